//! Exposure: what is shown, and what white hides.

use super::shots::smooth;
use crate::shooting::beside;
use radiosity::film::{Picture, RgbImage};
use std::fmt::Write;

/// Exposures, as multiples of the automatic one.
pub const TIMES: [f64; 3] = [0.25, 1.0, 4.0];

/// Of the light that comes to the eye, the share that a screen cannot show at this
/// exposure.
pub fn hidden(picture: &Picture, exposure: f64) -> f64 {
    let light = picture.pixels.iter().flat_map(|l| (exposure * l).to_array());
    let (mut all, mut above) = (0.0, 0.0);
    for v in light {
        all += v;
        above += (v - 1.0).max(0.0);
    }
    above / all
}

/// Dim, automatic, glaring.
pub fn picture() -> RgbImage {
    let picture = smooth();
    beside(&TIMES.map(|times| picture.display(times * picture.auto_exposure())))
}

/// What each of them hides.
pub fn table() -> String {
    let picture = smooth();
    let automatic = picture.auto_exposure();
    let mut text = String::from(
        "| exposure, 1/(W/(m² sr)) | pixels with a clamped channel | light that is not shown |\n\
         |---|---|---|\n",
    );
    for times in TIMES {
        let exposure = times * automatic;
        let _ = writeln!(
            text,
            "| {exposure:.2} | {:.1} % | {:.1} % |",
            100.0 * picture.clamped_share(exposure),
            100.0 * hidden(&picture, exposure),
        );
    }
    text
}
