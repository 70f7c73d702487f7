//! The suites of pictures, skies, certificates and directions, small and without a clock: who
//! is more accurate at equal work, and work that theory counts.

use radiosity::chart::suites::look::Onlooker;
use radiosity::chart::suites::{certificate, directional, pictures, second_pass, sky};
use radiosity::chart::{Bench, Trial};

/// The trial of this method and setting.
fn find<'t>(trials: &'t [Trial], method: &str, setting: f64) -> &'t Trial {
    let fits = |t: &&Trial| t.method == method && t.setting == setting;
    trials.iter().find(fits).unwrap_or_else(|| panic!("{method}, {setting}"))
}

fn error(trials: &[Trial], method: &str, setting: f64) -> f64 {
    find(trials, method, setting).error
}

/// Of a lamp half in a lobe. Of N cones at even levels the lamp's edge may cut one or two
/// otherwise than the lobe, so that the error falls as 1/N or so; one cone stays where it is.
#[test]
fn stacked_cones_come_to_the_lobe_and_one_cone_does_not() {
    let trials = second_pass::lobe(&Bench::SILENT);
    let cones = |n| error(&trials, "N stacked cones", n);
    assert!(cones(256.0) < 0.1 * cones(4.0), "{}", cones(256.0));
    assert!(error(&trials, "one cone of 90 %", 1.0) > 3.0 * cones(64.0));
    assert!(cones(4.0) < error(&trials, "N rays", 4.0));
    assert!(error(&trials, "N rays", 256.0) < 0.05);
    assert_eq!(find(&trials, "N stacked cones", 64.0).work.factors, 64);
    assert_eq!(find(&trials, "N rays", 64.0).work.rays, 64);
}

/// Cones carry the lamp, rays the rest: more of either is better, until the other's noise
/// is left.
#[test]
fn gloss_wants_cones_first() {
    let trials = second_pass::gloss(16, 64, &Bench::SILENT);
    let cones = |n| error(&trials, "8 rays and N cones", n);
    assert!(cones(32.0) < 0.5 * cones(2.0), "{} {}", cones(32.0), cones(2.0));
    let rays = |n| error(&trials, "N rays and 8 cones", n);
    assert!(rays(32.0) < 1.1 * rays(1.0));
    assert!(cones(32.0) < error(&trials, "N rays in one cone", 32.0));
    // Each pixel of the floor sends as many rays as it is told to, and none is lost as one
    // of many.
    let sent = |n| find(&trials, "N rays and 8 cones", n).work.rays;
    assert!(sent(32.0) >= 31 * sent(1.0), "{} {}", sent(32.0), sent(1.0));
}

/// A sun is a small part of the sky and most of its light.
#[test]
fn who_draws_by_brightness_finds_the_sun() {
    let all = sky::ground(&[64.0, 1024.0], &Bench::SILENT);
    let at = |scene: &str| -> Vec<Trial> {
        all.iter().filter(|t| t.scene == scene).cloned().collect()
    };
    let (sun, clouds) = (at(sky::SUNNY), at(sky::OVERCAST));
    let bright = error(&sun, "by brightness", 1024.0);
    assert!(error(&sun, "even", 1024.0) > 30.0 * bright);
    assert!(error(&sun, "by the cosine", 1024.0) > 30.0 * bright);
    // One over the root: 16 times the rays, a quarter of the error; known to 5 %.
    let ratio = error(&sun, "by brightness", 64.0) / bright;
    assert!((3.3..4.8).contains(&ratio), "{ratio}");
    assert!(find(&sun, "all texels", 8192.0).error < 1e-12);
    // Clouds have no sun: a factor of some units is all there is to gain.
    let even = error(&clouds, "even", 1024.0);
    assert!((1.2..10.0).contains(&(even / error(&clouds, "by the cosine", 1024.0))));
}

/// Four times the points halve the interval, and it is not narrower than what happens.
#[test]
fn certificates_tell_more_by_more_points() {
    let trials = certificate::audit(0.2, &[400.0, 1600.0], 8, &Bench::SILENT);
    let of = |scene: &str, points: f64| {
        let fits = |t: &&Trial| {
            t.scene == scene && t.setting == points && t.method == "64 rays"
        };
        trials.iter().find(fits).expect("it ran").error
    };
    let narrower = of(certificate::WIDTH, 400.0) / of(certificate::WIDTH, 1600.0);
    assert!((1.4..3.0).contains(&narrower), "{narrower}");
    for points in [400.0, 1600.0] {
        assert!(of(certificate::OFF, points) < of(certificate::WIDTH, points));
    }
}

/// One unknown for each direction: work counted, memory that grows, and two passes that
/// need none of it.
#[test]
fn directions_cost_more_than_they_gain() {
    let others: [&[f64]; 2] = [&[0.1], &[8.0]];
    let trials = directional::run(&[0.5, 0.25], &[1, 4], others, 64, &Bench::SILENT);
    let run = |patches: &str, bins| find(&trials, &format!("{patches} patches"), bins);
    for (patches, n) in [("28", 28), ("96", 96)] {
        let (one, many) = (run(patches, 1.0), run(patches, 16.0));
        assert_eq!(one.work.rays, 200 * n);
        assert_eq!(many.work.rays, 200 * 16 * n);
        assert!(many.work.bytes > 4 * one.work.bytes);
        assert!(many.error < one.error);
        assert!(many.energy.unwrap() < 1e-9, "{:?}", many.energy);
    }
    assert!(run("96", 16.0).error < run("28", 16.0).error);
    let two = find(&trials, "two passes", 0.1).error;
    assert!(two < 0.5 * run("96", 16.0).error, "{two}");
}

/// Only two passes show all light of a room with a mirror; the others lack a tenth of it,
/// or are noisy.
#[test]
fn two_passes_beat_what_is_half_of_them() {
    let look = Onlooker::at("cornell-mirror", 48, 600, 100);
    let trials =
        pictures::at_equal_error(&look, "a box", &[0.05], &[16.0], &Bench::SILENT);
    let two = error(&trials, "two passes", 0.05);
    let half =
        [("radiosity", 0.05), ("classical radiosity", 0.05), ("ray tracing", 4.0)];
    for (method, setting) in half {
        assert!(error(&trials, method, setting) > 3.0 * two, "{method}");
    }
    assert!(error(&trials, "paths", 16.0) > 3.0 * two);
    assert!(two < 0.1, "{two}");
    let brighter = |method, setting| find(&trials, method, setting).energy.unwrap();
    assert!(brighter("ray tracing", 4.0) < -0.3);
    assert!(brighter("two passes", 0.05).abs() < 0.05);
    assert_eq!(find(&trials, "paths", 16.0).work.rays, 16 * 48 * 48);
}

/// More samples of a pixel follow its edges more closely, flat or smooth.
#[test]
fn more_samples_draw_finer() {
    let trials = pictures::drawn(64, &[1.0, 4.0], 16, &Bench::SILENT);
    for method in ["flat", "smooth"] {
        let [one, four] = [1.0, 4.0].map(|n| find(&trials, method, n));
        assert!(four.error < 0.5 * one.error, "{method}");
        assert_eq!(four.work.pixels, 16 * 64 * 64);
    }
}
