//! `radiosity render`: a solved scene as a camera sees it.

use super::methods::{self, Made, Method};
use super::output::{Refusal, Terminal, check_writable, extension, write};
use super::report;
use super::sky::Lit;
use super::solve::{FactorMethod, How, SolverMethod};
use super::values::{self, Size};
use clap::{Args, ValueEnum};
use radiosity::certificate::{Judged, Sampling, audit};
use radiosity::film::{FalseColour, Format, Picture, Shot, luminance, png};
use radiosity::geometry::Rgb;
use radiosity::glam::DVec3;
use radiosity::mesh::ElementId;
use radiosity::room::Room;
use radiosity::scene::{Camera, Scene};
use radiosity::solution::Solution;
use serde_json::json;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Draws a picture of a scene in its own light
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity render cornell -o cornell.png
  radiosity render room.obj -o room.exr --size 1920x1080 --eye 1,1.6,4 --target 2,1,0
  radiosity render l-room -o mesh.png --shading flat --view mesh --tolerance 5%
  radiosity render gallery -o gallery.png
  radiosity render room.obj -o room.png --sky overcast:30 --two-sided
  radiosity render cornell-mirror -o true.exr --method path-trace --samples 256
  radiosity render cornell -o lux.png --view false-color
  radiosity render cornell -o wrong.png --view error")]
pub struct Render {
    #[command(flatten)]
    source: Lit,
    /// Where to write: .png (sRGB), .hdr or .exr (linear radiance, W/(m² sr))
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// How light is followed [default: two-pass where something shines or a sky does,
    /// else radiosity]
    #[arg(long, value_enum)]
    method: Option<Method>,
    /// Samples in each pixel [default: 9; with path-trace 64]
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// One brightness for each element, or a smooth course between their corners
    #[arg(long, value_enum, default_value_t = Shading::Smooth)]
    shading: Shading,
    /// Width and height of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "512x512")]
    #[arg(value_parser = values::size)]
    size: Size,
    /// Where the eye is [default: what the scene says, or a place that shows it]
    #[arg(long, value_name = "X,Y,Z", value_parser = values::vector)]
    #[arg(allow_hyphen_values = true)]
    eye: Option<DVec3>,
    /// A point in the middle of the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = values::vector)]
    #[arg(allow_hyphen_values = true)]
    target: Option<DVec3>,
    /// Vertical field of view, in degrees
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    fov: Option<f64>,
    /// A factor on radiance, 1 being white then; auto: most of what is lit stays below
    #[arg(long, value_name = "auto|VALUE", default_value = "auto")]
    #[arg(value_parser = exposure, allow_negative_numbers = true)]
    exposure: Exposure,
    /// What is drawn
    #[arg(long, value_enum, default_value_t = What::Color)]
    view: What,
    /// The largest relative error of the field asked for, as 0.01 or 1%
    #[arg(long, default_value = "1%", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    tolerance: f64,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Shading {
    Flat,
    Smooth,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum What {
    /// As it looks
    Color,
    /// Luminance as colour, on a scale of two decades
    FalseColor,
    /// As it looks, with the outlines of the elements
    Mesh,
    /// How wrong each element is, relative to the reflected light, from 0.1 % to 10 %
    Error,
}

#[derive(Clone, Copy)]
enum Exposure {
    Auto,
    Value(f64),
}

fn exposure(text: &str) -> Result<Exposure, String> {
    match text {
        "auto" => Ok(Exposure::Auto),
        _ => text
            .parse()
            .map(Exposure::Value)
            .map_err(|_| "give auto or a number".into()),
    }
}

/// So many, so that the error of each can be told.
const POINTS_ON_AN_ELEMENT: usize = 4;

impl Render {
    /// The main job: the Cornell box, into `out/cornell.png`; makes the folder.
    pub fn cornell() -> Result<Render, Refusal> {
        let folder = Path::new("out");
        std::fs::create_dir_all(folder).map_err(|error| {
            Refusal(format!("the folder out cannot be made ({error}); go elsewhere"))
        })?;
        Ok(Render {
            source: Lit::built_in("cornell"),
            output: folder.join("cornell.png"),
            method: None,
            samples: None,
            shading: Shading::Smooth,
            size: Size { width: 512, height: 512 },
            eye: None,
            target: None,
            fov: None,
            exposure: Exposure::Auto,
            view: What::Color,
            tolerance: 0.01,
        })
    }

