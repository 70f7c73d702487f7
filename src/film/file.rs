//! Pictures as bytes, and bytes as files.

use super::Picture;
use image::{ExtendedColorType, ImageEncoder, RgbImage};
use std::ffi::OsString;
use std::io::{self, Cursor, Write};
use std::path::{Path, PathBuf};
use std::{fmt, fs};

/// A kind of picture file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8-bit sRGB, to look at.
    Png,
    /// Linear radiance with a shared exponent (Ward 1991): 1 % steps at worst.
    Hdr,
    /// Linear radiance as `f32` (OpenEXR).
    Exr,
}

/// Why there is no picture file.
#[derive(Debug)]
#[non_exhaustive]
pub enum FilmError {
    /// The file's name ends in none of `.png`, `.hdr`, `.exr`.
    UnknownFormat(PathBuf),
    /// The encoder refused the picture.
    Encoding(image::ImageError),
}

impl fmt::Display for FilmError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            FilmError::UnknownFormat(path) => write!(
                f,
                "no picture can be written to `{}`; end its name in .png, .hdr or .exr",
                path.display()
            ),
            FilmError::Encoding(error) => {
                write!(f, "cannot encode the picture: {error}")
            }
        }
    }
}

impl std::error::Error for FilmError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            FilmError::UnknownFormat(_) => None,
            FilmError::Encoding(error) => Some(error),
        }
    }
}

impl From<image::ImageError> for FilmError {
    fn from(error: image::ImageError) -> FilmError {
        FilmError::Encoding(error)
    }
}

impl Format {
    /// The format that the extension of `path` asks for, in any case.
    ///
    /// # Errors
    /// When it is none of ours.
    pub fn of(path: &Path) -> Result<Format, FilmError> {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        match extension.to_ascii_lowercase().as_str() {
            "png" => Ok(Format::Png),
            "hdr" => Ok(Format::Hdr),
            "exr" => Ok(Format::Exr),
            _ => Err(FilmError::UnknownFormat(path.to_owned())),
        }
    }
}

impl Picture {
    /// The bytes of a picture file. `exposure` is for PNG; `.hdr` and `.exr` hold the
    /// radiance itself, in W/(m² sr).
    ///
    /// # Errors
    /// When the encoder refuses the picture: it has no pixels.
    pub fn encode(&self, format: Format, exposure: f64) -> Result<Vec<u8>, FilmError> {
        let pixels = self.pixels.iter().map(|l| l.as_vec3().to_array());
        let mut bytes = Cursor::new(Vec::new());
        match format {
            Format::Png => return png(&self.display(exposure)),
            Format::Hdr => image::codecs::hdr::HdrEncoder::new(&mut bytes).encode(
                &pixels.map(image::Rgb).collect::<Vec<_>>(),
                self.width as usize,
                self.height as usize,
            )?,
            Format::Exr => {
                let raw: Vec<u8> = pixels
                    .flatten()
                    .flat_map(|channel| channel.to_ne_bytes())
                    .collect();
                image::codecs::openexr::OpenExrEncoder::new(&mut bytes).write_image(
                    &raw,
                    self.width,
                    self.height,
                    ExtendedColorType::Rgb32F,
                )?;
            }
        }
        Ok(bytes.into_inner())
    }
}

/// The bytes of a PNG file.
///
/// # Errors
/// When the encoder refuses the picture: it has no pixels.
pub fn png(picture: &RgbImage) -> Result<Vec<u8>, FilmError> {
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes).write_image(
        picture.as_raw(),
        picture.width(),
        picture.height(),
        ExtendedColorType::Rgb8,
    )?;
    Ok(bytes)
}

/// Writes a file under a temporary name beside it, then renames it: whoever looks finds
/// the old file or the new one, never half of it.
///
/// # Errors
/// Those of the file system; nothing is left behind then.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_atomically_by(path, |file| file.write_all(bytes))
}

/// [`write_atomically`] of what `write` writes, piece by piece.
///
/// # Errors
/// Those of the file system and of `write`; nothing is left behind then.
pub fn write_atomically_by(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let name = path.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(hidden);
    let all = || {
        let mut file = io::BufWriter::new(fs::File::create(&temporary)?);
        write(&mut file)?;
        file.into_inner()?.sync_all()?;
        fs::rename(&temporary, path)
    };
    let written = all();
    if written.is_err() {
        // The first error is the one to report; there may be nothing to remove.
        let _ = fs::remove_file(&temporary);
    }
    written
}
