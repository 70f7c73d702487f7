//! The checks of this lab.
//!
//! ```text
//! |Ω̂ − Ω| ≲ a few ε, with ε = 2.2e-16     for the formula with a·(b×c)
//! |Ω̂ − Ω| ≲ a few ε √Ω                    for the one with edges, and for the corners
//! ```
//! so that of 1e-8 sr the first keeps seven digits, and of 1e-12 sr the second keeps nine.
//! Both checks ask for six. Found from its cosine, Ω = 1e-8 has none.

use super::Work;
use super::bugs::*;
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{decades, direction, uniform, whole_number};
use crate::lab::{Check, check};
use crate::shapes::{Place, convex, l_shape, room};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::radiometry::solid_angle_triangle;
use radiosity::random::Stream;
use std::f64::consts::PI;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "small", "a small surface covers A cosθ/r², or nothing", 2, small),
    check(2, "known", "known triangles are right", 1, known),
    check(2, "any", "any triangle is right, from either side", 2, any),
    check(2, "tiny", "a triangle of 1e-8 sr keeps its digits", 2, |w, s| {
        tiny(w, s, 1e-8, FLAT_COSINE)
    }),
    check(2, "tinier", "a triangle of 1e-12 sr keeps its digits", 1, |w, s| {
        tiny(w, s, 1e-12, CANCELS)
    }),
    check(3, "rectangles", "known rectangles are right", 1, rectangles),
    check(3, "convex", "a convex polygon is right, from either side", 1, |w, s| {
        polygons(w, s, convex)
    }),
    check(3, "notched", "a polygon with a notch is right", 2, |w, s| {
        polygons(w, s, |stream| {
            let (u, v) = (uniform(stream, 0.2, 0.6), uniform(stream, 0.2, 0.6));
            l_shape([1.0, 1.0], [u, v])
        })
    }),
    check(4, "inside", "from inside a closed surface covers 4π", 1, |w, s| {
        closed(w, s, true)
    }),
    check(4, "outside", "from outside it sums to 0", 1, |w, s| closed(w, s, false)),
];

/// The tolerance where digits are not the question: whatever is found from a cosine is
/// right within √ε = 1.5e-8.
const WIDE: f64 = 1e-7;

/// How triangles may be measured.
type Triangle = fn(DVec3, DVec3, DVec3) -> f64;
/// How polygons may be, with triangles measured right.
type Polygon = fn(DVec3, &[DVec3]) -> f64;

/// The library's, which is the right one.
const RIGHT: Triangle = solid_angle_triangle;

/// −a·(b×c).
fn triple(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    -a.dot((b - a).cross(c - a))
}

/// The right formula, but for the lengths in the denominator.
fn by([a, b, c]: [DVec3; 3], lengths: fn(f64, f64, f64) -> [f64; 4]) -> f64 {
    let [all, ab, bc, ca] = lengths(a.length(), b.length(), c.length());
    let below = all + a.dot(b) * ab + b.dot(c) * bc + c.dot(a) * ca;
    2.0 * triple(a, b, c).atan2(below)
}

/// A cosθ/r² at the triangle's centre.
fn flat(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    0.5 * triple(a, b, c) / ((a + b + c) / 3.0).length().powi(3)
}

/// Wrong ways with triangles.
const WRONG_TRIANGLES: &[(Bug, Triangle)] = &[
    (HALVED, |a, b, c| 0.5 * RIGHT(a, b, c)),
    (ATAN, |a, b, c| 2.0 * (0.5 * RIGHT(a, b, c)).tan().atan()),
    (REVERSED, |a, b, c| -RIGHT(a, b, c)),
    (UNSIGNED, |a, b, c| RIGHT(a, b, c).abs()),
    (NOT_UNIT, |a, b, c| by([a, b, c], |_, _, _| [1.0; 4])),
    (LENGTHS, |a, b, c| by([a, b, c], |a, b, c| [a * b * c, a, b, c])),
    (LENGTHS, |a, b, c| by([a, b, c], |a, b, c| [a * b * c, b, c, a])),
    (LENGTHS, |a, b, c| by([a, b, c], |a, b, c| [a * b * c, 1.0, 1.0, 1.0])),
    (LENGTHS, |a, b, c| by([a, b, c], |a, b, c| [0.0, c, a, b])),
    (FLAT, flat),
    (FLAT, |a, b, c| flat(a, b, c).abs()),
    (NO_EXCESS, |a, b, c| RIGHT(a, b, c).abs() + PI),
    (NO_EXCESS, |a, b, c| RIGHT(a, b, c) + PI.copysign(RIGHT(a, b, c))),
];

