//! BRDFs: how a surface scatters what arrives from one direction into all others.

use super::{Material, Shine};
use crate::geometry::{Frame, Rgb};
use crate::radiometry::cosine_direction;
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::{FRAC_1_PI, TAU};

/// The shape of a scattering, of reflectance 1 at normal incidence.
///
/// Directions are local, of unit length, and lead away from the surface; z is its normal.
/// `wi` leads to where light comes from, `wo` to where it goes.
// ANCHOR: lobe
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lobe {
    /// The same in all directions.
    Lambert,
    /// About the mirror direction, the narrower the larger the exponent.
    Phong {
        /// `n`, finite, ≥ 0.
        exponent: f64,
    },
}
// ANCHOR_END: lobe

impl Lobe {
    /// The BRDF, in 1/sr, ≥ 0: radiance towards `wo` for each irradiance from `wi`.
    ///
    /// ```text
    /// Lambert   f = 1/π
    /// Phong     f = (n + 2)/2π · cosⁿα        α between `wi` and the mirror image of `wo`
    /// ```
    /// (Lambert 1760; Phong 1975, so normalised by Lewis 1993.) Reciprocal:
    /// `f(wi, wo) = f(wo, wi)`, bit by bit. 0 where `wi` or `wo` is not above the horizon.
    pub fn value(self, wi: DVec3, wo: DVec3) -> f64 {
        debug_assert!(wi.is_normalized() && wo.is_normalized(), "{wi}, {wo}");
        // ANCHOR: value
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return 0.0;
        }
        match self {
            Lobe::Lambert => FRAC_1_PI,
            Lobe::Phong { exponent: n } => (n + 2.0) / TAU * power(mirrored(wo), wi, n),
        }
        // ANCHOR_END: value
    }

    /// Directional albedo, in `[0, 1]`: the share of the light from a direction of this
    /// `cosine` to the normal, in `[0, 1]`, that leaves again.
    ///
    /// ```text
    /// a(θ) = ∫ f cosθₒ dωₒ        Lambert 1;  Phong  cosθ ≤ a(θ) ≤ 1, and a(0) = 1
    /// a(θ) = ½ cosθ (1 + I) + W/2π sinⁿθ
    ///     I = ∫₀^{π/2−θ} cosⁿ⁻¹ψ dψ / ∫₀^{π/2} cosⁿ⁻¹ψ dψ       W = ∫ cosⁿψ dψ, −π/2 … π/2
    /// ```
    /// The double axis moment of Arvo 1995, for any real exponent: the incomplete integral
    /// is summed as a series in sin²θ or in cos²θ, whichever is the smaller.
    ///
    /// # Accuracy
    /// Relative to 1e-13.
    pub fn albedo(self, cosine: f64) -> f64 {
        debug_assert!((0.0..=1.0).contains(&cosine), "cosine: {cosine}");
        match self {
            Lobe::Lambert => 1.0,
            Lobe::Phong { exponent } => phong_albedo(exponent, cosine),
        }
    }

    /// Hemispherical albedo, in `[0, 1]`: the share of what falls in evenly from all sides.
    ///
    /// ```text
    /// ∫ a(θ) cosθ dω / π        Lambert 1;  Phong  2/3 + W/(3π (n + 2)), in (2/3, 5/6]
    /// ```
    /// # Accuracy
    /// Relative to 1e-14.
    pub fn hemispherical_albedo(self) -> f64 {
        match self {
            Lobe::Lambert => 1.0,
            Lobe::Phong { exponent: n } => {
                // ANCHOR: hemispherical
                2.0 / 3.0 + half_circle(n) * FRAC_1_PI / (3.0 * (n + 2.0))
                // ANCHOR_END: hemispherical
            }
        }
    }

    /// The density, in 1/sr, ≥ 0, with which [`Lobe::sample`] draws `wi` for `wo`.
    ///
    /// ```text
    /// Lambert   cosθᵢ/π            Phong   (n + 1)/2π · cosⁿα
    /// ```
    /// Over all directions it integrates to 1. A Phong lobe reaches below the horizon
    /// where `wo` is aslant; there the density is positive and the BRDF 0.
    pub fn pdf(self, wi: DVec3, wo: DVec3) -> f64 {
        // ANCHOR: pdf
        match self {
            Lobe::Lambert => wi.z.max(0.0) * FRAC_1_PI,
            Lobe::Phong { exponent: n } => (n + 1.0) / TAU * power(mirrored(wo), wi, n),
        }
        // ANCHOR_END: pdf
    }

    /// A direction `wi` for `wo`, from a point of the unit square: of density
    /// [`Lobe::pdf`].
    ///
    /// The mean of `value · cosθᵢ / pdf` over many is the directional albedo.
    pub fn sample(self, wo: DVec3, u: DVec2) -> DVec3 {
        // ANCHOR: sample
        match self {
            Lobe::Lambert => cosine_direction(u),
            Lobe::Phong { exponent: n } => {
                let cosine = (1.0 - u.x).powf(1.0 / (n + 1.0));
                let across = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
                let (sine, cosine_turn) = (TAU * u.y).sin_cos();
                let lobe = dvec3(across * cosine_turn, across * sine, cosine);
                Frame::about(mirrored(wo)).world_from_local(lobe)
            }
        }
        // ANCHOR_END: sample
    }
}

/// The mirror image of a direction: turned half round the normal.
fn mirrored(w: DVec3) -> DVec3 {
    dvec3(-w.x, -w.y, w.z)
}

/// `cosⁿα` between two directions, 0 where they are a right angle or more apart.
fn power(a: DVec3, b: DVec3, n: f64) -> f64 {
    let cosine = a.dot(b);
    if cosine > 0.0 { cosine.powf(n) } else { 0.0 }
}

