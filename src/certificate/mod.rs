//! The certificate: how far a field is from the truth, measured without trusting it.
//!
//! ```text
//! r = E + ρ H(B) − B            the residual of the continuous equation at a point
//! e = B* − B = r + K e          the error: what is missing here, and what the error of
//!                               other places sends here;   K e = ρ H(e)
//! ‖B* − B‖ / ‖B* − E‖           what is reported: area norm, worst channel
//! ```
//! At random points, some on each **stratum** of the scene, the irradiance `H(B)` is
//! gathered **twice**, by two independent sets of rays. Each gather is right on average but
//! noisy; the product of the two results is the square on average, since independent errors
//! do not correlate. (One result squared would be too large by the variance of the gather.)
//!
//! The same rays tell which stratum lights which. With the mean residual of each they give
//! the mean error `ē = r̄ + K ē` of each, and this the error at each point. The residual
//! of a mesh changes sign from place to place and dies out when it is reflected: the error
//! is near `‖r‖`, and not `‖r‖/(1 − ρ_max)`, which is only the worst that can be.
//!
//! Light that comes straight from emitters is summed exactly ([`Direct`]),
//! so that rays carry reflected light only, which varies little.
//!
//! What is reported is relative to the reflected light. Relative to `‖B‖` the lamp, which
//! is known, would hide everything.
//!
//! | part        | use it when                         | it fails when                      |
//! |-------------|-------------------------------------|------------------------------------|
//! | [`certify`] | a field is to be trusted            | a spot is met by no point: unknown |
//! | [`audit`]   | it is also asked where it is wrong  | single elements: few points, noise |
//!
//! ```
//! use radiosity::certificate::{Judged, Sampling, certify};
//! use radiosity::{geometry::Rgb, mesh::Mesh, room::Room, scene::built_in};
//! let scene = built_in("furnace").unwrap(); // B = 2 everywhere, of which 1 is reflected
//! let (room, mesh) = (Room::of(&scene), Mesh::uniform(&scene, 0.5));
//! let field = Judged { mesh: &mesh, radiosity: &|_, _| Rgb::splat(1.9) };
//! let (rays, lamps) = (room.visibility(), room.lamps());
//! let found = certify(&scene, rays, lamps, &field, Sampling::default());
//! assert!((found.error - 0.1).abs() < 1e-9);
//! ```
//!
//! **Not here:** what is done when the error is too large ([`crate::solution`]).
//! Beyond the lecture: chapter *How wrong is it?*. Sources: Arvo, Torrance & Smits 1994
//! (the errors of radiosity told apart); Lischinski, Smits & Greenberg 1994 (bounds).

mod gathering;
mod interval;
mod propagate;
mod strata;

use crate::geometry::Rgb;
use crate::mesh::{Element, ElementId, Mesh};
use crate::room::Direct;
use crate::scene::Scene;
use crate::visibility::Visibility;
use gathering::{Gathering, Point};
use glam::DVec3;
use interval::Norm;
use propagate::StrataExchange;
use strata::Strata;

/// What a field's error is, as far as sampling can tell.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Certificate {
    /// The likely error, `‖B* − B‖/‖B* − E‖`, worst channel.
    pub error: f64,
    /// The error is at least this.
    pub low: f64,
    /// The error is at most this; infinite when that cannot be said.
    pub high: f64,
    /// How sure that is, in `(0, 1)`.
    pub confidence: f64,
}

/// A certificate, and where the error is.
#[derive(Clone, Debug, PartialEq)]
pub struct Audit {
    /// The error of the whole.
    pub certificate: Certificate,
    /// Per element: root mean square of `r`, relative to that of the reflected light of
    /// the scene; worst channel. What the element itself does wrong: where to refine.
    pub residual: Vec<f64>,
    /// The same of `e`: how wrong the element is, whoever's fault that be.
    pub error: Vec<f64>,
}

