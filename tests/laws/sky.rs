//! Laws that every sky obeys: densities that sum to 1, draws that follow them, a
//! furnace, light that is added up and turned with its observer.

use glam::{DMat3, DQuat, DVec3, dvec2, dvec3};
use proptest::prelude::*;
use radiosity::geometry::Rgb;
use radiosity::random::Stream;
use radiosity::sky::{Panorama, Sky, cie_coefficients};
use std::f64::consts::{PI, TAU};
use std::fs;

fn direction() -> impl Strategy<Value = DVec3> {
    let far = |v: &DVec3| (0.1..1.0).contains(&v.length());
    let inside = (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(DVec3::from);
    inside.prop_filter("neither tiny nor in a corner", far).prop_map(DVec3::normalize)
}

fn colour() -> impl Strategy<Value = Rgb> {
    (0.0..2.0, 0.0..2.0, 0.0..2.0).prop_map(Rgb::from)
}

/// Black, plain, or a thousand times brighter.
fn texel() -> impl Strategy<Value = Rgb> {
    let shine = prop_oneof![Just(0.0), Just(1.0), Just(1.0), Just(1000.0)];
    (colour(), shine).prop_map(|(colour, shine)| colour * shine)
}

fn panorama() -> impl Strategy<Value = Panorama> {
    (1..9_usize, 1..7_usize).prop_flat_map(|(width, height)| {
        prop::collection::vec(texel(), width * height)
            .prop_map(move |texels| Panorama::new(width, texels).unwrap())
    })
}

/// Any sky.
fn sky() -> impl Strategy<Value = Sky> {
    prop_oneof![
        (colour(), direction()).prop_map(|(l, up)| Sky::uniform(l, up)),
        (colour(), direction()).prop_map(|(l, up)| Sky::overcast(l, up)),
        (panorama(), direction()).prop_map(|(p, up)| Sky::panorama(p, up)),
        (1..16_usize, 0.1..1.5, 0.0..TAU, colour(), direction()).prop_map(
            |(kind, elevation, azimuth, zenith, up)| {
                let sun = Sky::uniform(zenith, up).direction(elevation, azimuth);
                Sky::cie(cie_coefficients(kind).unwrap(), sun, zenith, up)
            }
        ),
    ]
}

/// Directions all over the sphere, each worth the same solid angle.
fn evenly(n: usize) -> impl Iterator<Item = DVec3> {
    Stream::named(0, &[9]).points::<2>(n).map(|[u, v]| {
        let y: f64 = 1.0 - 2.0 * u;
        let ((x, z), flat) = ((TAU * v).sin_cos(), (1.0 - y * y).sqrt());
        dvec3(flat * x, y, flat * z)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// `∫ pdf dω = 1`, by points all over the sphere: within five standard errors, as
    /// if they had been drawn by chance.
    #[test]
    fn densities_sum_to_one(sky in sky()) {
        let n = 20_000;
        let at: Vec<f64> = evenly(n).map(|d| 4.0 * PI * sky.pdf(d)).collect();
        let mean = at.iter().sum::<f64>() / n as f64;
        let spread = at.iter().map(|p| (p - mean).powi(2)).sum::<f64>() / n as f64;
        let error = (spread / n as f64).sqrt();
        prop_assert!((mean - 1.0).abs() < 5.0 * error + 1e-12, "{mean} ± {error}");
    }

    /// A mean of `w = L cosθ/pdf` over draws is the irradiance `H`. No `w` is above
    /// `W = max L/pdf`, so that its variance is at most `H W`, and (Bernstein 1924)
    ///
    /// ```text
    /// |mean − H| ≤ 6 √(H W/n) + 12 W/n          but for a chance of 2 e⁻¹⁸
    /// ```
    /// The spread of the draws themselves would not do: a bright patch of sky that
    /// barely looks over the plane's horizon is met by few of them, or none.
    #[test]
    fn draws_find_the_irradiance(
        sky in sky(),
        normal in direction(),
        seed in 0..1000_u64,
    ) {
        let n = 20_000;
        let mut random = Stream::named(seed, &[]);
        let (mut sum, mut most) = (Rgb::ZERO, Rgb::ZERO);
        for _ in 0..n {
            let (d, pdf) = sky.sample(dvec2(random.next(), random.next()));
            prop_assert!(pdf > 0.0 && d.is_normalized(), "{d} {pdf}");
            prop_assert_eq!(pdf, sky.pdf(d));
            let light = sky.radiance(d) / pdf;
            most = most.max(light);
            sum += light * normal.dot(d).max(0.0);
        }
        let (mean, expected) = (sum / n as f64, sky.irradiance(normal));
        let part = most / n as f64;
        let allowed = 6.0 * (expected * part).map(f64::sqrt) + 12.0 * part;
        let off = (mean - expected).abs() - allowed;
        prop_assert!(
            off.max_element() <= 1e-6,
            "{mean}, not {expected} within {allowed}"
        );
    }

    /// `H(n) − H(−n) = n · ∫ L ω dω`: linear in n, whatever the light.
    #[test]
    fn net_irradiance_is_a_vector(p in panorama(), up in direction(), n in direction()) {
        let (total, sky) = (p.total(), Sky::panorama(p, up));
        let net = |n: DVec3| sky.irradiance(n) - sky.irradiance(-n);
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(net);
        let off = net(n) - (x * n.x + y * n.y + z * n.z);
        let bound = 1e-5 * total.max_element().max(1e-3);
        prop_assert!(off.abs().max_element() < bound, "{off}");
    }

    /// Whoever turns with the sky sees no change.
    #[test]
    fn a_turn_of_all_changes_nothing(
        n in direction(),
        axis in direction(),
        angle in 0.0..PI,
        kind in 1..16_usize,
    ) {
        let turn = DMat3::from_quat(DQuat::from_axis_angle(axis, angle));
        let sun = Sky::uniform(Rgb::ONE, DVec3::Y).direction(0.7, 0.3);
        let coefficients = cie_coefficients(kind).unwrap();
        let sky = |turn: DMat3| {
            Sky::cie(coefficients, turn * sun, Rgb::ONE, turn * DVec3::Y)
        };
        let (here, there) = (sky(DMat3::IDENTITY), sky(turn));
        let off = there.irradiance(turn * n) - here.irradiance(n);
        prop_assert!(off.abs().max_element() < 1e-6, "{off}");
        let off = there.radiance(turn * n) - here.radiance(n);
        prop_assert!(n.y.abs() < 1e-3 || off.abs().max_element() < 1e-9, "{off}");
    }
}

/// A constant panorama: `∫ L dω = 4π L`, and every plane gets `π L`.
#[test]
fn a_furnace_all_around() {
    for (width, height) in [(1, 1), (2, 1), (7, 3), (64, 32)] {
        let radiance = Rgb::new(1.0, 0.5, 0.0);
        let panorama = Panorama::new(width, vec![radiance; width * height]).unwrap();
        let off = panorama.total() - 4.0 * PI * radiance;
        assert!(off.abs().max_element() < 1e-13, "{off}");
        let sky = Sky::panorama(panorama, DVec3::Y);
        for n in [DVec3::Y, DVec3::NEG_Y, dvec3(0.6, 0.0, 0.8), dvec3(0.48, 0.64, -0.6)]
        {
            let off = sky.irradiance(n) - PI * radiance;
            assert!(off.abs().max_element() < 1e-6, "{width}x{height} {n}: {off}");
        }
    }
}

/// Half a furnace, above: ½ (1 + cosθ) of π L, from panorama and formula alike.
#[test]
fn half_a_furnace_above() {
    let white_above = |row: usize| if row < 16 { Rgb::ONE } else { Rgb::ZERO };
    let texels = (0..64 * 32).map(|k| white_above(k / 64)).collect();
    let sky = Sky::panorama(Panorama::new(64, texels).unwrap(), DVec3::Z);
    let uniform = Sky::uniform(Rgb::ONE, DVec3::Z);
    for degrees in 0..=180 {
        let tilt = f64::from(degrees).to_radians();
        let normal = dvec3(tilt.sin() * 0.6, tilt.sin() * 0.8, tilt.cos());
        let expected = PI * (1.0 + tilt.cos()) / 2.0;
        assert!((uniform.irradiance(normal).x - expected).abs() < 1e-14);
        assert!((sky.irradiance(normal).x - expected).abs() < 1e-6, "{degrees}");
    }
}

/// The orientation of the contract, and of what hangs on another up.
#[test]
fn panoramas_hang_the_right_way() {
    // Four columns (behind-left, left-front, front-right, right-behind), two rows.
    let texels = (0..8).map(|k| Rgb::splat(f64::from(k))).collect();
    let panorama = Panorama::new(4, texels).unwrap();
    let y = Sky::panorama(panorama.clone(), DVec3::Y);
    for (d, texel) in [
        (dvec3(-0.1, 0.1, -1.0), 1.0),
        (dvec3(0.1, 0.1, -1.0), 2.0),
        (dvec3(1.0, 0.1, 0.1), 3.0),
        (dvec3(-1.0, 0.1, 0.1), 0.0),
        (dvec3(0.1, -0.1, -1.0), 6.0),
        (dvec3(0.1, -0.1, 1.0), 7.0),
    ] {
        assert_eq!(y.radiance(d.normalize()).x, texel, "{d}");
    }
    // z up: the middle looks along +y, right stays right.
    let z = Sky::panorama(panorama.clone(), DVec3::Z);
    assert_eq!(z.radiance(dvec3(0.1, 1.0, 0.1).normalize()).x, 2.0);
    assert_eq!(z.radiance(dvec3(0.1, 1.0, -0.1).normalize()).x, 6.0);
    // Upside down: the middle looks along −z still.
    let down = Sky::panorama(panorama, DVec3::NEG_Y);
    assert_eq!(down.radiance(dvec3(-0.1, -0.1, -1.0).normalize()).x, 2.0);
    let ahead = z.direction(0.0, 0.0);
    assert!((ahead - DVec3::Y).length() < 1e-15, "{ahead}");
    assert!((z.direction(0.0, PI / 2.0) - DVec3::X).length() < 1e-15);
}

/// A file holds a panorama to the steps of its shared exponent, 1 % at worst.
#[test]
fn a_panorama_is_written_and_read() {
    let paint = |d: DVec3| Rgb::new(1.5 + d.x, 100.0 * (1.1 + d.y), 1e-3 * (1.1 + d.z));
    let panorama = Panorama::painted(32, 16, paint).unwrap();
    let path =
        std::env::temp_dir().join(format!("radiosity-sky-{}.hdr", std::process::id()));
    fs::write(&path, panorama.encode().unwrap()).unwrap();
    let read = Panorama::read(&path).unwrap();
    assert_eq!((read.width(), read.height()), (32, 16));
    for (got, expected) in read.texels().iter().zip(panorama.texels()) {
        let off = (*got - *expected).abs().max_element() / expected.max_element();
        assert!(off < 1.0 / 128.0, "{got} {expected}");
    }
    // `EXPOSURE` says what the numbers were multiplied by before they were written.
    let bytes = fs::read(&path).unwrap();
    let line = bytes.iter().position(|&b| b == b'\n').unwrap() + 1;
    let exposed = [&bytes[..line], b"EXPOSURE=4\n", &bytes[line..]].concat();
    fs::write(&path, exposed).unwrap();
    let dimmed = Panorama::read(&path).unwrap();
    for (got, expected) in dimmed.texels().iter().zip(read.texels()) {
        assert!(
            (*got * 4.0 - *expected).abs().max_element()
                < 1e-12 * expected.x.abs().max(1.0)
        );
    }
    fs::remove_file(&path).unwrap();
}

/// What is no panorama is told so, with the texel.
#[test]
fn bad_texels_are_named() {
    let with = |value: f64| {
        let mut texels = vec![Rgb::ONE; 8];
        texels[6].y = value;
        Panorama::new(4, texels).unwrap_err().to_string()
    };
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        let said = with(value);
        assert!(
            said.contains("column 2, row 1") && said.contains("0 or more"),
            "{said}"
        );
    }
    assert!(Panorama::new(3, vec![Rgb::ONE; 8]).is_err());
    assert!(Panorama::new(0, vec![Rgb::ONE; 8]).is_err());
    assert!(Panorama::new(4, vec![]).is_err());
}