    /// Solves, draws and writes.
    pub fn run(&self, seed: u64, terminal: &Terminal) -> Result<(), Refusal> {
        let format = self.format()?;
        check_writable(&self.output)?;
        let (width, height) = self.size.checked()?;
        if let Exposure::Value(value) = self.exposure {
            values::positive("--exposure", value)?;
        }
        let how = How {
            levels: None,
            tolerance: self.tolerance,
            form_factors: FactorMethod::Auto,
            samples: None,
            method: SolverMethod::Auto,
        };
        let way = how.way(seed)?;
        if let Some(method) = self.method {
            methods::samples(self.samples, method)?;
        }
        let scene = self.source.load(terminal)?;
        let camera = self.camera(scene.camera)?;
        let method = self.method_for(&scene)?;
        let samples = methods::samples(self.samples, method)?;

        let start = Instant::now();
        let room = Room::of(&scene);
        let solved = methods::first_pass(method, &room, &way, terminal)?;
        let solution = solved.as_ref().map(|(solution, _)| solution);
        let side = methods::side(samples) as u32;
        let shot = Shot { camera, width, height, samples: side };
        let made = match (self.view, self.shading, solution) {
            (What::Error, _, Some(solution)) => Made {
                picture: self.errors(&shot, &room, solution, seed),
                rays: None,
                error: None,
            },
            (_, Shading::Flat, Some(solution)) => Made {
                picture: shot.flat(&solution.field.mesh, &solution.radiosity),
                rays: None,
                error: None,
            },
            _ => {
                methods::make(method, &room, solution, (&shot, samples), seed, terminal)
            }
        };
        let picture = &made.picture;
        let exposure = match self.exposure {
            Exposure::Auto => picture.auto_exposure(),
            Exposure::Value(value) => value,
        };
        let bytes = self.encoded(format, &shot, picture, exposure, solution)?;
        let seconds = start.elapsed().as_secs_f64();
        write(&self.output, &bytes)?;

        let noise = made.error.as_ref().map(|error| noise(picture, error));
        let clamped = picture.clamped_share(exposure);
        let mut text = match solution {
            Some(solution) => report::text(&scene, solution, self.tolerance, seconds),
            None => format!("{}: {seconds:.1} s\n", scene.name),
        };
        text += &format!(
            "picture: {}, {width}x{height}, {}, exposure {exposure:.4}, {} of the pixels \
             are clamped\n",
            self.output.display(),
            method.name(),
            report::percent(clamped)
        );
        if let Some(noise) = noise {
            let noise = report::percent(noise);
            text += &format!(
                "noise: pixels are off by about {noise} of the picture's mean (one \
                 standard error)\n"
            );
        }
        if self.view == What::Error {
            let FalseColour { low, high } = FalseColour::ERRORS;
            text += &format!(
                "colours: elements off by {} (dark) to {} (bright) of the reflected \
                 light\n",
                report::percent(low),
                report::percent(high)
            );
        }
        terminal.report(&text, || {
            let mut object = match &solved {
                Some((solution, plan)) => {
                    report::json_timed(solution, plan, self.tolerance, seconds)
                }
                None => json!({ "seconds": seconds }),
            };
            object["file"] = json!(self.output);
            object["method"] = json!(method.name());
            object["size"] = json!([width, height]);
            object["samples"] = json!(samples);
            object["exposure"] = json!(exposure);
            object["clamped"] = json!(clamped);
            object["rays"] = json!(made.rays);
            object["noise"] = json!(noise);
            let classes = methods::classes(&scene, &shot, seed);
            object["paths"] = methods::classes_json(&classes);
            object
        })
    }

    /// The method asked for, if it can show what is asked for; else the best.
    fn method_for(&self, scene: &Scene) -> Result<Method, Refusal> {
        let elements = self.view == What::Error || self.shading == Shading::Flat;
        let Some(method) = self.method else {
            let best = Method::best_for(scene);
            return Ok(if elements { Method::Radiosity } else { best });
        };
        let name = method.name();
        let refused = |option: &str, instead: &str| {
            Err(Refusal(format!(
                "{option} shows the elements of pass 1, which --method {name} does not; \
                 choose --method {instead}"
            )))
        };
        match (self.view, self.shading) {
            (What::Error, _) if method != Method::Radiosity => {
                refused("--view error", "radiosity")
            }
            (What::Mesh, _) if !method.solves() => {
                refused("--view mesh", "radiosity or two-pass")
            }
            (_, Shading::Flat) if method != Method::Radiosity => {
                refused("--shading flat", "radiosity")
            }
            _ => Ok(method),
        }
    }

