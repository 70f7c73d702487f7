//! The lab `gather`: right answers that are not the answer, and the numbers that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::gather::given::{Balance, Solved};
use labs::gather::report::until_small;
use labs::gather::{Work, answer, checks};

#[test]
fn other_right_answers_pass() {
    let answer = answer::WORK;
    // As power: F_ji A_j B_j, divided by the own area.
    let as_power = Work {
        arriving: |room, b, i| {
            let power = |j: usize| room.factors[j][i] * room.area[j] * b[j];
            (0..b.len()).map(power).sum::<f64>() / room.area[i]
        },
        ..answer::WORK
    };
    // Solved by bounces, and the balance from what arrives and leaves.
    let by_bounces = Work {
        solve: |room, accuracy| {
            let least =
                1.0 - room.reflectance.iter().fold(0.0_f64, |m, rho| m.max(*rho));
            let (mut radiosity, mut sweeps) = (room.emission.clone(), 0);
            loop {
                let new = (answer::WORK.bounce)(room, &radiosity);
                let change =
                    new.iter().zip(&radiosity).map(|(new, old)| (new - old).abs());
                // The change is the residual of the old values: the larger one.
                let settled = change.fold(0.0, f64::max) <= accuracy * least;
                (radiosity, sweeps) = (new, sweeps + 1);
                if settled {
                    return Solved { radiosity, sweeps };
                }
            }
        },
        balance: |room, b| {
            let power = |x: &dyn Fn(usize) -> f64| -> f64 {
                (0..b.len()).map(|i| room.area[i] * x(i)).sum()
            };
            let emitted = power(&|i| room.emission[i]);
            let absorbed = power(&|i| {
                (1.0 - room.reflectance[i]) * (answer::WORK.arriving)(room, b, i)
            });
            // In a closed room what is neither must be the rest.
            Balance { emitted, absorbed, unshot: emitted - absorbed }
        },
        ..answer::WORK
    };
    let works = [("answer", &answer), ("power", &as_power), ("bounces", &by_bounces)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work { arriving: |_, _, _| f64::NAN, ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    assert_eq!(failing.map(|(name, _)| name).collect::<Vec<_>>(), ["ball", "box"]);
}

/// The numbers that the report asks for, pinned: when a bounce changes little, what is
/// missing is ρ/(1 − ρ) times as much; after a sweep less, but not by much.
#[test]
fn a_small_change_leaves_a_large_error() {
    for rho in [0.5, 0.9, 0.99, 0.999] {
        let bounces = until_small(&answer::WORK, rho, 1e-3, false);
        let most = rho / (1.0 - rho);
        let ratio = bounces.error / bounces.change / most;
        assert!((0.9..1.01).contains(&ratio), "{rho}: {ratio}");
        let sweeps = until_small(&answer::WORK, rho, 1e-3, true);
        assert!(sweeps.steps < bounces.steps, "{rho}");
        let ratio = sweeps.error / sweeps.change / most;
        assert!((0.2..0.8).contains(&ratio), "{rho}: {ratio}");
    }
}
