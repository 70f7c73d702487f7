//! Failures of display and files: rows 77 to 82.

use super::rooms::{exact_factors, gathered, rectangle};
use super::{Found, Row, Shown, Sweep};
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::film::{Picture, Shot, linear_from_srgb, srgb_from_linear};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::Mesh;
use radiosity::obj;
use radiosity::random::Stream;
use radiosity::raster::{ItemBuffer, Seen, View};
use radiosity::scene::{Scene, built_in};
use radiosity::solve::Enclosure;
use std::f64::consts::{FRAC_PI_2, PI};
use std::io;
use std::path::Path;

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 77,
        name: "Radiosity shown as radiance",
        why: "A solver holds B, in W/m²; an eye sees L, in W/(m² sr). A diffuse \
              surface that sends B in all shows L = B/π in each direction.",
        size: "Forgotten, the picture is 3.14159 times too bright at every \
               reflectance; ours shows E/(π(1 − ρ)) of a furnace to 1e-8.",
        remedy: "One function turns B into L, and a furnace whose radiance is known \
                 tests the picture and not the solution alone.",
        tests: &["files::row_77_a_picture_shows_radiance"],
        shown: Shown::Curve(radiance_of_furnaces),
    },
    Row {
        number: 78,
        name: "Codes are not light",
        why: "sRGB codes are spaced as the eye likes it, about as light to the power \
              1/2.2. The mean of two codes is not the code of the mean light.",
        size: "Halfway between black and white the mean of the codes shows 0.214 where \
               0.5 is due; ours is off by half a code at most.",
        remedy: "Interpolate, filter and add radiance; code it as the last step.",
        tests: &["files::row_78_codes_are_not_light"],
        shown: Shown::Curve(ramp),
    },
    Row {
        number: 79,
        name: "White hides how bright",
        why: "What is above white is clamped. Two pictures that are white at the same \
              places are equal there, however far their light is apart.",
        size: "Under a low lamp, at eight times the exposure that just fits, 52 % of \
               the light is not shown; the share of clamped pixels says that something \
               is hidden.",
        remedy: "Report the clamped share, compare radiance and not codes, keep `.hdr` \
                 or `.exr`.",
        tests: &["files::row_79_white_hides_how_bright"],
        shown: Shown::Curve(clamped),
    },
    Row {
        number: 80,
        name: "A file that means something else",
        why: "Exporters write what readers like: faces of many corners, not all \
              convex, turned normals, Kd of 1 and more. A reader that makes the best \
              of it, silently, solves another scene.",
        size: "A fan from the first corner gives a notched square up to three times \
               its area; ours has it to rounding. Every broken file of the tests (51 \
               of them) is refused.",
        remedy: "Split as the outline says and warn; refuse what has no meaning, \
                 naming file, line, value and remedy.",
        tests: &[
            "files::row_80_outlines_keep_their_area",
            "files::row_80_broken_files_are_refused_by_line",
        ],
        shown: Shown::Curve(fans),
    },
    Row {
        number: 81,
        name: "The wrong thing is picked",
        why: "Picking reads an id at a pixel. Ids that were drawn as colours and \
              smoothed at edges are ids of something else; and a patch's id is no \
              element's.",
        size: "Ours picks right at 100 % of the pixels, edges included; ids smoothed \
               over 4 × 4 samples are lost at every edge, 40 % of the pixels at 20 × \
               20 elements in 64 × 64 pixels.",
        remedy: "Pick from an item buffer: one sample for each pixel, whole numbers, \
                 and a rule that gives each edge to one of its two sides.",
        tests: &["files::row_81_what_is_picked_is_what_is_seen"],
        shown: Shown::Curve(picked),
    },
    Row {
        number: 82,
        name: "Flat pieces for a curved wall",
        why: "Strips between lines on a cylinder are chords: less area, and nearer to \
              the axis than the wall that they stand for.",
        size: "A quarter cylinder in n strips has (π/2n)²/24 too little area and, from \
               the middle of its base, (π/2n)²/12 too large a factor: 1 % and 2 % at \
               three strips, and a quarter of that for twice as many.",
        remedy: "As many strips as the error asks for, which is second order; scale \
                 reflected flux by the exact area where it matters. (Splines are not \
                 evaluated here yet, so neither are their weights and degenerate edges.)",
        tests: &["files::row_82_strips_of_a_cylinder_are_of_second_order"],
        shown: Shown::Curve(strips),
    },
];

