//! The certificate: how far a field is from the truth, measured without trusting it.
//!
//! ```text
//! r = E + ρ H(B) − B          the residual of the continuous equation at a point
//! ‖r‖/(1 + ρ_max) ≤ ‖B − B*‖ ≤ ‖r‖/(1 − ρ_max)          in the area norm
//! ```
//! At random points, some on each element, the irradiance `H(B)` is gathered **twice**, by
//! two independent sets of rays. Each gather is right on average but noisy; the product of
//! the two residuals is `r²` on average, since independent errors do not correlate. (One
//! residual squared would be too large by the variance of the gather.)
//!
//! Light that comes straight from emitters is summed exactly ([`Direct`]), so that rays
//! carry reflected light only, which varies little.
//!
//! What is reported is relative to the reflected light: `‖B − B*‖/‖B* − E‖`. Relative to
//! `‖B‖` the lamp, which is known, would hide everything.

use super::{Direct, Enclosure};
use crate::form_factor::ray_from;
use crate::geometry::{Frame, Rgb};
use crate::mesh::{ElementId, Mesh};
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::DVec3;
use rayon::prelude::*;

/// What a field's error is, as far as sampling can tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// The likely error, `‖r‖/‖B − E‖`: the residual itself, worst channel.
    pub error: f64,
    /// The error is at least this.
    pub low: f64,
    /// The error is at most this; infinite when that cannot be said.
    pub high: f64,
    /// How sure that is, in `(0, 1)`.
    pub confidence: f64,
}

/// How much work a certificate may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Points in all; each element gets at least one.
    pub points: usize,
    /// Rays of each of the two gathers at a point.
    pub rays: usize,
    /// Names the random streams.
    pub seed: u64,
}

impl Default for Sampling {
    fn default() -> Sampling {
        Sampling { points: 10_000, rays: 32, seed: 0 }
    }
}

const CONFIDENCE: f64 = 0.95;

/// Measures the error of `field`, the radiosity in W/m² at a point of an element.
///
/// # Accuracy
/// The interval holds with the confidence stated when the samples have met every feature:
/// what no point falls on is not known (an empirical Bernstein bound, Maurer & Pontil
/// 2009, whose range is that of the samples).
pub fn certify(
    scene: &Scene,
    mesh: &Mesh,
    field: &(dyn Fn(ElementId, DVec3) -> Rgb + Sync),
    sampling: Sampling,
) -> Certificate {
    let enclosure = Enclosure::of(scene, mesh);
    let gathering = Gathering::new(scene, mesh, field, sampling);
    let area: f64 = enclosure.area.iter().sum();
    let samples: Vec<Sample> = (0..mesh.elements.len())
        .into_par_iter()
        .filter(|&k| enclosure.reflectance[k] != Rgb::ZERO)
        .flat_map_iter(|k| {
            let share = enclosure.area[k] / area * sampling.points as f64;
            gathering.samples(k, share.ceil().max(1.0) as usize, &enclosure)
        })
        .collect();
    let rho = enclosure.largest_reflectance();
    let channel = |c: usize| interval(&samples, c, rho[c]);
    let worst = |a: Certificate, b: Certificate| if b.high > a.high { b } else { a };
    worst(worst(channel(0), channel(1)), channel(2))
}

/// One point: its share of the area, the product of its two residuals, the square of the
/// reflected light.
struct Sample {
    area: f64,
    residual: Rgb,
    reflected: Rgb,
}

