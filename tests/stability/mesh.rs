//! Pinned failures of meshing, row by row of the table of failures. (Rows 36 to 38, 40,
//! 41 and 46: `tests/stability/display.rs`; 43 to 45: `tests/stability/links.rs`.)

use crate::failures::meshing::fields;
use crate::failures::rooms::{
    box_walls, face_means, rectangle, rows, scene, solved_by,
};
use glam::{DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Brightest, Enclosure, Shoot};

/// Two rooms of a metre each on one floor, with a wall between them that reaches from
/// floor to ceiling; the lamp is in the left one.
fn two_rooms() -> Scene {
    let mut faces: Vec<_> =
        box_walls([2.0, 1.0, 1.0]).map(|wall| (wall, 0.0, 0.5)).to_vec();
    let across = rectangle(DVec3::X, DVec3::Y, DVec3::Z);
    faces.push((across.flipped(), 0.0, 0.5));
    faces.push((across, 0.0, 0.5));
    let lamp = rectangle(dvec3(0.3, 0.3, 1.0), DVec3::Y * 0.4, DVec3::X * 0.4);
    faces.push((lamp, 1.0, 0.0));
    scene(faces)
}

fn shot_on(scene: &Scene, mesh: &Mesh) -> Vec<Rgb> {
    let enclosure = Enclosure::of(scene, mesh);
    let matrix = Analytic::new(scene, mesh, 1e-4, 0).matrix(&|| ());
    solved_by(
        &enclosure,
        Shoot::new(&enclosure, &matrix, Brightest::ByPower),
        1e-4,
        5000,
    )
}

/// Row 35, light leak: an element that straddles a wall shows the mean of both rooms:
/// the dark half of the floor glows like the lit one. Elements that are cut along
/// contact lines leak nothing, at any fineness - not to the last digit, nor between
/// vertices.
#[test]
fn row_35_light_leaks_under_walls() {
    let scene = two_rooms();
    let leak = shot_on(&scene, &Mesh::whole(&scene))[4].x;
    let fine = Mesh::uniform(&scene, 0.2);
    // The mean over both halves.
    let lit = face_means(&scene, &fine, &shot_on(&scene, &fine))[4].x;
    assert!((leak / lit - 1.0).abs() < 0.1, "{leak} {lit}");
    for edge in [5.0, 0.4, 0.3] {
        let mesh = Mesh::uniform(&scene, edge);
        let radiosity = shot_on(&scene, &mesh);
        let vertices = mesh.vertex_values(&radiosity);
        let mut dark = 0;
        for (element, b) in mesh.elements.iter().zip(&radiosity) {
            let polygon = &element.polygon;
            let side = polygon.centroid().x - 1.0;
            let right = side > 1e-9 || (side.abs() < 1e-9 && polygon.normal().x > 0.5);
            let shown = element.corners.iter().map(|c| vertices[c.0 as usize]);
            if right {
                assert!(*b == Rgb::ZERO && shown.into_iter().all(|b| b == Rgb::ZERO));
                dark += 1;
            }
        }
        assert!(dark > 4);
    }
}

/// Row 39: where a corner of one element lies on an edge of another, rounding leaves a
/// crack no wider than itself - and a cell whose centre falls into it shows nothing. In
/// the L-shaped room, whose pieces are meshed each by itself, a hemicube in ten has
/// such a hole, one cell of thousands; in a cube, where corners meet corners, none has.
#[test]
fn row_39_t_vertices_leave_holes() {
    let holes = |name: &str, resolution: u32| {
        let scene = built_in(name).unwrap();
        let mesh = Mesh::uniform(&scene, scene.diagonal() / 5.0);
        let lost =
            rows(&Hemicube::new(&mesh, resolution)).into_iter().map(|(_, l)| l.escaped);
        let lost: Vec<f64> = lost.filter(|l| *l > 0.0).collect();
        (lost.len(), lost.into_iter().fold(0.0, f64::max))
    };
    for resolution in [64, 128, 256] {
        let (count, worst) = holes("l-room", resolution);
        assert!(
            (1..=6).contains(&count) && worst < 1e-4,
            "{resolution}: {count} {worst}"
        );
        assert_eq!(holes("furnace", resolution), (0, 0.0));
    }
}

/// Row 39: where two small elements meet a large one, the T-vertex is shown as the
/// large one's edge has it; with a value of its own it would jump by h² B''/8.
#[test]
fn row_39_t_vertices_tear_the_field_unless_they_are_anchored() {
    let sweep = fields::torn();
    for &[h, expected] in &sweep.theory {
        assert!((sweep.at(h) - expected).abs() < 1e-12, "{h}: {}", sweep.at(h));
        assert!(sweep.by(1, h) < 1e-14, "{h}: {}", sweep.by(1, h));
    }
    assert_eq!(sweep.at(0.5), 0.0625);
    let (mesh, [_, anchored]) = fields::split_corner(0.5);
    assert_eq!(mesh.t_vertices().count(), 2);
    // From both sides of the edge, the anchored field is one.
    let at = |x: f64, y: f64, side: DVec3| {
        let p = dvec3(x, y, 0.0);
        let holds = |e: &&radiosity::mesh::Element| e.polygon.contains(p + side, 0.0);
        let element = mesh.elements.iter().find(holds).unwrap();
        mesh.value_at(element, p, &anchored).x
    };
    for k in 0..=20 {
        let y = 0.5 * k as f64 / 20.0 * 0.999 + 1e-4;
        let step = dvec3(1e-9, 0.0, 0.0);
        assert!((at(0.5, y, -step) - at(0.5, y, step)).abs() < 1e-12);
    }
}

/// Row 42: at an edge of a cube three walls of three brightnesses meet; none takes from
/// the others. Over the edge it would be half of the step.
#[test]
fn row_42_no_mean_over_a_corner() {
    let scene = scene(box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5)));
    let mesh = Mesh::uniform(&scene, 0.25);
    let own = |k: u32| Rgb::splat(1.0 + k as f64);
    let values: Vec<Rgb> = mesh.elements.iter().map(|e| own(e.patch.0)).collect();
    let vertices = mesh.vertex_values(&values);
    for element in &mesh.elements {
        for corner in &element.corners {
            let off = vertices[corner.0 as usize] - own(element.patch.0);
            assert!(off.abs().max_element() < 1e-14);
        }
    }
    // One material all over, and yet no vertex is shared between walls: 6 × 5 × 5.
    assert_eq!(mesh.vertices.len(), 150);
    let sweep = fields::over_the_corner();
    for &[top, expected] in &sweep.theory {
        assert!((sweep.at(top) - expected).abs() < 1e-14, "{top}");
        assert!(sweep.by(1, top) < 1e-14, "{top}");
    }
}
