//! `--sky`: what shines around a scene.

use super::output::{Refusal, Terminal};
use super::{Source, values};
use clap::Args;
use radiosity::geometry::Rgb;
use radiosity::glam::DVec3;
use radiosity::scene::Scene;
use radiosity::sky::{Panorama, Sky, cie_coefficients};
use std::path::PathBuf;

/// A scene, and the sky above it.
#[derive(Args, Clone)]
pub struct Lit {
    #[command(flatten)]
    pub source: Source,
    /// What shines around the scene, in W/(m² sr): uniform:R,G,B or overcast:ZENITH or
    /// clear:ZENITH,ELEVATION,AZIMUTH (of the sun, in degrees), above the horizon only;
    /// or a panorama, FILE.hdr
    #[arg(long, value_name = "SKY", value_parser = read)]
    sky: Option<Asked>,
    /// Opaque faces reflect on both sides, not on their front only
    #[arg(long)]
    two_sided: bool,
}

/// What `--sky` asks for.
#[derive(Clone, Debug, PartialEq)]
enum Asked {
    Uniform(Rgb),
    Overcast(f64),
    /// Radiance of the zenith; elevation and azimuth of the sun, in degrees.
    Clear(DVec3),
    File(PathBuf),
}

/// The clear sky of the CIE, with little haze.
const CLEAR: usize = 12;

fn read(text: &str) -> Result<Asked, String> {
    let number = |text: &str| text.trim().parse().map_err(|_| "give a number".into());
    if let Some(radiance) = text.strip_prefix("uniform:") {
        return values::vector(radiance).map(Asked::Uniform);
    }
    if let Some(zenith) = text.strip_prefix("overcast:") {
        return number(zenith).map(Asked::Overcast);
    }
    if let Some(numbers) = text.strip_prefix("clear:") {
        return values::vector(numbers).map(Asked::Clear);
    }
    let path = PathBuf::from(text);
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    if extension == "hdr" || extension == "exr" {
        return Ok(Asked::File(path));
    }
    Err("give uniform:R,G,B or overcast:ZENITH or clear:ZENITH,ELEVATION,AZIMUTH or the \
         path of an .hdr or .exr panorama"
        .into())
}

/// `radiance`, if a sky of this kind can have it.
fn possible(kind: &str, radiance: Rgb) -> Result<Rgb, Refusal> {
    if values::finite(kind, radiance)?.min_element() >= 0.0 {
        return Ok(radiance);
    }
    let Rgb { x, y, z } = radiance;
    Err(Refusal(format!(
        "{kind} {x},{y},{z} is not possible; give radiances of 0 or more"
    )))
}

impl Asked {
    fn sky(&self, up: DVec3) -> Result<Sky, Refusal> {
        Ok(match self {
            Asked::Uniform(radiance) => {
                Sky::uniform(possible("--sky uniform:", *radiance)?, up)
            }
            Asked::Overcast(zenith) => {
                Sky::overcast(possible("--sky overcast:", Rgb::splat(*zenith))?, up)
            }
            Asked::Clear(numbers) => {
                let DVec3 { x: zenith, y: elevation, z: azimuth } =
                    values::finite("--sky clear:", *numbers)?;
                let zenith = possible("--sky clear:", Rgb::splat(zenith))?;
                let sun = Sky::uniform(zenith, up)
                    .direction(elevation.to_radians(), azimuth.to_radians());
                let coefficients = cie_coefficients(CLEAR)
                    .filter(|_| elevation > 0.0 && elevation <= 90.0);
                let coefficients = coefficients.ok_or_else(|| {
                    Refusal(format!(
                        "--sky clear: has its sun at {elevation} degrees; give an elevation \
                         above 0 and up to 90"
                    ))
                })?;
                Sky::cie(coefficients, sun, zenith, up)
            }
            Asked::File(path) => Sky::panorama(Panorama::read(path)?, up),
        })
    }
}

impl Lit {
    /// A built-in scene in its own light.
    pub fn built_in(name: &str) -> Lit {
        let source = Source { scene: name.into(), up: None };
        Lit { source, sky: None, two_sided: false }
    }

    /// Reads the scene and its sky; the world's up is that of the camera.
    pub fn load(&self, terminal: &Terminal) -> Result<Scene, Refusal> {
        let mut scene = self.source.load(terminal)?;
        if self.two_sided {
            scene = scene.two_sided();
        }
        if let Some(asked) = &self.sky {
            let up = values::direction("--up", scene.camera.up)?;
            scene.sky = Some(asked.sky(up)?);
        }
        Ok(scene)
    }
}
