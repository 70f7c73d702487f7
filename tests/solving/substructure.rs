//! Substructuring: elements gather from patches, and the two levels agree.

use crate::common::rooms::{
    box_walls, exact_factors, gathered, rectangle, rows, scene, unit_square,
};
use glam::{DVec3, dvec3};
use radiosity::form_factor::Accuracy;
use radiosity::form_factor::Lost;
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::{Element, Mesh};
use radiosity::room::Direct;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Enclosure, OnElements, Oracle, Substructure};

/// A cube whose top emits; every wall reflects a share of its own.
fn lit_cube() -> Scene {
    let walls = box_walls([1.0, 1.5, 0.7]).into_iter().enumerate();
    let light = |wall| if wall == 5 { 1.0 } else { 0.0 };
    scene(walls.map(|(k, wall)| (wall, light(k), 0.1 + 0.14 * k as f64)))
}

/// Factors from the whole element to each patch of an empty convex room, exactly.
fn exactly(patches: &Mesh) -> impl Fn(&Element, &mut [f64]) -> Lost + Sync {
    let polygons: Vec<Polygon> = patches.polygons().cloned().collect();
    move |element, row| {
        for (q, patch) in polygons.iter().enumerate() {
            let same = element.polygon.plane().height(patch.centroid()).abs() < 1e-9;
            let power = if same {
                0.0
            } else {
                exchange(&element.polygon, patch, Accuracy::Best)
            };
            row[q] = power / element.polygon.area();
        }
        Lost::default()
    }
}

/// Factors from the element's middle, as a hemicube without cells would have them.
fn from_the_middle(patches: &Mesh) -> impl Fn(&Element, &mut [f64]) -> Lost + Sync {
    let polygons: Vec<Polygon> = patches.polygons().cloned().collect();
    move |element, row| {
        let (x, n) = (element.polygon.centroid(), element.polygon.normal());
        row.iter_mut()
            .zip(&polygons)
            .for_each(|(f, patch)| *f = lambert_polygon(x, n, patch));
        Lost::default()
    }
}

fn every_second(mesh: &Mesh) -> Vec<bool> {
    (0..mesh.elements.len()).map(|k| k % 2 == 0).collect()
}

fn off(a: &[Rgb], b: &[Rgb]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (*a - *b).abs().max_element()).fold(0.0, f64::max)
}

/// The area mean of the elements' values over each patch.
fn patch_means(mesh: &Mesh, of_elements: &[Rgb]) -> Vec<Rgb> {
    let patch = |p: &radiosity::mesh::Patch| {
        let ids = p.elements.start as usize..p.elements.end as usize;
        let sum: Rgb =
            ids.map(|k| mesh.elements[k].polygon.area() * of_elements[k]).sum();
        sum / mesh.patch_area(p)
    };
    mesh.patches.iter().map(patch).collect()
}

/// What elements gather is, in the mean, what their patch was solved to have: whatever the
/// factors, right or wrong.
#[test]
fn a_patch_is_the_mean_of_its_elements() {
    let scene = built_in("cornell").unwrap();
    let patches = Mesh::patched(&scene, 0.2);
    let cube = Hemicube::new(&patches, 32);
    let sees = |e: &Element, row: &mut [f64]| {
        cube.at(e.polygon.centroid(), e.polygon.normal(), row)
    };
    let mut both = Substructure::new(&scene, patches.clone(), &sees);
    for _ in 0..3 {
        let light = both.solve(1e-12);
        assert!(light.outcome.converged);
        let means = patch_means(both.mesh(), &light.radiosity);
        assert!(off(&means, &light.patches) < 1e-9);
        // So they have one ledger between them.
        let Enclosure { area, reflectance, .. } = Enclosure::of(&scene, both.mesh());
        let absorbed: Rgb = (0..area.len())
            .map(|k| area[k] * (Rgb::ONE - reflectance[k]) * light.irradiance[k])
            .sum();
        let ledger = light.outcome.last.ledger;
        let backs = ledger.absorbed - absorbed; // no row of a box loses light to backs
        assert!(backs.abs().max_element() < 1e-9, "{backs}");
        both.split(&every_second(both.mesh()));
    }
}

