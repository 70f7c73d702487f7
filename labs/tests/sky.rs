//! The lab `sky`: right answers that are not the answer, and the failure that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::sky::report::errors;
use labs::sky::{Map, Work, answer, checks};
use radiosity::geometry::Rgb;
use radiosity::prelude::{DVec2, DVec3};
use radiosity::sky::{Panorama, Sky};
use std::f64::consts::{PI, TAU};

fn sky(map: &Map) -> Sky {
    let texels = map.radiance.iter().map(|&l| Rgb::splat(l)).collect();
    Sky::panorama(Panorama::new(map.width, texels).unwrap(), DVec3::Y)
}

/// Draws directions evenly until one is bright enough.
fn by_rejection(map: &Map, u: DVec2) -> (DVec3, f64) {
    let brightest = map.radiance.iter().copied().fold(0.0, f64::max);
    let key = [u.x.to_bits(), u.y.to_bits()];
    let mut stream = radiosity::random::Stream::named(0, &key);
    let total: f64 = (0..map.radiance.len())
        .map(|k| map.radiance[k] * answer::texel(map.width, map.height, k / map.width))
        .sum();
    loop {
        let d = answer::towards(1.0 - 2.0 * stream.next(), TAU * (stream.next() - 0.5));
        let light = sky(map).radiance(d).x;
        if stream.next() * brightest < light {
            return (d, light / total);
        }
    }
}

#[test]
fn other_right_answers_pass() {
    let library = Work {
        texel: |w, h, row| {
            Panorama::new(w, vec![Rgb::ZERO; w * h]).unwrap().solid_angle(row)
        },
        irradiance: |map, normal| sky(map).irradiance(normal).x,
        sample: |map, u| sky(map).sample(u),
        ..answer::WORK
    };
    let plain = Work {
        texel: |w, h, row| {
            let theta = PI * (row as f64 + 0.5) / h as f64;
            theta.sin() * TAU / w as f64 * PI / h as f64
        },
        sample: by_rejection,
        ..answer::WORK
    };
    let works = [("answer", &answer::WORK), ("library", &library), ("plain", &plain)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work {
        texel: |_, _, _| f64::NAN,
        direction: |_, _, _, _| DVec3::splat(f64::NAN),
        irradiance: |_, _| f64::NAN,
        sample: |_, _| (DVec3::Y, f64::NAN),
    };
    assert!(judge(checks::ALL, &work, "0").iter().all(|(_, v)| !v.passed()));
}

/// With the sun half as wide, even directions are twice as wrong; those by brightness
/// do not care.
#[test]
fn small_suns_are_hard_to_find() {
    let [large, small] = [8, 32].map(|width| errors(&answer::WORK, width, 256, 400));
    assert!(small.even / large.even > 2.5, "{large:?} {small:?}");
    assert!(small.bright < 0.1 && large.bright < 0.1, "{large:?} {small:?}");
}
