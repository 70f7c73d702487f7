//! The values of options: how they are read, and which of them make sense.
//!
//! What is no number at all is refused while parsing (exit code 2); a number with which
//! nothing can be done is refused by its check (exit code 1).

use super::output::Refusal;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use radiosity::glam::DVec3;
use radiosity::raster::MAX_SIZE;
use radiosity::trace::PictureMethod;

/// Reads `0.01`, or `1%` for the same.
pub fn tolerance(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.strip_suffix('%') {
        Some(number) => (number, 0.01),
        None => (text, 1.0),
    };
    let number: Result<f64, _> = number.trim().parse();
    number.map(|x| x * unit).map_err(|_| "give a number, as 0.01 or 1%".into())
}

/// Reads `x,y,z`.
pub fn vector(text: &str) -> Result<DVec3, String> {
    let numbers: Result<Vec<f64>, _> =
        text.split(',').map(|x| x.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[x, y, z]) => Ok(DVec3::new(x, y, z)),
        _ => Err("give three numbers, as 0,1,0".into()),
    }
}

/// Width and height of a picture as they were asked for, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Pixels in a row; numbers that do not fit count as the largest that does.
    pub width: u64,
    /// Rows.
    pub height: u64,
}

/// Reads `512x512`.
pub fn size(text: &str) -> Result<Size, String> {
    let side = |digits: &str| {
        let number = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        number.then(|| digits.parse().unwrap_or(u64::MAX)) // only too many digits fail
    };
    let sides = text.split_once(['x', 'X']).map(|(w, h)| (side(w), side(h)));
    match sides {
        Some((Some(width), Some(height))) => Ok(Size { width, height }),
        _ => Err("give width and height in pixels, as 512x512".into()),
    }
}

/// The most pixels of a picture: 24 bytes each while it is computed, 1.5 GB in all.
const MOST_PIXELS: u64 = 1 << 26;

impl Size {
    /// The size, if a picture of it can be made.
    pub fn checked(self) -> Result<(u32, u32), Refusal> {
        let Size { width, height } = self;
        let fits = |side: u64| (1..=MAX_SIZE as u64).contains(&side);
        if fits(width) && fits(height) && width * height <= MOST_PIXELS {
            return Ok((width as u32, height as u32));
        }
        Err(Refusal(format!(
            "--size {width}x{height} is not possible; a picture has 1 to {MAX_SIZE} pixels \
             along each side and at most {MOST_PIXELS} in all"
        )))
    }
}

/// `value`, if it is positive and finite.
pub fn positive(option: &str, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(Refusal(format!("{option} {value} is not possible; give a positive number")))
}

/// `value`, if all of it is finite.
pub fn finite(option: &str, value: DVec3) -> Result<DVec3, Refusal> {
    if value.is_finite() {
        return Ok(value);
    }
    let DVec3 { x, y, z } = value;
    Err(Refusal(format!("{option} {x},{y},{z} is not possible; give finite numbers")))
}

/// The unit vector along `value`, if there is one.
pub fn direction(option: &str, value: DVec3) -> Result<DVec3, Refusal> {
    let DVec3 { x, y, z } = finite(option, value)?;
    value.try_normalize().ok_or_else(|| {
        Refusal(format!("{option} {x},{y},{z} has no direction; give another vector"))
    })
}

/// One of the ways of making a picture, by its name.
pub fn picture_method() -> impl TypedValueParser<Value = PictureMethod> {
    let possible = PictureMethod::ALL.map(|method| {
        let (name, words) = method.name_and_words();
        PossibleValue::new(name).help(words)
    });
    let named = |name: String| {
        let mut all = PictureMethod::ALL.into_iter();
        all.find(|method| method.name() == name).ok_or("no such method")
    };
    PossibleValuesParser::new(possible).try_map(named)
}
