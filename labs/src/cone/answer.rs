//! One right answer: caps of the sphere, and rays that are even on them.
#![deny(warnings)]

use super::given::{Cap, Glance};
use super::{Light, Work, World};
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// Task 1: 1 − cos a = 2 sin²(a/2), and the right side keeps its digits.
pub fn solid_angle(half_angle: f64) -> f64 {
    4.0 * PI * (0.5 * half_angle).sin().powi(2)
}

/// Task 2: the cone cuts a disc of radius sin a out of the sphere's shadow.
pub fn projected(half_angle: f64, tilt: f64) -> f64 {
    PI * half_angle.sin().powi(2) * tilt.cos()
}

/// Task 3: apart, one in the other, or two segments that meet along a chord.
pub fn share(cone: Cap, lamp: Cap) -> f64 {
    let (a, b) = (cone.half_angle, lamp.half_angle);
    let d = cone.axis.angle_between(lamp.axis);
    if d >= a + b {
        return 0.0;
    }
    if d <= (a - b).abs() {
        return (solid_angle(a.min(b)) / solid_angle(a)).min(1.0);
    }
    // The spherical triangle of both axes and a point where the rims cross.
    let angle = |far: f64, x: f64, y: f64| {
        let cosine = (far.cos() - x.cos() * y.cos()) / (x.sin() * y.sin());
        cosine.clamp(-1.0, 1.0).acos()
    };
    let (at_cone, at_lamp, at_rim) = (angle(b, d, a), angle(a, d, b), angle(d, a, b));
    let both = PI - at_rim - at_cone * a.cos() - at_lamp * b.cos();
    2.0 * both / solid_angle(a)
}

/// Task 4: a zone of the sphere is as large as it is high (Archimedes).
pub fn ray(cone: Cap, u: [f64; 2]) -> DVec3 {
    let cosine = 1.0 - u[0] * (1.0 - cone.half_angle.cos());
    let sine = (1.0 - cosine * cosine).sqrt();
    let (y, x) = (2.0 * PI * u[1]).sin_cos();
    Frame::about(cone.axis).world_from_local(dvec3(sine * x, sine * y, cosine))
}

/// A random place in cell k of n · n.
fn place(k: usize, n: usize, random: &mut Stream) -> [f64; 2] {
    [k % n, k / n].map(|cell| (cell as f64 + random.next()) / n as f64)
}

/// Task 5: one ray in each cell.
pub fn mean(light: Light, cone: Cap, strata: usize, random: &mut Stream) -> f64 {
    let rays = strata * strata;
    let one = |k: usize| light(ray(cone, place(k, strata, random)));
    (0..rays).map(one).sum::<f64>() / rays as f64
}

/// Task 6: the same, where each ray is a glance of its own.
pub fn gloss(world: World, look: Glance, depth: usize, random: &mut Stream) -> f64 {
    let hit = world(look.from, look.direction);
    if depth == 0 || hit.gloss == 0.0 {
        return hit.light;
    }
    let axis = look.direction.reflect(hit.normal);
    let cone = Cap { axis, half_angle: look.half_angle };
    let rays = look.strata * look.strata;
    let mut sum = 0.0;
    for k in 0..rays {
        let direction = ray(cone, place(k, look.strata, random));
        let next = Glance { from: hit.at, direction, ..look };
        sum += gloss(world, next, depth - 1, random);
    }
    hit.light + hit.gloss * sum / rays as f64
}

/// What is handed in.
pub const WORK: Work = Work { solid_angle, projected, share, ray, mean, gloss };
