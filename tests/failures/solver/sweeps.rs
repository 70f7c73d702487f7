//! Rows 47 to 49, 54 and 55: iterations that take long, or do not end where they
//! should.

use super::super::rooms::{
    box_walls, exact_factors, gathered, rows, scene, unit_square,
};
use super::super::{Found, Sweep, curve};
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{FormFactors, Lost, Matrix, Row, close};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::solve::{
    ConjugateGradients, Enclosure, GaussSeidel, Jacobi, Solver, error_bound,
};

/// A cube whose top emits 1 W/m², `k × k` elements a wall, with exact factors.
pub fn lit_cube(k: usize, rho: f64) -> (Enclosure, Matrix) {
    let emission = |wall: usize| f64::from(u8::from(wall == 5));
    let walls = box_walls([1.0; 3]).into_iter().enumerate();
    let scene = scene(walls.map(|(w, wall)| (wall, emission(w), rho)));
    let mesh = Mesh::uniform(&scene, 1.0 / k as f64);
    (Enclosure::of(&scene, &mesh), exact_factors(&mesh))
}

/// All light, W.
pub fn total(enclosure: &Enclosure, radiosity: &[Rgb]) -> f64 {
    enclosure.power(radiosity.iter().copied()).x
}

/// Sweeps until all light of the cube is within 1e-4 of the answer, `1/(1 − ρ)`.
fn sweeps<'a, S: Solver>(
    (enclosure, matrix): &'a (Enclosure, Matrix),
    rho: f64,
    solver: fn(&'a Enclosure, &'a Matrix) -> S,
) -> f64 {
    let mut solver = solver(enclosure, matrix);
    let near = |sum: f64| (sum * (1.0 - rho) - 1.0).abs() < 1e-4;
    let done =
        |_: &u32| solver.next().is_none() || near(total(enclosure, solver.radiosity()));
    f64::from((1..100_000).find(done).unwrap())
}

/// Row 47. After k bounces the share `ρ^(k+1)` of the light is missing.
pub fn stiffness() -> Sweep {
    let missing = [0.5, 0.2, 0.1, 0.03, 0.01, 0.003, 0.001];
    let rooms: Vec<(f64, (Enclosure, Matrix))> =
        missing.iter().map(|m| (1.0 - m, lit_cube(1, 1.0 - m))).collect();
    let line = |method, of: &dyn Fn(&(Enclosure, Matrix), f64) -> f64| {
        let points = rooms.iter().map(|(rho, room)| [1.0 - rho, of(room, *rho)]);
        Found { method, points: points.collect() }
    };
    Sweep {
        knob: "what a wall swallows, 1 − ρ",
        quantity: "sweeps to 1e-4 of the answer",
        logarithmic: [true, true],
        found: vec![
            line("Jacobi", &|room, rho| sweeps(room, rho, Jacobi::new)),
            line("Gauss–Seidel", &|room, rho| sweeps(room, rho, GaussSeidel::new)),
        ],
        theory: curve(&missing, |m| 1e-4_f64.ln() / (1.0 - m).ln()),
        law: "ln 1e-4 / ln ρ, about 9.2/(1 − ρ)",
    }
}

/// A room all of whose walls reflect all, which no material may.
pub fn white((mut enclosure, matrix): (Enclosure, Matrix)) -> (Enclosure, Matrix) {
    enclosure.reflectance.fill(Rgb::ONE);
    (enclosure, matrix)
}

/// Two squares a metre apart that face each other, the lower one a lamp.
pub fn facing_squares(rho: f64, k: usize) -> (Enclosure, Matrix) {
    let squares = [unit_square(0.0, true), unit_square(1.0, false)];
    let lit = squares.into_iter().zip([1.0, 0.0]);
    let scene = scene(lit.map(|(square, e)| (square, e, rho)));
    let mesh = Mesh::uniform(&scene, 1.0 / k as f64);
    (Enclosure::of(&scene, &mesh), exact_factors(&mesh))
}

