//! Pictures and numbers of *Why not specular radiosity?*, as snapshots and as claims.

use crate::picture::assert_picture;
use book::directional::{smear, views};

const PICTURES: &str = "src/pictures";

/// More directions show more of the gloss; one shows none of it.
#[test]
fn bins_come_nearer_to_the_gloss() {
    let mut last = 1.0;
    for (side, least) in views::SIDES.into_iter().zip([0.5, 0.3, 0.15]) {
        let found = views::by_bins(side);
        let off = views::off(&found);
        assert!((least..last).contains(&off), "{side}: {off}");
        last = off;
        let name = format!("directional-bins-{side}");
        assert_picture(PICTURES, &name, &views::panel(&found));
    }
    assert_picture(PICTURES, "directional-paths", &views::panel(views::by_paths()));
}

/// Each patch mirrors the lamp somewhere else.
#[test]
fn a_patch_keeps_a_picture() {
    assert_picture(PICTURES, "directional-floor", &views::floor());
}

/// A thousand bins leave nine tenths of the peak of a good varnish, and less of a better.
#[test]
fn peaks_are_smeared() {
    assert!((0.85..0.9).contains(&smear::peak_left(200.0, 32)));
    assert!((0.55..0.6).contains(&smear::peak_left(1000.0, 32)));
}
