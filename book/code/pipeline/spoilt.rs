//! One stage spoilt at a time, the others good: no later stage repairs it.

use radiosity::film::{Picture, RgbImage, Shot};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::{Enclosure, Jacobi, Solver};
use std::sync::OnceLock;

/// Which stage is spoilt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stage {
    /// None.
    None,
    /// Elements six times as wide.
    Split,
    /// Hemicubes of 16.
    Factors,
    /// Two bounces.
    Solve,
}

impl Stage {
    /// All of them.
    pub const ALL: [Stage; 4] =
        [Stage::None, Stage::Split, Stage::Factors, Stage::Solve];

    /// Its part of a file's name.
    pub fn file(self) -> &'static str {
        match self {
            Stage::None => "none",
            Stage::Split => "split",
            Stage::Factors => "factors",
            Stage::Solve => "solve",
        }
    }
}

/// The picture of the Cornell box that comes out, in radiances.
fn render(stage: Stage) -> Picture {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let edge = if stage == Stage::Split { 0.3 } else { 0.05 };
    let mesh = Mesh::uniform(&scene, edge);
    let enclosure = Enclosure::of(&scene, &mesh);
    let matrix = match stage {
        Stage::Factors => Hemicube::new(&mesh, 16).matrix(&|| ()),
        _ => {
            let accuracy = 0.02 / mesh.elements.len() as f64;
            Analytic::new(&scene, &mesh, accuracy, 0).sharp().matrix(&|| ())
        }
    };
    let bounces = if stage == Stage::Solve { 2 } else { 40 };
    let mut solver = Jacobi::new(&enclosure, &matrix);
    solver.by_ref().take(bounces).for_each(drop);
    let shot = Shot { camera: scene.camera, width: 160, height: 160, samples: 2 };
    shot.smooth(&mesh, &mesh.vertex_values(solver.radiosity()))
}

/// All four pictures, each made once.
fn picture_of(stage: Stage) -> &'static Picture {
    static PICTURES: OnceLock<[Picture; 4]> = OnceLock::new();
    let all = PICTURES.get_or_init(|| Stage::ALL.map(render));
    let place = Stage::ALL.iter().position(|s| *s == stage);
    &all[place.expect("ALL has all stages")]
}

/// The picture, at exposure 1.
pub fn picture(stage: Stage) -> RgbImage {
    picture_of(stage).display(1.0)
}

/// How far the picture is from the one with nothing spoilt: root mean square over the
/// pixels, relative, of what a display shows (radiance up to 1).
pub fn error(stage: Stage) -> f64 {
    let [got, good] = [stage, Stage::None].map(picture_of);
    let shown = |l: &Rgb| l.min(Rgb::ONE);
    let pairs = got.pixels.iter().zip(&good.pixels);
    let off: f64 = pairs.map(|(a, b)| (shown(a) - shown(b)).length_squared()).sum();
    let all: f64 = good.pixels.iter().map(|l| shown(l).length_squared()).sum();
    (off / all).sqrt()
}

/// The caption under it.
pub fn caption(stage: Stage) -> String {
    let what = match stage {
        Stage::None => {
            return "Nothing spoilt: edges up to 0.05 m, analytic factors, 40 \
                               bounces"
                .into();
        }
        Stage::Split => "Edges up to 0.3 m",
        Stage::Factors => "Hemicubes of 16",
        Stage::Solve => "Two bounces",
    };
    format!("{what}: off by {:.0} %", 100.0 * error(stage))
}
