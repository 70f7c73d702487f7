//! Values between the corners of an element: exact where they can be, and numbers always.

use glam::{DVec3, dvec3};
use radiosity::geometry::{Frame, Polygon};
use radiosity::mesh::wachspress;
use std::f64::consts::PI;

/// A linear field.
fn field(at: DVec3) -> DVec3 {
    let (offset, x, y) =
        (dvec3(0.05, 0.1, 0.4), dvec3(1.0, 0.2, -0.4), dvec3(0.1, 1.0, 0.5));
    PI * (offset + x * at.x + y * at.y)
}

/// Wachspress weights are positive, sum to 1, and reproduce linear fields and corners.
#[test]
fn interpolation_is_exact_for_linear_fields() {
    let hexagon: Vec<DVec3> =
        [(0.0, 0.0), (1.0, -0.2), (1.6, 0.3), (1.5, 1.0), (0.7, 1.3), (0.1, 0.9)]
            .map(|(x, y)| dvec3(x, y, 0.5 * x - 0.2 * y))
            .to_vec();
    for outline in [&hexagon[..], &hexagon[..4], &hexagon[..3]] {
        let polygon = Polygon::new(outline.to_vec()).unwrap();
        let centre = polygon.centroid();
        for (k, &corner) in outline.iter().enumerate() {
            let next = outline[(k + 1) % outline.len()];
            for p in [corner, centre, corner.lerp(centre, 0.3), corner.lerp(next, 0.4)]
            {
                let weights = wachspress(&polygon, p);
                let values = outline.iter().zip(&weights).map(|(&v, &w)| w * field(v));
                let got: DVec3 = values.sum();
                assert!(got.distance(field(p)) < 1e-14, "{got}, not {}", field(p));
                assert!(weights.iter().all(|w| (0.0..=1.0 + 1e-15).contains(w)));
            }
        }
    }
}

/// `Σ w_k v_k` is off from `p` by at most so many roundings of the polygon's size, times
/// how often the least height of a corner above the line through its neighbours goes into
/// it: the areas beside that corner are known to so many roundings only.
fn assert_reproduces(polygon: &Polygon, p: DVec3) {
    let v = polygon.vertices();
    let n = v.len();
    let size = v.iter().fold(0.0_f64, |most, a| most.max(a.length()));
    let least = (0..n).map(|k| {
        let (a, b, c) = (v[(k + n - 1) % n], v[k], v[(k + 1) % n]);
        ((b - a) / size).cross((c - a) / size).length() / ((c - a) / size).length()
    });
    let least = least.fold(1.0, f64::min);
    let weights = wachspress(polygon, p);
    let total: f64 = weights.iter().sum();
    let got: DVec3 = v.iter().zip(&weights).map(|(&v, &w)| w * (v / size)).sum();
    let off = got.distance(p / size);
    let most = 16.0 * f64::EPSILON / least;
    assert!(off <= most, "{n} corners of size {size:e}: {off:e} > {most:e}");
    assert!((total - 1.0).abs() < 1e-14 && weights.iter().all(|w| *w >= 0.0));
}

/// Points of all kinds: within, near an edge, on it, near a corner, in it.
fn points_of(polygon: &Polygon) -> Vec<DVec3> {
    let (v, centre) = (polygon.vertices(), polygon.centroid());
    let steps = [1, 2, 3, 5, 9, 17, 33, 65, 129, 257];
    let mut points = vec![centre];
    for k in steps.into_iter().filter(|&k| k <= v.len()).map(|k| k - 1) {
        let on_edge = v[k].lerp(v[(k + 1) % v.len()], 0.3);
        points.extend([v[k], on_edge, centre.lerp(v[k], 0.9)]);
        for near in [1e-3, 1e-8, 1e-15] {
            points.extend([v[k].lerp(centre, near), on_edge.lerp(centre, near)]);
        }
    }
    points
}

