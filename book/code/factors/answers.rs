//! Five programs, five answers: from the middle of a unit square to one that faces it.

use crate::map;
use glam::DVec3;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::shortcuts::{nusselt, point_to_disc, point_to_point};
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::radiometry::solid_angle;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Who says what.
pub struct Answer {
    /// The method, and its setting.
    pub by: &'static str,
    /// What it finds.
    pub factor: f64,
    /// Is it published, and quoted here, rather than computed?
    pub quoted: bool,
}

/// A square of side 1, 1 above the origin.
fn target() -> Polygon {
    map::square(1.0, DVec3::Z)
}

/// The exact factor.
pub fn exact() -> f64 {
    lambert_polygon(DVec3::ZERO, DVec3::Z, &target())
}

/// The share of rays from a speck at the origin that meet the square.
fn by_rays(rays: usize) -> f64 {
    let speck = map::square(1e-6, DVec3::ZERO).flipped();
    let mesh = Mesh::whole(&map::black(&[speck, target()]));
    let mut row = [0.0; 2];
    Cast::new(&mesh, rays, 1).row(ElementId(0), &mut row);
    row[1]
}

/// All answers.
pub fn answers() -> Vec<Answer> {
    let square = target();
    let own = map::square(1.0, DVec3::ZERO).flipped();
    let mesh = Mesh::whole(&map::black(&[target()]));
    let mut row = [0.0];
    Hemicube::new(&mesh, 64).turned(1).at(DVec3::ZERO, DVec3::Z, &mut row);
    let ours = |by, factor| Answer { by, factor, quoted: false };
    let quoted = |by, factor| Answer { by, factor, quoted: true };
    vec![
        ours("Lambert's formula", exact()),
        ours(
            "Nusselt's disc, 4 chords an edge",
            nusselt(DVec3::ZERO, DVec3::Z, &square, 4),
        ),
        ours("hemicube, resolution 64, turned", row[0]),
        ours("1000 rays", by_rays(1000)),
        ours("point to disc", point_to_disc(&own, &square)),
        ours("point to point", point_to_point(&own, &square)),
        ours("the cosine forgotten: Ω/2π", solid_angle(DVec3::ZERO, &square) / TAU),
        quoted("published: RRV, 2007", 0.160),
        quoted("published: lightmapper.h, default", 0.128),
    ]
}

/// The answers as a table.
pub fn table() -> String {
    let mut text = String::from("| who | answer | off by |\n|---|---|---|\n");
    for Answer { by, factor, quoted } in answers() {
        let digits = if quoted { 3 } else { 4 };
        let off = 100.0 * (factor / exact() - 1.0);
        let off = if off.abs() < 0.005 { "0".into() } else { format!("{off:+.1} %") };
        let off = off.replace('-', "−");
        let _ = writeln!(text, "| {by} | {factor:.digits$} | {off} |");
    }
    text
}

/// The answers along a line.
pub fn svg() -> String {
    let x = |factor: f64| 250.0 + 1600.0 * (factor - 0.1);
    let answers = answers();
    let height = 24 * answers.len() + 50;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 {height}\" \
         width=\"700\" height=\"{height}\" role=\"img\" fill=\"currentColor\" \
         font-size=\"13\">\n<title>Answers to one question, along a line from 0.1 to \
         0.35; the exact one is {:.4}</title>\n",
        exact()
    );
    let bottom = height - 30;
    let mut rule = |at: f64, width: u32, opacity: f64| {
        let _ = writeln!(
            svg,
            "<path d=\"M{0:.1} 5V{bottom}\" stroke=\"currentColor\" \
             stroke-width=\"{width}\" stroke-opacity=\"{opacity}\"/>",
            x(at)
        );
    };
    (2..=7).for_each(|k| rule(f64::from(k) * 0.05, 1, 0.25));
    rule(exact(), 2, 0.8);
    for k in 2..=7 {
        let at = f64::from(k) * 0.05;
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{}\" text-anchor=\"middle\">{at:.2}</text>",
            x(at),
            bottom + 20
        );
    }
    for (k, Answer { by, factor, quoted }) in answers.iter().enumerate() {
        let y = 20 + 24 * k;
        let fill = if *quoted { "none" } else { "#d55e00" };
        let _ = writeln!(
            svg,
            "<text x=\"235\" y=\"{}\" text-anchor=\"end\">{by}</text>\n\
             <circle cx=\"{:.1}\" cy=\"{y}\" r=\"5\" fill=\"{fill}\" stroke=\"#d55e00\" \
             stroke-width=\"2\"/>",
            y + 4,
            x(*factor)
        );
    }
    svg.push_str("</svg>\n");
    svg
}
