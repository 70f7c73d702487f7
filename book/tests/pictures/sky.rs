//! Pictures of the chapter *Light from the sky*, as snapshots.

use crate::picture::assert_picture;
use book::sky::{court, shadow, skies};

const PICTURES: &str = "src/pictures";

/// One court, one exposure, three skies that bring the same light to open ground.
#[test]
fn a_court_under_three_skies() {
    for kind in skies::Kind::ALL {
        let ground = kind.sky().irradiance(glam::DVec3::Y);
        assert!((ground.element_sum() / 300.0 - 1.0).abs() < 0.1, "{kind:?}: {ground}");
    }
    for (k, kind) in skies::Kind::ALL.into_iter().enumerate() {
        assert_picture(PICTURES, &format!("sky-court-{k}"), &court::picture(kind));
    }
    assert_picture(PICTURES, "sky-panorama", &skies::picture());
}

/// The sun is missed by even directions, or met and far too strong.
#[test]
fn a_sun_found_by_chance() {
    for (k, draw) in shadow::Draw::ALL.into_iter().enumerate() {
        assert_picture(PICTURES, &format!("sky-shadow-{k}"), &shadow::picture(draw));
    }
}
