//! Overshooting: the books balance, each shot comes nearer to the solution by as much
//! as theory says, and there are no more of them. (How many fewer: row 53 of
//! `tests/stability/shooting.rs`.)

use crate::common::any::{convex_room, room};
use crate::common::rooms::{exact_factors, gathered, rows};
use crate::common::shots::steps;
use proptest::prelude::*;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{FormFactors, Matrix};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::{Enclosure, Overshoot, Solver};

/// What has been sent so far, W/m²: the estimate whose residual is the unshot light.
fn sent(solver: &Overshoot) -> Vec<Rgb> {
    let state = solver.state();
    state.radiosity().iter().zip(state.unshot()).map(|(&b, &u)| b - u).collect()
}

/// `Q = ½ Σ A/ρ e (e − ρ F e)`, the distance from the solution in the energy norm.
fn distance(enclosure: &Enclosure, matrix: &Matrix, error: &[Rgb]) -> Rgb {
    let term = |i: usize| {
        let (rho, e) = (enclosure.reflectance[i], error[i]);
        let row = matrix.rows()[i].factors();
        let arrives: Rgb = row.iter().map(|&(j, f)| f * error[j as usize]).sum();
        0.5 * enclosure.area[i] / rho * e * (e - rho * arrives)
    };
    (0..error.len()).map(term).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// After every shot the imbalance is what the shooters' rows fall short of one, of
    /// the power that they shot, and nothing else.
    #[test]
    fn every_shot_is_booked(room in prop_oneof![room(true), room(false)]) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let done = || ();
        for matrix in [
            Analytic::new(&scene, &mesh, 1e-3, 1).matrix(&done),
            Cast::new(&mesh, 100, 1).matrix(&done),
            Hemicube::new(&mesh, 32).matrix(&done),
        ] {
            let rows = rows(&matrix);
            let mut solver = Overshoot::new(&enclosure, &matrix);
            let mut expected = Rgb::ZERO;
            for _ in 0..200 {
                let before = sent(&solver);
                let Some(step) = solver.next() else { break };
                let i = step.shot.unwrap().0 as usize;
                let power = enclosure.area[i] * (sent(&solver)[i] - before[i]);
                let (row, lost) = &rows[i];
                let kept = row.iter().sum::<f64>() + lost.escaped + lost.absorbed;
                expected += power * (1.0 - kept);
                let off = (step.ledger.imbalance - expected).abs().max_element();
                prop_assert!(off <= 1e-9 * step.ledger.emitted.max_element(), "{off}");
            }
        }
    }

    /// `Q' − Q = −(A_i/ρ_i) δ (ΔB_i − δ/2)`, and never more than 0: the unshot light
    /// may grow here and there, the distance from the solution does not.
    #[test]
    fn every_shot_comes_nearer(room in convex_room(), rho in 0.05..0.99_f64) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let mut enclosure = Enclosure::of(&scene, &mesh);
        enclosure.reflectance.fill(Rgb::splat(rho));
        let matrix = exact_factors(&mesh);
        let exact = gathered(&enclosure, &matrix, 1e-13, 5_000);
        let far = |solver: &Overshoot| {
            let error: Vec<Rgb> =
                sent(solver).iter().zip(&exact).map(|(&s, &x)| s - x).collect();
            distance(&enclosure, &matrix, &error)
        };
        let mut solver = Overshoot::new(&enclosure, &matrix);
        let (mut before, start) = (far(&solver), far(&solver).max_element());
        for _ in 0..60 {
            let (unshot, was) = (solver.state().unshot().to_vec(), sent(&solver));
            let Some(step) = solver.next() else { break };
            let i = step.shot.unwrap().0 as usize;
            let amount = sent(&solver)[i] - was[i];
            let scale = enclosure.area[i] / rho;
            let expected = -scale * amount * (unshot[i] - 0.5 * amount);
            let after = far(&solver);
            prop_assert!(expected.max_element() <= 0.0, "{expected}");
            let off = (after - before - expected).abs().max_element();
            prop_assert!(off <= 1e-9 * start, "{off} of {start}");
            before = after;
        }
    }

    /// Whatever the room and the method, it ends, at what gathering finds.
    #[test]
    fn it_ends_at_the_solution(room in prop_oneof![room(true), room(false)]) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let matrix = Analytic::new(&scene, &mesh, 1e-3, 1).matrix(&|| ());
        let rho = enclosure.largest_reflectance().max_element();
        let mut solver = Overshoot::new(&enclosure, &matrix);
        prop_assert!(solver.run(rho, 1e-6, 50_000).converged);
        let exact = gathered(&enclosure, &matrix, 1e-9, 5_000);
        let largest = exact.iter().fold(0.0, |m: f64, b| m.max(b.max_element()));
        for (b, exact) in solver.radiosity().iter().zip(&exact) {
            prop_assert!((*b - *exact).abs().max_element() <= 1e-4 * largest);
        }
    }
}

/// Where most light leaves, nothing comes back that could be shot ahead: nothing is
/// gained, and nothing lost.
#[test]
fn open_scenes_are_no_worse() {
    let scene = built_in("facing-squares").unwrap();
    let mesh = Mesh::uniform(&scene, 0.1);
    let mut enclosure = Enclosure::of(&scene, &mesh);
    let matrix = Analytic::new(&scene, &mesh, 1e-4, 0).matrix(&|| ());
    for rho in [0.5, 0.9, 0.999] {
        enclosure.reflectance.fill(Rgb::splat(rho));
        let [shoot, overshoot] = steps(&enclosure, &matrix);
        assert!(overshoot as f64 <= 1.05 * shoot as f64, "{rho}: {shoot} {overshoot}");
    }
}
