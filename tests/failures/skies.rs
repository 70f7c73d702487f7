//! Failures of light from the sky: rows 74 to 76.

use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec3, dvec2, dvec3};
use radiosity::geometry::{Frame, Rgb};
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use radiosity::sky::{Panorama, Sky};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 74,
        name: "Directions crowd the zenith",
        why: "Even steps in the polar angle θ are not even on the sphere; and \
              directions that are drawn by the cosine have it already.",
        size: "Even in θ, E is +27 % on flat ground, twice cosined +33 %, or −33 % \
               with the weight π; ours is ½(1 + cosβ) of the sky to rounding.",
        remedy: "Even in cosθ or by the cosine, each with its own weight, and tested \
                 on a plane at every tilt.",
        tests: &[
            "sky::row_74_directions_even_in_theta_or_twice_cosined",
            "sky::row_74_planes_see_their_share_of_the_sky",
        ],
        shown: Shown::Curve(tilted),
    },
    Row {
        number: 75,
        name: "The sun in one texel",
        why: "Directions drawn without looking at the picture meet the sun by luck: \
              one texel in tens of thousands has nine tenths of the light.",
        size: "256 directions miss it 97 times in 98 and once find it 98 times too \
               bright: 900 % off, and falling as 1/√N. Drawn by brightness as many are \
               off by 2.4 %.",
        remedy: "Draw texels by what they send; make a picture smaller by means, never \
                 by leaving out.",
        tests: &[
            "sky::row_75_a_sun_in_one_texel",
            "sky::row_75_a_sun_thinned_out_or_clamped",
            "sky::row_75_paths_find_a_sun_in_one_texel",
        ],
        shown: Shown::Curve(noise_of_the_sun),
    },
    Row {
        number: 76,
        name: "All texels count the same",
        why: "Rows of a latitude–longitude picture shrink towards the poles as sinθ.",
        size: "Without it a constant map sends 2π² instead of 4π, +57 %, and the row \
               at the pole of 32 rows counts 20 times too much.",
        remedy: "The solid angle of a row in closed form, `2·sinθ·sin(h/2)`, and not \
                 as a difference of cosines, which loses its digits at the pole.",
        tests: &[
            "sky::row_76_sine_forgotten",
            "sky::row_76_differences_of_cosines_fail_at_the_pole",
            "sky::row_76_seam_and_poles",
        ],
        shown: Shown::Curve(weights),
    },
];

/// The middle of `n × n` even pieces of the unit square: no noise.
fn pieces(n: usize) -> impl Iterator<Item = (f64, f64)> {
    let at = move |k: usize| (k as f64 + 0.5) / n as f64;
    (0..n * n).map(move |k| (at(k % n), at(k / n)))
}

/// A direction by its polar angle and its azimuth from 0 to 1.
pub fn polar(theta: f64, v: f64) -> DVec3 {
    let ((sin, cos), (y, x)) = (theta.sin_cos(), (TAU * v).sin_cos());
    dvec3(sin * x, sin * y, cos)
}

/// Even in solid angle, even in θ, and by the cosine.
pub const DRAWS: [fn(f64, f64) -> DVec3; 3] = [
    |u, v| polar(u.acos(), v),
    |u, v| polar(u * FRAC_PI_2, v),
    |u, v| cosine_direction(dvec2(u, v)),
];

/// The irradiance of a plane below a uniform sky of radiance 1, found by directions
/// drawn about its normal and weighted with `2π cosθ`: right for directions even in
/// solid angle.
pub fn naive(degrees: f64, n: usize, draw: fn(f64, f64) -> DVec3) -> f64 {
    let tilt = degrees.to_radians();
    let sky = Sky::uniform(Rgb::ONE, DVec3::Z);
    let frame = Frame::about(dvec3(tilt.sin(), 0.0, tilt.cos()));
    let light = |(u, v)| {
        let d = draw(u, v);
        TAU * d.z * sky.radiance(frame.world_from_local(d)).x
    };
    pieces(n).map(light).sum::<f64>() / (n * n) as f64
}

/// Row 74: the light of a uniform sky on a plane that leans.
pub fn tilted() -> Sweep {
    let tilts: Vec<f64> = (0..=9).map(|k| 20.0 * f64::from(k)).collect();
    let sky = Sky::uniform(Rgb::ONE, DVec3::Z);
    let ours = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        sky.irradiance(dvec3(sin, 0.0, cos)).x / PI
    };
    let by = |k: usize| move |degrees: f64| naive(degrees, 150, DRAWS[k]) / PI;
    Sweep {
        knob: "tilt of the plane, degrees",
        quantity: "light of the sky, of that on flat ground",
        logarithmic: [false, false],
        found: vec![
            Found::over("ours", &tilts, ours),
            Found::over("even in θ", &tilts, by(1)),
            Found::over("twice cosined", &tilts, by(2)),
        ],
        theory: curve(&tilts, |degrees| 0.5 * (1.0 + degrees.to_radians().cos())),
        law: "½(1 + cosβ)",
    }
}

