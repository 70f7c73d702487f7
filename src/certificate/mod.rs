//! The certificate: how far a field is from the truth, measured without trusting it.
//!
//! ```text
//! r = E + ρ H(B) − B            the residual of the continuous equation at a point
//! e = B* − B = r + K e          the error: what is missing here, and what the error of
//!                               other places sends here;   K e = ρ H(e)
//! ‖B* − B‖ / ‖B* − E‖           what is reported: area norm, worst channel
//! ‖H* − H‖ / ‖H*‖               and the same of what arrives, on black fronts, too
//! ```
//! Nothing that may have made the field has a say in it. The judge has the scene, the
//! hierarchy of its rays and the rules of what happens where they meet something
//! ([`crate::ways`]), and draws lamps and sky by a sampler of its own.
//!
//! At random points, some on each **stratum** of the scene, the irradiance `H(B)` is
//! gathered **twice**, by two independent sets of rays. Each gather is right on average but
//! noisy; the product of the two results is the square on average, since independent errors
//! do not correlate. (One result squared would be too large by the variance of the gather.)
//! Strata are small where elements are, and **where light lands**: rays from the lamps and
//! the sky tell. Of what none of them found nothing is known but that it is little:
//! [`Certificate::unseen`].
//!
//! The same rays tell which stratum lights which. With the mean residual of each they give
//! the mean error `ē = r̄ + K ē` of each, and this the error at each point. The residual
//! of a mesh changes sign from place to place and dies out when it is reflected: the error
//! is near `‖r‖`, and not `‖r‖/(1 − ρ_max)`, which is only the worst that can be.
//!
//! What is reported is relative to the reflected light. Relative to `‖B‖` the lamp, which
//! is known, would hide everything.
//!
//! | part        | use it when                         | it fails when                      |
//! |-------------|-------------------------------------|------------------------------------|
//! | [`certify`] | a field is to be trusted            | a spot is met by no ray: `unseen`  |
//! | [`audit`]   | it is also asked where it is wrong  | single elements: few points, noise |
//!
//! ```
//! use radiosity::certificate::{Judged, Sampling, certify};
//! use radiosity::{geometry::Rgb, mesh::Mesh, scene::built_in, visibility::Visibility};
//! let scene = built_in("furnace").unwrap(); // H = 2 everywhere, and B = 1 + H/2
//! let mesh = Mesh::uniform(&scene, 0.5);
//! let rays = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
//! let field = Judged { mesh: &mesh, irradiance: &|_, _| [Rgb::splat(1.8), Rgb::ZERO] };
//! let found = certify(&scene, &rays, &field, Sampling::default());
//! assert!(found.low <= 0.1 && 0.1 <= found.high && found.high < 0.101);
//! ```
//!
//! **Not here:** what is done when the error is too large ([`crate::solution`]).
//! Beyond the lecture: chapter *How wrong is it?*. Sources: Arvo, Torrance & Smits 1994
//! (the errors of radiosity told apart); Lischinski, Smits & Greenberg 1994 (bounds);
//! Veach & Guibas 1995 (samples of two kinds).

mod gathering;
mod guide;
mod interval;
mod landings;
mod lights;
mod outlook;
mod propagate;
mod strata;

use crate::geometry::Rgb;
use crate::mesh::{ElementId, Locator, Mesh};
use crate::scene::Scene;
use crate::visibility::Visibility;
use crate::ways::Specular;
use gathering::{Gathering, Point};
use glam::DVec3;
use interval::Norm;
use landings::{Landings, MISSED, Source, ball};
use lights::Lights;
use propagate::{Means, StrataExchange};
use strata::Strata;

/// A relative error, as far as sampling can tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RelativeError {
    /// The likely one, of the worst channel.
    pub error: f64,
    /// It is at least this.
    pub low: f64,
    /// It is at most this; infinite when that cannot be said.
    pub high: f64,
}

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
    /// `‖H* − H‖/‖H*‖` over all fronts, black ones too.
    pub irradiance: RelativeError,
    /// The share of the emitted power that rays from the lamps and the sky may have missed,
    /// with 95 % confidence: `3/N` of `N` rays.
    pub unseen: f64,
    /// The share of the emitted power that the first reflecting front it meets sends on; in
    /// a scene in which none reflects, that meets a front.
    pub reflected: f64,
}

impl Certificate {
    /// Is the field as right as this, in both measures, and is what was not seen no more?
    pub fn meets(&self, tolerance: f64) -> bool {
        let right = self.worst() <= tolerance;
        right && self.unseen <= tolerance * self.reflected
    }

    /// The larger of the two upper bounds.
    pub fn worst(&self) -> f64 {
        self.high.max(self.irradiance.high)
    }
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
    /// Rays from the lamps and the sky are sent until what they may have missed is no more
    /// than this share of what is reflected, or they are a million.
    pub unseen: f64,
    /// Names the random streams.
    pub seed: u64,
}

impl Default for Sampling {
    fn default() -> Sampling {
        Sampling { points: 3200, rays: 64, unseen: 0.01, seed: 0 }
    }
}

/// What is judged: a field of light, and the mesh that names its points.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// The elements.
    pub mesh: &'a Mesh,
    /// The irradiance, in W/m², at a point of an element: on its front, and behind it, where
    /// the face lets light through. What leaves it follows: `B = E + ρ H + τ H_behind`.
    pub irradiance: &'a (dyn Fn(ElementId, DVec3) -> [Rgb; 2] + Sync),
}

impl std::fmt::Debug for Judged<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("Judged").field("mesh", self.mesh).finish_non_exhaustive()
    }
}

