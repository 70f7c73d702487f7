//! Hemicube rows with exact factors where the hemicube's assumptions are broken.

use crate::common::rooms::{black, rectangle};
use crate::common::shapes::{cube, floor, lid, mesh_of};
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::hybrid::{Assumption, Hybrid};
use radiosity::form_factor::{FormFactors, Matrix, named};
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::built_in;

/// What the first polygon's row breaks, element by element.
fn broken(
    polygons: &[Polygon],
    resolution: u32,
    tolerance: f64,
) -> Vec<Option<Assumption>> {
    let (scene, mesh) = (black(polygons.to_vec()), mesh_of(polygons, 99.0));
    let hybrid = Hybrid::new(&scene, &mesh, resolution, tolerance, 1);
    let other = |j: usize| hybrid.broken(ElementId(0), ElementId(j as u32));
    (1..polygons.len()).map(other).collect()
}

/// Each assumption is broken on purpose, one after the other.
#[test]
fn each_assumption_is_asked() {
    use Assumption::{Aliasing, Proximity, Visibility};
    let ground = floor(1.0, DVec3::ZERO);
    let above = |side: f64, height: f64| lid(side, dvec3(0.0, 0.0, height));
    // Near: whatever the tolerance. Farther: as the error asks, ⅓ 5⁻² of a factor of .013.
    assert_eq!(broken(&[ground.clone(), above(1.0, 1.0)], 256, 1.0), [Some(Proximity)]);
    let far = [ground.clone(), above(1.0, 5.0)];
    assert_eq!(broken(&far, 256, 1.5e-4), [Some(Proximity)]);
    assert_eq!(broken(&far, 256, 3e-4), [None]);
    // Coarse cells: a fiftieth wide, five cells at 512, not one at 64.
    let small = [floor(0.02, DVec3::ZERO), above(0.02, 1.0)];
    assert_eq!(broken(&small, 64, 5e-5), [Some(Aliasing)]);
    assert_eq!(broken(&small, 1024, 5e-5), [None]);
    // A card between: it counts as soon as it may hide something.
    let card = |x: f64| floor(0.2, dvec3(x, 0.0, 2.0));
    let hidden = [ground.clone(), above(1.0, 5.0), card(0.0)];
    assert_eq!(broken(&hidden, 256, 3e-4)[0], Some(Visibility));
    let beside = [ground, above(1.0, 5.0), card(0.8)];
    assert_eq!(broken(&beside, 256, 3e-4)[0], None);
    // Nothing to see, nothing to break.
    assert_eq!(
        broken(&[floor(1.0, DVec3::ZERO), floor(1.0, DVec3::Z)], 8, 1e-9),
        [None]
    );
}

/// A plane that cuts the element: its centre sees nothing of what half of it sees.
#[test]
fn a_cut_element_is_done_exactly() {
    let ground = floor(1.0, DVec3::ZERO);
    let wall = rectangle(dvec3(0.1, -0.5, 2.0), DVec3::Z, DVec3::Y);
    let polygons = [ground, wall.flipped()];
    let (scene, mesh) = (black(polygons.to_vec()), mesh_of(&polygons, 99.0));
    let mut row = [0.0; 2];
    let hybrid = Hybrid::new(&scene, &mesh, 64, 1e-3, 1);
    hybrid.row(ElementId(0), &mut row);
    let exact = Analytic::new(&scene, &mesh, 1e-9, 1);
    let exact = exact.exchange(ElementId(0), ElementId(1));
    let mut half = [0.0; 2];
    Hemicube::new(&mesh, 512).row(ElementId(0), &mut half);
    assert!((row[1] - exact).abs() < 1e-5, "{row:?} {exact}");
    // The centre is behind the wall: the hemicube alone sees nothing of it.
    assert_eq!(half[1], 0.0);
}

/// The closed forms of the unit cube, to rounding: every pair is near.
#[test]
fn a_cube_is_exact() {
    let (scene, mesh) = (black(cube()), mesh_of(&cube(), 99.0));
    let hybrid = Hybrid::new(&scene, &mesh, 16, 1e-9, 1);
    let mut row = vec![0.0; 6];
    for i in 0..6 {
        hybrid.row(ElementId(i as u32), &mut row);
        for (j, &factor) in row.iter().enumerate() {
            let expected = match (i, j) {
                _ if i == j => 0.0,
                _ if i / 2 == j / 2 => named::parallel_rectangles(1.0, 1.0, 1.0),
                _ => named::perpendicular_rectangles(1.0, 1.0, 1.0),
            };
            assert!((factor - expected).abs() < 1e-9, "{i} {j}: {factor}");
        }
    }
}

/// Root mean square and largest difference of two matrices.
fn difference(a: &Matrix, b: &Matrix) -> (f64, f64) {
    let n = a.len();
    let (mut one, mut other) = (vec![0.0; n], vec![0.0; n]);
    let (mut squares, mut most) = (0.0, 0.0_f64);
    for i in 0..n {
        a.row(ElementId(i as u32), &mut one);
        b.row(ElementId(i as u32), &mut other);
        for (x, y) in one.iter().zip(&other) {
            squares += (x - y).powi(2);
            most = most.max((x - y).abs());
        }
    }
    ((squares / (n * n) as f64).sqrt(), most)
}

/// How many pairs are put in, and what error remains, in a Cornell box.
#[test]
fn few_pairs_carry_most_of_the_error() {
    let scene = built_in("cornell-regular").unwrap();
    let mesh = Mesh::uniform(&scene, scene.diagonal() / 12.0);
    let n = mesh.elements.len();
    assert!((300..900).contains(&n), "{n}");
    let exact = Analytic::new(&scene, &mesh, 1e-5, 1).matrix(&|| ());
    let plain = Hemicube::new(&mesh, 256).turned(1).matrix(&|| ());
    let (rms, most) = difference(&plain, &exact);
    assert!(most > 0.05, "{most}"); // neighbours in a corner
    for (tolerance, share, gain) in [(1e-2, 0.025, 4.0), (1e-3, 0.2, 7.0)] {
        let hybrid = Hybrid::new(&scene, &mesh, 256, tolerance, 1);
        let (rms_now, most_now) = difference(&hybrid.matrix(&|| ()), &exact);
        let pairs = (0..n as u32).flat_map(|i| (0..n as u32).map(move |j| (i, j)));
        let put_in =
            pairs.filter(|&(i, j)| hybrid.broken(ElementId(i), ElementId(j)).is_some());
        let put_in = put_in.count() as f64 / (n * n) as f64;
        assert!(put_in < share, "{tolerance}: {put_in} of the pairs");
        assert!(most_now < 1.5 * tolerance, "{tolerance}: {most_now} remains");
        assert!(rms_now < rms / gain, "{tolerance}: {rms} became {rms_now}");
    }
}
