//! Whole matrices of convex rooms against exact values.

use crate::common::rooms::{black, exact_factors, rows};
use crate::common::{cases, has_tag, polygon, within};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::{Accuracy, FormFactors, Lost};
use radiosity::mesh::Mesh;

/// Nine rooms, through the scene and the mesh as a user would: every factor to 1e-9.
#[test]
fn matrices_of_convex_rooms() {
    let cases = cases("A_enclosures");
    assert_eq!(cases.len(), 9);
    for case in &cases {
        let faces = case["faces"].as_array().unwrap();
        let scene = black(faces.iter().map(|face| polygon(&face["polygon"])));
        let mesh = Mesh::whole(&scene);
        let method = Analytic::new(&scene, &mesh, Accuracy::Best, 0);

        let pairs = exact_factors(&mesh);
        let gate = if has_tag(case, "extreme") { 1e-6 } else { 1e-9 };
        for (name, rows) in [
            ("row", rows(&method)),
            ("matrix", rows(&method.matrix(&|| ()))),
            ("pair", rows(&pairs)),
        ] {
            for (i, (row, lost)) in rows.into_iter().enumerate() {
                assert_eq!(lost, Lost::default(), "{}", case["id"]);
                for (j, got) in row.into_iter().enumerate() {
                    let expected = case["expected"]["F"][i][j].as_f64().unwrap();
                    assert!(
                        within(got, expected, gate, 1e-16),
                        "{} by {name}: F[{i}][{j}] = {got}, not {expected}",
                        case["id"]
                    );
                }
            }
        }
    }
}
