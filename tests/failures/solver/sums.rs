//! Rows 56 to 59: chance, rounding, and what is divided by.

use super::super::rooms::{
    box_walls, coloured_scene, exact_factors, gathered, rows, scene,
};
use super::super::{Found, Sweep, curve};
use super::sweeps::lit_cube;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::{FormFactors, Lost, Matrix, Row};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::solve::{Enclosure, Jacobi, Solver};

/// What arrives at first in a cube of 2 × 2 elements a wall whose top emits 1 W/m²: by
/// exact factors, and by rays.
pub fn arrives_in_cube(rays: Option<(usize, u64)>) -> Vec<f64> {
    let (enclosure, exact) = lit_cube(2, 0.5);
    let walls = box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5));
    let mesh = Mesh::uniform(&scene(walls), 0.5);
    let matrix = match rays {
        Some((rays, seed)) => Cast::new(&mesh, rays, seed).matrix(&|| ()),
        None => exact,
    };
    let solver = Jacobi::new(&enclosure, &matrix);
    solver.irradiance().iter().map(|h| h.x).collect()
}

/// Row 56. Independent rays would be off by `√(F (1 − F)/N)`; here over all elements,
/// in root mean square.
pub fn noise() -> Sweep {
    let exact = arrives_in_cube(None);
    let counts = [16.0, 64.0, 256.0, 1024.0];
    let mean_square = |of: &mut dyn FnMut(usize) -> f64| {
        (0..exact.len()).map(of).sum::<f64>() / exact.len() as f64
    };
    let scatter = |rays: f64, ours: bool| {
        let runs: u64 = 12;
        let mut sum = 0.0;
        for seed in 0..runs {
            let found = if ours {
                arrives_in_cube(Some((rays as usize, seed)))
            } else {
                independent(&exact, rays as usize, seed)
            };
            sum += mean_square(&mut |i| (found[i] - exact[i]).powi(2));
        }
        (sum / runs as f64).sqrt()
    };
    Sweep {
        knob: "rays an element",
        quantity: "error of the irradiance, W/m², root mean square",
        logarithmic: [true, true],
        found: vec![
            Found::over("independent rays", &counts, |n| scatter(n, false)),
            Found::over("rays spread evenly (ours)", &counts, |n| scatter(n, true)),
        ],
        theory: curve(&counts, |n| {
            mean_square(&mut |i| exact[i] * (1.0 - exact[i]) / n).sqrt()
        }),
        law: "√(F (1 − F)/N)",
    }
}

/// What would arrive by rays that know nothing of each other: each brings light with
/// probability F.
fn independent(exact: &[f64], rays: usize, seed: u64) -> Vec<f64> {
    let of = |(i, &f): (usize, &f64)| {
        let mut stream = Stream::named(seed, &[i as u64, rays as u64]);
        (0..rays).filter(|_| stream.next() < f).count() as f64 / rays as f64
    };
    exact.iter().enumerate().map(of).collect()
}

/// The faces of the sheet of [`sheet_in_furnace`]: the top of the lower room, the floor
/// of the upper.
pub const SHEET: [usize; 2] = [5, 6 + 4];

/// Two rooms of one furnace (`E = 1, ρ = ½`, so `B = 2`), a sheet between them that
/// reflects and passes so much and emits as much as it swallows: radiosities of all
/// faces.
pub fn sheet_in_furnace(rho: f64, tau: f64, accuracy: f64) -> Vec<Rgb> {
    let room = scene(box_walls([1.0, 1.0, 0.5]).map(|wall| (wall, 1.0, 0.5)));
    let mesh = Mesh::whole(&room);
    let factors = rows(&exact_factors(&mesh));
    let b = 2.0;
    let mut enclosure = Enclosure::of(&room, &mesh);
    enclosure.area.extend(enclosure.area.clone());
    enclosure.emission.extend(enclosure.emission.clone());
    enclosure.reflectance.extend(enclosure.reflectance.clone());
    let mut all = vec![vec![0.0; 12]; 12];
    for (i, row) in all.iter_mut().enumerate() {
        let first = i / 6 * 6;
        row[first..first + 6].copy_from_slice(&factors[i % 6].0);
    }
    // B = E + ρ H + τ H of the other face = E + ρ (F + τ/ρ F of the other face) B
    let [low, up] = SHEET.map(|face| all[face].clone());
    for (face, other) in [(SHEET[0], &up), (SHEET[1], &low)] {
        all[face].iter_mut().zip(other).for_each(|(f, g)| *f += tau / rho * g);
        enclosure.reflectance[face] = Rgb::splat(rho);
        enclosure.emission[face] = Rgb::splat((1.0 - rho - tau) * b);
    }
    let rows = all.iter().map(|r| Row::of(r, Lost::default())).collect();
    gathered(&enclosure, &Matrix::from_rows(rows), accuracy, 10_000)
}

