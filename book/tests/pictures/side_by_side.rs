//! Pictures of the chapter *Side by side*, as snapshots.

use crate::picture::assert_picture;
use book::side_by_side::{self, METHODS};

/// What each method shows, and where it is off.
#[test]
fn methods_side_by_side() {
    for name in METHODS {
        let drawn = side_by_side::picture(name);
        assert_picture("src/pictures", &format!("side-{name}"), &drawn);
        if name != "reference" {
            let off = side_by_side::difference(name);
            assert_picture("src/pictures", &format!("side-{name}-off"), &off);
        }
    }
}
