//! Directional radiosity: what one unknown for each direction costs, and what it gains, in
//! a cube with a glossy floor; beside it two passes and paths for one view of it.

use super::look::solved;
use super::truth::PictureTruth;
use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::directional::{Bins, Directional, Transport};
use crate::film::{Picture, Shot};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material, Shine};
use crate::mesh::{ElementId, Mesh};
use crate::raster::{ItemBuffer, Seen, View as Eye};
use crate::room::Room;
use crate::scene::{Camera, Face, MaterialId, Scene};
use crate::solve::Ledger;
use crate::trace::{Look, PathTracer, TwoPass};
use glam::{DVec3, dvec3};

/// This suite.
pub const SUITE: Suite = Suite {
    name: "directional",
    about: "radiosity with directions, two passes and paths, over a glossy floor",
    measure,
    views: &[
        ChartView {
            file: "directional-growth",
            title: "Memory of directional radiosity over the number of directions",
            across: (Column::Setting, "bins for each patch"),
            upward: (Column::Bytes, "bytes"),
            least: 1.0,
            shows: |t| t.method.ends_with(PATCHES),
        },
        ChartView {
            file: "directional-cost",
            title: "Error of the floor in the picture against the time to find it",
            across: (Column::Seconds, "CPU seconds, one thread"),
            upward: (Column::Error, "error of a pixel, relative to the mean"),
            least: 1e-3,
            shows: |_| true,
        },
    ],
};

/// Scene of the suite.
pub const CUBE: &str = "cube with a glossy floor";

/// What follows the number of them in the name of a method by bins.
pub const PATCHES: &str = " patches";

/// The exponent of the floor's gloss.
pub const EXPONENT: f64 = 20.0;

/// Light bounces until less than this share is left.
const LEFT: f64 = 1e-3;

/// Rays from each beam.
const RAYS: usize = 200;

fn measure(bench: &Bench) -> Vec<Trial> {
    // Longest edges of the patches, m; bins along an edge of the chessboard.
    let (edges, sides) = ([0.5, 0.25, 0.125], [1, 2, 4, 8, 16]);
    let paths = [2.0, 8.0, 32.0, 128.0, 512.0];
    let tolerances = [0.1, 0.05, 0.02];
    run(&edges, &sides, [&tolerances, &paths], 1000, bench)
}

/// Patches with these `edges`, `side²` bins for each of `sides`; two passes at `tolerances`;
/// `paths` for each pixel, and so many, twice, in what counts as true.
pub fn run(
    edges: &[f64],
    sides: &[u32],
    [tolerances, paths]: [&[f64]; 2],
    truth: usize,
    bench: &Bench,
) -> Vec<Trial> {
    let scene = scene();
    let tracer = PathTracer::of(&Room::of(&scene));
    let floor: Vec<usize> =
        (0..).zip(floor_pixels(&shot(1))).filter(|p| p.1).map(|p| p.0).collect();
    let by_paths = |n, seed| tracer.picture(&shot(1), n, seed, &|_, _, _| {}).picture;
    let truth = PictureTruth::of(floor, |seed| by_paths(truth, 1000 + seed));
    let judge =
        |(seen, energy): &Answer| Verdict { energy: *energy, ..truth.judge(seen) };
    let bins: Vec<f64> = sides.iter().map(|side| f64::from(side * side)).collect();
    let mut contest = Contest::new(CUBE, truth.uncertainty(), judge);
    for &edge in edges {
        let name = format!("{}{PATCHES}", Mesh::uniform(&scene, edge).elements.len());
        let by_bins = move |bins: f64, _| by_bins(edge, bins.sqrt() as u32);
        contest = contest.with(Method::new(&name, &bins, by_bins));
    }
    let two_passes = Method::new("two passes", tolerances, |tolerance, _| {
        two_passes(&scene, tolerance)
    });
    let paths = Method::random("paths", paths, |n, seed| {
        let picture = by_paths(n as usize, seed);
        let rays = (n as usize * picture.pixels.len()) as u64;
        ((picture, None), WorkDone { rays, ..WorkDone::default() })
    })
    .seeds(2); // a picture has many pixels
    contest.with(two_passes).with(paths).run(SUITE.name, bench)
}

/// A picture, and light made or lost, where that is kept account of.
type Answer = (Picture, Option<f64>);

/// Bytes of a colour, and of a stored pair of beams.
const COLOUR: usize = size_of::<Rgb>();
const PAIR: usize = size_of::<(u32, f64)>();

fn by_bins(edge: f64, side: u32) -> (Answer, WorkDone) {
    let tiny = Tiny::new(edge, side, RAYS);
    let (light, bounces, ledger) = tiny.solve();
    let picture = tiny.picture(&light, &shot(3));
    let (n, m) = (tiny.mesh.elements.len(), tiny.transport.bins().len());
    let (unknowns, pairs) = (n * m, tiny.transport.pairs());
    // What leaves, what arrives, what leaves next; the shares; the paints.
    let kept = 3 * COLOUR * unknowns + PAIR * pairs;
    let bytes = kept + COLOUR * m * m * tiny.scene.materials.len();
    let work = WorkDone {
        factors: pairs as u64,
        rays: (unknowns * RAYS) as u64,
        steps: bounces as u64,
        bytes: bytes as u64,
        ..WorkDone::default()
    };
    let energy = (ledger.imbalance / ledger.emitted).abs().max_element();
    ((picture, Some(energy)), work)
}

/// Radiosity for the diffuse light, to this error, and rays for the gloss.
fn two_passes(scene: &Scene, tolerance: f64) -> (Answer, WorkDone) {
    let (solution, work) = solved(scene, tolerance);
    let light = &solution.vertex_radiosity;
    let second = TwoPass::showing(
        &Room::of(scene),
        &solution.field.mesh,
        light,
        Look::default(),
    );
    let shown = second.picture(&shot(3), &|_, _, _| {});
    let Ledger { imbalance, emitted, .. } = solution.field.ledger;
    let energy = (imbalance / emitted).abs().max_element();
    ((shown.picture, Some(energy)), WorkDone { rays: shown.rays, ..work })
}

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
#[derive(Debug)]
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
                let at = Eye::pixel_centre(x, y, shot.width, shot.height);
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