/// The directional albedo of a normalised Phong lobe; see [`Lobe::albedo`].
///
/// With `s = sinθ`, `c = cosθ`, both of
///
/// ```text
/// a = c  + W/2π sⁿ (1 − c² Σ  (n+1)(n+3)…/(n+2)(n+4)… s²ᵐ)
/// a = ½c + W/2π sⁿ (1 + n c² Σ (n+1)(n+3)…/3·5·7…      c²ᵐ)
/// ```
fn phong_albedo(n: f64, c: f64) -> f64 {
    let c2 = c * c;
    let s2 = (1.0 - c) * (1.0 + c);
    // sⁿ, without the rounding of s² enlarged n times
    let lobe =
        if s2 > 0.5 { (0.5 * n * (-c2).ln_1p()).exp() } else { s2.powf(0.5 * n) };
    if lobe < 1e-17 {
        return c; // the lobe has shrunk to a point, well above the horizon
    }
    let rim = half_circle(n) / TAU * lobe;
    // ANCHOR: phong_albedo
    let (mut term, mut sum, mut k) = (1.0, 0.0, 1.0);
    if s2 <= 0.5 {
        while term > 1e-17 * sum {
            sum += term;
            term *= s2 * (n + k) / (n + k + 1.0);
            k += 2.0;
        }
        return c + rim * (1.0 - c2 * sum);
    }
    // ANCHOR_END: phong_albedo
    while term > 1e-17 * sum {
        sum += term;
        term *= c2 * (n + k) / (k + 2.0);
        k += 2.0;
    }
    0.5 * c + rim * (1.0 + n * c2 * sum)
}

/// `W = ∫ cosⁿψ dψ` from −π/2 to π/2, in rad; `n ≥ 0`. Relative error below 1e-14.
///
/// By `W(n) = W(n + 2) (n + 2)/(n + 1)` it is found from one of 60 or more, and there
/// by the asymptotic series of Wallis' quotient in `1/(n + ½)`.
fn half_circle(n: f64) -> f64 {
    let (mut k, mut factor) = (n, 1.0);
    while k < 60.0 {
        factor *= (k + 2.0) / (k + 1.0);
        k += 2.0;
    }
    let m = k + 0.5;
    let y = 1.0 / (m * m);
    let series = 1.0 - y * (1.0 / 16.0 - y * (21.0 / 512.0 - y * 671.0 / 8192.0));
    factor * (TAU / m).sqrt() * series
}

/// The BRDF of a material: a diffuse part and a gloss lobe, channel by channel.
///
/// ```text
/// f = ρ_d/π + ρ_s (n + 2)/2π cosⁿα        1/sr;   ρ_d + ρ_s ≤ 1, as its material is passive
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Brdf {
    diffuse: Rgb,
    specular: Rgb,
    exponent: f64,
}

impl Material {
    /// Its BRDF: what it scatters diffusely, and its gloss. What it mirrors or passes
    /// leaves in single directions and has no BRDF.
    pub fn brdf(&self) -> Brdf {
        let (specular, exponent) = match self.shine() {
            Shine::Gloss { reflectance, exponent } => (reflectance, exponent),
            _ => (Rgb::ZERO, 0.0),
        };
        Brdf { diffuse: self.diffuse(), specular, exponent }
    }
}

impl Brdf {
    /// Its two lobes, each with its reflectance.
    fn lobes(&self) -> [(Rgb, Lobe); 2] {
        // ANCHOR: lobes
        let gloss = Lobe::Phong { exponent: self.exponent };
        [(self.diffuse, Lobe::Lambert), (self.specular, gloss)]
        // ANCHOR_END: lobes
    }

    /// How often the gloss lobe is sampled: its share of the reflectance, in `[0, 1]`.
    fn gloss_share(&self) -> f64 {
        let [d, s] = [self.diffuse, self.specular].map(|k| k.element_sum());
        if s > 0.0 { s / (d + s) } else { 0.0 }
    }

    /// The BRDF, in 1/sr; as [`Lobe::value`].
    pub fn value(&self, wi: DVec3, wo: DVec3) -> Rgb {
        self.lobes().map(|(k, lobe)| k * lobe.value(wi, wo)).into_iter().sum()
    }

    /// Directional albedo, in `[0, 1]`; as [`Lobe::albedo`]. In a glow of radiance 1 from
    /// everywhere it is the radiance that leaves at this `cosine` to the normal.
    pub fn albedo(&self, cosine: f64) -> Rgb {
        self.lobes().map(|(k, lobe)| k * lobe.albedo(cosine)).into_iter().sum()
    }

    /// The density of [`Brdf::sample`], in 1/sr.
    pub fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        let (share, [(_, diffuse), (_, gloss)]) = (self.gloss_share(), self.lobes());
        (1.0 - share) * diffuse.pdf(wi, wo) + share * gloss.pdf(wi, wo)
    }

    /// A direction `wi` for `wo`, from a point of `[0, 1)²`: from one lobe or the other,
    /// in proportion to their reflectances.
    pub fn sample(&self, wo: DVec3, u: DVec2) -> DVec3 {
        let (share, [(_, diffuse), (_, gloss)]) = (self.gloss_share(), self.lobes());
        // ANCHOR: choose
        // What decides is stretched to the whole unit again.
        if u.x < share {
            gloss.sample(wo, dvec2(u.x / share, u.y))
        } else {
            diffuse.sample(wo, dvec2((u.x - share) / (1.0 - share), u.y))
        }
        // ANCHOR_END: choose
    }
}
