//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, clear, fresnel, frosted, mean, pane, sheet};
use super::bugs::*;
use super::given::{Lamp, crossing, plane};
use crate::lab::{Wrong, plays};
use radiosity::prelude::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};

/// The answer, but with other lamps behind the pane.
macro_rules! shines {
    ($clear:expr) => {
        Work { clear: $clear, ..WORK }
    };
}

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("amplitudes", "Fresnel's formulas", &[NOT_SQUARED], {
        Work { fresnel: |c, n| fresnel(c, n).map(f64::sqrt), ..WORK }
    }),
    plays("p-and-s", "p is parallel to the surface", &[EXCHANGED], {
        Work {
            fresnel: |c, n| {
                let [s, p] = fresnel(c, n);
                [p, s]
            },
            ..WORK
        }
    }),
    plays("out-of-glass", "n sinᵢ = sinₜ", &[UPSIDE_DOWN], {
        Work { fresnel: |c, n| fresnel(c, n.recip()), ..WORK }
    }),
    plays("straight-through", "a pane does not bend light", &[NOT_BENT], {
        Work { fresnel: |_, n| fresnel(1.0, n), ..WORK }
    }),
    plays("what-passes", "1 − R", &[PASSED], {
        Work { fresnel: |c, n| fresnel(c, n).map(|r| 1.0 - r), ..WORK }
    }),
    plays("one-face", "glass passes 96 %", &[ONE_FACE], {
        Work {
            pane: |c, n| {
                let [s, p] = fresnel(c, n);
                1.0 - (s + p) / 2.0
            },
            ..WORK
        }
    }),
    plays("two-faces", "96 % of 96 %", &[NO_REFLECTIONS], {
        Work {
            pane: |c, n| {
                let [s, p] = fresnel(c, n).map(|r| 1.0 - 2.0 * r + r * r);
                (s + p) / 2.0
            },
            ..WORK
        }
    }),
    plays("grey-light", "unpolarised light is the mean", &[MEAN_FIRST], {
        Work {
            pane: |c, n| {
                let r = fresnel(c, n).iter().sum::<f64>() / 2.0;
                (1.0 - r) / (1.0 + r)
            },
            ..WORK
        }
    }),
    plays("s-alone", "the first of the two formulas", &[ONE_POLARISATION], {
        Work {
            pane: |c, n| {
                let [s, _] = fresnel(c, n);
                2.0 / (1.0 + s) - 1.0
            },
            ..WORK
        }
    }),
    plays("what-comes-back", "1 − T", &[REFLECTED], {
        Work { pane: |c, n| 1.0 - pane(c, n), ..WORK }
    }),
    plays("both-together", "s and p", &[SUMMED], {
        Work { pane: |c, n| pane(c, n) + pane(c, n), ..WORK }
    }),
    plays("ninety-two", "a pane passes 92 %", &[STRAIGHT_ON], {
        Work { pane: |_, n| pane(1.0, n), ..WORK }
    }),
    plays("every-direction", "the mean over the hemisphere", &[NO_COSINE], {
        Work {
            mean: |n, rings| over(rings, |sine, cosine| sine * pane(cosine, n)),
            ..WORK
        }
    }),
    plays("every-angle", "all angles alike", &[NO_SINE], {
        Work {
            mean: |n, rings| over(rings, |_, cosine| cosine * pane(cosine, n)),
            ..WORK
        }
    }),
    plays("mean-ninety-two", "diffuse light has no angle", &[STRAIGHT_ON], {
        Work { mean: |n, _| pane(1.0, n), ..WORK }
    }),
    plays("integral", "∫ T cosθ dω", &[NOT_A_MEAN], {
        Work { mean: |n, rings| PI * mean(n, rings), ..WORK }
    }),
    plays("no-glass", "glass is clear", &[NO_GLASS], {
        shines!(|p, n, window, index, lamp| {
            let d = (lamp.at - p).normalize();
            let passed = pane(plane(window).normal.dot(d).abs(), index);
            clear(p, n, window, index, lamp) / passed
        })
    }),
    plays("clear-ninety-two", "the pane's transmittance", &[STRAIGHT_ON], {
        shines!(|p, n, window, index, lamp| by(p, n, window, index, lamp, |_| 1.0))
    }),
    plays("angle-at-the-point", "the angle of incidence", &[OTHER_ANGLE], {
        shines!(|p, n, window, index, lamp| {
            let d = (lamp.at - p).normalize();
            by(p, n, window, index, lamp, |_| n.dot(d).abs())
        })
    }),
    plays("angle-at-the-lamp", "where it leaves", &[OTHER_ANGLE], {
        shines!(|p, n, window, index, lamp| {
            by(p, n, window, index, lamp, |d| d.dot(lamp.normal).abs())
        })
    }),
    plays("front-of-the-pane", "backs are dark", &[ONE_WAY_PANE], {
        shines!(|p, n, window, index, lamp| match plane(window).height(p) > 0.0 {
            true => clear(p, n, window, index, lamp),
            false => 0.0,
        })
    }),
    plays("one-cosine", "E = I cosθ/r²", &[NO_LAMP_COSINE], {
        shines!(|p, n, window, index, lamp| {
            let normal = (p - lamp.at).normalize();
            clear(p, n, window, index, Lamp { normal, ..lamp })
        })
    }),
    plays("no-pi", "cosines, area, distance", &[NO_PI], {
        shines!(|p, n, window, index, lamp| {
            clear(p, n, window, index, Lamp { area: PI * lamp.area, ..lamp })
        })
    }),
    plays("no-wall", "a window is a plane", &[NO_WALL], {
        shines!(|p, n, window, index, lamp| {
            let middle = window.iter().sum::<DVec3>() / window.len() as f64;
            let large = |c: &DVec3| middle + (c - middle) * 1e4;
            let wide: Vec<DVec3> = window.iter().map(large).collect();
            clear(p, n, &wide, index, lamp)
        })
    }),
    plays("two-sided-lamp", "a cosine is positive", &[FROM_BEHIND], {
        shines!(|p, n, window, index, lamp| {
            let back = Lamp { normal: -lamp.normal, ..lamp };
            [n, -n]
                .map(|n| {
                    clear(p, n, window, index, lamp) + clear(p, n, window, index, back)
                })
                .iter()
                .sum()
        })
    }),
    plays("rho-for-tau", "in order of the arguments", &[RHO_FOR_TAU], {
        Work { sheet: |h, rho, tau| sheet(h, tau, rho), ..WORK }
    }),
    plays("light-comes-in", "from the front to the back", &[ONE_WAY_SHEET], {
        Work { sheet: |[a, b], rho, tau| [rho * a, sheet([a, b], rho, tau)[1]], ..WORK }
    }),
    plays("it-passes", "a sheet passes light", &[NO_REFLECTANCE], {
        Work { sheet: |h, _, tau| sheet(h, 0.0, tau), ..WORK }
    }),
    plays("it-reflects", "B = E + ρ H", &[NOTHING_PASSES], {
        Work { sheet: |h, rho, _| sheet(h, rho, 0.0), ..WORK }
    }),
    plays("same-face", "what falls on it leaves it", &[SAME_FACE], {
        Work { sheet: |h, rho, tau| h.map(|h| rho * h + tau * h), ..WORK }
    }),
    plays("clear-paper", "what falls on it goes on", &[NO_TAU], {
        Work { frosted: |p, n, w, outside, _| frosted(p, n, w, outside, 1.0), ..WORK }
    }),
    plays("radiosity", "B = τ H", &[NO_FACTOR], {
        Work { frosted: |_, _, _, outside, tau| outside * tau, ..WORK }
    }),
    plays("as-radiance", "L = B/π", &[PI_AGAIN], {
        Work {
            frosted: |p, n, w, outside, tau| frosted(p, n, w, outside, tau / PI),
            ..WORK
        }
    }),
];

/// 2 ∫ `of`(sine, cosine) dθ.
fn over(rings: usize, of: impl Fn(f64, f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for k in 0..rings {
        let theta = FRAC_PI_2 * (0.5 + k as f64) / rings as f64;
        sum += of(theta.sin(), theta.cos());
    }
    2.0 * sum * FRAC_PI_2 / rings as f64
}

/// The transmittance by another cosine, of the direction to the lamp.
fn by(
    p: DVec3,
    n: DVec3,
    window: &[DVec3],
    index: f64,
    lamp: Lamp,
    cosine: impl Fn(DVec3) -> f64,
) -> f64 {
    if crossing(p, lamp.at, window).is_none() {
        return 0.0;
    }
    let d = (lamp.at - p).normalize();
    let right = pane(d.dot(plane(window).normal).abs(), index);
    clear(p, n, window, index, lamp) * pane(cosine(d), index) / right
}