/// The sum over a fan, each triangle seen from `point` and measured by `triangle`.
fn fan(point: DVec3, corners: &[DVec3], triangle: Triangle) -> f64 {
    let r = |k: usize| corners[k] - point;
    (1..corners.len() - 1).map(|k| triangle(r(0), r(k), r(k + 1))).sum()
}

/// Wrong ways with polygons.
const WRONG_POLYGONS: &[(Bug, Polygon)] = &[
    (UNSIGNED, |p, v| fan(p, v, RIGHT).abs()),
    (NOT_MOVED, |_, v| fan(DVec3::ZERO, v, RIGHT)),
    (FAN_SHORT, |p, v| fan(p, &v[..v.len() - 1], RIGHT)),
    (FAN_SHORT, |p, v| fan(p, v, RIGHT) - fan(p, &[v[0], v[1], v[2]], RIGHT)),
    (STRIP, |p, v| v.windows(3).map(|corners| fan(p, corners, RIGHT)).sum()),
];

/// What the numbers of `measured` would be for each wrong way with triangles.
fn by_wrong_triangles(measured: impl Fn(Triangle) -> Vec<f64>) -> Vec<Suspect> {
    WRONG_TRIANGLES.iter().map(|&(bug, wrong)| (bug, measured(wrong))).collect()
}

/// Small surfaces, as many from behind as from the front.
fn small(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let at = direction(stream) * uniform(stream, 0.5, 5.0);
        (at, direction(stream), uniform(stream, 0.01, 0.1))
    };
    let drawn: Vec<(DVec3, DVec3, f64)> = (0..40).map(|_| draw()).collect();
    // From the cosine, the distance and the area; `seen` tells fronts from backs.
    let all = |f: &dyn Fn(f64, f64, f64) -> f64| {
        let one = |&(at, n, area): &(DVec3, DVec3, f64)| {
            f(-n.dot(at.normalize()), at.length(), area)
        };
        drawn.iter().map(one).collect::<Vec<f64>>()
    };
    let seen = |cosine: f64| if cosine > 0.0 { 1.0 } else { 0.0 };
    let suspects = [
        (NO_COSINE, all(&|_, r, a| a / r / r)),
        (NO_COSINE, all(&|c, r, a| seen(c) * a / r / r)),
        (ONE_DISTANCE, all(&|c, r, a| c.max(0.0) * a / r)),
        (ONE_DISTANCE, all(&|c, r, a| c * a / r)),
        (OVER_PI, all(&|c, r, a| c.max(0.0) * a / (PI * r * r))),
        (FROM_BEHIND, all(&|c, r, a| c * a / r / r)),
        (FROM_BEHIND, all(&|c, r, a| c.abs() * a / r / r)),
        (WRONG_SIDE, all(&|c, r, a| (-c).max(0.0) * a / r / r)),
        (WRONG_SIDE, all(&|c, r, a| -c * a / r / r)),
    ];
    let got: Vec<f64> =
        drawn.iter().map(|&(at, n, a)| (work.small)(at, n, a)).collect();
    let place = |k: usize| {
        let (at, n, area) = drawn[k];
        let cosine = -n.dot(at.normalize());
        format!("r = {:.3}, cosθ = {cosine:.3}, A = {area:.3}", at.length())
    };
    let expected = all(&|c, r, a| c.max(0.0) * a / r / r);
    compare(&got, &expected, Within::Absolute(1e-12), &suspects, place)
}

/// Compares the student's triangles with these values.
fn triangles(
    work: &Work,
    drawn: &[([DVec3; 3], f64)],
    within: Within,
    place: impl Fn(usize) -> String,
) -> Verdict {
    let all = |f: Triangle| drawn.iter().map(|&([a, b, c], _)| f(a, b, c)).collect();
    let expected: Vec<f64> = drawn.iter().map(|&(_, exact)| exact).collect();
    let got: Vec<f64> = all(work.triangle);
    compare(&got, &expected, within, &by_wrong_triangles(all), place)
}

