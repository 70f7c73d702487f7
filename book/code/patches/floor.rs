//! Floors seen from above: where the field tears, leaks and kinks.

use crate::shooting::beside;
use glam::{DVec3, dvec3};
use radiosity::film::{Picture, RgbImage};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::{Element, Mesh};
use radiosity::room::Direct;
use radiosity::scene::{Face, MaterialId, Scene};

/// Pixels along an edge of a panel.
const PANEL: u32 = 96;

/// A rectangle, its front along a × b.
fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    let corners = vec![corner, corner + a, corner + a + b, corner + b];
    Polygon::new(corners).expect("a rectangle is a polygon")
}

/// A scene of faces with what they emit, W/m²; all reflect nothing: what is shown is what
/// arrives.
fn scene(faces: &[(Polygon, f64)]) -> Scene {
    let material = |(k, (_, e)): (usize, &(Polygon, f64))| {
        let of = Coefficients { emission: Rgb::splat(*e), ..Default::default() };
        Material::new(format!("m{k}"), of).expect("black is passive")
    };
    let materials = faces.iter().enumerate().map(material).collect();
    let face = |(k, (polygon, _)): (u32, &(Polygon, f64))| Face {
        outline: polygon.vertices().to_vec(),
        material: MaterialId(k),
    };
    let outlines = (0..).zip(faces).map(face).collect();
    let scene = Scene::assemble("floor", materials, outlines, None);
    scene.expect("rectangles are fit faces").0
}