/// A patch that is its own only element: the plain system, solved as ever.
#[test]
fn without_elements_it_is_gathering() {
    let scene = lit_cube();
    let patches = Mesh::patched(&scene, 0.5);
    let sees = exactly(&patches);
    let light = Substructure::new(&scene, patches.clone(), &sees).solve(1e-12);
    let enclosure = Enclosure::of(&scene, &patches);
    let plain = gathered(&enclosure, &exact_factors(&patches), 1e-12, 1000);
    assert!(off(&light.radiosity, &plain) < 1e-9);
    assert!(off(&light.patches, &light.radiosity) < 1e-9);
}

/// Exact factors add up: the mean over the elements of `F_eq` is `F_pq`, so that elements
/// leave the patches' own solution as it was.
#[test]
fn exact_factors_of_elements_add_up_to_those_of_their_patch() {
    let scene = lit_cube();
    let patches = Mesh::patched(&scene, 0.5);
    let sees = exactly(&patches);
    let mut both = Substructure::new(&scene, patches.clone(), &sees);
    let before = both.solve(1e-12).patches;
    for _ in 0..2 {
        both.split(&every_second(both.mesh()));
    }
    assert!(off(&both.solve(1e-12).patches, &before) < 1e-9);
    let factors = rows(&both.patch_factors());
    for (row, exact) in factors.iter().zip(rows(&exact_factors(&patches))) {
        let apart = row.0.iter().zip(&exact.0).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-11);
    }
}

/// Factors from one point of a patch are wrong nearby; the mean over its elements is less
/// so, by the square of their number along an edge: what a hemicube cannot cure, elements can.
#[test]
fn elements_cure_what_the_middle_of_a_patch_gets_wrong() {
    let scene = scene(box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5)));
    let patches = Mesh::whole(&scene);
    let sees = from_the_middle(&patches);
    let mut both = Substructure::new(&scene, patches.clone(), &sees);
    let exact = 0.199_824_895_698_387;
    let to_the_ceiling = |both: &Substructure| rows(&both.patch_factors())[4].0[5];
    let mut last = to_the_ceiling(&both) - exact;
    assert!((last / exact - 0.198).abs() < 1e-3, "{last}");
    for _ in 0..4 {
        both.split(&vec![true; both.mesh().elements.len()]);
        let error = to_the_ceiling(&both) - exact;
        assert!((3.9..5.0).contains(&(last / error)), "{last} {error}");
        last = error;
    }
}

/// Elements of one patch do not interact: no row has an entry in its own patch's column.
#[test]
fn elements_of_a_patch_do_not_see_each_other() {
    let scene = built_in("l-room").unwrap();
    let patches = Mesh::patched(&scene, 0.15 * scene.diagonal());
    let cube = Hemicube::new(&patches, 64);
    let own = std::sync::atomic::AtomicUsize::new(0);
    let sees = |e: &Element, row: &mut [f64]| {
        let lost = cube.at(e.polygon.centroid(), e.polygon.normal(), row);
        if row[e.patch.0 as usize] != 0.0 {
            own.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        }
        lost
    };
    let mut both = Substructure::new(&scene, patches.clone(), &sees);
    both.split(&vec![true; patches.elements.len()]);
    let factors = rows(&both.patch_factors());
    assert!(factors.iter().enumerate().all(|(p, (row, _))| row[p] == 0.0));
    assert_eq!(own.into_inner(), 0);
}

