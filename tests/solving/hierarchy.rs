//! Hierarchical radiosity: its laws and exact tables. (How it fails:
//! `tests/stability/links.rs`.)

use crate::common::cases;
use crate::common::rooms::{box_walls, face_means, gathered, rectangle, scene};
use glam::{DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::Rgb;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::Enclosure;
use radiosity::solve::hierarchy::{
    Hierarchical, Hierarchy, HierarchyOptions, solve_hierarchy,
};

fn solved(scene: &Scene, error: f64) -> Hierarchical {
    let options = HierarchyOptions::aiming_at(error, scene);
    solve_hierarchy(scene, &options, &|_, _, _| {})
}

/// A unit cube of reflectance ρ whose top emits 1 W/m².
fn lit_cube(rho: f64) -> Scene {
    let walls = box_walls([1.0; 3]).into_iter().enumerate();
    scene(walls.map(|(w, wall)| (wall, f64::from(u8::from(w == 5)), rho)))
}

fn area_norm(mesh: &Enclosure, x: impl IntoIterator<Item = Rgb>) -> f64 {
    mesh.norm_squared(x).max_element().sqrt()
}

/// The furnace: all is `E/(1 − ρ)`; undivided to the accuracy of the factors, divided to
/// the error asked for.
#[test]
fn the_furnace_glows_evenly() {
    for rho in [0.1, 0.5, 0.9] {
        let furnace = scene(box_walls([1.0, 2.0, 0.7]).map(|wall| (wall, 1.0, rho)));
        let glow = 1.0 / (1.0 - rho);
        let off = |found: &Hierarchical| {
            let off = |b: &Rgb| (b.x / glow - 1.0).abs();
            found.radiosity.iter().map(off).fold(0.0, f64::max)
        };
        let mut whole =
            Hierarchy::new(&furnace, HierarchyOptions::aiming_at(1.0, &furnace));
        whole.solve(1e-10);
        assert!(off(&whole.finish(&furnace)) < 1e-5 * glow);
        let found = solved(&furnace, 0.05);
        assert!(found.links > 30, "nothing was divided");
        let enclosure = Enclosure::of(&furnace, &found.mesh);
        let wrong = found.radiosity.iter().map(|&b| b - Rgb::splat(glow));
        let all = found.radiosity.iter().map(|&b| b - Rgb::ONE);
        let error = area_norm(&enclosure, wrong) / area_norm(&enclosure, all);
        assert!(error < 0.05, "{rho}: {error}");
    }
}

/// In a closed room with one reflectance `Σ A B (1 − ρ) = Φ`; nothing escapes, exactly.
#[test]
fn a_closed_room_keeps_its_energy() {
    for (rho, error) in [(0.5, 0.04), (0.8, 0.04), (0.5, 0.02)] {
        let found = solved(&lit_cube(rho), error);
        let enclosure = Enclosure::of(&lit_cube(rho), &found.mesh);
        let kept = enclosure.power(found.radiosity.iter().copied()) * (1.0 - rho);
        assert!((kept.x - 1.0).abs() < 0.5 * error, "{rho} {error}: {kept}");
        assert_eq!(found.ledger.escaped, Rgb::ZERO);
        assert!(found.ledger.worst_imbalance() < 0.5 * error, "{:?}", found.ledger);
        assert!(found.solver_residual < 0.1 * error);
    }
}

/// What leaves an open scene is counted, by rays, not inferred.
#[test]
fn what_escapes_is_counted() {
    for name in ["facing-squares", "cornell-regular"] {
        let found = solved(&built_in(name).unwrap(), 0.05);
        let ledger = found.ledger;
        assert!(ledger.escaped.x > 0.1 * ledger.emitted.x, "{name}: {ledger:?}");
        assert!(ledger.worst_imbalance() < 0.02, "{name}: {ledger:?}");
    }
}

/// Face means of boxes against a converged solution of the continuous equation.
#[test]
fn boxes_meet_the_continuous_truth() {
    for case in cases("C_continuous") {
        let numbers = |v: &serde_json::Value| -> Vec<f64> {
            v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
        };
        let dims = numbers(&case["params"]["dims"]).try_into().unwrap();
        let (e, rho) = (numbers(&case["E"]), numbers(&case["rho"]));
        let walls = box_walls(dims).into_iter().zip(e.iter().zip(&rho));
        let scene = scene(walls.map(|(wall, (&e, &rho))| (wall, e, rho)));
        let truth = numbers(&case["expected"]["B_face_mean"]);
        let found = solved(&scene, 0.02);
        let means = face_means(&scene, &found.mesh, &found.radiosity);
        let areas = scene.face_areas();
        let square = |of: &dyn Fn(usize) -> f64| -> f64 {
            (0..6).map(|k| areas[k] * of(k).powi(2)).sum()
        };
        let error = square(&|k| means[k].x - truth[k]);
        let error = (error / square(&|k| truth[k] - e[k])).sqrt();
        assert!(error < 0.01, "{}: {error}", case["id"]);
    }
}

/// The regular Cornell box against an independent solution: 1 % of the face means.
#[test]
fn the_cornell_box_is_within_a_per_cent() {
    let scene = built_in("cornell-regular").unwrap();
    let found = solved(&scene, 0.02);
    let means = face_means(&scene, &found.mesh, &found.irradiance);
    let areas = scene.face_areas();
    let tables = cases("F_cornell_radiosity");
    for (channel, table) in tables[..2].iter().enumerate() {
        let expected = table["expected"]["irradiance_face_mean"].as_object().unwrap();
        let (mut error, mut light) = (0.0, 0.0);
        for (name, k) in expected.keys().zip(0..) {
            let expected = expected[name].as_f64().unwrap();
            error += areas[k] * (means[k][channel] - expected).powi(2);
            light += areas[k] * expected.powi(2);
        }
        let error = (error / light).sqrt();
        assert!(error < 0.01, "channel {channel}: {error}");
    }
}

/// On its own mesh the hierarchy finds what the full matrix finds, round the corner of
/// the L-shaped room and past the blocks of the Cornell box.
#[test]
fn the_full_matrix_says_the_same() {
    for name in ["l-room", "cornell-regular"] {
        let scene = built_in(name).unwrap();
        let found = solved(&scene, 0.08);
        let enclosure = Enclosure::of(&scene, &found.mesh);
        let tolerance = 0.02 / found.mesh.elements.len() as f64;
        let method = Analytic::new(&scene, &found.mesh, tolerance, 0);
        let matrix = method.without_losses().matrix(&|| ());
        let full = gathered(&enclosure, &matrix, 1e-4, 1000);
        let apart = full.iter().zip(&found.radiosity).map(|(&a, &b)| a - b);
        let light = full.iter().zip(&enclosure.emission).map(|(&b, &e)| b - e);
        let error = area_norm(&enclosure, apart) / area_norm(&enclosure, light);
        assert!(error < 0.08, "{name}: {error}");
    }
}

/// Links grow no faster than elements: slope ≤ 1.1 on log–log paper. And they are few.
#[test]
fn links_grow_linearly() {
    for (scene, most) in
        [(lit_cube(0.5), 12), (built_in("cornell-regular").unwrap(), 8)]
    {
        let counts = [0.1, 0.02].map(|error| {
            let found = solved(&scene, error);
            (found.mesh.elements.len(), found.links)
        });
        let [(few, links_of_few), (many, links_of_many)] = counts;
        let ratio = |a: usize, b: usize| (b as f64 / a as f64).ln();
        let slope = ratio(links_of_few, links_of_many) / ratio(few, many);
        assert!(few >= 400 && many > 10 * few, "{counts:?}");
        assert!(slope <= 1.1, "{slope}: {counts:?}");
        assert!(links_of_many < most * many, "{counts:?}");
    }
}

/// The same bits at any number of threads.
#[test]
fn threads_change_nothing() {
    let scene = built_in("cornell-regular").unwrap();
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| solved(&scene, 0.05))
    };
    let (one, many) = (with(1), with(4));
    assert_eq!(one.radiosity, many.radiosity);
    assert_eq!(one.vertex_radiosity, many.vertex_radiosity);
    assert_eq!((one.ledger, one.links), (many.ledger, many.links));
}