/// What fell on one face of the sheet, out of what leaves both: here the wrong way, by
/// dividing. And how far those are off: both relative to the right ones.
pub fn divided(rho: f64, tau: f64) -> [f64; 2] {
    let b = sheet_in_furnace(rho, tau, 1e-6);
    let left = SHEET.map(|face| b[face].x - 2.0 * (1.0 - rho - tau));
    let off = left.map(|b| (b / (2.0 * (rho + tau)) - 1.0).abs());
    let [low, up] = left;
    let fell = (rho * up - tau * low) / (rho * rho - tau * tau);
    [(0.5 * fell - 1.0).abs(), off[0].max(off[1])]
}

/// Row 57.
pub fn singular_sheet() -> Sweep {
    let rho = 0.4;
    let apart = [0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];
    let kept = |d: f64| {
        // What falls on all is kept, that on the sheet with it: the furnace's 2.
        let b = sheet_in_furnace(rho, rho - d, 1e-6);
        SHEET.map(|face| (0.5 * b[face].x - 1.0).abs()).into_iter().fold(0.0, f64::max)
    };
    let first = divided(rho, rho - apart[0])[1];
    Sweep {
        knob: "ρ − τ",
        quantity: "error of what falls on the sheet, relative",
        logarithmic: [true, true],
        found: vec![
            Found::over("from what leaves it", &apart, |d| divided(rho, rho - d)[0]),
            Found::over("kept (ours)", &apart, kept),
        ],
        theory: curve(&apart, |d| (2.0 * rho - d) / d * first),
        law: "(ρ + τ)/(ρ − τ) times the solver's error, at most",
    }
}

/// Row 58: many equal shares of one.
pub fn single_precision() -> Sweep {
    let counts = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 4e6];
    // A logarithmic scale has no place for 0.
    let off = |sum: f64| (sum - 1.0).abs().max(1e-17);
    let single = |n: f64| {
        let share = (1.0 / n) as f32;
        off(f64::from((0..n as u32).fold(0.0_f32, |sum, _| sum + share)))
    };
    let double = |n: f64| off((0..n as u32).fold(0.0_f64, |sum, _| sum + 1.0 / n));
    Sweep {
        knob: "shares",
        quantity: "error of their sum, relative",
        logarithmic: [true, true],
        found: vec![
            Found::over("single precision", &counts, single),
            Found::over("double precision (ours)", &counts, double),
        ],
        theory: curve(&counts, |n| 0.5 * n * f64::from(f32::EPSILON)),
        law: "at most 2⁻²⁴ an addition",
    }
}

/// All light of a red room over what is emitted, in red and in green: `ρ` are (red,
/// .05, 0).
pub fn red_room(red: f64) -> Rgb {
    let rho = Rgb::new(red, 0.05, 0.0);
    let emission = |k: usize| if k == 5 { Rgb::ONE } else { Rgb::ZERO };
    let walls = box_walls([1.0, 2.0, 3.0]).into_iter().enumerate();
    let scene = coloured_scene(walls.map(|(k, wall)| (wall, emission(k), rho)));
    let mesh = Mesh::whole(&scene);
    let enclosure = Enclosure::of(&scene, &mesh);
    let light = gathered(&enclosure, &exact_factors(&mesh), 1e-11, 10_000);
    enclosure.power(light) / 2.0 // 1 m × 2 m of 1 W/m²
}

/// Row 59: red light of a red room; by its own reflectance, and by the mean of the
/// three.
pub fn one_grey() -> Sweep {
    let reds = [0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95];
    let grey = |red: f64| {
        let rho = (red + 0.05) / 3.0;
        red_room(rho).x
    };
    Sweep {
        knob: "reflectance in red (green 0.05, blue 0)",
        quantity: "red light / red light emitted",
        logarithmic: [false, true],
        found: vec![
            Found::over("one reflectance, the mean of three", &reds, grey),
            Found::over("each channel its own (ours)", &reds, |red| red_room(red).x),
        ],
        theory: curve(&reds, |red| 1.0 / (1.0 - red)),
        law: "1/(1 − ρ) of the channel",
    }
}