/// `m n` factors, and of a split element only the four new rows.
#[test]
fn factors_are_counted() {
    let scene = lit_cube();
    let patches = Mesh::patched(&scene, 0.5);
    let m = patches.elements.len();
    let sees = from_the_middle(&patches);
    let mut both = Substructure::new(&scene, patches.clone(), &sees);
    assert_eq!(both.factors_computed(), m * m);
    let mut one = vec![false; m];
    one[3] = true;
    let before = both.patch_factors();
    both.split(&one);
    assert_eq!(both.mesh().elements.len(), m + 3);
    assert_eq!(both.factors_computed(), m * (m + 4));
    // The rows that were kept are still those of their elements.
    let after = both.patch_factors();
    let others = (0..m).filter(|&p| p != 3);
    assert!(others.into_iter().all(|p| before.rows()[p] == after.rows()[p]));
    assert_ne!(before.rows()[3], after.rows()[3]);
    let fresh = Substructure::new(&scene, both.mesh().clone(), &sees);
    assert_eq!(fresh.patch_factors(), after);
}

#[test]
fn a_furnace_is_a_furnace_on_both_levels() {
    let scene = built_in("furnace:0.5").unwrap();
    let patches = Mesh::patched(&scene, 0.5);
    let cube = Hemicube::new(&patches, 64);
    let sees = |e: &Element, row: &mut [f64]| {
        cube.at(e.polygon.centroid(), e.polygon.normal(), row)
    };
    let mut both = Substructure::new(&scene, patches.clone(), &sees);
    both.split(&every_second(&patches));
    let OnElements { patches, radiosity, .. } = both.solve(1e-12);
    let two = |b: &Rgb| (*b - Rgb::splat(2.0)).abs().max_element() < 1e-9;
    assert!(patches.iter().all(two) && radiosity.iter().all(two));
}

/// A white floor under a lamp of 0.1 at 1, and a black panel between that hides half.
fn half_hidden() -> Scene {
    let floor = rectangle(dvec3(-1.0, -1.0, 0.0), DVec3::X * 2.0, DVec3::Y * 2.0);
    let lamp = rectangle(dvec3(-0.05, -0.05, 1.0), DVec3::Y * 0.1, DVec3::X * 0.1);
    let panel = rectangle(dvec3(0.013, -1.0, 0.3), DVec3::X * 0.9, DVec3::Y * 2.0);
    scene([(floor, 0.0, 0.5), (lamp, 100.0, 0.0), (panel, 0.0, 0.0)])
}

/// What is left of the error of the smooth field on the floor, `‖B − B*‖/‖B*‖`, by 40 000
/// places of which no mesh has a corner.
fn error_on_floor(scene: &Scene, mesh: &Mesh, radiosity: &[Rgb]) -> f64 {
    let (direct, vertices) = (Direct::of(scene), mesh.vertex_values(radiosity));
    let (mut off, mut whole) = (0.0, 0.0);
    let at_places = |e: &Element, off: &mut f64, whole: &mut f64| {
        let light = direct.on(&e.polygon);
        let across = (100.0 * e.polygon.area().sqrt()).ceil() as usize;
        let share = e.polygon.area() / (across * across) as f64;
        for k in 0..across * across {
            let [u, v] =
                [k % across, k / across].map(|c| (c as f64 + 0.5) / across as f64);
            let x = e.polygon.point_at([u, v]);
            let truth = 0.5 * light.irradiance(x).x;
            *off += share * (mesh.value_at(e, x, &vertices).x - truth).powi(2);
            *whole += share * truth.powi(2);
        }
    };
    for e in mesh.elements.iter().filter(|e| mesh.surface_of(e) == 0) {
        at_places(e, &mut off, &mut whole);
    }
    (off / whole).sqrt()
}

#[derive(Debug)]
struct Run {
    elements: usize,
    error: f64,
    factors: usize,
}

