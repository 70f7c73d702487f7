//! Pictures of the page on links, as snapshots.

use crate::picture::assert_picture;
use book::links::{ERRORS, picture};

#[test]
fn meshes_of_three_errors() {
    for (k, error) in ERRORS.into_iter().enumerate() {
        assert_picture("src/pictures", &format!("links-mesh-{k}"), &picture(error));
    }
}
