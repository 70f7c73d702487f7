//! The built-in scenes.
//!
//! | scene             | asks                                                            |
//! |-------------------|-----------------------------------------------------------------|
//! | `cornell`         | does it look like the photograph?                               |
//! | `cornell-regular` | do the numbers meet the published-size reference?               |
//! | `furnace`         | is energy kept? every point must have `B = 1/(1 − ρ)`           |
//! | `facing-squares`  | is one form factor right? `F = 0.199825`                        |
//! | `l-room`          | does light turn a corner? floor and ceiling are not convex      |
//! | `indirect-room`   | how good is a method where all light is reflected light?        |
//!
//! Sources: the Cornell University Program of Computer Graphics, *Cornell Box Data*.

mod cornell;
mod rooms;

use super::{Camera, Face, MaterialId, Scene};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material};
use glam::{DVec3, dvec3};
use std::fmt;

/// A built-in scene, by name.
pub struct BuiltIn {
    /// The name by which the command knows it.
    pub name: &'static str,
    /// One line on what it is for.
    pub about: &'static str,
    /// Makes it.
    pub make: fn() -> Scene,
}

/// All built-in scenes.
pub fn builtins() -> Vec<BuiltIn> {
    vec![
        BuiltIn {
            name: "cornell",
            about: "the Cornell box as measured, in metres",
            make: cornell::measured,
        },
        BuiltIn {
            name: "cornell-regular",
            about: "the Cornell box with right angles, light of radiosity 1",
            make: cornell::regular,
        },
        BuiltIn {
            name: "furnace",
            about: "closed unit cube, E = 1, reflectance 0.5, so B = 2; furnace:RHO \
                    takes any reflectance in [0, 1)",
            make: || rooms::furnace(0.5).expect("0.5 is passive"),
        },
        BuiltIn {
            name: "facing-squares",
            about: "two unit squares face to face at distance 1, one emits; open",
            make: rooms::facing_squares,
        },
        BuiltIn {
            name: "l-room",
            about: "closed L-shaped room, its lamp round the corner",
            make: rooms::l_room,
        },
        BuiltIn {
            name: "indirect-room",
            about: "closed room that no lamp shines into: all light is reflected",
            make: rooms::indirect_room,
        },
    ]
}

/// Why there is no built-in scene of some name.
#[derive(Clone, Debug, PartialEq)]
pub enum BuiltInError {
    /// No scene is called so.
    Unknown(String),
    /// `furnace:RHO` with a reflectance that is no number in `[0, 1)`.
    Reflectance(String),
}

impl fmt::Display for BuiltInError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            BuiltInError::Unknown(name) => {
                let names: Vec<&str> = builtins().iter().map(|b| b.name).collect();
                let names = names.join(", ");
                write!(f, "there is no built-in scene `{name}`; choose one of {names}")
            }
            BuiltInError::Reflectance(given) => write!(
                f,
                "`furnace:{given}` needs a reflectance in [0, 1), as in `furnace:0.5`"
            ),
        }
    }
}

impl std::error::Error for BuiltInError {}

/// The built-in scene of this name; `furnace:RHO` is a furnace of reflectance `RHO`.
///
/// # Errors
/// When no scene is called so, or the reflectance is no number in `[0, 1)`.
pub fn built_in(name: &str) -> Result<Scene, BuiltInError> {
    if let Some(given) = name.strip_prefix("furnace:") {
        let rho = given.parse().ok().and_then(rooms::furnace);
        return rho.ok_or_else(|| BuiltInError::Reflectance(given.into()));
    }
    match builtins().iter().find(|b| b.name == name) {
        Some(scene) => Ok((scene.make)()),
        None => Err(BuiltInError::Unknown(name.into())),
    }
}

/// A diffuse material that is known to be passive.
fn material(name: &str, emission: Rgb, diffuse: Rgb) -> Material {
    let coefficients = Coefficients { emission, diffuse, ..Default::default() };
    Material::new(name, coefficients).expect("built-in materials are passive")
}

/// Faces and materials as they are put together, one call a face.
#[derive(Default)]
struct Builder {
    materials: Vec<Material>,
    faces: Vec<Face>,
}

impl Builder {
    fn material(&mut self, name: &str, emission: Rgb, diffuse: Rgb) -> MaterialId {
        self.materials.push(material(name, emission, diffuse));
        MaterialId(self.materials.len() as u32 - 1)
    }

    fn face(&mut self, material: MaterialId, outline: &[DVec3]) {
        self.faces.push(Face { outline: outline.to_vec(), material });
    }

    /// A closed room over `plan`, corners `(x, z)` counter-clockwise seen from above (the
    /// z-axis down the page, so `(0, 0)`, `(0, 1)`, `(1, 1)`), fronts inwards: the floor,
    /// the ceiling at `height`, then one wall for each edge of the plan.
    fn room(
        &mut self,
        plan: &[(f64, f64)],
        height: f64,
        floor: MaterialId,
        ceiling: MaterialId,
        walls: &[MaterialId],
    ) {
        debug_assert_eq!(plan.len(), walls.len(), "one material for each wall");
        let at = |k: usize, y: f64| {
            let (x, z) = plan[k % plan.len()];
            dvec3(x, y, z)
        };
        let level: Vec<DVec3> = (0..plan.len()).map(|k| at(k, 0.0)).collect();
        let lid: Vec<DVec3> = (0..plan.len()).rev().map(|k| at(k, height)).collect();
        self.face(floor, &level);
        self.face(ceiling, &lid);
        for (k, &wall) in walls.iter().enumerate() {
            self.face(
                wall,
                &[at(k + 1, 0.0), at(k, 0.0), at(k, height), at(k + 1, height)],
            );
        }
    }

    /// A block that stands on the floor, fronts outwards: its top and its sides. It has no
    /// underside, as the blocks of the Cornell box have none.
    fn block(&mut self, plan: &[(f64, f64)], height: f64, material: MaterialId) {
        let at = |k: usize, y: f64| {
            let (x, z) = plan[k % plan.len()];
            dvec3(x, y, z)
        };
        let top: Vec<DVec3> = (0..plan.len()).map(|k| at(k, height)).collect();
        self.face(material, &top);
        for k in 0..plan.len() {
            let side = [at(k, 0.0), at(k + 1, 0.0), at(k + 1, height), at(k, height)];
            self.face(material, &side);
        }
    }

    fn scene(self, name: &str, camera: Camera) -> Scene {
        let scene = Scene::assemble(name, self.materials, self.faces, Some(camera));
        scene.expect("built-in scenes are sound").0
    }
}
