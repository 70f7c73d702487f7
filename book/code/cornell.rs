//! The Cornell box, solved and seen: the picture on the first page.

use radiosity::room::Room;
use radiosity::solution::Goal;
use radiosity::work::Work;

use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::film::{RgbImage, Shot};
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solution::solve_on;

/// Longest edge of an element, in metres.
const MAX_EDGE: f64 = 0.05;

/// The box as its camera sees it, `size` pixels square, at an exposure of 1.
pub fn picture(size: u32) -> RgbImage {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, MAX_EDGE);
    let method = Classical::by(Factors::Analytic);
    let solution =
        solve_on(&Room::of(&scene), &method, mesh, &Goal::default(), &Work::quiet())
            .unwrap();
    let shot = Shot { camera: scene.camera, width: size, height: size, samples: 3 };
    shot.smooth(&solution.field.mesh, &solution.vertex_radiosity).display(1.0)
}
