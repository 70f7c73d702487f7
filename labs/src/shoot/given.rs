//! What the student is given. The room is that of the lab `gather`.

// ANCHOR: light
/// The light in a room, element by element.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// `H_i`, W/m²: what has arrived so far.
    pub irradiance: Vec<f64>,
    /// `B_i`, W/m²: what has been emitted and reflected so far.
    pub radiosity: Vec<f64>,
    /// `ΔB_i`, W/m²: what of that is still to be sent.
    pub unshot: Vec<f64>,
}
// ANCHOR_END: light

// ANCHOR: by
/// What "the brightest" means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By {
    /// The most unshot power, `A_i ΔB_i`.
    Power,
    /// The most unshot radiosity, `ΔB_i`.
    Radiosity,
}
// ANCHOR_END: by

// ANCHOR: progress
/// What there is after some shots.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// The solution so far.
    pub light: Light,
    /// What is shown: the radiosity with the ambient guess.
    pub picture: Vec<f64>,
}
// ANCHOR_END: progress
