//! Pinned failures of the hemicube and of pictures of ids, row by row of the table of
//! failures. The curves: `failures/hemicube.rs` and `failures/raster.rs`.

use crate::failures::hemicube::{self, on_a_speck, over_places};
use crate::failures::raster::{self, as_colour, between, by_hybrid, cut_near, wall_at};
use crate::failures::rooms::{black, box_walls, moved, rectangle, rows, unit_square};
use crate::failures::shapes::{cube, mesh_of, squares_with_screen};
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::{CubeFace, Hemicube, Weights};
use radiosity::form_factor::pictures::{Pictures, unseen_by_plane};
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::geometry::Frame;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::radiometry::projected_solid_angle;
use radiosity::raster::{ItemBuffer, MAX_ID, Seen};
use std::f64::consts::PI;

/// Aliasing: a small square faces the eye from distance 1, in random directions. Root mean
/// square of the relative error.
#[test]
fn row_18_small_patches_alias() {
    for (resolution, side, rms) in [
        (32, 0.02, 2.33),
        (32, 0.1, 0.21),
        (64, 0.02, 0.83),
        (64, 0.05, 0.23),
        (64, 0.1, 0.088),
        (128, 0.02, 0.27),
        (128, 0.1, 0.031),
        (256, 0.02, 0.115),
    ] {
        let (got, _) = over_places(resolution, side, 4000);
        // The published squares lie along the cells, which makes it worse by up to 40 %;
        // ours are also rolled at random. Four thousand places: known to a few per cent.
        assert!((0.7..1.1).contains(&(got / rms)), "{resolution} {side}: {got}");
    }
    let sweep = hemicube::aliasing();
    for line in &sweep.found {
        for &[k, got] in &line.points {
            let share = got / sweep.expected(k);
            assert!((0.6..1.25).contains(&share), "{} {k}: {share}", line.method);
        }
    }
}

/// A lamp between the centres of the cells is not there: as often as its solid angle holds
/// none of the 3·32² centres, as long as it cannot hold two.
#[test]
fn row_19_a_small_lamp_is_missed() {
    for (resolution, side, missed) in
        [(32, 0.02, 0.81), (32, 0.1, 0.0), (64, 0.02, 0.31), (64, 0.05, 0.0)]
    {
        let (_, got) = over_places(resolution, side, 4000);
        assert!((got - missed).abs() < 0.03, "{resolution} {side}: {got}");
    }
    let sweep = hemicube::missed();
    for side in [0.005, 0.01, 0.02] {
        let (got, expected) = (sweep.at(side), sweep.expected(side));
        // A thousand places: four standard errors.
        let allowed = 4.0 * (expected * (100.0 - expected) / 1000.0).sqrt();
        assert!((got - expected).abs() < allowed, "{side}: {got}, not {expected}");
    }
}

/// A large wall shoots at a speck through one heavy cell of its hemicube: the speck gets 100
/// times more than there is. (It may be missed as well, and get nothing.)
#[test]
fn row_20_a_speck_gets_more_than_there_is() {
    let cell = on_a_speck(0.03, true);
    assert!((130.0..145.0).contains(&cell), "{cell} W/m² from a wall of 1 W/m²");
    let exact = on_a_speck(0.03, false);
    assert!((0.9..1.0).contains(&exact), "{exact}");
    let sweep = hemicube::speck();
    for &[ratio, law] in &sweep.theory {
        let (cell, exact) = (sweep.at(ratio), sweep.by(1, ratio));
        assert!((cell / law - 1.0).abs() < 0.01, "{ratio}: {cell}, not {law}");
        assert!((exact - 0.968).abs() < 1e-3, "{ratio}: {exact}");
    }
}

/// One cell of the top is so heavy that shooting through it at a tiny element sends more
/// than there is: `F_ji = F_ij A_i/A_j > 1` once `A_i/A_j` exceeds `1/ΔF`.
#[test]
fn row_20_one_cell_limits_the_ratio_of_areas() {
    for (resolution, ratio) in [(32, 804.0), (64, 3217.0), (256, 51_472.0)] {
        let weights = Weights::exact(resolution);
        let heaviest = weights.of(CubeFace::Top).iter().copied().fold(0.0, f64::max);
        // over a cell of width h at the zenith, 1/(x² + y² + 1)² falls by 4h²/3 in the
        // mean
        let tolerance = 6.0 / f64::from(resolution).powi(2) + 3e-4;
        assert!((1.0 / heaviest / ratio - 1.0).abs() < tolerance, "{resolution}");
    }
}

/// What the classic weights are off by, at 16 … 128: a quarter each time.
#[test]
fn row_21_classic_weights_miss_one_by_little() {
    let sweep = hemicube::delta_sum();
    for (resolution, miss) in
        [(16.0, 0.002123), (32.0, 0.00053), (64.0, 0.000132), (128.0, 0.0000331)]
    {
        let got = sweep.at(resolution);
        assert!((got - miss).abs() < 0.01 * miss, "{resolution}: {got}");
        assert!((got / sweep.expected(resolution) - 1.0).abs() < 0.01, "{got}");
        assert!(sweep.by(1, resolution) < 1e-13, "{}", sweep.by(1, resolution));
    }
}

