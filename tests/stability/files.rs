//! Pinned failures of display and files: rows 77 to 82 of the table of failures.

use crate::failures::display::{
    clamped, fans, notched, picked, quarter_cylinder, radiance_of_furnaces, ramp, read,
    round_trip, strips,
};
use crate::failures::rooms::{exact_factors, gathered};
use crate::failures::{Sweep, paths};
use glam::{DVec3, dvec2};
use radiosity::film::{Shot, byte, linear_from_srgb};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::Mesh;
use radiosity::raster::Seen;
use radiosity::scene::built_in;
use radiosity::solve::Enclosure;
use std::f64::consts::{FRAC_PI_2, PI};

/// How far a method is from the theory at the most.
fn off(sweep: &Sweep, method: usize) -> f64 {
    let pairs = sweep.found[method].points.iter().zip(&sweep.theory);
    pairs.fold(0.0, |worst, (got, right)| worst.max((got[1] - right[1]).abs()))
}

/// Row 77: radiosity is no radiance: what a picture of the furnace shows is `B/π`.
#[test]
fn row_77_a_picture_shows_radiance() {
    let scene = built_in("furnace:0.5").unwrap();
    let mesh = Mesh::uniform(&scene, 0.5);
    let enclosure = Enclosure::of(&scene, &mesh);
    let radiosity = gathered(&enclosure, &exact_factors(&mesh), 1e-10, 1000);
    let shot = Shot { camera: scene.camera, width: 16, height: 16, samples: 1 };
    for pixel in shot.flat(&mesh, &radiosity).pixels {
        assert!((pixel * PI - Rgb::splat(2.0)).abs().max_element() < 1e-8, "{pixel}");
    }
    let sweep = radiance_of_furnaces();
    assert!(off(&sweep, 0) < 1e-8);
    for (b, right) in sweep.found[1].points.iter().zip(&sweep.theory) {
        assert!((b[1] / right[1] - PI).abs() < 1e-7, "{b:?}");
    }
}

/// Row 78: between black and white lies half the light, code 188; the mean of the codes
/// is a fifth of it. So values are interpolated before they are coded.
#[test]
fn row_78_codes_are_not_light() {
    assert_eq!(byte(0.5), 188);
    assert!((linear_from_srgb(0.5) - 0.214).abs() < 1e-4);
    let sweep = ramp();
    // Half a code is 0.45 % of white at the bright end, where the curve is steepest.
    assert!(off(&sweep, 0) < 0.0045, "{}", off(&sweep, 0));
    let lost = off(&sweep, 1);
    assert!((0.285..0.300).contains(&lost), "{lost}");
}

/// Row 79: white hides how bright: of a furnace seen at three exposures the pictures
/// are equal, and the share that is clamped says why.
#[test]
fn row_79_white_hides_how_bright() {
    let scene = built_in("furnace:0.5").unwrap();
    let mesh = Mesh::whole(&scene);
    let shot = Shot { camera: scene.camera, width: 8, height: 8, samples: 1 };
    let picture = shot.flat(&mesh, &[Rgb::splat(2.0); 6]);
    let exposures = [0.9 * PI / 2.0, 1.1 * PI / 2.0, 11.0 * PI / 2.0];
    let [dim, bright, glaring] = exposures.map(|e| picture.display(e));
    assert!(bright == glaring && dim != bright);
    assert_eq!(exposures.map(|e| picture.clamped_share(e)), [0.0, 1.0, 1.0]);

    // A floor under a lamp: all is shown up to exposure 1, and then less and less of
    // it.
    let sweep = clamped();
    let shares = &sweep.found[1].points;
    for ((shown, share), right) in
        sweep.found[0].points.iter().zip(shares).zip(&sweep.theory)
    {
        let lost = 1.0 - shown[1] / right[1];
        let fits = shown[0] <= 1.0;
        assert_eq!(fits, share[1] == 0.0, "{shown:?}");
        assert_eq!(fits, lost.abs() < 0.01, "{shown:?}: {lost}");
        assert!(shown[0] < 8.0 || (0.522..0.524).contains(&lost), "{lost}");
    }
}

/// Row 80: faces of many corners, not convex: area is what the outline has, and a
/// warning names the line. A fan counts the notch instead of taking it off.
#[test]
fn row_80_outlines_keep_their_area() {
    let sweep = fans();
    assert!(off(&sweep, 0) < 1e-10, "{}", off(&sweep, 0));
    assert!(sweep.found[1].points.iter().all(|p| p[1].abs() < 1e-10));
    // Turned, it is the same outline seen from behind: a front is where corners turn
    // left.
    for reversed in [false, true] {
        let mut outline = notched(0.5).to_vec();
        if reversed {
            outline.reverse();
        }
        let corner = |v: &DVec3| format!("v {} {} {}\n", v.x, v.y, v.z);
        let text: String = outline.iter().map(corner).collect();
        // Normals of the file that say otherwise change nothing: corners count.
        let (scene, _) =
            read(&(text + "vn 0 0 1\nf 1//1 2//1 3//1 4//1 5//1\n"), "").unwrap();
        let up = if reversed { -1.0 } else { 1.0 };
        assert!(scene.surfaces.iter().all(|s| s.polygon.normal().z == up));
    }
}

