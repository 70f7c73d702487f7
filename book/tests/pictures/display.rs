//! Pictures and numbers of *The picture*, as snapshots and as claims.

use crate::picture::assert_picture;
use book::display::{exposure, ramp, shots, straight, tears};
use glam::dvec2;
use radiosity::film::{Picture, byte};
use std::f64::consts::PI;

const PICTURES: &str = "src/pictures";

#[test]
fn one_solution_in_four_ways() {
    let names = ["flat", "smooth", "mesh", "false-colour"];
    for (name, view) in names.into_iter().zip(shots::views()) {
        assert_picture(PICTURES, &format!("picture-{name}"), &view);
    }
    let [ids, near] = shots::kept();
    assert_picture(PICTURES, "picture-ids", &ids);
    assert_picture(PICTURES, "picture-depth", &near);
}

/// Row 39: T-vertices leave holes of one cell, about one in a million; corners that meet
/// corners leave none.
#[test]
fn t_vertices_leave_pinholes() {
    let found = tears::in_the_l_room();
    let share = found.holes as f64 / found.cells as f64;
    assert!((1e-7..1e-5).contains(&share), "{} of {}", found.holes, found.cells);
    assert_picture(PICTURES, "picture-hole", &found.closeup.expect("there is one"));
    assert_eq!(tears::in_the_cube().holes, 0);
    assert_picture(PICTURES, "picture-torn", &tears::torn());
}

/// Half-way up the picture of a floor from 1 m to 9 m one sees 1.8 m: a tenth of the way.
#[test]
fn straight_lines_are_divided_in_the_world() {
    let [world, page] =
        straight::values(dvec2(0.0, -5.0 / 9.0 / half_height())).unwrap();
    assert!((world - 0.1).abs() < 1e-9 && (page - 0.5).abs() < 1e-9, "{world} {page}");
    assert_picture(PICTURES, "picture-straight", &straight::picture());
}

/// Of the picture of that floor, where the line of sight is 1 m long.
fn half_height() -> f64 {
    46.0_f64.to_radians().tan()
}

/// Failure 77: an automatic exposure hides a forgotten π: radiosity looks as radiance does.
#[test]
fn a_forgotten_pi_does_not_show() {
    let right = shots::smooth();
    let pixels = right.pixels.iter().map(|&l| PI * l).collect();
    let wrong = Picture { pixels, ..right };
    assert!((right.auto_exposure() / wrong.auto_exposure() - PI).abs() < 1e-12);
    let [a, b] = [&right, &wrong].map(|p| p.display(p.auto_exposure()));
    let apart = a.as_raw().iter().zip(b.as_raw()).map(|(&a, &b)| a.abs_diff(b)).max();
    assert!(apart <= Some(1), "{apart:?}");
}

/// Failure 78: half-way between two lights lies not what half-way between their codes does.
#[test]
fn codes_are_not_interpolated() {
    let [light, code] = ramp::codes(0.5);
    assert_eq!((light, byte(0.51)), (byte(0.51), light));
    assert!(light > code + 40, "{light} {code}");
    assert_picture(PICTURES, "picture-board", &ramp::board());
    assert_picture(PICTURES, "picture-ramps", &ramp::ramps());
}

/// Failure 79: what white hides is told. The lamp is a few pixels, and half of the light; at
/// four times the exposure most of the room is white too.
#[test]
fn what_white_hides_is_told() {
    let picture = shots::smooth();
    let automatic = picture.auto_exposure();
    let [dim, white, glaring] =
        exposure::TIMES.map(|times| exposure::hidden(&picture, times * automatic));
    assert!((0.45..0.5).contains(&dim), "{dim}");
    assert!(dim < white && white < 0.6 && glaring > 0.65, "{dim} {white} {glaring}");
    assert!((0.01..=0.03).contains(&picture.clamped_share(automatic)));
    assert_picture(PICTURES, "picture-exposure", &exposure::picture());
}