/// Row 48: walls that reflect all, in a closed room and in an open one.
pub fn reflecting_all() -> Sweep {
    let counts = [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0];
    let line = |method, (enclosure, matrix): (Enclosure, Matrix)| {
        let mut solver = Jacobi::new(&enclosure, &matrix);
        let mut done = 0.0;
        Found::over(method, &counts, |count| {
            solver.nth((count - done) as usize - 1);
            done = count;
            total(&enclosure, solver.radiosity())
        })
    };
    Sweep {
        knob: "bounces",
        quantity: "light, W, of a lamp of 1 W",
        logarithmic: [true, true],
        found: vec![
            line("closed room, ρ = 1", white(lit_cube(1, 0.5))),
            line("two squares, ρ = 1: light can leave", white(facing_squares(0.5, 2))),
            line("closed room, ρ = 0.99", lit_cube(1, 0.99)),
        ],
        theory: curve(&counts, |count| count + 1.0),
        law: "1 W more with each bounce",
    }
}

/// Of a solver after some sweeps: the last update, the error, and the bound by the
/// residual; all in W/m² and the area norm.
fn update_error_bound(
    (enclosure, matrix): &(Enclosure, Matrix),
    mut solver: impl Solver,
    sweeps: usize,
) -> [f64; 3] {
    let rho = enclosure.largest_reflectance().x;
    let exact = gathered(enclosure, matrix, 1e-12, 100_000);
    let norm = |a: &[Rgb], b: &[Rgb]| {
        enclosure.norm_squared(a.iter().zip(b).map(|(&a, &b)| a - b)).x.sqrt()
    };
    solver.nth(sweeps - 2);
    let before = solver.radiosity().to_vec();
    let step = solver.next().unwrap();
    // The residual is relative to the reflected light of the moment.
    let light = norm(solver.radiosity(), &enclosure.emission);
    let update = norm(solver.radiosity(), &before);
    let error = norm(solver.radiosity(), &exact);
    [update, error, error_bound(step.residual, rho) * light]
}

/// Row 49. Each bounce leaves ρ of the last: `ρ + ρ² + …` are still to come.
pub fn small_updates() -> Sweep {
    let rhos = [0.8, 0.9, 0.95, 0.98, 0.99, 0.995];
    let missing = rhos.map(|rho| 1.0 - rho);
    let rooms = missing.map(|m| lit_cube(2, 1.0 - m));
    let of = |m: f64| &rooms[missing.iter().position(|&x| x == m).unwrap()];
    // Late enough for all but the slowest part to have died out.
    let sweeps = 30;
    let by = |room: &(Enclosure, Matrix)| {
        update_error_bound(room, Jacobi::new(&room.0, &room.1), sweeps)
    };
    Sweep {
        knob: "what a wall swallows, 1 − ρ",
        quantity: "error / last update",
        logarithmic: [true, true],
        found: vec![
            Found::over("Jacobi", &missing, |m| {
                let [update, error, _] = by(of(m));
                error / update
            }),
            Found::over("Gauss–Seidel", &missing, |m| {
                let (e, f) = of(m);
                let solver = GaussSeidel::new(e, f);
                let [update, error, _] = update_error_bound(of(m), solver, sweeps);
                error / update
            }),
            Found::over("bound by the residual (ours)", &missing, |m| {
                let [update, _, bound] = by(of(m));
                bound / update
            }),
        ],
        theory: curve(&missing, |m| (1.0 - m) / m),
        law: "ρ/(1 − ρ) of Jacobi's",
    }
}

