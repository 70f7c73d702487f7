//! Laws of the solution: the books balance after every step, light is never negative,
//! and all ways of solving reach the same end.

use crate::common::any::{Room, convex_room, room};
use crate::common::rooms::{
    box_walls, exact_factors, gathered, rows, scene, solved_by,
};
use proptest::prelude::*;
use radiosity::chart::race::contestants;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{FormFactors, Matrix};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::solve::{
    Brightest, Enclosure, GaussSeidel, Ledger, Shoot, Solver, Step, contraction,
    error_bound,
};

/// Bookkeeping closes to this share of what is emitted.
const BOOKS: f64 = 1e-9;

fn meshed(room: &Room) -> (Mesh, Enclosure, [Matrix; 3]) {
    let scene = room.scene();
    let mesh = Mesh::uniform(&scene, 0.9);
    let done = || ();
    let matrices = [
        Analytic::new(&scene, &mesh, 1e-3, 1).matrix(&done),
        Cast::new(&mesh, 100, 1).matrix(&done),
        Hemicube::new(&mesh, 32).matrix(&done),
    ];
    let enclosure = Enclosure::of(&scene, &mesh);
    (mesh, enclosure, matrices)
}

/// For each element: by how much its factors and what it loses fall short of one.
fn shortfall(matrix: &Matrix) -> Vec<f64> {
    let short = |(row, lost): (Vec<f64>, radiosity::form_factor::Lost)| {
        1.0 - row.iter().sum::<f64>() - lost.escaped - lost.absorbed
    };
    rows(matrix).into_iter().map(short).collect()
}

