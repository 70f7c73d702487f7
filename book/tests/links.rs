//! Pictures of the page on links, as snapshots.
//!
//! To draw them anew: `INSTA_UPDATE=always cargo test -p book --test links`, and look.

#[path = "../../tests/common/picture.rs"]
mod picture;

use book::links::{ERRORS, picture};
use picture::assert_picture;

#[test]
fn meshes_of_three_errors() {
    for (k, error) in ERRORS.into_iter().enumerate() {
        assert_picture("src/pictures", &format!("links-mesh-{k}"), &picture(error));
    }
}
