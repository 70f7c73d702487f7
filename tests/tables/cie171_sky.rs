//! Test cases in the style of CIE 171:2006 with a sky: what comes through an opening,
//! open or glazed, past an overhang or a wall, in per cent of what falls on the ground.
//!
//! By quadrature over the opening, with `Sky` for the radiance and `pane` for the
//! glass.

use crate::common::{cases, point, within};
use glam::{DVec3, dvec3};
use radiosity::geometry::Rgb;
use radiosity::material::optics::pane;
use radiosity::sky::{Sky, cie_coefficients};
use serde_json::Value;
use std::f64::consts::PI;

const INDEX: f64 = 1.52;

/// That of the table for exact methods.
const GATE: f64 = 1e-6;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The sky of a case, above a ground that reflects diffusely what falls on it.
struct Outside {
    sky: Sky,
    sun: DVec3,
    ground: f64,
    horizontal: f64,
}

impl Outside {
    fn of(params: &Value) -> Outside {
        let elevation = number(&params["sun_elevation_deg"]).to_radians();
        let flat = match params["sun_azimuth"].as_str() {
            Some("+y") => DVec3::Y,
            Some("-y") => DVec3::NEG_Y,
            other => panic!("{other:?}"),
        };
        let sun = flat * elevation.cos() + DVec3::Z * elevation.sin();
        let kind = params["sky_type"].as_u64().unwrap() as usize;
        let sky = Sky::cie(cie_coefficients(kind).unwrap(), sun, Rgb::ONE, DVec3::Z);
        let horizontal = sky.irradiance(DVec3::Z).x;
        let expected = number(&params["E_horizontal_over_Lz"]);
        assert!(within(horizontal, expected, 1e-7, 0.0), "{kind}: {horizontal}");
        let albedo = params["ground_reflectance"].as_f64().unwrap_or(0.0);
        Outside { sky, sun, ground: albedo * horizontal / PI, horizontal }
    }

    fn radiance(&self, direction: DVec3) -> f64 {
        let below = if direction.z < 0.0 { self.ground } else { 0.0 };
        self.sky.radiance(direction).x + below
    }
}

/// Nodes and weights of Gauss and Legendre on `[0, 1]`.
const NODES: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// `∫ f` over a parallelogram: a fixed rule, on pieces that get smaller towards where
/// `f` is unruly; `free` tells how far a point is from there.
fn integral(
    [corner, u, v]: [DVec3; 3],
    free: &impl Fn(DVec3) -> f64,
    f: &impl Fn(DVec3) -> f64,
) -> f64 {
    let size = u.length().max(v.length());
    if size > 0.4 || size > 0.01 && size > 0.4 * free(corner + (u + v) / 2.0) {
        let halves = if u.length() > v.length() {
            [[corner, u / 2.0, v], [corner + u / 2.0, u / 2.0, v]]
        } else {
            [[corner, u, v / 2.0], [corner + v / 2.0, u, v / 2.0]]
        };
        return halves.into_iter().map(|half| integral(half, free, f)).sum();
    }
    let mut sum = 0.0;
    for (s, weight) in NODES {
        for (t, other) in NODES {
            sum += weight * other * f(corner + u * s + v * t);
        }
    }
    sum * u.cross(v).length()
}

/// A rectangular opening in the plane with this normal (outward), by its corners.
struct Opening {
    low: DVec3,
    high: DVec3,
    outward: DVec3,
}

impl Opening {
    /// That of a case, as much of it as sees the sky from `x` on the floor past
    /// overhang and wall, which reach as far as one sees.
    fn of(case: &Value, x: DVec3) -> Opening {
        let (mut low, mut high) = match case["opening"].as_array() {
            Some(corners) => radiosity::geometry::bounds(corners.iter().map(point)),
            None => (dvec3(1.0, 0.0, 1.0), dvec3(3.0, 0.0, 2.0)),
        };
        let outward = if low.z == high.z { DVec3::Z } else { DVec3::NEG_Y };
        let told = |what: &str, before: &str| -> Option<f64> {
            let told = case["params"][what].as_str()?;
            let number = told.split_once(before)?.1.split([' ', ',']).next()?;
            Some(number.parse().unwrap())
        };
        if let Some(depth) = told("overhang", "y=-") {
            high.z = high.z.min(3.0 * x.y / (x.y + depth)).max(low.z);
        }
        if let Some(height) = told("wall", "height ") {
            low.z = low.z.max(height * x.y / (x.y + 6.0)).min(high.z);
        }
        Opening { low, high, outward }
    }