/// Row 77: the radiance that a picture of the white furnace shows, over its
/// reflectance.
pub fn radiance_of_furnaces() -> Sweep {
    let shown = |rho: f64| {
        let scene = built_in(&format!("furnace:{rho}")).unwrap();
        let mesh = Mesh::whole(&scene);
        let enclosure = Enclosure::of(&scene, &mesh);
        let b = gathered(&enclosure, &exact_factors(&mesh), 1e-10, 2000);
        let shot = Shot { camera: scene.camera, width: 8, height: 8, samples: 1 };
        (shot.flat(&mesh, &b).pixels[27].x, b[0].x)
    };
    let rhos: Vec<f64> = (1..10).map(|k| f64::from(k) / 10.0).collect();
    let all: Vec<_> = rhos.iter().map(|&rho| (rho, shown(rho))).collect();
    Sweep {
        knob: "reflectance of the furnace",
        quantity: "radiance in the picture, W/(m² sr)",
        logarithmic: [false, true],
        found: vec![
            Found {
                method: "ours",
                points: all.iter().map(|(rho, (l, _))| [*rho, *l]).collect(),
            },
            Found {
                method: "B taken for L",
                points: all.iter().map(|(rho, (_, b))| [*rho, *b]).collect(),
            },
        ],
        theory: rhos.iter().map(|rho| [*rho, 1.0 / (PI * (1.0 - rho))]).collect(),
        law: "E/(π(1 − ρ))",
    }
}

/// Row 78: the light of a ramp from black to white whose codes are the right ones, and
/// of one whose codes are even.
pub fn ramp() -> Sweep {
    let places: Vec<f64> = (0..=16).map(|k| f64::from(k) / 16.0).collect();
    let shown = |code: &dyn Fn(f64) -> f64| {
        let light =
            |t: &f64| [*t, linear_from_srgb((255.0 * code(*t)).round() / 255.0)];
        places.iter().map(light).collect()
    };
    Sweep {
        knob: "way from black to white",
        quantity: "light shown, of white",
        logarithmic: [false, false],
        found: vec![
            Found { method: "light is interpolated", points: shown(&srgb_from_linear) },
            Found { method: "codes are", points: shown(&|t| t) },
        ],
        theory: places.iter().map(|t| [*t, *t]).collect(),
        law: "as far, as bright",
    }
}

/// Row 79: a floor under a low lamp, exposed more and more; 1 is when its brightest
/// place is just white.
pub fn clamped() -> Sweep {
    let lamp = rectangle(dvec3(0.4, 0.4, 0.2), DVec3::Y * 0.2, DVec3::X * 0.2);
    let size = 48;
    let mut floor = Picture::new(size, size);
    for (k, pixel) in floor.pixels.iter_mut().enumerate() {
        let at = |k: usize| (k as f64 + 0.5) / f64::from(size);
        let x = dvec3(at(k % size as usize), at(k / size as usize), 0.0);
        *pixel = Rgb::splat(lambert_polygon(x, DVec3::Z, &lamp));
    }
    let brightest = floor.pixels.iter().fold(0.0, |m: f64, l| m.max(l.x));
    let mean = floor.pixels.iter().map(|l| l.x).sum::<f64>() / f64::from(size * size);
    let (mut shown, mut share, mut theory) = (vec![], vec![], vec![]);
    for k in -2..=6 {
        let exposure = 2f64.powi(k);
        let e = exposure / brightest;
        let codes = floor.display(e).into_raw().into_iter();
        let light: f64 = codes.map(|c| linear_from_srgb(f64::from(c) / 255.0)).sum();
        shown.push([exposure, light / f64::from(3 * size * size)]);
        share.push([exposure, floor.clamped_share(e)]);
        theory.push([exposure, e * mean]);
    }
    Sweep {
        knob: "exposure; at 1 the brightest pixel is just white",
        quantity: "share of white",
        logarithmic: [true, false],
        found: vec![
            Found { method: "mean light shown", points: shown },
            Found { method: "clamped pixels", points: share },
        ],
        theory: theory.into_iter().filter(|p| p[1] < 1.5).collect(),
        law: "mean light",
    }
}