fn closes(ledger: &Ledger, imbalance: Rgb) -> bool {
    let sum = ledger.absorbed + ledger.escaped + ledger.unshot + ledger.imbalance;
    let allowed = BOOKS * ledger.emitted.max_element();
    (ledger.emitted - sum).abs().max_element() <= allowed
        && (ledger.imbalance - imbalance).abs().max_element() <= allowed
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Shooting: after every shot the imbalance is what the shooters' rows fall short
    /// of one, and nothing else; the unshot light never grows by more than that either.
    #[test]
    fn every_shot_is_booked(room in prop_oneof![room(true), room(false)]) {
        let (_, enclosure, matrices) = meshed(&room);
        for matrix in &matrices {
            let short = shortfall(matrix);
            let mut solver = Shoot::new(&enclosure, matrix, Brightest::ByPower);
            let mut unshot = enclosure.emission.clone();
            let mut imbalance = Rgb::ZERO;
            let mut before = enclosure.power(unshot.iter().copied());
            for step in solver.by_ref().take(200) {
                let from = step.shot.unwrap().0 as usize;
                let power = enclosure.area[from] * unshot[from];
                imbalance += power * short[from];
                prop_assert!(closes(&step.ledger, imbalance), "{:?}", step.ledger);
                // Light is absorbed at each shot: ρ ≤ 0.9 leaves at most nine tenths.
                let invented = power * (-short[from]).max(0.0);
                let most = before - 0.1 * power + invented + BOOKS;
                prop_assert!(step.ledger.unshot.cmple(most).all());
                before = step.ledger.unshot;
                unshot = solver_state(&mut unshot, &enclosure, matrix, from);
            }
        }
    }

    /// Gathering: the imbalance is `Σ A B (1 − lost) − Σ A H`, computed here anew, of
    /// bounces, sweeps and conjugate gradients alike.
    #[test]
    fn every_sweep_is_booked(room in prop_oneof![room(true), room(false)]) {
        let (_, enclosure, matrices) = meshed(&room);
        for matrix in &matrices {
            let rows = rows(matrix);
            for contestant in contestants() {
                let mut solver = (contestant.start)(&enclosure, matrix);
                for _ in 0..8 {
                    let Some(step) = solver.next() else { break };
                    if step.shot.is_some() {
                        break; // what is shot is booked when it is sent: see above
                    }
                    let b = solver.radiosity();
                    let imbalance: Rgb = (0..b.len()).map(|i| {
                        let (row, lost) = &rows[i];
                        let arrives: Rgb = row.iter().zip(b).map(|(&f, &b)| f * b).sum();
                        let kept = 1.0 - lost.escaped - lost.absorbed;
                        enclosure.area[i] * (kept * b[i] - arrives)
                    }).sum();
                    prop_assert!(closes(&step.ledger, imbalance), "{:?}", step.ledger);
                }
            }
        }
    }

    /// Light is never negative, and never less than what is emitted.
    #[test]
    fn light_is_positive(room in prop_oneof![room(true), room(false)]) {
        let (_, enclosure, matrices) = meshed(&room);
        for matrix in &matrices {
            let shooting = Shoot::new(&enclosure, matrix, Brightest::ByPower);
            for radiosity in [
                gathered(&enclosure, matrix, 1e-6, 30),
                solved_by(&enclosure, shooting, 1e-6, 300),
            ] {
                for (b, e) in radiosity.iter().zip(&enclosure.emission) {
                    prop_assert!(b.is_finite() && b.cmpge(*e).all(), "{b} < {e}");
                }
            }
        }
    }

    /// Reciprocal, closed factors: no light is invented or lost. The imbalance is zero
    /// after every step of every solver, and what is absorbed is what is emitted.
    #[test]
    fn exact_factors_conserve_energy(room in convex_room(), rho in 0.0..0.9_f64) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let mut enclosure = Enclosure::of(&scene, &mesh);
        let matrix = exact_factors(&mesh);
        for contestant in contestants() {
            for step in (contestant.start)(&enclosure, &matrix).take(60) {
                prop_assert!(step.ledger.worst_imbalance() < 1e-11, "{:?}", step.ledger);
            }
        }
        let last = GaussSeidel::new(&enclosure, &matrix).nth(400).unwrap().ledger;
        let off = (last.absorbed - last.emitted).abs().max_element();
        prop_assert!(off <= BOOKS * last.emitted.max_element(), "{last:?}");
        // With one reflectance for all, `Σ A B (1 − ρ) = Φ`, whatever the shape of the
        // room.
        enclosure.reflectance.fill(Rgb::splat(rho));
        let b = gathered(&enclosure, &matrix, 1e-12, 1000);
        let kept = enclosure.power(b) * (1.0 - rho);
        let off = (kept - last.emitted).abs().max_element();
        prop_assert!(off <= BOOKS * last.emitted.max_element(), "{kept}");
    }

    /// All solvers end at one solution: each within the error that its residual allows.
    #[test]
    fn all_ways_lead_to_one_solution(room in room(false)) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let matrix = Analytic::new(&scene, &mesh, 1e-3, 1).matrix(&|| ());
        let contraction = contraction(&enclosure, &matrix);
        prop_assert!(contraction < 0.9 + 0.05, "{contraction}");
        let accuracy = 1e-4;
        let truth = gathered(&enclosure, &matrix, 1e-12, 10_000);
        let scale = enclosure.norm_squared(
            truth.iter().zip(&enclosure.emission).map(|(&b, &e)| b - e));
        for contestant in contestants() {
            let mut solver = (contestant.start)(&enclosure, &matrix);
            let run = solver.run(contraction, accuracy, 100_000);
            prop_assert!(run.converged, "{}", contestant.name);
            let error = enclosure.norm_squared(
                truth.iter().zip(solver.radiosity()).map(|(&a, &b)| a - b));
            // The bound is relative to what was found: that much less than the truth.
            let most = (accuracy * accuracy * scale).cmpgt(0.9998 * error);
            let dark = scale.cmpeq(Rgb::ZERO);
            prop_assert!((most | dark).all(), "{}: {error} {scale}", contestant.name);
        }
    }

    /// The ambient term is a guess for the display: the solution does not know of it,
    /// and in the end it is gone.
    #[test]
    fn ambient_light_is_not_in_the_result(room in convex_room()) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let matrix = exact_factors(&mesh);
        let mut asked = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
        let mut silent = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
        for _ in 0..50 {
            let shown = asked.with_ambient();
            let mut pairs = shown.iter().zip(asked.radiosity());
            prop_assert!(pairs.all(|(a, b)| a.cmpge(*b).all()));
            asked.next();
            silent.next();
            prop_assert_eq!(asked.radiosity(), silent.radiosity());
        }
        let rho = enclosure.largest_reflectance().max_element();
        let done = |s: &Step| error_bound(s.residual, rho) < 1e-9;
        let last = asked.by_ref().take(100_000).find(done);
        prop_assume!(last.is_some());
        let apart = enclosure.power(
            asked.with_ambient().iter().zip(asked.radiosity()).map(|(&a, &b)| a - b));
        let all = enclosure.power(asked.radiosity().iter().copied());
        prop_assert!(apart.max_element() <= 1e-6 * all.max_element(), "{apart}");
    }

    /// The furnace: where all emits E and reflects ρ, all is `E/(1 − ρ)`. Gathering
    /// needs no more than rows that sum to one - however wrong the factors are.
    #[test]
    fn the_furnace_glows_evenly(
        sides in [0.3..3.0_f64, 0.3..3.0, 0.3..3.0], rho in 0.0..0.95_f64,
    ) {
        let scene = scene(box_walls(sides).map(|wall| (wall, 1.0, rho)));
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let exact = exact_factors(&mesh);
        let done = || ();
        let mut all = vec![
            gathered(&enclosure, &Hemicube::new(&mesh, 16).matrix(&done), 1e-11, 2000),
            gathered(&enclosure, &Cast::new(&mesh, 30, 1).matrix(&done), 1e-11, 2000),
        ];
        for contestant in contestants() {
            let mut solver = (contestant.start)(&enclosure, &exact);
            solver.run(rho, 1e-11, 200_000);
            all.push(solver.radiosity().to_vec());
        }
        for b in all {
            let glow = 1.0 / (1.0 - rho);
            let off = |b: &Rgb| (b.x / glow - 1.0).abs();
            prop_assert!(b.iter().all(|b| off(b) < BOOKS), "{:?}", b[0]);
        }
    }
}

/// What is unshot after element `from` has shot, kept apart from the solver's own
/// books.
fn solver_state(
    unshot: &mut [Rgb],
    enclosure: &Enclosure,
    matrix: &Matrix,
    from: usize,
) -> Vec<Rgb> {
    let power = enclosure.area[from] * unshot[from];
    unshot[from] = Rgb::ZERO;
    for &(j, factor) in matrix.rows()[from].factors() {
        let j = j as usize;
        unshot[j] += enclosure.reflectance[j] * power * factor / enclosure.area[j];
    }
    unshot.to_vec()
}
