//! Failures of rules for two polygons: rows 8 to 11.

use super::exact::{CORNER, FACING};
use super::factors::facing;
use super::matrices::from_centre;
use super::rooms::{rectangle, unit_square};
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec2, DVec3, dvec3};
use radiosity::form_factor::Accuracy;
use radiosity::form_factor::analytic::exchange;
use radiosity::form_factor::area::kernel;
use radiosity::form_factor::exchange_by_contour;
use radiosity::form_factor::named::parallel_rectangles;
use radiosity::geometry::Polygon;
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 8,
        name: "Random pairs at a shared edge",
        why: "The kernel's square goes as 1/r² over r beside the edge: its mean is \
              infinite, and so is the variance.",
        size: "A hundred times the samples gain a factor of 5 at best, not 10; the largest \
               of n samples grows as n^⅔. Rays are as good as anywhere.",
        remedy: "Draw directions instead of points; or sample only what is hidden.",
        tests: &[
            "pairs::row_08_random_pairs_have_infinite_variance_at_an_edge",
            "pairs::row_08_the_control_takes_the_variance_away",
        ],
        shown: Shown::Curve(random_pairs),
    },
    Row {
        number: 9,
        name: "Gauss points on touching edges",
        why: "The contour integral has a logarithm where the edges touch, which no \
              polynomial follows.",
        size: "Points that give eleven digits of facing squares are off by 7.5e-3 on a \
               wedge of any angle; twice as many by half of that.",
        remedy: "Points that crowd doubly exponentially at the ends: all digits.",
        tests: &["pairs::row_09_touching_edges_want_a_better_rule"],
        shown: Shown::Curve(gauss_points),
    },
    Row {
        number: 10,
        name: "Digits lost far away",
        why: "A closed form is a difference of large terms; a far factor is small.",
        size: "The printed form has no digit left at 1e4 sizes; the contour integral has \
               eight, and four at 1e6; ours has fifteen everywhere.",
        remedy: "Far away the kernel is flat: a few points give all digits.",
        tests: &["pairs::row_10_closed_forms_cancel_far_away"],
        shown: Shown::Curve(cancellation),
    },
    Row {
        number: 11,
        name: "False convergence",
        why: "A rule that stops when halving changes little trusts two answers that are \
              wrong in the same way.",
        size: "Of squares a hundredth apart, 1e-3 is asked for and 1.9e-2 given. A \
               published program found F = 1.31, in a row of 1.56.",
        remedy: "Bounds, or an integral that is exact; ours closes the room to 2e-3.",
        tests: &[
            "pairs::row_11_halving_converges_to_the_wrong_number",
            "pairs::row_11_touching_obstructions_do_no_harm",
        ],
        shown: Shown::Curve(false_convergence),
    },
];

/// The unit floor and the wall on its edge x = 0.
pub fn corner() -> [Polygon; 2] {
    [unit_square(0.0, true), rectangle(DVec3::ZERO, DVec3::Y, DVec3::Z)]
}

/// The mean of the kernel over so many pairs of random points, and its largest value.
pub fn by_pairs(to: &Polygon, samples: usize, seed: u64) -> (f64, f64) {
    let [ground, _] = corner();
    let mut random = Stream::named(seed, &[8]);
    let (mut sum, mut most) = (0.0, 0.0_f64);
    for _ in 0..samples {
        let p = ground.point_at([random.next(), random.next()]);
        let q = to.point_at([random.next(), random.next()]);
        let kernel = kernel(&ground, p, to, q);
        sum += kernel;
        most = most.max(kernel);
    }
    (sum / samples as f64, most)
}

/// The share of rays from the ground that meet the unit wall on its edge.
fn by_rays(samples: usize, seed: u64) -> f64 {
    let mut random = Stream::named(seed, &[8, 1]);
    let mut meets = || {
        let [x, y] = [random.next(), random.next()];
        let d = cosine_direction(DVec2::new(random.next(), random.next()));
        let t = -x / d.x;
        t > 0.0 && (0.0..1.0).contains(&(y + t * d.y)) && t * d.z < 1.0
    };
    (0..samples).filter(|_| meets()).count() as f64 / samples as f64
}

/// The root mean square of the relative error in per cent, over a hundred runs.
pub fn rms(exact: f64, run: impl Fn(u64) -> f64) -> f64 {
    let squares: f64 = (0..100).map(|seed| (run(seed) / exact - 1.0).powi(2)).sum();
    100.0 * (squares / 100.0).sqrt()
}

/// Row 8.
pub fn random_pairs() -> Sweep {
    let knobs = [30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0];
    let ([_, wall], lid) = (corner(), unit_square(1.0, false));
    let over = |method, exact: f64, run: &dyn Fn(usize, u64) -> f64| {
        Found::over(method, &knobs, |n| rms(exact, |seed| run(n as usize, seed)))
    };
    Sweep {
        knob: "samples",
        quantity: "error of F, %",
        logarithmic: [true, true],
        found: vec![
            over("pairs of points, a shared edge", CORNER, &|n, s| {
                by_pairs(&wall, n, s).0
            }),
            over("pairs of points, facing squares", FACING, &|n, s| {
                by_pairs(&lid, n, s).0
            }),
            over("rays, a shared edge", CORNER, &by_rays),
        ],
        theory: curve(&knobs, |n| 100.0 * ((1.0 - CORNER) / (CORNER * n)).sqrt()),
        law: "√((1 − F)/(F n)), the standard error of rays",
    }
}

