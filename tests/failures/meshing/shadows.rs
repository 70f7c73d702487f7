//! Rows 35 to 38: what a mesh makes of shadows. Light is that of the lamps alone, exact
//! at each place, so that all that is wrong is the mesh.

use super::super::rooms::{rectangle, scene};
use super::super::{Found, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::{Element, Mesh};
use radiosity::room::Direct;
use radiosity::scene::Scene;

/// A floor of 1 with a wall on it at `x`, beyond which all is dark: the lamp hangs on
/// the left of it, and lower than the wall is high.
pub fn beside_a_wall(x: f64) -> Scene {
    let floor = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let wall = rectangle(dvec3(x, -9.0, 0.0), DVec3::Y * 18.0, DVec3::Z * 3.0);
    let lamp = rectangle(dvec3(0.0, 0.4, 2.0), DVec3::Y * 0.2, DVec3::X * 0.2);
    scene([(floor, 0.0, 0.5), (wall, 0.0, 0.0), (lamp, 10.0, 0.0)])
}

/// Elements of the floor that are cut nowhere: the whole of it, in four, `rounds`
/// times.
pub fn uncut(scene: &Scene, rounds: usize) -> Mesh {
    let floor = |mesh: &Mesh| -> Vec<bool> {
        mesh.elements.iter().map(|e| mesh.surface_of(e) == 0).collect()
    };
    (0..rounds).fold(Mesh::whole(scene), |mesh, _| mesh.split(&floor(&mesh)))
}

fn floor(mesh: &Mesh) -> impl Iterator<Item = &Element> {
    mesh.elements.iter().filter(|e| mesh.surface_of(e) == 0)
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

/// Of the light that leaks under the wall at 0.9: the area, m², and how bright it is,
/// relative to the floor beside the wall, on its bright side.
pub fn leak(mesh: &Mesh) -> [f64; 2] {
    let scene = beside_a_wall(0.9);
    let direct = Direct::of(&scene);
    let (mut area, mut height) = (0.0, 0.0_f64);
    for e in floor(mesh) {
        let xs = e.polygon.vertices().iter().map(|v| v.x);
        let (low, high) = xs.fold((1.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
        // The lamp lights what lies before the wall, and nothing else.
        if high > 0.9 + 1e-9 && low < 0.9 {
            let lit = direct.on(&e.polygon).irradiance(dvec3(0.899, 0.5, 0.0)).x;
            area += e.polygon.area() * (high - 0.9) / (high - low);
            height = height.max(mean(&direct, e) / lit);
        }
    }
    [area, height]
}

/// The lit share of an element of edge `h` under the wall at 0.9: .9/h without its
/// whole part.
pub fn lit_share(h: f64) -> f64 {
    (0.9 / h + 1e-9).fract()
}

/// Row 35.
pub fn light_leak() -> Sweep {
    let edges = [0.5, 0.25, 0.125, 0.0625, 0.03125];
    let scene = beside_a_wall(0.9);
    let [mut brightness, mut area] = [const { Vec::new() }; 2];
    for (round, h) in edges.into_iter().enumerate() {
        let [of_leak, height] = leak(&uncut(&scene, round + 1));
        area.push([h, of_leak]);
        brightness.push([h, height]);
    }
    Sweep {
        knob: "edge of an element, m",
        quantity: "the leak: light behind the wall / before it; area, m²",
        logarithmic: [true, false],
        found: vec![
            Found { method: "brightness", points: brightness },
            Found { method: "area", points: area },
            Found::over("cut along the wall (ours)", &edges, |h| {
                leak(&Mesh::uniform(&scene, h))[1]
            }),
        ],
        theory: curve(&edges, lit_share),
        law: "brightness = the lit share of the element under the wall",
    }
}

/// Where the shadow of the wall begins, m, along the middle of the floor: at the first
/// element whose middle is dark.
pub fn shadow_begins(scene: &Scene, mesh: &Mesh) -> f64 {
    let direct = Direct::of(scene);
    let is_dark =
        |e: &&Element| direct.on(&e.polygon).irradiance(e.polygon.centroid()).x == 0.0;
    let corners = floor(mesh).filter(is_dark).flat_map(|e| e.polygon.vertices());
    corners.map(|v| v.x).fold(1.0, f64::min)
}

/// Row 36. Elements are a quarter of a metre; the foot stands somewhere in the third.
pub fn floating() -> Sweep {
    let places =
        [0.05, 0.15, 0.25, 0.35, 0.45, 0.49, 0.51, 0.55, 0.65, 0.75, 0.85, 0.95];
    let gap = |place: f64, mesh: fn(&Scene) -> Mesh| {
        let foot = 0.25 * (2.0 + place);
        let scene = beside_a_wall(foot);
        (shadow_begins(&scene, &mesh(&scene)) - foot) / 0.25
    };
    let line = |method, mesh: fn(&Scene) -> Mesh| {
        Found::over(method, &places, |place| gap(place, mesh))
    };
    Sweep {
        knob: "where the wall stands in its element, of the edge",
        quantity: "gap between wall and shadow, elements",
        logarithmic: [false, false],
        found: vec![
            line("elements that are not cut", |scene| uncut(scene, 2)),
            line("cut where they touch (ours)", |scene| Mesh::uniform(scene, 0.25)),
        ],
        theory: curve(&places, |p| if p < 0.5 { -p } else { 1.0 - p }),
        law: "the element is dark when its middle is behind the wall",
    }
}

/// A floor below a lamp that is nearly a point, and half-way a panel whose edge, and so
/// the edge of its shadow, runs aslant over the grid: `x + 0.6 y = 0.31` on the floor.
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

/// Row 37. A row of elements has its step at a middle, anywhere within half an element
/// of the edge, `u`; the edge is at `0.6 v` from there, v in the row's height. The mean
/// of `|u − 0.6 v|` is `1/4 + 0.36/12`, across the row; aslant it is nearer by
/// `1/√1.36`.
pub fn stairs() -> Sweep {
    const ASLANT: f64 = (0.25 + 0.36 / 12.0) / 1.166_190_378_969_06;
    let scene = slanting_shadow();
    let direct = Direct::of(&scene);
    let misplaced = |h: f64| {
        let mesh = Mesh::uniform(&scene, h);
        let mut wrong = 0.0;
        for e in floor(&mesh) {
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
    let edges = [0.2, 0.1, 0.05, 0.025];
    Sweep {
        knob: "edge of an element, m",
        quantity: "distance of the shown edge from the true one, mean, m",
        logarithmic: [true, true],
        found: vec![Found::over(
            "one number an element, exact light",
            &edges,
            misplaced,
        )],
        theory: curve(&edges, |h| ASLANT * h),
        law: "0.24 h, for an edge of slope 0.6",
    }
}

/// The side of the spot of row 38, m.
pub const SPOT: f64 = 0.1;

/// A lid with a square hole, a small lamp above it, and on the floor a spot of light of
/// side [`SPOT`] about `(0.125, 0.125)`.
pub fn spot() -> Scene {
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

/// The light of [`spot`] in the middles of all elements, W/m².
pub fn light_of_spot(direct: &Direct, mesh: &Mesh) -> Vec<Rgb> {
    let light = |e: &Element| match mesh.surface_of(e) {
        0 => 0.5 * direct.on(&e.polygon).irradiance(e.polygon.centroid()),
        1 => Rgb::splat(1e6),
        _ => Rgb::ZERO,
    };
    mesh.elements.iter().map(light).collect()
}

/// Row 38. The floor is two metres wide, in n × n elements; their middles are at (k +
/// ½) h.
pub fn missed_spot() -> Sweep {
    let scene = spot();
    let direct = Direct::of(&scene);
    let whole = Mesh::whole(&scene);
    let brightness = 0.5
        * direct.on(&whole.elements[0].polygon).irradiance(dvec3(0.125, 0.125, 0.0));
    let all = brightness.x * SPOT * SPOT;
    let shown = |n: usize| {
        let mesh = Mesh::uniform(&scene, 2.0 / n as f64 + 1e-9);
        let light = light_of_spot(&direct, &mesh);
        let on_floor = mesh.elements.iter().zip(&light);
        let on_floor = on_floor.filter(|(e, _)| mesh.surface_of(e) == 0);
        on_floor.map(|(e, b)| e.polygon.area() * b.x).sum::<f64>() / all
    };
    let within = |n: usize| {
        let h = 2.0 / n as f64;
        let middle = |k: usize| (k as f64 + 0.5) * h - 1.0;
        let seen = (0..n).filter(|&k| (0.075..0.175).contains(&middle(k))).count();
        (seen as f64 * h / SPOT).powi(2)
    };
    let counts = [2, 4, 8, 10, 12, 16, 20, 32, 36, 50];
    let knob = |n: usize| 2.0 / n as f64 / SPOT;
    Sweep {
        knob: "edge of an element / side of the spot",
        quantity: "light that is shown / light of the spot",
        logarithmic: [true, false],
        found: vec![Found {
            method: "one place an element",
            points: counts.iter().map(|&n| [knob(n), shown(n)]).collect(),
        }],
        theory: counts.iter().map(|&n| [knob(n), within(n)]).collect(),
        law: "h²/side² for each middle within the spot; 1 is right",
    }
}
