//! Failures of pictures of ids: rows 23 to 28.

use super::exact::{STRIP, above, beside, past_screen};
use super::rooms::{black, moved, rectangle, rows as all_rows, unit_square};
use super::shapes::squares_with_screen;
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DQuat, DVec2, DVec3, dvec3};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::{CubeFace, Hemicube, Weights};
use radiosity::form_factor::hybrid::Hybrid;
use radiosity::form_factor::pictures::Pictures;
use radiosity::geometry::{Frame, Plane, Polygon};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::random::Stream;
use radiosity::raster::{ItemBuffer, Seen, View};
use radiosity::scene::Scene;
use std::f64::consts::PI;

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 23,
        name: "The centre sees one shadow",
        why: "What hides some of a patch is taken to hide the same of it from everywhere \
              on the other.",
        size: "Past a screen that hides three quarters one hemicube sees nothing; 2 × 2 err \
               by +5 %, 3 × 3 by −7 %, 6 × 6 by .7 %.",
        remedy: "Ask what may stand between, and do those pairs exactly.",
        tests: &["hemicube::row_23_the_centre_sees_one_shadow"],
        shown: Shown::Curve(one_shadow),
    },
    Row {
        number: 24,
        name: "Black corners",
        why: "A near plane cuts away what is nearer than it: just the wall beside the \
              element.",
        size: "Half of the factor is in that wall, and all of it is lost; ours has no near \
               plane and loses nothing at 1e-8.",
        remedy: "Clip to the pyramid of the eye alone, in homogeneous coordinates.",
        tests: &["hemicube::row_24_no_near_plane_cuts_the_corner"],
        shown: Shown::Curve(near_plane),
    },
    Row {
        number: 25,
        name: "Two faces fight for a plane",
        why: "The depths of two faces in one plane differ by rounding alone, which any move \
              of the eye rolls anew.",
        size: "A third of a poster's pixels change hands when the eye moves by a millionth; \
               in ours none, for what lies beneath was cut away.",
        remedy: "Settle who owns the plane once, when the scene is read: the smaller wins.",
        tests: &["hemicube::row_25_coplanar_faces_do_not_fight"],
        shown: Shown::Curve(fight),
    },
    Row {
        number: 26,
        name: "Ids as colours",
        why: "A colour holds 24 bits, and what smooths edges mixes two ids to a third.",
        size: "With 2²⁵ patches half of all ids come back as others; ours are numbers, and \
               none does.",
        remedy: "Keep ids in integers, and never blend them.",
        tests: &["hemicube::row_26_ids_neither_overflow_nor_blend"],
        shown: Shown::Curve(colours),
    },
    Row {
        number: 27,
        name: "A single plane has no horizon",
        why: "One picture above the element, however wide, ends before the horizon.",
        size: "It misses 44.6 % at half-width 1, 17 % at 2, .8 % at 10, and nothing in the \
               row says so.",
        remedy: "Hemicube or cubic tetrahedron: their pictures close at the horizon.",
        tests: &["hemicube::row_27_a_single_plane_loses_the_horizon"],
        shown: Shown::Curve(horizon),
    },
    Row {
        number: 28,
        name: "Light through backs",
        why: "A renderer that skips faces it sees from behind looks through them.",
        size: "All of the light comes through a one-sided wall; through ours exactly none, \
               and what falls on the back is booked.",
        remedy: "Draw backs too, as black blockers.",
        tests: &["hemicube::row_28_no_light_through_backs"],
        shown: Shown::Curve(backs),
    },
];

/// The factor from the first to the second polygon, cut into elements of at most `edge`.
pub fn between(
    polygons: &[Polygon],
    edge: f64,
    factors: &dyn Fn(&Scene, &Mesh) -> Vec<Vec<f64>>,
) -> f64 {
    let scene = black(polygons.to_vec());
    let mesh = Mesh::uniform(&scene, edge);
    let factors = factors(&scene, &mesh);
    let [from, to] = [0, 1].map(|k| mesh.patches[k].elements.clone());
    let power = |i: u32| {
        let row = &factors[i as usize];
        let area = mesh.elements[i as usize].polygon.area();
        area * to.clone().map(|j| row[j as usize]).sum::<f64>()
    };
    from.map(power).sum::<f64>() / polygons[0].area()
}

pub fn by_hemicube(_: &Scene, mesh: &Mesh) -> Vec<Vec<f64>> {
    all_rows(&Hemicube::new(mesh, 256)).into_iter().map(|r| r.0).collect()
}

pub fn by_hybrid(scene: &Scene, mesh: &Mesh) -> Vec<Vec<f64>> {
    let hybrid = Hybrid::new(scene, mesh, 256, 1e-4, 1);
    all_rows(&hybrid).into_iter().map(|r| r.0).collect()
}

