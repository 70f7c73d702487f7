//! What each stage hands to the next: elements, factors, radiosities, picture.

use crate::hemicube::view::paint;
use crate::{ledger, light};
use glam::dvec3;
use radiosity::field::Classical;
use radiosity::film::{RgbImage, Shot, hemicube_cross};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::mesh::Mesh;
use radiosity::raster::Seen;
use radiosity::room::Room;
use radiosity::scene::{Camera, built_in};
use radiosity::solution::Goal;
use radiosity::solution::{Solution, solve_on};
use radiosity::work::Work;
use std::sync::OnceLock;

/// Longest edge of an element, in metres.
pub const EDGE: f64 = 0.1;

/// Pixels along an edge of a picture.
const SIZE: u32 = 160;

/// The element that is looked from: on the floor, towards the front.
const FROM: glam::DVec3 = dvec3(0.4, 0.0, 0.1);

/// The Cornell box, solved by hemicubes of 256.
pub fn solved() -> &'static Solution {
    static SOLVED: OnceLock<Solution> = OnceLock::new();
    SOLVED.get_or_init(|| {
        let scene = built_in("cornell").expect("`cornell` is built in");
        let mesh = Mesh::uniform(&scene, EDGE);
        solve_on(
            &Room::of(&scene),
            &Classical::default(),
            mesh,
            &Goal::default(),
            &Work::quiet(),
        )
        .unwrap()
    })
}

fn shot(camera: Camera) -> Shot {
    Shot { camera, width: SIZE, height: SIZE, samples: 2 }
}

/// Stage 1: the elements, each in its paint.
pub fn elements() -> RgbImage {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = &solved().field.mesh;
    let shot = Shot { samples: 1, ..shot(scene.camera) };
    let items = shot.items(mesh);
    let of = |x, y| match items.seen(x, y) {
        Seen::Front(id) => paint(&scene, mesh.elements[id as usize].patch.0),
        _ => [0; 3],
    };
    let mut picture = RgbImage::new(SIZE, SIZE);
    picture.enumerate_pixels_mut().for_each(|(x, y, pixel)| pixel.0 = of(x, y));
    shot.with_mesh(picture, mesh)
}

/// Stage 2: what one element sees through its hemicube, every element in its own shade.
pub fn factors() -> RgbImage {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = &solved().field.mesh;
    let apart = |&a: &usize, &b: &usize| {
        let off = |k: usize| mesh.elements[k].polygon.centroid().distance(FROM);
        off(a).total_cmp(&off(b))
    };
    let from = (0..mesh.elements.len()).min_by(apart).expect("a mesh has elements");
    let element = &mesh.elements[from].polygon;
    let cube = Hemicube::new(mesh, 80);
    hemicube_cross(&cube, element.centroid(), element.normal(), 1, |_, _, seen| {
        match seen {
            Seen::Front(id) => {
                let shade = [1.0, 0.8, 0.6][id as usize % 3];
                let paint = paint(&scene, mesh.elements[id as usize].patch.0);
                paint.map(|c| (f64::from(c) * shade) as u8)
            }
            Seen::Back(_) => [0; 3],
            Seen::Nothing => [24, 32, 72],
        }
    })
}

/// Stage 3: one radiosity for each element.
pub fn flat() -> RgbImage {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let solution = solved();
    shot(scene.camera).flat(&solution.field.mesh, &solution.radiosity).display(1.0)
}

/// Stage 4: the picture for one of the eyes.
pub fn smooth(eye: usize) -> RgbImage {
    let solution = solved();
    let shot = shot(eyes()[eye]);
    shot.smooth(&solution.field.mesh, &solution.vertex_radiosity).display(1.0)
}

/// Three eyes: the scene's own, one from the right and above, one inside on the floor.
pub fn eyes() -> [Camera; 3] {
    let [own, moved] = light::assumptions::cameras();
    let inside = Camera {
        eye: dvec3(0.5, 0.08, 0.04),
        target: dvec3(0.2, 0.25, 0.45),
        fov: 75.0,
        ..own
    };
    [own, moved, inside]
}

/// The caption of the opening picture.
pub fn caption() -> String {
    format!(
        "Scene <code>cornell</code>, {} elements with edges up to {EDGE} m, form \
         factors by hemicubes of 256, exposure 1.",
        solved().field.mesh.elements.len()
    )
}

/// The caption of the three eyes.
pub fn eyes_caption() -> String {
    let (solve, picture) = (super::cost::solve_share(), super::cost::picture_share());
    format!(
        "One solution, three eyes. On a mesh of {} elements, all that is done once \
         takes {solve:.1} s, and a picture of 512 × 512 pixels {picture:.0} ms.",
        super::cost::shown()
    )
}

/// The ledger of the solution.
pub fn ledger() -> String {
    ledger::table(solved())
}
