//! Coplanar faces that look the same way: the smaller wins, and nothing is left to fight.

use glam::{DQuat, DVec3, dvec3};
use proptest::prelude::*;
use radiosity::geometry::Polygon;
use radiosity::material::{Coefficients, Material};
use radiosity::scene::{Face, FaceId, MaterialId, Repair, Scene};

type Rectangle = (f64, f64, f64, f64); // x, y, width, height

/// A rectangle at height `z`, front upwards.
fn at((x, y, w, h): Rectangle, z: f64) -> Vec<DVec3> {
    [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
        .map(|(x, y)| dvec3(x, y, z))
        .to_vec()
}

fn assemble(outlines: Vec<Vec<DVec3>>) -> (Scene, Vec<Repair>) {
    let grey = Material::new("grey", Coefficients::default()).unwrap();
    let face = |outline| Face { outline, material: MaterialId(0) };
    let faces = outlines.into_iter().map(face).collect();
    Scene::assemble("test", vec![grey], faces, None).unwrap()
}

/// The area that two surfaces share.
fn shared(a: &Polygon, b: &Polygon) -> f64 {
    let left: f64 = a.without(b).iter().map(Polygon::area).sum();
    a.area() - left
}

#[test]
fn a_poster_cuts_the_wall() {
    let (scene, warnings) =
        assemble(vec![at((0.0, 0.0, 4.0, 3.0), 0.0), at((1.0, 1.0, 1.0, 1.0), 0.0)]);
    assert_eq!(scene.face_areas(), [11.0, 1.0]);
    let expected = Repair::Covered { face: FaceId(0), by: FaceId(1), area: 1.0 };
    assert_eq!(warnings, [expected]);
    assert_eq!(
        warnings[0].to_string(),
        "face 0 overlaps the smaller face 1 in one plane, both looking the same way; the \
         part beneath (area 1.000000) was cut out of it"
    );
}

#[test]
fn of_equal_faces_the_earlier_wins_and_the_other_stays_a_face() {
    let square = at((0.0, 0.0, 1.0, 1.0), 2.0);
    let mut turned = square.clone();
    turned.rotate_left(1);
    let (scene, warnings) = assemble(vec![square, turned]);
    assert_eq!((scene.faces.len(), scene.surfaces.len()), (2, 1));
    assert_eq!(scene.face_areas(), [1.0, 0.0]);
    assert_eq!(warnings.len(), 1);
}

#[test]
fn a_wall_wholly_tiled_over_has_nothing_left() {
    let tile = |k: u32| at((f64::from(k % 2), f64::from(k / 2), 1.0, 1.0), 0.0);
    let mut outlines = vec![at((0.0, 0.0, 2.0, 2.0), 0.0)];
    outlines.extend((0..4).map(tile));
    let (scene, warnings) = assemble(outlines);
    assert_eq!(scene.face_areas(), [0.0, 1.0, 1.0, 1.0, 1.0]);
    assert_eq!(warnings.len(), 4);
}

#[test]
fn a_stamp_on_a_poster_on_a_wall_wins_over_both() {
    let (scene, _) = assemble(vec![
        at((0.0, 0.0, 8.0, 8.0), 0.0),
        at((1.0, 1.0, 4.0, 4.0), 0.0),
        at((2.0, 2.0, 1.0, 1.0), 0.0),
    ]);
    assert_eq!(scene.face_areas(), [48.0, 15.0, 1.0]);
}

#[test]
fn what_does_not_overlap_is_left_alone() {
    let floor = at((0.0, 0.0, 2.0, 1.0), 0.0);
    let mut lid = at((0.5, 0.25, 1.0, 0.5), 0.0);
    lid.reverse(); // back to back
    for other in [
        at((2.0, 0.0, 1.0, 1.0), 0.0),        // shares an edge
        at((2.0 - 1e-9, 0.0, 1.0, 1.0), 0.0), // and a rounding error
        at((2.0, 1.0, 1.0, 1.0), 0.0),        // shares a corner
        at((0.5, 0.25, 1.0, 0.5), 1e-3),      // lies a millimetre above
        vec![dvec3(1., 0., 0.), dvec3(1., 1., 0.), dvec3(1., 1., 1.)], // stands on it
        lid,
    ] {
        let (scene, warnings) = assemble(vec![floor.clone(), other]);
        assert_eq!((scene.surfaces.len(), warnings.len()), (2, 0));
    }
}

#[test]
fn rounded_corners_are_still_in_the_plane() {
    // Six decimals of a slanted wall 5 m wide, as exporters write them.
    let turn = DQuat::from_rotation_y(0.3) * DQuat::from_rotation_x(0.7);
    let rounded = |v: DVec3| (turn * v * 1e6).round() / 1e6;
    let outlines = [(0.0, 0.0, 5.0, 3.0), (1.0, 1.0, 0.4, 0.6)]
        .map(|r| at(r, 0.0).into_iter().map(rounded).collect());
    let (scene, warnings) = assemble(outlines.to_vec());
    assert_eq!(warnings.len(), 1);
    assert!((scene.face_areas()[0] - (15.0 - 0.24)).abs() < 1e-5);
}

#[test]
fn a_thousand_tiles_on_one_floor_and_ten_thousand_side_by_side() {
    let tiles = |n: u32, side: f64| {
        (0..n * n)
            .map(move |k| at((f64::from(k % n), f64::from(k / n), side, side), 0.0))
    };
    let (scene, warnings) = assemble(tiles(100, 1.0).collect());
    assert_eq!((scene.surfaces.len(), warnings.len()), (10_000, 0));
    let floor = at((0.0, 0.0, 32.0, 32.0), 0.0);
    let (scene, warnings) =
        assemble(std::iter::once(floor).chain(tiles(32, 0.5)).collect());
    assert_eq!(warnings.len(), 1024);
    assert!((scene.face_areas()[0] - 0.75 * 1024.0).abs() < 1e-9);
}

fn rectangle() -> impl Strategy<Value = Rectangle> {
    // Eighths: ties and shared edges abound.
    (0u8..16, 0u8..16, 1u8..16, 1u8..16).prop_map(|(x, y, w, h)| {
        let eighth = |k: u8| f64::from(k) / 8.0;
        (eighth(x), eighth(y), eighth(w), eighth(h))
    })
}

proptest! {
    /// No point of the plane is claimed twice, and none is lost.
    #[test]
    fn every_point_belongs_to_one_face(
        rectangles in proptest::collection::vec(rectangle(), 1..8),
        slant in -1.0..1.0f64,
    ) {
        let turn = DQuat::from_rotation_x(slant);
        let outline = |&r: &Rectangle| at(r, 0.0).into_iter().map(|v| turn * v).collect();
        let (scene, _) = assemble(rectangles.iter().map(outline).collect());
        for (k, a) in scene.surfaces.iter().enumerate() {
            for b in &scene.surfaces[k + 1..] {
                prop_assert!(shared(&a.polygon, &b.polygon).abs() < 1e-12);
            }
        }
        // In eighths, the union is counted exactly.
        let covered = (0..1024).filter(|k| {
            let (x, y) = (f64::from(k % 32) / 8.0 + 0.06, f64::from(k / 32) / 8.0 + 0.06);
            rectangles.iter().any(|&(left, low, w, h)| {
                (left..left + w).contains(&x) && (low..low + h).contains(&y)
            })
        });
        let union = covered.count() as f64 / 64.0;
        let area: f64 = scene.face_areas().iter().sum();
        prop_assert!((area - union).abs() < 1e-12, "{area} for {union}");
    }

    /// Nor does it matter in which order the faces come, if no two are equal.
    #[test]
    fn the_smaller_wins_in_any_order(x in 0.1..2.0, y in 0.1..2.0) {
        let (wall, poster) = (at((0.0, 0.0, 3.0, 3.0), 1.0), at((x, y, 2.0, 1.0), 1.0));
        let there = assemble(vec![wall.clone(), poster.clone()]).0.face_areas();
        let back = assemble(vec![poster, wall]).0.face_areas();
        prop_assert_eq!(there, [back[1], back[0]]);
    }
}