/// A sun of one texel in a grey sky, 256 × 128: it sends nine tenths of the light.
pub fn sunny() -> (Panorama, usize) {
    let (width, height) = (256, 128);
    let mut texels = vec![Rgb::ONE; width * height];
    let sun = 40 * width + 77;
    texels[sun] = Rgb::splat(1e5);
    (Panorama::new(width, texels).unwrap(), sun)
}

/// The light of a sky on flat ground by so many directions even over the sphere.
pub fn even(sky: &Sky, rays: usize, random: &mut Stream) -> f64 {
    let light = |_| {
        let d = polar((1.0 - 2.0 * random.next()).acos(), random.next());
        4.0 * PI * sky.radiance(d).x * d.y.max(0.0)
    };
    (0..rays).map(light).sum::<f64>() / rays as f64
}

/// The same by directions that are drawn by brightness.
pub fn drawn(sky: &Sky, rays: usize, random: &mut Stream) -> f64 {
    let light = |_| {
        let (d, pdf) = sky.sample(dvec2(random.next(), random.next()));
        sky.radiance(d).x * d.y.max(0.0) / pdf
    };
    (0..rays).map(light).sum::<f64>() / rays as f64
}

/// Row 75: the error of those estimates over their number of directions: root mean
/// square.
pub fn noise_of_the_sun() -> Sweep {
    let (panorama, sun) = sunny();
    let omega = panorama.solid_angle(sun / panorama.width());
    let cosine = cosine_of(&panorama, sun);
    let sky = Sky::panorama(panorama, DVec3::Y);
    let right = sky.irradiance(DVec3::Y).x;
    let counts = [16.0, 64.0, 256.0, 1024.0, 4096.0];
    let rms = |by: fn(&Sky, usize, &mut Stream) -> f64, rays: f64| {
        let sky = &sky;
        move |n: f64| {
            let runs = (rays / n) as u64;
            let mut random = Stream::named(n as u64, &[75]);
            let off = |_| (by(sky, n as usize, &mut random) / right - 1.0).powi(2);
            100.0 * ((0..runs).map(off).sum::<f64>() / runs as f64).sqrt()
        }
    };
    // A hit counts 4π/(NΩ) times the sun: the variance of so rare a hit is its square
    // times its chance.
    let share = 1e5 * omega * cosine / right;
    let law = |n: f64| 100.0 * share * (4.0 * PI / (n * omega)).sqrt();
    Sweep {
        knob: "directions",
        quantity: "error of the light on the ground, %",
        logarithmic: [true, true],
        found: vec![
            Found::over("even over the sphere", &counts, rms(even, 1e6)),
            Found::over("ours: by brightness", &counts, rms(drawn, 1e5)),
        ],
        theory: curve(&counts, law),
        law: "√(4π/(NΩ)) times the sun's share",
    }
}

/// The cosine on flat ground of a texel's middle.
fn cosine_of(panorama: &Panorama, texel: usize) -> f64 {
    let row = texel / panorama.width();
    (PI * (row as f64 + 0.5) / panorama.height() as f64).cos()
}

/// Row 76: the weight of a texel over what is right, of 64 rows.
pub fn weights() -> Sweep {
    let height = 64;
    let panorama =
        Panorama::new(2 * height, vec![Rgb::ONE; 2 * height * height]).unwrap();
    let rows: Vec<usize> =
        (0..height).filter(|k| k % 4 == 0 || *k == height - 1).collect();
    let theta = |row: &usize| 180.0 * (*row as f64 + 0.5) / height as f64;
    // The middle texels of all, over `step² sinθ`.
    let step = PI / height as f64;
    let right = |row: &usize| step * step * theta(row).to_radians().sin();
    let line = |of: &dyn Fn(&usize) -> f64| {
        rows.iter().map(|row| [theta(row), of(row) / right(row)]).collect()
    };
    Sweep {
        knob: "angle from the zenith, degrees",
        quantity: "weight of a texel over its solid angle",
        logarithmic: [false, true],
        found: vec![
            Found { method: "all texels alike", points: line(&|_| step * step) },
            Found { method: "ours", points: line(&|row| panorama.solid_angle(*row)) },
        ],
        theory: rows
            .iter()
            .map(|r| [theta(r), 1.0 / theta(r).to_radians().sin()])
            .collect(),
        law: "1/sinθ",
    }
}