    /// Irradiance at `x` with `normal`; `passes` is the glass's share by cosine.
    fn lights(
        &self,
        x: DVec3,
        normal: DVec3,
        outside: &Outside,
        passes: fn(f64) -> f64,
    ) -> f64 {
        let light = |w: DVec3| {
            let (d, r2) = ((w - x).normalize(), (w - x).length_squared());
            let cos = d.dot(self.outward).max(0.0);
            outside.radiance(d) * normal.dot(d).max(0.0) * cos * passes(cos) / r2
        };
        // Unruly: near x, where the sun is seen, and just above the horizon.
        let sun = outside.sun;
        let sun = x + sun * ((self.low - x).dot(self.outward) / sun.dot(self.outward));
        let nearest = x.clamp(self.low, self.high);
        let free = |w: DVec3| {
            let horizon = if w.z > x.z { w.z - x.z } else { f64::INFINITY };
            w.distance(nearest).min(w.distance(sun)).min(horizon)
        };
        let DVec3 { x: wide, y: deep, z: high } = self.high - self.low;
        if self.outward == DVec3::Z {
            let all = [self.low, DVec3::X * wide, DVec3::Y * deep];
            return integral(all, &free, &light);
        }
        let strip = |from: f64, to: f64| {
            let corner = self.low + DVec3::Z * from;
            integral([corner, DVec3::X * wide, DVec3::Z * (to - from)], &free, &light)
        };
        let horizon = (x.z - self.low.z).clamp(0.0, high);
        strip(0.0, horizon) + strip(horizon, high)
    }
}

/// The normal of the face on which a point of the room lies.
fn normal_at(x: DVec3) -> DVec3 {
    match x {
        _ if x.z == 0.0 => DVec3::Z,
        _ if x.z == 3.0 => DVec3::NEG_Z,
        _ if x.y == 0.0 => DVec3::Y,
        _ => DVec3::NEG_Y,
    }
}

/// Holds all cases of the table whose name begins so.
fn meet(kinds: &[&str], key: &str, passes: fn(f64) -> f64) {
    let mut count = 0;
    for case in cases("E_cie171") {
        let id = case["id"].as_str().unwrap();
        if !kinds.iter().any(|kind| id.starts_with(kind)) {
            continue;
        }
        let outside = Outside::of(&case["params"]);
        let places = case["params"]["points"].as_object().unwrap();
        for (name, expected) in case["expected"][key].as_object().unwrap() {
            let x = point(&places[name]);
            let opening = Opening::of(&case, x);
            let got = opening.lights(x, normal_at(x), &outside, passes);
            let (got, expected) = (100.0 * got / outside.horizontal, number(expected));
            let own = number(&case["uncertainty_abs"]);
            assert!(
                within(got, expected, GATE, own),
                "{id} {name}: {got}, not {expected}"
            );
            count += 1;
        }
    }
    assert!(count >= 100, "{count}");
}

fn open(_: f64) -> f64 {
    1.0
}

fn glass(cos: f64) -> f64 {
    pane(cos, INDEX).1
}

/// 5.9 and 5.10: an opening in the roof, 1 × 1 and 4 × 4.
#[test]
fn through_the_roof() {
    meet(&["E-5.9-"], "SC_percent", open);
    meet(&["E-5.10-"], "SC_percent", glass);
}

/// 5.11 and 5.12: an opening in the facade, with the ground before it.
#[test]
fn through_the_facade() {
    meet(&["E-5.11-"], "SC_plus_ERC_percent", open);
    meet(&["E-5.12-"], "SC_plus_ERC_percent", glass);
}

/// 5.13 and 5.14: a black overhang above the opening, a black wall before it.
#[test]
fn past_an_overhang_or_a_wall() {
    meet(&["E-5.13-", "E-5.14-"], "SC_percent", open);
}
