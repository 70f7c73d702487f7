//! Pinned failures of what is shown of a solution, row by row of the table of failures: each
//! asserts how large the failure is, or that the trap is avoided.

mod common;

use common::rooms::{box_walls, exact_factors, gathered, rectangle, scene};
use glam::{DVec3, dvec3};
use radiosity::film::{linear_from_srgb, srgb_from_linear};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::{Element, Mesh};
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Enclosure, Oracle};

/// The lamp of rows 40 and 41: a square of 0.2 that hangs 0.2 above the origin.
fn low_lamp() -> Polygon {
    rectangle(dvec3(-0.1, -0.1, 0.2), DVec3::Y * 0.2, DVec3::X * 0.2)
}

/// What is off along a line under the lamp's middle, with elements of edge `h`.
struct OnLine {
    /// One number for an element, that of its middle.
    flat: f64,
    /// Linear between exact values at the vertices.
    linear: f64,
    /// Linear between means of the neighbours' middles.
    averaged: f64,
    /// The largest kink of the linear field: the change of its slope.
    kink: f64,
}

impl OnLine {
    fn of(h: f64) -> OnLine {
        let lamp = low_lamp();
        let exact = |x: DVec3| lambert_polygon(x, DVec3::Z, &lamp);
        // A strip so narrow that it is a line, two elements longer than what is looked at.
        let (half, width) = (0.5 + 2.0 * h, 1e-4);
        let corner = dvec3(-half, -0.5 * width, 0.0);
        let strip = rectangle(corner, DVec3::X * 2.0 * half, DVec3::Y * width);
        let mesh = Mesh::uniform(&scene([(strip, 0.0, 0.5)]), h);
        let means: Vec<Rgb> =
            mesh.polygons().map(|p| Rgb::splat(exact(p.centroid()))).collect();
        let averaged = mesh.vertex_values(&means);
        let corners: Vec<Rgb> =
            mesh.vertices.iter().map(|&v| Rgb::splat(exact(v))).collect();
        let mut on = OnLine { flat: 0.0, linear: 0.0, averaged: 0.0, kink: 0.0 };
        for (k, e) in mesh.elements.iter().enumerate() {
            let middle = e.polygon.centroid().x;
            if middle.abs() > 0.5 {
                continue;
            }
            for step in -100..=100 {
                let x = DVec3::X * (middle + 0.4999 * h * f64::from(step) / 100.0);
                let off = |b: Rgb| (b.x - exact(x)).abs();
                on.flat = on.flat.max(off(means[k]));
                on.linear = on.linear.max(off(mesh.value_at(e, x, &corners)));
                on.averaged = on.averaged.max(off(mesh.value_at(e, x, &averaged)));
            }
        }
        let at = |k: i32| exact(DVec3::X * (f64::from(k) * h));
        let most = (0.5 / h) as i32;
        for k in -most..=most {
            on.kink = on.kink.max(((at(k + 1) - 2.0 * at(k) + at(k - 1)) / h).abs());
        }
        on
    }
}

const EDGES: [f64; 5] = [0.5, 0.25, 0.125, 0.0625, 0.03125];

/// Row 40, Mach bands: the eye sees where the slope changes. Half the element does not mean
/// half the kink: it first grows, since the coarse mesh had missed how steep the light is.
#[test]
fn row_40_kinks_get_worse_before_they_get_better() {
    let expected = [0.93, 1.49, 1.36, 0.81, 0.42];
    for (h, expected) in EDGES.into_iter().zip(expected) {
        let kink = OnLine::of(h).kink;
        assert!((kink - expected).abs() < 0.006, "{h}: {kink}");
    }
}

/// Row 41: one number for an element errs as its size; what is linear between exact corners
/// errs as the square of it, in the end, and half as much as between means of neighbours.
#[test]
fn row_41_flat_is_of_first_order_and_smooth_of_second() {
    let flat = [0.186, 0.101, 0.060, 0.032, 0.016];
    let linear = [0.070, 0.021, 0.018, 0.0060, 0.0016];
    let averaged = [0.187, 0.088, 0.034, 0.012, 0.0032];
    for (k, h) in EDGES.into_iter().enumerate() {
        let on = OnLine::of(h);
        for (got, expected) in
            [(on.flat, flat[k]), (on.linear, linear[k]), (on.averaged, averaged[k])]
        {
            // Two digits.
            let close = (got - expected).abs() < 0.035 * expected;
            assert!(close, "{h}: {got} for {expected}");
        }
    }
    let order = |of: fn(&OnLine) -> f64, h: f64| {
        (of(&OnLine::of(h)) / of(&OnLine::of(0.5 * h))).log2()
    };
    for h in [0.02, 0.01] {
        assert!((order(|on| on.flat, h) - 1.0).abs() < 0.05);
        assert!((order(|on| on.linear, h) - 2.0).abs() < 0.1);
        assert!((order(|on| on.averaged, h) - 2.0).abs() < 0.1);
        let on = OnLine::of(h);
        assert!((on.averaged / on.linear - 2.0).abs() < 0.1);
        assert!((order(|on| on.kink, h) - 1.0).abs() < 0.05);
    }
}

