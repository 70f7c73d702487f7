//! Which ways of making a picture there are, and the best for a room.

use super::{Look, PathTracer, Shown, TwoPass, Whitted};
use crate::film::{Picture, Shot};
use crate::geometry::Rgb;
use crate::room::Room;
use crate::scene::Scene;
use crate::sky::Sky;
use crate::solution::Solution;
use crate::work::Progress;

/// How light is followed to a picture.
///
/// | method       | pass 1 | rays from the eye | shows                                     |
/// |--------------|--------|-------------------|-------------------------------------------|
/// | `Radiosity`  | yes    | no                | diffuse light; what shines is black       |
/// | `RayTrace`   | no     | yes               | lamps, mirrors, glass; no interreflection |
/// | `TwoPass`    | yes    | where it shines   | all light                                 |
/// | `PathTrace`  | no     | yes, by chance    | all light, and noise                      |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureMethod {
    /// Diffuse light between elements, drawn as it is.
    Radiosity,
    /// Classical ray tracing.
    RayTrace,
    /// Radiosity, then rays where something shines.
    TwoPass,
    /// Random paths of all kinds: the reference, with its standard error.
    PathTrace,
}

/// A picture, and what is known of it.
#[derive(Clone, Debug)]
#[must_use]
pub struct Rendered {
    /// The picture.
    pub picture: Picture,
    /// How many rays were followed from the eye, where they were counted.
    pub rays: Option<u64>,
    /// The standard error of each pixel, where chance decided.
    pub error: Option<Vec<Rgb>>,
}

/// What is drawn, and who is told how far it is.
#[derive(Clone, Copy)]
pub struct Drawing<'a> {
    /// Camera, size and samples.
    pub shot: &'a Shot,
    /// Names the random streams.
    pub seed: u64,
    /// Who is told.
    pub progress: Progress<'a>,
}

impl std::fmt::Debug for Drawing<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Drawing { shot, seed, .. } = self;
        f.debug_struct("Drawing").field("shot", shot).field("seed", seed).finish()
    }
}

impl From<Picture> for Rendered {
    fn from(picture: Picture) -> Rendered {
        Rendered { picture, rays: None, error: None }
    }
}

impl From<Shown> for Rendered {
    fn from(shown: Shown) -> Rendered {
        Rendered { picture: shown.picture, rays: Some(shown.rays), error: None }
    }
}

impl PictureMethod {
    /// The method that shows all light of `scene` at the least cost: a scene in which
    /// nothing shines needs no second pass.
    pub fn best_for(scene: &Scene) -> PictureMethod {
        let sky = scene.sky.as_ref().is_some_and(Sky::shines);
        match scene.shines() || sky {
            true => PictureMethod::TwoPass,
            false => PictureMethod::Radiosity,
        }
    }

    /// What of this scene's light it leaves out, in a sentence; `None` where nothing is.
    pub fn leaves_out(self, scene: &Scene) -> Option<&'static str> {
        let sky = scene.sky.as_ref().is_some_and(Sky::shines);
        match self {
            PictureMethod::RayTrace if sky => Some(
                "ray tracing shows the sky and lights nothing by it; choose two-pass to \
                 have its light as well",
            ),
            PictureMethod::Radiosity if sky || scene.shines() => Some(
                "radiosity alone shows neither the sky nor what shines, which are black; \
                 choose two-pass to see them",
            ),
            _ => None,
        }
    }

    /// All of them.
    pub const ALL: [PictureMethod; 4] = [
        PictureMethod::Radiosity,
        PictureMethod::RayTrace,
        PictureMethod::TwoPass,
        PictureMethod::PathTrace,
    ];

    /// Its name, and in a sentence what it shows.
    pub fn name_and_words(self) -> (&'static str, &'static str) {
        match self {
            PictureMethod::Radiosity => (
                "radiosity",
                "Diffuse light between elements, drawn as it is; what shines is black",
            ),
            PictureMethod::RayTrace => (
                "ray-trace",
                "Classical ray tracing: lamps, mirrors and glass, no light between diffuse \
                 surfaces",
            ),
            PictureMethod::TwoPass => {
                ("two-pass", "Radiosity, then rays where something shines")
            }
            PictureMethod::PathTrace => (
                "path-trace",
                "Random paths of all kinds: the reference, with its standard error",
            ),
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.name_and_words().0
    }

    /// Does it begin with pass 1?
    pub fn solves(self) -> bool {
        matches!(self, PictureMethod::Radiosity | PictureMethod::TwoPass)
    }

    /// The picture of `room`, drawn from its `solution` by a method that
    /// [solves](PictureMethod::solves).
    ///
    /// Paths: `samples²` through each pixel, two at least. `seed` names the random streams.
    ///
    /// ```
    /// use radiosity::trace::{Drawing, PictureMethod};
    /// use radiosity::{film::Shot, room::Room, scene::built_in};
    /// let scene = built_in("furnace").unwrap(); // E = 1, ρ = ½: B = 2 everywhere
    /// let shot = Shot { camera: scene.camera, width: 4, height: 4, samples: 16 };
    /// let paths = PictureMethod::PathTrace;
    /// let drawing = Drawing { shot: &shot, seed: 1, progress: &|_, _, _| {} };
    /// let drawn = paths.draw(&Room::of(&scene), None, &drawing);
    /// let mean = drawn.picture.pixels.iter().map(|l| l.x).sum::<f64>() / 16.0;
    /// assert!((mean * std::f64::consts::PI - 2.0).abs() < 0.1);
    /// ```
    ///
    /// # Panics
    /// When a method that solves gets no solution.
    pub fn draw(
        self,
        room: &Room,
        solution: Option<&Solution>,
        &Drawing { shot, seed, progress }: &Drawing,
    ) -> Rendered {
        let solved = || solution.expect("this method draws what pass 1 has found");
        match self {
            PictureMethod::Radiosity => {
                progress("drawing", 0, 1);
                let Solution { field, vertex_radiosity, .. } = solved();
                shot.smooth(&field.mesh, vertex_radiosity).into()
            }
            PictureMethod::TwoPass => {
                let options = Look { seed, ..Look::default() };
                let second = TwoPass::of(room, &solved().field, options);
                second.picture(shot, progress).into()
            }
            PictureMethod::RayTrace => {
                Whitted::of(room, Look::default()).picture(shot, progress).into()
            }
            PictureMethod::PathTrace => {
                let paths = (shot.samples as usize).pow(2).max(2);
                let traced = PathTracer::of(room).picture(shot, paths, seed, progress);
                Rendered {
                    picture: traced.picture,
                    rays: None,
                    error: Some(traced.error),
                }
            }
        }
    }
}