/// Triangles of the accuracy tables, about the origin: name, corners, sr.
const KNOWN: [(&str, [[f64; 3]; 3], f64); 3] = [
    (
        "I4-triangle-octant",
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        PI / 2.0,
    ),
    (
        "I4-triangle-flat",
        [[1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [-1.0, -1.0, 1.0]],
        PI / 3.0,
    ),
    (
        "I4-triangle-generic",
        [[0.3, 0.2, 1.0], [1.2, -0.4, 0.8], [0.1, 1.5, 2.0]],
        0.136_400_902_374_733_5,
    ),
];

/// The table's triangles, turned, enlarged, and so ordered that they count positive.
fn known(work: &Work, stream: &mut Stream) -> Verdict {
    let place = Place::about_origin(stream, 1.7);
    let drawn = KNOWN.map(|(_, corners, exact)| {
        let [a, b, c] = corners.map(|corner| place.of(DVec3::from(corner)));
        let positive = a.dot(b.cross(c)) < 0.0;
        (if positive { [a, b, c] } else { [a, c, b] }, exact)
    });
    let place = |k: usize| format!("{}, turned", KNOWN[k].0);
    triangles(work, &drawn, Within::Relative(1e-12), place)
}

/// Triangles of all sizes and either side.
fn any(work: &Work, stream: &mut Stream) -> Verdict {
    let mut corner = || direction(stream) * uniform(stream, 0.2, 5.0);
    let mut draw = || {
        let [a, b, c] = std::array::from_fn(|_| corner());
        ([a, b, c], RIGHT(a, b, c))
    };
    let drawn: Vec<_> = (0..40).map(|_| draw()).collect();
    let place = |k: usize| {
        let [a, b, c] = drawn[k].0;
        format!("triangle {a:.3} {b:.3} {c:.3}")
    };
    triangles(work, &drawn, Within::Absolute(WIDE), place)
}

/// Half of a square with a corner on its axis, from `least` sr upward:
///
/// ```text
/// Ω = ½ atan(s²/√(1 + 2s²))         s the edge, seen from a distance of 1
/// ```
/// `lost` is the mistake when nothing is wrong but the digits.
fn tiny(work: &Work, stream: &mut Stream, least: f64, lost: Bug) -> Verdict {
    let mut draw = |_| {
        let s = decades(stream, (2.0 * least).sqrt(), (200.0 * least).sqrt());
        let exact = 0.5 * (s * s).atan2((1.0 + 2.0 * s * s).sqrt());
        let corners = [dvec3(0.0, 0.0, 1.0), dvec3(s, s, 1.0), dvec3(s, 0.0, 1.0)];
        let scale = uniform(stream, 0.3, 3.0);
        let place = Place::about_origin(stream, scale);
        (corners.map(|corner| place.of(corner)), exact)
    };
    let drawn: Vec<_> = (0..20).map(&mut draw).collect();
    let place = |k: usize| format!("a triangle of {:.2e} sr", drawn[k].1);
    let verdict = triangles(work, &drawn, Within::Relative(1e-6), place);
    if verdict.passed() || verdict.bug.is_some() {
        return verdict;
    }
    // Right where there are digits to spare? Then those are what is wrong.
    let before = match lost {
        CANCELS => tiny(work, stream, 1e-8, FLAT_COSINE),
        _ => any(work, stream),
    };
    let bug = if before.passed() { Some(lost) } else { before.bug };
    Verdict { bug, ..verdict }
}

/// Compares the student's polygons with the sum over a fan.
fn outlines(
    work: &Work,
    drawn: &[(DVec3, Vec<DVec3>)],
    expected: &[f64],
    place: impl Fn(usize) -> String,
) -> Verdict {
    let all = |f: &dyn Fn(DVec3, &[DVec3]) -> f64| {
        drawn.iter().map(|(p, v)| f(*p, v)).collect::<Vec<f64>>()
    };
    let mut suspects = by_wrong_triangles(|wrong| all(&|p, v| fan(p, v, wrong)));
    suspects.extend(WRONG_POLYGONS.iter().map(|&(bug, wrong)| (bug, all(&wrong))));
    let within = Within::Absolute(WIDE);
    compare(&all(&work.polygon), expected, within, &suspects, place)
}

/// Rectangles of the accuracy tables, on the axis: name, edge, distance, sr.
const RECTANGLES: [(&str, f64, f64, f64); 3] = [
    ("I6-rect-1x1-d1", 1.0, 1.0, 0.805_431_683_161_323_2),
    ("I6-rect-1000x1000-d1", 1000.0, 1.0, 6.271_871_617_536_734),
    ("I6-rect-1x1-d1000", 1.0, 1000.0, 9.999_997_500_000_73e-7),
];

fn rectangles(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn = RECTANGLES.map(|(_, edge, distance, _)| {
        let (place, h) = (Place::draw(stream), 0.5 * edge);
        let corners = [(-h, -h), (-h, h), (h, h), (h, -h)];
        let corners = corners.map(|(x, y)| dvec3(x, y, distance));
        (place.of(DVec3::ZERO), place.all(&corners))
    });
    let place = |k: usize| format!("{}, turned", RECTANGLES[k].0);
    outlines(work, &drawn, &RECTANGLES.map(|case| case.3), place)
}

/// Polygons of some kind, seen from anywhere, from either side.
fn polygons(
    work: &Work,
    stream: &mut Stream,
    shape: impl Fn(&mut Stream) -> Vec<DVec3>,
) -> Verdict {
    let mut draw = |_| {
        let outline = shape(stream);
        let eye = direction(stream) * uniform(stream, 0.5, 2.0);
        let place = Place::draw(stream);
        (place.of(eye), place.all(&outline))
    };
    let drawn: Vec<_> = (0..20).map(&mut draw).collect();
    let expected: Vec<f64> = drawn.iter().map(|(p, v)| fan(*p, v, RIGHT)).collect();
    let place = |k: usize| {
        let (p, v) = &drawn[k];
        let corners: Vec<String> = v.iter().map(|c| format!("{c:.3}")).collect();
        format!("from {p:.3}, corners {}", corners.join(" "))
    };
    outlines(work, &drawn, &expected, place)
}

/// Rooms of two shapes, fronts once inward and once outward.
fn closed(work: &Work, stream: &mut Stream, inside: bool) -> Verdict {
    let mut drawn = Vec::new();
    for k in 0..8 {
        let n = whole_number(stream, 3, 7);
        let corner = |k: usize| {
            let turn = k as f64 / n as f64 * 2.0 * PI;
            dvec3(turn.cos(), turn.sin(), 0.0)
        };
        let prism = room(&(0..n).map(corner).collect::<Vec<_>>(), 1.0);
        let notched = room(&l_shape([1.0, 1.0], [0.4, 0.5]), 1.0);
        let faces = if k % 2 == 0 { prism } else { notched };
        let mut eye = dvec3(
            uniform(stream, 0.02, 0.35),
            uniform(stream, 0.02, 0.35),
            uniform(stream, 0.02, 0.98),
        );
        if !inside {
            eye.z += if stream.next() < 0.5 { 1.0 } else { -1.0 };
        }
        let place = Place::draw(stream);
        let mut faces: Vec<Vec<DVec3>> = faces.iter().map(|f| place.all(f)).collect();
        let outward = k % 4 > 1;
        if outward {
            faces.iter_mut().for_each(|face| face.reverse());
        }
        drawn.push((place.of(eye), faces, if outward { -1.0 } else { 1.0 }));
    }
    let all = |f: &dyn Fn(DVec3, &[Vec<DVec3>]) -> f64| {
        drawn.iter().map(|(p, faces, _)| f(*p, faces)).collect::<Vec<f64>>()
    };
    let sum = |each: fn(f64) -> f64| {
        all(&|p, faces| faces.iter().map(|v| each(fan(p, v, RIGHT))).sum())
    };
    let with =
        |polygon: Polygon| all(&|p, faces| faces.iter().map(|v| polygon(p, v)).sum());
    let mut suspects = by_wrong_triangles(|wrong| {
        all(&|p, faces| faces.iter().map(|v| fan(p, v, wrong)).sum())
    });
    suspects.extend(WRONG_POLYGONS.iter().map(|&(bug, wrong)| (bug, with(wrong))));
    suspects.extend([
        (
            UNSIGNED,
            all(&|p, faces| faces.iter().map(|v| fan(p, v, RIGHT)).sum::<f64>().abs()),
        ),
        (FRONTS_ONLY, sum(|face| face.max(0.0))),
        (SHARE, sum(|face| face / (4.0 * PI))),
    ]);
    let share = if inside { 4.0 * PI } else { 0.0 };
    let expected: Vec<f64> = drawn.iter().map(|room| share * room.2).collect();
    let place = |k: usize| {
        let way = if drawn[k].2 > 0.0 { "inward" } else { "outward" };
        format!("{} faces, fronts {way}", drawn[k].1.len())
    };
    compare(&all(&work.surface), &expected, Within::Absolute(WIDE), &suspects, place)
}
