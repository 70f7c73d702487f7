//! Pictures and numbers of the chapter *Who carries which light?*, as snapshots and claims.

use crate::picture::assert_picture;
use book::transport::{cost, parts};

const PICTURES: &str = "src/pictures";

#[test]
fn a_picture_and_its_parts() {
    assert_picture(PICTURES, "transport-whole", &parts::whole());
    assert_picture(PICTURES, "transport-classes", &parts::sheet());
}

/// What the chapter claims of its chart.
#[test]
fn nobody_is_faster_than_both_ways_together() {
    assert!(cost::longer("lobes") > 2.0, "{}", cost::longer("lobes"));
    // Hardly faster than lamps alone: what is left is the mirror's light.
    let lamps = cost::longer("lamps");
    assert!((0.85..1.2).contains(&lamps), "{lamps}");
}
