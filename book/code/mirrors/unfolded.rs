//! A mirror, a lamp, and the world that is seen in it, in section.

use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::virtual_world::VirtualWorld;
use std::fmt::Write;

/// Upper end of the mirror `x = 1`, in metres.
pub const TOP: f64 = 0.6;

/// A scene of faces with what they are made of.
pub fn scene(faces: &[(&Polygon, Coefficients)]) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, coefficients)) in faces.iter().enumerate() {
        materials.extend(Material::new(format!("m{k}"), *coefficients));
        let material = MaterialId(k as u32);
        outlines.push(Face { outline: polygon.vertices().to_vec(), material });
    }
    Scene::assemble("mirrors", materials, outlines, None).expect("faces are fit").0
}

/// A rectangle from a corner and two edges.
pub fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    Polygon::new(vec![corner, corner + a, corner + a + b, corner + b])
        .expect("a rectangle is a polygon")
}

/// A mirror that keeps this share.
pub fn mirror(share: f64) -> Coefficients {
    let shine = Shine::Mirror { reflectance: Rgb::splat(share) };
    Coefficients { shine, ..Default::default() }
}

/// The unit square 1 above the origin, looking down.
pub fn lamp() -> Polygon {
    rectangle(dvec3(-0.5, -0.5, 1.0), DVec3::Y, DVec3::X)
}

/// A small floor about the origin, looking up.
pub fn floor() -> Polygon {
    rectangle(dvec3(-0.01, -0.01, 0.0), 0.02 * DVec3::X, 0.02 * DVec3::Y)
}

fn world() -> VirtualWorld {
    let wall = rectangle(dvec3(1.0, -50.0, 0.0), TOP * DVec3::Z, 100.0 * DVec3::Y);
    let lamp = lamp();
    let dull = Coefficients::default();
    VirtualWorld::of(
        &scene(&[(&lamp, dull), (&wall, mirror(1.0)), (&floor(), dull)]),
        1,
    )
}

/// Ends of the image of the lamp, and of the part of it that is seen from the origin.
fn image() -> [f64; 4] {
    let world = world();
    let image = &world.images()[1];
    let whole = image.of_polygon(&lamp());
    let seen = image.clip(DVec3::ZERO, whole.vertices()).unwrap_or_default();
    let ends = |v: &[DVec3]| {
        let x = || v.iter().map(|v| v.x);
        [x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max)]
    };
    let ([a, b], [c, d]) = (ends(whole.vertices()), ends(&seen));
    [a, b, c, d]
}

/// Factors from the origin to the image: through the window, and as if it had no edges.
pub fn factors() -> [f64; 2] {
    let world = world();
    let sights = world.sights(&floor(), &lamp());
    let once = sights.iter().filter(|sight| sight.level() == 1);
    let clipped = once.map(|sight| sight.factor(DVec3::ZERO, DVec3::Z).x).sum();
    let image = world.images()[1].of_polygon(&lamp());
    [clipped, lambert_polygon(DVec3::ZERO, DVec3::Z, &image)]
}

/// The caption, with its numbers.
pub fn caption() -> String {
    let [clipped, whole] = factors();
    let [.., from, to] = image();
    format!(
        "The lamp, a square of 1 m, hangs 1 m over the floor; the mirror ends {TOP} m above \
         it. Of the image, the part from {from:.3} m to {to:.1} m is seen: F = {clipped:.6}. \
         Without the window's edge it would be {whole:.6}, **{:.0} % more**.\n",
        100.0 * (whole / clipped - 1.0)
    )
}

/// The drawing, as SVG without ids, in the colour of the text around it.
pub fn svg() -> String {
    let at = |x: f64, z: f64| (150.0 + 150.0 * x, 190.0 - 150.0 * z);
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 560 230\" \
         width=\"560\" height=\"230\" role=\"img\" fill=\"none\" \
         stroke=\"currentColor\" font-size=\"14\">\n<title>Section: a floor, a lamp above \
         it, a mirror to the right and the image of the lamp behind the mirror; lines of sight \
         from a point of the floor through the mirror to the image</title>\n",
    );
    let mut line = |points: &[(f64, f64)], style: &str| {
        let points = points.iter().map(|&(x, z)| at(x, z));
        let points: Vec<String> =
            points.map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(svg, "<polyline points=\"{}\" {style}/>", points.join(" "));
    };
    let [image_from, image_to, from, to] = image();
    let (thin, dashed) =
        ("stroke-opacity=\"0.5\"", "stroke-dasharray=\"3 4\" stroke-opacity=\"0.6\"");
    let (orange, blue) = (
        "stroke-width=\"4\" stroke=\"#d55e00\"",
        "stroke-width=\"5\" stroke=\"#3b8fd0\"",
    );
    line(&[(-0.9, 0.0), (1.0, 0.0)], "");
    line(&[(1.0, 0.0), (2.7, 0.0)], dashed);
    line(&[(1.0, TOP), (1.0, 1.2)], dashed);
    for end in [from, to] {
        let hit = (1.0, 1.0 / end);
        line(&[(0.0, 0.0), hit], thin);
        line(&[hit, (end, 1.0)], dashed);
        line(&[hit, (2.0 - end, 1.0)], thin);
    }
    line(&[(-0.5, 1.0), (0.5, 1.0)], orange);
    line(&[(image_from, 1.0), (image_to, 1.0)], thin);
    line(&[(from, 1.0), (to, 1.0)], orange);
    line(&[(1.0, 0.0), (1.0, TOP)], blue);
    for (x, z, text) in [
        (-0.45, 1.08, "lamp"),
        (1.4, 1.08, "its image: what is seen, thick"),
        (1.04, 0.08, "mirror: a window"),
        (-0.06, -0.14, "x"),
    ] {
        let (x, y) = at(x, z);
        let style = "fill=\"currentColor\" stroke=\"none\"";
        let _ = writeln!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\" {style}>{text}</text>");
    }
    svg.push_str("</svg>\n");
    svg
}
