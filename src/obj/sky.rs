//! The sky of a scene: a comment line that [`load`](super::load) reads.
//!
//! ```text
//! # sky uniform r g b up x y z
//! # sky overcast r g b up x y z                                        of the zenith
//! # sky cie a b c d e sun x y z zenith r g b up x y z
//! # sky panorama up x y z file NAME.hdr
//! ```

use super::lines::numbers;
use crate::geometry::Rgb;
use crate::sky::{Kind, Panorama, Sky};
use glam::DVec3;
use std::io;
use std::path::Path;

/// The line for `sky`, whose panorama, if it is one, is in `file`.
pub(super) fn line(sky: &Sky, file: &str) -> String {
    let triple = |v: DVec3| format!("{} {} {}", v.x, v.y, v.z);
    let up = triple(sky.up());
    match sky.kind() {
        Kind::Uniform(l) => format!("# sky uniform {} up {up}", triple(l)),
        Kind::Overcast(zenith) => format!("# sky overcast {} up {up}", triple(zenith)),
        Kind::Cie { coefficients, sun, zenith } => {
            let coefficients = coefficients.map(|c| c.to_string()).join(" ");
            let (sun, zenith) = (triple(sun), triple(zenith));
            format!("# sky cie {coefficients} sun {sun} zenith {zenith} up {up}")
        }
        Kind::Panorama(_) => format!("# sky panorama up {up} file {file}"),
    }
}

/// Reads what stands after `# sky `; a panorama lies in `folder`. `None` when it is not
/// understood.
///
/// # Errors
/// A sentence, when the panorama cannot be read or is none.
pub(super) fn read(
    text: &str,
    folder: &Path,
    open: impl Fn(&Path) -> io::Result<Vec<u8>>,
) -> Result<Option<Sky>, String> {
    let Some(rest) = text.strip_prefix("panorama up ") else {
        return Ok(analytic(text));
    };
    let parts =
        rest.split_once(" file ").and_then(|(up, file)| Some((unit(up)?, file)));
    let Some((up, file)) = parts else { return Ok(None) };
    let path = folder.join(file.trim());
    let shown = path.display();
    let bytes = open(&path).map_err(|error| {
        let remedy = "put it there, or remove this line";
        format!("the sky `{shown}` cannot be read ({error}); {remedy}")
    })?;
    let panorama = Panorama::decode(&bytes);
    let panorama = panorama.map_err(|error| format!("the sky `{shown}` {error}"))?;
    Ok(Some(Sky::panorama(panorama, up)))
}

fn analytic(text: &str) -> Option<Sky> {
    let (sky, up) = text.split_once(" up ")?;
    let up = unit(up)?;
    let (kind, rest) = sky.split_once(' ')?;
    match kind {
        "uniform" => Some(Sky::uniform(radiance(rest)?, up)),
        "overcast" => Some(Sky::overcast(radiance(rest)?, up)),
        "cie" => {
            let (coefficients, rest) = rest.split_once(" sun ")?;
            let (sun, zenith) = rest.split_once(" zenith ")?;
            let coefficients: [f64; 5] = numbers(coefficients).ok()?.try_into().ok()?;
            let sun = unit(sun).filter(|sun| sun.dot(up) > 0.0)?;
            let zenith = radiance(zenith).filter(|_| coefficients[1] < 0.0)?;
            Some(Sky::cie(coefficients, sun, zenith, up))
        }
        _ => None,
    }
}

fn triple(text: &str) -> Option<DVec3> {
    let numbers: [f64; 3] = numbers(text).ok()?.try_into().ok()?;
    Some(DVec3::from_array(numbers))
}

fn radiance(text: &str) -> Option<Rgb> {
    triple(text).filter(|l| l.min_element() >= 0.0)
}

/// A direction; one of unit length stays as it is, to the last bit.
fn unit(text: &str) -> Option<DVec3> {
    let v = triple(text)?;
    if v.is_normalized() { Some(v) } else { v.try_normalize() }
}