/// The lecture's promise: split where it pays, near lights and at shadow boundaries. A
/// quarter of the elements then has less than half of the error.
#[test]
fn splitting_where_it_pays_takes_fewer_elements() {
    let scene = half_hidden();
    let direct = Direct::of(&scene);
    // The lamp is the only thing that shines.
    let sees = |e: &Element, row: &mut [f64]| {
        row.fill(0.0);
        let x = e.polygon.centroid();
        row[1] = direct.on(&e.polygon).irradiance(x).x / 100.0;
        Lost::default()
    };
    let coarse = || Mesh::whole(&scene).split(&[true, false, false]);
    let run = |marks: &dyn Fn(&Mesh, &[Rgb]) -> Vec<bool>, rounds: usize| {
        let mut both = Substructure::new(&scene, coarse(), &sees);
        for _ in 0..rounds {
            let light = both.solve(1e-9);
            let marks = marks(both.mesh(), &light.radiosity);
            both.split(&marks);
        }
        let light = both.solve(1e-9);
        let error = error_on_floor(&scene, both.mesh(), &light.radiosity);
        let (elements, factors) = (both.mesh().elements.len(), both.factors_computed());
        Run { elements, error, factors }
    };
    let all = |mesh: &Mesh, _: &[Rgb]| {
        mesh.elements.iter().map(|e| mesh.surface_of(e) == 0).collect()
    };
    let oracle = Oracle { tolerance: 0.08, smallest: 1.1 * 4.0 / 4_f64.powi(7) };
    let direct = Direct::of(&scene);
    let rise = |e: &Element| direct.rise(&e.polygon);
    let adaptive = run(&|mesh, b| oracle.marks(&scene, mesh, b, &rise), 6);
    let (uniform, finer) = (run(&all, 5), run(&all, 6));
    assert!(adaptive.elements * 4 < uniform.elements, "{adaptive:?} {uniform:?}");
    assert!(adaptive.error * 2.0 < uniform.error, "{adaptive:?} {uniform:?}");
    assert!(adaptive.factors * 4 < uniform.factors, "{adaptive:?} {uniform:?}");
    // With a sixteenth, a third more.
    assert!(adaptive.elements * 16 < finer.elements, "{adaptive:?} {finer:?}");
    assert!(adaptive.error < 1.35 * finer.error, "{adaptive:?} {finer:?}");
}

/// What the oracle marks, and that it comes to an end.
#[test]
fn the_oracle_marks_shadow_edges_and_stops() {
    let scene = half_hidden();
    let direct = Direct::of(&scene);
    let mesh = Mesh::patched(&scene, 0.1);
    let exact = |e: &Element| match mesh.surface_of(e) {
        0 => 0.5 * direct.on(&e.polygon).irradiance(e.polygon.centroid()),
        1 => Rgb::splat(100.0),
        _ => Rgb::ZERO,
    };
    let radiosity: Vec<Rgb> = mesh.elements.iter().map(exact).collect();
    let oracle = Oracle { tolerance: 0.05, smallest: 1e-3 };
    let rise = |e: &Element| direct.rise(&e.polygon);
    let marks = oracle.marks(&scene, &mesh, &radiosity, &rise);
    let xs = |wanted: bool| {
        let of = mesh.elements.iter().zip(&marks).filter(move |(_, m)| **m == wanted);
        of.map(|(e, _)| e.polygon.centroid().x).collect::<Vec<f64>>()
    };
    // The umbra's edge is where the panel's edge is seen from the lamp: at x = .013 − .3/.7
    // (.05 − .013) = −.003 it begins, and at .013 + .3/.7 (.05 + .013) = .04 it is whole.
    let near = xs(true).into_iter().filter(|x| x.abs() < 0.1).count();
    assert!(near >= 20, "{near}");
    // Deep in the shadow, and where the light is even, nothing is to be done.
    assert!(xs(true).iter().all(|x| !(0.15..0.9).contains(x)), "{:?}", xs(true));
    assert!(xs(false).len() > 200);
    let never = Oracle { smallest: 0.011, ..oracle };
    assert!(!never.marks(&scene, &mesh, &radiosity, &rise).contains(&true));
    // Nothing shines: nothing to split, and nothing divides by the light.
    let dark = crate::common::rooms::scene([(unit_square(0.0, true), 0.0, 0.5)]);
    let floor = Mesh::whole(&dark);
    assert_eq!(oracle.marks(&dark, &floor, &[Rgb::ZERO], &|_| Rgb::ZERO), [false]);
}
