//! Pictures and numbers of *Mirrors and windows*, as snapshots and as claims.

use crate::picture::assert_picture;
use book::mirrors::levels::{Mirrors, sums};
use book::mirrors::{hemicube, unfolded};

#[test]
fn a_hemicube_looks_into_the_mirror_world() {
    assert_picture("src/pictures", "mirrors-hemicube", &hemicube::picture());
}

#[test]
fn the_window_of_the_figure_cuts_the_image() {
    let [clipped, whole] = unfolded::factors();
    assert!((clipped - 0.009785756793).abs() < 1e-11);
    assert!((whole - 0.013923717407).abs() < 1e-11);
}

#[test]
fn the_curves_end_where_they_should() {
    let two = sums(Mirrors::Two, 1.0, 8);
    let four = sums(Mirrors::Four, 1.0, 8);
    assert!((two[1] * 5f64.sqrt() - 0.913).abs() < 1e-3);
    assert!((four[1] - 0.576871128).abs() < 1e-9 && (four[8] - 0.978).abs() < 1e-3);
}
