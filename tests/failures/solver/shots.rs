//! Rows 50 to 53: shooting, and guesses at the light that is still under way.

use super::super::rooms::{box_walls, exact_factors, rectangle, scene};
use super::super::{Found, Sweep, curve};
use super::sweeps::{facing_squares, lit_cube, total};
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::{FormFactors, Matrix};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::solve::{Brightest, Enclosure, Overshoot, Shoot, Solver};

/// A wall that is a lamp of 1 W, and forty specks of half a milliwatt that are five
/// times as bright; all reflect half.
fn specks() -> (Enclosure, Matrix) {
    let mut faces: Vec<_> = box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5)).to_vec();
    faces[0].1 = 1.0;
    for k in 0..40 {
        let [x, y] = [k % 8, k / 8].map(|k| 0.1 + 0.02 * f64::from(k));
        let speck = rectangle(dvec3(x, y, 1.0), DVec3::Y * 0.01, DVec3::X * 0.01);
        faces.push((speck, 5.0, 0.5));
    }
    let scene = scene(faces);
    let mesh = Mesh::uniform(&scene, 0.5);
    (Enclosure::of(&scene, &mesh), exact_factors(&mesh))
}

/// Row 50. Each speck that shoots loses half of its 0.5 mW, of 1.02 W.
pub fn specks_first() -> Sweep {
    let (enclosure, matrix) = specks();
    let counts = [1.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0];
    let line = |method, brightest| {
        let run: Vec<f64> = Shoot::new(&enclosure, &matrix, brightest)
            .take(40)
            .map(|step| 100.0 * step.ledger.unshot.x / step.ledger.emitted.x)
            .collect();
        Found::over(method, &counts, |k| run[k as usize - 1])
    };
    Sweep {
        knob: "shots",
        quantity: "light that has not moved, %",
        logarithmic: [false, false],
        found: vec![
            line("by radiosity, ΔB", Brightest::ByRadiosity),
            line("by power, A ΔB (ours)", Brightest::ByPower),
        ],
        theory: curve(&counts, |k| 100.0 * (1.0 - 0.5 * k * 5e-4 / 1.02)),
        law: "a shot of a speck moves 0.5 mW of 1.02 W, and half is swallowed",
    }
}

/// Row 51, in a room with ρ = 0.7. The ambient term of the start is all light that is
/// still to come, the share ρ.
pub fn counted_twice() -> Sweep {
    let rho = 0.7;
    let (enclosure, matrix) = lit_cube(2, rho);
    let all = 1.0 / (1.0 - rho);
    let counts = [1.0, 5.0, 10.0, 20.0, 40.0, 60.0, 80.0, 100.0, 150.0, 200.0];
    let mut solver = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
    let start = total(&enclosure, &solver.with_ambient())
        - total(&enclosure, solver.radiosity());
    let [mut bare, mut shown, mut kept] = [const { Vec::new() }; 3];
    let mut done = 0;
    for count in counts {
        solver.nth(count as usize - done - 1);
        done = count as usize;
        let light = total(&enclosure, solver.radiosity());
        bare.push([count, light / all]);
        shown.push([count, total(&enclosure, &solver.with_ambient()) / all]);
        kept.push([count, (light + start) / all]);
    }
    Sweep {
        knob: "shots",
        quantity: "light / all light of the solution",
        logarithmic: [false, false],
        found: vec![
            Found { method: "ambient term kept in the result", points: kept },
            Found { method: "only shown (ours)", points: shown },
            Found { method: "without", points: bare },
        ],
        theory: curve(&counts, |_| 1.0 + rho),
        law: "1 + ρ: what was guessed arrives again",
    }
}

