//! Pictures: sRGB, exposure, files, views, drawings, comparison.

use crate::common::picture::assert_picture;
use glam::{DVec3, dvec3};
use radiosity::film::{
    FalseColour, Format, Picture, RgbImage, Shot, byte, colour_of_id, compare,
    hemicube_cross, linear_from_srgb, side_by_side, srgb_from_linear, write_atomically,
};
use radiosity::form_factor::hemicube::{CubeFace, Hemicube};
use radiosity::geometry::{Frame, Polygon, Rgb};
use radiosity::mesh::{Mesh, wachspress};
use radiosity::raster::{Seen, View};
use radiosity::scene::{Scene, built_in};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::Path;

const PICTURES: &str = "tests/pictures";

fn cornell() -> Scene {
    built_in("cornell").expect("the Cornell box is built in")
}

/// A stand-in for a solution: a radiosity for each place that is linear in it.
fn field(at: DVec3) -> Rgb {
    PI * (dvec3(0.05, 0.1, 0.4)
        + dvec3(1.0, 0.2, -0.4) * at.x
        + dvec3(0.1, 1.0, 0.5) * at.y)
}

fn shot(scene: &Scene, size: u32, samples: u32) -> Shot {
    Shot { camera: scene.camera, width: size, height: size, samples }
}

#[test]
fn srgb_meets_the_table() {
    let table: Value =
        serde_json::from_str(include_str!("../data/srgb_transfer.json")).unwrap();
    for case in table["cases"].as_array().unwrap() {
        let linear = case["params"]["linear"].as_f64().unwrap();
        let encoded = case["expected"]["encoded"].as_f64().unwrap();
        assert!((srgb_from_linear(linear) - encoded).abs() < 1e-15, "{case}");
        assert_eq!(u64::from(byte(linear)), case["expected"]["byte"].as_u64().unwrap());
        // The standard rounds its two thresholds: the branches differ by 4e-8 there.
        assert!((linear_from_srgb(encoded) - linear).abs() < 5e-8, "{case}");
    }
}

/// Failure 78: mid-grey in bytes is not half the light.
#[test]
fn half_the_code_is_a_fifth_of_the_light() {
    assert!((linear_from_srgb(0.5) - 0.2140).abs() < 5e-5);
}

/// Every byte survives a round trip through linear light.
#[test]
fn bytes_survive_a_round_trip() {
    for code in 0..=255_u8 {
        assert_eq!(byte(linear_from_srgb(f64::from(code) / 255.0)), code);
    }
}

#[test]
fn exposure_leaves_the_lamp_to_clamp() {
    let mut picture = Picture::new(10, 10);
    picture.pixels.fill(Rgb::splat(0.25));
    picture.pixels[7] = Rgb::splat(100.0);
    assert_eq!(picture.auto_exposure(), 4.0);
    assert_eq!(picture.clamped_share(4.0), 0.01);
    assert_eq!(picture.display(4.0).get_pixel(7, 0).0, [255; 3]);
    assert_eq!(Picture::new(4, 4).auto_exposure(), 1.0);
}

/// `.hdr` and `.exr` hold the radiance itself: EXR as f32, HDR to a shared exponent's 1
/// %.
#[test]
fn linear_files_hold_radiance() {
    let mut picture = Picture::new(9, 2);
    for (k, pixel) in picture.pixels.iter_mut().enumerate() {
        *pixel = dvec3(1.5, 3.0, 0.75) * 10_f64.powi(k as i32 % 9 - 4);
    }
    for (format, relative) in [(Format::Exr, 1e-7), (Format::Hdr, 1.0 / 128.0)] {
        let bytes = picture.encode(format, 123.0).unwrap();
        let read = image::load_from_memory(&bytes).unwrap().to_rgb32f();
        for (got, expected) in read.pixels().zip(&picture.pixels) {
            let got = DVec3::from_array(got.0.map(f64::from));
            let apart = (got - expected).abs().max_element();
            assert!(apart <= relative * expected.max_element(), "{got} {expected}");
        }
    }
}

