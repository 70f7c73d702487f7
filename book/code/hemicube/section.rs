//! The idea in section: what looks the same from the element has the same form factor.

use glam::{DVec2, dvec2};
use std::fmt::Write;

/// Pixels to a unit.
const SCALE: f64 = 130.0;

/// The patch, in section: from one end to the other, the cube's half width being 1.
const PATCH: (DVec2, DVec2) = (dvec2(0.35, 1.85), dvec2(1.75, 1.55));

fn at(p: DVec2) -> (f64, f64) {
    (SCALE * (p.x + 2.0), SCALE * (2.1 - p.y))
}

/// Where the ray from the origin through `p` meets the top of the cube or its side.
fn on_cube(p: DVec2) -> DVec2 {
    p / p.y.max(p.x.abs())
}

/// The drawing, as SVG without ids, in the colour of the text around it.
pub fn svg() -> String {
    let (a, b) = PATCH;
    let corner = dvec2(1.0, 1.0); // the patch is seen across an edge of the cube
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 520 300\" \
         width=\"520\" height=\"300\" role=\"img\" fill=\"none\" \
         stroke=\"currentColor\" font-size=\"14\">\n\
         <title>Section through a hemicube: a patch, its shadow on the half cube, on the \
         hemisphere, and on the base</title>\n",
    );
    let mut line = |points: &[DVec2], style: &str| {
        let points: Vec<String> = points
            .iter()
            .map(|&p| at(p))
            .map(|(x, y)| format!("{x:.1},{y:.1}"))
            .collect();
        let _ = writeln!(svg, "<polyline points=\"{}\" {style}/>", points.join(" "));
    };
    let dashed = "stroke-dasharray=\"3 4\" stroke-opacity=\"0.6\"";
    line(&[dvec2(-1.9, 0.0), dvec2(1.9, 0.0)], "");
    line(&[dvec2(-1.0, 0.0), dvec2(-1.0, 1.0), corner, dvec2(1.0, 0.0)], "");
    let angle = |k: i32| f64::from(k) * std::f64::consts::PI / 60.0;
    let arc: Vec<DVec2> = (0..=60).map(|k| DVec2::from_angle(angle(k))).collect();
    line(&arc, "stroke-opacity=\"0.5\"");
    for end in [a, b] {
        line(&[DVec2::ZERO, end], dashed);
        let foot = end.normalize();
        line(&[foot, dvec2(foot.x, 0.0)], dashed);
    }
    let thick = "stroke-width=\"4\" stroke=\"#d55e00\"";
    line(&[a, b], thick);
    line(&[on_cube(a), corner, on_cube(b)], thick);
    line(&[dvec2(a.normalize().x, 0.0), dvec2(b.normalize().x, 0.0)], thick);
    for k in -4..=4 {
        let x = f64::from(k) / 4.0;
        line(&[dvec2(x, 0.97), dvec2(x, 1.03)], "");
        if k > 0 {
            line(&[dvec2(0.97, x), dvec2(1.03, x)], "");
            line(&[dvec2(-1.03, x), dvec2(-0.97, x)], "");
        }
    }
    let mut label = |p: DVec2, text: &str| {
        let (x, y) = at(p);
        let style = "fill=\"currentColor\" stroke=\"none\"";
        let _ = writeln!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\" {style}>{text}</text>");
    };
    label(dvec2(1.1, 1.85), "patch");
    label(dvec2(-0.95, 1.08), "half cube, in cells");
    label(dvec2(-0.6, 0.62), "hemisphere");
    label(dvec2(-0.5, -0.16), "element");
    label(dvec2(0.2, -0.16), "shadow on the base: area πF");
    svg.push_str("</svg>\n");
    svg
}
