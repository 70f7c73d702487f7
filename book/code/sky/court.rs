//! A court under three skies.

use super::skies::{Kind, WIDTH};
use crate::ledger as ledgers;
use glam::{DVec3, dvec3};
use radiosity::film::{RgbImage, Shot};
use radiosity::geometry::Rgb;
use radiosity::material::{Coefficients, Material};
use radiosity::plan::Plan;
use radiosity::room::Room;
use radiosity::scene::{Camera, Face, MaterialId, Scene};
use radiosity::solution::Goal;
use radiosity::trace::PathTracer;
use radiosity::work::Work;

/// What is asked for of pass 1.
const TOLERANCE: f64 = 0.1;

/// A box on the ground about `middle`, `half` as wide and deep, its top at `height`.
fn block(middle: [f64; 2], half: [f64; 2], height: f64) -> Vec<Vec<DVec3>> {
    let [x, z] = middle;
    let at = |i: f64, j: f64, y: f64| dvec3(x + i * half[0], y, z + j * half[1]);
    let side = |[i, j]: [f64; 2], [k, l]: [f64; 2]| {
        vec![at(i, j, 0.0), at(k, l, 0.0), at(k, l, height), at(i, j, height)]
    };
    let around = [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
    let mut faces: Vec<_> =
        (0..4).map(|k| side(around[k], around[(k + 1) % 4])).collect();
    faces.push(around.map(|[i, j]| at(i, j, height)).to_vec());
    faces
}

/// Pale ground as far as `reach` m, a white block and a red one, under this sky.
pub fn scene(kind: Kind, reach: f64) -> Scene {
    let paint = |name: &str, diffuse| {
        let coefficients = Coefficients { diffuse, ..Coefficients::default() };
        Material::new(name, coefficients).expect("below 1")
    };
    let materials = vec![
        paint("ground", Rgb::new(0.5, 0.48, 0.42)),
        paint("white", Rgb::splat(0.75)),
        paint("red", Rgb::new(0.65, 0.15, 0.1)),
    ];
    let ground = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    let ground = ground.map(|(x, z)| dvec3(x * reach, 0.0, z * reach)).to_vec();
    let mut faces = vec![(0, ground)];
    faces.extend(block([-0.7, -0.9], [0.6, 0.6], 2.0).into_iter().map(|f| (1, f)));
    faces.extend(block([0.9, 0.3], [0.5, 0.5], 0.8).into_iter().map(|f| (2, f)));
    let face = |(material, outline)| Face { outline, material: MaterialId(material) };
    let camera = Camera {
        eye: dvec3(2.4, 1.5, 5.8),
        target: dvec3(0.0, 1.15, 0.0),
        up: DVec3::Y,
        fov: 40.0,
    };
    let faces = faces.into_iter().map(face).collect();
    let scene = Scene::assemble("court", materials, faces, Some(camera));
    Scene { sky: Some(kind.sky()), ..scene.expect("its faces are sound").0 }
}

/// Paths through each pixel.
const SAMPLES: usize = 96;

/// What the camera sees, path by path; all skies are shown with one exposure.
pub fn picture(kind: Kind) -> RgbImage {
    let scene = scene(kind, 40.0);
    let (camera, width, height) = (scene.camera, 128, 96);
    let shot = Shot { camera, width, height, samples: 1 };
    let seen =
        PathTracer::of(&Room::of(&scene)).picture(&shot, SAMPLES, 0, &|_, _, _| {});
    seen.picture.display(0.035)
}

/// What is said below the first picture.
pub fn caption() -> String {
    format!(
        "A court under a clear sky with a sun, all of it one panorama of {WIDTH} × {} \
         texels. Drawn by the path tracer, {SAMPLES} paths to a pixel.\n",
        WIDTH / 2
    )
}

/// Where the light of the court went under the overcast sky, as pass 1 has it.
pub fn ledger() -> String {
    let scene = scene(Kind::Overcast, 3.0);
    let (room, goal) = (Room::of(&scene), Goal::within(TOLERANCE));
    let done = Plan::of(&room, TOLERANCE).run(&room, &goal, &Work::quiet());
    ledgers::table(&done.expect("it can be solved").solution)
}
