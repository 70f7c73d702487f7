//! Failures of visibility: rows 29 to 34.

use super::exact::{FACING, past_screen};
use super::rooms::{black, box_walls, moved, unit_square};
use super::shapes::squares_with_screen;
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec2, DVec3, Vec3, dvec3};
use radiosity::form_factor::Accuracy;
use radiosity::form_factor::analytic::{Analytic, exchange};
use radiosity::geometry::{Polygon, Ray};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use radiosity::visibility::Visibility;
use std::f64::consts::{PI, TAU};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 29,
        name: "One ray decides",
        why: "A ray from middle to middle answers yes or no for all pairs of points.",
        size: "As a screen's corner slides past the middle, F jumps from .1998 to 0; the \
               truth glides through .1499.",
        remedy: "Cut the polygons by what hides them, or draw many rays.",
        tests: &["occlusion::row_29_one_ray_decides_all_or_nothing"],
        shown: Shown::Curve(one_ray),
    },
    Row {
        number: 30,
        name: "A millimetre of safety",
        why: "An offset against self-shadowing is a length, and the scene may have any.",
        size: "Rays that begin at 1 mm lose .08 % of the light in a room of 1 m, 8 % in one \
               of 1 cm, 69 % in one of 1 mm; ours begin at 0 and lose none at any scale.",
        remedy: "A ray never meets the face that it leaves: no length is needed.",
        tests: &[
            "occlusion::row_30_scale_does_not_matter",
            "occlusion::row_30_an_offset_is_a_length",
        ],
        shown: Shown::Curve(offsets),
    },
    Row {
        number: 31,
        name: "Cracks between triangles",
        why: "Each triangle rounds its own edge; neighbours that do not share the sums \
              leave a crack between.",
        size: "Of rays aimed at corners and edges of a closed sphere 1 to 9 % slip out in \
               single precision; of ours none, nor of a million random ones.",
        remedy: "Shear all into the ray's frame, so that neighbours see the same numbers.",
        tests: &["occlusion::row_31_no_ray_leaves_a_closed_sphere"],
        shown: Shown::Curve(cracks),
    },
    Row {
        number: 32,
        name: "A wire that samples miss",
        why: "What is thin is met by few pairs of points, and by none with a chance of \
              (1 − p)ⁿ.",
        size: "A wire of .01 is missed by all of 100 pairs in 13 % of cases; it hides a \
               third of its width, however thin.",
        remedy: "Cut by the wire's own outline.",
        tests: &["occlusion::row_32_samples_miss_a_wire"],
        shown: Shown::Curve(wire_missed),
    },
    Row {
        number: 33,
        name: "Mean visibility times F",
        why: "The pairs that still see each other are not like the others: nearer, or \
              farther.",
        size: "Past a screen over three quarters V·F is 14 % too little; the open area's \
               share in place of V gives 71 % too much.",
        remedy: "Integrate the kernel and visibility together.",
        tests: &["occlusion::row_33_mean_visibility_is_not_a_factor"],
        shown: Shown::Curve(mean_visibility),
    },
    Row {
        number: 34,
        name: "A tree for three walls",
        why: "A hierarchy pays by what it does not look at; of few triangles there is \
              nothing to skip.",
        size: "In a box of 12 triangles the tree makes more tests than there are triangles; \
               with 972 it makes 36 times fewer. (Counted, not timed.)",
        remedy: "Leaves of a few triangles; no tree below that.",
        tests: &["occlusion::row_34_a_tree_does_not_pay_for_few"],
        shown: Shown::Curve(tree),
    },
];

/// Squares with a screen over `u` and `v` midway: do the middles see each other?
pub fn middles_see(pair: &[Polygon]) -> bool {
    let ray = Ray { origin: pair[0].centroid(), direction: DVec3::Z };
    Visibility::new(pair).closest(&ray, Some(0)).is_some_and(|hit| hit.item == 1)
}