/// The unit square with a notch from its left side, so deep.
pub fn notched(depth: f64) -> [DVec3; 5] {
    [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (depth, 0.5)]
        .map(|(x, y)| dvec3(x, y, 0.0))
}

/// Row 80: the area of a notched square as triangles about its first corner, and as it
/// is read from a file.
pub fn fans() -> Sweep {
    let fan = |outline: &[DVec3]| -> f64 {
        let doubled =
            |k: usize| (outline[k] - outline[0]).cross(outline[k + 1] - outline[0]);
        (1..outline.len() - 1).map(|k| 0.5 * doubled(k).length()).sum()
    };
    let as_read = |outline: &[DVec3]| -> f64 {
        let corner = |v: &DVec3| format!("v {} {} {}\n", v.x, v.y, v.z);
        let text: String = outline.iter().map(corner).collect();
        let text = text + "f 1 2 3 4 5\n";
        let (scene, warnings) = read(&text, "").unwrap();
        assert!(warnings.iter().any(|w| w.line == Some(6)), "{warnings:?}");
        scene.surfaces.iter().map(|s| s.polygon.area()).sum()
    };
    let depths: Vec<f64> = (1..10).map(|k| f64::from(k) / 10.0).collect();
    let off = |area: &dyn Fn(&[DVec3]) -> f64| {
        let error =
            |t: &f64| [*t, 100.0 * (area(&notched(*t)) / (1.0 - 0.5 * t) - 1.0)];
        depths.iter().map(error).collect()
    };
    Sweep {
        knob: "depth of the notch",
        quantity: "error of the area, %",
        logarithmic: [false, false],
        found: vec![
            Found { method: "a fan from the first corner", points: off(&fan) },
            Found { method: "ours: split, with a warning", points: off(&as_read) },
        ],
        theory: depths.iter().map(|t| [*t, 100.0 * t / (1.0 - 0.5 * t)]).collect(),
        law: "the notch counts and is not taken off: t/(1 − t/2)",
    }
}

/// Reads `obj` as `room.obj`, beside which there is only `room.mtl`.
pub fn read(obj: &str, mtl: &str) -> Result<(Scene, Vec<obj::Warning>), obj::ObjError> {
    obj::read(Path::new("room.obj"), obj.as_bytes(), |path| match path.to_str() {
        Some("room.mtl") => Ok(mtl.into()),
        _ => Err(io::ErrorKind::NotFound.into()),
    })
}

/// Pixels along an edge of the picture of row 81.
const PIXELS: u32 = 64;

/// The square `|x|, |y| ≤ 1` in `k × k` elements, moved by `shift`, as seen from above
/// it by a view that it more than fills.
fn grid(k: usize, shift: DVec2) -> (View, Vec<Polygon>) {
    let view = View::new(DVec3::Z, DVec3::X, DVec3::Y, DVec3::NEG_Z);
    let edge = 2.0 / k as f64;
    let element = |n: usize| {
        let place = |n: usize| edge * n as f64 - 1.0 - edge;
        let [x, y] = [n % (k + 2), n / (k + 2)].map(place);
        rectangle(
            dvec3(x + shift.x, y + shift.y, 0.0),
            DVec3::X * edge,
            DVec3::Y * edge,
        )
    };
    (view, (0..(k + 2) * (k + 2)).map(element).collect())
}

fn drawn(view: &View, elements: &[Polygon], size: u32) -> ItemBuffer {
    let mut buffer = ItemBuffer::new(size, size);
    for (id, element) in elements.iter().enumerate() {
        buffer.draw(view, element, id as u32);
    }
    buffer
}

/// The share of pixels whose id names the element that lies under their centre.
pub fn round_trip(k: usize, shift: DVec2) -> f64 {
    let (view, elements) = grid(k, shift);
    let buffer = drawn(&view, &elements, PIXELS);
    let right = |x: u32, y: u32| {
        let d = view.direction(View::pixel_centre(x, y, PIXELS, PIXELS));
        let on_floor = DVec3::Z - d / d.z;
        match buffer.seen(x, y) {
            Seen::Front(id) => elements[id as usize].contains(on_floor, 1e-9),
            _ => false,
        }
    };
    let all = (0..PIXELS * PIXELS).filter(|n| right(n % PIXELS, n / PIXELS)).count();
    all as f64 / f64::from(PIXELS * PIXELS)
}