#[test]
fn interpolation_stands_many_corners_and_all_scales() {
    let turned = Frame::about(dvec3(0.36, 0.48, 0.8));
    for n in
        (3..=20).chain([31, 32, 63, 64, 100, 128, 200, 255, 256, 257, 400, 511, 512])
    {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / n as f64;
            turned.x * angle.cos() + turned.y * angle.sin()
        };
        for scale in [1e-70, 1e-30, 1e-3, 1.0, 1e30, 1e70] {
            let corners = (0..n).map(|k| scale * corner(k)).collect();
            let polygon = Polygon::new(corners).unwrap();
            points_of(&polygon).iter().for_each(|&p| assert_reproduces(&polygon, p));
        }
    }
}

#[test]
fn interpolation_stands_slivers() {
    for thin in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let at = |x: f64, y: f64| dvec3(x, y * thin, 0.0);
        for outline in [
            vec![at(0.0, 0.0), at(1.0, 0.0), at(0.4, 1.0)],
            vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)],
            vec![at(0.0, 0.0), at(0.5, -1.0), at(1.0, 0.0), at(0.3, 1.0)],
        ] {
            let polygon = Polygon::new(outline).unwrap();
            points_of(&polygon).iter().for_each(|&p| assert_reproduces(&polygon, p));
        }
    }
}

/// Pieces cut from faces that pierce each other may be as narrow as rounding, or have a
/// corner twice: their weights are numbers, and sum to 1.
#[test]
fn interpolation_stands_outlines_that_rounding_closes() {
    let (mut kept, far) = (0, dvec3(1e3 / 3.0, 1e3 / 7.0, 1e3 / 11.0));
    for thin in (12..20).map(|digits| 0.1_f64.powi(digits)) {
        let at = |x: f64, y: f64| far + dvec3(x, y * thin, x);
        for outline in [
            vec![at(0.0, 0.0), at(1.0, 0.0), at(0.4, 1.0)],
            vec![at(0.0, 0.0), at(0.5, 0.0), at(1.0, 0.0), at(0.3, 1.0)],
            vec![at(0.0, 0.0), at(0.0, 0.0), at(1.0, 0.0), at(0.4, 1.0)],
        ] {
            let Ok(polygon) = Polygon::new(outline) else { continue };
            kept += 1;
            for p in points_of(&polygon) {
                let weights = wachspress(&polygon, p);
                assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)), "{weights:?}");
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            }
        }
    }
    assert!(kept > 0, "no outline as narrow as that is a polygon");
}

/// A corner in the middle of a straight edge changes nothing, on the edge and off it.
#[test]
fn interpolation_passes_over_straight_corners() {
    let outline = [(0.0, 0.0), (1.0, 0.1), (3.0, 0.3), (2.0, 2.0), (0.0, 1.5)]
        .map(|(x, y)| dvec3(x, y, x - 2.0 * y));
    let straight = Polygon::new(outline.to_vec()).unwrap();
    let whole = [outline[0], outline[2], outline[3], outline[4]];
    let whole = Polygon::new(whole.to_vec()).unwrap();
    for p in points_of(&straight) {
        let mut weights = wachspress(&straight, p);
        assert_eq!(weights.remove(1), 0.0);
        for (got, expected) in weights.iter().zip(wachspress(&whole, p)) {
            assert!((got - expected).abs() < 1e-13, "{p}: {got}, not {expected}");
        }
    }
}

/// On a rectangle the weights are bilinear.
#[test]
fn interpolation_is_bilinear_on_rectangles() {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)];
    let outline = corners.map(|(x, y)| dvec3(x, y, 0.0)).to_vec();
    let weights = wachspress(&Polygon::new(outline).unwrap(), dvec3(0.5, 0.25, 0.0));
    for (got, expected) in weights.iter().zip([0.5625, 0.1875, 0.0625, 0.1875]) {
        assert!((got - expected).abs() < 1e-15, "{weights:?}");
    }
}
