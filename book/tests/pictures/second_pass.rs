//! Pictures and numbers of the chapter *The second pass*, as snapshots and as claims.

use crate::picture::assert_picture;
use book::second_pass::{cost, depth, gloss, profile, views};
use radiosity::chart::suites::second_pass::{MIRROR, PLAIN};

const PICTURES: &str = "src/pictures";

#[test]
fn one_camera_three_ways_to_see() {
    assert_picture(PICTURES, "second-pass-classical", &views::classical());
    assert_picture(PICTURES, "second-pass-first", &views::first_pass());
    assert_picture(PICTURES, "second-pass-both", &views::both());
}

#[test]
fn a_ball_of_glass() {
    assert_picture(PICTURES, "second-pass-ball", &views::ball_picture());
}

#[test]
fn a_floor_under_three_lobes() {
    for (k, n) in gloss::EXPONENTS.into_iter().enumerate() {
        assert_picture(PICTURES, &format!("second-pass-gloss-{k}"), &gloss::picture(n));
    }
}

/// The law of the chapter: `k^(d+1)` of the whole is missing.
#[test]
fn a_cut_leaves_a_power_out() {
    for (r, d) in [(0.5_f64, 3), (0.9, 10), (0.99, 24)] {
        let all = 1.0 / (1.0 - r);
        let missing = 1.0 - depth::seen(r, d) / all;
        assert!((missing - r.powi(d as i32 + 1)).abs() < 1e-12, "{r} {d}: {missing}");
    }
}

/// One cone knows nothing of a lamp just outside of it; four stacked ones do.
#[test]
fn a_stack_has_no_edge() {
    let lobe = profile::share(&profile::stacked(4096), 10.0);
    let four = profile::share(&profile::stacked(4), 10.0);
    assert!((lobe - 0.04).abs() < 0.01, "{lobe}");
    assert!((four - lobe).abs() < 0.025, "{four} {lobe}");
}

/// The claim of the chapter and of the project, as measured.
#[test]
fn two_passes_beat_paths_by_ten_at_least() {
    for (scene, most) in [(MIRROR, 0.03), (PLAIN, 0.04)] {
        let (error, times) = cost::gain(scene);
        assert!(error <= most && times >= 10.0, "{scene}: {error} {times}");
    }
}
