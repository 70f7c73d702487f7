//! Pinned failures of shooting, row by row of the table of failures: each asserts the
//! wrong answer and how wrong it is, or that the trap is avoided.

use crate::common::shots::steps;
use crate::failures::rooms::{box_walls, exact_factors, scene, solved_by};
use crate::failures::solver::shots::{
    Ahead, bounded, counted_twice, overshooting, shot_ahead, specks_first,
    through_walls,
};
use crate::failures::solver::sweeps::{lit_cube, total};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::{Brightest, Enclosure, Shoot};

/// Row 50: who is the brightest? A large wall lamp holds most of the light, forty
/// specks are each five times as bright. By radiosity the specks go first: after forty
/// shots 99 % of the light has not moved; by power, 13 %.
#[test]
fn row_50_small_patches_shoot_too_early() {
    let sweep = specks_first();
    for &[shots, expected] in &sweep.theory {
        // The specks' own light comes back to them, a little.
        assert!((sweep.at(shots) - expected).abs() < 1e-3, "{shots}");
    }
    let (radiosity, power) = (sweep.at(40.0), sweep.by(1, 40.0));
    assert!((10.0..15.0).contains(&power) && radiosity > 98.0, "{power} {radiosity}");
}

/// Row 51: shown with its ambient term, a closed room of one reflectance has all of its
/// light, `Φ/(1 − ρ)`, after every shot; put into the result, the term is counted again
/// when its light arrives.
#[test]
fn row_51_ambient_light_counts_once() {
    let sweep = counted_twice();
    for &[shots, twice] in &sweep.theory {
        let [kept, shown, bare] = [0, 1, 2].map(|by| sweep.by(by, shots));
        assert!((shown - 1.0).abs() < 1e-9, "{shots}: {shown}");
        assert!((kept - bare - (twice - 1.0)).abs() < 1e-9, "{shots}: {kept} {bare}");
    }
    assert!(sweep.by(2, 20.0) < 0.7 && (sweep.at(200.0) - 1.7).abs() < 0.01);
    let (enclosure, matrix) = lit_cube(2, 0.7);
    let solver = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
    let end = solved_by(&enclosure, solver, 1e-9, 100_000);
    assert!((total(&enclosure, &end) * 0.3 - 1.0).abs() < 1e-7);
}

/// Row 52: two rooms without a door. Ambient light shines in the dark one; the solution
/// leaves it dark.
#[test]
fn row_52_ambient_light_passes_walls() {
    let sweep = through_walls();
    for &[edge, expected] in &sweep.theory {
        assert!((sweep.at(edge) / expected - 1.0).abs() < 1e-6, "{edge}");
        assert_eq!(sweep.by(1, edge), 0.0);
    }
    assert!((sweep.at(1.0) - 0.041_667).abs() < 1e-6);
}

/// Row 53: two facing squares that reflect 0.99. Who shoots ahead as the ambient term
/// of a closed room has it sends a hundred times what will come back; the debt is sent
/// back, and so on: ten thousand times more with each ten shots. The same guess within
/// the safe bound converges; so does anything below twice the unshot light, and nothing
/// above.
#[test]
fn row_53_overshooting_without_bound_explodes() {
    let growth = |short: Ahead, long: Ahead| long.owed / short.owed;
    let unbounded = |shots| shot_ahead(shots, |unshot, ambient| unshot + ambient);
    let grown = growth(unbounded(20), unbounded(40));
    assert!((1e6..1e10).contains(&grown), "{grown:e}");
    assert!(shot_ahead(3000, bounded).residual < 1e-4);
    let above = |shots| shot_ahead(shots, |u, _| 2.1 * u);
    let grown = growth(above(300), above(400));
    assert!((1e3..1e6).contains(&grown), "{grown:e}");
    assert!(shot_ahead(10_000, |u, _| 1.9 * u).residual < 1e-4);
    let sweep = overshooting();
    for (long, short) in sweep.found[0].points.iter().zip(&sweep.found[1].points) {
        assert_eq!(long[1] > short[1], long[0] > 2.0, "{long:?} {short:?}");
    }
}

/// Row 53, the better half: in a room like others half of the shots are saved; where
/// light lasts long, nearly all.
#[test]
fn row_53_half_of_the_shots_are_saved() {
    let walls = || box_walls([1.0; 3]).into_iter().enumerate();
    for (rho, gain) in [(0.5, 2.0..3.0), (0.9, 9.0..13.0), (0.99, 40.0..60.0)] {
        let lit = |wall: usize| f64::from(u8::from(wall == 5));
        let scene = scene(walls().map(|(k, wall)| (wall, lit(k), rho)));
        let mesh = Mesh::uniform(&scene, 0.25);
        let enclosure = Enclosure::of(&scene, &mesh);
        let [shoot, overshoot] = steps(&enclosure, &exact_factors(&mesh));
        let ratio = shoot as f64 / overshoot as f64;
        assert!(gain.contains(&ratio), "{rho}: {shoot} {overshoot}");
    }
    let scene = built_in("cornell").unwrap();
    let mesh = Mesh::uniform(&scene, 0.1);
    let matrix = Analytic::new(&scene, &mesh, 1e-4, 0).matrix(&|| ());
    let [shoot, overshoot] = steps(&Enclosure::of(&scene, &mesh), &matrix);
    let ratio = shoot as f64 / overshoot as f64;
    assert!((1.5..2.0).contains(&ratio), "{shoot} {overshoot}");
}
