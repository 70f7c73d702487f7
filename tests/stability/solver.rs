//! Pinned failures of solvers, row by row of the table of failures: each asserts the
//! wrong answer and how wrong it is, or that the trap is avoided. (Rows 50 to 53:
//! `tests/stability/shooting.rs`; 57: `tests/stability/sheets.rs`.)

use crate::failures::solver::sums::{
    arrives_in_cube, noise, one_grey, red_room, single_precision,
};
use crate::failures::solver::sweeps::{
    bright_cube, lit_cube, order, reflecting_all, small_updates, stalled_gradients,
    stiffness, total, white,
};
use radiosity::form_factor::Matrix;
use radiosity::geometry::Rgb;
use radiosity::material::{Coefficients, Material, MaterialError};
use radiosity::solve::{ConjugateGradients, GaussSeidel, Solver};

/// Row 47: sweeps to 1e-4 of the answer: ~ 1/(1 − ρ), ten times as many for each nine.
#[test]
fn row_47_sweeps_grow_as_light_dies_out_slowly() {
    let sweep = stiffness();
    for &[swallowed, expected] in &sweep.theory {
        let (jacobi, gauss_seidel) = (sweep.at(swallowed), sweep.by(1, swallowed));
        // The first whole number at which ρ^(k+1) is small enough.
        assert_eq!(jacobi, (expected - 1.0).ceil(), "{swallowed}");
        assert!((0.49..0.54).contains(&(gauss_seidel / jacobi)), "{gauss_seidel}");
    }
    let nines = [0.5, 0.1, 0.01, 0.001];
    assert_eq!(nines.map(|s| sweep.at(s)), [13.0, 87.0, 916.0, 9205.0]);
    assert_eq!(nines.map(|s| sweep.by(1, s)), [7.0, 44.0, 459.0, 4603.0]);
}

/// Row 48: a closed room that swallows nothing has no solution: each sweep adds the
/// same light again. The material is refused. Where light can leave there is one.
#[test]
fn row_48_reflecting_all_is_refused() {
    let all = Coefficients { diffuse: Rgb::ONE, ..Default::default() };
    assert!(matches!(Material::new("all", all), Err(MaterialError::Diffuse { .. })));
    let sweep = reflecting_all();
    for &[bounces, expected] in &sweep.theory {
        assert!((sweep.at(bounces) / expected - 1.0).abs() < 1e-9, "{bounces}");
    }
    // Two squares with F = .1998: 1/(1 − F).
    assert!((sweep.by(1, 1000.0) - 1.0 / (1.0 - 0.199_825)).abs() < 1e-5);
    assert!((sweep.by(2, 1000.0) - 100.0).abs() < 0.01);
    let (enclosure, matrix) = white(lit_cube(1, 0.5));
    let mut solver = GaussSeidel::new(&enclosure, &matrix);
    let mut after = |sweeps: usize| {
        solver.nth(sweeps - 1);
        total(&enclosure, solver.radiosity())
    };
    let (one, two, three) = (after(1000), after(1000), after(1000));
    assert!(one > 1000.0 && ((three - two) / (two - one) - 1.0).abs() < 1e-6);
}

/// Row 49: a small step is no small error. At ρ = 0.99 the error is 99 times the last
/// step of Jacobi, and half of it of Gauss–Seidel; the residual over 1 − ρ bounds it.
#[test]
fn row_49_a_small_update_is_no_small_error() {
    let sweep = small_updates();
    for &[swallowed, expected] in &sweep.theory {
        let [jacobi, gauss_seidel, bound] = [0, 1, 2].map(|by| sweep.by(by, swallowed));
        assert!((jacobi / expected - 1.0).abs() < 1e-3, "{swallowed}: {jacobi}");
        assert!((0.4..0.51).contains(&(gauss_seidel / expected)), "{gauss_seidel}");
        // Here the light that is missing is even: the worst case, and so no less.
        let rounding = 1e-9;
        assert!(
            (1.0 - rounding..1.001).contains(&(bound / jacobi)),
            "{bound} {jacobi}"
        );
    }
    assert!(
        (sweep.at(0.01) - 99.0).abs() < 0.1 && (sweep.by(1, 0.01) - 49.3).abs() < 0.1
    );
}

/// Row 54: one sweep of Gauss–Seidel depends on the order of the elements, here by 8 %;
/// the solution does not.
#[test]
fn row_54_a_sweep_depends_on_the_order() {
    let sweep = order();
    assert!((sweep.at(1.0) - 0.082).abs() < 1e-3, "{}", sweep.at(1.0));
    for &[sweeps, expected] in &sweep.theory {
        let share = sweep.at(sweeps) / expected;
        assert!((0.05..0.15).contains(&share), "{sweeps}: {share}");
    }
    assert!(sweep.at(64.0) < 1e-12);
}