/// No light, no partner, no area to speak of, far too few elements allowed: answers all
/// the same, and none is negative or NaN.
#[test]
fn strange_scenes_have_answers() {
    let square = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let strip = rectangle(dvec3(0.0, 0.0, 0.5), 1e-5 * DVec3::Y, DVec3::X);
    let dark = box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5));
    let black = box_walls([1.0; 3]).map(|wall| (wall, 1.0, 0.0));
    for faces in [
        vec![(square.clone(), 1.0, 0.5)],
        vec![(square.clone(), 1.0, 0.5), (strip, 1.0, 0.5)],
        dark.to_vec(),
        black.to_vec(),
    ] {
        let scene = scene(faces);
        let found = solved(&scene, 0.05);
        let light = found.radiosity.iter().chain(&found.irradiance);
        for b in light.chain(&found.vertex_radiosity) {
            assert!(b.is_finite() && b.min_element() >= 0.0, "{b}");
        }
        assert!(found.solver_residual <= 0.01, "{}", found.solver_residual);
    }
    let scene = lit_cube(0.5);
    let options = HierarchyOptions::aiming_at(0.001, &scene);
    let options = HierarchyOptions { most_elements: 300, ..options };
    let found = solve_hierarchy(&scene, &options, &|_, _, _| {});
    assert!((200..=303).contains(&found.mesh.elements.len()));
}
