//! Extended form factors: laws, doubled rooms, and each method against the exact one.

use crate::common::cases;
use crate::common::mirrored::{diffuse, mirror, pane, scene_of};
use crate::common::rooms::{box_walls, exact_factors, gathered, rectangle, rows};
use glam::{DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::Coefficients;
use radiosity::mesh::Mesh;
use radiosity::scene::Scene;
use radiosity::solve::Enclosure;
use radiosity::virtual_world::{
    ExtendedAnalytic, ExtendedCast, ExtendedHemicube, VirtualWorld,
};

/// A room with a mirror on the wall, one on the floor beside it, and a table between.
fn furnished(share: f64) -> Scene {
    let walls = box_walls([2.0, 2.0, 2.0]);
    let mut faces: Vec<(Polygon, Coefficients)> =
        walls.into_iter().map(|w| (w, diffuse(0.0, 0.5))).collect();
    let picture = rectangle(dvec3(0.0, 0.4, 0.6), 1.2 * DVec3::Y, 1.0 * DVec3::Z);
    faces.push((picture, mirror(share)));
    let other = rectangle(dvec3(0.3, 2.0, 0.3), 1.4 * DVec3::X, 1.2 * DVec3::Z);
    faces.push((other, mirror(0.7 * share)));
    let table = rectangle(dvec3(0.8, 0.7, 0.5), 0.5 * DVec3::X, 0.5 * DVec3::Y);
    faces.push((table.clone(), diffuse(0.0, 0.5)));
    faces.push((table.flipped(), diffuse(0.0, 0.5)));
    scene_of(faces)
}

/// `Σ F + absorbed + escaped + cut` of each row.
fn closures(method: &dyn FormFactors) -> Vec<f64> {
    let sum = |(row, lost): (Vec<f64>, radiosity::form_factor::Lost)| {
        row.iter().sum::<f64>() + lost.absorbed + lost.escaped + lost.cut
    };
    rows(method).into_iter().map(sum).collect()
}

/// The largest `|F − F'|` between two methods, and the largest of the second.
fn apart(a: &dyn FormFactors, b: &dyn FormFactors) -> f64 {
    let mut worst = 0.0_f64;
    for ((a, _), (b, _)) in rows(a).into_iter().zip(rows(b)) {
        for (a, b) in a.into_iter().zip(b) {
            worst = worst.max((a - b).abs());
        }
    }
    worst
}

#[test]
fn extended_factors_are_reciprocal_and_closed_at_each_level() {
    let scene = furnished(0.9);
    let mesh = Mesh::whole(&scene);
    for levels in 0..3 {
        let world = VirtualWorld::of(&scene, levels);
        let method = ExtendedAnalytic::of(
            Analytic::new(&scene, &mesh, 1e-5, 0),
            &mesh,
            &world,
            0,
        );
        let matrix = method.matrix(&|| ());
        for (i, closure) in closures(&matrix).into_iter().enumerate() {
            // Black backs are counted by 2048 rays, the rest is exact.
            assert!((closure - 1.0).abs() < 4e-3, "{levels} {i}: {closure}");
        }
        let all = rows(&matrix);
        for i in 0..mesh.elements.len() {
            for j in 0..mesh.elements.len() {
                let area = |k: usize| mesh.elements[k].polygon.area();
                let (there, back) = (area(i) * all[i].0[j], area(j) * all[j].0[i]);
                assert!((there - back).abs() < 1e-14, "{i} {j} {there} {back}");
            }
        }
        // Row by row, from the other side, the same is found.
        let off = apart(&method, &matrix);
        assert!(off < 1e-5, "{levels}: {off:e}");
    }
}

/// By rays and by hemicubes every share is booked to rounding, panes among them.
#[test]
fn nothing_is_lost_of_what_rays_and_hemicubes_send() {
    let mut faces: Vec<(Polygon, Coefficients)> =
        box_walls([2.0; 3]).into_iter().map(|w| (w, diffuse(0.0, 0.5))).collect();
    faces[0].1 = mirror(0.9);
    faces[5].1 = Coefficients { diffuse: Rgb::splat(0.3), ..mirror(0.6) };
    for x in [0.9, 1.1] {
        faces
            .push((rectangle(dvec3(x, 0.2, 0.2), DVec3::Y, 1.5 * DVec3::Z), pane(1.5)));
    }
    faces.remove(3); // open
    let scene = scene_of(faces);
    let mesh = Mesh::whole(&scene);
    for levels in 0..4 {
        let world = VirtualWorld::of(&scene, levels);
        let by_rays = ExtendedCast::new(&mesh, &world, 1, 500, 3);
        let by_hemicube = ExtendedHemicube::new(&mesh, &world, 1, 32);
        for closure in closures(&by_rays).into_iter().chain(closures(&by_hemicube)) {
            assert!((closure - 1.0).abs() < 1e-12, "{levels}: {closure}");
        }
        let cut: f64 = rows(&by_rays).iter().map(|(_, lost)| lost.cut).sum();
        assert!(cut > 1e-4);
    }
}

/// The exact images, what rays find, and what hemicubes show, each within its own error:
/// √(F/rays), and a hemicube's aliasing and nearness.
#[test]
fn all_methods_find_the_same_extended_factors() {
    let scene = furnished(1.0);
    let mesh = Mesh::whole(&scene);
    let world = VirtualWorld::of(&scene, 2);
    let exact =
        ExtendedAnalytic::of(Analytic::new(&scene, &mesh, 1e-5, 0), &mesh, &world, 0)
            .matrix(&|| ());
    let rays = 40_000;
    let by_rays = ExtendedCast::new(&mesh, &world, 0, rays, 1);
    let off = apart(&by_rays, &exact);
    assert!(off < 4.0 * (0.25 / rays as f64).sqrt(), "rays: {off}");
    // A finer mesh, so that the middle of an element speaks for it.
    let mesh = Mesh::uniform(&scene, 0.5);
    let exact = ExtendedCast::new(&mesh, &world, 0, rays, 2);
    let rms = |resolution: u32| {
        let method = ExtendedHemicube::new(&mesh, &world, 0, resolution);
        let (mut sum, mut count) = (0.0, 0.0);
        for ((a, _), (b, _)) in rows(&method).into_iter().zip(rows(&exact)) {
            for (a, b) in a.into_iter().zip(b) {
                sum += (a - b) * (a - b);
                count += 1.0;
            }
        }
        f64::sqrt(sum / count)
    };
    let off = rms(128);
    assert!(off < 2.5e-3, "hemicubes: {off}");
}

/// A room with one perfect mirror wall is the doubled room, factor by factor.
#[test]
fn a_room_with_a_perfect_mirror_is_the_doubled_room() {
    let walls = box_walls([1.0, 1.5, 0.8]);
    let of = |k: usize| match k {
        0 => mirror(1.0),
        5 => diffuse(1.0, 0.8),
        k => diffuse(0.0, 0.3 + 0.1 * k as f64),
    };
    let scene = scene_of((0..6).map(|k| (walls[k].clone(), of(k))));
    let mesh = Mesh::uniform(&scene, 0.5);
    let world = VirtualWorld::of(&scene, 1);
    let method =
        ExtendedAnalytic::of(Analytic::new(&scene, &mesh, 1e-9, 0), &mesh, &world, 0);
    let matrix = method.matrix(&|| ());
    let found = gathered(&Enclosure::of(&scene, &mesh), &matrix, 1e-13, 500);

    // The same elements and their images, each a patch of the doubled room.
    let left_right = walls[0].plane().mirror();
    let whole: Vec<usize> = (0..mesh.elements.len())
        .filter(|&k| mesh.surface_of(&mesh.elements[k]) != 0)
        .collect();
    let at = |k: usize| mesh.elements[k].polygon.clone();
    let faces = whole.iter().flat_map(|&k| [at(k), at(k).moved(&left_right)]);
    let material = |k: usize| of(mesh.surface_of(&mesh.elements[k]) as usize);
    let doubled =
        scene_of(faces.zip(whole.iter().flat_map(|&k| [material(k), material(k)])));
    let doubled_mesh = Mesh::whole(&doubled);
    let exact = exact_factors(&doubled_mesh);
    for (a, &i) in whole.iter().enumerate() {
        for (b, &j) in whole.iter().enumerate() {
            let of = |row: &[(u32, f64)], j: usize| {
                row.iter().find(|f| f.0 as usize == j).map_or(0.0, |f| f.1)
            };
            let row = exact.rows()[2 * a].factors();
            let want = of(row, 2 * b) + of(row, 2 * b + 1);
            let got = of(matrix.rows()[i].factors(), j);
            assert!((got - want).abs() < 1e-10, "{i} {j}: {got} {want}");
        }
    }
    let enclosure = Enclosure::of(&doubled, &doubled_mesh);
    let want = gathered(&enclosure, &exact, 1e-13, 500);
    for (a, &i) in whole.iter().enumerate() {
        assert!((found[i] - want[2 * a]).abs().max_element() < 1e-10, "{i}");
        assert!((found[i] - want[2 * a + 1]).abs().max_element() < 1e-10, "{i}");
    }
}

/// The table's cube with a mirror wall: the radiosities.
#[test]
fn the_cube_with_a_mirror_wall_has_the_light_of_the_table() {
    let all = cases("G_mirror_glass");
    let mut done = 0;
    for case in all.iter().filter(|c| c["family"] == "mirror_room_radiosity") {
        let share = case["params"]["mirror_reflectance"].as_f64().unwrap();
        let number = |key: &str, k: usize| case["params"][key][k].as_f64().unwrap();
        let walls = box_walls([1.0; 3]);
        let of = |k: usize| match k {
            0 => mirror(share),
            k => diffuse(number("E", k - 1), number("rho", k - 1)),
        };
        let scene = scene_of((0..6).map(|k| (walls[k].clone(), of(k))));
        let mesh = Mesh::whole(&scene);
        let world = VirtualWorld::of(&scene, 1);
        let method = ExtendedAnalytic::of(
            Analytic::new(&scene, &mesh, 1e-9, 0),
            &mesh,
            &world,
            0,
        );
        let matrix = method.matrix(&|| ());
        let found = gathered(&Enclosure::of(&scene, &mesh), &matrix, 1e-14, 500);
        for k in 1..6 {
            let want = case["expected"]["B"][k - 1].as_f64().unwrap();
            assert!((found[k].x / want - 1.0).abs() < 1e-9, "{} {k}", case["id"]);
        }
        done += 1;
    }
    assert_eq!(done, 2);
}