/// Lamps in a row along the cells beat with them; turned hemicubes spread the same error as
/// noise over the receivers.
#[test]
fn row_22_turning_breaks_the_beat() {
    let sweep = hemicube::beat();
    for angle in [0.0, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0] {
        let (straight, law) = (sweep.at(angle), sweep.expected(angle));
        // The top's weights are not quite those of its middle line.
        assert!((straight - law).abs() < 0.05 * law + 1.0, "{angle}: {straight} {law}");
        let turned = sweep.by(1, angle);
        assert!((30.0..50.0).contains(&turned), "{angle}: {turned}");
    }
    // In step, all 38 are seen or none: √(.64/.36).
    assert!((sweep.at(0.0) - 133.3).abs() < 2.0, "{}", sweep.at(0.0));
    assert!(sweep.at(0.0) > 3.0 * sweep.by(1, 0.0));
}

/// The visibility assumption: the centre sees a screen's edge in one place, other points in
/// others. Three quarters are hidden. One hemicube sees nothing of what is left; k × k of
/// them err now this way, now that, until the elements are small. Asking what may stand
/// between, and doing those pairs exactly, repairs it at once.
#[test]
fn row_23_the_centre_sees_one_shadow() {
    let sweep = raster::one_shadow();
    for (k, percent) in
        [(1.0, -100.0), (2.0, 5.4), (3.0, -7.0), (4.0, 1.3), (5.0, -3.0), (6.0, 0.7)]
    {
        let (got, law) = (sweep.at(k), sweep.expected(k));
        assert!((got - percent).abs() < 0.2, "{k}: {got} %");
        // An edge that runs along the cells is off by half a cell of 256.
        assert!((got - law).abs() < 1.7, "{k}: {got}, not {law} %");
    }
    let (pair, exact) =
        (squares_with_screen(0.0..0.75, 0.0..1.0), 0.029_163_422_950_906);
    for k in [1.0, 2.0, 3.0, 4.0, 5.0, 6.0] {
        let repaired = between(&pair, 1.0 / k, &by_hybrid);
        assert!((repaired - exact).abs() < 1e-4, "{k}: {repaired}");
    }
}

/// An element touches the wall beside it: the corner is not lost, however small the gap. A
/// near plane loses all of that wall, which is half of the factor.
#[test]
fn row_24_no_near_plane_cuts_the_corner() {
    for gap in [1e-2, 1e-5, 1e-8] {
        let mesh = mesh_of(&[wall_at(gap)], 99.0);
        let mut row = [0.0];
        Hemicube::new(&mesh, 64).at(DVec3::ZERO, DVec3::Z, &mut row);
        assert!((row[0] - 0.5).abs() < 0.01 + gap, "gap {gap}: {row:?}");
        assert!((cut_near(0.0, &wall_at(gap)) - row[0]).abs() < 1e-15, "gap {gap}");
    }
    let sweep = raster::near_plane();
    for &[gap, law] in &sweep.theory {
        let (cut, ours) = (sweep.at(gap), sweep.by(1, gap));
        assert!((ours - law).abs() < 0.007, "{gap}: {ours}, not {law}");
        match gap {
            gap if gap < 1e-4 => assert_eq!(cut, 0.0),
            gap if gap < 1e-2 => assert!(cut < 0.4 * law, "{gap}: {cut}"),
            _ => assert_eq!(cut, ours),
        }
    }
    // An element of a closed room, flush in its corner: a black corner, and ours is whole.
    let corner = dvec3(1e-3, 1e-3, 0.0);
    let sum = |near: f64| -> f64 {
        let walls = box_walls([1.0; 3]);
        let seen =
            walls.iter().map(|wall| cut_near(near, &moved(wall, |p| p - corner)));
        seen.sum()
    };
    assert!(sum(0.01) < 0.4, "{}", sum(0.01));
    assert!((sum(0.0) - 1.0).abs() < 0.01, "{}", sum(0.0));
}

/// A poster in the plane of its wall: which of them a pixel shows is decided by rounding,
/// and anew when the eye moves by a millionth. Ours are settled when the scene is read: not
/// one pixel changes.
#[test]
fn row_25_coplanar_faces_do_not_fight() {
    let sweep = raster::fight();
    for shift in [1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3] {
        let (fights, settled) = (sweep.at(shift), sweep.by(1, shift));
        assert!((20.0..55.0).contains(&fights), "{shift}: {fights} %");
        assert_eq!(settled, 0.0, "{shift}");
    }
}

