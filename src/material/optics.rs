//! Smooth faces between media: reflection, refraction, Fresnel's law, panes.

use glam::DVec3;

/// The direction of a ray after a mirror; unit vectors in, unit vector out.
///
/// ```text
/// r = d − 2 (d·n) n
/// ```
pub fn reflect(direction: DVec3, normal: DVec3) -> DVec3 {
    // ANCHOR: reflect
    direction - 2.0 * direction.dot(normal) * normal
    // ANCHOR_END: reflect
}

/// The direction of a ray after a face between two media, by Snell's law; `None` where all
/// of it is reflected (total internal reflection).
///
/// ```text
/// t = η d + (η cosᵢ − cosₜ) n        cosᵢ = −d·n > 0,  sinₜ = η sinᵢ,  η = nᵢ/nₜ
/// ```
/// `direction` and `normal` are of unit length, the normal on the side that the ray comes
/// from; `eta` is the index there over that beyond.
pub fn refract(direction: DVec3, normal: DVec3, eta: f64) -> Option<DVec3> {
    // ANCHOR: refract
    let cos_i = -direction.dot(normal);
    let cos_t = cosine_beyond(cos_i, eta)?;
    Some(eta * direction + (eta * cos_i - cos_t) * normal)
    // ANCHOR_END: refract
}

/// `cosₜ` in `(0, 1]` for `cosᵢ` in `[0, 1]`; `None` where nothing passes.
fn cosine_beyond(cos_i: f64, eta: f64) -> Option<f64> {
    let sine_squared = eta * eta * ((1.0 - cos_i) * (1.0 + cos_i)).max(0.0);
    (sine_squared < 1.0).then(|| (1.0 - sine_squared).sqrt())
}

/// What a smooth face reflects of light that swings across the plane of incidence (`s`)
/// and in it (`p`); each in `[0, 1]`. The rest passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fresnel {
    /// Across the plane of incidence.
    pub s: f64,
    /// In the plane of incidence; 0 at Brewster's angle.
    pub p: f64,
}

impl Fresnel {
    /// That of unpolarised light.
    pub fn mean(self) -> f64 {
        0.5 * (self.s + self.p)
    }
}

/// Fresnel's law: what a face between dielectrics reflects.
///
/// ```text
/// s = ((η cosᵢ − cosₜ)/(η cosᵢ + cosₜ))²     p = ((cosᵢ − η cosₜ)/(cosᵢ + η cosₜ))²
/// ```
/// `cos_i` in `[0, 1]` is to the normal, `eta = nᵢ/nₜ > 0`. Both are 1 under total
/// internal reflection, and at grazing incidence.
///
/// # Accuracy
/// To rounding (1e-15).
pub fn fresnel(cos_i: f64, eta: f64) -> Fresnel {
    // ANCHOR: fresnel
    let Some(cos_t) = cosine_beyond(cos_i, eta) else {
        return Fresnel { s: 1.0, p: 1.0 };
    };
    let share = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
    Fresnel { s: share(eta * cos_i, cos_t), p: share(cos_i, eta * cos_t) }
    // ANCHOR_END: fresnel
}

/// What a thin clear pane reflects and passes of unpolarised light, `(r, t)`, with
/// `r + t = 1` to rounding: [`slab`] without absorption.
pub fn pane(cos_i: f64, index: f64) -> (f64, f64) {
    slab(cos_i, index, 0.0)
}

/// What a plane-parallel slab in air reflects and passes of unpolarised light: `(r, t)`.
///
/// ```text
/// τ = e^(−a/cosₜ)       t = (1 − R)² τ/(1 − R² τ²)       r = R (1 + τ t)
/// ```
/// for each polarisation with its own `R`, then the mean: light that bounces inside stays
/// polarised. `absorption` is the coefficient times the thickness, ≥ 0; `index > 0`.
/// All internal reflections are summed; interference is not (panes are thick beside a
/// wavelength). At grazing incidence everything is reflected.
pub fn slab(cos_i: f64, index: f64, absorption: f64) -> (f64, f64) {
    // ANCHOR: slab
    let Some(cos_t) = cosine_beyond(cos_i, 1.0 / index).filter(|_| cos_i > 0.0) else {
        return (1.0, 0.0);
    };
    let tau = (-absorption / cos_t).exp();
    let Fresnel { s, p } = fresnel(cos_i, 1.0 / index);
    let one = |face: f64| {
        let out = 1.0 - (face * tau).powi(2);
        let passed = if out > 0.0 { (1.0 - face).powi(2) * tau / out } else { 0.0 };
        (face * (1.0 + tau * passed), passed)
    };
    let (s, p) = (one(s), one(p));
    (0.5 * (s.0 + p.0), 0.5 * (s.1 + p.1))
    // ANCHOR_END: slab
}
