//! The built-in scenes.
//!
//! | scene                | asks                                                         |
//! |----------------------|--------------------------------------------------------------|
//! | `cornell`            | does it look like the photograph?                            |
//! | `cornell-regular`    | do the numbers meet the published-size reference?            |
//! | `furnace`            | is energy kept? every point must have `B = 1/(1 − ρ)`        |
//! | `facing-squares`     | is one form factor right? `F = 0.199825`                     |
//! | `l-room`             | does light turn a corner? floor and ceiling are not convex   |
//! | `indirect-room`      | how good is a method where all light is reflected light?     |
//! | `mirror-room`        | is it the doubled room? one wall is a perfect mirror         |
//! | `mirror-corridor`    | what does each level of images add? two mirrors face to face |
//! | `cornell-mirror`     | what do mirrors throw into a room? the tall block is one     |
//! | `cornell-pane`       | what does glass hold back, and mirror?                       |
//! | `glazed-room`        | how much daylight comes through a window pane?               |
//! | `sky-room`           | how much through an open window?                             |
//! | `translucent-screen` | does light come out on the other side of paper?              |
//! | `glossy-floor`       | how are highlights spread?                                   |
//! | `glass-ball`         | where does bent light go? a caustic                          |
//! | `gallery`            | all of it, in one picture                                    |
//!
//! Sources: the Cornell University Program of Computer Graphics, *Cornell Box Data*.

mod cornell;
mod gallery;
mod rooms;
mod shiny;

use super::{Camera, Face, MaterialId, Scene};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material, Shine};
use glam::{DVec3, dvec3};
use std::fmt;

/// A built-in scene, by name.
#[derive(Clone, Copy, Debug)]
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
    BUILT_INS.to_vec()
}

const fn scene(
    name: &'static str,
    about: &'static str,
    make: fn() -> Scene,
) -> BuiltIn {
    BuiltIn { name, about, make }
}

const BUILT_INS: [BuiltIn; 16] = [
    scene("cornell", "the Cornell box as measured, in metres", cornell::measured),
    scene(
        "cornell-regular",
        "the Cornell box with right angles, light of radiosity 1",
        cornell::regular,
    ),
    scene(
        "furnace",
        "closed unit cube, E = 1, reflectance 0.5, so B = 2; furnace:RHO takes any \
         reflectance in [0, 1)",
        || rooms::furnace(0.5).expect("0.5 is passive"),
    ),
    scene(
        "facing-squares",
        "two unit squares face to face at distance 1, one emits; open",
        rooms::facing_squares,
    ),
    scene("l-room", "closed L-shaped room, its lamp round the corner", rooms::l_room),
    scene(
        "indirect-room",
        "closed room that no lamp shines into: all light is reflected",
        rooms::indirect_room,
    ),
    scene(
        "mirror-room",
        "closed room, one wall a perfect mirror: half of a room twice as deep",
        shiny::mirror_room,
    ),
    scene(
        "mirror-corridor",
        "two mirrors face to face along a corridor: images without end",
        shiny::mirror_corridor,
    ),
    scene(
        "cornell-mirror",
        "the Cornell box, its tall block a mirror",
        cornell::with_mirror,
    ),
    scene(
        "cornell-pane",
        "the Cornell box, a pane of glass before its blocks",
        cornell::with_pane,
    ),
    scene(
        "glazed-room",
        "room with a glazed window under an overcast sky",
        shiny::glazed_room,
    ),
    scene(
        "sky-room",
        "the same room, its window open, under a uniform sky",
        shiny::sky_room,
    ),
    scene(
        "translucent-screen",
        "room divided by a paper screen, all its lamps behind it",
        shiny::translucent_screen,
    ),
    scene(
        "glossy-floor",
        "room with a polished floor that smears a lamp and blocks",
        shiny::glossy_floor,
    ),
    scene(
        "glass-ball",
        "room with a ball of glass that gathers the light of a lamp",
        shiny::glass_ball,
    ),
    scene(
        "gallery",
        "all of it: mirror, panes, screen, polished floor, ball, daylight",
        gallery::gallery,
    ),
];

/// Why there is no built-in scene of some name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
                let names: Vec<&str> = BUILT_INS.iter().map(|b| b.name).collect();
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
    match BUILT_INS.iter().find(|b| b.name == name) {
        Some(scene) => Ok((scene.make)()),
        None => Err(BuiltInError::Unknown(name.into())),
    }
}

/// A diffuse material that is known to be passive.
fn material(name: &str, emission: Rgb, diffuse: Rgb) -> Material {
    let coefficients = Coefficients { emission, diffuse, ..Default::default() };
    Material::new(name, coefficients).expect("built-in materials are passive")
}

/// A corner of a plan, `(x, z)`.
type Corner = (f64, f64);

/// Faces and materials as they are put together, one call a face.
#[derive(Default)]
struct SceneBuilder {
    materials: Vec<Material>,
    faces: Vec<Face>,
}

impl SceneBuilder {
    fn material(&mut self, name: &str, emission: Rgb, diffuse: Rgb) -> MaterialId {
        self.materials.push(material(name, emission, diffuse));
        MaterialId(self.materials.len() as u32 - 1)
    }

    fn face(&mut self, material: MaterialId, outline: &[DVec3]) {
        self.faces.push(Face { outline: outline.to_vec(), material });
    }

