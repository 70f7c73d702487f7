//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, from_bulb, from_sky, from_surface, radiosity, reflected};
use super::bugs::*;
use super::given::{Sent, Spot};
use crate::lab::{Wrong, plays};
use crate::run::PANIC;
use radiosity::prelude::{DVec3, dvec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("flux-times-area", "large lamps are bright", &[TIMES_AREA], {
        Work { radiosity: |flux, area| flux * area, ..WORK }
    }),
    plays("exitance-over-pi", "π goes everywhere", &[PI_TOO_EARLY], {
        Work { radiosity: |flux, area| radiosity(flux, area) / PI, ..WORK }
    }),
    plays("b-is-l", "brightness is brightness", &[NO_PI], {
        Work { radiance: radiosity, ..WORK }
    }),
    plays("l-is-pi-b", "L = π B", &[PI_UPSIDE_DOWN], {
        Work { radiance: |flux, area| PI * radiosity(flux, area), ..WORK }
    }),
    plays("hemisphere", "a hemisphere has 2π", &[TWO_PI], {
        Work { radiance: |flux, area| radiosity(flux, area) / 2.0 / PI, ..WORK }
    }),
    plays("bulb-no-cosine", "the inverse-square law", &[NO_COSINE], {
        Work {
            from_bulb: |flux, bulb, receiver| {
                from_bulb(flux, bulb, facing(receiver, bulb))
            },
            ..WORK
        }
    }),
    plays("bulb-linear", "light falls off as 1/r", &[DISTANCE], {
        Work {
            from_bulb: |flux, bulb, receiver| {
                from_bulb(flux, bulb, receiver) * bulb.distance(receiver.at)
            },
            ..WORK
        }
    }),
    plays("bulb-half", "a bulb shines into a hemisphere", &[NOT_ALL_ROUND], {
        Work { from_bulb: |flux, bulb, to| from_bulb(flux * 2.0, bulb, to), ..WORK }
    }),
    plays("bulb-through", "a negative cosine is a number", &[FROM_BEHIND], {
        Work {
            from_bulb: |flux, bulb, to| {
                let back = Spot { normal: -to.normal, ..to };
                from_bulb(flux, bulb, to) - from_bulb(flux, bulb, back)
            },
            ..WORK
        }
    }),
    plays("no-receiver-cosine", "a cosine at the lamp", &[NO_COSINE], {
        Work {
            from_surface: |l, area, source, receiver| {
                from_surface(l, area, source, facing(receiver, source.at))
            },
            ..WORK
        }
    }),
    plays("no-source-cosine", "a cosine at the wall", &[NO_SOURCE_COSINE], {
        Work {
            from_surface: |l, area, source, receiver| {
                from_surface(l, area, facing(source, receiver.at), receiver)
            },
            ..WORK
        }
    }),
    plays("long-cosines", "a dot product is a cosine", &[DISTANCE], {
        Work {
            from_surface: |l, area, source, receiver| {
                let way = receiver.at - source.at;
                let cosines = source.normal.dot(way).max(0.0)
                    * receiver.normal.dot(-way).max(0.0);
                l * area * cosines / way.length_squared()
            },
            ..WORK
        }
    }),
    plays("two-backs", "minus times minus", &[FROM_BEHIND], {
        Work {
            from_surface: |l, area, source, receiver| {
                let way = (receiver.at - source.at).normalize();
                let cosines = source.normal.dot(way) * receiver.normal.dot(-way);
                l * area * cosines.max(0.0) / source.at.distance_squared(receiver.at)
            },
            ..WORK
        }
    }),
    plays("surface-over-pi", "a form factor times L", &[PI_AGAIN], {
        Work { from_surface: |l, a, s, r| from_surface(l / PI, a, s, r), ..WORK }
    }),
    plays("sky-no-cosine", "∫ L dω", &[INTEGRAL_NO_COSINE], {
        Work { from_sky: |sky, n| from_sky(&|d| sky(d) / d.z, n), ..WORK }
    }),
    plays("sky-no-sine", "dω = dθ dφ", &[NO_SINE], {
        Work { from_sky: |sky, n| from_sky(&|d| sky(d) / d.x.hypot(d.y), n), ..WORK }
    }),
    plays("sky-degrees", "dθ is 90/n", &[DEGREES], {
        Work {
            from_sky: |sky, n| from_sky(sky, n) * (90.0 / FRAC_PI_2).powi(2),
            ..WORK
        }
    }),
    plays("sky-sine-of-degrees", "sin 45 is ½√2", &[DEGREES], {
        Work {
            from_sky: |sky, n| walked(sky, n, 90.0, 360.0, f64::to_radians(1.0)),
            ..WORK
        }
    }),
    plays("sky-half-round", "φ to π", &[HALF_TURN], {
        Work { from_sky: |sky, n| walked(sky, n, FRAC_PI_2, PI, 1.0), ..WORK }
    }),
    plays("sky-below", "θ to π", &[BELOW], {
        Work { from_sky: |sky, n| walked(sky, n, PI, 2.0 * PI, 1.0), ..WORK }
    }),
    plays("sky-mean", "a mean is an integral", &[MEAN], {
        Work { from_sky: |sky, n| from_sky(sky, n) / PI / PI, ..WORK }
    }),
    plays("sky-sum", "a sum is an integral", &[NO_STEP], {
        Work {
            from_sky: |sky, n| from_sky(sky, n) / (FRAC_PI_2 / n as f64).powi(2),
            ..WORK
        }
    }),
    plays("sky-times-pi", "H = π L", &[PI_AGAIN], {
        Work { from_sky: |sky, n| PI * from_sky(sky, n), ..WORK }
    }),
    plays("sky-flat-directions", "(cosφ, sinφ, cosθ)", &[NOT_A_DIRECTION], {
        Work {
            from_sky: |sky, n| {
                let flat = |d: DVec3| {
                    let across = d.x.hypot(d.y);
                    sky(dvec3(d.x / across, d.y / across, d.z))
                };
                from_sky(&flat, n)
            },
            ..WORK
        }
    }),
    plays("sky-list-too-short", "an index too far", &[PANIC], {
        Work {
            from_sky: |sky, n| {
                let rings = vec![from_sky(sky, n); n];
                rings[n]
            },
            ..WORK
        }
    }),
    plays("radiance-is-radiosity", "what leaves is what is seen", &[NO_PI], {
        Work {
            reflected: |h, rho| {
                let sent = reflected(h, rho);
                Sent { radiance: sent.radiosity, ..sent }
            },
            ..WORK
        }
    }),
    plays("brdf-times-h", "ρ/π times H is all there is", &[PI_TOO_EARLY], {
        Work { reflected: |h, rho| reflected(h / PI, rho), ..WORK }
    }),
    plays("absorbed", "ρ is what is kept", &[ABSORBED], {
        Work { reflected: |h, rho| reflected(h, 1.0 - rho), ..WORK }
    }),
    plays("white", "all light comes back", &[NO_REFLECTANCE], {
        Work { reflected: |h, _| reflected(h, 1.0), ..WORK }
    }),
];

/// Turned so that it faces `to`, if it faced it at all.
fn facing(spot: Spot, to: DVec3) -> Spot {
    let way = (to - spot.at).normalize();
    if spot.normal.dot(way) > 0.0 { Spot { normal: way, ..spot } } else { spot }
}

/// The sum over n rings to `theta` of 4n pieces to `phi`, both in units of `unit`.
fn walked(
    sky: &dyn Fn(DVec3) -> f64,
    n: usize,
    theta: f64,
    phi: f64,
    unit: f64,
) -> f64 {
    let (ring, piece) = (theta / n as f64, phi / (4 * n) as f64);
    let mut sum = 0.0;
    for cell in 0..4 * n * n {
        let t = ring * (0.5 + (cell / (4 * n)) as f64);
        let p = piece * (0.5 + (cell % (4 * n)) as f64);
        let at = dvec3(t.sin() * p.cos(), t.sin() * p.sin(), t.cos());
        sum += sky(at) * t.sin() * t.cos() * ring * unit * piece * unit;
    }
    sum
}