/// A floor of 1 with a wall on it at `x`, beyond which all is dark: the lamp hangs on the
/// left of it, and lower than the wall is high.
fn beside_a_wall(x: f64) -> Scene {
    let floor = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let wall = rectangle(dvec3(x, -9.0, 0.0), DVec3::Y * 18.0, DVec3::Z * 3.0);
    let lamp = rectangle(dvec3(0.0, 0.4, 2.0), DVec3::Y * 0.2, DVec3::X * 0.2);
    scene([(floor, 0.0, 0.5), (wall, 0.0, 0.0), (lamp, 10.0, 0.0)])
}

/// Elements of the floor that are cut nowhere: the whole of it, in four, `rounds` times.
fn uncut(scene: &Scene, rounds: usize) -> Mesh {
    let floor = |mesh: &Mesh| -> Vec<bool> {
        mesh.elements.iter().map(|e| mesh.surface_of(e) == 0).collect()
    };
    (0..rounds).fold(Mesh::whole(scene), |mesh, _| mesh.split(&floor(&mesh)))
}

/// The mean of the lamp's light over an element, by 32 × 32 places.
fn mean(direct: &Direct, e: &Element) -> f64 {
    let light = direct.on(&e.polygon);
    let at = |k: usize| {
        let [u, v] = [k % 32, k / 32].map(|c| (c as f64 + 0.5) / 32.0);
        light.irradiance(e.polygon.point_at([u, v])).x
    };
    (0..1024).map(at).sum::<f64>() / 1024.0
}

