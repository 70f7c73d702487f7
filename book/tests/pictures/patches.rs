//! Pictures and numbers of the chapter *Patches and elements*, as snapshots and as claims.

use crate::picture::assert_picture;
use book::patches::{cost, floor, rounds};
use radiosity::chart::suites::meshes::{CORNELL, INDIRECT};

const PICTURES: &str = "src/pictures";

/// Each round adds elements, never patches, and only the new elements look around.
#[test]
fn rounds_of_splitting() {
    let shown = rounds::shown();
    assert_eq!(shown.len(), rounds::ROUNDS);
    for pair in shown.windows(2) {
        let (m, [old, new]) = (pair[0].mesh.patches.len(), [&pair[0], &pair[1]]);
        assert_eq!(m, new.mesh.patches.len());
        assert!(new.mesh.elements.len() > old.mesh.elements.len());
        assert!(new.factors - old.factors < m * new.mesh.elements.len());
    }
    for round in 0..rounds::ROUNDS {
        let name = format!("patches-round-{round}");
        assert_picture(PICTURES, &name, &rounds::picture(round));
    }
}

/// Failure 39: h²|B''|/8, here nearly a third of the brightest light.
#[test]
fn t_vertices_tear_until_they_are_anchored() {
    let tear = floor::tear();
    assert!((0.069..0.071).contains(&tear.jump()), "{}", tear.jump());
    assert_picture(PICTURES, "patches-tear", &tear.picture());
}

/// Failure 35: a dark room glows where its floor goes on under the wall.
#[test]
fn floors_leak_until_they_are_cut() {
    let [leaking, cut] = floor::leaks();
    assert!(leaking > 0.3 && cut == 0.0, "{leaking} {cut}");
    assert_picture(PICTURES, "patches-leak", &floor::leak_picture());
}

/// Failure 40: kinks get worse before they get better.
#[test]
fn kinks_are_seen() {
    let kinks = [0.5, 0.25, 0.125, 0.0625, 0.03125].map(floor::kink);
    for (kink, expected) in kinks.into_iter().zip([0.93, 1.49, 1.36, 0.81, 0.42]) {
        assert!((kink - expected).abs() < 0.006, "{kink} {expected}");
    }
    assert_picture(PICTURES, "patches-bands", &floor::bands_picture());
}

/// What the chapter claims of its chart.
#[test]
fn marked_elements_go_further() {
    assert!(cost::gain(CORNELL).2 > 1.3);
    assert!(cost::gain(INDIRECT).2 > 2.5);
}