/// Row 23.
pub fn one_shadow() -> Sweep {
    let pair = squares_with_screen(0.0..0.75, 0.0..1.0);
    let off = |f: f64| 100.0 * (f / STRIP - 1.0);
    // From x the screen's edge at ¾ throws its shadow up to 3/2 − x.
    let from_centres = |k: f64| {
        let n = k as u32;
        let place = |i: u32| (f64::from(i) + 0.5) / k;
        let seen = |x: f64, y: f64| match 1.5 - x {
            edge if edge < 1.0 => above(x, y, [edge..1.0, 0.0..1.0]),
            _ => 0.0,
        };
        let all = (0..n * n).map(|c| seen(place(c % n), place(c / n))).sum::<f64>();
        off(all / (k * k))
    };
    let knobs = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    Sweep {
        knob: "hemicubes along the square",
        quantity: "error of F, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("hemicubes of 256", &knobs, |k| {
                off(between(&pair, 1.0 / k, &by_hemicube))
            }),
            Found::over("repaired pair by pair", &knobs[..3], |k| {
                off(between(&pair, 1.0 / k, &by_hybrid))
            }),
        ],
        theory: curve(&knobs, from_centres),
        law: "closed form from the centres, each with its own shadow",
    }
}

/// The half-width and the height of the wall of row 24.
const WALL: f64 = 5.0;

/// The wrong method: a hemicube of 64 at the origin that sees nothing nearer than `near`
/// in the direction of a face.
pub fn cut_near(near: f64, polygon: &Polygon) -> f64 {
    let (weights, frame) = (Weights::exact(64), Frame::about(DVec3::Z));
    let mut cells = ItemBuffer::new(1, 1);
    let of_face = |face: CubeFace| {
        let view = face.view(DVec3::ZERO, &frame);
        let forward = view.direction(match face {
            CubeFace::Top => DVec2::ZERO,
            _ => DVec2::NEG_Y, // the sides' pictures end at the horizon
        });
        let forward = forward.normalize();
        let beyond = Plane::through(near * forward, forward);
        let (width, height) = face.size(64);
        cells.reset(width, height);
        if let Some(polygon) = polygon.clipped(beyond) {
            cells.draw(&view, &polygon, 0);
        }
        let seen = cells.pixels().zip(weights.of(face));
        seen.filter(|s| s.0 == Seen::Front(0)).map(|s| s.1).sum::<f64>()
    };
    CubeFace::ALL.into_iter().map(of_face).sum::<f64>().abs() // no −0
}

/// A wall beside the origin, this far away.
pub fn wall_at(gap: f64) -> Polygon {
    rectangle(dvec3(gap, -WALL, 0.0), DVec3::Z * WALL, DVec3::Y * 2.0 * WALL)
}

/// Row 24.
pub fn near_plane() -> Sweep {
    let knobs = [1e-8, 1e-5, 1e-3, 3e-3, 0.02, 0.1, 0.5, 2.0];
    Sweep {
        knob: "distance of the wall",
        quantity: "F of the wall",
        logarithmic: [true, false],
        found: vec![
            Found::over("near plane at .01", &knobs, |gap| {
                cut_near(0.01, &wall_at(gap))
            }),
            Found::over("ours", &knobs, |gap| cut_near(0.0, &wall_at(gap))),
        ],
        theory: curve(&knobs, |gap| beside(gap, WALL, WALL)),
        law: "closed form (Howell B-4)",
    }
}

/// A poster on a wall, both in one slanted plane that is turned in its own way.
fn poster_on_wall(turn: u64) -> [Polygon; 2] {
    let mut random = Stream::named(turn, &[25]);
    let mut angle = || 0.8 * (random.next() - 0.5);
    let turn = DQuat::from_rotation_x(angle()) * DQuat::from_rotation_y(angle());
    let slanted = |square: Polygon| moved(&square, |p| turn * p + DVec3::Z);
    let square = |half: f64| {
        let corner = dvec3(-half, -half, 0.0);
        slanted(rectangle(corner, DVec3::Y * 2.0 * half, DVec3::X * 2.0 * half))
    };
    [square(0.7), square(0.4)]
}

/// The share, in per cent, of pixels within the poster that show something else when the
/// eye moves by `shift`, over forty pairs of poster and wall; `settled`: as the scene is read.
pub fn flips(shift: f64, settled: bool) -> f64 {
    const SIDE: u32 = 48;
    const PAIRS: u64 = 40;
    let frame = Frame::about(DVec3::Z);
    let (mut changed, mut all) = (0, 0);
    for turn in 0..PAIRS {
        let pair = poster_on_wall(turn);
        let pieces: Vec<(Polygon, u32)> = if settled {
            let scene = black(pair.clone());
            scene.surfaces.iter().map(|s| (s.polygon.clone(), s.face.0)).collect()
        } else {
            pair.iter().cloned().zip(0..).collect()
        };
        let shown = |view: &View| {
            let mut buffer = ItemBuffer::new(SIDE, SIDE);
            pieces.iter().for_each(|(polygon, id)| buffer.draw(view, polygon, *id));
            buffer.pixels().collect::<Vec<_>>()
        };
        let eyes = [DVec3::ZERO, shift * dvec3(0.8, 0.5, 0.3)];
        let [before, after] = eyes.map(|eye| shown(&CubeFace::Top.view(eye, &frame)));
        let view = CubeFace::Top.view(DVec3::ZERO, &frame);
        let poster = &pair[1];
        for (k, (a, b)) in (0..).zip(before.into_iter().zip(after)) {
            let at = View::pixel_centre(k % SIDE, k / SIDE, SIDE, SIDE);
            let ray = view.direction(at);
            let plane = poster.plane();
            let on_plane = ray * (plane.height(DVec3::ZERO) / -plane.normal.dot(ray));
            if poster.contains(on_plane, -0.05) {
                all += 1;
                changed += u32::from(a != b);
            }
        }
    }
    100.0 * f64::from(changed) / f64::from(all)
}