#[test]
fn the_extension_names_the_format() {
    for (path, format) in [("a.png", Format::Png), ("b.HDR", Format::Hdr)] {
        assert_eq!(Format::of(Path::new(path)).unwrap(), format);
    }
    for path in ["a.jpeg", "png", ""] {
        let says = Format::of(Path::new(path)).unwrap_err().to_string();
        assert!(says.contains("end its name in .png, .hdr or .exr"), "{says}");
    }
    assert!(Picture::new(0, 0).encode(Format::Png, 1.0).is_err());
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("files");
    // left from an earlier run, or not there
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.txt");
    write_atomically(&path, b"one").unwrap();
    write_atomically(&path, b"two").unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"two");
    assert!(write_atomically(&folder, b"a folder is in the way").is_err());
    assert!(write_atomically(&folder.join("none/a.txt"), b"no such folder").is_err());
    assert_eq!(
        std::fs::read_dir(&folder).unwrap().count(),
        1,
        "nothing is left behind"
    );
    let siblings = std::fs::read_dir(folder.parent().unwrap()).unwrap();
    let names = siblings.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert!(names.into_iter().all(|name| !name.ends_with(".tmp")));
}

/// Wachspress weights are positive, sum to 1, and reproduce linear fields and corners.
#[test]
fn interpolation_is_exact_for_linear_fields() {
    let hexagon: Vec<DVec3> =
        [(0.0, 0.0), (1.0, -0.2), (1.6, 0.3), (1.5, 1.0), (0.7, 1.3), (0.1, 0.9)]
            .map(|(x, y)| dvec3(x, y, 0.5 * x - 0.2 * y))
            .to_vec();
    for outline in [&hexagon[..], &hexagon[..4], &hexagon[..3]] {
        let polygon = Polygon::new(outline.to_vec()).unwrap();
        let centre = polygon.centroid();
        for (k, &corner) in outline.iter().enumerate() {
            let next = outline[(k + 1) % outline.len()];
            for p in [corner, centre, corner.lerp(centre, 0.3), corner.lerp(next, 0.4)]
            {
                let weights = wachspress(&polygon, p);
                let values = outline.iter().zip(&weights).map(|(&v, &w)| w * field(v));
                let got: Rgb = values.sum();
                assert!(got.distance(field(p)) < 1e-14, "{got}, not {}", field(p));
                assert!(weights.iter().all(|w| (0.0..=1.0 + 1e-15).contains(w)));
            }
        }
    }
}

/// `Σ w_k v_k` is off from `p` by at most so many roundings of the polygon's size, times
/// how often the least height of a corner above the line through its neighbours goes into
/// it: the areas beside that corner are known to so many roundings only.
fn assert_reproduces(polygon: &Polygon, p: DVec3) {
    let v = polygon.vertices();
    let n = v.len();
    let size = v.iter().fold(0.0_f64, |most, a| most.max(a.length()));
    let least = (0..n).map(|k| {
        let (a, b, c) = (v[(k + n - 1) % n], v[k], v[(k + 1) % n]);
        ((b - a) / size).cross((c - a) / size).length() / ((c - a) / size).length()
    });
    let least = least.fold(1.0, f64::min);
    let weights = wachspress(polygon, p);
    let total: f64 = weights.iter().sum();
    let got: DVec3 = v.iter().zip(&weights).map(|(&v, &w)| w * (v / size)).sum();
    let off = got.distance(p / size);
    let most = 16.0 * f64::EPSILON / least;
    assert!(off <= most, "{n} corners of size {size:e}: {off:e} > {most:e}");
    assert!((total - 1.0).abs() < 1e-14 && weights.iter().all(|w| *w >= 0.0));
}