/// The irradiance of a field of which only the radiosity is known: `(B − E)/(ρ + τ)`, and 0
/// on black surfaces, whatever arrives there.
pub fn irradiance_of<'a>(
    scene: &'a Scene,
    mesh: &'a Mesh,
    radiosity: impl Fn(ElementId, DVec3) -> Rgb + Sync + 'a,
) -> impl Fn(ElementId, DVec3) -> [Rgb; 2] + Sync + 'a {
    move |id, x| {
        let material = mesh.material(scene, mesh.element(id));
        let reflected = radiosity(id, x) - material.emission();
        let scattered = material.scattered();
        let of = |c: usize| {
            if scattered[c] > 0.0 { reflected[c] / scattered[c] } else { 0.0 }
        };
        [Rgb::new(of(0), of(1), of(2)); 2]
    }
}

/// Measures the error of a field.
///
/// # Accuracy
/// As [`audit`].
pub fn certify(
    scene: &Scene,
    visibility: &Visibility,
    field: &Judged,
    sampling: Sampling,
) -> Certificate {
    audit(scene, visibility, field, sampling).certificate
}

/// Measures the error of `field`, and where it is.
///
/// # Accuracy
/// The interval holds with the confidence stated when the samples have met every feature:
/// what no ray has found is not known, but for how much light it may be. What single elements
/// are said to be off by is noisy: each has but a few points.
pub fn audit(
    scene: &Scene,
    visibility: &Visibility,
    field: &Judged,
    sampling: Sampling,
) -> Audit {
    let mesh = field.mesh;
    let (rays, lights) = (Specular::within(scene, visibility), Lights::of(scene));
    let reflects =
        scene.surfaces.iter().any(|s| scene.material(s).scattered() != Rgb::ZERO);
    let source =
        Source { scene, rays: &rays, lights: &lights, reflects, ball: ball(scene) };
    let landings = source.landings(field, sampling);
    let strata = Strata::of(mesh, &landings, sampling.points);
    let pieces = strata.pieces.iter();
    let surface = |element: u32| mesh.surface_of(&mesh.elements[element as usize]);
    let pieces = pieces.map(|p| (surface(p.element), &p.polygon));
    let locator = Locator::of(scene, pieces);
    let (rays, lights, strata) = (&rays, &lights, &strata);
    let power = landings.power;
    let gathering =
        Gathering { scene, rays, lights, strata, field, locator, sampling, power };
    let points = gathering.all();
    let exchange =
        StrataExchange::of(strata, |h| strata.material(h, scene, mesh), &points);
    let means = exchange.errors(&points, sampling.seed);
    // ANCHOR: products
    let pairs = |of: &dyn Fn(&Point, usize) -> Rgb| -> Vec<Rgb> {
        points.iter().map(|p| of(p, 0) * of(p, 1)).collect()
    };
    let of_residual = pairs(&|p, set| p.residual(set));
    let error_at = |p: &Point, set| p.residual(set) + p.returned(set, &means.error);
    let of_error = pairs(&error_at);
    let of_truth = pairs(&|p, set| p.reflected() + error_at(p, set));
    let lacking_at = |p: &Point, set| p.lacks(set) + p.arriving(set, &means.error);
    let of_lacking = pairs(&lacking_at);
    let of_arriving = pairs(&|p, set| p.stored() + lacking_at(p, set));
    // ANCHOR_END: products
    let judge = Judgement { strata, points: &points, means: &means };
    let leaving = judge.relative([&of_error, &of_truth], means.noise);
    let irradiance = judge.relative([&of_lacking, &of_arriving], means.arriving_noise);
    let scale = interval::mean(strata, &points, &of_truth);
    let map =
        |squares: &[Rgb]| interval::by_element(mesh, strata, &points, squares, scale);
    Audit {
        certificate: told(leaving, irradiance, &landings, reflects),
        residual: map(&of_residual),
        error: map(&of_error),
    }
}

/// What is known at all points.
struct Judgement<'a> {
    strata: &'a Strata,
    points: &'a [Point],
    means: &'a Means,
}

impl Judgement<'_> {
    /// The norm of an error over that of the truth, from products at points.
    fn relative(&self, [error, truth]: [&[Rgb]; 2], noise: Rgb) -> RelativeError {
        let Judgement { strata, points, means } = self;
        let mut worst = RelativeError::default();
        for c in 0..3 {
            let norm = |squares: &[Rgb]| Norm::of(strata, points, squares, noise, c);
            let (error, truth) = (norm(error), norm(truth));
            let doubt = error.doubt(means, c);
            let (error, truth) = (error.widened(doubt), truth.widened(doubt));
            worst.error = worst.error.max(ratio(error.likely, truth.likely));
            worst.low = worst.low.max(ratio(error.low, truth.high));
            worst.high = worst.high.max(ratio(error.high, truth.low));
        }
        worst
    }
}

/// The certificate. Where light is sent but none is seen to be reflected, nothing is known of
/// what is reflected: it may be off by all of it.
fn told(
    leaving: RelativeError,
    irradiance: RelativeError,
    landings: &Landings,
    reflects: bool,
) -> Certificate {
    let blind = reflects && landings.sent > 0.0 && landings.reflected == 0.0;
    Certificate {
        error: leaving.error,
        low: leaving.low,
        high: if blind { leaving.high.max(1.0) } else { leaving.high },
        confidence: interval::CONFIDENCE,
        irradiance,
        unseen: if landings.sent > 0.0 { MISSED / landings.sent } else { 0.0 },
        reflected: landings.reflected,
    }
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
