//! Area-to-area sampling, and what the control does. (Row 8 of the table of failures, its
//! infinite variance at a shared edge: `tests/stability/pairs.rs`.)

use glam::dvec3;
use radiosity::form_factor::area::{AreaEstimate, controlled, sampled};
use radiosity::geometry::Polygon;
use radiosity::visibility::Visibility;

fn polygon(corners: [[f64; 3]; 4]) -> Polygon {
    Polygon::new(corners.map(|[x, y, z]| dvec3(x, y, z)).to_vec()).unwrap()
}

fn floor() -> Polygon {
    polygon([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]])
}

fn ceiling() -> Polygon {
    polygon([[0., 0., 1.], [0., 1., 1.], [1., 1., 1.], [1., 0., 1.]])
}

/// Shares the edge x = 0 with the floor.
fn wall() -> Polygon {
    polygon([[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]])
}

/// Hides the pairs of floor and ceiling whose midpoint lies in it.
fn quarter() -> Polygon {
    polygon([[0., 0., 0.5], [0.5, 0., 0.5], [0.5, 0.5, 0.5], [0., 0.5, 0.5]])
}

const SEEDS: u64 = 40;

/// The root mean square of the error over seeds, relative.
fn rms(exact: f64, estimate: impl Fn(u64) -> AreaEstimate) -> f64 {
    let square = |seed| (estimate(seed).exchange / exact - 1.0).powi(2);
    ((0..SEEDS).map(square).sum::<f64>() / SEEDS as f64).sqrt()
}

/// Facing squares are easy: .1 % by 1e5 points that are independent, less by these.
#[test]
fn facing_squares_are_easy() {
    let empty = Visibility::new([]);
    let exact = 0.199824895698387;
    let off = rms(exact, |s| sampled(&floor(), &ceiling(), &empty, 10_000, s));
    assert!(off < 1e-3 * 10_f64.sqrt(), "{off}");
}

/// Half of the pairs are hidden or not; plain and controlled agree with the exact ¾ F.
#[test]
fn what_is_hidden_is_sampled_with_an_honest_error() {
    let scene = Visibility::new([&quarter()]);
    let exact = 0.149868671773790;
    for n in [1000, 100_000] {
        for method in [sampled, controlled] {
            let far = (0..SEEDS).filter(|&seed| {
                let e = method(&floor(), &ceiling(), &scene, n, seed);
                (e.exchange - exact).abs() > 2.0 * e.standard_error
            });
            // Of independent points 5 % are farther off; even ones less often.
            let far = far.count();
            assert!(far <= 5, "{far} of {SEEDS} at {n} points");
        }
    }
}

/// A screen near, but not in, the shared edge: the control keeps the variance finite, and
/// a hundred times the points gain tenfold or more.
#[test]
fn the_control_keeps_the_variance_finite_at_a_shared_edge() {
    let screen =
        polygon([[0.2, 0., 0.1], [0.2, 1., 0.1], [0.2, 1., 0.6], [0.2, 0., 0.6]]);
    let scene = Visibility::new([&screen]);
    let exact = controlled(&floor(), &wall(), &scene, 3_000_000, 99).exchange;
    let off = |n| rms(exact, |s| controlled(&floor(), &wall(), &scene, n, s));
    let (few, many) = (off(300), off(30_000));
    assert!(many < few / 10.0, "{few} {many}");
    let plain = rms(exact, |s| sampled(&floor(), &wall(), &scene, 30_000, s));
    assert!(plain > 3.0 * many, "{plain} {many}");
}
