//! The lab `certify`: right answers that are not the answer, and the numbers that its
//! report asks for.

mod common;

use common::all_pass;
use labs::certify::report::norms;
use labs::certify::{Work, answer, checks};

#[test]
fn other_right_answers_pass() {
    let answer = answer::WORK;
    // Bounce by bounce, each added to the sum: the series.
    let series = Work {
        propagated: |room, r| {
            let (mut term, mut sum) = (r.to_vec(), r.to_vec());
            for _ in 0..500 {
                let arriving = |row: &Vec<f64>| -> f64 {
                    row.iter().zip(&term).map(|(f, x)| f * x).sum()
                };
                let next = room.factors.iter().zip(&room.reflectance);
                term = next.map(|(row, rho)| rho * arriving(row)).collect();
                sum.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
            }
            sum
        },
        // ab = ((a + b)² − (a − b)²)/4
        squared: |points| {
            let product = |p: &labs::certify::given::Point| {
                let [a, b] = [0, 1].map(|g| (answer::WORK.residual)(p, g));
                p.area * ((a + b).powi(2) - (a - b).powi(2)) / 4.0
            };
            points.iter().map(product).sum()
        },
        ..answer::WORK
    };
    all_pass(checks::ALL, &[("answer", &answer), ("series", &series)]);
}

/// A square has the variance in it, σ²/rays; a product of ten thousand is right.
#[test]
fn the_square_needs_rays_and_the_product_points() {
    for rays in [4, 64, 1024] {
        let found = norms(&answer::WORK, 10_000, rays);
        let noise = 0.5 / (rays as f64).sqrt();
        assert!((found.truth - 0.02).abs() < 1e-3);
        let square = found.truth.hypot(noise);
        assert!((found.square / square - 1.0).abs() < 0.05, "{rays}: {found:?}");
        let off = (found.product.powi(2) - found.truth.powi(2)).abs();
        assert!(off < 5.0 * noise * (noise + 0.04) / 100.0, "{rays}: {found:?}");
    }
}
