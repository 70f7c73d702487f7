//! From radiance to a picture: exposure, sRGB, false colour, drawings, comparison.
//!
//! ```text
//! L = B/π                       what a diffuse surface of radiosity B shows, W/(m² sr)
//! v = exposure · L              1 is white; what exceeds it is clamped, and counted
//! byte = round(255 sRGB(v))     sRGB: IEC 61966-2-1, about v^(1/2.2)
//! ```
//!
//! | step                       | use it when                | it misleads when       |
//! |----------------------------|----------------------------|------------------------|
//! | [`Shot::flat`]             | the solution is to be seen | taken for a photo      |
//! | [`Shot::smooth`]           | it should look pleasing    | elements are large     |
//! | [`FalseColour`]            | numbers are to be read off | seen without its scale |
//! | [`Picture::auto_exposure`] | one picture is looked at   | two are compared       |
//! | [`compare`]                | two pictures should agree  | they were clamped      |
//!
//! All averaging is done on linear radiance; only the last step to bytes is not linear.
//!
//! ```
//! use radiosity::film::{Picture, srgb_from_linear};
//! use radiosity::geometry::Rgb;
//! let mut picture = Picture::new(2, 1);
//! picture.pixels.copy_from_slice(&[Rgb::splat(0.5), Rgb::splat(3.0)]);
//! assert_eq!(picture.display(1.0).get_pixel(0, 0).0, [188; 3]); // half the light, not 128
//! assert_eq!(picture.clamped_share(1.0), 0.5); // the other is brighter than white
//! assert!((srgb_from_linear(0.5) - 0.735).abs() < 1e-3);
//! ```
//!
//! **Not here:** tone curves: what is brighter than white is white, and the share of
//! such pixels is reported. Chapter *The picture* (L09). Sources: IEC
//! 61966-2-1:1999; Poynton 2003.

mod compare;
mod draw;
mod false_colour;
mod file;
mod view;

pub use crate::texture::linear_from_srgb;
pub use compare::{Difference, compare, side_by_side};
pub use draw::{colour_of_id, hemicube_cross};
pub use false_colour::{FalseColour, luminance};
pub use file::{FilmError, Format, png, write_atomically, write_atomically_by};
pub use image::RgbImage;
pub use view::Shot;

use crate::geometry::Rgb;

/// A picture of linear radiance.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Radiance in W/(m² sr), row by row from the top, each from the left.
    pub pixels: Vec<Rgb>,
}

impl Picture {
    /// The share of lit pixels that [`Picture::auto_exposure`] leaves below white.
    const BELOW_WHITE: f64 = 0.97;

    /// A black picture.
    pub fn new(width: u32, height: u32) -> Picture {
        let pixels = vec![Rgb::ZERO; width as usize * height as usize];
        Picture { width, height, pixels }
    }

    /// The factor that makes the brightest channel of 97 % of the lit pixels at most 1.
    ///
    /// In 1/(W/(m² sr)), positive. A lamp in the picture covers a few per cent at most
    /// and may clamp; what it lights may not. 1 for a black picture.
    // ANCHOR: auto_exposure
    pub fn auto_exposure(&self) -> f64 {
        let brightest = self.pixels.iter().map(|l| l.max_element());
        let mut lit: Vec<f64> =
            brightest.filter(|l| *l > 0.0 && l.is_finite()).collect();
        if lit.is_empty() {
            return 1.0;
        }
        let rank = ((lit.len() - 1) as f64 * Picture::BELOW_WHITE) as usize;
        1.0 / *lit.select_nth_unstable_by(rank, f64::total_cmp).1
    }
    // ANCHOR_END: auto_exposure

    /// The share of pixels, in `[0, 1]`, that have a channel above white.
    pub fn clamped_share(&self, exposure: f64) -> f64 {
        let clamped = |l: &&Rgb| l.max_element() * exposure > 1.0 + 1e-9;
        self.pixels.iter().filter(clamped).count() as f64
            / self.pixels.len().max(1) as f64
    }

    /// The picture in 8-bit sRGB; what exceeds `1/exposure` is clamped.
    pub fn display(&self, exposure: f64) -> RgbImage {
        self.map(|radiance| (radiance * exposure).to_array().map(byte))
    }

    /// An 8-bit picture whose pixels are `colour` of this one's.
    pub fn map(&self, colour: impl Fn(Rgb) -> [u8; 3]) -> RgbImage {
        RgbImage::from_fn(self.width, self.height, |x, y| {
            let pixel = y as usize * self.width as usize + x as usize;
            image::Rgb(colour(self.pixels[pixel]))
        })
    }
}

// ANCHOR: srgb
/// The sRGB code value, in `[0, 1]`, of a linear one in `[0, 1]` (IEC 61966-2-1).
pub fn srgb_from_linear(v: f64) -> f64 {
    if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}
// ANCHOR_END: srgb

/// The 8-bit sRGB code of a linear value; below 0 is black, above 1 white.
pub fn byte(v: f64) -> u8 {
    (255.0 * srgb_from_linear(v.clamp(0.0, 1.0)) + 0.5) as u8
}