/// From samples of `r²` to an interval for the error, in one channel.
fn interval(samples: &[Sample], c: usize, rho: f64) -> Certificate {
    let n = samples.len() as f64;
    let terms = || samples.iter().map(|s| n * s.area * s.residual[c]);
    let mean = terms().sum::<f64>() / n;
    let variance =
        terms().map(|y| (y - mean) * (y - mean)).sum::<f64>() / (n - 1.0).max(1.0);
    let range = terms().fold(0.0_f64, |m, y| m.max(y.abs()));
    let log = (2.0 / (1.0 - CONFIDENCE)).ln();
    let width = (2.0 * variance * log / n).sqrt() + 7.0 * range * log / (3.0 * n);
    let root = |x: f64| x.max(0.0).sqrt();
    let (likely, least, most) = (root(mean), root(mean - width), root(mean + width));
    let reflected = samples.iter().map(|s| s.area * s.reflected[c]).sum::<f64>().sqrt();
    // ‖B* − E‖ lies within the error of ‖B − E‖.
    let (low, high) = (least / (1.0 + rho), most / (1.0 - rho));
    let ratio = |error: f64, scale: f64| match (error, scale) {
        (0.0, _) => 0.0,
        (_, scale) if scale <= 0.0 => f64::INFINITY,
        (error, scale) => error / scale,
    };
    Certificate {
        error: ratio(likely, reflected),
        low: ratio(low, reflected + low),
        high: ratio(high, reflected - high),
        confidence: CONFIDENCE,
    }
}

/// Gathers light at points, independently of any form factor.
struct Gathering<'a> {
    mesh: &'a Mesh,
    field: &'a (dyn Fn(ElementId, DVec3) -> Rgb + Sync),
    sampling: Sampling,
    elements: Visibility,
    direct: Direct<'a>,
    /// Per element: what of its emission rays must not count again.
    summed: Vec<Rgb>,
}

impl<'a> Gathering<'a> {
    fn new(
        scene: &'a Scene,
        mesh: &'a Mesh,
        field: &'a (dyn Fn(ElementId, DVec3) -> Rgb + Sync),
        sampling: Sampling,
    ) -> Gathering<'a> {
        let direct = Direct::of(scene);
        let mut summed = Enclosure::of(scene, mesh).emission;
        if !direct.sums_emitters() {
            summed.fill(Rgb::ZERO);
        }
        Gathering {
            mesh,
            field,
            sampling,
            elements: Visibility::new(mesh.polygons()),
            direct,
            summed,
        }
    }

    /// Residuals at `count` points of element `k`.
    fn samples(&self, k: usize, count: usize, enclosure: &Enclosure) -> Vec<Sample> {
        let id = ElementId(k as u32);
        let polygon = &self.mesh.elements[k].polygon;
        let (e, rho) = (enclosure.emission[k], enclosure.reflectance[k]);
        let direct = self.direct.on(polygon);
        let places = Stream::named(self.sampling.seed, &[k as u64]).points(count);
        let sample = |(point, place): (usize, [f64; 2])| {
            let x = polygon.point_at(place);
            let direct = direct.irradiance(x);
            let b = (self.field)(id, x);
            let gathered = |set: u64| {
                let name = [k as u64, point as u64, set];
                direct + self.indirect(id, x, Stream::named(self.sampling.seed, &name))
            };
            let residual = |set: u64| e + rho * gathered(set) - b;
            Sample {
                area: enclosure.area[k] / count as f64,
                residual: residual(1) * residual(2),
                reflected: (b - e) * (b - e),
            }
        };
        places.enumerate().map(sample).collect()
    }

    /// Reflected light that arrives at `x`, by rays.
    fn indirect(&self, from: ElementId, x: DVec3, mut random: Stream) -> Rgb {
        let element = &self.mesh.element(from).polygon;
        let frame = Frame::about(element.normal());
        let mut sum = Rgb::ZERO;
        for [c, d] in random.points(self.sampling.rays) {
            let mut ray = ray_from(element, &frame, [0.0, 0.0, c, d]);
            ray.origin = x;
            if let Some(hit) =
                self.elements.closest(&ray, Some(from.0)).filter(|h| h.front)
            {
                let y = ray.origin + hit.distance * ray.direction;
                let light = (self.field)(ElementId(hit.item), y);
                sum += light - self.summed[hit.item as usize];
            }
        }
        sum / self.sampling.rays as f64
    }
}