/// The exact method's factor from the first polygon to the second.
pub fn ours(polygons: &[Polygon], tolerance: f64) -> f64 {
    let scene = black(polygons.to_vec());
    let mesh = Mesh::whole(&scene);
    let method = Analytic::new(&scene, &mesh, tolerance, 0);
    method.exchange(ElementId(0), ElementId(1))
}

/// Row 29.
pub fn one_ray() -> Sweep {
    let knobs = [0.2, 0.3, 0.4, 0.499_999, 0.500_001, 0.6, 0.7, 0.8];
    let pair = |edge: f64| squares_with_screen(0.0..edge, 0.0..edge);
    Sweep {
        knob: "side of a screen in the corner",
        quantity: "F past it",
        logarithmic: [false, false],
        found: vec![
            Found::over("one ray", &knobs, |edge| match middles_see(&pair(edge)) {
                true => FACING,
                false => 0.0,
            }),
            Found::over("ours", &knobs, |edge| ours(&pair(edge), 1e-6)),
        ],
        theory: curve(&knobs, |edge| past_screen([0.0..edge, 0.0..edge])),
        law: "the pairs whose middle misses the screen, integrated",
    }
}

/// The share, in per cent, of rays from the floor of a closed cube of this `side`
/// that meet nothing when they begin at `offset`.
pub fn escaped(side: f64, offset: f64) -> f64 {
    const RAYS: usize = 20_000;
    let walls = box_walls([side; 3]);
    let visibility = Visibility::new(&walls);
    let leaves = |[a, b, c, d]: [f64; 4]| {
        let direction = cosine_direction(DVec2::new(c, d));
        let origin = dvec3(a, b, 0.0) * side + offset * direction;
        visibility.closest(&Ray { origin, direction }, Some(4)).is_none()
    };
    let rays = Stream::named(30, &[]).points(RAYS);
    100.0 * rays.filter(|&ray| leaves(ray)).count() as f64 / RAYS as f64
}

/// Row 30.
pub fn offsets() -> Sweep {
    let knobs = [1e-3, 2e-3, 5e-3, 1e-2, 3e-2, 0.1, 1.0, 1e3];
    Sweep {
        knob: "side of the room, m",
        quantity: "rays that leave it, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("rays begin at 1 mm", &knobs, |side| escaped(side, 1e-3)),
            Found::over("ours", &knobs, |side| escaped(side, 0.0)),
        ],
        theory: curve(&knobs[3..], |side| 100.0 * 8.0 / (3.0 * PI) * 1e-3 / side),
        law: "four edges × 2/(3π) × 1 mm/side, first order",
    }
}

/// A sphere of triangles that share their corners.
pub fn sphere(rings: usize) -> Vec<Polygon> {
    let sectors = 2 * rings;
    let at = |i: usize, j: usize| {
        let theta = PI * i as f64 / rings as f64;
        let phi = TAU * (j % sectors) as f64 / sectors as f64;
        if i == 0 || i == rings {
            return dvec3(0.0, 0.0, if i == 0 { 1.0 } else { -1.0 });
        }
        dvec3(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())
    };
    let mut faces = Vec::new();
    for i in 0..rings {
        for j in 0..sectors {
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            for k in [[0, 1, 2], [0, 2, 3]] {
                faces.extend(Polygon::new(k.map(|n| corners[n]).to_vec()));
            }
        }
    }
    faces
}

/// Rays from a point within, aimed at the corners and the middles of edges: the hard ones.
pub fn hard_rays(faces: &[Polygon]) -> impl Iterator<Item = Ray> + '_ {
    let targets =
        faces.iter().flat_map(|f| f.edges().flat_map(|(a, b)| [a, b, a.midpoint(b)]));
    targets.map(|target| {
        let origin = dvec3(0.1, -0.2, 0.05);
        Ray { origin, direction: (target - origin).normalize() }
    })
}

