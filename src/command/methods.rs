//! How pictures are made: samples, pass 1, and whose light they show.

use super::output::{Refusal, Terminal};
use super::report::rgb;
use super::solve::{Way, solved};
use radiosity::film::{Shot, luminance};
use radiosity::geometry::Rgb;
use radiosity::room::Room;
use radiosity::scene::Scene;
use radiosity::solution::Solution;
use radiosity::trace::{ClassRow, Drawing, PathTracer, PictureMethod, Rendered, Table};
use serde_json::{Value, json};

/// More samples in a pixel are a slip of the keyboard.
const MOST_SAMPLES: usize = 1 << 16;

/// How many samples a pixel gets, if the number makes sense: evenly spread ones in rows
/// and columns, so a square.
pub fn samples(given: Option<usize>, method: PictureMethod) -> Result<usize, Refusal> {
    // Where none are asked for: their mean, or their random paths.
    let usual = if method == PictureMethod::PathTrace { 64 } else { 9 };
    let asked = given.unwrap_or(usual);
    if !(1..=MOST_SAMPLES).contains(&asked) {
        return Err(Refusal(format!(
            "--samples {asked} is not possible; choose 1 to {MOST_SAMPLES}"
        )));
    }
    Ok(match method {
        PictureMethod::PathTrace => asked.max(2), // or nothing could be said of the error
        _ => side(asked).pow(2),
    })
}

/// The side of the smallest square with so many cells.
pub fn side(samples: usize) -> usize {
    (1..).find(|side| side * side >= samples).unwrap_or(1)
}

/// Pass 1, and what was decided on the way, one line each.
pub type Solved = (Solution, Vec<String>);

/// What is drawn of a scene, and how.
pub struct Shown {
    pub method: PictureMethod,
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
) -> Rendered {
    let progress = |what: &'static str, done, all| terminal.progress(what, done, all);
    if method != PictureMethod::PathTrace {
        let drawing = Drawing { shot, seed, progress: &progress };
        return method.draw(room, solution, &drawing);
    }
    // As many paths as were asked for, a square or not.
    let traced = PathTracer::of(room).picture(shot, samples, seed, &progress);
    Rendered { picture: traced.picture, rays: None, error: Some(traced.error) }
}

/// Pass 1, if the method has one; else only checks that there is light.
pub fn first_pass(
    method: PictureMethod,
    room: &Room,
    way: &Way,
    terminal: &Terminal,
) -> Result<Option<Solved>, Refusal> {
    if let Some(words) = method.leaves_out(room.scene) {
        terminal.warn(words);
    }
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
