//! Pictures and numbers of the chapters on shooting, as snapshots and as claims.

use crate::picture::assert_picture;
use book::shooting::{ahead, cornell, lit, specks, steps};

const PICTURES: &str = "src/pictures";

/// The light moves from the middle panel to the left one, and the lamp goes first.
#[test]
fn shots_one_by_one() {
    let left = steps::STAGES.map(steps::unshot);
    assert!(left.is_sorted_by(|a, b| a > b), "{left:?}");
    assert!((0.84..0.87).contains(&left[0]) && left[4] < 0.05, "{left:?}");
    for shots in steps::STAGES {
        let name = format!("progressive-after-{shots}");
        assert_picture(PICTURES, &name, &steps::picture(shots));
    }
}

/// Failure 50: by radiosity, forty specks go first, with 3 % of the light.
#[test]
fn bright_specks_come_too_early() {
    use radiosity::solve::Brightest;
    let [radiosity, power] =
        [Brightest::ByRadiosity, Brightest::ByPower].map(|by| specks::shot(by).0);
    assert!(radiosity > 0.95 && power < 0.4, "{radiosity} {power}");
    assert_picture(PICTURES, "progressive-specks", &specks::picture());
}

/// Only lamps emit at first, then what they light, then all but what is black or
/// unseen.
#[test]
fn few_emit_at_first() {
    let (emitting, n) = (lit::emitting(), cornell().mesh.elements.len());
    assert_eq!(emitting[0], 4);
    assert!((0.6..0.8).contains(&(emitting[1] as f64 / n as f64)), "{emitting:?}");
    assert!(emitting[2] == emitting[3] && emitting[3] < n, "{emitting:?}");
    let [rough, fine] = [0.5, 0.02].map(|error| lit::rows_used(&lit::counts(error)));
    assert!(rough < n / 50 && fine > n * 9 / 10, "{rough} {fine} {n}");
    assert_picture(PICTURES, "shines-map", &lit::picture());
}

/// Overshooting is ahead at every stage that the chapter shows.
#[test]
fn overshooting_is_ahead() {
    for shots in ahead::STAGES {
        let [ahead, plain] = ahead::errors(shots);
        assert!(ahead < plain, "{shots}: {ahead} {plain}");
        let name = format!("shines-after-{shots}");
        assert_picture(PICTURES, &name, &ahead::picture(shots));
    }
}

/// Failure 53: what is owed grows without end when a shot may be more than twice what
/// is there; within the safe bound it is paid back.
#[test]
fn debts_grow_without_the_safe_bound() {
    let [unbounded, twice, safe] = ahead::RULES.map(|(_, rule)| ahead::debt(rule, 400));
    assert!(unbounded[29] > 1e4 * unbounded[9], "{unbounded:?}");
    assert!(twice[399] > 1e3 * twice[299], "{twice:?}");
    assert!(safe.iter().all(|&debt| debt < 1.0), "{safe:?}");
}
