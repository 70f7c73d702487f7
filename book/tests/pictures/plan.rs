//! Pictures of the chapter *What does this scene need?*, as snapshots.

use crate::picture::assert_picture;
use book::plan;

/// The smaller the error asked for, the finer the mesh, and first where shadows end.
#[test]
fn meshes_that_were_asked_for_by_their_error() {
    for k in 0..plan::ASKED.len() {
        assert_picture("src/pictures", &format!("needs-mesh-{k}"), &plan::picture(k));
    }
}
