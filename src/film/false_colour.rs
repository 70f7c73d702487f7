//! Luminance as colour, for reading off numbers.

use super::Picture;
use crate::geometry::Rgb;
use image::RgbImage;

/// Ten stops of *viridis* (van der Walt & Smith 2015, CC0), in sRGB bytes: its
/// lightness rises evenly, so that it survives colour blindness and grey printers.
const VIRIDIS: [[u8; 3]; 10] = [
    [68, 1, 84],
    [72, 40, 120],
    [62, 74, 137],
    [49, 104, 142],
    [38, 130, 142],
    [31, 158, 137],
    [53, 183, 121],
    [109, 205, 89],
    [180, 222, 44],
    [253, 231, 37],
];

/// A scale from numbers to colours: equal steps of colour are equal ratios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FalseColour {
    /// The positive number that is shown darkest, as is all below it.
    pub low: f64,
    /// The number that is shown brightest, as is all above it; more than `low`.
    pub high: f64,
}

/// The luminance, in W/(m² sr), of a radiance in linear sRGB primaries (Rec. 709).
pub fn luminance(radiance: Rgb) -> f64 {
    radiance.dot(Rgb::new(0.2126, 0.7152, 0.0722))
}

impl FalseColour {
    /// For relative errors: from 0.1 % to 10 %, so that pictures can be compared.
    pub const ERRORS: FalseColour = FalseColour { low: 1e-3, high: 1e-1 };

    /// Two decades that end where `picture` turns white at its automatic exposure.
    pub fn of(picture: &Picture) -> FalseColour {
        let high = 1.0 / picture.auto_exposure();
        FalseColour { low: 0.01 * high, high }
    }

    /// The colour of a number, in sRGB bytes.
    pub fn colour(&self, value: f64) -> [u8; 3] {
        let t = (value.max(self.low) / self.low).ln() / (self.high / self.low).ln();
        let place = t.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
        let below = (place as usize).min(VIRIDIS.len() - 2);
        let (a, b) = (VIRIDIS[below], VIRIDIS[below + 1]);
        let mix = |k: usize| {
            let (a, b) = (f64::from(a[k]), f64::from(b[k]));
            (a + (b - a) * (place - below as f64) + 0.5) as u8
        };
        [mix(0), mix(1), mix(2)]
    }

    /// The luminance of `picture` in colours.
    pub fn draw(&self, picture: &Picture) -> RgbImage {
        picture.map(|radiance| self.colour(luminance(radiance)))
    }

    /// The numbers to write beside the picture: `steps` of them (at least 2) from low
    /// to high, each with its colour.
    pub fn legend(&self, steps: usize) -> Vec<(f64, [u8; 3])> {
        let value = |k: usize| {
            let t = k as f64 / (steps.max(2) - 1) as f64;
            self.low * (self.high / self.low).powf(t)
        };
        (0..steps.max(2)).map(|k| (value(k), self.colour(value(k)))).collect()
    }
}
