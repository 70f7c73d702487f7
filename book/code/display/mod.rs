//! The figures and numbers of the chapter *The picture*.
//!
//! [`shots`] shows one solution in four ways, and what a pixel keeps; [`tears`] looks at
//! T-vertices, [`straight`] at interpolation in perspective, [`ramp`] at codes and light,
//! [`exposure`] at what white hides; [`cost`] says what was measured.

pub mod cost;
pub mod exposure;
pub mod ramp;
pub mod shots;
pub mod straight;
pub mod tears;

use radiosity::film::RgbImage;

/// Each pixel as a square of so many.
pub fn enlarged(picture: &RgbImage, times: u32) -> RgbImage {
    let (width, height) = (times * picture.width(), times * picture.height());
    RgbImage::from_fn(width, height, |x, y| *picture.get_pixel(x / times, y / times))
}

/// Path and text of the generated files of this chapter.
pub fn files() -> Vec<(String, String)> {
    vec![
        ("generated/picture-view.md".to_string(), shots::caption()),
        ("generated/picture-key.md".into(), shots::key()),
        ("generated/picture-holes.md".into(), tears::text()),
        ("generated/picture-ramp.md".into(), ramp::text()),
        ("generated/picture-exposure.md".into(), exposure::table()),
        ("generated/picture-cost.md".into(), cost::text()),
        ("generated/picture-ledger.md".into(), shots::ledger()),
    ]
}
