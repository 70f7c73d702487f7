//! The ways of making a picture, and what each tells besides it.
//!
//! | method     | pass 1 | rays from the eye | shows                                          |
//! |------------|--------|-------------------|------------------------------------------------|
//! | radiosity  | yes    | no                | diffuse light; what shines is black            |
//! | ray-trace  | no     | yes               | lamps, mirrors, glass; no diffuse interreflection |
//! | two-pass   | yes    | where it shines   | all light                                      |
//! | path-trace | no     | yes, by chance    | all light, and noise                           |

use super::output::{Refusal, Terminal};
use super::report::rgb;
use super::solve::{Way, solved};
use clap::ValueEnum;
use radiosity::film::{Picture, Shot, luminance};
use radiosity::geometry::Rgb;
use radiosity::room::Room;
use radiosity::scene::Scene;
use radiosity::sky::Sky;
use radiosity::solution::Solution;
use radiosity::trace::{ClassRow, Limits, Look, PathTracer, Table, TwoPass, Whitted};
use serde_json::{Value, json};

/// How light is followed.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum Method {
    /// Diffuse light between elements, drawn as it is; what shines is black
    Radiosity,
    /// Classical ray tracing: lamps, mirrors and glass, no light between diffuse surfaces
    RayTrace,
    /// Radiosity, then rays where something shines
    TwoPass,
    /// Random paths of all kinds: the reference, with its standard error
    PathTrace,
}

impl Method {
    /// The method that shows all light of `scene` at the least cost: a scene in which
    /// nothing shines needs no second pass.
    pub fn best_for(scene: &Scene) -> Method {
        let sky = scene.sky.as_ref().is_some_and(Sky::shines);
        if scene.shines() || sky { Method::TwoPass } else { Method::Radiosity }
    }

    /// Its name, as it is given.
    pub fn name(self) -> &'static str {
        match self {
            Method::Radiosity => "radiosity",
            Method::RayTrace => "ray-trace",
            Method::TwoPass => "two-pass",
            Method::PathTrace => "path-trace",
        }
    }

    /// Does it begin with pass 1?
    pub fn solves(self) -> bool {
        matches!(self, Method::Radiosity | Method::TwoPass)
    }

    /// Samples in a pixel where none are asked for: their mean, or their random paths.
    fn usual_samples(self) -> usize {
        if self == Method::PathTrace { 64 } else { 9 }
    }
}

/// More samples in a pixel are a slip of the keyboard.
const MOST_SAMPLES: usize = 1 << 16;

/// How many samples a pixel gets, if the number makes sense: evenly spread ones in rows
/// and columns, so a square.
pub fn samples(given: Option<usize>, method: Method) -> Result<usize, Refusal> {
    let asked = given.unwrap_or(method.usual_samples());
    if !(1..=MOST_SAMPLES).contains(&asked) {
        return Err(Refusal(format!(
            "--samples {asked} is not possible; choose 1 to {MOST_SAMPLES}"
        )));
    }
    Ok(match method {
        Method::PathTrace => asked.max(2), // or nothing could be said of the error
        _ => side(asked).pow(2),
    })
}

/// The side of the smallest square with so many cells.
pub fn side(samples: usize) -> usize {
    (1..).find(|side| side * side >= samples).unwrap_or(1)
}

/// Pass 1, and what was decided on the way, one line each.
pub type Solved = (Solution, Vec<String>);

/// A picture, and what is known of it.
pub struct Made {
    pub picture: Picture,
    /// How many rays were followed from the eye, where they were counted.
    pub rays: Option<u64>,
    /// The standard error of each pixel, where chance decided.
    pub error: Option<Vec<Rgb>>,
}

impl Made {
    /// A picture of which there is no more to say.
    pub fn of(picture: Picture) -> Made {
        Made { picture, rays: None, error: None }
    }
}

/// What is drawn of a scene, and how.
pub struct Shown {
    pub method: Method,
    pub shot: Shot,
    /// Samples in a pixel.
    pub samples: usize,
    pub seed: u64,
}

/// Makes the picture; `solution` is there if the method solves.
pub fn make(
    room: &Room,
    solution: Option<&Solution>,
    &Shown { method, ref shot, samples, seed }: &Shown,
    terminal: &Terminal,
) -> Made {
    let progress = |what: &'static str, done, all| terminal.progress(what, done, all);
    let shown = |shown: radiosity::trace::Shown| Made {
        picture: shown.picture,
        rays: Some(shown.rays),
        error: None,
    };
    match (method, solution) {
        (Method::TwoPass, Some(Solution { field, .. })) => {
            let options = Look { seed, ..Look::default() };
            let second = TwoPass::of(room, field, options);
            shown(second.picture(shot, &progress))
        }
        (_, Some(Solution { field, vertex_radiosity, .. })) => {
            terminal.progress("drawing", 0, 1);
            Made::of(shot.smooth(&field.mesh, vertex_radiosity))
        }
        (Method::PathTrace, None) => {
            let traced = PathTracer::of(room).picture(shot, samples, seed, &progress);
            Made { picture: traced.picture, rays: None, error: Some(traced.error) }
        }
        (_, None) => {
            shown(Whitted::of(room, Limits::default()).picture(shot, &progress))
        }
    }
}

/// Pass 1, if the method has one; else only checks that there is light.
pub fn first_pass(
    method: Method,
    room: &Room,
    way: &Way,
    terminal: &Terminal,
) -> Result<Option<Solved>, Refusal> {
    if method.solves() {
        return solved(room, way, terminal).map(Some);
    }
    super::solve::lit(room.scene)?;
    Ok(None)
}

/// Pixels along the longer side of the picture that is measured by class.
const CLASS_PIXELS: u32 = 64;

/// Paths through each of them.
const CLASS_PATHS: usize = 32;

/// Which light is whose: the mean radiance of a small version of the picture by classes of
/// paths, measured by random ones.
pub fn classes(scene: &Scene, &Shown { ref shot, seed, .. }: &Shown) -> Table {
    let scale = f64::from(CLASS_PIXELS) / f64::from(shot.width.max(shot.height));
    let small = |pixels: u32| ((f64::from(pixels) * scale) as u32).max(1);
    let (width, height) = (small(shot.width), small(shot.height));
    let shot = Shot { width, height, ..*shot };
    PathTracer::of(&Room::of(scene))
        .picture(&shot, CLASS_PATHS, seed, &|_, _, _| {})
        .classes
}

/// The table as `--json` has it: mean radiance over the picture, W/(m² sr).
pub fn classes_json(table: &Table) -> Value {
    let row = |row: ClassRow| {
        json!({
            "paths": row.class.word(), "what": row.class.name(),
            "owner": row.class.owner().name(),
            "mean": rgb(row.mean), "standard_error": rgb(row.error),
        })
    };
    table.rows().map(row).collect()
}

/// The same for people, channels as one luminance, classes without any light left out.
pub fn classes_text(table: &Table) -> String {
    let mut text = String::from("whose light it shows, mean radiance in W/(m² sr):\n");
    for ClassRow { class, mean, error } in
        table.rows().filter(|row| row.mean != Rgb::ZERO)
    {
        let (mean, error) = (luminance(mean), luminance(error));
        let (word, name, owner) = (class.word(), class.name(), class.owner().name());
        text += &format!("{word:<8}{mean:>10.4} ± {error:<10.4}{name}, {owner}\n");
    }
    text
}