/// Ids are numbers, not colours: more than 2²⁴ of them do not overflow, and no pixel on an
/// edge is a blend of two.
#[test]
fn row_26_ids_neither_overflow_nor_blend() {
    let sweep = raster::colours();
    for &[patches, law] in &sweep.theory {
        assert!((sweep.at(patches) - law).abs() < 0.5, "{patches}: {sweep:?}");
        assert_eq!(sweep.by(1, patches), 0.0, "{patches}");
    }
    let frame = Frame::about(DVec3::Z);
    let view = CubeFace::Top.view(DVec3::ZERO, &frame);
    let mut buffer = ItemBuffer::new(64, 64);
    let ids = [(1 << 24) - 1, 1 << 24, (1 << 24) + 1, 1 << 25, MAX_ID];
    for (k, &id) in ids.iter().enumerate() {
        let tilted = rectangle(
            dvec3(0.37 * k as f64 - 0.9, -0.9, 1.0),
            dvec3(0.1, 1.7, 0.0),
            dvec3(0.31, 0.05, 0.0),
        );
        buffer.draw(&view, &tilted, id);
    }
    let number = |seen: Seen| match seen {
        Seen::Nothing => None,
        Seen::Front(id) | Seen::Back(id) => Some(id),
    };
    for id in ids {
        assert!(buffer.pixels().filter(|&p| number(p) == Some(id)).count() > 300);
    }
    assert!(buffer.pixels().filter_map(number).all(|id| ids.contains(&id)));
    // What smooths edges takes the mean of neighbours: as colours, that is a third id.
    let known = ids.map(as_colour);
    let colour = |x, y| number(buffer.seen(x, y)).map_or(0, as_colour);
    let blends = (0..64)
        .flat_map(|y| (0..63).map(move |x| (x, y)))
        .map(|(x, y)| colour(x, y).midpoint(colour(x + 1, y)));
    let strange = blends.filter(|&c| c != 0 && !known.contains(&c)).count();
    assert!(strange > 50, "{strange}");
}

/// The share that a single plane does not see is known from a closed form.
#[test]
fn row_27_a_single_plane_loses_the_horizon() {
    let sweep = raster::horizon();
    for &[half_width, law] in &sweep.theory {
        assert!((sweep.at(half_width) - law).abs() < 1e-11, "{half_width}");
        assert!(sweep.by(1, half_width) < 1e-10, "{half_width}");
    }
    let mesh = mesh_of(&cube(), 9.0);
    for (half_width, unseen) in [
        (0.5, 0.760_543_529_5),
        (1.0, 0.445_873_576_02),
        (2.0, 0.168_971_499_843),
        (10.0, 0.008_114_366_818_8),
    ] {
        let got = unseen_by_plane(half_width);
        assert!((got - unseen).abs() < 1e-10, "{half_width}: {got}");
        let pictures = Pictures::single_plane(&mesh, 64, half_width);
        let sum: f64 = pictures.weights().flatten().sum();
        assert!((sum - (1.0 - got)).abs() < 1e-13, "{half_width}: {sum}");
        // In a closed room the row is short by just that, and nothing says so.
        let mut row = vec![0.0; mesh.elements.len()];
        let lost = pictures.row(ElementId(0), &mut row);
        let sum: f64 = row.iter().sum();
        assert!((sum - (1.0 - got)).abs() < 1e-13, "{half_width}: {sum}");
        assert_eq!(lost, Lost::default());
    }
    // A light that stands on the horizon is not there for the plane.
    let wall = rectangle(dvec3(3., -1., 0.), DVec3::Z, DVec3::Y * 2.0);
    let mesh = mesh_of(&[wall], 9.0);
    let mut row = [0.0];
    Pictures::single_plane(&mesh, 256, 1.0).at(DVec3::ZERO, DVec3::Z, &mut row);
    assert_eq!(row, [0.0]);
    Pictures::tetrahedron(&mesh, 256).at(DVec3::ZERO, DVec3::Z, &mut row);
    let outline = mesh.elements[0].polygon.vertices();
    let exact = projected_solid_angle(DVec3::ZERO, DVec3::Z, outline) / PI;
    assert!((row[0] - exact).abs() < 0.001, "{row:?} {exact}");
}

/// The back of a wall is black and blocks: no light comes through it, and what falls on it
/// is booked.
#[test]
fn row_28_no_light_through_backs() {
    let sweep = raster::backs();
    for &[side, law] in &sweep.theory {
        let ours = sweep.by(1, side);
        assert!((ours - law).abs() < 2e-5, "{side}: {ours}, not {law}");
        assert!((sweep.at(side) - 0.199_825).abs() < 1e-6, "{}", sweep.at(side));
    }
    assert_eq!(sweep.by(1, 1.2), 0.0);
    let lamp = unit_square(0.0, true);
    let (behind, receiver) = (unit_square(0.5, true), unit_square(1.0, false));
    let large = moved(&behind, |v| dvec3(9.0 * v.x - 4.0, 9.0 * v.y - 4.0, v.z));
    let scene = black([lamp, receiver, large]);
    let mesh = Mesh::whole(&scene);
    let methods: [&dyn FormFactors; 3] = [
        &Analytic::new(&scene, &mesh, 1e-6, 0),
        &Hemicube::new(&mesh, 64),
        &Cast::new(&mesh, 1000, 0),
    ];
    for method in methods {
        let (row, lost) = rows(method).remove(0);
        assert_eq!(row, [0.0; 3]);
        assert!(lost.absorbed > 0.9, "{lost:?}");
    }
}
