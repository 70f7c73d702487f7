//! What the student is given: a room, and what is to be said of it.

// ANCHOR: room
/// A closed room of n elements, for one colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
    /// `A_i`, m².
    pub area: Vec<f64>,
    /// `E_i`, W/m².
    pub emission: Vec<f64>,
    /// `ρ_i`, in `[0, 1)`.
    pub reflectance: Vec<f64>,
    /// `factors[i][j]` is `F_ij`, from i to j. Each row sums to 1; `A_i F_ij = A_j
    /// F_ji`.
    pub factors: Vec<Vec<f64>>,
}
// ANCHOR_END: room

// ANCHOR: balance
/// Where the light is, in W.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// What the elements emit.
    pub emitted: f64,
    /// What they keep of what arrives.
    pub absorbed: f64,
    /// What the residual would send: light that has not settled yet.
    pub unshot: f64,
}
// ANCHOR_END: balance

// ANCHOR: solved
/// An answer, and the work it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// `B_i`, W/m².
    pub radiosity: Vec<f64>,
    /// How many bounces or sweeps.
    pub sweeps: usize,
}
// ANCHOR_END: solved
