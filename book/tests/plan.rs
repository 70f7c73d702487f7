//! Pictures of the chapter *What does this scene need?*, as snapshots.
//!
//! To draw them anew: `INSTA_UPDATE=always cargo test -p book --test plan`, and look.

#[path = "../../tests/common/picture.rs"]
mod picture;

use book::plan;
use picture::assert_picture;

/// The smaller the error asked for, the finer the mesh, and first where shadows end.
#[test]
fn meshes_that_were_asked_for_by_their_error() {
    for k in 0..plan::ASKED.len() {
        assert_picture("src/pictures", &format!("needs-mesh-{k}"), &plan::picture(k));
    }
}
