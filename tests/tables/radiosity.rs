//! Solutions of the radiosity equation, discrete and continuous, against exact values.

use crate::common::rooms::{box_walls, exact_factors, face_means, gathered, scene};
use crate::common::{cases, within};
use radiosity::chart::race::contestants;
use radiosity::form_factor::{Lost, Matrix, Row};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::solve::{Brightest, Enclosure, GaussSeidel, Jacobi, Shoot, Solver};
use serde_json::Value;

fn numbers(v: &Value) -> Vec<f64> {
    v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// The system of a case; what a row lacks to one escapes.
fn system(case: &Value) -> (Enclosure, Matrix) {
    let row = |factors: &Value| {
        let factors = numbers(factors);
        let escaped = (1.0 - factors.iter().sum::<f64>()).max(0.0);
        Row::of(&factors, Lost { escaped, ..Lost::default() })
    };
    let rows = case["F"].as_array().unwrap().iter().map(row).collect();
    let splat = |key: &str| numbers(&case[key]).into_iter().map(Rgb::splat).collect();
    let enclosure = Enclosure {
        area: numbers(&case["areas"]),
        emission: splat("E"),
        reflectance: splat("rho"),
        ..Default::default()
    };
    (enclosure, Matrix::from_rows(rows))
}

/// 28 systems solved in 40 digits: radiosity, and where the light went.
#[test]
fn all_solvers_solve_the_systems() {
    let cases = cases("C_radiosity");
    assert_eq!(cases.len(), 28);
    for case in &cases {
        let (enclosure, matrix) = system(case);
        let rho = enclosure.largest_reflectance().max_element();
        for contestant in contestants() {
            let name = contestant.name;
            let mut solver = (contestant.start)(&enclosure, &matrix);
            solver.run(rho, 1e-11, 3_000_000);
            let radiosity = solver.radiosity();
            let expected = numbers(&case["expected"]["B"]);
            // the whole field to 1e-9: a face that is nearly black has its share of it
            let scale = expected.iter().copied().fold(0.0, f64::max);
            for (got, expected) in radiosity.iter().zip(expected) {
                assert!(
                    within(got.x, expected, 1e-9, 1e-10 * scale),
                    "{} {name}: {}, not {expected}",
                    case["id"],
                    got.x
                );
            }
        }
        let mut solver = GaussSeidel::new(&enclosure, &matrix);
        let last = solver.by_ref().take(200_000).find(|step| step.residual < 1e-14);
        let ledger = last.unwrap_or_else(|| solver.next().unwrap()).ledger;
        for (got, key) in [
            (ledger.emitted.x, "power_emitted"),
            (ledger.absorbed.x, "power_absorbed"),
            (ledger.escaped.x, "power_escaped"),
        ] {
            let expected = case["expected"][key].as_f64().unwrap();
            let rounding = 1e-9 * ledger.emitted.x;
            assert!(
                within(got, expected, 1e-9, rounding),
                "{} {key}: {got}, not {expected}",
                case["id"]
            );
        }
    }
}

/// Jacobi's steps are bounces of light: after 1, 2, 5, 10 and 20 of them.
#[test]
fn jacobi_goes_bounce_by_bounce_as_published() {
    let mut seen = 0;
    for case in cases("C_radiosity") {
        let Some(bounces) = case["expected"]["gathering_B_after_k_bounces"].as_object()
        else {
            continue;
        };
        let (enclosure, matrix) = system(&case);
        let mut solver = Jacobi::new(&enclosure, &matrix);
        let mut last = 0;
        for (k, expected) in bounces {
            let k: usize = k.parse().unwrap();
            solver.nth(k - last - 1);
            last = k;
            for (got, expected) in solver.radiosity().iter().zip(numbers(expected)) {
                seen += 1;
                let id = &case["id"];
                assert!(within(got.x, expected, 1e-12, 1e-14), "{id} after {k}: {got}");
            }
        }
    }
    assert!(seen > 500, "{seen}");
}

/// Who shoots when, what is left, what the display adds: shot by shot.
#[test]
fn shooting_goes_step_by_step_as_published() {
    let mut seen = 0;
    for case in cases("C_radiosity") {
        let expected = &case["expected"]["progressive_shooting"];
        if expected.is_null() {
            continue;
        }
        seen += 1;
        let (enclosure, matrix) = system(&case);
        let mut solver = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
        // With a tie among the brightest, rounding decides who is first.
        let tied = expected["smallest_relative_margin_in_choice"].as_f64() < Some(1e-9);
        let order = expected["order"].as_array().unwrap();
        for (k, shot) in order.iter().enumerate() {
            // Nothing left to shoot: the table goes on shooting zeros.
            let Some(step) = solver.next() else { break };
            if !tied {
                assert_eq!(step.shot.unwrap().0 as u64, shot.as_u64().unwrap(), "{k}");
            }
            let state = &expected["after_shots"][(k + 1).to_string()];
            if tied || state.is_null() {
                continue;
            }
            let meets = |got: &[Rgb], key: &str| {
                let expected = numbers(&state[key]);
                for (got, expected) in got.iter().zip(expected) {
                    assert!(
                        within(got.x, expected, 1e-9, 1e-13),
                        "{} after {} shots: {key} {}, not {expected}",
                        case["id"],
                        k + 1,
                        got.x
                    );
                }
            };
            meets(solver.radiosity(), "B");
            meets(solver.unshot(), "unshot_B");
            meets(&solver.with_ambient(), "B_with_ambient");
            let unshot = state["unshot_power"].as_f64().unwrap();
            assert!(within(step.ledger.unshot.x, unshot, 1e-9, 1e-13));
        }
    }
    assert_eq!(seen, 16);
}

/// Constant elements with exact factors, mesh by mesh: an independent program's face
/// means to 1e-9. What is left to the continuous truth falls with the published order,
/// 1.65…2.
#[test]
fn boxes_meet_the_published_meshes_and_converge() {
    for case in cases("C_continuous") {
        let dims = numbers(&case["params"]["dims"]).try_into().unwrap();
        let (e, rho) = (numbers(&case["E"]), numbers(&case["rho"]));
        let walls = box_walls(dims).into_iter().zip(e.into_iter().zip(rho));
        let scene = scene(walls.map(|(wall, (e, rho))| (wall, e, rho)));
        let truth = numbers(&case["expected"]["B_face_mean"]);
        let mut last = f64::INFINITY;
        for level in case["mesh_sequence_constant_galerkin"].as_array().unwrap() {
            let cells = level["cells_per_unit_edge"].as_u64().unwrap();
            if cells > 8 {
                break; // 384 elements; each further step costs 16 times as much
            }
            let mesh = Mesh::uniform(&scene, 1.0 / cells as f64);
            let enclosure = Enclosure::of(&scene, &mesh);
            let radiosity = gathered(&enclosure, &exact_factors(&mesh), 1e-12, 10_000);
            let means = face_means(&scene, &mesh, &radiosity);
            let published = numbers(&level["B_face_mean"]);
            let mut worst = 0.0_f64;
            for ((got, published), truth) in means.iter().zip(published).zip(&truth) {
                assert!(
                    within(got.x, published, 1e-9, 1e-9),
                    "{} {cells}: {}, not {published}",
                    case["id"],
                    got.x
                );
                worst = worst.max((got.x - truth).abs());
            }
            assert!(worst < 0.4 * last || worst < 1e-9, "{}: {worst}", case["id"]);
            last = worst;
        }
    }
}
