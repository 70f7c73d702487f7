//! The hemicube's cousins, its error budget, and what all of them share.

use crate::common::rooms::rectangle;
use crate::common::shapes::{cube, mesh_of};
use glam::{DVec3, dvec2, dvec3};
use radiosity::form_factor::hemicube::{
    CubeFace, Hemicube, Weights, aliasing_error, resolution_for,
};
use radiosity::form_factor::pictures::{Pictures, unseen_by_plane};
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::geometry::Frame;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::radiometry::{projected_solid_angle, solid_angle_of_corner};
use radiosity::random::Stream;
use radiosity::raster::{ItemBuffer, Seen};
use std::f64::consts::{PI, TAU};

/// The weight of a cell is a form factor: Lambert's formula gives the closed forms.
#[test]
fn weights_are_form_factors_of_cells() {
    let n = 16;
    let weights = Weights::exact(n);
    let frame = Frame { x: DVec3::X, y: DVec3::Y, z: DVec3::Z };
    for face in CubeFace::ALL {
        let (view, (_, rows)) = (face.view(DVec3::ZERO, &frame), face.size(n));
        let step = (2.0 / f64::from(n), 2.0 / f64::from(rows));
        for (k, weight) in weights.of(face).iter().enumerate() {
            let (x, y) = (k as u32 % n, k as u32 / n);
            let corner = |u: u32, v: u32| {
                let x = f64::from(x + u) * step.0 - 1.0;
                view.direction(dvec2(x, 1.0 - f64::from(y + v) * step.1))
            };
            let cell = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            let factor = projected_solid_angle(DVec3::ZERO, DVec3::Z, &cell) / PI;
            assert!((factor - weight).abs() < 1e-15, "{face:?} {k}: {factor} {weight}");
        }
    }
}

#[test]
fn the_tetrahedron_sees_all_there_is() {
    let mesh = mesh_of(&cube(), 9.0);
    for resolution in [2, 3, 16, 255, 512] {
        let pictures = Pictures::tetrahedron(&mesh, resolution);
        let sum: f64 = pictures.weights().flatten().sum();
        assert!((sum - 1.0).abs() < 1e-12, "{resolution}: {sum}");
        for weights in pictures.weights() {
            // All three alike; half the cells, those above the diagonal, see something.
            let of_one: f64 = weights.iter().sum();
            assert!((of_one - 1.0 / 3.0).abs() < 1e-12, "{resolution}: {of_one}");
            let seeing = weights.iter().filter(|w| **w > 0.0).count() as u32;
            assert_eq!(seeing, resolution * (resolution - 1) / 2);
        }
    }
}

#[test]
fn rows_of_the_tetrahedron_sum_to_one_in_a_closed_room() {
    let mesh = mesh_of(&cube(), 0.26);
    let straight = Pictures::tetrahedron(&mesh, 96);
    let turned = Pictures::tetrahedron(&mesh, 96).turned(7);
    for method in [straight, turned] {
        let mut row = vec![0.0; mesh.elements.len()];
        for id in 0..mesh.elements.len() {
            let lost = method.row(ElementId(id as u32), &mut row);
            let sum: f64 = row.iter().sum();
            assert!((sum - 1.0).abs() < 1e-12, "row {id} sums to {sum}");
            assert_eq!(lost, Lost::default(), "row {id}");
        }
    }
}

/// Every case of the table, by cells as fine as those of the hemicube's own test.
#[test]
fn cousins_meet_the_table_of_polygons() {
    for case in &crate::common::cases("A_point_polygon") {
        let mesh = mesh_of(&[crate::common::polygon(&case["B"])], 1e9);
        let (point, normal) = (
            crate::common::point(&case["point"]),
            crate::common::point(&case["normal"]).normalize(),
        );
        let expected = case["expected"]["F_dA_B"].as_f64().unwrap();
        let mut row = [0.0];
        Pictures::tetrahedron(&mesh, 768).turned(1).at(point, normal, &mut row);
        let got = row[0];
        assert!((got - expected).abs() < 1e-3, "{}: {got}, not {expected}", case["id"]);
        // The plane sees all but what passes by; never more than there is.
        let plane = Pictures::single_plane(&mesh, 768, 8.0).turned(1);
        plane.at(point, normal, &mut row);
        let (got, most) = (row[0], expected + 3e-3);
        let least = expected - unseen_by_plane(8.0) - 3e-3;
        assert!((least..most).contains(&got), "{}: {got} of {expected}", case["id"]);
    }
}

/// What [`aliasing_error`] promises, over a hundredfold of sizes in cells.
#[test]
fn the_budget_for_aliasing_holds() {
    for (resolution, size) in [
        (32, 0.02),
        (32, 0.1),
        (64, 0.05),
        (64, 0.1),
        (128, 0.1),
        (128, 0.2),
        (256, 0.2),
    ] {
        let (promised, got) =
            (aliasing_error(resolution, size), aliasing(resolution, size, 3000));
        let ratio = got / promised;
        assert!(
            (0.6..1.25).contains(&ratio),
            "{resolution} {size}: {got}, promised {promised}"
        );
    }
}

