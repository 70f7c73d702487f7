//! `radiosity render`: a solved scene as a camera sees it.

use super::methods::{self, Shown};
use super::output::{Refusal, Terminal, check_writable, extension, write};
use super::sky::Lit;
use super::solve::{FactorMethod, How, SolverMethod, Way};
use super::told::Told;
use super::values::{self, Size};
use clap::{Args, ValueEnum};
use radiosity::certificate::{Judged, Sampling, audit, irradiance_of};
use radiosity::film::{FalseColour, Format, Picture, Shot, png};
use radiosity::geometry::Rgb;
use radiosity::glam::DVec3;
use radiosity::mesh::ElementId;
use radiosity::room::Room;
use radiosity::scene::{Camera, Scene};
use radiosity::solution::Solution;
use radiosity::trace::{PictureMethod, Rendered};
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
  radiosity render cornell -o wrong.png --view error
  radiosity render mirror-room -o mirror.png --classes")]
pub struct Render {
    #[command(flatten)]
    source: Lit,
    /// Where to write: .png (sRGB), .hdr or .exr (linear radiance, W/(m² sr))
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// How light is followed [default: two-pass where something shines or a sky does,
    /// else radiosity]
    #[arg(long, value_parser = values::picture_method())]
    method: Option<PictureMethod>,
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
    pub view: What,
    /// The largest relative error of the field asked for, as 0.01 or 1%
    #[arg(long, default_value = "1%", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    pub tolerance: f64,
    /// Tell whose light the picture shows: its mean radiance by classes of paths, measured
    /// by random ones after the picture is written
    #[arg(long)]
    classes: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Shading {
    Flat,
    Smooth,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum What {
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
            classes: false,
        })
    }

    /// Solves, draws and writes.
    pub fn run(&self, seed: u64, terminal: &Terminal) -> Result<(), Refusal> {
        let format = self.format()?;
        let way = self.checked(seed)?;
        let scene = self.source.load(terminal)?;
        let shown = self.shown(&scene, seed)?;

        let start = Instant::now();
        let room = Room::of(&scene);
        let solved = methods::first_pass(shown.method, &room, &way, terminal)?;
        let solution = solved.as_ref().map(|(solution, _)| solution);
        let made = self.made(&room, solution, &shown, terminal);
        let exposure = match self.exposure {
            Exposure::Auto => made.picture.auto_exposure(),
            Exposure::Value(value) => value,
        };
        let mut told =
            Told { shown, solved, made, exposure, seconds: 0.0, classes: None };
        let bytes = self.encoded(format, &told)?;
        told.seconds = start.elapsed().as_secs_f64();
        write(&self.output, &bytes)?;
        told.classes = self.classes.then(|| methods::classes(&scene, &told.shown));
        terminal.report(&told.text(self, &scene), || told.json(self))
    }

    /// Refuses what can be refused before anything is read; else how pass 1 goes.
    fn checked(&self, seed: u64) -> Result<Way, Refusal> {
        check_writable(&self.output)?;
        self.size.checked()?;
        if let Exposure::Value(value) = self.exposure {
            values::positive("--exposure", value)?;
        }
        if let Some(method) = self.method {
            methods::samples(self.samples, method)?;
        }
        let how = How {
            levels: None,
            tolerance: self.tolerance,
            form_factors: FactorMethod::Auto,
            samples: None,
            method: SolverMethod::Auto,
        };
        how.way(seed)
    }

    /// What is to be drawn of `scene`, and how.
    fn shown(&self, scene: &Scene, seed: u64) -> Result<Shown, Refusal> {
        let camera = self.camera(scene.camera)?;
        let (width, height) = self.size.checked()?;
        let method = self.method_for(scene)?;
        let samples = methods::samples(self.samples, method)?;
        let side = methods::side(samples) as u32;
        let shot = Shot { camera, width, height, samples: side };
        Ok(Shown { method, shot, samples, seed })
    }

    /// The picture.
    fn made(
        &self,
        room: &Room,
        solution: Option<&Solution>,
        shown: &Shown,
        terminal: &Terminal,
    ) -> Rendered {
        match (self.view, self.shading, solution) {
            (What::Error, _, Some(solution)) => {
                Rendered::from(self.errors(shown, room, solution))
            }
            (_, Shading::Flat, Some(solution)) => Rendered::from(
                shown.shot.flat(&solution.field.mesh, &solution.radiosity),
            ),
            _ => methods::make(room, solution, shown, terminal),
        }
    }

    /// The method asked for, if it can show what is asked for; else the best.
    fn method_for(&self, scene: &Scene) -> Result<PictureMethod, Refusal> {
        let elements = self.view == What::Error || self.shading == Shading::Flat;
        let Some(method) = self.method else {
            let best = PictureMethod::best_for(scene);
            return Ok(if elements { PictureMethod::Radiosity } else { best });
        };
        let name = method.name();
        let refused = |option: &str, instead: &str| {
            Err(Refusal(format!(
                "{option} shows the elements of pass 1, which --method {name} does not; \
                 choose --method {instead}"
            )))
        };
        match (self.view, self.shading) {
            (What::Error, _) if method != PictureMethod::Radiosity => {
                refused("--view error", "radiosity")
            }
            (What::Mesh, _) if !method.solves() => {
                refused("--view mesh", "radiosity or two-pass")
            }
            (_, Shading::Flat) if method != PictureMethod::Radiosity => {
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
    fn errors(&self, shown: &Shown, room: &Room, solution: &Solution) -> Picture {
        let Solution { field, radiosity, vertex_radiosity, .. } = solution;
        let mesh = &field.mesh;
        let seen = |id: ElementId, x| match self.shading {
            Shading::Flat => radiosity[id.0 as usize],
            Shading::Smooth => mesh.value_at(mesh.element(id), x, vertex_radiosity),
        };
        let usual = Sampling { seed: shown.seed, ..Sampling::default() };
        let points = usual.points.max(POINTS_ON_AN_ELEMENT * mesh.elements.len());
        let irradiance = irradiance_of(room.scene, mesh, seen);
        let judged = Judged { mesh, irradiance: &irradiance };
        let sampling = Sampling { points, ..usual };
        let found = audit(room.scene, room.visibility(), &judged, sampling);
        let errors: Vec<Rgb> = found.error.iter().map(|e| Rgb::splat(e * PI)).collect();
        shown.shot.flat(mesh, &errors)
    }

    fn encoded(&self, format: Format, told: &Told) -> Result<Vec<u8>, Refusal> {
        let Told { made: Rendered { picture, .. }, shown, .. } = told;
        Ok(match self.view {
            What::Color => picture.encode(format, told.exposure)?,
            What::FalseColor => png(&FalseColour::of(picture).draw(picture))?,
            What::Error => png(&FalseColour::ERRORS.draw(picture))?,
            What::Mesh => {
                let picture = picture.display(told.exposure);
                match &told.solved {
                    Some((Solution { field, .. }, _)) => {
                        png(&shown.shot.with_mesh(picture, &field.mesh))?
                    }
                    None => png(&picture)?,
                }
            }
        })
    }
}