/// Row 35: halve an element that straddles a wall, and the leak gets narrower, but no less
/// bright: what falls is its area. Cut along the wall, none is left.
#[test]
fn row_35_a_leak_falls_in_area_and_not_in_height() {
    let scene = beside_a_wall(0.9);
    let direct = Direct::of(&scene);
    let leaks = |mesh: &Mesh| {
        let (mut area, mut height) = (0.0, 0.0_f64);
        for e in mesh.elements.iter().filter(|e| mesh.surface_of(e) == 0) {
            let xs = e.polygon.vertices().iter().map(|v| v.x);
            let (low, high) =
                xs.fold((1.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
            let light = mean(&direct, e);
            if high > 0.9 + 1e-9 && light > 0.0 {
                area += e.polygon.area() * (high - 0.9_f64.max(low)) / (high - low);
                // Beside the wall, on its bright side.
                let lit = direct.on(&e.polygon).irradiance(dvec3(0.899, 0.5, 0.0)).x;
                height = height.max(light / lit);
            }
        }
        [area, height]
    };
    // The lit share of the element under the wall: .9/h without its whole part.
    for (rounds, share) in [(1, 0.8), (2, 0.6), (3, 0.2), (4, 0.4), (5, 0.8)] {
        let h = 0.5_f64.powi(rounds);
        let [area, height] = leaks(&uncut(&scene, rounds as usize));
        assert!((area - (1.0 - share) * h).abs() < 1e-9, "{rounds}: {area}");
        assert!((height / share - 1.0).abs() < 0.25, "{rounds}: {height}");
    }
    for edge in [0.5, 0.3, 0.1] {
        assert_eq!(leaks(&Mesh::uniform(&scene, edge)), [0.0, 0.0]);
    }
}

/// Row 36, floating objects: the shadow of what stands on the floor begins where the first
/// element begins whose middle is dark, up to half an element beyond the foot (it floats) or
/// before it (a shadow leak). Elements that are cut where they touch leave no gap.
#[test]
fn row_36_things_float_above_coarse_floors() {
    // Where the shadow begins, along the middle of the floor.
    let begins = |scene: &Scene, mesh: &Mesh| {
        let direct = Direct::of(scene);
        let dark = mesh.elements.iter().filter(|e| {
            let x = e.polygon.centroid();
            mesh.surface_of(e) == 0 && direct.on(&e.polygon).irradiance(x).x == 0.0
        });
        let corners = dark.flat_map(|e| e.polygon.vertices().to_vec());
        corners.map(|v| v.x).fold(1.0, f64::min)
    };
    for (foot, rounds, gap) in
        [(0.26, 1, 0.24), (0.74, 1, -0.24), (0.64, 2, 0.11), (0.33, 4, -0.0175)]
    {
        let scene = beside_a_wall(foot);
        let start = begins(&scene, &uncut(&scene, rounds));
        assert!((start - foot - gap).abs() < 1e-9, "{foot} {rounds}: {start}");
        assert!(gap.abs() <= 0.5 * 0.5_f64.powi(rounds as i32));
        for edge in [0.5, 0.25, 0.125] {
            let begin = begins(&scene, &Mesh::uniform(&scene, edge));
            assert!((begin - foot).abs() < 1e-7, "{begin}");
        }
    }
}

/// A floor below a lamp that is nearly a point, and half-way a panel whose edge, and so the
/// edge of its shadow, runs aslant over the grid: `x + 0.6 y = 0.31` on the floor.
fn slanting_shadow() -> Scene {
    let floor = rectangle(dvec3(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y);
    let lamp =
        rectangle(dvec3(-0.0005, -0.0005, 1.0), DVec3::Y * 1e-3, DVec3::X * 1e-3);
    // Half-way up, all is half as far from the middle: x + 0.6 y = 0.155.
    let at = |y: f64| dvec3(0.155 - 0.6 * y, y, 0.5);
    let panel =
        vec![at(2.0), at(-2.0), at(-2.0) + DVec3::X * 9.0, at(2.0) + DVec3::X * 9.0];
    let panel = Polygon::new(panel).unwrap();
    scene([(floor, 0.0, 0.5), (lamp, 1e6, 0.0), (panel, 0.0, 0.0)])
}

/// Row 37, jagged shadows: with one number for an element the edge of a shadow runs along
/// the grid, in steps. It is out of place by a quarter of an element in the mean, and halves
/// with it: first order only, however exact the light.
#[test]
fn row_37_shadow_edges_are_stairs() {
    let scene = slanting_shadow();
    let direct = Direct::of(&scene);
    let misplaced = |h: f64| {
        let mesh = Mesh::uniform(&scene, h);
        let mut wrong = 0.0;
        for e in mesh.elements.iter().filter(|e| mesh.surface_of(e) == 0) {
            let light = direct.on(&e.polygon);
            let shown = light.irradiance(e.polygon.centroid()).x > 0.0;
            for k in 0..400 {
                let [u, v] = [k % 20, k / 20].map(|c| (f64::from(c) + 0.5) / 20.0);
                let x = e.polygon.point_at([u, v]);
                let lit = x.x + 0.6 * x.y < 0.31;
                if lit != shown {
                    wrong += e.polygon.area() / 400.0;
                }
            }
        }
        // The edge runs from y = −.5 to y = .5, where x = .61 is beyond the floor.
        let length = 1.36_f64.sqrt() * (0.5 - (0.31 - 0.5) / 0.6);
        wrong / length
    };
    for h in [0.1, 0.05, 0.025] {
        let share = misplaced(h) / h;
        assert!((0.2..0.3).contains(&share), "{h}: {share}");
    }
}

/// A lid with a square hole, a small lamp above it, and on the floor a spot of light of side
/// `0.1` about `(0.125, 0.125)`.
fn spot() -> Scene {
    let floor = rectangle(dvec3(-1.0, -1.0, 0.0), DVec3::X * 2.0, DVec3::Y * 2.0);
    let lamp = rectangle(dvec3(-1e-3, -1e-3, 1.0), DVec3::Y * 2e-3, DVec3::X * 2e-3);
    // Half-way up the hole is half as large, and half as far from the middle.
    let (low, high) = (0.5 * 0.075, 0.5 * 0.175);
    let bar = |from: [f64; 2], to: [f64; 2]| {
        let size = dvec3(to[0] - from[0], to[1] - from[1], 0.0);
        let corner = dvec3(from[0], from[1], 0.5);
        rectangle(corner, DVec3::X * size.x, DVec3::Y * size.y)
    };
    let lid = [
        bar([-3.0, -3.0], [low, 3.0]),
        bar([high, -3.0], [3.0, 3.0]),
        bar([low, -3.0], [high, low]),
        bar([low, high], [high, 3.0]),
    ];
    let things = [(floor, 0.0, 0.5), (lamp, 1e6, 0.0)].into_iter();
    scene(things.chain(lid.map(|bar| (bar, 0.0, 0.0))))
}

/// Rows 38 and 43: a spot of light smaller than an element, beside its middle and away from
/// its corners, is missed by all who look at these: the floor stays black, the error is the
/// whole of the spot, and the oracle, which looks at the same places, marks nothing.
#[test]
fn rows_38_and_43_a_spot_between_the_places_is_not_there() {
    let scene = spot();
    let direct = Direct::of(&scene);
    let oracle = Oracle { tolerance: 1e-3, smallest: 1e-4 };
    let look = |edge: f64| {
        let mesh = Mesh::patched(&scene, edge);
        let light = |e: &Element| match mesh.surface_of(e) {
            0 => 0.5 * direct.on(&e.polygon).irradiance(e.polygon.centroid()),
            1 => Rgb::splat(1e6),
            _ => Rgb::ZERO,
        };
        let radiosity: Vec<Rgb> = mesh.elements.iter().map(light).collect();
        let floor = mesh.elements.iter().zip(&radiosity);
        let floor = floor.filter(|(e, _)| mesh.surface_of(e) == 0);
        let brightest = floor.map(|(_, b)| b.x).fold(0.0, f64::max);
        let marks = oracle.marks(&scene, &mesh, &radiosity);
        (brightest, marks.iter().filter(|mark| **mark).count())
    };
    let whole = Mesh::whole(&scene);
    let there = direct.on(&whole.elements[0].polygon);
    let truth = 0.5 * there.irradiance(dvec3(0.125, 0.125, 0.0)).x;
    assert!(truth > 0.5, "{truth}");
    assert!(there.irradiance(dvec3(0.25, 0.25, 0.0)) == Rgb::ZERO);
    // Elements of 1, .5: the spot lies beside the middle, .25, and the corner, 0.
    for edge in [1.0, 0.5] {
        assert_eq!(look(edge), (0.0, 0), "{edge}");
    }
    // Elements of .25, whose middle it is.
    let (brightest, marked) = look(0.25);
    assert!((brightest / truth - 1.0).abs() < 1e-9 && marked > 0, "{brightest}");
}

/// Row 46: a floor of bright and dark tiles as one mean reflectance. The mean of the
/// reflectances gives the light of the room; that of the numbers in an sRGB picture, which
/// are not proportional to light, loses a tenth of what is reflected.
#[test]
fn row_46_the_mean_of_a_texture_is_taken_in_linear_light() {
    const TILES: usize = 8;
    let tiles = [0.9, 0.1];
    let reflected = |floor: &dyn Fn(usize, usize) -> f64| {
        let mut faces: Vec<_> = box_walls([1.0; 3]).map(|w| (w, 0.0, 0.5)).to_vec();
        faces[5].1 = 1.0;
        faces.remove(4); // the floor, which is tiled
        let step = 1.0 / TILES as f64;
        for k in 0..TILES * TILES {
            let (i, j) = (k % TILES, k / TILES);
            let corner = dvec3(i as f64 * step, j as f64 * step, 0.0);
            let tile = rectangle(corner, step * DVec3::X, step * DVec3::Y);
            faces.push((tile, 0.0, floor(i, j)));
        }
        let mesh = Mesh::whole(&scene(faces.clone()));
        let enclosure = Enclosure::of(&scene(faces), &mesh);
        let light = gathered(&enclosure, &exact_factors(&mesh), 1e-12, 10_000);
        enclosure.power(light.iter().zip(&enclosure.emission).map(|(&b, &e)| b - e)).x
    };
    let tiled = reflected(&|i, j| tiles[(i + j) % 2]);
    let linear = reflected(&|_, _| 0.5 * (tiles[0] + tiles[1]));
    let encoded = 0.5 * (srgb_from_linear(tiles[0]) + srgb_from_linear(tiles[1]));
    let wrong = reflected(&|_, _| linear_from_srgb(encoded));
    assert!((linear / tiled - 1.0).abs() < 1e-3, "{linear} {tiled}");
    assert!((0.05..0.15).contains(&(1.0 - wrong / tiled)), "{}", wrong / tiled);
}