/// Points of all kinds: within, near an edge, on it, near a corner, in it.
fn points_of(polygon: &Polygon) -> Vec<DVec3> {
    let (v, centre) = (polygon.vertices(), polygon.centroid());
    let steps = [1, 2, 3, 5, 9, 17, 33, 65, 129, 257];
    let mut points = vec![centre];
    for k in steps.into_iter().filter(|&k| k <= v.len()).map(|k| k - 1) {
        let on_edge = v[k].lerp(v[(k + 1) % v.len()], 0.3);
        points.extend([v[k], on_edge, centre.lerp(v[k], 0.9)]);
        for near in [1e-3, 1e-8, 1e-15] {
            points.extend([v[k].lerp(centre, near), on_edge.lerp(centre, near)]);
        }
    }
    points
}

#[test]
fn interpolation_stands_many_corners_and_all_scales() {
    let turned = Frame::about(dvec3(0.36, 0.48, 0.8));
    for n in
        (3..=20).chain([31, 32, 63, 64, 100, 128, 200, 255, 256, 257, 400, 511, 512])
    {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / n as f64;
            turned.x * angle.cos() + turned.y * angle.sin()
        };
        for scale in [1e-70, 1e-30, 1e-3, 1.0, 1e30, 1e70] {
            let corners = (0..n).map(|k| scale * corner(k)).collect();
            let polygon = Polygon::new(corners).unwrap();
            points_of(&polygon).iter().for_each(|&p| assert_reproduces(&polygon, p));
        }
    }
}

#[test]
fn interpolation_stands_slivers() {
    for thin in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let at = |x: f64, y: f64| dvec3(x, y * thin, 0.0);
        for outline in [
            vec![at(0.0, 0.0), at(1.0, 0.0), at(0.4, 1.0)],
            vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)],
            vec![at(0.0, 0.0), at(0.5, -1.0), at(1.0, 0.0), at(0.3, 1.0)],
        ] {
            let polygon = Polygon::new(outline).unwrap();
            points_of(&polygon).iter().for_each(|&p| assert_reproduces(&polygon, p));
        }
    }
}

/// Pieces cut from faces that pierce each other may be as narrow as rounding, or have a
/// corner twice: their weights are numbers, and sum to 1.
#[test]
fn interpolation_stands_outlines_that_rounding_closes() {
    let (mut kept, far) = (0, dvec3(1e3 / 3.0, 1e3 / 7.0, 1e3 / 11.0));
    for thin in (12..20).map(|digits| 0.1_f64.powi(digits)) {
        let at = |x: f64, y: f64| far + dvec3(x, y * thin, x);
        for outline in [
            vec![at(0.0, 0.0), at(1.0, 0.0), at(0.4, 1.0)],
            vec![at(0.0, 0.0), at(0.5, 0.0), at(1.0, 0.0), at(0.3, 1.0)],
            vec![at(0.0, 0.0), at(0.0, 0.0), at(1.0, 0.0), at(0.4, 1.0)],
        ] {
            let Ok(polygon) = Polygon::new(outline) else { continue };
            kept += 1;
            for p in points_of(&polygon) {
                let weights = wachspress(&polygon, p);
                assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)), "{weights:?}");
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            }
        }
    }
    assert!(kept > 0, "no outline as narrow as that is a polygon");
}

/// A corner in the middle of a straight edge changes nothing, on the edge and off it.
#[test]
fn interpolation_passes_over_straight_corners() {
    let outline = [(0.0, 0.0), (1.0, 0.1), (3.0, 0.3), (2.0, 2.0), (0.0, 1.5)]
        .map(|(x, y)| dvec3(x, y, x - 2.0 * y));
    let straight = Polygon::new(outline.to_vec()).unwrap();
    let whole = [outline[0], outline[2], outline[3], outline[4]];
    let whole = Polygon::new(whole.to_vec()).unwrap();
    for p in points_of(&straight) {
        let mut weights = wachspress(&straight, p);
        assert_eq!(weights.remove(1), 0.0);
        for (got, expected) in weights.iter().zip(wachspress(&whole, p)) {
            assert!((got - expected).abs() < 1e-13, "{p}: {got}, not {expected}");
        }
    }
}

