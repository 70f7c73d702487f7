//! Rows 39 to 42 and 46: what a mesh makes of light that it knows exactly at its
//! vertices.

use super::super::rooms::{box_walls, exact_factors, gathered, rectangle, scene};
use super::super::{Found, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::film::srgb_from_linear;
use radiosity::form_factor::Matrix;
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::{Element, Mesh, VertexId};
use radiosity::solve::Enclosure;
use radiosity::texture::linear_from_srgb;
use std::f64::consts::PI;

/// Four elements, one of which is split in four: two T-vertices. `B = x² + y²` at
/// vertices, of its own and with the T-vertices anchored; the side of the large
/// elements is `h`.
pub fn split_corner(h: f64) -> (Mesh, [Vec<Rgb>; 2]) {
    let square = rectangle(DVec3::ZERO, 2.0 * h * DVec3::X, 2.0 * h * DVec3::Y);
    let mesh = Mesh::patched(&scene([(square, 1.0, 0.5)]), h + 1e-9);
    let mesh = mesh.split(&[true, false, false, false]);
    let own: Vec<Rgb> =
        mesh.vertices.iter().map(|v| Rgb::splat(v.length_squared())).collect();
    let mut anchored = own.clone();
    mesh.anchor(&mut anchored);
    (mesh, [own, anchored])
}

/// Row 39: how far the field is torn in the middle of an edge with a T-vertex.
pub fn torn() -> Sweep {
    let edges = [0.5, 0.4, 0.3, 0.2, 0.1, 0.05];
    // The large element's edge is straight between its ends; where it is in its middle?
    let tear = |h: f64, anchored: usize| {
        let (mesh, values) = split_corner(h);
        let jump = |t: usize| {
            let at = mesh.vertices[t];
            let ends = |v: &DVec3| (v.distance(at) - 0.5 * h).abs() < 1e-9;
            // Along the edge, which runs where the small elements end.
            let along = |v: &DVec3| {
                let off = *v - at;
                if at.x > at.y { off.x.abs() < 1e-9 } else { off.y.abs() < 1e-9 }
            };
            let of = |k: usize| values[anchored][k].x;
            let around = (0..mesh.vertices.len())
                .filter(|&k| ends(&mesh.vertices[k]) && along(&mesh.vertices[k]));
            let ends: Vec<f64> = around.map(of).collect();
            assert_eq!(ends.len(), 2);
            (0.5 * (ends[0] + ends[1]) - of(t)).abs()
        };
        mesh.t_vertices().map(|t| jump(t.0 as usize)).fold(0.0, f64::max)
    };
    let line = |method, anchored| Found::over(method, &edges, |h| tear(h, anchored));
    Sweep {
        knob: "edge of the large element, m",
        quantity: "jump of B at the T-vertex, W/m²",
        logarithmic: [false, false],
        found: vec![line("a value of its own", 0), line("anchored (ours)", 1)],
        theory: curve(&edges, |h| 0.125 * h * h * 2.0),
        law: "h² |B''|/8, for B = x² + y²",
    }
}

/// The lamp of rows 40 and 41: a square of 0.2 that hangs 0.2 above the origin.
fn low_lamp() -> Polygon {
    rectangle(dvec3(-0.1, -0.1, 0.2), DVec3::Y * 0.2, DVec3::X * 0.2)
}

/// What is off along a line under the lamp's middle, with elements of edge `h`.
pub struct OnLine {
    /// One number for an element, that of its middle.
    pub flat: f64,
    /// Linear between exact values at the vertices.
    pub linear: f64,
    /// Linear between means of the neighbours' middles.
    pub averaged: f64,
    /// The largest kink of the linear field: the change of its slope.
    pub kink: f64,
}

impl OnLine {
    pub fn of(h: f64) -> OnLine {
        let lamp = low_lamp();
        let exact = |x: DVec3| lambert_polygon(x, DVec3::Z, &lamp);
        // A strip so narrow that it is a line, two elements longer than what is looked
        // at.
        let (half, width) = (0.5 + 2.0 * h, 1e-4);
        let corner = dvec3(-half, -0.5 * width, 0.0);
        let strip = rectangle(corner, DVec3::X * 2.0 * half, DVec3::Y * width);
        let mesh = Mesh::uniform(&scene([(strip, 0.0, 0.5)]), h);
        let means: Vec<Rgb> =
            mesh.polygons().map(|p| Rgb::splat(exact(p.centroid()))).collect();
        let averaged = mesh.vertex_values(&means);
        let corners: Vec<Rgb> =
            mesh.vertices.iter().map(|&v| Rgb::splat(exact(v))).collect();
        let mut on = OnLine { flat: 0.0, linear: 0.0, averaged: 0.0, kink: 0.0 };
        for (k, e) in mesh.elements.iter().enumerate() {
            let middle = e.polygon.centroid().x;
            if middle.abs() > 0.5 {
                continue;
            }
            for step in -100..=100 {
                let x = DVec3::X * (middle + 0.4999 * h * f64::from(step) / 100.0);
                let off = |b: Rgb| (b.x - exact(x)).abs();
                on.flat = on.flat.max(off(means[k]));
                on.linear = on.linear.max(off(mesh.value_at(e, x, &corners)));
                on.averaged = on.averaged.max(off(mesh.value_at(e, x, &averaged)));
            }
        }
        let at = |k: i32| exact(DVec3::X * (f64::from(k) * h));
        let most = (0.5 / h) as i32;
        for k in -most..=most {
            on.kink = on.kink.max(((at(k + 1) - 2.0 * at(k) + at(k - 1)) / h).abs());
        }
        on
    }
}

/// The edges of elements of rows 40 and 41, m.
pub const EDGES: [f64; 5] = [0.5, 0.25, 0.125, 0.0625, 0.03125];

/// The light on the line, by the closed form for a point below the corner of a
/// rectangle that is parallel to its ground (`x` by `y`, at height 0.2).
fn light_on_line(x: f64) -> f64 {
    let corner = |a: f64, b: f64| {
        let (a, b) = (a / 0.2, b / 0.2);
        let (p, q) = (a.hypot(1.0), b.hypot(1.0));
        (a / p * (b / p).atan() + b / q * (a / q).atan()) / (2.0 * PI)
    };
    2.0 * (corner(0.1 - x, 0.1) + corner(0.1 + x, 0.1))
}

/// The largest slope of the light on the line, and how fast its slope changes at most.
pub fn steepest() -> [f64; 2] {
    let d = 1e-4;
    let at = |k: i32| {
        let [a, b, c] = [-1, 0, 1].map(|s| light_on_line(f64::from(k + s) * d));
        [((c - a) / (2.0 * d)).abs(), ((a - 2.0 * b + c) / (d * d)).abs()]
    };
    (0..5000).map(at).fold([0.0; 2], |m, s| [m[0].max(s[0]), m[1].max(s[1])])
}

/// Row 40.
pub fn kinks() -> Sweep {
    let [_, bend] = steepest();
    Sweep {
        knob: "edge of an element, m",
        quantity: "largest change of slope at a vertex, W/m³",
        logarithmic: [true, true],
        found: vec![Found::over("linear between exact vertices", &EDGES, |h| {
            OnLine::of(h).kink
        })],
        theory: curve(&EDGES, |h| bend * h),
        law: "h max |B''|, once elements are small",
    }
}

/// Row 41.
pub fn flat_and_smooth() -> Sweep {
    let [slope, _] = steepest();
    let all: Vec<(f64, OnLine)> = EDGES.iter().map(|&h| (h, OnLine::of(h))).collect();
    let line = |method, of: fn(&OnLine) -> f64| Found {
        method,
        points: all.iter().map(|(h, on)| [*h, of(on)]).collect(),
    };
    Sweep {
        knob: "edge of an element, m",
        quantity: "largest error of B, W/m²",
        logarithmic: [true, true],
        found: vec![
            line("one number an element", |on| on.flat),
            line("between means of neighbours", |on| on.averaged),
            line("between exact vertices", |on| on.linear),
        ],
        theory: curve(&EDGES, |h| 0.5 * h * slope),
        law: "½ h max |B'|, one number an element; the others end with h²",
    }
}

/// Radiosities of the six walls of a cube: 1, but for the top, and at the vertices of
/// elements of ¼ m what `shown` makes of them. The largest that is off on a wall of 1.
fn off_at_corners(top: f64, shown: fn(&Mesh, &[Rgb]) -> Vec<Rgb>) -> f64 {
    let scene = scene(box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5)));
    let mesh = Mesh::uniform(&scene, 0.25);
    let own = |patch: u32| Rgb::splat(if patch == 5 { top } else { 1.0 });
    let values: Vec<Rgb> = mesh.elements.iter().map(|e| own(e.patch.0)).collect();
    let vertices = shown(&mesh, &values);
    let of = |e: &Element| -> f64 {
        let off = |c: &VertexId| (vertices[c.0 as usize].x - own(e.patch.0).x).abs();
        e.corners.iter().map(off).fold(0.0, f64::max)
    };
    mesh.elements.iter().filter(|e| e.patch.0 != 5).map(of).fold(0.0, f64::max)
}