/// The wrong method: each triangle decides for itself, in single precision (Möller &
/// Trumbore).
fn meets(ray: &Ray, triangle: &Polygon) -> bool {
    let [a, b, c] = [0, 1, 2].map(|k| triangle.vertices()[k].as_vec3());
    let (origin, direction): (Vec3, Vec3) =
        (ray.origin.as_vec3(), ray.direction.as_vec3());
    let (e, f, s) = (b - a, c - a, origin - a);
    let p = direction.cross(f);
    let determinant = e.dot(p);
    let q = s.cross(e);
    let (u, v) = (s.dot(p) / determinant, direction.dot(q) / determinant);
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && f.dot(q) / determinant > 0.0
}

/// Row 31.
pub fn cracks() -> Sweep {
    let knobs = [4.0, 6.0, 8.0, 12.0, 16.0];
    let share = |rings: f64, sees: &dyn Fn(&[Polygon], &Ray) -> bool| {
        let faces = sphere(rings as usize);
        let out = hard_rays(&faces).filter(|ray| !sees(&faces, ray)).count();
        100.0 * out as f64 / (9 * faces.len()) as f64
    };
    let tight = |rings: f64| {
        let visibility = Visibility::new(&sphere(rings as usize));
        share(rings, &|_, ray| visibility.closest(ray, None).is_some())
    };
    let each = |faces: &[Polygon], ray: &Ray| faces.iter().any(|f| meets(ray, f));
    Sweep {
        knob: "rings of triangles of a closed sphere",
        quantity: "rays at edges that slip out, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("each triangle by itself", &knobs, |rings| share(rings, &each)),
            Found::over("ours", &knobs, tight),
        ],
        theory: curve(&knobs, |_| 0.0),
        law: "none: the sphere is closed",
    }
}

/// Facing squares with a wire of this width across, midway.
pub fn wire(width: f64) -> Vec<Polygon> {
    squares_with_screen(0.5 - width / 2.0..0.5 + width / 2.0, 0.0..1.0)
}

/// The share, in per cent, of `tries` in which each of so many random pairs of points sees
/// past the wire.
pub fn missed(width: f64, pairs: usize, tries: usize) -> f64 {
    let visibility = Visibility::new(&wire(width));
    let [from, to] = [unit_square(0.0, true), unit_square(1.0, false)];
    let mut random = Stream::named(32, &[pairs as u64]);
    let mut all_see = || {
        (0..pairs).all(|_| {
            let origin = from.point_at([random.next(), random.next()]);
            let end = to.point_at([random.next(), random.next()]);
            let ray = Ray { origin, direction: (end - origin).normalize() };
            visibility.closest(&ray, Some(0)).is_some_and(|hit| hit.item == 1)
        })
    };
    100.0 * (0..tries).filter(|_| all_see()).count() as f64 / tries as f64
}

/// Row 32.
pub fn wire_missed() -> Sweep {
    const WIDTH: f64 = 0.01;
    let knobs = [1.0, 5.0, 10.0, 30.0, 100.0, 200.0];
    Sweep {
        knob: "pairs of points",
        quantity: "cases in which the wire is not met, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("random pairs", &knobs, |n| missed(WIDTH, n as usize, 2000)),
            Found::over("ours", &knobs, |_| {
                100.0 * f64::from(u8::from(ours(&wire(WIDTH), 1e-6) > FACING - 1e-4))
            }),
        ],
        theory: curve(&knobs, |n| 100.0 * (1.0 - 2.0 * WIDTH).powf(n)),
        law: "(1 − p)ⁿ, p = 2 × width",
    }
}

/// The share of pairs of points of facing squares that see each other past a screen over
/// x < `edge`, midway; by 128 × 127 pairs, so that no middle lies on its edge.
pub fn visible_pairs(edge: f64) -> f64 {
    const CELLS: [usize; 2] = [128, 127];
    let visibility = Visibility::new(&squares_with_screen(0.0..edge, 0.0..1.0));
    let place = |k: usize, n: usize| (k as f64 + 0.5) / n as f64;
    let sees = |pair: &usize| {
        let from = place(pair % CELLS[0], CELLS[0]);
        let to = place(pair / CELLS[0], CELLS[1]);
        let origin = dvec3(from, 0.5, 0.0);
        let direction = (dvec3(to, 0.5, 1.0) - origin).normalize();
        let hit = visibility.closest(&Ray { origin, direction }, Some(0));
        hit.is_some_and(|hit| hit.item == 1)
    };
    let all = CELLS[0] * CELLS[1];
    (0..all).filter(sees).count() as f64 / all as f64
}

