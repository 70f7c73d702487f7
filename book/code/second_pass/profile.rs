//! The lobe in section, the one cone that stands for it, and a stack of four.

use radiosity::geometry::Polygon;
use radiosity::glam::{DVec3, dvec3};
use radiosity::trace::Cone;
use std::fmt::Write;

/// The lobe that is drawn.
const EXPONENT: f64 = 100.0;

/// The share that the one cone holds.
const SHARE: f64 = 0.9;

/// Cones in the stack that is drawn.
const STACK: u32 = 4;

/// Pixels for a degree, and for the height of the lobe.
const SCALE: [f64; 2] = [9.0, 180.0];

fn at(degrees: f64, height: f64) -> String {
    format!("{:.1},{:.1} ", 300.0 + SCALE[0] * degrees, 210.0 - SCALE[1] * height)
}

/// What a ring at this angle counts in one cone, where the lobe's peak counts 1.
fn one_cone(degrees: f64) -> f64 {
    let half_angle = Cone::holding(SHARE, EXPONENT, DVec3::Z).half_angle;
    // Of equal sum: the lobe has 2π/(n + 2) of projected solid angle, the cone π sin²β.
    let height = 2.0 / ((EXPONENT + 2.0) * half_angle.sin().powi(2));
    if degrees.abs().to_radians() < half_angle { height } else { 0.0 }
}

fn stack(degrees: f64) -> f64 {
    let level = |k: u32| (f64::from(k) + 0.5) / f64::from(STACK);
    let holds = |k: &u32| {
        let cone = Cone::above(level(*k), EXPONENT, DVec3::Z);
        degrees.abs().to_radians() < cone.half_angle
    };
    (0..STACK).filter(holds).count() as f64 / f64::from(STACK)
}

fn lobe(degrees: f64) -> f64 {
    degrees.to_radians().cos().powf(EXPONENT)
}

/// A height over an angle.
type Profile = fn(f64) -> f64;

/// The drawing, in the colour of the text around it.
pub fn svg() -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 250\" width=\"600\" \
         height=\"250\" role=\"img\" fill=\"none\" stroke=\"currentColor\" \
         font-size=\"14\">\n<title>A Phong lobe over the angle from its axis, one cone of \
         the same power, and four cones stacked</title>\n",
    );
    let curves: [(Profile, &str); 3] = [
        (one_cone, "stroke=\"#d55e00\" stroke-width=\"2\""),
        (stack, "stroke=\"#3b8fd0\" stroke-width=\"2\""),
        (lobe, "stroke-width=\"1.5\""),
    ];
    for (height, style) in curves {
        let points: String = (-600..=600)
            .map(|k| f64::from(k) / 20.0)
            .map(|degrees| at(degrees, height(degrees)))
            .collect();
        let _ = writeln!(svg, "<polyline points=\"{}\" {style}/>", points.trim_end());
    }
    let _ = writeln!(svg, "<path d=\"M{}L{}\"/>", at(-30.0, 0.0), at(30.0, 0.0));
    for degrees in [-30, -20, -10, 0, 10, 20, 30] {
        let x = 300.0 + SCALE[0] * f64::from(degrees);
        let _ = writeln!(
            svg,
            "<text x=\"{x:.0}\" y=\"232\" text-anchor=\"middle\" stroke=\"none\" \
             fill=\"currentColor\">{degrees}°</text>"
        );
    }
    svg + "</svg>\n"
}

/// The share of the lobe (or of what stands for it) that a lamp fills that begins at this
/// angle from the axis and goes on for ever.
pub fn share(cones: &[Cone], degrees: f64) -> f64 {
    let tan = degrees.to_radians().tan();
    let lamp = Polygon::new(vec![
        dvec3(tan, -40.0, 1.0),
        dvec3(tan + 40.0, -40.0, 1.0),
        dvec3(tan + 40.0, 40.0, 1.0),
        dvec3(tan, 40.0, 1.0),
    ])
    .expect("a rectangle");
    let overlap = |c: &Cone| c.overlap(DVec3::ZERO, DVec3::Z, lamp.vertices());
    cones.iter().map(overlap).sum::<f64>()
        / cones.iter().map(|c| c.projected_solid_angle(DVec3::Z)).sum::<f64>()
}

/// So many cones, stacked.
pub fn stacked(count: u32) -> Vec<Cone> {
    let level = |k: u32| (f64::from(k) + 0.5) / f64::from(count);
    (0..count).map(|k| Cone::above(level(k), EXPONENT, DVec3::Z)).collect()
}

/// The table: a lamp's edge in one cone, in stacks, and in the lobe.
pub fn markdown() -> String {
    let one = [Cone::holding(SHARE, EXPONENT, DVec3::Z)];
    let mut text = String::from(
        "| the lamp begins at | one cone | 4 stacked | 16 stacked | the lobe |\n\
         |---|---|---|---|---|\n",
    );
    for degrees in [0.0, 5.0, 10.0, 12.0, 15.0] {
        let [four, sixteen, all] = [4, 16, 4096].map(|n| share(&stacked(n), degrees));
        let one = share(&one, degrees);
        let _ = writeln!(
            text,
            "| {degrees}° | {:.1} % | {:.1} % | {:.1} % | {:.1} % |",
            100.0 * one,
            100.0 * four,
            100.0 * sixteen,
            100.0 * all
        );
    }
    text
}