/// Row 25.
pub fn fight() -> Sweep {
    let knobs = [1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3];
    Sweep {
        knob: "how far the eye moves",
        quantity: "pixels of the poster that change, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("both drawn", &knobs, |shift| flips(shift, false)),
            Found::over("ours: the smaller wins", &knobs, |shift| flips(shift, true)),
        ],
        theory: curve(&knobs, |_| 50.0),
        law: "a coin tossed anew for each pixel: at most one half",
    }
}

/// The wrong method: an id through a colour of 24 bits.
pub fn as_colour(id: u32) -> u32 {
    let [blue, green, red, _] = id.to_le_bytes();
    u32::from_le_bytes([blue, green, red, 0])
}

/// What a pixel says that was drawn with this id.
pub fn drawn(id: u32) -> u32 {
    let frame = Frame::about(DVec3::Z);
    let mut pixel = ItemBuffer::new(1, 1);
    let square = moved(&unit_square(1.0, false), |p| p - dvec3(0.5, 0.5, 0.0));
    pixel.draw(&CubeFace::Top.view(DVec3::ZERO, &frame), &square, id);
    match pixel.seen(0, 0) {
        Seen::Front(id) => id,
        other => panic!("the square faces the eye, and shows {other:?}"),
    }
}

/// Row 26.
pub fn colours() -> Sweep {
    let knobs = [22, 23, 24, 25, 26, 27, 28].map(|bits| f64::from(1u32 << bits));
    let wrong = |patches: f64, way: fn(u32) -> u32| {
        let places = Stream::named(26, &[]).points(500);
        let ids = places.map(|[u]: [f64; 1]| (u * patches) as u32);
        ids.filter(|&id| way(id) != id).count() as f64 / 5.0
    };
    Sweep {
        knob: "patches",
        quantity: "ids that come back wrong, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("colours of 24 bits", &knobs, |n| wrong(n, as_colour)),
            Found::over("ours", &knobs, |n| wrong(n, drawn)),
        ],
        theory: curve(&knobs, |n| 100.0 * (1.0 - f64::from(1 << 24) / n).max(0.0)),
        law: "1 − 2²⁴/patches",
    }
}

/// Row 27.
pub fn horizon() -> Sweep {
    let knobs = [0.5, 1.0, 2.0, 4.0, 10.0, 20.0];
    let scene = black([unit_square(1.0, false)]);
    let mesh = Mesh::whole(&scene);
    let missed = |pictures: Pictures| {
        100.0 * (1.0 - pictures.weights().flatten().sum::<f64>()).max(0.0)
    };
    Sweep {
        knob: "half-width of the plane / its distance",
        quantity: "light that it cannot see, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("single plane", &knobs, |w| {
                missed(Pictures::single_plane(&mesh, 64, w))
            }),
            Found::over("cubic tetrahedron", &knobs, |_| {
                missed(Pictures::tetrahedron(&mesh, 64))
            }),
        ],
        theory: curve(&knobs, |w| {
            let s = w / w.hypot(1.0);
            100.0 * (1.0 - 4.0 / PI * s * s.atan())
        }),
        law: "1 − 4/π s atan s, s = w/√(1 + w²)",
    }
}

/// A lamp below, a receiver above, and a square of this side midway that shows the lamp its
/// back.
pub fn past_a_back(side: f64) -> Vec<Polygon> {
    let range = 0.5 - 0.5 * side..0.5 + 0.5 * side;
    squares_with_screen(range.clone(), range)
}

/// Row 28.
pub fn backs() -> Sweep {
    let knobs = [0.1, 0.25, 0.5, 0.75, 0.9, 1.0, 1.2];
    let seen = |polygons: Vec<Polygon>| {
        let scene = black(polygons);
        let mesh = Mesh::whole(&scene);
        Analytic::new(&scene, &mesh, 1e-5, 0).exchange(ElementId(0), ElementId(1))
    };
    Sweep {
        knob: "side of a wall that shows its back",
        quantity: "F from lamp to receiver behind it",
        logarithmic: [false, false],
        found: vec![
            // A face that is not drawn is not there.
            Found::over("backs skipped", &knobs, |side| {
                seen(past_a_back(side)[..2].to_vec())
            }),
            Found::over("ours", &knobs, |side| seen(past_a_back(side))),
        ],
        theory: curve(&knobs, |side| {
            let range = 0.5 - 0.5 * side..0.5 + 0.5 * side;
            past_screen([range.clone(), range]).max(0.0)
        }),
        law: "the pairs whose middle misses the wall: none from side 1 on",
    }
}