    /// A material that does not only scatter diffusely, known to be passive.
    fn shiny(
        &mut self,
        name: &str,
        diffuse: Rgb,
        translucence: Rgb,
        shine: Shine,
    ) -> MaterialId {
        let emission = Rgb::ZERO;
        let coefficients = Coefficients { emission, diffuse, translucence, shine };
        let made = Material::new(name, coefficients);
        self.materials.push(made.expect("built-in materials are passive"));
        MaterialId(self.materials.len() as u32 - 1)
    }

    /// A closed room over `plan`, corners counter-clockwise seen from above (the
    /// z-axis down the page, so `(0, 0)`, `(0, 1)`, `(1, 1)`), fronts inwards: the floor,
    /// the ceiling at `height`, then one wall for each edge of the plan.
    fn room(
        &mut self,
        plan: &[Corner],
        height: f64,
        [floor, ceiling]: [MaterialId; 2],
        walls: &[MaterialId],
    ) {
        debug_assert_eq!(plan.len(), walls.len(), "one material for each wall");
        self.level(plan, height, [floor, ceiling]);
        for (k, &wall) in walls.iter().enumerate() {
            self.wall(wall, [plan[k], plan[(k + 1) % plan.len()]], height);
        }
    }

    /// The floor and the ceiling over `plan`.
    fn level(
        &mut self,
        plan: &[Corner],
        height: f64,
        [floor, ceiling]: [MaterialId; 2],
    ) {
        let at = |y: f64| move |&(x, z): &Corner| dvec3(x, y, z);
        self.face(floor, &plan.iter().map(at(0.0)).collect::<Vec<_>>());
        self.face(ceiling, &plan.iter().rev().map(at(height)).collect::<Vec<_>>());
    }

    /// The wall along the edge of a plan from `a` to `b`.
    fn wall(&mut self, material: MaterialId, [a, b]: [Corner; 2], height: f64) {
        let at = |(x, z): Corner, y| dvec3(x, y, z);
        self.face(material, &[at(b, 0.0), at(a, 0.0), at(a, height), at(b, height)]);
    }

    /// The same wall with a `hole`. Returns the outline of the hole, looking inwards.
    fn pierced_wall(
        &mut self,
        material: MaterialId,
        [a, b]: [Corner; 2],
        height: f64,
        hole: Hole,
    ) -> [DVec3; 4] {
        let part = |left: f64, right: f64, low, high| {
            let at = |s: f64, y| dvec3(a.0 + s * (b.0 - a.0), y, a.1 + s * (b.1 - a.1));
            [at(right, low), at(left, low), at(left, high), at(right, high)]
        };
        let Hole { left, right, low, high } = hole;
        self.face(material, &part(0.0, left, 0.0, height));
        self.face(material, &part(left, right, 0.0, low));
        self.face(material, &part(left, right, high, height));
        self.face(material, &part(right, 1.0, 0.0, height));
        part(left, right, low, high)
    }

    /// A ball: `2n` slices from pole to pole in `n` bands, fronts outwards.
    fn ball(&mut self, centre: DVec3, radius: f64, n: usize, material: MaterialId) {
        let at = |band: usize, slice: usize| {
            let angle = |k: usize| std::f64::consts::PI * k as f64 / n as f64;
            let ((ring, y), (x, z)) =
                (angle(band).sin_cos(), angle(slice % (2 * n)).sin_cos());
            centre + radius * dvec3(ring * x, y, ring * z)
        };
        for slice in 0..2 * n {
            self.face(material, &[at(0, 0), at(1, slice), at(1, slice + 1)]);
            for band in 1..n - 1 {
                let (a, b) = (at(band, slice), at(band + 1, slice));
                let (c, d) = (at(band + 1, slice + 1), at(band, slice + 1));
                self.face(material, &[a, b, c, d]);
            }
            self.face(material, &[at(n - 1, slice), at(n, 0), at(n - 1, slice + 1)]);
        }
    }

    /// A block that stands on the floor, fronts outwards: its top and its sides. It has no
    /// underside, as the blocks of the Cornell box have none.
    fn block(&mut self, plan: &[Corner], height: f64, material: MaterialId) {
        self.block_on(plan, [0.0, height], material);
    }

    /// A block that stands on another one: between two heights.
    fn block_on(&mut self, plan: &[Corner], y: [f64; 2], material: MaterialId) {
        let at = |k: usize, y: f64| {
            let (x, z) = plan[k % plan.len()];
            dvec3(x, y, z)
        };
        let [low, high] = y;
        let top: Vec<DVec3> = (0..plan.len()).map(|k| at(k, high)).collect();
        self.face(material, &top);
        for k in 0..plan.len() {
            let side = [at(k, low), at(k + 1, low), at(k + 1, high), at(k, high)];
            self.face(material, &side);
        }
    }

    fn scene(self, name: &str, camera: Camera) -> Scene {
        let scene = Scene::assemble(name, self.materials, self.faces, Some(camera));
        scene.expect("built-in scenes are sound").0
    }
}

/// A hole in a wall.
#[derive(Clone, Copy)]
struct Hole {
    /// Where it begins and ends, as shares of the wall's length.
    left: f64,
    right: f64,
    /// The heights of its sill and its lintel.
    low: f64,
    high: f64,
}
