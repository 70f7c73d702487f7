//! Pinned failures of sheets that let light through.

use crate::failures::solver::sums::{divided, sheet_in_furnace, singular_sheet};

/// Row 57: a sheet that reflects as much as it lets through. Programs that keep what
/// leaves its two faces, and ask what fell on them, divide by ρ² − τ²: a relative error
/// of (ρ + τ)/|ρ − τ| times that of their numbers, and nothing at all for ρ = τ. Here
/// what falls on a face is kept, and the furnace with such a sheet across it comes out.
#[test]
fn row_57_a_sheet_may_reflect_as_much_as_it_passes() {
    for (rho, tau) in [(0.4, 0.1), (0.4, 0.4), (0.4, 0.4 + 1e-9), (0.495, 0.495)] {
        for b in sheet_in_furnace(rho, tau, 1e-13) {
            assert!((b.x - 2.0).abs() < 1e-9, "{rho} {tau}: {b}");
        }
    }
    // Of a solver that is stopped early: good to 1e-6, and useless when divided.
    assert!(
        sheet_in_furnace(0.4, 0.4 - 1e-9, 1e-6)
            .iter()
            .all(|b| { (b.x - 2.0).abs() < 1e-5 })
    );
    assert!(divided(0.4, 0.4 - 1e-9)[0] > 1.0);
    let sweep = singular_sheet();
    for &[apart, most] in &sweep.theory {
        let (divided, ours) = (sweep.at(apart), sweep.by(1, apart));
        assert!(divided < most, "{apart}: {divided}");
        assert!(ours < 1e-6, "{apart}: {ours}");
        if apart <= 1e-3 {
            // Both faces are off by nearly as much: a seventh of the worst case.
            assert!((0.1..0.2).contains(&(divided / most)), "{apart}: {divided}");
        }
    }
}
