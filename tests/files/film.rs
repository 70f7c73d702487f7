//! Pictures: sRGB, exposure, files, views, drawings, comparison.

use crate::common::picture::assert_picture;
use glam::{DVec3, dvec3};
use radiosity::film::{
    FalseColour, Format, Picture, RgbImage, Shot, byte, colour_of_id, compare,
    hemicube_cross, linear_from_srgb, side_by_side, srgb_from_linear, write_atomically,
};
use radiosity::form_factor::hemicube::{CubeFace, Hemicube};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
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
