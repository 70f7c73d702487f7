//! Rows 43 to 45: who looks at points, and links between pieces.

use super::super::rooms::{black, box_walls, rectangle, scene};
use super::super::{Found, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::exchange;
use radiosity::form_factor::{Obstruction, estimate};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::occlusion::Blockers;
use radiosity::solve::hierarchy::{Forest, Hierarchy, HierarchyOptions, NodeId};

/// The side of the card of row 43, m.
const CARD: f64 = 0.1;

/// Row 43: a card slides over a floor of 1 m below a lamp that is nearly a point, so
/// low that all its shadow falls on the floor: what it takes from the floor is what it
/// gets.
pub fn blind_points() -> Sweep {
    let floor = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let lamp = rectangle(dvec3(0.49, 0.49, 1.0), 0.02 * DVec3::Y, 0.02 * DVec3::X);
    // Something must hang beside the card, so that there is a shaft without it, too.
    let all = |card: Option<Polygon>| {
        let base = rectangle(-DVec3::Z, DVec3::X, DVec3::Y);
        let things = [floor.clone(), lamp.clone(), base];
        Blockers::of(&black(things.into_iter().chain(card)))
    };
    let open = estimate(&floor, &lamp, &all(None), Obstruction::Partial).mean;
    let places = [0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.43, 0.47, 0.5];
    // In per cent of the open factor: what points miss, how far the link is trusted to
    // be off, and what is missing.
    let at = |x: f64| {
        let corner = dvec3(x - 0.5 * CARD, 0.5 - 0.5 * CARD, 0.02);
        let card = rectangle(corner, CARD * DVec3::X, CARD * DVec3::Y);
        let seen =
            estimate(&floor, &lamp, &all(Some(card.clone())), Obstruction::Partial);
        // What reaches the card from above, of what reaches the floor.
        let taken = exchange(&card, &lamp, 1e-9) / exchange(&floor, &lamp, 1e-9);
        [1.0 - seen.mean / open, seen.bend / open, taken].map(|share| 100.0 * share)
    };
    let found: Vec<[f64; 3]> = places.iter().map(|&x| at(x)).collect();
    let line = |of: usize| -> Vec<[f64; 2]> {
        places.iter().zip(&found).map(|(&x, f)| [x, f[of]]).collect()
    };
    Sweep {
        knob: "where the card is, m (a point looks from 0.11 and 0.5)",
        quantity: "share of the light, %",
        logarithmic: [false, false],
        found: vec![
            Found { method: "hidden, by nine points", points: line(0) },
            Found { method: "doubt of the link (ours)", points: line(1) },
        ],
        theory: line(2),
        law: "hidden: what falls on the card",
    }
}

/// By how much the factor from a floor to a wall on its edge is bent, both squares of
/// one size.
fn bend(size: f64) -> f64 {
    let blockers = Blockers::of(&black(box_walls([1.0; 3])));
    let floor = rectangle(DVec3::ZERO, size * DVec3::X, size * DVec3::Y);
    let wall = rectangle(DVec3::ZERO, size * DVec3::Y, size * DVec3::Z);
    estimate(&floor, &wall, &blockers, Obstruction::Free).bend
}

/// Row 44.
pub fn contacts() -> Sweep {
    let sizes: [f64; 10] = std::array::from_fn(|k| 0.5_f64.powi(k as i32));
    let one = bend(1.0);
    Sweep {
        knob: "side of two squares that share an edge, m",
        quantity: "what asks for refinement / of squares of 1 m",
        logarithmic: [true, true],
        found: vec![
            Found::over("error of the factor", &sizes, |s| bend(s) / one),
            Found::over("error of the power, with the area (ours)", &sizes, |s| {
                s * s * bend(s) / one
            }),
        ],
        theory: curve(&sizes, |_| 1.0),
        law: "similar figures have the same factors",
    }
}

/// A unit cube of reflectance ρ whose top emits 1 W/m².
pub fn lit_cube(rho: f64) -> radiosity::scene::Scene {
    let walls = box_walls([1.0; 3]).into_iter().enumerate();
    scene(walls.map(|(w, wall)| (wall, f64::from(u8::from(w == 5)), rho)))
}

/// A long room with a pentagon, a triangle and a crooked quadrilateral in it: the last
/// is cut into pieces that are not of one size.
pub fn odd_shapes() -> Hierarchy {
    let corner = |k: f64| {
        let (s, c) = (k * std::f64::consts::TAU / 5.0).sin_cos();
        dvec3(0.3 * c + 0.5, 0.3 * s + 0.5, 0.5)
    };
    let pentagon = Polygon::new([0., 1., 2., 3., 4.].map(corner).to_vec()).unwrap();
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z];
    let triangle = Polygon::new(vec![0.1 * z, x + 0.1 * z, y + 0.1 * z]).unwrap();
    let crooked = [2.0 * x, 2.9 * x, 2.5 * x + 0.5 * y, 2.0 * x + 0.9 * y];
    let crooked = Polygon::new(crooked.map(|v| v + 0.2 * z).to_vec()).unwrap();
    let walls =
        box_walls([3.0, 1.0, 1.0]).into_iter().chain([pentagon, crooked, triangle]);
    let scene = scene(walls.enumerate().map(|(k, p)| (p, (k % 2) as f64, 0.6)));
    Hierarchy::new(&scene, HierarchyOptions::aiming_at(0.02, &scene))
}