/// How much work a certificate may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Points in all, about; at least 16.
    pub points: usize,
    /// Rays of each of the two gathers at a point.
    pub rays: usize,
    /// Names the random streams.
    pub seed: u64,
}

impl Default for Sampling {
    fn default() -> Sampling {
        Sampling { points: 3200, rays: 64, seed: 0 }
    }
}

const CONFIDENCE: f64 = 0.95;

/// What is judged: a field of light, and the mesh that names its points.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// The elements.
    pub mesh: &'a Mesh,
    /// The radiosity, in W/m², at a point of an element.
    pub radiosity: &'a (dyn Fn(ElementId, DVec3) -> Rgb + Sync),
}

impl std::fmt::Debug for Judged<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("Judged").field("mesh", self.mesh).finish_non_exhaustive()
    }
}

/// Measures the error of a field.
///
/// # Accuracy
/// As [`audit`].
pub fn certify(
    scene: &Scene,
    visibility: &Visibility,
    lamps: &Direct,
    field: &Judged,
    sampling: Sampling,
) -> Certificate {
    audit(scene, visibility, lamps, field, sampling).certificate
}

/// Measures the error of `field`, and where it is.
///
/// # Accuracy
/// The interval holds with the confidence stated when the samples have met every feature:
/// what no point falls on is not known. What single elements are said to be off by is
/// noisy: each has but a few points.
pub fn audit(
    scene: &Scene,
    visibility: &Visibility,
    lamps: &Direct,
    field: &Judged,
    sampling: Sampling,
) -> Audit {
    let mesh = field.mesh;
    let scattered = |e: &Element| mesh.material(scene, e).scattered();
    let scattered: Vec<Rgb> = mesh.elements.iter().map(scattered).collect();
    let strata = Strata::of(mesh, &scattered, sampling.points);
    let points =
        Gathering::new((scene, visibility, lamps), &strata, field, sampling).all();
    let exchange = StrataExchange::of(&strata, &scattered, &points);
    let means = exchange.errors(&points, sampling.seed);
    // ANCHOR: products
    let pairs = |of: &dyn Fn(&Point, usize) -> Rgb| -> Vec<Rgb> {
        points.iter().map(|p| of(p, 0) * of(p, 1)).collect()
    };
    let of_residual = pairs(&|p, set| p.residual[set]);
    let error_at = |p: &Point, set| p.residual[set] + p.arriving(set, &means.error);
    let of_error = pairs(&error_at);
    let of_truth = pairs(&|p, set| p.reflected + error_at(p, set));
    // ANCHOR_END: products
    let mut certificate =
        Certificate { error: 0.0, low: 0.0, high: 0.0, confidence: CONFIDENCE };
    for c in 0..3 {
        let norm = |squares: &[Rgb]| Norm::of(&strata, &points, squares, &means, c);
        let (error, truth) = (norm(&of_error), norm(&of_truth));
        let doubt = error.doubt(&means, c);
        let (error, truth) = (error.widened(doubt), truth.widened(doubt));
        certificate.error = certificate.error.max(ratio(error.likely, truth.likely));
        certificate.low = certificate.low.max(ratio(error.low, truth.high));
        certificate.high = certificate.high.max(ratio(error.high, truth.low));
    }
    let scale = interval::mean(&strata, &points, &of_truth);
    let map =
        |squares: &[Rgb]| interval::by_element(mesh, &strata, &points, squares, scale);
    Audit { certificate, residual: map(&of_residual), error: map(&of_error) }
}

/// A relative error; without light, none is no error, and any is without bound; what is not
/// a number is not known to be small.
fn ratio(error: f64, scale: f64) -> f64 {
    match (error, scale) {
        (error, scale) if error.is_nan() || scale.is_nan() => f64::INFINITY,
        (0.0, _) => 0.0,
        (_, scale) if scale <= 0.0 => f64::INFINITY,
        (error, scale) => error / scale,
    }
}
