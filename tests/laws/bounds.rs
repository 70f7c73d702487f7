//! Bounds of partly hidden factors hold, whatever stands between.

use crate::common::rooms::black;
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::random::Stream;

const A: ElementId = ElementId(0);
const B: ElementId = ElementId(1);

/// The unit squares one apart, and a few random triangles between them.
fn squares_and_triangles(random: &mut Stream) -> Vec<Polygon> {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let square = |z: f64| corners.map(|(x, y)| dvec3(x, y, z)).to_vec();
    let mut all = vec![
        Polygon::new(square(0.0)).unwrap(),
        Polygon::new(square(1.0)).unwrap().flipped(),
    ];
    let triangles = 1 + (3.0 * random.next()) as usize;
    while all.len() < 2 + triangles {
        // Some of them pierce the squares' planes.
        let mut point = || {
            let (x, y, z) = (random.next(), random.next(), random.next());
            1.4 * dvec3(x, y, z) - DVec3::splat(0.2)
        };
        all.extend(Polygon::new(vec![point(), point(), point()]));
    }
    all
}

/// 1000 random scenes: the factor lies between its bounds, and more halvings never widen
/// them. The factor is asked to 1e-4, and may miss the bounds by as much.
#[test]
fn the_factor_lies_between_its_bounds() {
    let mut random = Stream::named(33, &[]);
    let (mut gap, mut narrower) = (0.0, 0.0);
    for case in 0..1000 {
        let scene = black(squares_and_triangles(&mut random));
        let mesh = Mesh::whole(&scene);
        let method = Analytic::new(&scene, &mesh, 1e-4, 0);
        let factor = method.exchange(A, B);
        let (low, high) = method.bounds(A, B, 4);
        let (lower, higher) = method.bounds(A, B, 8);
        assert!(low <= lower + 1e-12 && higher <= high + 1e-12, "case {case}");
        assert!(
            lower - 1e-4 <= factor && factor <= higher + 1e-4,
            "case {case}: {factor} is not in [{lower}, {higher}]"
        );
        gap += high - low;
        narrower += higher - lower;
    }
    // Four halvings halve the edges of all pieces, and so, in the end, the share of pairs
    // of pieces that a shadow's edge runs through; pieces as coarse as these gain less (.85 here).
    let ratio = narrower / gap;
    assert!((0.5..0.9).contains(&ratio), "four halvings leave {ratio} of the gap");
}

/// With nothing between both bounds are the factor; with a wall between, zero.
#[test]
fn bounds_of_all_and_nothing() {
    let mut random = Stream::named(34, &[]);
    let squares = squares_and_triangles(&mut random)[..2].to_vec();
    let bounds = |polygons: Vec<Polygon>| {
        let scene = black(polygons);
        let mesh = Mesh::whole(&scene);
        Analytic::new(&scene, &mesh, 1e-6, 0).bounds(A, B, 6)
    };
    let (low, high) = bounds(squares.clone());
    assert_eq!(low, high);
    assert!((low - 0.199824895698387).abs() < 1e-12);
    let wall = [(-1.0, -1.0), (2.0, -1.0), (2.0, 2.0), (-1.0, 2.0)];
    let wall = wall.map(|(x, y)| dvec3(x, y, 0.5)).to_vec();
    let hidden = squares.into_iter().chain([Polygon::new(wall).unwrap()]);
    assert_eq!(bounds(hidden.collect()), (0.0, 0.0));
}
