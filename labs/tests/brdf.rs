//! The lab `brdf`: right answers that are not the answer, and the failure that its report
//! asks for.

mod common;

use common::all_pass;
use labs::brdf::report::errors;
use labs::brdf::{Work, answer, checks};
use radiosity::material::Lobe;
use radiosity::prelude::{DVec3, dvec2, dvec3};
use std::f64::consts::{PI, TAU};

#[test]
fn other_right_answers_pass() {
    fn lobe(exponent: f64) -> Lobe {
        Lobe::Phong { exponent }
    }
    let library = Work {
        lambert: |rho, wi, wo| rho * Lobe::Lambert.value(wi, wo),
        phong: |n, wi, wo| lobe(n).value(wi, wo),
        sample: |n, wo, [u, v]| lobe(n).sample(wo, dvec2(v, u)),
        pdf: |n, wi, wo| lobe(n).pdf(wi, wo),
        ..answer::WORK
    };
    let other = Work { albedo: even_in_the_cosine, sample: by_tangent, ..answer::WORK };
    let works = [("answer", &answer::WORK), ("library", &library), ("other", &other)];
    all_pass(checks::ALL, &works);
}

/// Rings of equal solid angle.
fn even_in_the_cosine(f: labs::brdf::Brdf, wo: DVec3, rings: usize) -> f64 {
    let mut sum = 0.0;
    for cell in 0..4 * rings * rings {
        let z = ((cell % rings) as f64 + 0.5) / rings as f64;
        let (y, x) =
            (TAU * ((cell / rings) as f64 + 0.5) / (4 * rings) as f64).sin_cos();
        let across = (1.0 - z * z).sqrt();
        sum += f(dvec3(across * x, across * y, z), wo) * z;
    }
    sum * TAU / (4 * rings * rings) as f64
}

/// The mirror image's frame made by hand, and the other end of the unit interval.
fn by_tangent(n: f64, wo: DVec3, u: [f64; 2]) -> DVec3 {
    let axis = 2.0 * wo.z * DVec3::Z - wo;
    let x = axis.cross(DVec3::X).normalize();
    let cosine = u[0].powf(1.0 / (1.0 + n));
    let (s, c) = (2.0 * PI * u[1]).sin_cos();
    cosine * axis + (1.0 - cosine * cosine).sqrt() * (c * x + s * axis.cross(x))
}

/// What the report asks for, pinned: rings find a lobe while it is wider than they are,
/// and miss it beyond. Samples gain: f cosθ/pdf is the cosine, which varies the less the
/// narrower the lobe, by 1/√n.
#[test]
fn rings_lose_a_narrow_lobe_and_samples_do_not() {
    let of = |exponent, rings| errors(&answer::WORK, exponent, rings, 32);
    assert!(of(100.0, 16).grid < 1e-5, "{:?}", of(100.0, 16));
    // A ring of 16 is 0.1 rad wide, a lobe of 10⁴ 0.024.
    assert!(of(1e4, 16).grid > 0.3, "{:?}", of(1e4, 16));
    assert!(of(1e4, 32).grid > 0.05, "{:?}", of(1e4, 32));
    for exponent in [100.0, 1e3, 1e4] {
        let [wide, narrow] = [exponent, 10.0 * exponent].map(|n| of(n, 16).samples);
        let gain = wide / narrow;
        assert!((2.5..4.0).contains(&gain), "{exponent}: {gain}");
    }
}