/// On a rectangle the weights are bilinear.
#[test]
fn interpolation_is_bilinear_on_rectangles() {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)];
    let outline = corners.map(|(x, y)| dvec3(x, y, 0.0)).to_vec();
    let weights = wachspress(&Polygon::new(outline).unwrap(), dvec3(0.5, 0.25, 0.0));
    for (got, expected) in weights.iter().zip([0.5625, 0.1875, 0.0625, 0.1875]) {
        assert!((got - expected).abs() < 1e-15, "{weights:?}");
    }
}

/// A linear field is shown as it is, in perspective: each pixel has the radiance `B/π`
/// of the point that it looks at (except beside outlines, where a pixel may look past).
#[test]
fn smooth_shading_is_correct_in_perspective() {
    let scene = cornell();
    let mesh = Mesh::uniform(&scene, 0.2);
    let of_vertices: Vec<Rgb> = mesh.vertices.iter().map(|&v| field(v)).collect();
    let shot = shot(&scene, 64, 1);
    let picture = shot.smooth(&mesh, &of_vertices);
    let view = shot.view();
    let items = shot.items(&mesh);
    for (k, (seen, got)) in items.pixels().zip(&picture.pixels).enumerate() {
        let Seen::Front(id) = seen else {
            assert_eq!(*got, Rgb::ZERO);
            continue;
        };
        let at = View::pixel_centre(k as u32 % 64, k as u32 / 64, 64, 64);
        let plane = mesh.elements[id as usize].polygon.plane();
        let direction = view.direction(at);
        let t = -plane.height(view.eye()) / plane.normal.dot(direction);
        let expected = field(view.eye() + direction * t) / PI;
        assert!(got.distance(expected) < 1e-4, "pixel {k}: {got}, not {expected}");
    }
}

/// More samples change edges only, and no mean.
#[test]
fn samples_are_averaged_in_linear_light() {
    let scene = cornell();
    let mesh = Mesh::uniform(&scene, 0.3);
    let white = vec![Rgb::splat(PI); mesh.elements.len()];
    let picture = shot(&scene, 32, 4).flat(&mesh, &white);
    let fine = shot(&scene, 128, 1).flat(&mesh, &white);
    for y in 0..32 {
        for x in 0..32 {
            let block =
                (0..16).map(|k| fine.pixels[(4 * y + k / 4) * 128 + 4 * x + k % 4]);
            let mean = block.sum::<Rgb>() / 16.0;
            assert!(picture.pixels[y * 32 + x].distance(mean) < 1e-12, "pixel {x} {y}");
        }
    }
}

#[test]
fn pictures_of_the_cornell_box() {
    let scene = cornell();
    let mesh = Mesh::uniform(&scene, 0.15);
    let of_elements: Vec<Rgb> =
        mesh.elements.iter().map(|e| field(e.polygon.centroid())).collect();
    let of_vertices: Vec<Rgb> = mesh.vertices.iter().map(|&v| field(v)).collect();
    let shot = shot(&scene, 96, 3);
    let flat = shot.flat(&mesh, &of_elements);
    let exposure = flat.auto_exposure();
    assert_picture(PICTURES, "view-flat", &flat.display(exposure));
    let smooth = shot.smooth(&mesh, &of_vertices);
    assert_picture(PICTURES, "view-smooth", &smooth.display(exposure));
    assert_picture(
        PICTURES,
        "view-mesh",
        &shot.with_mesh(flat.display(exposure), &mesh),
    );
    let false_colour = FalseColour::of(&smooth).draw(&smooth);
    assert_picture(PICTURES, "view-false-colour", &false_colour);
}

#[test]
fn pictures_of_an_unfolded_hemicube() {
    let scene = cornell();
    let mesh = Mesh::whole(&scene);
    let cube = Hemicube::new(&mesh, 16);
    let eye = dvec3(0.4, 0.0, 0.15); // on the floor, before the blocks
    let of_ids = hemicube_cross(&cube, eye, DVec3::Y, 4, |_, _, seen| match seen {
        Seen::Front(id) => colour_of_id(id),
        Seen::Back(_) => [40; 3],
        Seen::Nothing => [225; 3],
    });
    assert_picture(PICTURES, "hemicube-ids", &of_ids);
    let scale = FalseColour { low: 1e-5, high: 5e-3 };
    let of_weights =
        hemicube_cross(&cube, eye, DVec3::Y, 4, |face: CubeFace, cell, _| {
            scale.colour(cube.weights().of(face)[cell])
        });
    assert_picture(PICTURES, "hemicube-weights", &of_weights);
}

