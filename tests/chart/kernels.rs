//! The suites `light` and `form-factors` without a clock: what their charts claim, by error
//! over work.

use radiosity::chart::suites::form_factors::{FAR, HIDDEN, NEAR, Pair, TOUCHING};
use radiosity::chart::suites::light::{self, ALBEDO, IRRADIANCE, SOLID_ANGLE};
use radiosity::chart::{Bench, Column, Trial, exponent};

fn trials(name: &str) -> Vec<Trial> {
    let pair = Pair::named(name).expect("the pair has a name");
    pair.contest(name).run("test", &Bench::SILENT)
}

fn of<'t>(trials: &'t [Trial], method: &str) -> Vec<&'t Trial> {
    let found: Vec<&Trial> = trials.iter().filter(|t| t.method == method).collect();
    assert!(!found.is_empty(), "{method}");
    found
}

/// The most accurate error of a method.
fn best(trials: &[Trial], method: &str) -> f64 {
    of(trials, method).iter().map(|t| t.error).fold(f64::INFINITY, f64::min)
}

/// The pairs' exact factors: rectangles by their printed formulas, with nothing between.
#[test]
fn the_formula_is_exact_wherever_the_squares_are() {
    for name in [FAR, NEAR, TOUCHING, HIDDEN] {
        let trials = trials(name);
        for t in of(&trials, "Lambert's formula") {
            // A tolerance is absolute; the least of these factors is 0.0124.
            assert!(t.error <= t.setting / 0.012 + 1e-12, "{name}: {t:?}");
        }
        assert!(Pair::named("squares in a hat").is_none());
    }
}

/// Orders of convergence along the touching edge, by counted work: k⁴ pairs of first order,
/// k² places of second. Rays are spread evenly: at least one over the root.
#[test]
fn slopes_are_those_of_theory() {
    let trials = trials(TOUCHING);
    let slope =
        |method: &str, work| exponent(&of(&trials, method), work, Column::Error);
    let points = slope("point to point", Column::Factors);
    assert!((points + 0.25).abs() < 0.03, "{points}");
    let middles = slope("Lambert at the middles", Column::Factors);
    assert!((middles + 1.0).abs() < 0.1, "{middles}");
    assert!(slope("rays", Column::Rays) < -0.45);
}

/// One hemicube stands still at what its centre gets wrong; 8 × 8 of them do not. Rules that
/// see no blocker are wrong by the same, however finely they cut; rays are not.
#[test]
fn what_stands_still_on_the_charts() {
    let near = trials(NEAR);
    assert!((best(&near, "one hemicube") - 0.315).abs() < 5e-3);
    assert!(best(&near, "k × k hemicubes") < 0.01);
    let hidden = trials(HIDDEN);
    for blind in ["point to point", "point to disc", "Lambert at the middles"] {
        // All of 0.1998 in place of 0.0292.
        assert!((best(&hidden, blind) - 5.852).abs() < 0.02, "{blind}");
    }
    assert!(best(&hidden, "rays") < 0.02 && best(&hidden, "random pairs") < 0.02);
}

/// Second order of pieces (their number is k²), a root of rays or better, and lobes are best
/// drawn from themselves.
#[test]
fn integrals_over_directions() {
    let trials = (light::SUITE.measure)(&Bench::SILENT);
    let of_scene = |scene: &str| -> Vec<Trial> {
        trials.iter().filter(|t| t.scene == scene).cloned().collect()
    };
    let angle = of_scene(SOLID_ANGLE);
    let pieces = exponent(&of(&angle, "k × k pieces"), Column::Rays, Column::Error);
    assert!((pieces + 1.0).abs() < 0.06, "{pieces}");
    assert!(best(&angle, "closed form") < 1e-14);
    let irradiance = of_scene(IRRADIANCE);
    assert!(best(&irradiance, "rays by the cosine") < best(&irradiance, "even rays"));
    let albedo = of_scene(ALBEDO);
    let error = |drawn: &str| best(&albedo, drawn);
    assert!(error("drawn from the lobe") < error("drawn by the cosine"));
    assert!(error("drawn by the cosine") < error("drawn evenly"));
}
