//! Where the light of every plain built-in scene goes, as numbers: a table that is compared with
//! the one kept under `snapshots/`. To accept a change, run with `INSTA_UPDATE=always` and
//! read the difference.

use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::{Scene, builtins};
use radiosity::solve::{Brightest, Enclosure, GaussSeidel, Ledger, Shoot};
use std::fmt::Write;

/// After 20 sweeps or 200 shots, by all three kinds of factors; the imbalance is what the
/// rows allow: none for shooting where they count each direction once.
#[test]
fn ledgers_of_the_built_in_scenes() {
    let mut table = String::from(
        "scene factors solver: absorbed escaped unshot imbalance, % of emitted\n",
    );
    for scene in builtins().iter().map(|b| (b.make)()).filter(Scene::is_plain) {
        let mesh = Mesh::uniform(&scene, scene.diagonal() / 5.0);
        let enclosure = Enclosure::of(&scene, &mesh);
        let done = || ();
        for (name, matrix, allowed) in [
            ("analytic", Analytic::new(&scene, &mesh, 1e-4, 0).matrix(&done), 0.06),
            ("rays", Cast::new(&mesh, 256, 0).matrix(&done), 1e-12),
            ("hemicube", Hemicube::new(&mesh, 64).matrix(&done), 1e-12),
        ] {
            let gathered =
                GaussSeidel::new(&enclosure, &matrix).nth(19).unwrap().ledger;
            let mut solver = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
            let shot = solver.by_ref().take(200).last().unwrap().ledger;
            assert!(shot.worst_imbalance() < allowed, "{} {name} {shot:?}", scene.name);
            for (solver, ledger) in [("gather", gathered), ("shoot", shot)] {
                let scene = &scene.name;
                writeln!(table, "{scene} {name} {solver}: {}", shares(&ledger))
                    .unwrap();
            }
        }
    }
    insta::assert_snapshot!("ledgers", table);
}

/// The green channel's terms, in % of what is emitted. They must sum to all of it.
fn shares(ledger: &Ledger) -> String {
    let Ledger { emitted, absorbed, escaped, unshot, imbalance } = *ledger;
    let sum = absorbed + escaped + unshot + imbalance;
    assert!((sum - emitted).abs().max_element() <= 1e-9 * emitted.max_element());
    let percent = |power: Rgb| format!("{:.2}", 100.0 * power.y / emitted.y);
    let zero = |text: String| if text == "-0.00" { "0.00".into() } else { text };
    [absorbed, escaped, unshot, imbalance].map(|p| zero(percent(p))).join(" ")
}
