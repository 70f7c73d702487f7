//! Failures of materials, gloss, glass and corners: rows 69 to 72.

use super::paths::{dull, shiny};
use super::rooms::{exact_factors, gathered, rectangle};
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::optics::{fresnel, refract};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::built_in;
use radiosity::solve::Enclosure;
use radiosity::trace::{Cone, PathTracer, Strategy};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 69,
        name: "More light out than in",
        why: "Kd + Ks + Td above 1 makes light at every bounce; the series 1 + s + s² \
              + … has no sum.",
        size: "After fifty bounces a furnace of s = 1.2 sends 54 600 times what it \
               emits; ours refuses the file from 1 on, and finds 1/(1 − s) below.",
        remedy: "Refuse the material where it is made, with its name, the sum and what \
                 to lower; let Fresnel's law split what shines.",
        tests: &["rays::row_69_materials_that_make_light_are_refused"],
        shown: Shown::Curve(more_than_all),
    },
    Row {
        number: 70,
        name: "One cone for a lobe",
        why: "A cone of even weight has an edge that a lobe has not; a few rays are a \
              coarse dice.",
        size: "As a lamp's edge crosses a lobe of exponent 100, one cone is off by up \
               to 6 % of the lobe, eight rays by 18 % where half of it is met (one \
               standard deviation); a stack of cones is right.",
        remedy: "The exact overlap of lamp and cone, over a stack of cones that is the \
                 lobe.",
        tests: &[
            "rays::row_70_one_cone_has_an_edge_where_the_lobe_has_none",
            "rays::row_70_a_lamp_half_in_the_cone_counts_half",
            "rays::row_70_the_noise_of_gloss_falls_with_the_rays",
        ],
        shown: Shown::Curve(edge_of_a_cone),
    },
    Row {
        number: 71,
        name: "Light lost inside glass",
        why: "Beyond the critical angle all light is reflected. Whoever takes what cannot \
              be refracted for nothing loses it.",
        size: "At 60° inside glass a face reflects and passes 7 % of the light instead \
               of all, with Schlick's curve and no total reflection; ours gives R + T \
               = 1 to rounding at every angle.",
        remedy: "Fresnel's law as it stands, and a stack of the solids that a ray is \
                 in.",
        tests: &[
            "rays::row_71_glass_is_invisible_in_an_even_glow",
            "rays::row_71_faces_pass_what_they_do_not_reflect",
        ],
        shown: Shown::Curve(reflected_and_passed),
    },
    Row {
        number: 72,
        name: "Sparks in corners",
        why: "A lamp's point that is drawn by area counts cosθ cosθ′A/(πr²): without \
              bound as r → 0.",
        size: "At a distance d from the corner one sample counts up to 0.103/d² of its \
               wall: 1034 at a hundredth. Weighed by both chances none counts more \
               than 2.",
        remedy: "Directions by the cosine for final gathering, both ways weighed \
                 together for lamps.",
        tests: &[
            "rays::row_72_corners_make_no_sparks",
            "rays::row_72_final_gathering_makes_no_sparks",
        ],
        shown: Shown::Curve(sparks),
    },
];

/// Row 69: the radiosity of a furnace of E = 1 whose walls reflect the share s.
pub fn more_than_all() -> Sweep {
    let shares = [0.2, 0.5, 0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2];
    let bounces = |s: f64| (0..=50).map(|k| s.powi(k)).sum();
    let accepted = |s: &&f64| {
        let diffuse = Rgb::splat(**s);
        Material::new("m", Coefficients { diffuse, ..Default::default() }).is_ok()
    };
    let ours: Vec<f64> = shares.iter().filter(accepted).copied().collect();
    let solved = |s: f64| {
        let scene = built_in(&format!("furnace:{s}")).unwrap();
        let mesh = Mesh::whole(&scene);
        gathered(&Enclosure::of(&scene, &mesh), &exact_factors(&mesh), 1e-9, 5000)[0].x
    };
    Sweep {
        knob: "reflected in all, of what falls on the walls",
        quantity: "radiosity over emission",
        logarithmic: [false, true],
        found: vec![
            Found::over("who believes the file, 50 bounces", &shares, bounces),
            Found::over("ours: refused from 1 on", &ours, solved),
        ],
        theory: curve(&[0.2, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99], |s| 1.0 / (1.0 - s)),
        law: "1/(1 − s)",
    }
}

/// The exponent of the lobe of row 70.
pub const EXPONENT: f64 = 100.0;

/// A lamp that fills all beyond this angle from the axis.
pub fn beyond(angle: f64) -> Polygon {
    rectangle(dvec3(angle.tan(), -40.0, 1.0), 80.0 * DVec3::Y, 40.0 * DVec3::X)
}

/// The share of the lobe that meets that lamp, as a stack of cones has it; even in the
/// root of the level, as the widest cones grow without end.
pub fn of_lobe(angle: f64, cones: usize) -> f64 {
    let share = |j: usize| {
        let v = (j as f64 + 0.5) / cones as f64;
        let cone = Cone::above(v * v, EXPONENT, DVec3::Z);
        2.0 * v * cone.overlap(DVec3::ZERO, DVec3::Z, beyond(angle).vertices())
    };
    (EXPONENT + 2.0) / TAU * (0..cones).map(share).sum::<f64>() / cones as f64
}

/// The same as one cone of even weight, that holds nine tenths of the lobe.
pub fn of_cone(angle: f64) -> f64 {
    let cone = Cone::holding(0.9, EXPONENT, DVec3::Z);
    cone.share(DVec3::ZERO, DVec3::Z, beyond(angle).vertices())
}