/// Row 55: conjugate gradients need reciprocal factors. In a bright room (ρ = 0.999),
/// with factors by 64 rays each, the residual stalls near 5e-5, however long they run;
/// sweeps go on to rounding. With factors of element centres they get there, but limp:
/// the residual grows tenfold on the way. Of the rays' matrix made reciprocal and
/// closed they make short work.
#[test]
fn row_55_conjugate_gradients_stall_without_reciprocity() {
    let sweep = stalled_gradients();
    // Above what is promised for reciprocal factors, and below.
    assert!(sweep.at(500.0) > 1e3 * sweep.expected(500.0));
    for &[steps, promised] in &sweep.theory {
        assert!(sweep.by(2, steps) < promised, "{steps}");
    }
    assert!(sweep.by(2, 30.0) < 1e-12, "{}", sweep.by(2, 30.0));
    let (enclosure, [rays, centres, _]) = bright_cube();
    let residuals = |matrix: &Matrix| -> Vec<f64> {
        let solver = ConjugateGradients::new(&enclosure, matrix);
        solver.take(500).map(|step| step.residual).collect()
    };
    let least = |from: &[f64]| from.iter().copied().fold(f64::INFINITY, f64::min);
    let stalled = least(&residuals(&rays));
    assert!((1e-6..1e-4).contains(&stalled), "{stalled}");
    let swept = GaussSeidel::new(&enclosure, &rays).nth(20_000).unwrap().residual;
    assert!(swept < 1e-13, "{swept}");
    let centres = residuals(&centres);
    let grown = (1..20).map(|k| centres[k] / least(&centres[..k])).fold(0.0, f64::max);
    assert!(grown > 5.0 && least(&centres) < 1e-12, "{grown}");
}

/// Row 56: what is drawn at random is right on average, and the same again for the same
/// seed. Irradiance by 64 rays an element, over 100 seeds, is as far from the exact one
/// as its scatter allows: of 24 elements the largest z is below 4 (Šidák: 99.8 %).
#[test]
fn row_56_random_factors_are_right_on_average() {
    let of = |seed| arrives_in_cube(Some((64, seed)));
    let runs: Vec<Vec<f64>> = (0..100).map(of).collect();
    let count = runs.len() as f64;
    for (i, exact) in arrives_in_cube(None).into_iter().enumerate() {
        let mean = runs.iter().map(|h| h[i]).sum::<f64>() / count;
        let square = runs.iter().map(|h| (h[i] - mean).powi(2)).sum::<f64>();
        let scatter = (square / (count - 1.0) / count).sqrt();
        let z = if scatter > 0.0 { (mean - exact).abs() / scatter } else { 0.0 };
        assert!(z < 4.0, "element {i}: {mean}, not {exact}, z = {z}");
    }
    assert_eq!(of(7), of(7));
    assert_ne!(of(7), of(8));
    let sweep = noise();
    for &[rays, expected] in &sweep.theory {
        let (independent, ours) = (sweep.at(rays), sweep.by(1, rays));
        // 12 runs of 20 elements that see the lamp: its standard deviation is 5 %.
        assert!((independent / expected - 1.0).abs() < 0.15, "{rays}: {independent}");
        assert!((0.4..0.7).contains(&(ours / expected)), "{rays}: {ours}");
    }
}

/// Row 58: a million small shares summed in single precision miss a per cent; in
/// double, as everything here is, eleven digits are kept.
#[test]
fn row_58_single_precision_drifts() {
    let sweep = single_precision();
    assert!((sweep.at(1e6) - 0.009_039).abs() < 1e-5, "{}", sweep.at(1e6));
    assert!(sweep.by(1, 1e6) < 1e-11);
    for &[shares, most] in &sweep.theory {
        assert!(sweep.at(shares) <= most, "{shares}: {}", sweep.at(shares));
        let double = most * f64::EPSILON / f64::from(f32::EPSILON);
        assert!(sweep.by(1, shares) <= double, "{shares}: {}", sweep.by(1, shares));
    }
}

/// Row 59: in a red room red light goes round and green dies at once: each channel has
/// its own `Φ/(1 − ρ)`.
#[test]
fn row_59_each_channel_has_its_own_books() {
    let all = red_room(0.95);
    let expected = 1.0 / (Rgb::ONE - Rgb::new(0.95, 0.05, 0.0));
    assert!(
        ((all / expected) - Rgb::ONE).abs().max_element() < 1e-9,
        "{all} {expected}"
    );
    assert!((all.x / all.y - 19.0).abs() < 1e-6);
    let sweep = one_grey();
    for &[red, expected] in &sweep.theory {
        assert!((sweep.by(1, red) / expected - 1.0).abs() < 1e-9, "{red}");
        let grey = 1.0 / (1.0 - (red + 0.05) / 3.0);
        assert!((sweep.at(red) / grey - 1.0).abs() < 1e-9, "{red}");
    }
    assert!(
        (sweep.at(0.95) - 1.5).abs() < 1e-9 && (sweep.by(1, 0.95) - 20.0).abs() < 1e-6
    );
}