/// A unit square on the common edge of the ground, leaning at this angle.
pub fn leaning(degrees: f64) -> Polygon {
    let (sin, cos) = degrees.to_radians().sin_cos();
    rectangle(DVec3::ZERO, DVec3::Y, dvec3(cos, 0.0, sin))
}

/// The contour integral from the unit ground by Gauss points: n on one edge and n + 1 on
/// the other, lest two of them coincide.
pub fn plain_contour(j: &Polygon, n: usize) -> f64 {
    let (here, there) = (gauss(n), gauss(n + 1));
    let mut sum = 0.0;
    for (a, b) in unit_square(0.0, true).edges() {
        for (c, d) in j.edges() {
            let along = (b - a).dot(d - c);
            for (s, ws) in &here {
                for (t, wt) in &there {
                    let r = a.lerp(b, *s).distance(c.lerp(d, *t));
                    sum += ws * wt * along * r.ln();
                }
            }
        }
    }
    sum / TAU
}

/// Places and weights of the n-point rule on `[0, 1]`, by Newton's method.
fn gauss(n: usize) -> Vec<(f64, f64)> {
    let point = |k: usize| {
        let mut x = (PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut p, mut before) = (1.0, 0.0);
            for m in (0..n).map(|m| m as f64) {
                (p, before) = (((2.0 * m + 1.0) * x * p - m * before) / (m + 1.0), p);
            }
            slope = n as f64 * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(point).collect()
}

/// Rounding, for curves of what is exact but for it.
const ROUNDING: f64 = 1e-16;

/// Row 9.
pub fn gauss_points() -> Sweep {
    let knobs = [3.0, 6.0, 12.0, 24.0, 48.0];
    let [ground, wall] = corner();
    let off = |j: &Polygon, exact: f64, n: f64| {
        (plain_contour(j, n as usize) - exact).abs().max(ROUNDING)
    };
    let lid = unit_square(1.0, false);
    let ours = exchange_by_contour(ground.vertices(), wall.vertices()) - CORNER;
    Sweep {
        knob: "Gauss points on an edge",
        quantity: "error of F",
        logarithmic: [true, true],
        found: vec![
            Found::over("Gauss, a shared edge", &knobs, |n| off(&wall, CORNER, n)),
            Found::over("Gauss, facing squares", &knobs, |n| off(&lid, FACING, n)),
            Found::over("ours, a shared edge", &knobs, |_| ours.abs().max(ROUNDING)),
        ],
        theory: curve(&knobs, |n| 0.098 / n),
        law: "one half with each doubling, as a logarithm asks for",
    }
}

/// Facing unit squares by the printed formula (Howell C-11), which cancels.
pub fn printed(distance: f64) -> f64 {
    let x = 1.0 / distance;
    let (s, q) = (1.0 + x * x, (1.0 + x * x).sqrt());
    let logarithm = (s * s / (1.0 + 2.0 * x * x)).sqrt().ln();
    let arcs = 2.0 * x * q * (x / q).atan() - 2.0 * x * x.atan();
    2.0 / (PI * x * x) * (logarithm + arcs)
}

/// Row 10.
pub fn cancellation() -> Sweep {
    let knobs = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
    let relative = |distance: f64, f: f64| {
        (f / parallel_rectangles(1.0, 1.0, distance) - 1.0).abs().max(ROUNDING)
    };
    let contour = |d: f64| {
        let (i, j) = (unit_square(0.0, true), unit_square(d, false));
        exchange_by_contour(i.vertices(), j.vertices())
    };
    let ours = |d: f64| {
        exchange(&unit_square(0.0, true), &unit_square(d, false), Accuracy::Best)
    };
    Sweep {
        knob: "distance / side",
        quantity: "relative error of F",
        logarithmic: [true, true],
        found: vec![
            Found::over("the printed closed form", &knobs, |d| relative(d, printed(d))),
            Found::over("contour integral", &knobs, |d| relative(d, contour(d))),
            Found::over("ours", &knobs, |d| relative(d, ours(d))),
        ],
        theory: curve(&knobs, |d| (ROUNDING * d.powi(4)).min(1.0)),
        law: "rounding times distance⁴, until no digit is left",
    }
}

/// The wrong rule: from the middles of k × k pieces, halved until a step changes the mean
/// by less than `asked`, relative.
pub fn until_it_settles(i: &Polygon, j: &Polygon, asked: f64) -> f64 {
    let mut pieces = vec![i.clone()];
    let mean = |pieces: &[Polygon]| {
        let sum: f64 = pieces.iter().map(|p| p.area() * from_centre(p, j)).sum();
        sum / i.area()
    };
    let mut last = mean(&pieces);
    loop {
        // Twice, for halves of halves are squares.
        for _ in 0..2 {
            pieces = pieces.iter().flat_map(Polygon::halves).collect();
        }
        let next = mean(&pieces);
        if (next - last).abs() < asked * next {
            return next;
        }
        last = next;
    }
}

/// Row 11.
pub fn false_convergence() -> Sweep {
    let knobs = [1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4];
    let apart = |method, distance: f64| {
        let [i, j] = facing(distance);
        let exact = parallel_rectangles(1.0, 1.0, distance);
        Found::over(method, &knobs, |asked| {
            (until_it_settles(&i, &j, asked) / exact - 1.0).abs().max(ROUNDING)
        })
    };
    Sweep {
        knob: "error asked for",
        quantity: "error given",
        logarithmic: [true, true],
        found: vec![
            apart("squares .01 apart", 0.01),
            apart("squares .03 apart", 0.03),
            apart("squares .1 apart", 0.1),
        ],
        theory: curve(&knobs, |asked| asked),
        law: "as much as was asked for",
    }
}
