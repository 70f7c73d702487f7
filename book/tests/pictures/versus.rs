//! The pictures and numbers of *Speed against accuracy*.

use crate::picture::assert_picture;
use book::versus::{itself, rule, views};
use radiosity::chart::{Trial, WorkDone};

#[test]
fn what_the_same_time_buys() {
    for k in 0..views::VIEWS.len() {
        let name = format!("versus-view-{k}");
        assert_picture("src/pictures", &name, &views::picture(k));
    }
}

/// Against itself the hemicube converges, cell by cell; the truth stays 5 % away, for one
/// centre speaks for the whole square (row 1 of the failures).
#[test]
fn a_method_agrees_with_itself() {
    let errors = itself::errors();
    let (first, last) = (errors[0], errors[errors.len() - 1]);
    assert!(last.1 < first.1 / 10.0 && last.1 < 3e-3, "{errors:?}");
    assert!((0.045..0.055).contains(&last.2), "{errors:?}");
}

/// The quickest is the quickest of those that are good enough.
#[test]
fn the_winner_is_good_enough_and_quickest() {
    let trial = |method: &str, seconds, error| Trial {
        suite: "s".into(),
        scene: "here".into(),
        method: method.into(),
        setting: 1.0,
        seconds,
        runs: 1,
        work: WorkDone::default(),
        memory: 0,
        error,
        uncertainty: 0.0,
        energy: None,
    };
    let trials = [
        trial("coarse", 1.0, 0.5),
        trial("good", 5.0, 0.01),
        trial("good", 3.0, 0.09),
        trial("other", 4.0, 0.001),
    ];
    let found = rule::quickest(&trials, "here", 0.1);
    assert_eq!(found, [("good", 3.0), ("other", 4.0)]);
    assert!(rule::quickest(&trials, "there", 0.1).is_empty());
}
