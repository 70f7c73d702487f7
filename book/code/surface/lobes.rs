//! Lobes as polar curves, and directional albedos as curves over the angle.

use super::ball::bare;
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::material::Lobe;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// The lobe that is drawn beside Lambert's.
const GLOSS: Lobe = Lobe::Phong { exponent: 4.0 };

/// Mid-tones, as in the charts.
const COLOURS: [&str; 5] = ["#d55e00", "#3b8fd0", "#00a078", "#b765a0", "#a08a00"];

fn head(width: u32, height: u32, title: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\" role=\"img\" fill=\"none\" \
         stroke=\"currentColor\" font-size=\"13\">\n<title>{title}</title>\n"
    )
}

fn line(svg: &mut String, points: impl Iterator<Item = DVec2>, style: &str) {
    let points: Vec<String> =
        points.map(|p| format!("{:.1},{:.1}", p.x, p.y)).collect();
    let _ = writeln!(svg, "<polyline points=\"{}\" {style}/>", points.join(" "));
}

fn label(svg: &mut String, at: DVec2, anchor: &str, text: &str) {
    let _ = writeln!(
        svg,
        "<text x=\"{:.0}\" y=\"{:.0}\" text-anchor=\"{anchor}\" fill=\"currentColor\" \
         stroke=\"none\">{text}</text>",
        at.x, at.y
    );
}

/// Both lobes for three directions of the incoming light, as polar curves: the distance
/// from the origin is the BRDF.
pub fn polar() -> String {
    const SCALE: f64 = 120.0; // pixels for each 1/sr
    let mut svg = head(
        690,
        190,
        "Polar curves of two BRDFs for light that comes in at 0, 45 and 75 degrees: a half \
         circle about the origin for Lambert; a lobe about the mirror direction for Phong, \
         cut off at the horizon",
    );
    for (k, degrees) in [0.0_f64, 45.0, 75.0].into_iter().enumerate() {
        let origin = dvec2(115.0 + 230.0 * k as f64, 150.0);
        let place = |v: DVec2| origin + SCALE * dvec2(v.x, -v.y);
        let theta = degrees.to_radians();
        let wi = dvec3(-theta.sin(), 0.0, theta.cos());
        // The direction at this turn from the right-hand horizon.
        let towards = |turn: f64| dvec3(turn.cos(), 0.0, turn.sin());
        let curve = |lobe: Lobe| {
            (0..=180).map(move |k| {
                let w = towards(PI / 180.0 * f64::from(k));
                let f = if w.z > 1e-9 { lobe.value(wi, w) } else { 0.0 };
                place(f * dvec2(w.x, w.z))
            })
        };
        let ground = [dvec2(-0.9, 0.0), dvec2(0.9, 0.0)].map(place);
        line(&mut svg, ground.into_iter(), "");
        // What would be below the horizon, were there no surface.
        let below = (-90..=0).map(|k| {
            let w = towards(PI / 180.0 * f64::from(k));
            let cosine = w.dot(dvec3(-wi.x, 0.0, wi.z)).max(0.0);
            place(GLOSS.value(DVec3::Z, DVec3::Z) * cosine.powi(4) * dvec2(w.x, w.z))
        });
        if degrees > 0.0 {
            line(&mut svg, below, "stroke-dasharray=\"3 4\" stroke-opacity=\"0.6\"");
        }
        for (lobe, colour) in [(Lobe::Lambert, COLOURS[1]), (GLOSS, COLOURS[0])] {
            let style = format!("stroke=\"{colour}\" stroke-width=\"2.5\"");
            line(&mut svg, curve(lobe), &style);
        }
        let from = 1.05 * dvec2(wi.x, wi.z);
        line(
            &mut svg,
            [from, DVec2::ZERO].map(place).into_iter(),
            "stroke-width=\"1.5\"",
        );
        let tip = |turn: f64| place(DVec2::from_angle(turn).rotate(0.09 * from));
        let arrow = [tip(0.4), place(DVec2::ZERO), tip(-0.4)];
        line(&mut svg, arrow.into_iter(), "stroke-width=\"1.5\"");
        label(&mut svg, origin + dvec2(0.0, 32.0), "middle", &format!("{degrees}°"));
    }
    svg.push_str("</svg>\n");
    svg
}

/// Directional albedos over the angle from the normal.
pub fn curves() -> String {
    let place = |degrees: f64, a: f64| dvec2(60.0 + 5.0 * degrees, 320.0 - 140.0 * a);
    let mut svg = head(
        700,
        370,
        "Directional albedo over the angle: Lambert constant at 1; normalised Phong lobes \
         fall from 1, the narrower the faster, to no less than the cosine; a lobe without \
         its constant starts above 2",
    );
    for k in 0..=4 {
        let a = 0.5 * f64::from(k);
        let ends = [place(0.0, a), place(90.0, a)];
        let opacity = if k == 2 { 0.6 } else { 0.2 };
        let style = format!("stroke-opacity=\"{opacity}\"");
        line(&mut svg, ends.into_iter(), &style);
        label(&mut svg, ends[0] + dvec2(-8.0, 4.0), "end", &format!("{a}"));
    }
    for degrees in [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0] {
        let ends = [place(degrees, 0.0), place(degrees, 2.2)];
        line(&mut svg, ends.into_iter(), "stroke-opacity=\"0.2\"");
        label(&mut svg, ends[0] + dvec2(-6.0, 20.0), "middle", &format!("{degrees}°"));
    }
    label(&mut svg, place(45.0, -0.3), "middle", "angle to the normal");
    let angles = || (0..=180).map(|k| f64::from(k) / 2.0);
    let cosine = |degrees: f64| degrees.to_radians().cos().clamp(0.0, 1.0);
    let curve =
        |svg: &mut String, a: &dyn Fn(f64) -> f64, colour: &str, extra: &str| {
            let style = format!("stroke=\"{colour}\" stroke-width=\"2\" {extra}");
            line(svg, angles().map(|t| place(t, a(cosine(t)))), &style);
        };
    curve(&mut svg, &|_| 1.0, COLOURS[1], "");
    label(&mut svg, place(91.0, 0.97), "start", "Lambert");
    let right = |n: f64| place(91.0, Lobe::Phong { exponent: n }.albedo(0.0) - 0.03);
    for n in [1.0, 10.0, 100.0] {
        let lobe = Lobe::Phong { exponent: n };
        curve(&mut svg, &|c| lobe.albedo(c), COLOURS[0], "");
        label(&mut svg, right(n), "start", &format!("Phong, n = {n}"));
    }
    curve(&mut svg, &|c| c, "currentColor", "stroke-dasharray=\"3 4\"");
    label(&mut svg, place(92.0, -0.1), "start", "cosine");
    curve(&mut svg, &|c| bare(1.0, c), COLOURS[3], "");
    label(&mut svg, place(91.0, bare(1.0, 0.0) - 0.03), "start", "n = 1, no constant");
    // The constant of the density, in place of that of the BRDF.
    let density = |c: f64| 2.0 / TAU * bare(1.0, c);
    curve(&mut svg, &density, COLOURS[2], "");
    label(&mut svg, place(91.0, density(0.0) - 0.03), "start", "n = 1, of the density");
    svg.push_str("</svg>\n");
    svg
}
