//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::answer::{WORK, gloss, mean, projected, ray, share, solid_angle};
use super::bugs::*;
use super::given::{Cap, Glance};
use super::{Work, World};
use crate::lab::{Wrong, plays};
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("aperture", "an angle is an angle", &[WHOLE_ANGLE], {
        Work { solid_angle: |a| solid_angle(a / 2.0), ..WORK }
    }),
    plays("with-a-cosine", "∫ cosθ dω", &[PROJECTED], {
        Work { solid_angle: |a| projected(a, 0.0), ..WORK }
    }),
    plays("disc", "a cone ends in a disc", &[FLAT], {
        Work { solid_angle: |a| PI * a.powi(2), ..WORK }
    }),
    plays("one-minus-cosine", "2π (1 − cos a)", &[CANCELS], {
        Work { solid_angle: |a| 2.0 * PI * (1.0 - a.cos()), ..WORK }
    }),
    plays("cosine-of-the-axis", "Ω cosθ", &[SOLID], {
        Work { projected: |a, tilt| solid_angle(a) * tilt.cos(), ..WORK }
    }),
    plays("no-tilt", "π sin²a", &[NO_TILT], {
        Work { projected: |a, _| projected(a, 0.0), ..WORK }
    }),
    plays("sine", "the radius of the disc", &[NOT_SQUARED], {
        Work { projected: |a, tilt| projected(a, tilt) / a.sin(), ..WORK }
    }),
    plays("form-factor", "a share of everything", &[NO_PI], {
        Work { projected: |a, tilt| projected(a, tilt) / PI, ..WORK }
    }),
    plays("of-the-lamp", "how much of the lamp is there?", &[OF_THE_LAMP], {
        Work { share: |cone, lamp| share(lamp, cone), ..WORK }
    }),
    plays("overlap", "the overlap", &[STERADIANS], {
        Work {
            share: |cone, lamp| share(cone, lamp) * solid_angle(cone.half_angle),
            ..WORK
        }
    }),
    plays("one-look", "is the axis on the lamp?", &[ALL_OR_NOTHING], {
        Work {
            share: |cone, lamp| {
                f64::from(cone.axis.dot(lamp.axis) > lamp.half_angle.cos())
            },
            ..WORK
        }
    }),
    plays("flat-discs", "two discs on paper", &[FLAT_DISCS], {
        Work { share: flat_share, ..WORK }
    }),
    plays("always-a-triangle", "the formula", &[NO_TRIANGLE], {
        Work {
            share: |cone, lamp| {
                let apart = cone.axis.angle_between(lamp.axis);
                let (a, b) = (cone.half_angle, lamp.half_angle);
                let corner = (apart.cos() - a.cos() * b.cos()) / (a.sin() * b.sin());
                share(cone, lamp) + 0.0 * corner.acos()
            },
            ..WORK
        }
    }),
    plays("even-angles", "θ = u a", &[EVEN_ANGLES], {
        Work {
            ray: |cone, [u, v]| {
                let (sine, cosine) = (u * cone.half_angle).sin_cos();
                turned(cone.axis, sine, cosine, v)
            },
            ..WORK
        }
    }),
    plays("even-disc", "θ = a√u, as on a disc", &[EVEN_DISC], {
        Work {
            ray: |cone, [u, v]| {
                let (sine, cosine) = (u.sqrt() * cone.half_angle).sin_cos();
                turned(cone.axis, sine, cosine, v)
            },
            ..WORK
        }
    }),
    plays("cosine-weighted", "as for form factors", &[BY_COSINE], {
        Work {
            ray: |cone, [u, v]| {
                let sine = u.sqrt() * cone.half_angle.sin();
                turned(cone.axis, sine, (1.0 - sine * sine).sqrt(), v)
            },
            ..WORK
        }
    }),
    plays("half-turn", "φ = π v", &[HALF_TURN], {
        Work { ray: |cone, [u, v]| ray(cone, [u, v / 2.0]), ..WORK }
    }),
    plays("upright", "(sinθ cosφ, sinθ sinφ, cosθ)", &[ABOUT_Z], {
        Work { ray: |cone, u| ray(Cap { axis: DVec3::Z, ..cone }, u), ..WORK }
    }),
    plays("long", "axis and something across", &[NOT_UNIT], {
        Work { ray: |cone, u| ray(cone, u) * 1.01, ..WORK }
    }),
    plays("sum", "add them up", &[SUM], {
        Work {
            mean: |light, cone, n, random| {
                mean(light, cone, n, random) * (n * n) as f64
            },
            ..WORK
        }
    }),
    plays("integral", "∫ L dω", &[INTEGRAL], {
        Work {
            mean: |light, cone, n, random| {
                mean(light, cone, n, random) * solid_angle(cone.half_angle)
            },
            ..WORK
        }
    }),
    plays("mirror", "gloss is a mirror", &[ONE_RAY, SAME_RAYS], {
        Work { mean: |light, cone, _, _| light(cone.axis), ..WORK }
    }),
    plays("anywhere", "random is random", &[NOT_STRATIFIED], {
        Work {
            mean: |light, cone, n, random| {
                let mut sum = 0.0;
                for _ in 0..n * n {
                    sum += light(ray(cone, [random.next(), random.next()]));
                }
                sum / (n * n) as f64
            },
            ..WORK
        }
    }),
    plays("middle-of-the-cell", "the middle is the best place", &[SAME_RAYS], {
        Work {
            mean: |light, cone, n, _| {
                let middle = |k: usize| (k as f64 + 0.5) / n as f64;
                let at = |k: usize| ray(cone, [middle(k % n), middle(k / n)]);
                (0..n * n).map(|k| light(at(k))).sum::<f64>() / (n * n) as f64
            },
            ..WORK
        }
    }),
    plays("no-own-light", "what it reflects", &[OWN_LIGHT], {
        Work { gloss: reflected, ..WORK }
    }),
    plays("no-share", "the mean over the cone", &[NO_SHARE], {
        Work { gloss: unfading, ..WORK }
    }),
    plays("deeper", "until depth is below zero", &[WRONG_DEPTH], {
        Work {
            gloss: |world, look, depth, random| gloss(world, look, depth + 1, random),
            ..WORK
        }
    }),
    plays("one-level", "the lecture's rule", &[ONE_LEVEL], {
        Work {
            gloss: |world, look, depth, random| {
                gloss(world, look, depth.min(1), random)
            },
            ..WORK
        }
    }),
    plays("straight-on", "the ray goes on", &[STRAIGHT_ON], {
        Work {
            gloss: |world, look, depth, random| {
                aimed(world, look, depth, random, |d, _| d)
            },
            ..WORK
        }
    }),
    plays("on-the-normal", "a lobe stands on the surface", &[ABOUT_NORMAL], {
        Work {
            gloss: |world, look, depth, random| {
                aimed(world, look, depth, random, |_, n| n)
            },
            ..WORK
        }
    }),
    plays("back-to-the-eye", "2 (d·n) n − d", &[BACK], {
        Work {
            gloss: |world, look, depth, random| {
                aimed(world, look, depth, random, |d, _| -d)
            },
            ..WORK
        }
    }),
];

