//! Are two 8-bit pictures the same, and if not, where?

use image::RgbImage;
use std::fmt;

/// How two pictures of one size differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// How many pixels they have.
    pub pixels: usize,
    /// What difference of a channel was let pass, in steps of 1/255.
    pub step: u8,
    /// How many pixels have a channel that differs by more.
    pub off: usize,
    /// The largest difference of a channel, in steps of 1/255.
    pub worst: u8,
    /// Column and row of the first pixel that differs so.
    pub at: (u32, u32),
    /// The mean difference of all channels, in steps of 1/255.
    pub mean: f64,
}

impl Difference {
    /// The share of pixels that are off, in `[0, 1]`.
    pub fn share(&self) -> f64 {
        self.off as f64 / self.pixels.max(1) as f64
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "{} of {} pixels ({:.2} %) differ by more than {}/255; \
             worst {} at ({}, {})",
            self.off,
            self.pixels,
            100.0 * self.share(),
            self.step,
            self.worst,
            self.at.0,
            self.at.1
        )
    }
}

/// Compares two pictures; `None` when their sizes differ.
pub fn compare(old: &RgbImage, new: &RgbImage, step: u8) -> Option<Difference> {
    if old.dimensions() != new.dimensions() {
        return None;
    }
    let pixels = old.width() as usize * old.height() as usize;
    let mut found =
        Difference { pixels, step, off: 0, worst: 0, at: (0, 0), mean: 0.0 };
    let mut sum = 0;
    for ((x, y, a), b) in old.enumerate_pixels().zip(new.pixels()) {
        let apart = [0, 1, 2].map(|k| a[k].abs_diff(b[k]));
        let most = apart.into_iter().max().unwrap_or(0);
        sum += apart.into_iter().map(u64::from).sum::<u64>();
        found.off += usize::from(most > step);
        if most > found.worst {
            (found.worst, found.at) = (most, (x, y));
        }
    }
    found.mean = sum as f64 / (3 * pixels).max(1) as f64;
    Some(found)
}

/// One picture that shows old, new and their difference (eight times enlarged in
/// value).
pub fn side_by_side(old: &RgbImage, new: &RgbImage) -> RgbImage {
    let (width, height) =
        (old.width().max(new.width()), old.height().max(new.height()));
    let gap = 4;
    RgbImage::from_fn(3 * width + 2 * gap, height, |x, y| {
        let (panel, x) = (x / (width + gap), x % (width + gap));
        let (a, b) = (old.get_pixel_checked(x, y), new.get_pixel_checked(x, y));
        let grey = image::Rgb([128; 3]);
        match (panel, a, b) {
            (0, Some(pixel), _) | (1, _, Some(pixel)) => *pixel,
            (2, Some(a), Some(b)) => {
                image::Rgb([0, 1, 2].map(|k| a[k].abs_diff(b[k]).saturating_mul(8)))
            }
            _ => grey,
        }
    })
}
