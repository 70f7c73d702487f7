//! How fast solvers are, how far they can be trusted, and what they share.

use crate::common::any::{convex_room, room};
use crate::common::rooms::{box_walls, exact_factors, gathered, scene};
use proptest::prelude::*;
use radiosity::chart::race::contestants;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{Cached, FormFactors, Lost, Matrix, Row};
use radiosity::geometry::Rgb;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{
    Brightest, ConjugateGradients, Enclosure, GaussSeidel, Jacobi, Shoot, Solver,
    contraction, error_bound,
};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A box whose top emits 1 W/m², with exact factors.
fn lit_box(sides: [f64; 3], edge: f64, rho: f64) -> (Enclosure, Matrix) {
    let emission = |wall: usize| f64::from(u8::from(wall == 5));
    let walls = box_walls(sides).into_iter().enumerate();
    let scene = scene(walls.map(|(w, wall)| (wall, emission(w), rho)));
    let mesh = Mesh::uniform(&scene, edge);
    (Enclosure::of(&scene, &mesh), exact_factors(&mesh))
}

fn difference(a: &[Rgb], b: &[Rgb]) -> Vec<Rgb> {
    a.iter().zip(b).map(|(&a, &b)| a - b).collect()
}

fn norm(enclosure: &Enclosure, x: &[Rgb]) -> Rgb {
    let square = enclosure.norm_squared(x.iter().copied());
    Rgb::from_array(square.to_array().map(f64::sqrt))
}

/// `‖ρFx‖/‖x‖` in the area norm, worst channel, of light `x` that was sent there and back
/// many times: what becomes of the light that lasts longest.
fn lasting_gain(enclosure: &Enclosure, factors: &Matrix) -> f64 {
    let Enclosure { area, reflectance, .. } = enclosure;
    let mut x = vec![Rgb::ONE; enclosure.len()];
    let mut gain = Rgb::ZERO;
    for _ in 0..200 {
        let (mut there, mut back) = (vec![], vec![Rgb::ZERO; x.len()]);
        for (i, row) in factors.rows().iter().enumerate() {
            let row = row.factors();
            let arrives: Rgb = row.iter().map(|&(j, f)| f * x[j as usize]).sum();
            there.push(reflectance[i] * arrives);
            for &(j, f) in row {
                let j = j as usize;
                back[j] += area[i] * f / area[j] * reflectance[i] * there[i];
            }
        }
        gain = norm(enclosure, &there) / norm(enclosure, &x);
        let scale = norm(enclosure, &back);
        x = back.iter().map(|&b| b / scale).collect();
    }
    gain.to_array().into_iter().filter(|g| g.is_finite()).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// The contraction bounds what a bounce leaves of any light, whatever the factors, and
    /// is not far above what it leaves of the light that lasts longest.
    #[test]
    fn the_contraction_is_a_bound(room in prop_oneof![room(true), room(false)]) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        for factors in [
            Analytic::new(&scene, &mesh, 1e-3, 1).matrix(&|| ()),
            Cast::new(&mesh, 100, 1).matrix(&|| ()),
            Hemicube::new(&mesh, 32).matrix(&|| ()),
        ] {
            let bound = contraction(&enclosure, &factors);
            let gain = lasting_gain(&enclosure, &factors);
            prop_assert!(gain <= bound * (1.0 + 1e-9), "{gain} > {bound}");
            prop_assert!(bound <= 1.2 * gain, "{bound} is no sharp bound of {gain}");
        }
    }

    /// Reciprocal and closed: no more than `ρ_max`.
    #[test]
    fn exact_factors_contract_by_the_largest_reflectance(room in convex_room()) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let bound = contraction(&enclosure, &exact_factors(&mesh));
        let most = enclosure.largest_reflectance().max_element();
        prop_assert!(bound <= most * (1.0 + 1e-9), "{bound} > {most}");
    }

    /// With hemicubes, which are not reciprocal, the true error of the discrete solution is
    /// below the bound after every sweep - or none is given: beside a block that is thin for
    /// its hemicubes, a bounce may leave more than all of the light.
    #[test]
    fn the_bound_holds_for_computed_factors(room in room(false)) {
        let scene = room.scene();
        let mesh = Mesh::uniform(&scene, 0.9);
        let enclosure = Enclosure::of(&scene, &mesh);
        let factors = Hemicube::new(&mesh, 32).matrix(&|| ());
        let truth = gathered(&enclosure, &factors, 1e-13, 2000);
        let contraction = contraction(&enclosure, &factors);
        let mut solver = GaussSeidel::new(&enclosure, &factors);
        for _ in 0..10 {
            let bound = error_bound(solver.next().unwrap().residual, contraction);
            let error = norm(&enclosure, &difference(solver.radiosity(), &truth));
            let found = difference(solver.radiosity(), &enclosure.emission);
            if contraction >= 1.0 {
                prop_assert_eq!(bound, f64::INFINITY);
                break;
            }
            let allowed = bound * norm(&enclosure, &found) + 1e-12;
            prop_assert!(error.cmple(allowed).all(), "{error} > {allowed}");
        }
    }
}