fn turned(axis: DVec3, sine: f64, cosine: f64, v: f64) -> DVec3 {
    let (y, x) = (PI * 2.0 * v).sin_cos();
    Frame::about(axis).world_from_local(dvec3(sine * x, sine * y, cosine))
}

/// The overlap of circles of the radii a and b on paper, as a share of the first.
fn flat_share(cone: Cap, lamp: Cap) -> f64 {
    let (a, b) = (cone.half_angle, lamp.half_angle);
    let d = cone.axis.angle_between(lamp.axis);
    if d >= a + b || d <= (a - b).abs() {
        let small = a.min(b) / a;
        return if d < a + b { small * small } else { 0.0 };
    }
    let at = |own: f64, other: f64| {
        ((d * d + own * own - other * other) / (2.0 * d * own)).acos()
    };
    let (s, t) = (at(a, b), at(b, a));
    let lens = a * a * (s - s.sin() * s.cos()) + b * b * (t - t.sin() * t.cos());
    lens / (PI * a * a)
}

/// Gloss without light of its own.
fn reflected(world: World, look: Glance, depth: usize, random: &mut Stream) -> f64 {
    let hit = world(look.from, look.direction);
    if hit.gloss == 0.0 || depth == 0 {
        return hit.light;
    }
    let axis = look.direction - 2.0 * hit.normal * hit.normal.dot(look.direction);
    let cone = Cap { axis, half_angle: look.half_angle };
    let n = look.strata;
    let mut sum = 0.0;
    for k in 0..n * n {
        let u = [k / n, k % n].map(|cell| (random.next() + cell as f64) / n as f64);
        let next = Glance { from: hit.at, direction: ray(cone, u), ..look };
        sum += reflected(world, next, depth - 1, random) / (n * n) as f64;
    }
    hit.gloss * sum
}

/// Gloss of a share of 1.
fn unfading(world: World, look: Glance, depth: usize, random: &mut Stream) -> f64 {
    let all = |from: DVec3, d: DVec3| {
        let hit = world(from, d);
        let gloss = if hit.gloss > 0.0 { 1.0 } else { 0.0 };
        super::given::Hit { gloss, ..hit }
    };
    gloss(&all, look, depth, random)
}

/// Gloss about another axis, made of the direction and the normal.
fn aimed(
    world: World,
    look: Glance,
    depth: usize,
    random: &mut Stream,
    axis: fn(DVec3, DVec3) -> DVec3,
) -> f64 {
    // A surface that mirrors `direction` to this axis: its normal is between the two.
    let tilted = |from: DVec3, d: DVec3| {
        let hit = world(from, d);
        let normal = (axis(d, hit.normal) - d).normalize_or_zero();
        super::given::Hit { normal, ..hit }
    };
    gloss(&tilted, look, depth, random)
}
