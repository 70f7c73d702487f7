//! Textures: pictures of reflectances, and what a patch needs to know of them.
//!
//! ```text
//! v = s/12.92              s ≤ 0.04045         s: an sRGB code value, in [0, 1]
//! v = ((s + 0.055)/1.055)^2.4      above       v: the reflectance that it stands for
//! ρ = Kd · mean(v)         not v(mean(s)), and not mean(s)
//! ```
//! Light is exchanged between patches, each of one reflectance: the mean of its texture.
//! Reflectances are averaged, not codes, or a chequered floor comes out too dark by half.
//!
//! | reads    | use it when                        | it fails when                       |
//! |----------|------------------------------------|-------------------------------------|
//! | [`mean`] | light is exchanged between patches | the pattern is to be seen           |
//!
//! ```
//! use radiosity::film::{Format, Picture};
//! use radiosity::{geometry::Rgb, texture};
//! let mut picture = Picture::new(2, 1); // black, and white
//! picture.pixels[1] = Rgb::ONE;
//! let file = picture.encode(Format::Png, 1.0).unwrap();
//! assert_eq!(texture::mean(&file).unwrap(), Rgb::splat(0.5)); // of light, not of codes
//! assert!((texture::linear_from_srgb(188.0 / 255.0) - 0.503).abs() < 1e-3);
//! ```
//!
//! **Not here:** the pattern itself, and where on a face it lies; pictures that are
//! written ([`crate::film`]). Chapter *The pipeline*, for the virtual world (L23). Sources: Cohen et al. 1986
//! (textures after the solution); IEC 61966-2-1 (sRGB).

use crate::geometry::Rgb;
use image::{DynamicImage, ImageFormat, ImageReader};
use std::fmt;
use std::io::Cursor;

/// Why some bytes are no texture.
#[derive(Debug)]
#[non_exhaustive]
pub enum TextureError {
    /// They are no picture of a kind that is read.
    Format,
    /// They are, but broken or far too large.
    Picture(image::ImageError),
    /// A value is negative, infinite or no number.
    Value,
}

impl fmt::Display for TextureError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            TextureError::Format => {
                f.write_str("is no picture of a known kind; convert it to .png")
            }
            TextureError::Picture(error) => {
                write!(f, "cannot be decoded ({error}); convert it to .png anew")
            }
            TextureError::Value => f.write_str(
                "holds values that are negative or not finite; convert it to .png",
            ),
        }
    }
}

impl std::error::Error for TextureError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            TextureError::Picture(error) => Some(error),
            TextureError::Format | TextureError::Value => None,
        }
    }
}

// ANCHOR: mean
/// The mean over a picture, in linear light: each channel ≥ 0, of PNG files ≤ 1.
///
/// `bytes` are those of a PNG file, whose codes are taken as sRGB, or of a Radiance `.hdr`
/// or OpenEXR file, which hold linear light. Transparency is ignored.
///
/// # Errors
/// See [`TextureError`].
pub fn mean(bytes: &[u8]) -> Result<Rgb, TextureError> {
    let (picture, linear) = decoded(bytes)?;
    let light = |code: f32| match linear {
        true => f64::from(code),
        false => linear_from_srgb(f64::from(code)),
    };
    let picture = picture.into_rgb32f();
    let sum: Rgb = picture.pixels().map(|p| Rgb::from_array(p.0.map(light))).sum();
    let mean = sum / f64::from(picture.width()) / f64::from(picture.height());
    // ANCHOR_END: mean
    match mean.is_finite() && mean.min_element() >= 0.0 {
        true => Ok(mean),
        false => Err(TextureError::Value),
    }
}

/// The picture, and whether it holds linear light.
fn decoded(bytes: &[u8]) -> Result<(DynamicImage, bool), TextureError> {
    let reader = ImageReader::new(Cursor::new(bytes));
    let reader = reader.with_guessed_format().map_err(|_| TextureError::Format)?;
    let linear = match reader.format() {
        Some(ImageFormat::Png) => false,
        Some(ImageFormat::Hdr | ImageFormat::OpenExr) => true,
        _ => return Err(TextureError::Format),
    };
    Ok((reader.decode().map_err(TextureError::Picture)?, linear))
}

/// The linear value, in `[0, 1]`, of an sRGB code value in `[0, 1]` (IEC 61966-2-1).
pub fn linear_from_srgb(v: f64) -> f64 {
    if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}