/// The wrong way: the mean of all elements that have a corner in the place, whatever
/// wall they are of.
fn mean_of_all(mesh: &Mesh, values: &[Rgb]) -> Vec<Rgb> {
    let at = |place: &DVec3| {
        let here = |e: &Element| {
            e.polygon.vertices().iter().any(|v| v.distance(*place) < 1e-9)
        };
        let all = mesh.elements.iter().zip(values).filter(|(e, _)| here(e));
        let (sum, n) = all.fold((Rgb::ZERO, 0.0), |(s, n), (_, b)| (s + *b, n + 1.0));
        sum / n
    };
    mesh.vertices.iter().map(at).collect()
}

/// Row 42.
pub fn over_the_corner() -> Sweep {
    let tops = [1.0, 2.0, 4.0, 6.0, 8.0, 10.0];
    let line = |method, shown: fn(&Mesh, &[Rgb]) -> Vec<Rgb>| {
        Found::over(method, &tops, |top| off_at_corners(top, shown))
    };
    Sweep {
        knob: "radiosity of the ceiling / that of the walls",
        quantity: "error on the walls / their radiosity",
        logarithmic: [false, false],
        found: vec![
            line("mean over all elements at a vertex", mean_of_all),
            line("mean over those of one wall (ours)", |mesh, b| mesh.vertex_values(b)),
        ],
        theory: curve(&tops, |top| 0.5 * (top - 1.0)),
        law: "half of the step: two elements of either wall meet there",
    }
}