/// Root mean square of the relative error over places in the half-space and turns.
fn aliasing(resolution: u32, side: f64, places: u64) -> f64 {
    let weights = Weights::exact(resolution);
    let frame = Frame::about(DVec3::Z);
    let mut cells = ItemBuffer::new(1, 1);
    let mut random = Stream::named(2, &[resolution as u64]);
    let mut squares = 0.0;
    for _ in 0..places {
        let z = side + (1.0 - side) * random.next();
        let (around, roll) = (TAU * random.next(), TAU * random.next());
        let r = (1.0 - z * z).sqrt();
        let centre = dvec3(r * around.cos(), r * around.sin(), z);
        let facing = Frame::about(-centre);
        let a = side * (facing.x * roll.cos() + facing.y * roll.sin());
        let b = -facing.z.cross(a);
        let polygon = rectangle(centre - (a + b) / 2.0, b, a);
        let exact =
            projected_solid_angle(DVec3::ZERO, DVec3::Z, polygon.vertices()) / PI;
        let mut got = 0.0;
        for face in CubeFace::ALL {
            let (width, height) = face.size(resolution);
            cells.reset(width, height);
            cells.draw(&face.view(DVec3::ZERO, &frame), &polygon, 0);
            let seen = cells.pixels().zip(weights.of(face));
            got += seen.filter(|s| s.0 == Seen::Front(0)).map(|s| s.1).sum::<f64>();
        }
        squares += (got / exact - 1.0).powi(2);
    }
    (squares / places as f64).sqrt()
}

#[test]
fn the_resolution_follows_from_the_budget() {
    for error in [0.3, 0.03, 0.003] {
        for size in [0.01, 0.1, 1.0] {
            let resolution = resolution_for(error, size);
            assert!(
                resolution.is_multiple_of(2)
                    && aliasing_error(resolution, size) <= error
            );
            let coarser = resolution.saturating_sub(2);
            assert!(coarser == 0 || aliasing_error(coarser, size) > error);
        }
    }
    assert_eq!(resolution_for(1e-9, 1e-9), radiosity::raster::MAX_SIZE);
    assert_eq!(resolution_for(1e9, 1.0), 2);
}

/// All of the family agree on a room, each to what its cells allow.
#[test]
fn the_family_agrees() {
    let mesh: Mesh = mesh_of(&cube(), 0.34);
    let n = mesh.elements.len();
    let of = |method: &dyn FormFactors, from: u32| {
        let mut row = vec![0.0; n];
        method.row(ElementId(from), &mut row);
        row
    };
    let (half, tetra, plane) = (
        Hemicube::new(&mesh, 256),
        Pictures::tetrahedron(&mesh, 384),
        Pictures::single_plane(&mesh, 4096, 16.0),
    );
    for from in [0, 4, 13] {
        let [half, tetra, plane] =
            [&half as &dyn FormFactors, &tetra, &plane].map(|m| of(m, from));
        for j in 0..n {
            assert!((half[j] - tetra[j]).abs() < 2e-3, "{from} {j}");
            assert!((half[j] - plane[j]).abs() < 2e-3 + unseen_by_plane(16.0));
        }
    }
}

/// A hemicube's top is a plane of half-width 1: four corner rectangles, one away.
#[test]
fn a_plane_is_the_top_made_wider() {
    let top: f64 = Weights::exact(64).of(CubeFace::Top).iter().sum();
    assert!((unseen_by_plane(1.0) - (1.0 - top)).abs() < 1e-13);
    // The solid angle it misses is less: light near the horizon weighs little.
    let share = 1.0 - 4.0 * solid_angle_of_corner(1.0, 1.0, 1.0) / TAU;
    assert!(share > unseen_by_plane(1.0), "{share}");
}

#[test]
fn rows_of_cousins_do_not_depend_on_threads() {
    use rayon::prelude::*;
    let mesh = mesh_of(&cube(), 0.5);
    let method = Pictures::tetrahedron(&mesh, 48).turned(3);
    let row = |id: usize| {
        let mut row = vec![0.0; mesh.elements.len()];
        let lost = method.row(ElementId(id as u32), &mut row);
        (row, lost)
    };
    let one: Vec<_> = (0..mesh.elements.len()).map(row).collect();
    let many: Vec<_> = (0..mesh.elements.len()).into_par_iter().map(row).collect();
    assert!(one == many);
}

/// The walls are polygons that anything else could be.
#[test]
fn elements_below_the_horizon_do_not_count() {
    let below = rectangle(dvec3(-1., -1., -1.), DVec3::X * 2.0, DVec3::Y * 2.0);

    let mesh = mesh_of(&[below], 9.0);
    let mut row = [0.0];
    for resolution in [2, 63, 64] {
        let lost = Pictures::tetrahedron(&mesh, resolution).at(
            DVec3::ZERO,
            DVec3::Z,
            &mut row,
        );
        assert_eq!(row, [0.0]);
        assert!((lost.escaped - 1.0).abs() < 1e-12);
    }
}