/// The same room with its elements in the opposite order.
fn reversed((enclosure, matrix): &(Enclosure, Matrix)) -> (Enclosure, Matrix) {
    let n = enclosure.len();
    let back = |k: usize| n - 1 - k;
    let dense = rows(matrix);
    let row = |i: usize| {
        let row: Vec<f64> = (0..n).map(|j| dense[back(i)].0[back(j)]).collect();
        Row::of(&row, Lost::default())
    };
    let of = |values: &[Rgb]| values.iter().rev().copied().collect::<Vec<Rgb>>();
    let mirrored = Enclosure {
        area: enclosure.area.iter().rev().copied().collect(),
        emission: of(&enclosure.emission),
        reflectance: of(&enclosure.reflectance),
        ..Default::default()
    };
    (mirrored, Matrix::from_rows((0..n).map(row).collect()))
}

/// Row 54: all light after some sweeps, in one order of the elements and in the other.
pub fn order() -> Sweep {
    let there = lit_cube(2, 0.8);
    let back = reversed(&there);
    let counts = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
    let apart = |count: f64| {
        let after = |(e, f): &(Enclosure, Matrix)| {
            let mut solver = GaussSeidel::new(e, f);
            solver.nth(count as usize - 1);
            total(e, solver.radiosity())
        };
        // A logarithmic scale has no place for 0.
        (after(&there) / after(&back) - 1.0).abs().max(1e-16)
    };
    Sweep {
        knob: "sweeps",
        quantity: "light in one order / in the other, less 1",
        logarithmic: [true, true],
        found: vec![Found::over("Gauss–Seidel", &counts, apart)],
        theory: curve(&counts, |count| 0.8_f64.powf(2.0 * count)),
        law: "ρ²ᵏ: a sweep is worth two bounces",
    }
}

/// A bright cube whose factors are of 64 rays each, of hemicubes, and of the rays made
/// reciprocal and closed.
pub fn bright_cube() -> (Enclosure, [Matrix; 3]) {
    let walls = box_walls([1.0; 3]).into_iter().enumerate();
    let lit = |w: usize| f64::from(u8::from(w == 5));
    let scene = scene(walls.map(|(w, wall)| (wall, lit(w), 0.999)));
    let mesh = Mesh::uniform(&scene, 0.25);
    let enclosure = Enclosure::of(&scene, &mesh);
    let rays = Cast::new(&mesh, 64, 1).matrix(&|| ());
    let mut repaired: Vec<_> =
        rays.rows().iter().map(|row| row.factors().to_vec()).collect();
    close(&mut repaired, &enclosure.area);
    let row = |factors| Row::new(factors, Lost::default());
    let repaired = Matrix::from_rows(repaired.into_iter().map(row).collect());
    (enclosure, [rays, Hemicube::new(&mesh, 16).matrix(&|| ()), repaired])
}

/// Row 55. The bound is that of a positive definite system of this condition,
/// `κ = (1 + ρ)/(1 − ρ)`: the residual is at most `2 √κ ((√κ − 1)/(√κ + 1))^k`.
pub fn stalled_gradients() -> Sweep {
    let (enclosure, [rays, centres, repaired]) = bright_cube();
    let counts =
        [1.0, 2.0, 4.0, 7.0, 12.0, 20.0, 30.0, 50.0, 100.0, 200.0, 400.0, 500.0];
    let line = |method, matrix: &Matrix| {
        let run: Vec<f64> = ConjugateGradients::new(&enclosure, matrix)
            .take(500)
            .map(|step| step.residual)
            .collect();
        // Whoever is done stays there.
        let last = *run.last().unwrap();
        let after = |k: f64| run.get(k as usize - 1).copied().unwrap_or(last);
        Found::over(method, &counts, |k| after(k).max(1e-16))
    };
    let root = (1.999_f64 / 0.001).sqrt();
    Sweep {
        knob: "steps",
        quantity: "residual / reflected light",
        logarithmic: [true, true],
        found: vec![
            line("factors by 64 rays", &rays),
            line("by hemicubes", &centres),
            line("rays, made reciprocal and closed", &repaired),
        ],
        theory: curve(&counts, |k| 2.0 * root * ((root - 1.0) / (root + 1.0)).powf(k)),
        law: "at most, were the factors reciprocal",
    }
}