/// How bright, in W, a cube is by reflected light whose floor has this reflectance, in
/// 8 × 8 tiles; its ceiling emits 1 W/m².
fn reflected(tiles: &(Enclosure, Matrix), rho: [f64; 2]) -> f64 {
    let (room, factors) = tiles;
    let mut room = room.clone();
    // The tiles come after the five walls.
    for k in 0..64 {
        room.reflectance[5 + k] = Rgb::splat(rho[(k % 8 + k / 8) % 2]);
    }
    let light = gathered(&room, factors, 1e-12, 10_000);
    room.power(light.iter().zip(&room.emission).map(|(&b, &e)| b - e)).x
}

fn tiled_room() -> (Enclosure, Matrix) {
    let mut faces: Vec<_> = box_walls([1.0; 3]).map(|w| (w, 0.0, 0.5)).to_vec();
    faces[5].1 = 1.0;
    faces.remove(4); // the floor, which is tiled
    for k in 0..64 {
        let corner = dvec3(f64::from(k % 8), f64::from(k / 8), 0.0) / 8.0;
        let tile = rectangle(corner, DVec3::X / 8.0, DVec3::Y / 8.0);
        faces.push((tile, 0.0, 0.5));
    }
    let scene = scene(faces);
    let mesh = Mesh::whole(&scene);
    (Enclosure::of(&scene, &mesh), exact_factors(&mesh))
}

/// The same in one's head: floor, four sides, ceiling, each of one brightness. A cube's
/// walls see the opposite one by .199825, each other one by a quarter of the rest.
fn reflected_by(floor: f64) -> f64 {
    let opposite = 0.199_824_895;
    let beside = 0.25 * (1.0 - opposite);
    let [mut b, mut side, mut top] = [0.0, 0.0, 1.0];
    for _ in 0..200 {
        let arrives = [
            opposite * top + 4.0 * beside * side,
            (opposite + 2.0 * beside) * side + beside * (b + top),
            opposite * b + 4.0 * beside * side,
        ];
        [b, side, top] = [floor * arrives[0], 0.5 * arrives[1], 1.0 + 0.5 * arrives[2]];
    }
    b + 4.0 * side + top - 1.0
}

/// Row 46: what of the reflected light is lost by a mean of codes.
pub fn mean_of_codes() -> Sweep {
    let room = tiled_room();
    let mean = |dark: f64| 0.5 * (0.9 + dark);
    let of_codes = |dark: f64| {
        linear_from_srgb(0.5 * (srgb_from_linear(0.9) + srgb_from_linear(dark)))
    };
    let darks = [0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9];
    let line = |method, of: &dyn Fn(f64) -> f64| {
        Found::over(method, &darks, |dark| {
            let tiled = reflected(&room, [0.9, dark]);
            100.0 * (1.0 - reflected(&room, [of(dark); 2]) / tiled)
        })
    };
    let theory =
        |dark: f64| 1.0 - reflected_by(of_codes(dark)) / reflected_by(mean(dark));
    Sweep {
        knob: "reflectance of the dark tiles (the bright: 0.9)",
        quantity: "reflected light that is lost, %",
        logarithmic: [false, false],
        found: vec![
            line("mean of sRGB codes", &of_codes),
            line("mean of reflectances (ours)", &mean),
        ],
        theory: curve(&darks, |dark| 100.0 * theory(dark)),
        law: "a cube whose floor has the mean of the codes, by hand",
    }
}