/// The share of pixels whose 4 × 4 samples have all one id: those that smoothing
/// spares.
fn unmixed(k: usize, shift: DVec2) -> f64 {
    let (view, elements) = grid(k, shift);
    let fine = drawn(&view, &elements, 4 * PIXELS);
    let pure = |x: u32, y: u32| {
        let id = |n: u32| fine.seen(4 * x + n % 4, 4 * y + n / 4);
        (1..16).all(|n| id(n) == id(0))
    };
    let all = (0..PIXELS * PIXELS).filter(|n| pure(n % PIXELS, n / PIXELS)).count();
    all as f64 / f64::from(PIXELS * PIXELS)
}

/// Row 81: pixels that pick the element under them, over the number of elements.
pub fn picked() -> Sweep {
    let elements = [2, 4, 8, 12, 16, 20, 24, 28, 32];
    let shifts = |k: usize| {
        let mut random = Stream::named(81, &[k as u64]);
        let edge = 2.0 / k as f64;
        (0..12).map(move |_| edge * dvec2(random.next(), random.next()))
    };
    let mean = |of: &dyn Fn(usize, DVec2) -> f64| {
        let at = |k: usize| 100.0 * shifts(k).map(|s| of(k, s)).sum::<f64>() / 12.0;
        elements.iter().map(|&k| [k as f64, at(k)]).collect()
    };
    // An edge falls among the 4 samples of a pixel three times in four.
    let spared = |k: f64| 100.0 * (1.0 - 0.75 * k / f64::from(PIXELS)).powi(2);
    Sweep {
        knob: "elements along the edge of a picture of 64 × 64 pixels",
        quantity: "pixels that pick the element under them, %",
        logarithmic: [false, false],
        found: vec![
            Found { method: "ours: item buffer", points: mean(&round_trip) },
            Found { method: "ids as smoothed colours", points: mean(&unmixed) },
        ],
        theory: elements.iter().map(|&k| [k as f64, spared(k as f64)]).collect(),
        law: "(1 − ¾ k/64)²: an edge spoils its pixels",
    }
}

/// A quarter of a cylinder of radius and height 1 about the z axis, in `n` flat strips
/// that look at the axis.
pub fn quarter_cylinder(n: usize) -> Vec<Polygon> {
    let at = |k: usize| {
        let (sin, cos) = (FRAC_PI_2 * k as f64 / n as f64).sin_cos();
        dvec3(cos, sin, 0.0)
    };
    let strip = |k: usize| rectangle(at(k + 1), at(k) - at(k + 1), DVec3::Z).flipped();
    (0..n).map(strip).collect()
}

/// Row 82: a quarter cylinder in flat strips: its area, and its factor from the middle
/// of its base, which is `¼ h²/(r² + h²) = ⅛`.
pub fn strips() -> Sweep {
    let counts = [1, 2, 3, 4, 6, 8, 12, 16, 32, 64];
    let area = |n: usize| {
        let area: f64 = quarter_cylinder(n).iter().map(Polygon::area).sum();
        100.0 * (1.0 - area / FRAC_PI_2)
    };
    let factor = |n: usize| {
        let from_base = |p: &Polygon| lambert_polygon(DVec3::ZERO, DVec3::Z, p);
        let factor: f64 = quarter_cylinder(n).iter().map(from_base).sum();
        100.0 * (factor / 0.125 - 1.0)
    };
    let points =
        |of: &dyn Fn(usize) -> f64| counts.iter().map(|&n| [n as f64, of(n)]).collect();
    let law = |n: &usize| [*n as f64, 100.0 * (FRAC_PI_2 / *n as f64).powi(2) / 24.0];
    Sweep {
        knob: "strips",
        quantity: "area missing, factor in excess, %",
        logarithmic: [true, true],
        found: vec![
            Found { method: "area", points: points(&area) },
            Found { method: "factor", points: points(&factor) },
        ],
        theory: counts.iter().map(law).collect(),
        law: "θ²/24 of the area, θ the angle of a strip",
    }
}