fn area(forest: &Forest, id: NodeId) -> f64 {
    forest.node(id).polygon.area()
}

/// What the elements send, W.
pub fn sent_by_elements(forest: &Forest) -> Rgb {
    forest.leaves().map(|id| area(forest, id) * forest.radiosity(id)).sum()
}

/// What the roots send, W, when a node's radiosity is `of` it.
pub fn sent_by_roots(forest: &Forest, of: impl Fn(NodeId) -> Rgb) -> Rgb {
    (0..forest.roots as u32).map(NodeId).map(|id| area(forest, id) * of(id)).sum()
}

/// The wrong way up: the mean of the children, however large each is.
fn plain_mean(forest: &Forest, id: NodeId) -> Rgb {
    let node = forest.node(id);
    let n = node.children.len() as f64;
    if node.is_leaf() {
        return forest.radiosity(id);
    }
    node.children.clone().map(|c| plain_mean(forest, NodeId(c)) / n).sum()
}

/// Row 45. Rounding is at most half of 2⁻⁵² for each element that is summed.
pub fn push_and_pull() -> Sweep {
    let mut hierarchy = odd_shapes();
    let (mut ours, mut plain, mut rounding) = (Vec::new(), Vec::new(), Vec::new());
    for error in [0.4, 0.2, 0.1, 0.07, 0.05] {
        hierarchy.solve(0.1 * error);
        hierarchy.refine(error);
        hierarchy.solve(0.1 * error);
        let (forest, n) = (hierarchy.forest(), hierarchy.elements() as f64);
        let all = sent_by_elements(forest);
        let off = |by_roots: Rgb| ((by_roots - all) / all).abs().max_element();
        // A logarithmic scale has no place for 0.
        let of_ours = off(sent_by_roots(forest, |id| forest.radiosity(id))).max(1e-17);
        ours.push([n, of_ours]);
        plain.push([n, off(sent_by_roots(forest, |id| plain_mean(forest, id)))]);
        rounding.push([n, 0.5 * n * f64::EPSILON]);
    }
    Sweep {
        knob: "elements",
        quantity: "power that is lost or made on the way up, share",
        logarithmic: [true, true],
        found: vec![
            Found { method: "mean of the children", points: plain },
            Found { method: "by their areas (ours)", points: ours },
        ],
        theory: rounding,
        law: "rounding: half of 2⁻⁵² an element",
    }
}