/// Row 80: what has no meaning is refused, in a sentence that names file, line, value
/// and remedy; here one of each kind (all of them: `tests/files/obj.rs`).
#[test]
fn row_80_broken_files_are_refused_by_line() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let shown = format!("mtllib room.mtl\n{square}usemtl m\nf 1 2 3 4\n");
    let cases: [(&str, &str, &[&str]); 6] = [
        ("f 1 2 9\n", "", &["room.obj, line 5", "corner 9", "4 stand above"]),
        ("f 1 3 2 4\n", "", &["room.obj, line 5", "f 1 3 2 4", "crosses"]),
        ("f 1 1 1\n", "", &["room.obj, line 5", "f 1 1 1", "1 distinct"]),
        ("v 0 nan 0\n", "", &["room.obj, line 5", "`nan`", "finite"]),
        ("usemtl gold\nf 1 2 3\n", "", &["line 5", "`gold`", "define it with"]),
        (
            "",
            "newmtl m\nKd 1 .5 .5\n",
            &["room.mtl, line 2", "`m`", "(1, 0.5, 0.5)", "ower"],
        ),
    ];
    for (obj, mtl, words) in cases {
        let text =
            if mtl.is_empty() { format!("{square}{obj}") } else { shown.clone() };
        let error =
            read(&text, mtl).err().unwrap_or_else(|| panic!("accepted: {text}"));
        let said = error.to_string();
        assert!(words.iter().all(|word| said.contains(word)), "{said}");
    }
}

/// Row 81: pixel, id and pixel again: wherever edges fall, also through the middles of
/// pixels, the element that is picked is the one that lies there. And in the Cornell
/// box each pixel's ray meets the element that is picked.
#[test]
fn row_81_what_is_picked_is_what_is_seen() {
    for k in [1, 3, 8, 21, 64] {
        // With 8 and 64 elements and no shift every edge runs through corners of
        // pixels; moved by half a pixel, through their middles.
        for shift in [dvec2(0.0, 0.0), dvec2(1.0, 1.0) / 64.0, dvec2(0.011, 0.007)] {
            assert_eq!(round_trip(k, shift), 1.0, "{k} {shift}");
        }
    }
    let sweep = picked();
    assert!(sweep.found[0].points.iter().all(|p| p[1] == 100.0));
    // The mean of twelve random places.
    assert!(off(&sweep, 1) < 4.0, "{}", off(&sweep, 1));

    let scene = built_in("cornell").unwrap();
    let mesh = Mesh::uniform(&scene, 0.1);
    let shot = Shot { camera: scene.camera, width: 48, height: 48, samples: 1 };
    let (items, view) = (shot.items(&mesh), shot.view());
    let mut count = 0;
    for (x, y) in (0..48 * 48).map(|n| (n % 48, n / 48)) {
        let direction =
            view.direction(radiosity::raster::View::pixel_centre(x, y, 48, 48));
        let reach = |p: &Polygon| {
            let plane = p.plane();
            let t = -plane.height(view.eye()) / plane.normal.dot(direction);
            (t > 0.0 && p.contains(view.eye() + t * direction, 1e-9)).then_some(t)
        };
        let nearest = mesh.polygons().filter_map(reach).fold(f64::INFINITY, f64::min);
        match items.seen(x, y) {
            Seen::Front(id) | Seen::Back(id) => {
                let picked = reach(&mesh.elements[id as usize].polygon).unwrap();
                assert!((picked - nearest).abs() < 1e-6, "{x} {y}: {picked} {nearest}");
                count += 1;
            }
            Seen::Nothing => assert!(nearest.is_infinite(), "{x} {y}: {nearest}"),
        }
    }
    assert!(count > 1500, "{count}");
}

/// Row 82: strips for a curved wall: area and factor are of second order, the area
/// always too small and the factor always too large.
#[test]
fn row_82_strips_of_a_cylinder_are_of_second_order() {
    let sweep = strips();
    let [area, factor] = [0, 1].map(|k| &sweep.found[k].points);
    let mut before = f64::INFINITY;
    for ((area, factor), law) in area.iter().zip(factor).zip(&sweep.theory) {
        assert!(0.0 < area[1] && area[1] < before && factor[1] > 0.0);
        before = area[1];
        let theta = FRAC_PI_2 / area[0];
        // The next terms: θ²/80 of the area's law, and less than θ² of the factor's.
        assert!((area[1] / law[1] - 1.0).abs() < theta.powi(2) / 79.0, "{area:?}");
        assert!((factor[1] / law[1] / 2.0 - 1.0).abs() < theta.powi(2), "{factor:?}");
    }
    // Exactly: the wall gets what the sector of the lid leaves.
    for n in [1, 2, 7] {
        let lid = |k: usize| {
            let at = |k: usize| {
                DVec3::from((
                    dvec2(1.0, 0.0).rotate(glam::DVec2::from_angle(
                        FRAC_PI_2 * k as f64 / n as f64,
                    )),
                    1.0,
                ))
            };
            Polygon::new(vec![DVec3::Z, at(k), at(k + 1)]).unwrap()
        };
        let from_base = |p: Polygon| lambert_polygon(DVec3::ZERO, DVec3::Z, &p);
        let walls: f64 = quarter_cylinder(n).into_iter().map(from_base).sum();
        let lids: f64 = (0..n).map(|k| from_base(lid(k))).sum();
        assert!((walls + lids - 0.25).abs() < 1e-12, "{n}: {walls} {lids}");
    }
    // Nothing of this is lost on spheres of triangles: less area too.
    let ball: f64 = paths::sphere(DVec3::ZERO, 1.0, 32).iter().map(Polygon::area).sum();
    let missing = 1.0 - ball / (4.0 * PI);
    assert!(missing > 0.0 && missing < (PI / 32.0).powi(2), "{missing}");
}