    /// The format of the file, if it can hold what is asked for.
    fn format(&self) -> Result<Format, Refusal> {
        extension(&self.output, &["png", "hdr", "exr"])?;
        let format = Format::of(&self.output)?;
        if self.view != What::Color && format != Format::Png {
            return Err(Refusal(format!(
                "{} holds radiance, and this --view is a drawing; end it in .png",
                self.output.display()
            )));
        }
        Ok(format)
    }

    /// The camera of the scene with what the options change.
    fn camera(&self, of_scene: Camera) -> Result<Camera, Refusal> {
        let place = |option, given: Option<DVec3>, own| match given {
            Some(given) => values::finite(option, given),
            None => Ok(own),
        };
        let eye = place("--eye", self.eye, of_scene.eye)?;
        let target = place("--target", self.target, of_scene.target)?;
        let fov = self.fov.unwrap_or(of_scene.fov);
        if !(fov > 0.0 && fov < 180.0) {
            return Err(Refusal(format!(
                "--fov {fov} is not possible; give degrees between 0 and 180"
            )));
        }
        let forward = values::direction("--target minus --eye:", target - eye)?;
        let up = of_scene.up;
        if forward.cross(up).length() < 1e-9 * up.length() {
            let DVec3 { x, y, z } = up;
            return Err(Refusal(format!(
                "the eye looks straight along the world's up {x},{y},{z}; give another \
                 --up, --eye or --target"
            )));
        }
        Ok(Camera { eye, target, up, fov })
    }

    /// The error of what is shown, flat or smooth, in place of the light; each element
    /// has the error that was measured on it.
    fn errors(
        &self,
        shot: &Shot,
        room: &Room,
        solution: &Solution,
        seed: u64,
    ) -> Picture {
        let Solution { field, radiosity, vertex_radiosity, .. } = solution;
        let mesh = &field.mesh;
        let shown = |id: ElementId, x| match self.shading {
            Shading::Flat => radiosity[id.0 as usize],
            Shading::Smooth => mesh.value_at(mesh.element(id), x, vertex_radiosity),
        };
        let usual = Sampling { seed, ..Sampling::default() };
        let points = usual.points.max(POINTS_ON_AN_ELEMENT * mesh.elements.len());
        let judged = Judged { mesh, radiosity: &shown };
        let sampling = Sampling { points, ..usual };
        let (visibility, lamps) = (room.visibility(), room.lamps());
        let found = audit(room.scene, visibility, lamps, &judged, sampling);
        let shown: Vec<Rgb> = found.error.iter().map(|e| Rgb::splat(e * PI)).collect();
        shot.flat(mesh, &shown)
    }

    fn encoded(
        &self,
        format: Format,
        shot: &Shot,
        picture: &Picture,
        exposure: f64,
        solution: Option<&Solution>,
    ) -> Result<Vec<u8>, Refusal> {
        Ok(match self.view {
            What::Color => picture.encode(format, exposure)?,
            What::FalseColor => png(&FalseColour::of(picture).draw(picture))?,
            What::Error => png(&FalseColour::ERRORS.draw(picture))?,
            What::Mesh => {
                let picture = picture.display(exposure);
                match solution {
                    Some(solution) => {
                        png(&shot.with_mesh(picture, &solution.field.mesh))?
                    }
                    None => png(&picture)?,
                }
            }
        })
    }
}

/// The standard error of a pixel, root mean square, relative to the mean luminance.
fn noise(picture: &Picture, error: &[Rgb]) -> f64 {
    let mean = picture.pixels.iter().map(|l| luminance(*l)).sum::<f64>();
    let squares = error.iter().map(|e| luminance(*e).powi(2)).sum::<f64>();
    let pixels = error.len() as f64;
    (squares / pixels).sqrt() / (mean / pixels).max(f64::MIN_POSITIVE)
}