/// Row 52: a lit cube, and a dark one of this edge beside it. After one shot half of
/// the light is left, and spread over all walls: `ρ · Φ/2 / ((1 − ρ) Σ A)`.
pub fn through_walls() -> Sweep {
    let edges = [0.25, 0.5, 1.0, 1.5, 2.0, 3.0];
    let after = |edge: f64, shots: usize, ambient: bool| {
        let lit = box_walls([1.0; 3]).into_iter().enumerate();
        let lit = lit.map(|(k, wall)| (wall, f64::from(u8::from(k == 5)), 0.5));
        let aside = |wall: Polygon| {
            let moved = wall.vertices().iter().map(|&v| v + 1.5 * DVec3::X);
            (Polygon::new(moved.collect()).unwrap(), 0.0, 0.5)
        };
        let scene = scene(lit.chain(box_walls([edge; 3]).map(aside)));
        let mesh = Mesh::whole(&scene);
        let enclosure = Enclosure::of(&scene, &mesh);
        let matrix = Analytic::new(&scene, &mesh, 1e-6, 0).matrix(&|| ());
        let mut solver = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
        solver.nth(shots - 1);
        let ambient = if ambient { solver.with_ambient() } else { Vec::new() };
        let shown = if ambient.is_empty() { solver.radiosity() } else { &ambient };
        shown[6..].iter().map(|b| b.x).fold(0.0, f64::max)
    };
    Sweep {
        knob: "edge of the dark room, m",
        quantity: "radiosity in the dark room, W/m²",
        logarithmic: [false, false],
        found: vec![
            Found::over("ambient term, after a shot", &edges, |a| after(a, 1, true)),
            Found::over("solution (ours)", &edges, |a| after(a, 200, false)),
        ],
        theory: curve(&edges, |a| 0.5 * 0.5 / (0.5 * 6.0 * (1.0 + a * a))),
        law: "ρ · unshot / Σ A (1 − ρ), over both rooms",
    }
}

/// How things stand after some shots.
pub struct Ahead {
    /// Light that was shot before it was there, W.
    pub owed: f64,
    /// That, and light which is not shot yet, W.
    pub open: f64,
    /// Relative to the reflected light.
    pub residual: f64,
}

/// So many shots between two squares of ρ = 0.99, each as large as `rule` says of the
/// unshot and the ambient light.
pub fn shot_ahead(shots: usize, rule: impl Fn(f64, f64) -> f64) -> Ahead {
    let (enclosure, matrix) = facing_squares(0.99, 4);
    let mut solver = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
    let mut residual = 0.0;
    for _ in 0..shots {
        let ambient = 0.99 * solver.ambient().x;
        let amount = |i: usize| rule(solver.unshot()[i].x, ambient);
        let most = |&i: &usize, &j: &usize| {
            amount(i).abs().total_cmp(&amount(j).abs()).then(j.cmp(&i))
        };
        let i = (0..enclosure.len()).max_by(most).unwrap();
        let amount = Rgb::splat(amount(i));
        residual = solver.send(ElementId(i as u32), amount).residual;
    }
    let unshot = || solver.unshot().iter();
    let owed = enclosure.power(unshot().map(|u| -u.min(Rgb::ZERO))).x;
    Ahead { owed, open: enclosure.power(unshot().map(|u| u.abs())).x, residual }
}

/// Unshot light and the guess at what comes back, within the safe bound.
pub fn bounded(unshot: f64, ambient: f64) -> f64 {
    let most = Overshoot::SAFE * unshot;
    (unshot + ambient).clamp(most.min(0.0), most.max(0.0))
}

/// Row 53. A shot of ω ΔB changes the distance from the solution by `−ω (2 − ω) ΔB²`
/// times something positive: below 2 it shrinks, above it grows. Drawn upright.
pub fn overshooting() -> Sweep {
    let factors = [1.5, 1.6, 1.7, 1.8, 1.9, 1.95, 2.05, 2.1, 2.15, 2.2];
    let after = |shots: usize| {
        move |omega: f64| shot_ahead(shots, |unshot, _| omega * unshot).open
    };
    let found = vec![
        Found::over("after 300 shots", &factors, after(300)),
        Found::over("after 150 shots", &factors, after(150)),
    ];
    let open = found.iter().flat_map(|line| &line.points).map(|p| p[1]);
    let [least, most] = open.fold([1.0_f64, 1.0_f64], |[a, b], x| [a.min(x), b.max(x)]);
    Sweep {
        knob: "what is shot / what is unshot",
        quantity: "light that is unshot or owed, W",
        logarithmic: [false, true],
        found,
        theory: vec![[2.0, least], [2.0, most]],
        law: "2: above, each shot leads away from the solution",
    }
}
