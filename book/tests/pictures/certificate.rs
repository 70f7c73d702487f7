//! The pictures and numbers of *How wrong is it?*.

use crate::picture::assert_picture;
use book::certificate::{bounds, maps, noise};

const PICTURES: &str = "src/pictures";

/// Three meshes: each is certified to be better than the last.
#[test]
fn finer_meshes_are_less_wrong() {
    assert_picture(PICTURES, "how-wrong-light", &maps::picture());
    let mut last = f64::INFINITY;
    for k in 0..maps::EDGES.len() {
        assert_picture(PICTURES, &format!("how-wrong-map-{k}"), &maps::error_map(k));
        let c = maps::certificate(k);
        assert!(c.high < last, "{c:?}");
        last = c.low;
    }
}

/// The same mesh by few points and by many: the single element is noisy, the whole is not.
#[test]
fn few_points_make_a_noisy_map() {
    for points in maps::POINTS {
        let name = format!("how-wrong-points-{points}");
        assert_picture(PICTURES, &name, &maps::map_by(points));
    }
}

/// The truth lies within, and the bounds are near; `‖r‖/(1 − ρ)` is far.
#[test]
fn the_truth_lies_between_the_bounds() {
    for rho in [0.2, 0.8] {
        for case in bounds::cases(rho, &[2, 4]) {
            let c = case.certificate;
            assert!(
                c.low <= case.truth && case.truth <= c.high,
                "{} {c:?}",
                case.truth
            );
            assert!(c.high < 1.3 * case.truth);
            assert!(case.residual / (1.0 - rho) > (1.0 + rho) * case.truth);
        }
    }
}

/// The mean of a square is the square of the mean and the variance; of a product of two
/// independent ones it is the square of the mean.
#[test]
fn noise_makes_a_square_too_large_and_leaves_a_product_alone() {
    for rays in noise::RAYS {
        let noise::Residual { square, product, exact, noise } = noise::residual(rays);
        let expected = exact.hypot(noise);
        assert!((square / expected - 1.0).abs() < 0.05, "{rays}: {square} {expected}");
        // 2000 products, each off by the variance or so.
        let off = (product.powi(2) - exact.powi(2)).abs();
        let allowed = 4.0 * noise * (noise + 2.0 * exact) / 2000_f64.sqrt();
        assert!(off < allowed, "{rays}: {product} {exact} ± {allowed}");
    }
}
