//! The figures and numbers of the chapter *Why not specular radiosity?*
//!
//! [`Tiny`] is a cube with a glossy floor, solved in patches and bins; [`views`] looks at
//! it; [`smear`] asks what bins make of a lobe; [`growth`] reads what was measured.

pub mod growth;
pub mod smear;
pub mod views;

use glam::{DVec3, dvec3};
use radiosity::directional::{Bins, Directional, Transport};
use radiosity::film::{Picture, Shot};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::raster::{ItemBuffer, Seen, View};
use radiosity::scene::{Camera, Face, MaterialId, Scene};
use radiosity::solve::Ledger;

/// The exponent of the floor's gloss.
pub const EXPONENT: f64 = 20.0;

/// Light bounces until less than this share is left.
const LEFT: f64 = 1e-3;

/// A cube with an edge of 1 m: a red wall, a floor that is glossy, a lamp in the ceiling.
pub fn scene() -> Scene {
    let paint = |name: &str, emission: Rgb, diffuse: Rgb, gloss: f64| {
        let shine = Shine::Gloss { reflectance: Rgb::splat(gloss), exponent: EXPONENT };
        let shine = if gloss > 0.0 { shine } else { Shine::Dull };
        let c = Coefficients { emission, diffuse, shine, ..Coefficients::default() };
        Material::new(name, c).expect("the paints are passive")
    };
    let (dark, grey) = (Rgb::ZERO, Rgb::splat(0.5));
    let materials = vec![
        paint("grey", dark, grey, 0.0),
        paint("red", dark, dvec3(0.6, 0.2, 0.1), 0.0),
        paint("floor", dark, Rgb::splat(0.2), 0.6),
        paint("lamp", dvec3(4.0, 4.0, 2.0), Rgb::splat(0.3), 0.0),
    ];
    let (x, y, z, o) = (DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO);
    let lamp = dvec3(0.25, 0.25, 1.0);
    let faces = [
        (1, o, y, z),
        (0, x, z, y),
        (0, o, z, x),
        (0, y, x, z),
        (2, o, x, y),
        (0, z, y, x),
        (3, lamp, 0.5 * y, 0.5 * x),
    ];
    let face = |(material, o, a, b): (u32, DVec3, DVec3, DVec3)| {
        let outline = vec![o, o + a, o + a + b, o + b];
        Face { outline, material: MaterialId(material) }
    };
    let camera = Camera {
        eye: dvec3(0.5, 0.03, 0.62),
        target: dvec3(0.42, 0.6, 0.2),
        up: DVec3::Z,
        fov: 85.0,
    };
    let scene =
        Scene::assemble("glossy", materials, faces.map(face).to_vec(), Some(camera));
    scene.expect("the faces are sound").0
}

/// The view of the chapter.
pub fn shot(samples: u32) -> Shot {
    Shot { camera: scene().camera, width: 64, height: 64, samples }
}

/// The cube in patches and bins.
pub struct Tiny {
    /// The cube.
    pub scene: Scene,
    /// Its elements are the patches.
    pub mesh: Mesh,
    /// Between their beams.
    pub transport: Transport,
}

impl Tiny {
    /// Patches of at most this `edge`, `side²` bins, so many `rays` from each beam.
    pub fn new(edge: f64, side: u32, rays: usize) -> Tiny {
        let scene = scene();
        let mesh = Mesh::uniform(&scene, edge);
        let mut transport = Transport::sampled(&mesh, Bins::new(side), rays, 0);
        transport.close();
        Tiny { scene, mesh, transport }
    }

    /// All its light, how many bounces that took, and where it went.
    pub fn solve(&self) -> (Directional<'_>, usize, Ledger) {
        let mut light = Directional::new(&self.scene, &self.mesh, &self.transport);
        let mut bounces = 0;
        loop {
            bounces += 1;
            let Some(ledger) = light.next() else { unreachable!("it never ends") };
            if (ledger.unshot / ledger.emitted).abs().max_element() < LEFT {
                return (light, bounces, ledger);
            }
        }
    }

    /// What an eye sees.
    pub fn picture(&self, light: &Directional, shot: &Shot) -> Picture {
        let mut picture = Picture::new(shot.width, shot.height);
        let mut items = ItemBuffer::new(shot.width, shot.height);
        let samples = f64::from(shot.samples * shot.samples);
        for view in shot.views() {
            items.reset(shot.width, shot.height);
            self.mesh.polygons().zip(0..).for_each(|(p, id)| items.draw(&view, p, id));
            for (k, seen) in items.pixels().enumerate() {
                let Seen::Front(patch) = seen else { continue };
                let (x, y) = (k as u32 % shot.width, k as u32 / shot.width);
                let at = View::pixel_centre(x, y, shot.width, shot.height);
                let to_eye = -view.direction(at).normalize();
                picture.pixels[k] += light.towards(ElementId(patch), to_eye) / samples;
            }
        }
        picture
    }
}

/// Pixels whose middle shows the floor.
pub fn floor_pixels(shot: &Shot) -> Vec<bool> {
    let mesh = Mesh::whole(&scene());
    let floor = |seen: Seen| matches!(seen, Seen::Front(id) if id == 4);
    shot.items(&mesh).pixels().map(floor).collect()
}

/// The error of a picture of the floor: root mean square over its pixels, relative to that
/// of the `truth`.
pub fn error(picture: &Picture, truth: &Picture) -> f64 {
    let (mut off, mut norm) = (0.0, 0.0);
    let floor = floor_pixels(&shot(1));
    for ((a, b), _) in
        picture.pixels.iter().zip(&truth.pixels).zip(floor).filter(|(_, floor)| *floor)
    {
        off += (*a - *b).length_squared();
        norm += b.length_squared();
    }
    (off / norm).sqrt()
}

/// The outline of the cube's floor, for those who look at it alone.
pub fn is_floor(polygon: &Polygon) -> bool {
    polygon.normal() == DVec3::Z
}

/// Path and text of the generated files of this chapter.
pub fn files() -> Vec<(String, String)> {
    vec![
        ("generated/directional-growth.svg".to_string(), growth::svg()),
        ("generated/directional-growth.md".into(), growth::table()),
        ("generated/directional-cost.svg".into(), growth::cost_svg()),
        ("generated/directional-cost.md".into(), growth::text()),
        ("generated/directional-cornell.md".into(), growth::cornell()),
        ("generated/directional-smear.md".into(), smear::table()),
        ("generated/directional-views.md".into(), views::caption()),
        ("generated/directional-floor.md".into(), views::floor_caption()),
        ("generated/directional-ledger.md".into(), views::ledger()),
    ]
}