/// The floor of 1 × 1 about the origin, the first surface of its scene.
fn floor() -> Polygon {
    rectangle(dvec3(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y)
}

/// A panel: the floor from above, y upward, white where `value` is `white`.
fn panel(white: f64, value: impl Fn(DVec3) -> f64) -> RgbImage {
    let mut picture = Picture::new(PANEL, PANEL);
    let at = |k: usize| (k as f64 + 0.5) / f64::from(PANEL) - 0.5;
    for (k, pixel) in picture.pixels.iter_mut().enumerate() {
        let (x, y) = (k % PANEL as usize, k / PANEL as usize);
        *pixel = Rgb::splat(value(dvec3(at(x), -at(y), 0.0)) / white);
    }
    picture.display(1.0)
}

/// The floor's element at a place.
fn element_at(mesh: &Mesh, x: DVec3) -> &Element {
    let mut floor = mesh.elements.iter().filter(|e| mesh.surface_of(e) == 0);
    floor.find(|e| e.polygon.contains(x, 1e-9)).expect("the floor has no hole")
}

/// The lamp of two figures: a square of 0.2 that hangs 0.2 above the middle.
fn low_lamp(x: DVec3) -> f64 {
    let lamp = rectangle(dvec3(-0.1, -0.1, 0.2), DVec3::Y * 0.2, DVec3::X * 0.2);
    lambert_polygon(x, DVec3::Z, &lamp)
}

/// Four elements, one of them split: its two T-vertices with the light that is there, and
/// with that of the edges that they lie on.
pub struct Tear {
    mesh: Mesh,
    own: Vec<Rgb>,
    anchored: Vec<Rgb>,
}

/// The figure's mesh.
pub fn tear() -> Tear {
    let scene = scene(&[(floor(), 0.0)]);
    let mesh = Mesh::patched(&scene, 0.5).split(&[true, false, false, false]);
    let own: Vec<Rgb> =
        mesh.vertices.iter().map(|&v| Rgb::splat(low_lamp(v))).collect();
    let mut anchored = own.clone();
    mesh.anchor(&mut anchored);
    Tear { mesh, own, anchored }
}

impl Tear {
    /// How much a T-vertex differs from the edge that it lies on, at most.
    pub fn jump(&self) -> f64 {
        let pairs = self.own.iter().zip(&self.anchored);
        pairs.map(|(own, edge)| (*own - *edge).x.abs()).fold(0.0, f64::max)
    }

    /// Torn, and anchored.
    pub fn picture(&self) -> RgbImage {
        let shown = |values: &[Rgb]| {
            panel(0.25, |x| self.mesh.value_at(element_at(&self.mesh, x), x, values).x)
        };
        beside(&[shown(&self.own), shown(&self.anchored)])
    }
}

/// What the tear is worth.
pub fn tear_caption() -> String {
    let whole = low_lamp(DVec3::ZERO);
    format!(
        "The jump is {:.0} % of the brightest light on the floor.\n",
        100.0 * tear().jump() / whole
    )
}

/// Where the wall of the next figure stands.
const WALL: f64 = 0.15;

/// A floor with a wall across it, and a lamp on the left of the wall, lower than it.
fn two_rooms() -> Scene {
    let wall = rectangle(dvec3(WALL, -9.0, 0.0), DVec3::Y * 18.0, DVec3::Z * 9.0);
    let lamp = rectangle(dvec3(-0.3, -0.1, 0.5), DVec3::Y * 0.2, DVec3::X * 0.2);
    scene(&[(floor(), 0.0), (wall, 0.0), (lamp, 1.0)])
}

/// The light on the floor between the vertices of these elements, each of which has the mean
/// of what arrives on it.
fn on_elements(scene: &Scene, mesh: &Mesh) -> Vec<Rgb> {
    const ACROSS: usize = 8;
    let direct = Direct::of(scene);
    let mean = |e: &Element| {
        let light = direct.on(&e.polygon);
        let at = |k: usize| {
            let place = |c: usize| (c as f64 + 0.5) / ACROSS as f64;
            e.polygon.point_at([place(k % ACROSS), place(k / ACROSS)])
        };
        let places = ACROSS * ACROSS;
        let sum: Rgb = (0..places).map(|k| light.irradiance(at(k))).sum();
        sum / places as f64
    };
    mesh.vertex_values(&mesh.elements.iter().map(mean).collect::<Vec<Rgb>>())
}

/// Elements of a quarter of the floor that nobody cut, and the same cut along the wall.
fn leaking_and_cut(scene: &Scene) -> [Mesh; 2] {
    let floor = |mesh: &Mesh| -> Vec<bool> {
        mesh.elements.iter().map(|e| mesh.surface_of(e) == 0).collect()
    };
    let whole = Mesh::whole(scene);
    let half = whole.split(&floor(&whole));
    [half.split(&floor(&half)), Mesh::uniform(scene, 0.25)]
}

/// The brightest that the dark side is shown, against the brightest of the bright side.
pub fn leaks() -> [f64; 2] {
    let scene = two_rooms();
    leaking_and_cut(&scene).map(|mesh| {
        let values = on_elements(&scene, &mesh);
        let shown = |x: f64| {
            let x = dvec3(x, 0.01, 0.0);
            mesh.value_at(element_at(&mesh, x), x, &values).x
        };
        let most = |from: f64, to: f64| {
            let at = |k: u32| from + (to - from) * (f64::from(k) + 0.5) / 100.0;
            (0..100).map(at).map(shown).fold(0.0, f64::max)
        };
        most(WALL, 0.5) / most(-0.5, WALL)
    })
}

/// The truth, elements that straddle the wall, and elements cut along it.
pub fn leak_picture() -> RgbImage {
    let scene = two_rooms();
    let direct = Direct::of(&scene);
    let light = direct.on(&scene.surfaces[0].polygon);
    let truth = panel(0.05, |x| light.irradiance(x).x);
    let [leaking, cut] = leaking_and_cut(&scene).map(|mesh| {
        let values = on_elements(&scene, &mesh);
        panel(0.05, |x| mesh.value_at(element_at(&mesh, x), x, &values).x)
    });
    beside(&[truth, leaking, cut])
}

/// How bright the leak is.
pub fn leak_caption() -> String {
    let [leaking, cut] = leaks();
    format!(
        "The dark room glows with up to {:.0} % of the brightest light in the bright one; \
         cut along the wall, with {:.0} %.\n",
        100.0 * leaking,
        100.0 * cut
    )
}

/// Edges of the elements of the last figure.
pub const BANDS: [f64; 3] = [0.25, 0.125, 0.0625];

/// The floor below the low lamp, linear between exact vertices: ever smaller elements, and
/// the truth.
pub fn bands_picture() -> RgbImage {
    let scene = scene(&[(floor(), 0.0)]);
    let mut panels: Vec<RgbImage> = Vec::new();
    for h in BANDS {
        let mesh = Mesh::uniform(&scene, h);
        let exact: Vec<Rgb> =
            mesh.vertices.iter().map(|&v| Rgb::splat(low_lamp(v))).collect();
        panels.push(panel(0.25, |x| mesh.value_at(element_at(&mesh, x), x, &exact).x));
    }
    panels.push(panel(0.25, low_lamp));
    beside(&panels)
}

/// The change of slope at the middle, W/m² a metre, for a lamp of 1 W/m².
pub fn kink(h: f64) -> f64 {
    let at = |k: f64| low_lamp(DVec3::X * (k * h));
    2.0 * (at(0.0) - at(1.0)) / h
}

/// The kinks of the figure.
pub fn bands_caption() -> String {
    let [a, b, c] = BANDS.map(kink);
    format!(
        "At the brightest vertex the slope changes by {a:.2}, {b:.2} and {c:.2}; with \
         elements of 0.5 it would be {:.2}.\n",
        kink(0.5)
    )
}
