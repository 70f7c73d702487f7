//! Panoramas as files.

use super::panorama::MOST_TEXELS;
use super::{Panorama, PanoramaError};
use crate::geometry::Rgb;
use image::codecs::hdr::{HdrDecoder, HdrEncoder};
use image::codecs::openexr::OpenExrDecoder;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, ImageResult};
use std::fmt;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// Why a file is no sky.
#[derive(Debug)]
#[non_exhaustive]
pub struct SkyError {
    /// The file.
    pub path: PathBuf,
    /// What is the matter with it.
    pub reason: SkyTrouble,
}

/// What can be the matter with a file.
#[derive(Debug)]
#[non_exhaustive]
pub enum SkyTrouble {
    /// It cannot be read.
    File(std::io::Error),
    /// It is no picture, or one of 8 bits to a channel, or broken.
    Picture(Option<image::ImageError>),
    /// It is a picture, but no panorama.
    Panorama(PanoramaError),
}

impl fmt::Display for SkyError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "the sky `{}` {}", self.path.display(), self.reason)
    }
}

impl fmt::Display for SkyTrouble {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            SkyTrouble::File(error) => write!(f, "cannot be read: {error}"),
            SkyTrouble::Picture(None) => {
                f.write_str("holds no radiance; give a .hdr or .exr picture")
            }
            SkyTrouble::Picture(Some(error)) => {
                write!(f, "cannot be decoded: {error}; give a .hdr or .exr picture")
            }
            SkyTrouble::Panorama(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SkyError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.reason)
    }
}

impl std::error::Error for SkyTrouble {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            SkyTrouble::File(error) => Some(error),
            SkyTrouble::Picture(error) => error.as_ref().map(|error| error as _),
            SkyTrouble::Panorama(error) => Some(error),
        }
    }
}

impl From<std::io::Error> for SkyTrouble {
    fn from(error: std::io::Error) -> SkyTrouble {
        SkyTrouble::File(error)
    }
}

impl From<image::ImageError> for SkyTrouble {
    fn from(error: image::ImageError) -> SkyTrouble {
        SkyTrouble::Picture(Some(error))
    }
}

impl From<PanoramaError> for SkyTrouble {
    fn from(error: PanoramaError) -> SkyTrouble {
        SkyTrouble::Panorama(error)
    }
}

impl Panorama {
    /// Reads a picture of all directions: Radiance `.hdr` (its `EXPOSURE` divided out)
    /// or OpenEXR, told apart by their content.
    ///
    /// # Errors
    /// The file is missing, no such picture, broken, too large, or has a texel that is
    /// negative, infinite or no number.
    pub fn read(path: &Path) -> Result<Panorama, SkyError> {
        let bytes = std::fs::read(path).map_err(SkyTrouble::File);
        let panorama = bytes.and_then(|bytes| Panorama::decode(&bytes));
        panorama.map_err(|reason| SkyError { path: path.to_owned(), reason })
    }

    /// As [`Panorama::read`], of the bytes of such a file.
    ///
    /// # Errors
    /// Those of [`Panorama::read`], but for the missing file.
    pub fn decode(bytes: &[u8]) -> Result<Panorama, SkyTrouble> {
        let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format()?;
        match reader.format() {
            Some(ImageFormat::Hdr) => {
                let decoder = HdrDecoder::new(reader.into_inner())?;
                let exposure = decoder.metadata().exposure.unwrap_or(1.0);
                decoded(decoder, f64::from(exposure))
            }
            Some(ImageFormat::OpenExr) => {
                decoded(OpenExrDecoder::new(reader.into_inner())?, 1.0)
            }
            _ => Err(SkyTrouble::Picture(None)),
        }
    }

    /// The bytes of a Radiance `.hdr` file: a shared exponent, steps of 1 % at worst.
    ///
    /// # Errors
    /// None that is known of; they would be the encoder's.
    pub fn encode(&self) -> ImageResult<Vec<u8>> {
        let mut bytes = Vec::new();
        let pixel = |l: &Rgb| image::Rgb(l.as_vec3().to_array());
        let pixels: Vec<_> = self.texels().iter().map(pixel).collect();
        HdrEncoder::new(&mut bytes).encode(&pixels, self.width(), self.height())?;
        Ok(bytes)
    }
}

fn decoded(decoder: impl ImageDecoder, exposure: f64) -> Result<Panorama, SkyTrouble> {
    let (width, height) = decoder.dimensions();
    let (width, height) = (width as usize, height as usize);
    // Asked before anything is allocated: a header is easily wrong.
    if width.saturating_mul(height) > MOST_TEXELS {
        return Err(PanoramaError::TooLarge { width, height }.into());
    }
    let picture = DynamicImage::from_decoder(decoder)?.into_rgb32f();
    let texel = |p: &image::Rgb<f32>| Rgb::from_array(p.0.map(f64::from)) / exposure;
    Ok(Panorama::new(width, picture.pixels().map(texel).collect())?)
}
