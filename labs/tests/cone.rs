//! The lab `cone`: right answers that are not the answer, and the numbers that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::cone::given::{Cap, Glance};
use labs::cone::report::noise;
use labs::cone::{Work, answer, checks};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// The share by rings: of each the lamp takes the part that is near enough.
fn by_rings(cone: Cap, lamp: Cap) -> f64 {
    const RINGS: usize = 200_000;
    let (a, b) = (cone.half_angle, lamp.half_angle);
    let d = cone.axis.angle_between(lamp.axis);
    let ring = |k: usize| {
        // Even in cosθ, so that each ring has the same size.
        let u = (k as f64 + 0.5) / RINGS as f64;
        let cosine = 1.0 - u * (1.0 - a.cos());
        let sine = (1.0 - cosine * cosine).sqrt();
        let edge = (b.cos() - cosine * d.cos()) / (sine * d.sin());
        edge.clamp(-1.0, 1.0).acos() / PI
    };
    (0..RINGS).map(ring).sum::<f64>() / RINGS as f64
}

/// Caps by half-angle formulas, rays turned by hand, cells in another order, and
/// gloss by a function of its own.
#[test]
fn other_right_answers_pass() {
    let other = Work {
        solid_angle: |a| TAU * a.sin().powi(2) / (1.0 + a.cos()),
        projected: |a, tilt| 0.5 * PI * (1.0 - (2.0 * a).cos()) * tilt.cos(),
        ray: |cone, [u, v]| {
            let c = cone.half_angle.cos();
            let cosine = c + v * (1.0 - c);
            let x = cone.axis.any_orthonormal_vector();
            let (s, t) = (TAU * u).sin_cos();
            let sine = (1.0 - cosine * cosine).sqrt();
            cosine * cone.axis + sine * (t * x + s * cone.axis.cross(x))
        },
        mean: |light, cone, n, random| {
            let mut sum = 0.0;
            for i in (0..n).rev() {
                for j in 0..n {
                    let u = (i as f64 + random.next()) / n as f64;
                    let v = (j as f64 + random.next()) / n as f64;
                    sum += light((answer::WORK.ray)(cone, [v, u])) / (n * n) as f64;
                }
            }
            sum
        },
        gloss: |world, look, depth, random| {
            fn at(w: labs::cone::World, g: Glance, left: usize, r: &mut Stream) -> f64 {
                let hit = w(g.from, g.direction);
                let mut sum = 0.0;
                let rays = if left > 0 { g.strata * g.strata } else { 0 };
                for k in 0..rays {
                    let d =
                        g.direction - 2.0 * g.direction.dot(hit.normal) * hit.normal;
                    let cone = Cap { axis: d, half_angle: g.half_angle };
                    let cell = [k / g.strata, k % g.strata];
                    let u = cell.map(|c| (c as f64 + r.next()) / g.strata as f64);
                    let direction = (answer::WORK.ray)(cone, u);
                    sum += at(w, Glance { from: hit.at, direction, ..g }, left - 1, r);
                }
                hit.light + hit.gloss * sum / rays.max(1) as f64
            }
            at(world, look, depth, random)
        },
        ..answer::WORK
    };
    all_pass(checks::ALL, &[("answer", &answer::WORK), ("other", &other)]);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work { share: |_, _| f64::NAN, ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    assert_eq!(failing.map(|(name, _)| name).collect::<Vec<_>>(), ["cut", "clear"]);
}

/// The closed form of the overlap against rings, which know no triangles.
#[test]
fn rings_find_the_same_share() {
    for (a, b, d) in
        [(0.2, 0.3, 0.3), (1.2, 0.7, 0.9), (0.5, 1.5, 1.3), (0.4, 0.4, 0.1)]
    {
        let cone = Cap { axis: DVec3::Z, half_angle: a };
        let axis = dvec3(f64::sin(d), 0.0, f64::cos(d));
        let lamp = Cap { axis, half_angle: b };
        let (exact, rings) = ((answer::WORK.share)(cone, lamp), by_rings(cone, lamp));
        assert!((exact - rings).abs() < 1e-6, "{a} {b} {d}: {exact} {rings}");
    }
}

/// The numbers that the report asks for, pinned: a ray in each cell is better by √n,
/// where a rim runs through.
#[test]
fn the_rim_of_a_lamp_is_noisy_by_the_cells_that_it_crosses() {
    let [few, many] = [8, 32].map(|strata| noise(&answer::WORK, strata, 400));
    println!("{few:?} {many:?}");
    let [anywhere, stratified] =
        [few.anywhere / many.anywhere, few.stratified / many.stratified];
    assert!((3.4..4.7).contains(&anywhere), "{anywhere}"); // 4: as 1/n
    assert!((6.4..9.9).contains(&stratified), "{stratified}"); // 8: as 1/n^(3/2)
    assert!(many.stratified < 0.4 * many.anywhere);
}
