//! Light through translucent sheets: three solvers find it, two run steps of theirs there,
//! and the books close.

use crate::common::mirrored::{diffuse, scene_of};
use crate::common::rooms::{box_walls, rectangle};
use glam::DVec3;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::Rgb;
use radiosity::material::Coefficients;
use radiosity::mesh::Mesh;
use radiosity::scene::Scene;
use radiosity::solve::{
    Brightest, ConjugateGradients, Enclosure, GaussSeidel, Jacobi, Overshoot, Shoot,
    Solver, contraction,
};

/// A box, divided by a sheet from wall to wall; the lamp is one end wall.
fn divided(lamp: usize) -> Scene {
    let walls = box_walls([2.0, 1.0, 1.0]);
    let of = |k: usize| diffuse(if k == lamp { 1.0 } else { 0.0 }, 0.5);
    let translucence = Rgb::new(0.5, 0.3, 0.0);
    let paper = Coefficients { translucence, ..diffuse(0.0, 0.4) };
    let sheet = rectangle(DVec3::X, DVec3::Y, DVec3::Z);
    let walls = walls.into_iter().enumerate().map(|(k, w)| (w, of(k)));
    scene_of(walls.chain([(sheet, paper)]))
}

/// Behind a sheet the operator need not be positive, which conjugate gradients and
/// overshooting rest on: they say so and take the steps of Jacobi and of shooting instead,
/// one by one. The others find the same light by ways of their own.
#[test]
fn all_solvers_find_the_light_behind_a_sheet() {
    let scene = divided(0);
    let mesh = Mesh::uniform(&scene, 0.5);
    let enclosure = Enclosure::of(&scene, &mesh);
    assert!(enclosure.is_translucent());
    for (i, through) in enclosure.through.iter().enumerate() {
        let Some(through) = through else { continue };
        let [here, there] =
            [i, through.back.0 as usize].map(|k| mesh.elements[k].polygon.centroid());
        assert!(here.distance(there) < 1e-12, "the sides are split alike");
    }
    let factors = Analytic::new(&scene, &mesh, 1e-6, 0).matrix(&|| ());
    let bound = contraction(&enclosure, &factors);
    assert!(bound > 0.4 && bound < 0.95, "{bound}");
    let mut found = Vec::new();
    macro_rules! by {
        ($solver:expr) => {{
            let mut solver = $solver;
            let outcome = solver.run(bound, 1e-11, 200_000);
            assert!(outcome.converged);
            let imbalance = outcome.last.ledger.worst_imbalance();
            found.push((solver.radiosity().to_vec(), imbalance, outcome.steps));
        }};
    }
    by!(Jacobi::new(&enclosure, &factors));
    by!(GaussSeidel::new(&enclosure, &factors));
    by!(ConjugateGradients::new(&enclosure, &factors));
    by!(Shoot::new(&enclosure, &factors, Brightest::ByPower));
    by!(Overshoot::new(&enclosure, &factors));
    let [jacobi, gauss, conjugate, shoot, overshoot] = &found[..] else { panic!() };
    assert!(conjugate == jacobi && overshoot == shoot);
    assert!(gauss.2 < jacobi.2 && jacobi.2 < shoot.2);
    for (radiosity, imbalance, _) in &found {
        // Rows of exact factors sum to one within their tolerance.
        assert!(*imbalance < 1e-4, "{imbalance}");
        for (a, b) in radiosity.iter().zip(&found[0].0) {
            assert!((*a - *b).abs().max_element() < 1e-9, "{a} {b}");
        }
    }
    // Behind the sheet it is coloured as the sheet, and dark where that passes nothing.
    let behind = mesh.elements.iter().position(|e| mesh.surface_of(e) == 1).unwrap();
    let light = found[0].0[behind];
    assert!(light.x > light.y && light.y > 0.0 && light.z == 0.0, "{light}");
}

/// From either side, as much gets through.
#[test]
fn a_sheet_passes_alike_both_ways() {
    let irradiance = |lamp: usize, wall: u32| {
        let scene = divided(lamp);
        let mesh = Mesh::whole(&scene);
        let enclosure = Enclosure::of(&scene, &mesh);
        let factors = Analytic::new(&scene, &mesh, 1e-9, 0).matrix(&|| ());
        let mut solver = GaussSeidel::new(&enclosure, &factors);
        solver.run(0.95, 1e-13, 500);
        let k = mesh.elements.iter().position(|e| mesh.surface_of(e) == wall);
        solver.irradiance()[k.unwrap()]
    };
    let (there, back) = (irradiance(0, 1), irradiance(1, 0));
    assert!((there - back).abs().max_element() < 1e-9, "{there} {back}");
    assert!(there.x > 0.0);
}