/// Cells that lie side by side on the unfolded hemicube lie side by side on the cube,
/// also across its edges: their directions, drawn as colours, differ by a cell's width
/// at most.
#[test]
fn the_cross_is_cut_only_where_it_must_be() {
    let mesh = Mesh::whole(&cornell());
    let n = 16;
    let cube = Hemicube::new(&mesh, n);
    let (eye, normal) = (DVec3::ZERO, DVec3::Z);
    let frame = cube.frame(eye, normal);
    let cross = hemicube_cross(&cube, eye, normal, 1, |face, cell, _| {
        let (width, height) = face.size(n);
        let at = View::pixel_centre(cell as u32 % n, cell as u32 / n, width, height);
        let direction = face.view(eye, &frame).direction(at);
        (frame.local_from_world(direction) * 100.0 + 120.0).to_array().map(|c| c as u8)
    });
    let white = image::Rgb([255; 3]);
    let step = (100.0 * 2.0 / n as f64) as u8 + 1;
    let mut pairs = 0;
    for (x, y, cell) in cross.enumerate_pixels() {
        for (dx, dy) in [(1, 0), (0, 1)] {
            let next = cross.get_pixel_checked(x + dx, y + dy).unwrap_or(&white);
            if *cell != white && *next != white {
                let apart = [0, 1, 2].map(|k| cell[k].abs_diff(next[k]));
                assert!(apart.iter().all(|&d| d <= step), "({x}, {y}): {apart:?}");
                pairs += 1;
            }
        }
    }
    // rows and columns of neighbours in the cross
    assert_eq!(pairs, 2 * (n * (2 * n - 1) + n * (n - 1)));
}

#[test]
fn false_colour_rises_evenly() {
    let scale = FalseColour { low: 0.1, high: 10.0 };
    let light = |value: f64| {
        let [r, g, b] =
            scale.colour(value).map(|c| linear_from_srgb(f64::from(c) / 255.0));
        radiosity::film::luminance(dvec3(r, g, b)).cbrt()
    };
    let values: Vec<f64> =
        (0..=50).map(|k| light(0.1 * 100_f64.powf(k as f64 / 50.0))).collect();
    let steps: Vec<f64> = values.windows(2).map(|v| v[1] - v[0]).collect();
    let mean = steps.iter().sum::<f64>() / 50.0;
    assert!(steps.iter().all(|s| (0.4..2.0).contains(&(s / mean))), "{steps:?}");
    for (value, end) in [(0.0, 0.1), (-1.0, 0.1), (99.0, 10.0), (f64::NAN, 0.1)] {
        assert_eq!(scale.colour(value), scale.colour(end));
    }
    let legend: Vec<f64> = scale.legend(3).iter().map(|stop| stop.0).collect();
    assert!((legend[1] - 1.0).abs() < 1e-12 && legend[2] == 10.0, "{legend:?}");
}

#[test]
fn differences_are_counted_and_shown() {
    let old = RgbImage::from_pixel(10, 4, image::Rgb([100; 3]));
    let mut new = old.clone();
    new.put_pixel(3, 2, image::Rgb([100, 101, 190]));
    new.put_pixel(4, 2, image::Rgb([102, 100, 100]));
    let found = compare(&old, &new, 2).unwrap();
    assert_eq!(
        found.to_string(),
        "1 of 40 pixels (2.50 %) differ by more than 2/255; worst 90 at (3, 2)"
    );
    assert_eq!(found.mean, (1 + 90 + 2) as f64 / 120.0);
    assert_eq!(side_by_side(&old, &new).dimensions(), (38, 4));
    assert!(compare(&old, &RgbImage::new(4, 10), 2).is_none());
}