/// Two elements that see nothing but each other, one a hundred times as large. As areas
/// differ, `F = 1` both ways is not reciprocal: a little light on the small one is much
/// light on the large one. A bound from the reflectance alone would be 3.3 times too small;
/// the contraction is 5, and no bound is given. A solver that runs on tells that it has not
/// converged, though it has.
#[test]
fn far_from_reciprocal_no_bound_is_given() {
    let enclosure = Enclosure {
        area: vec![100.0, 1.0],
        emission: vec![Rgb::ZERO, Rgb::ONE],
        reflectance: vec![Rgb::splat(0.5); 2],
        ..Default::default()
    };
    let row = |j| Row::new(vec![(j, 1.0)], Lost::default());
    let factors = Matrix::from_rows(vec![row(1), row(0)]);
    let c = contraction(&enclosure, &factors);
    assert!((c - 5.0).abs() < 1e-12, "{c}");
    assert_eq!(error_bound(1e-9, c), f64::INFINITY);
    // B = (2/3, 4/3). Before the first bounce r = (½, 0) and is 5 in the area norm.
    let residual_at_start = 10.0 * 0.5;
    let error_at_start =
        norm(&enclosure, &[Rgb::splat(2.0 / 3.0), Rgb::splat(1.0 / 3.0)]).x;
    assert!(error_at_start > 1.3 * residual_at_start);
    // A residual of 1 on the small element: the error is 3.3 times what ρ allows.
    let inverse =
        |r: [f64; 2]| [(r[0] + 0.5 * r[1]) / 0.75, (0.5 * r[0] + r[1]) / 0.75];
    let [large, small] = inverse([0.0, 1.0]);
    let error = (100.0 * large * large + small * small).sqrt();
    assert!((error / error_bound(1.0, 0.5) - 3.4).abs() < 0.1, "{error}");
    let run = GaussSeidel::new(&enclosure, &factors).run(c, 1e-6, 100);
    assert!(!run.converged && run.steps < 100 && run.last.residual < 1e-15);
}

/// Of a closed room of one reflectance `k` bounces lack exactly the share `ρ^(k+1)` of the
/// light. A sweep of Gauss-Seidel does, in the long run, as much as two bounces: `ρ²`.
#[test]
fn bounces_and_sweeps_converge_as_theory_says() {
    for rho in [0.5, 0.9, 0.99] {
        let (enclosure, matrix) = lit_box([1.0, 2.0, 1.5], 0.5, rho);
        let all = 2.0 / (1.0 - rho);
        let lacks = |b: &[Rgb]| 1.0 - enclosure.power(b.iter().copied()).x / all;
        let mut bounces = Jacobi::new(&enclosure, &matrix);
        for k in 1..=20 {
            bounces.next();
            let share = rho.powi(k + 1);
            let got = lacks(bounces.radiosity());
            assert!((got - share).abs() < 1e-11, "{rho} {k}: {got}, not {share}");
        }
        let mut sweeps = GaussSeidel::new(&enclosure, &matrix);
        sweeps.nth(7);
        let before = lacks(sweeps.radiosity());
        sweeps.next();
        let rate = (lacks(sweeps.radiosity()) / before).ln() / rho.ln();
        assert!((1.8..2.3).contains(&rate), "{rho}: a sweep does {rate} bounces");
    }
}

