//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, albedo, lambert, passive, pdf, phong, sample};
use super::bugs::*;
use crate::lab::{Wrong, plays};
use radiosity::prelude::{DVec3, dvec3};
use std::f64::consts::PI;

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("lambert-no-pi", "what comes back is ρ", &[NO_PI], {
        Work { lambert: |rho, wi, wo| PI * lambert(rho, wi, wo), ..WORK }
    }),
    plays("lambert-hemisphere", "a hemisphere has 2π", &[OTHER_PI], {
        Work { lambert: |rho, wi, wo| lambert(rho, wi, wo) / 2.0, ..WORK }
    }),
    plays("lambert-cosine", "Lambert's law is the cosine law", &[COSINE_INSIDE], {
        Work { lambert: |rho, wi, wo| lambert(rho, wi, wo) * wi.z.max(0.0), ..WORK }
    }),
    plays("lambert-constant", "a constant is a constant", &[THROUGH], {
        Work { lambert: |rho, _, _| lambert(rho, DVec3::Z, DVec3::Z), ..WORK }
    }),
    plays("bare-phong", "ks cosⁿα, as in the lecture notes", &[NO_CONSTANT], {
        Work {
            phong: |n, wi, wo| phong(n, wi, wo) / phong(n, DVec3::Z, DVec3::Z),
            ..WORK
        }
    }),
    plays("n-plus-one", "∫ cosⁿα dω = 2π/(n + 1)", &[OF_DENSITY], {
        Work { phong: |n, wi, wo| phong(n, wi, wo) * (n + 1.0) / (n + 2.0), ..WORK }
    }),
    plays(
        "cosine-inside",
        "so one need not think of it",
        &[COSINE_INSIDE, NOT_RECIPROCAL],
        Work { phong: |n, wi, wo| phong(n, wi, wo) * wi.z.max(0.0), ..WORK },
    ),
    plays("phongs-own", "radiance in, radiance out", &[OVER_COSINE, NOT_RECIPROCAL], {
        Work {
            phong: |n, wi, wo| match wi.z > 0.0 {
                true => phong(n, wi, wo) / wi.z,
                false => 0.0,
            },
            ..WORK
        }
    }),
    plays("points-back", "the angle between wi and wo", &[RETRO, LOBE_BEHIND], {
        Work { phong: |n, wi, wo| phong(n, dvec3(-wi.x, -wi.y, wi.z), wo), ..WORK }
    }),
    plays(
        "upright",
        "the highlight is on the normal",
        &[ABOUT_NORMAL, NOT_RECIPROCAL, LOBE_BEHIND],
        {
            Work {
                phong: |n, wi, wo| match wo.z > 0.0 {
                    true => phong(n, wi, DVec3::Z),
                    false => 0.0,
                },
                ..WORK
            }
        },
    ),
    plays("blinn", "the halfway vector is cheaper", &[HALFWAY, LOBE_BEHIND], {
        Work {
            phong: |n, wi, wo| match wi.z > 0.0 && wo.z > 0.0 {
                true => phong(n, (wi + wo).normalize(), DVec3::Z),
                false => 0.0,
            },
            ..WORK
        }
    }),
    plays("no-horizon", "the cosine of α is enough", &[THROUGH], {
        Work { phong: |n, wi, wo| pdf(n, wi, wo) / (n + 1.0) * (n + 2.0), ..WORK }
    }),
    plays("horizon-of-the-lamp", "light comes from above", &[THROUGH], {
        Work {
            phong: |n, wi, wo| match wi.z > 0.0 {
                true => pdf(n, wi, wo) / (n + 1.0) * (n + 2.0),
                false => 0.0,
            },
            ..WORK
        }
    }),
    plays("two-sided-lobe", "an even power needs no cut", &[LOBE_BEHIND], {
        Work {
            phong: |n, wi, wo| {
                let back = pdf(n, -wi, wo) / (n + 1.0) * (n + 2.0);
                let above = wi.z > 0.0 && wo.z > 0.0;
                phong(n, wi, wo) + if above { back } else { 0.0 }
            },
            ..WORK
        }
    }),
    plays("albedo-no-cosine", "∫ f dω", &[NO_COSINE], {
        Work { albedo: |f, wo, n| albedo(&|wi, wo| f(wi, wo) / wi.z, wo, n), ..WORK }
    }),
    plays(
        "albedo-cosine-twice",
        "one for the lamp, one for the eye",
        &[COSINE_TWICE],
        {
            Work {
                albedo: |f, wo, n| albedo(&|wi, wo| f(wi, wo) * wi.z, wo, n),
                ..WORK
            }
        },
    ),
    plays("albedo-cosine-of-the-eye", "flux leaves by the cosine", &[OTHER_COSINE], {
        Work {
            albedo: |f, wo, n| albedo(&|wi, wo| f(wi, wo) / wi.z * wo.z, wo, n),
            ..WORK
        }
    }),
    plays("albedo-no-sine", "dω = dθ dφ", &[NO_SINE], {
        Work {
            albedo: |f, wo, n| albedo(&|wi, wo| f(wi, wo) / wi.x.hypot(wi.y), wo, n),
            ..WORK
        }
    }),
    plays("albedo-over-pi", "a mean over the hemisphere", &[PI_AGAIN], {
        Work { albedo: |f, wo, n| albedo(f, wo, n) / PI, ..WORK }
    }),
    plays("albedo-long-directions", "(cosφ, sinφ, cosθ)", &[NOT_UNIT], {
        Work {
            albedo: |f, wo, n| {
                let flat = |wi: DVec3, wo: DVec3| {
                    let across = wi.x.hypot(wi.y);
                    f(dvec3(wi.x / across, wi.y / across, wi.z), wo)
                };
                albedo(&flat, wo, n)
            },
            ..WORK
        }
    }),
    plays("pdf-is-the-brdf", "samples follow the BRDF", &[OF_BRDF], {
        Work { pdf: phong_everywhere, ..WORK }
    }),
    plays("pdf-with-cosine", "samples follow what is reflected", &[COSINE_INSIDE], {
        Work { pdf: |n, wi, wo| phong_everywhere(n, wi, wo) * wi.z.max(0.0), ..WORK }
    }),
    plays("root-of-n", "cosⁿα = u", &[ROOT], {
        Work { sample: |n, wo, u| sample(n - 1.0, wo, u), ..WORK }
    }),
    plays("sample-even", "random is random", &[UNIFORM], {
        Work { sample: |_, wo, u| sample(0.0, wo, u), ..WORK }
    }),
    plays("sample-upright", "a lobe has its own frame", &[ABOUT_NORMAL], {
        Work { sample: |n, _, u| sample(n, DVec3::Z, u), ..WORK }
    }),
    plays("sample-back", "towards the eye", &[RETRO], {
        Work { sample: |n, wo, u| sample(n, dvec3(-wo.x, -wo.y, wo.z), u), ..WORK }
    }),
    plays("sample-not-unit", "sinα = 1 − cosα", &[NOT_UNIT], {
        Work { sample: |n, wo, u| sample(n, wo, u) * 0.99, ..WORK }
    }),
    plays("each-alone", "both are at most 1", &[EACH_ALONE], {
        Work { passive: |d, s| passive(d, [0.0; 3]) && passive([0.0; 3], s), ..WORK }
    }),
    plays("on-average", "it is about all light", &[MEAN_OF_CHANNELS], {
        Work {
            passive: |d, s| {
                let mean = |k: [f64; 3]| [k.iter().sum::<f64>() / 3.0; 3];
                passive(mean(d), mean(s))
            },
            ..WORK
        }
    }),
    plays("below-one", "less than came", &[STRICT], {
        Work {
            passive: |d, s| {
                passive(d.map(|k| 1.000_000_1 * k), s.map(|k| 1.000_000_1 * k))
            },
            ..WORK
        }
    }),
];

/// The lobe with the BRDF's constant, below the horizon too.
fn phong_everywhere(n: f64, wi: DVec3, wo: DVec3) -> f64 {
    pdf(n, wi, wo) * phong(n, DVec3::Z, DVec3::Z) / pdf(n, DVec3::Z, DVec3::Z)
}
