//! The directional albedo of a lobe as an integral, by directions that are drawn in three
//! ways, or that stand on a grid.

use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::material::Lobe;
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The lobe that is measured.
pub const LOBE: Lobe = Lobe::Phong { exponent: 50.0 };

/// Where it is looked at from: 45° to the normal.
pub fn eye() -> DVec3 {
    dvec3(0.5, 0.5, 0.5f64.sqrt())
}

/// How directions are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Draw {
    /// Evenly over the hemisphere.
    Even,
    /// In proportion to the cosine.
    Cosine,
    /// From the lobe.
    Lobe,
}

/// What one direction tells, of a point of the unit square: `f cosθ / pdf`.
fn weight(draw: Draw, u: DVec2) -> f64 {
    let wo = eye();
    let wi = match draw {
        Draw::Even => {
            let ((sine, cosine), across) =
                ((TAU * u.y).sin_cos(), (1.0 - u.x * u.x).sqrt());
            dvec3(across * cosine, across * sine, u.x)
        }
        Draw::Cosine => cosine_direction(u),
        Draw::Lobe => LOBE.sample(wo, u),
    };
    if wi.z <= 0.0 {
        return 0.0;
    }
    let reflected = LOBE.value(wi, wo) * wi.z;
    match draw {
        Draw::Even => reflected * TAU,
        Draw::Cosine => reflected * PI / wi.z,
        Draw::Lobe => reflected / LOBE.pdf(wi, wo),
    }
}

/// The albedo from so many directions, each drawn by itself.
pub fn drawn(draw: Draw, samples: usize, seed: u64) -> f64 {
    let mut stream = Stream::named(seed, &[samples as u64]);
    let mut one = || weight(draw, dvec2(stream.next(), stream.next()));
    (0..samples).map(|_| one()).sum::<f64>() / samples as f64
}

/// The albedo from a grid of `rings` × 4·`rings` directions, even in θ and φ.
pub fn on_a_grid(rings: u32) -> f64 {
    let step = FRAC_PI_2 / f64::from(rings);
    let mut sum = 0.0;
    for k in 0..4 * rings * rings {
        let theta = step * (f64::from(k / (4 * rings)) + 0.5);
        let (y, x) = (step * (f64::from(k % (4 * rings)) + 0.5)).sin_cos();
        let (sine, cosine) = theta.sin_cos();
        sum += LOBE.value(dvec3(sine * x, sine * y, cosine), eye()) * cosine * sine;
    }
    sum * step * step
}