/// The energy norm of an error, `Σ A (d²/ρ − d F d)`, which conjugate gradients minimise.
fn energy(enclosure: &Enclosure, factors: &Matrix, d: &[Rgb]) -> f64 {
    let term = |i: usize| {
        let row = factors.rows()[i].factors();
        let arrives: f64 = row.iter().map(|&(j, f)| f * d[j as usize].x).sum();
        enclosure.area[i] * d[i].x * (d[i].x / enclosure.reflectance[i].x - arrives)
    };
    (0..d.len()).map(term).sum::<f64>().sqrt()
}

/// Conjugate gradients find the best of all mixtures of so many bounces. So they are never
/// behind Jacobi; they never lose ground; and they gain at least the factor of theory.
#[test]
fn conjugate_gradients_are_the_best_of_all_bounces() {
    for rho in [0.5, 0.9, 0.99, 0.999] {
        let (enclosure, matrix) = lit_box([1.0, 2.0, 1.5], 0.5, rho);
        let truth = {
            let mut solver = ConjugateGradients::new(&enclosure, &matrix);
            solver.run(rho, 1e-14, 300);
            solver.radiosity().to_vec()
        };
        let distance = |b: &[Rgb]| energy(&enclosure, &matrix, &difference(b, &truth));
        let start = distance(&enclosure.emission);
        let root: f64 = (1.0 - rho * rho).sqrt();
        let q = (1.0 - root) / rho;
        let (mut last, mut k) = (start, 0);
        let mut jacobi = Jacobi::new(&enclosure, &matrix);
        let mut solver = ConjugateGradients::new(&enclosure, &matrix);
        while last > 1e-10 * start {
            solver.next();
            jacobi.next();
            k += 1;
            let now = distance(solver.radiosity());
            let theory = 2.0 * f64::powi(q, k) * start;
            let bounced = distance(jacobi.radiosity());
            assert!(now <= theory && now <= bounced && now < last, "{rho} {k}: {now}");
            last = now;
        }
        assert!(k < 25, "{rho}: {k} steps");
    }
}

/// A room with black walls among others, and one that is black all over: conjugate
/// gradients leave black elements out, and still tell what arrives at them.
#[test]
fn black_walls_take_no_part() {
    let (mut enclosure, matrix) = lit_box([1.0, 1.0, 1.0], 0.5, 0.8);
    for black in [12, enclosure.len()] {
        enclosure.reflectance[..black].fill(Rgb::ZERO);
        let truth = gathered(&enclosure, &matrix, 1e-14, 1000);
        let mut solver = ConjugateGradients::new(&enclosure, &matrix);
        let run = solver.run(0.8, 1e-13, 100);
        assert!(run.converged && run.last.ledger.worst_imbalance() < 1e-12, "{run:?}");
        let apart = difference(solver.radiosity(), &truth);
        assert!(apart.iter().all(|d| d.abs().max_element() < 1e-11));
        assert!(solver.irradiance()[..12].iter().all(|h| h.x > 0.1));
    }
    // and when there is nothing left to do, they end
    assert!(ConjugateGradients::new(&enclosure, &matrix).nth(3).is_none());
}

