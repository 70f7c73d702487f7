//! Light from the sky: the ground's irradiance, by directions drawn in three ways, and by
//! all texels.

use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::geometry::Rgb;
use crate::radiometry::cosine_direction;
use crate::random::Stream;
use crate::sky::{Panorama, Sky, cie_coefficients};
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::{PI, TAU};

/// This suite.
pub const SUITE: Suite = Suite {
    name: "sky",
    about: "the ground's irradiance by directions of the sky, and by all of it",
    measure,
    views: &[
        view("sky-sun", |t| t.scene == SUNNY),
        view("sky-overcast", |t| t.scene == OVERCAST),
    ],
};

const fn view(file: &'static str, shows: fn(&Trial) -> bool) -> ChartView {
    ChartView {
        file,
        title: "Relative error of the ground's irradiance against the time to find it",
        across: (Column::Seconds, "CPU seconds for one point"),
        upward: (Column::Error, "relative error"),
        least: 1e-4,
        shows,
    }
}

/// Scenes of the suite.
pub const SUNNY: &str = "open ground in the sun";
/// See [`SUNNY`].
pub const OVERCAST: &str = "open ground under clouds";

/// What falls on open ground under each sky, W/m².
pub const GROUND: f64 = 100.0;

/// Texels in a row of the painted panorama; half as many rows.
pub const WIDTH: usize = 128;

/// Share of the ground's light that comes from the sun.
pub const SUN: f64 = 0.75;

/// How directions are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Draw {
    /// Evenly over the hemisphere above.
    Even,
    /// In proportion to the cosine.
    Cosine,
    /// In proportion to the sky's radiance.
    Bright,
}

impl Draw {
    /// All of them.
    pub const ALL: [Draw; 3] = [Draw::Even, Draw::Cosine, Draw::Bright];

    /// As tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Draw::Even => "even",
            Draw::Cosine => "by the cosine",
            Draw::Bright => "by brightness",
        }
    }

    /// A direction above the ground, y up, and `L cosθ/pdf` along it.
    pub fn light(self, sky: &Sky, u: DVec2) -> (DVec3, Rgb) {
        let (d, pdf) = match self {
            Draw::Even => {
                let ((x, z), flat) = ((TAU * u.y).sin_cos(), (1.0 - u.x * u.x).sqrt());
                (dvec3(flat * x, u.x, flat * z), 1.0 / TAU)
            }
            Draw::Cosine => {
                let DVec3 { x, y, z } = cosine_direction(u);
                (dvec3(x, z, -y), z / PI)
            }
            Draw::Bright => sky.sample(u),
        };
        let light = if d.y > 0.0 { sky.radiance(d) * d.y / pdf } else { Rgb::ZERO };
        (d, light)
    }

    /// Finds the ground's irradiance, in the second channel, by so many directions.
    fn method<'s>(self, sky: &'s Sky, rays: &[f64]) -> Method<'s, f64> {
        let find = move |n: f64, seed| {
            let mut stream = Stream::named(seed, &[n as u64]);
            let mut ray = || self.light(sky, dvec2(stream.next(), stream.next())).1.y;
            let sum: f64 = (0..n as u64).map(|_| ray()).sum();
            (sum / n, WorkDone { rays: n as u64, ..WorkDone::default() })
        };
        Method::random(self.name(), rays, find).seeds(SEEDS)
    }
}

/// The sun is met by one even direction in three thousand: who wants to know the error of a
/// few must try often.
const SEEDS: u64 = 256;

fn measure(bench: &Bench) -> Vec<Trial> {
    ground(&[64.0, 256.0, 1024.0, 4096.0, 16_384.0], bench)
}

/// The ground under both skies, by so many directions.
pub fn ground(rays: &[f64], bench: &Bench) -> Vec<Trial> {
    let sunny = Sky::panorama(sunny(), DVec3::Y);
    let texels = (WIDTH * WIDTH / 2) as u64;
    let all = Method::new("all texels", &[texels as f64], |_, _| {
        (sunny.irradiance(DVec3::Y).y, WorkDone { rays: texels, ..WorkDone::default() })
    });
    let clouds = Sky::overcast(Rgb::splat(GROUND * 9.0 / (7.0 * PI)), DVec3::Y);
    let in_the_sun = contest(SUNNY, &sunny, rays).with(all);
    let trials = in_the_sun.run(SUITE.name, bench);
    [trials, contest(OVERCAST, &clouds, rays).run(SUITE.name, bench)].concat()
}

fn contest<'s>(name: &str, sky: &'s Sky, rays: &[f64]) -> Contest<'s, f64> {
    let exact = sky.irradiance(DVec3::Y).y;
    let off = move |found: &f64| Verdict::of((found / exact - 1.0).abs());
    let with =
        |contest: Contest<'s, f64>, draw: Draw| contest.with(draw.method(sky, rays));
    Draw::ALL.into_iter().fold(Contest::new(name, 0.0, off), with)
}

/// Towards the sun: high on the left, behind whoever looks at the panorama's middle.
pub fn sun() -> DVec3 {
    dvec3(-0.62, 0.62, 0.48).normalize()
}

/// The CIE's clear sky (12), bluer above and away from the sun, and the sun in one
/// texel; dark ground.
pub fn sunny() -> Panorama {
    let coefficients = cie_coefficients(12).expect("12 is one of 15");
    let clear = Sky::cie(coefficients, sun(), Rgb::ONE, DVec3::Y);
    let ground = clear.irradiance(DVec3::Y).x;
    let paint = |d: DVec3| {
        let grey = clear.radiance(d).x * GROUND * (1.0 - SUN) / ground;
        let away = 1.0 - sun().dot(d).max(0.0).powi(4);
        let blue = away * (0.3 + 0.7 * d.y).max(0.0);
        Rgb::new(1.0 - 0.5 * blue, 1.0 - 0.2 * blue, 1.0 + 0.5 * blue) * grey
    };
    let painted = Panorama::painted(WIDTH, WIDTH / 2, paint).expect("all are positive");
    let mut texels = painted.texels().to_vec();
    let near = |k: &usize| {
        let (column, row) = (k % WIDTH, k / WIDTH);
        middle(column, row).dot(sun())
    };
    let k = (0..texels.len()).max_by(|a, b| near(a).total_cmp(&near(b)));
    let k = k.expect("it has texels");
    let (omega, cos) = (painted.solid_angle(k / WIDTH), middle(k % WIDTH, k / WIDTH).y);
    texels[k] += Rgb::new(1.0, 0.93, 0.8) * (GROUND * SUN / (omega * cos));
    Panorama::new(WIDTH, texels).expect("all are positive")
}

/// The direction to the middle of a texel.
fn middle(column: usize, row: usize) -> DVec3 {
    let elevation = PI / 2.0 - PI * (row as f64 + 0.5) / (WIDTH / 2) as f64;
    let azimuth = 2.0 * PI * ((column as f64 + 0.5) / WIDTH as f64 - 0.5);
    Sky::uniform(Rgb::ONE, DVec3::Y).direction(elevation, azimuth)
}
