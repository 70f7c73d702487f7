//! The suites without a clock: counts that theory gives, and the orders that chapters claim.

use radiosity::chart::suites::{meshes, plan, scaling};
use radiosity::chart::{Bench, Column, Trial, exponent};
use radiosity::scene::built_in;

/// The trials of a method, in order.
fn of<'t>(trials: &'t [Trial], method: &str) -> Vec<&'t Trial> {
    let found: Vec<&Trial> = trials.iter().filter(|t| t.method == method).collect();
    assert!(found.len() > 1, "{method} ran {} times", found.len());
    found
}

/// Of equally many factors or links, links err less than a matrix; of no more elements,
/// smooth light does. A matrix has n² factors, links grow about as elements.
#[test]
fn links_and_smooth_light_do_better_than_a_matrix() {
    let reach = meshes::Reach { truth: 0.01, even: 1000.0, rounds: 2, finest: 0.02 };
    let trials = meshes::contest(meshes::CUBE, reach, &Bench::SILENT);
    let (matrix, links) = (of(&trials, meshes::HEMICUBES), of(&trials, meshes::LINKS));
    for t in &matrix {
        assert_eq!(t.work.factors as f64, t.setting.powi(2));
        assert_eq!(t.work.pixels as f64, 3.0 * 256.0 * 256.0 * t.setting);
    }
    let grown = exponent(&links, Column::Setting, Column::Factors);
    assert!((0.9..1.4).contains(&grown), "links grow by the power {grown}");
    let last = matrix.last().unwrap();
    let cheap = |t: &&&Trial| t.work.factors <= last.work.factors;
    let best = links.iter().rfind(cheap).unwrap();
    assert!(best.error < last.error, "{} links: {}", best.work.factors, best.error);
    let smooth = of(&trials, meshes::SMOOTH);
    let small = smooth.iter().rfind(|t| t.setting <= last.setting).unwrap();
    assert!(small.error < 0.5 * last.error, "{}: {}", small.setting, small.error);
}

/// In the room that is lit through a gap, elements split where the oracle says err hardly
/// more than twice as many that are split all over.
#[test]
fn elements_are_saved_where_nothing_happens() {
    let reach = meshes::Reach { truth: 0.01, even: 300.0, rounds: 2, finest: 0.1 };
    let trials = meshes::contest(meshes::INDIRECT, reach, &Bench::SILENT);
    let [all, marked] = [meshes::ALL, meshes::MARKED].map(|m| of(&trials, m)[1]);
    assert!(marked.setting < 0.6 * all.setting, "{} elements", marked.setting);
    assert!(marked.error < 1.2 * all.error, "{} and {}", marked.error, all.error);
    let patches = of(&trials, meshes::ALL)[0].setting;
    // Rows of the patches, once as elements and once as parents of others.
    assert_eq!(all.work.factors as f64, patches * (patches + all.setting));
}

/// Factors grow as the square, cells as the rows, and a ray meets something in a closed
/// room however small the tiles.
#[test]
fn counts_grow_as_theory_says() {
    let room = built_in("cornell-regular").unwrap();
    let tiles = [60.0, 240.0];
    let trials = scaling::rows("room", &room, &tiles, &Bench::SILENT);
    for t in &trials {
        assert_eq!(t.work.factors as f64, scaling::ROWS_TIMED as f64 * t.setting);
    }
    let closed = built_in("furnace").unwrap();
    for t in of(&scaling::rays(&closed, &tiles, &Bench::SILENT), "rays") {
        assert_eq!(t.work.rays, scaling::RAYS as u64);
    }
    let all = scaling::stages(
        "room",
        &built_in("cornell").unwrap(),
        &[60.0, 200.0],
        &Bench::SILENT,
    );
    let factors = of(&all, "form factors");
    assert!((exponent(&factors, Column::Setting, Column::Factors) - 2.0).abs() < 1e-12);
    assert!((exponent(&factors, Column::Setting, Column::Pixels) - 1.0).abs() < 1e-12);
    for t in factors {
        assert!(t.work.bytes < 16 * t.work.factors, "zeros are not kept");
    }
}

/// First links are between all pairs of surfaces: on many small ones, their number goes
/// by the square, and that of smooth light's hemicubes does not.
#[test]
fn links_suffer_from_many_surfaces() {
    let room = built_in("cornell-regular").unwrap();
    let trials = scaling::surfaces(&room, &[100.0, 300.0], &Bench::SILENT);
    let links = of(&trials, "links");
    let grown = exponent(&links, Column::Setting, Column::Factors);
    assert!((1.5..2.1).contains(&grown), "links grow by the power {grown}");
}

/// What is asked is certified, what is certified holds, and all that work is at most twice
/// that of the cheapest fixed setting that would have done - which nobody knows beforehand -
/// and its proof. (Without its proof it would cost less: facing squares would do with a
/// fifth of the light. But then nobody would know.)
#[test]
fn a_plan_costs_at_most_twice_the_best_in_hindsight() {
    for name in ["facing-squares", "cornell"] {
        let asked = [0.05, 0.02];
        let trials = plan::contest(name, &asked, &asked, &Bench::SILENT);
        let of = |method| of(&trials, method);
        let (certified, best) = (of(plan::CERTIFIED), of(plan::BEST));
        for (k, done) in of(plan::PLAN).iter().enumerate() {
            assert!(certified[k].error <= done.setting, "{name}: {:?}", certified[k]);
            assert!(done.error <= certified[k].error + done.uncertainty, "{done:?}");
            assert!(best[k].error <= done.setting, "{:?}", best[k]);
            let ratio = plan::cost(&done.work) / plan::cost(&best[k].work);
            assert!(ratio <= 2.0, "{name}, {}: {ratio} times the work", done.setting);
        }
    }
}
