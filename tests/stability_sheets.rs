//! Pinned failures of sheets that let light through.

mod common;

use common::rooms::{box_walls, exact_factors, gathered, rows, scene};
use radiosity::form_factor::{Lost, Matrix, Row};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::solve::Enclosure;

/// Row 57: a sheet that reflects as much as it lets through. Programs that keep what
/// leaves its two faces, and ask what fell on them, divide by ρ² − τ²: a relative error of
/// (ρ + τ)/|ρ − τ| times that of their numbers, and nothing at all for ρ = τ. Here what
/// falls on a face is kept, and the furnace with such a sheet across it comes out.
#[test]
fn row_57_a_sheet_may_reflect_as_much_as_it_passes() {
    // Two rooms of one box; the sheet is the top of the lower and the floor of the upper.
    const SHEET: [usize; 2] = [5, 6 + 4];
    let room = scene(box_walls([1.0, 1.0, 0.5]).map(|wall| (wall, 1.0, 0.5)));
    let mesh = Mesh::whole(&room);
    let factors = rows(&exact_factors(&mesh));
    let light = |rho: f64, tau: f64, accuracy: f64| {
        let b = 2.0; // of walls with E = 1 and ρ = 1/2
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
        let matrix = Matrix::from_rows(
            all.iter().map(|r| Row::of(r, Lost::default())).collect(),
        );
        gathered(&enclosure, &matrix, accuracy, 10_000)
    };
    for (rho, tau) in [(0.4, 0.1), (0.4, 0.4), (0.4, 0.4 + 1e-9), (0.495, 0.495)] {
        for b in light(rho, tau, 1e-13) {
            assert!((b.x - 2.0).abs() < 1e-9, "{rho} {tau}: {b}");
        }
    }
    // What fell on the two faces, out of what left them: radiosities of a solver that is
    // stopped early are good to 1e-6, and what comes of them is off by 45 times itself.
    let (rho, tau) = (0.4, 0.4 - 1e-9);
    let b = light(rho, tau, 1e-6);
    assert!(b.iter().all(|b| (b.x - 2.0).abs() < 1e-5), "{b:?}");
    let [low, up] = SHEET.map(|face| b[face].x - 2.0 * (1.0 - rho - tau));
    let recovered = (rho * up - tau * low) / (rho * rho - tau * tau);
    assert!((recovered - 2.0).abs() > 2.0, "{recovered}");
}