/// Row 33.
pub fn mean_visibility() -> Sweep {
    let knobs = [0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9];
    let exact = |edge: f64| past_screen([0.0..edge, 0.0..1.0]);
    let off = |f: f64, edge: f64| 100.0 * (f / exact(edge) - 1.0);
    let open =
        exchange(&unit_square(0.0, true), &unit_square(1.0, false), Accuracy::Best);
    let sees = |edge: f64| match edge < 0.5 {
        true => 1.0 - 2.0 * edge * edge,
        false => 2.0 * (1.0 - edge).powi(2),
    };
    Sweep {
        knob: "screen over x < …",
        quantity: "error of F, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("mean visibility × F", &knobs, |e| {
                off(visible_pairs(e) * open, e)
            }),
            Found::over("open area × F", &knobs[..6], |e| off((1.0 - e) * open, e)),
            Found::over("ours", &knobs, |e| {
                off(ours(&squares_with_screen(0.0..e, 0.0..1.0), 1e-6), e)
            }),
        ],
        theory: curve(&knobs, |e| off(sees(e) * FACING, e)),
        law: "mean of pairs, 2(1 − x)², times F, over the integral of both",
    }
}

/// Tests of boxes and of triangles that a ray needs, on average over a thousand rays, in a
/// cube with n × n tiles to a wall; by the tree, and how many triangles there are. A box is
/// looked into when the ray enters it before its hit: as if the nearest were known.
pub fn tests_of_a_ray(n: usize) -> (f64, f64) {
    const RAYS: usize = 1000;
    let tile = |wall: &Polygon, k: usize| {
        let (i, j) = ((k % n) as f64, (k / n) as f64);
        let [o, a, b] = [0, 1, 3].map(|k| wall.vertices()[k]);
        let shift = (a - o) * i / n as f64 + (b - o) * j / n as f64;
        moved(wall, |p| o + (p - o) / n as f64 + shift)
    };
    let walls = box_walls([1.0; 3]);
    let tiles: Vec<Polygon> =
        walls.iter().flat_map(|wall| (0..n * n).map(move |k| tile(wall, k))).collect();
    let visibility = Visibility::new(&tiles);
    let mut random = Stream::named(34, &[]);
    let mut tests = 0;
    for _ in 0..RAYS {
        let mut point = || dvec3(random.next(), random.next(), random.next());
        let (origin, direction) = (point(), (point() - 0.5).normalize());
        let hit = visibility.closest(&Ray { origin, direction }, None);
        let reach = hit.map_or(f64::INFINITY, |hit| hit.distance);
        let boxes = std::cell::Cell::new(0);
        let mut triangles = 0;
        let outside = |low: DVec3, high: DVec3| {
            boxes.set(boxes.get() + 1);
            let (a, b) = ((low - origin) / direction, (high - origin) / direction);
            let enter = a.min(b).max_element().max(0.0);
            enter > a.max(b).min_element() + 1e-12 || enter > reach
        };
        visibility.visit(outside, |_| triangles += 1);
        tests += boxes.get() + triangles;
    }
    (f64::from(tests) / RAYS as f64, 2.0 * tiles.len() as f64)
}

/// Row 34.
pub fn tree() -> Sweep {
    let tiles = [1, 2, 3, 5, 9, 16];
    let by_tree = tiles.map(|n| {
        let (tests, triangles) = tests_of_a_ray(n);
        [triangles, tests]
    });
    let all = by_tree.map(|p| p[0]);
    Sweep {
        knob: "triangles",
        quantity: "tests of boxes and triangles for a ray",
        logarithmic: [true, true],
        found: vec![Found { method: "tree", points: by_tree.to_vec() }],
        theory: curve(&all, |n| n),
        law: "without a tree: each triangle once",
    }
}