/// `∫ cosⁿ⁺¹γ dγ` from an angle to π/2, of that from −π/2: the lobe's projection on the
/// plane across the lamp's edge. Simpson's rule.
pub fn tail(angle: f64) -> f64 {
    let sum = |from: f64| {
        let (n, step) = (2000, (FRAC_PI_2 - from) / 2000.0);
        let weight = |k: i32| match k {
            0 | 2000 => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let at = |k: i32| {
            weight(k) * (from + f64::from(k) * step).cos().powf(EXPONENT + 1.0)
        };
        (0..=n).map(at).sum::<f64>() * step / 3.0
    };
    sum(angle) / sum(-FRAC_PI_2)
}

/// Row 70: a lamp's edge that crosses the lobe about a reflected ray.
pub fn edge_of_a_cone() -> Sweep {
    let degrees: Vec<f64> = (0..=9).map(|k| 2.0 * f64::from(k)).collect();
    let at = |share: &dyn Fn(f64) -> f64, d: f64| 100.0 * share(d.to_radians());
    // Eight directions drawn by the lobe: whole eighths.
    let mut random = Stream::named(70, &[]);
    let drawn: Vec<f64> = (0..8)
        .map(|_| {
            let cosine = random.next().powf(1.0 / (EXPONENT + 2.0));
            ((1.0 - cosine * cosine).sqrt() * (TAU * random.next()).cos() / cosine)
                .atan()
        })
        .collect();
    let counted =
        |angle: f64| drawn.iter().filter(|a| **a > angle).count() as f64 / 8.0;
    Sweep {
        knob: "lamp's edge off the reflected ray, degrees",
        quantity: "share of the lobe that meets the lamp, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("one cone", &degrees, |d| at(&of_cone, d)),
            Found::over("eight rays", &degrees, |d| at(&counted, d)),
            Found::over("ours: a stack of cones", &degrees, |d| {
                at(&|angle| of_lobe(angle, 1000), d)
            }),
        ],
        theory: curve(&degrees, |d| at(&tail, d)),
        law: "the lobe's exact tail",
    }
}

/// What a face of glass passes of light that comes from inside, unpolarised: Fresnel's
/// amplitudes `2cosᵢ/(…)`, and not what is left of the reflected.
pub fn passed(degrees: f64) -> f64 {
    let (n, cosine) = (1.5, degrees.to_radians().cos());
    let sine = degrees.to_radians().sin();
    let Some(out) = refract(dvec3(sine, 0.0, -cosine), DVec3::Z, n) else { return 0.0 };
    let beyond = -out.z;
    let amplitudes = [
        2.0 * n * cosine / (n * cosine + beyond),
        2.0 * n * cosine / (cosine + n * beyond),
    ];
    let thinner = beyond / (n * cosine);
    0.5 * thinner * amplitudes.map(|t| t * t).iter().sum::<f64>()
}

/// Row 71: what a face of glass reflects and passes in all of light from inside.
pub fn reflected_and_passed() -> Sweep {
    let degrees: Vec<f64> = (0..=17).map(|k| 5.0 * f64::from(k)).collect();
    let ours = |d: f64| fresnel(d.to_radians().cos(), 1.5).mean() + passed(d);
    let schlick =
        |d: f64| 0.04 + 0.96 * (1.0 - d.to_radians().cos()).powi(5) + passed(d);
    Sweep {
        knob: "angle inside the glass, degrees",
        quantity: "reflected and passed, of what comes",
        logarithmic: [false, false],
        found: vec![
            Found::over("ours: Fresnel", &degrees, ours),
            Found::over("Schlick, no total reflection", &degrees, schlick),
        ],
        theory: curve(&degrees, |_| 1.0),
        law: "R + T = 1",
    }
}

/// Row 72: the largest of 20 000 samples of a wall, seen from the floor so far from it.
pub fn sparks() -> Sweep {
    let distances = [0.003, 0.01, 0.03, 0.1, 0.3];
    // ANCHOR: by_area
    let by_area = |d: f64| {
        let mut random = Stream::named(72, &[(1e6 * d) as u64]);
        let x = dvec3(d, 0.5, 0.0);
        let largest = |most: f64, _| {
            let r = dvec3(0.0, random.next(), random.next()) - x;
            most.max(r.z * d / (PI * r.length_squared().powi(2)))
        };
        (0..20_000).fold(0.0, largest)
    };
    // ANCHOR_END: by_area
    let ours = |d: f64| {
        let wall = rectangle(DVec3::ZERO, DVec3::Y, DVec3::Z);
        let floor = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
        let scene = shiny([(wall, dull(1.0, 0.0)), (floor, dull(0.0, 0.5))]);
        let tracer = PathTracer::of(&Room::of(&scene)).by(Strategy::Both);
        let mut random = Stream::named(72, &[(1e6 * d) as u64]);
        let origin = dvec3(0.9, 0.5, 0.5);
        let direction = (dvec3(d, 0.5, 0.0) - origin).normalize();
        let ray = Ray { origin, direction };
        let sample = |most: f64, _| most.max(tracer.radiance(ray, &mut random).x);
        2.0 * PI * (0..5_000).fold(0.0, sample)
    };
    Sweep {
        knob: "distance from the wall",
        quantity: "largest sample, of what the wall sends",
        logarithmic: [true, true],
        found: vec![
            Found::over("points drawn by area", &distances, by_area),
            Found::over("ours: both chances weighed", &distances, ours),
        ],
        // ANCHOR: law
        theory: curve(&distances, |d| 9.0 / (16.0 * 3f64.sqrt() * PI) / (d * d)),
        law: "9/(16√3 π d²), the largest there can be",
        // ANCHOR_END: law
    }
}