/// ρ up to 0.9999: each solver keeps its word, and the books close after every step.
#[test]
fn light_that_bounces_ten_thousand_times() {
    for rho in [0.999, 0.9999] {
        let (enclosure, matrix) = lit_box([1.0, 2.0, 1.5], 1.0, rho);
        let c = contraction(&enclosure, &matrix);
        assert!((c / rho - 1.0).abs() < 1e-12, "{c}");
        let mut solver = ConjugateGradients::new(&enclosure, &matrix);
        assert!(solver.run(c, 1e-10, 100).converged);
        let truth = solver.radiosity().to_vec();
        let all = enclosure.power(truth.iter().copied()).x * (1.0 - rho);
        assert!((all / 2.0 - 1.0).abs() < 1e-9, "{all}");
        for contestant in contestants() {
            let mut solver = (contestant.start)(&enclosure, &matrix);
            let accuracy = 1e-3;
            let bound = loop {
                let step = solver.next().unwrap();
                assert!(step.ledger.worst_imbalance() < 1e-9, "{}", contestant.name);
                let bound = error_bound(step.residual, c);
                if bound <= accuracy {
                    break bound;
                }
            };
            let error = norm(&enclosure, &difference(solver.radiosity(), &truth)).x;
            let light = norm(&enclosure, &difference(&truth, &enclosure.emission)).x;
            assert!(error <= 1.002 * bound * light, "{}: {error}", contestant.name);
        }
    }
}

/// Counts the rows that are asked of a method.
struct Counted<'a> {
    method: &'a dyn FormFactors,
    rows: AtomicUsize,
}

impl FormFactors for Counted<'_> {
    fn len(&self) -> usize {
        self.method.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        self.rows.fetch_add(1, Ordering::Relaxed);
        self.method.row(from, row)
    }
}

fn room_with_lamps() -> (Scene, Mesh) {
    let scene = built_in("cornell-regular").unwrap();
    let mesh = Mesh::uniform(&scene, 2.0);
    (scene, mesh)
}

/// Other lamps need no other factors: two lamps apart add up to both together, dimmed as
/// one likes, and no row is computed anew.
#[test]
fn lamps_add_up_without_new_factors() {
    let (scene, mesh) = room_with_lamps();
    let room = Enclosure::of(&scene, &mesh);
    let hemicube = Hemicube::new(&mesh, 32);
    let counted = Counted { method: &hemicube, rows: AtomicUsize::new(0) };
    let kept = Cached::new(&counted);
    let lamp = |which: usize, colour: Rgb| -> Vec<Rgb> {
        (0..room.len())
            .map(|i| if i % 7 == which { colour } else { Rgb::ZERO })
            .collect()
    };
    let (warm, cold) = (Rgb::new(9.0, 6.0, 2.0), Rgb::new(1.0, 3.0, 8.0));
    let lamps = [lamp(1, warm), lamp(4, cold)];
    let both = lamps[0].iter().zip(&lamps[1]).map(|(&a, &b)| 0.3 * a + b).collect();
    let accuracy = 1e-8;
    let solve = |emission: Vec<Rgb>| {
        let lit = room.relit(emission);
        let mut solver = Shoot::new(&lit, &kept, Brightest::ByPower);
        let rho = lit.largest_reflectance().max_element();
        assert!(solver.run(rho, accuracy, 1_000_000).converged);
        solver.radiosity().to_vec()
    };
    let together = solve(both);
    let [warm, cold] = lamps.map(solve);
    assert!(counted.rows.load(Ordering::Relaxed) <= room.len(), "a row was made twice");
    let mixed: Vec<Rgb> = warm.iter().zip(&cold).map(|(&a, &b)| 0.3 * a + b).collect();
    let apart = norm(&room, &difference(&mixed, &together));
    // Three solutions, each within the accuracy but for what hemicubes are off.
    let allowed = 3.0 * 2.0 * accuracy * norm(&room, &together);
    assert!(apart.cmple(allowed).all(), "{apart} {allowed}");
}
