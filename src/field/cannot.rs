//! What a method does not know, said in one sentence.

use crate::material::Material;
use crate::room::Room;
use crate::scene::Scene;
use crate::sky::Sky;
use std::error::Error;
use std::fmt;

/// What a room may have that a method may not know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Feature {
    /// Light from outside of the scene.
    Sky,
    /// A face that mirrors.
    Mirror,
    /// A clear pane.
    Pane,
    /// The boundary of a solid that refracts.
    Glass,
    /// A face that lets light through diffusely.
    Sheet,
}

impl Feature {
    fn words(self) -> &'static str {
        match self {
            Feature::Sky => "the light of the sky",
            Feature::Mirror => "mirrors",
            Feature::Pane => "panes",
            Feature::Glass => "solid glass",
            Feature::Sheet => "faces that let light through diffusely",
        }
    }

    fn is_of(self, material: &Material) -> bool {
        match self {
            Feature::Sky => false,
            Feature::Sheet => material.translucence() != crate::geometry::Rgb::ZERO,
            Feature::Mirror => material.shine().mirror().is_some(),
            Feature::Pane => material.shine().pane().is_some(),
            Feature::Glass => material.shine().index_of_solid().is_some(),
        }
    }
}

/// Why a method cannot find the light of a room.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cannot {
    /// The room has what the method does not know.
    Unknown {
        /// The method, as it is called on the command line.
        method: &'static str,
        /// What it does not know.
        feature: Feature,
        /// Where the first of it is; empty for the sky.
        place: String,
    },
    /// A surface lies so far off that rounding there is as large as light can tell.
    FarOff {
        /// Which surface, in words.
        place: String,
    },
    /// There is nothing that light could fall on.
    NoSurfaces,
}

impl fmt::Display for Cannot {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Cannot::Unknown { method, feature, place } => {
                let at = if place.is_empty() { "" } else { " (" };
                let end = if place.is_empty() { "" } else { ")" };
                write!(
                    f,
                    "--method {method} does not know {}{at}{place}{end} and would leave out \
                     their light; choose --method auto, which does",
                    feature.words()
                )
            }
            Cannot::FarOff { place } => write!(
                f,
                "{place} lies so far from the origin that rounding moves its corners by more \
                 than a millionth of its size; move the scene nearer to the origin"
            ),
            Cannot::NoSurfaces => {
                write!(
                    f,
                    "the scene has no faces, so there is nothing to light; add one"
                )
            }
        }
    }
}

impl Error for Cannot {}

/// Rounding of a corner may be this share of the surface's size.
const ROUNDING: f64 = 1e-6;

impl Cannot {
    /// What every method needs: a surface, and coordinates that tell its corners apart.
    pub(crate) fn in_any_case(scene: &Scene) -> Result<(), Cannot> {
        if scene.surfaces.is_empty() {
            return Err(Cannot::NoSurfaces);
        }
        let coarse = |s: &crate::scene::Surface| {
            let far = s.polygon.vertices().iter().map(|v| v.abs().max_element());
            let far = far.fold(0.0, f64::max);
            far * f64::EPSILON > ROUNDING * s.polygon.diameter()
        };
        match scene.surfaces.iter().position(coarse) {
            Some(k) => Err(Cannot::FarOff { place: place(scene, k) }),
            None => Ok(()),
        }
    }

    /// Refuses the first of `features` that the room has.
    pub(super) fn check(
        method: &'static str,
        room: &Room,
        features: &[Feature],
    ) -> Result<(), Cannot> {
        let scene = room.scene;
        for &feature in features {
            let is_of = |s: &crate::scene::Surface| feature.is_of(scene.material(s));
            let found = scene.surfaces.iter().position(is_of);
            let sky = scene.sky.as_ref().is_some_and(Sky::shines);
            let place = match feature {
                Feature::Sky if sky => String::new(),
                Feature::Sky => continue,
                _ => match found {
                    Some(k) => place(scene, k),
                    None => continue,
                },
            };
            return Err(Cannot::Unknown { method, feature, place });
        }
        Ok(())
    }
}

/// A surface in words.
fn place(scene: &Scene, k: usize) -> String {
    let surface = &scene.surfaces[k];
    format!("face {}, material `{}`", surface.face.0, scene.material(surface).name())
}

/// What a method leaves out, counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dropped {
    /// How many surfaces.
    pub count: usize,
    /// The first, in words.
    pub first: String,
}

impl Dropped {
    /// The gloss of a room.
    pub(super) fn gloss(room: &Room) -> Option<Dropped> {
        let scene = room.scene;
        let glossy = |k: &usize| {
            let shine = scene.material(&scene.surfaces[*k]).shine();
            shine.gloss().is_some() && !shine.is_dull()
        };
        let all: Vec<usize> = (0..scene.surfaces.len()).filter(glossy).collect();
        let first = place(scene, *all.first()?);
        Some(Dropped { count: all.len(), first })
    }
}

impl fmt::Display for Dropped {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Dropped { count, first } = self;
        write!(
            f,
            "this method leaves out gloss, of {count} surfaces (first: {first}): what it \
             sends on counts as absorbed"
        )
    }
}
