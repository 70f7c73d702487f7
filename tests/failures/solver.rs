//! Failures of solvers: rows 47 to 59.

pub mod shots;
pub mod sums;
pub mod sweeps;

use super::{Row, Shown};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 47,
        name: "White rooms take long",
        why: "Each sweep leaves ρ of what is missing: where little is swallowed, light \
              has to bounce often.",
        size: "13, 87, 916, 9205 bounces to 1e-4 at ρ = 0.5, 0.9, 0.99, 0.999; half as \
               many sweeps by Gauss–Seidel.",
        remedy: "Conjugate gradients, about √ of it; overshooting.",
        tests: &["solver::row_47_sweeps_grow_as_light_dies_out_slowly"],
        shown: Shown::Curve(sweeps::stiffness),
    },
    Row {
        number: 48,
        name: "All light stays",
        why: "A closed room that swallows nothing has no solution: each sweep adds the \
              same light again.",
        size: "Another lamp's worth with each bounce, without end; at ρ = 0.99 it ends \
               at 100, and where light can leave even ρ = 1 ends, at 1.25. Such a \
               material is refused.",
        remedy: "Refuse ρ ≥ 1 where materials are made.",
        tests: &["solver::row_48_reflecting_all_is_refused"],
        shown: Shown::Curve(sweeps::reflecting_all),
    },
    Row {
        number: 49,
        name: "A small update is no small error",
        why: "The next updates are nearly as large, and there are many of them.",
        size: "The error is ρ/(1 − ρ) last updates of Jacobi's: 99 at ρ = 0.99, and 49 \
               of Gauss–Seidel's.",
        remedy: "Stop by the residual over 1 − ρ, which bounds the error.",
        tests: &["solver::row_49_a_small_update_is_no_small_error"],
        shown: Shown::Curve(sweeps::small_updates),
    },
    Row {
        number: 50,
        name: "Small patches shoot too early",
        why: "The brightest patch is not the one with the most light.",
        size: "Forty specks, five times as bright as a wall of lamps: after forty \
               shots 99 % of the light has not moved; chosen by power, 13 %.",
        remedy: "Choose by A ΔB.",
        tests: &["shooting::row_50_small_patches_shoot_too_early"],
        shown: Shown::Curve(shots::specks_first),
    },
    Row {
        number: 51,
        name: "Ambient light counted twice",
        why: "The ambient term is a guess at light that is still to come: it will \
              come.",
        size: "Kept in the result it makes 1 + ρ of all light, here 1.7; only shown, \
               exactly Φ/(1 − ρ) after every shot.",
        remedy: "Add it to what is shown, never to what is solved.",
        tests: &["shooting::row_51_ambient_light_counts_once"],
        shown: Shown::Curve(shots::counted_twice),
    },
    Row {
        number: 52,
        name: "Ambient light passes walls",
        why: "It is spread over all surfaces, seen or not.",
        size: "0.042 W/m² in a dark cube beside a lit one, and 0 in the solution, \
               exactly.",
        remedy: "For the first moments only; the solution does not know of it.",
        tests: &["shooting::row_52_ambient_light_passes_walls"],
        shown: Shown::Curve(shots::through_walls),
    },
    Row {
        number: 53,
        name: "Shot too far ahead",
        why: "Whoever shoots light that is not there yet owes it, and the debt is shot \
              back.",
        size: "Converges below twice the unshot light and explodes above. The ambient \
               guess without a bound: ten thousand times more with each ten shots; \
               within the safe bound it saves half of all shots, and nine in ten where \
               ρ = 0.9.",
        remedy: "Never twice what is unshot, by the theory of Gortler, Cohen and Slusallek; at most \
                 1.9 times, here.",
        tests: &[
            "shooting::row_53_overshooting_without_bound_explodes",
            "shooting::row_53_half_of_the_shots_are_saved",
        ],
        shown: Shown::Curve(shots::overshooting),
    },
    Row {
        number: 54,
        name: "A sweep depends on the order",
        why: "Gauss–Seidel takes the newest values, and which are new depends on who \
              comes first.",
        size: "8 % of all light after one sweep, gone as ρ²ᵏ: below 1e-12 after 64.",
        remedy: "Run to the end, or do not show what is half done.",
        tests: &["solver::row_54_a_sweep_depends_on_the_order"],
        shown: Shown::Curve(sweeps::order),
    },
    Row {
        number: 55,
        name: "Gradients stall without reciprocity",
        why: "Conjugate gradients are made for A F symmetric; factors by rays or \
              hemicubes are not.",
        size: "At ρ = 0.999, by 64 rays, the residual stays near 1e-4; by hemicubes it \
               grows tenfold on the way; made reciprocal it is at 1e-12 after 20 \
               steps.",
        remedy: "Make the factors reciprocal and closed, or sweep.",
        tests: &["solver::row_55_conjugate_gradients_stall_without_reciprocity"],
        shown: Shown::Curve(sweeps::stalled_gradients),
    },
    Row {
        number: 56,
        name: "Chance",
        why: "A factor by rays is right on average, and off in each single run.",
        size: "√(F (1 − F)/N) by independent rays, 40 % less by rays that are spread \
               evenly; no element's mean over 100 seeds is off by four of its \
               deviations.",
        remedy: "State the error, name the seed, and spread the rays.",
        tests: &["solver::row_56_random_factors_are_right_on_average"],
        shown: Shown::Curve(sums::noise),
    },
    Row {
        number: 57,
        name: "A sheet that passes what it reflects",
        why: "Programs that keep what leaves the two faces, and ask what fell on them, \
              divide by ρ² − τ².",
        size: "The solver's error times up to (ρ + τ)/(ρ − τ), and nothing at all for \
               ρ = τ. Here what falls is kept: 3e-7 with a solver of 1e-6, whatever τ \
               is.",
        remedy: "Keep irradiances.",
        tests: &["sheets::row_57_a_sheet_may_reflect_as_much_as_it_passes"],
        shown: Shown::Curve(sums::singular_sheet),
    },
    Row {
        number: 58,
        name: "Single precision drifts",
        why: "A share that is below the last digit of the sum is rounded, each time \
              the same way.",
        size: "A million shares of a millionth: 0.9 % off in single precision, 1e-11 \
               in double.",
        remedy: "Sums of light in double precision.",
        tests: &["solver::row_58_single_precision_drifts"],
        shown: Shown::Curve(sums::single_precision),
    },
    Row {
        number: 59,
        name: "One grey for all colours",
        why: "Red light goes round in a red room for long, green light dies at once: \
              their mean does neither.",
        size: "At a reflectance of 0.95 in red there is 20 times the red light that is \
               emitted; by the mean of three reflectances 1.5 times.",
        remedy: "Each channel its own reflectance, its own residual and its own \
                 ledger.",
        tests: &["solver::row_59_each_channel_has_its_own_books"],
        shown: Shown::Curve(sums::one_grey),
    },
];
