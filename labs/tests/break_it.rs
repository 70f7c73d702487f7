//! The lab `break-it`: right answers that are not the answer, and the numbers that its
//! report asks for.

mod common;

use common::all_pass;
use labs::break_it::given::{Hidden, Near, Slow};
use labs::break_it::report::{errors, growth, misses};
use labs::break_it::{Work, answer, checks};
use radiosity::form_factor::named::parallel_rectangles;

#[test]
fn other_right_answers_pass() {
    let answer = answer::WORK;
    let other = Work {
        // By the closed form, and by halving.
        near: |wanted| {
            let error = |d: f64| {
                1.0 / (std::f64::consts::PI * d * d) / parallel_rectangles(1.0, 1.0, d)
                    - 1.0
            };
            let (mut low, mut high) = (0.01, 100.0);
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if error(middle) > 1.1 * wanted { low = middle } else { high = middle }
            }
            Near { distance: low, error: error(low) }
        },
        // Half of a cell is seen at half of the places.
        hidden: |cells, missed| {
            let area = (1.0 - missed) * 4.0 / f64::from(cells).powi(2);
            let cell = 4.0 / f64::from(cells * cells);
            Hidden { side: area.sqrt(), brightness: cell / area }
        },
        // Bounce after bounce, by the largest element.
        runaway: |f| {
            let (mut b, mut largest) = (vec![1.0; f.len()], 1.0);
            for _ in 0..3000 {
                let next = |row: &Vec<f64>| -> f64 {
                    row.iter().zip(&b).map(|(f, b)| f * b).sum()
                };
                let all: Vec<f64> = f.iter().map(next).collect();
                largest = all.iter().copied().fold(0.0, f64::max);
                b = all.iter().map(|b| b / largest).collect();
            }
            1.0 / largest
        },
        // e^(−k (1 − ρ)), and the sum 1/(1 − ρ).
        slow: |sweeps, missing| {
            let swallowed = -missing.ln() / f64::from(sweeps);
            Slow { reflectance: 1.0 - swallowed, behind: 1.0 / swallowed }
        },
        // By another ring: over the walls y = 0 and y = d.
        lawful: |room, wanted| {
            let mut f = room.factors.clone();
            let power = wanted * room.area[4] * f[4][5];
            for (i, j, sign) in [(4, 5, 1.0), (5, 2, -1.0), (2, 3, 1.0), (3, 4, -1.0)] {
                f[i][j] += sign * power / room.area[i];
                f[j][i] += sign * power / room.area[j];
            }
            f
        },
    };
    all_pass(checks::ALL, &[("answer", &answer), ("other", &other)]);
}

/// Two thirds of (side/distance)² holds to 15 % above a side, and no more at half of it.
#[test]
fn the_law_of_points_ends_where_squares_are_near() {
    for found in errors(&answer::WORK) {
        let off = found.foretold / found.found - 1.0;
        let far = found.knob > 1.0;
        assert_eq!(off.abs() < 0.15, far, "{found:?}");
    }
}

/// Above a cell's side a lamp is not missed as often as its area says.
#[test]
fn lamps_are_missed_by_their_area() {
    for found in misses(&answer::WORK).iter().skip(2) {
        assert!((found.found - found.foretold).abs() < 0.04, "{found:?}");
    }
}

/// The finer the elements, the nearer neighbours are in their own size, and no better: the
/// mean over all gets better, as fewer are at edges.
#[test]
fn factors_by_middles_are_more_than_all() {
    let found = growth(&answer::WORK);
    assert!(found.iter().all(|f| (f.foretold / f.found - 1.0).abs() < 1e-3));
    assert!((found[1].found - 1.146).abs() < 1e-3, "{found:?}");
    assert!((found[5].found - 0.989).abs() < 2e-3, "{found:?}");
}
