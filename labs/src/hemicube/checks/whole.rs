//! Task 6: the student's functions together, against exact form factors.
//!
//! ```text
//! |F̂ − F| ≤ L e / (2π) + e² F      L the outline's length on the hemicube, e the edge
//! ```
//! A cell counts wholly or not at all: at most half a cell's width along the outline is
//! given to the wrong element, and no place of the hemicube weighs more than 1/π per
//! area (the middle of the top). The second term is that of the weights.

use super::sized;
use crate::check::{Verdict, Within, compare};
use crate::draw::uniform;
use crate::hemicube::Work;
use crate::hemicube::bugs::NORMALISED_AWAY;
use crate::hemicube::given::{StudentHemicube, Weights};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::mesh::ElementId;
use radiosity::prelude::{DVec3, Polygon, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// The form factor from the centre of a unit square to the opposite one, 1 away.
const KNOWN: f64 = 0.239_456_470_460_774;

/// What element 0 sees, by a hemicube of `n` cells along an edge.
fn seen(
    work: &Work,
    elements: &[Polygon],
    n: usize,
) -> Result<(Vec<f64>, Lost), Verdict> {
    let hemicube = StudentHemicube::new(work, elements, n);
    sized(hemicube.weights(), n)?;
    let mut row = vec![0.0; elements.len()];
    let lost = hemicube.row(ElementId(0), &mut row);
    Ok((row, lost))
}

/// A rectangle about `centre` with half-edges `a` and `b`; its front is along `a × b`.
fn rectangle(centre: DVec3, a: DVec3, b: DVec3) -> Polygon {
    let corners = [centre - a - b, centre + a - b, centre + a + b, centre - a + b];
    // Half-edges at right angles always span a polygon.
    Polygon::new(corners.to_vec()).expect("a rectangle")
}

fn floor(size: f64) -> Polygon {
    rectangle(DVec3::ZERO, DVec3::X * size, DVec3::Y * size)
}

/// The six walls of the box `±half`, fronts inward, floor first and ceiling last.
fn room(half: DVec3) -> Vec<Polygon> {
    let (x, y, z) = (DVec3::X * half.x, DVec3::Y * half.y, DVec3::Z * half.z);
    vec![
        rectangle(-z, x, y),
        rectangle(-x, y, z),
        rectangle(x, z, y),
        rectangle(-y, z, x),
        rectangle(y, x, z),
        rectangle(z, y, x),
    ]
}

/// The bound of the module's header for an outline of length `outline`.
fn bound(n: usize, outline: f64) -> f64 {
    let edge = 2.0 / n as f64;
    outline * edge / (2.0 * PI) + edge * edge
}

/// A unit square, 1 above the middle of a small one. Its outline runs along the borders
/// of cells, so that the weights alone decide: 1 % is what a hemicube of 256 promises.
pub fn known(work: &Work, _: &mut Stream) -> Verdict {
    let lid = rectangle(DVec3::Z, DVec3::Y * 0.5, DVec3::X * 0.5);
    let row = match seen(work, &[floor(0.01), lid], 256) {
        Ok((row, _)) => row,
        Err(wrong) => return wrong,
    };
    let place = |_| "the form factor of the unit square 1 above".to_string();
    let verdict = compare(&row[1..], &[KNOWN], Within::Relative(0.01), &[], place);
    let Some(message) = &verdict.message else { return verdict };
    let sum = match seen(work, &room(DVec3::ONE), 64) {
        Ok((row, _)) => row.iter().sum::<f64>(),
        Err(wrong) => return wrong,
    };
    let percent = 100.0 * (row[1] / KNOWN - 1.0);
    let way = if percent < 0.0 { "low" } else { "high" };
    let message = format!(
        "{message}: {:.0} % {way}; the row of a closed room sums to {sum:.3}",
        percent.abs()
    );
    // Right sums, and the weights alone give this factor: nothing else is to blame.
    let Weights { top, .. } = (work.weights)(256);
    let middle = (0..top.len()).filter(|k| {
        let inside = |k: usize| (64..192).contains(&k);
        inside(k % 256) && inside(k / 256)
    });
    let weighed: f64 = middle.map(|k| top[k]).sum();
    let to_blame =
        (weighed - row[1]).abs() < 1e-9 && (sum - 1.0).abs() < bound(64, 0.0);
    Verdict {
        message: Some(message),
        bug: to_blame.then_some(NORMALISED_AWAY),
        ..verdict
    }
}

/// A turned rectangle somewhere above, within the top face's view.
pub fn elsewhere(work: &Work, stream: &mut Stream) -> Verdict {
    const N: usize = 128;
    let height = uniform(stream, 0.5, 3.0);
    let turn = uniform(stream, 0.0, PI);
    let (a, b) = (uniform(stream, 0.2, 0.4), uniform(stream, 0.2, 0.4));
    let along = dvec3(turn.cos(), turn.sin(), 0.0) * height;
    let centre = dvec3(uniform(stream, -0.3, 0.3), uniform(stream, -0.3, 0.3), 1.0);
    let lid = rectangle(centre * height, along * b, along.cross(DVec3::Z) * a);
    let expected = lambert_polygon(DVec3::ZERO, DVec3::Z, &lid);
    let (row, _) = match seen(work, &[floor(0.01), lid], N) {
        Ok(seen) => seen,
        Err(wrong) => return wrong,
    };
    let place = |_| format!("a rectangle at height {height:.3}");
    let within = Within::Absolute(bound(N, 4.0 * (a + b)));
    compare(&row[1..], &[expected], within, &[], place)
}

/// A box of random shape: from its floor the other walls are all there is.
pub fn closed(work: &Work, stream: &mut Stream) -> Verdict {
    const N: usize = 64;
    let mut half = || uniform(stream, 0.4, 1.5);
    let walls = room(dvec3(half(), half(), half()));
    let eye = walls[0].centroid();
    let exact = |wall: &Polygon| lambert_polygon(eye, DVec3::Z, wall);
    let mut expected: Vec<f64> = walls.iter().map(exact).collect();
    expected[0] = 0.0;
    let (row, lost) = match seen(work, &walls, N) {
        Ok(seen) => seen,
        Err(wrong) => return wrong,
    };
    let sum = row.iter().sum::<f64>() + lost.escaped + lost.absorbed;
    let within = Within::Absolute(bound(N, 0.0));
    let what = |_| "the sum of the row and of what is lost".to_string();
    let place = |j: usize| format!("from the floor, wall {j}");
    // A wall's outline is at most four straight lines across two faces each.
    let each = Within::Absolute(bound(N, 8.0));
    compare(&[sum], &[1.0], within, &[], what)
        .and(|| compare(&row, &expected, each, &[], place))
        .and(|| {
            compare(&[lost.escaped, lost.absorbed], &[0.0, 0.0], within, &[], |k| {
                format!("{} from a closed room", ["escaped", "absorbed"][k])
            })
        })
}

/// A card between the floor and a lid, once facing the floor, once with its back to it.
pub fn hidden(work: &Work, stream: &mut Stream) -> Verdict {
    const N: usize = 128;
    let lid = rectangle(DVec3::Z, DVec3::Y * 0.8, DVec3::X * 0.8);
    let height = uniform(stream, 0.3, 0.8);
    let (a, b) = (uniform(stream, 0.2, 0.5), uniform(stream, 0.2, 0.5));
    let centre = DVec3::Z * height;
    let down = rectangle(centre, DVec3::Y * (a * height), DVec3::X * (b * height));
    let card = lambert_polygon(DVec3::ZERO, DVec3::Z, &down);
    let rest = lambert_polygon(DVec3::ZERO, DVec3::Z, &lid) - card;
    let judge = |card_is: Polygon, expected: [f64; 3], what: &'static str| {
        // The card stands last: a buffer that keeps the first would see the lid.
        let (row, lost) = match seen(work, &[floor(0.01), lid.clone(), card_is], N) {
            Ok(seen) => seen,
            Err(wrong) => return wrong,
        };
        let within = Within::Absolute(bound(N, 4.0 * (a + b) + 6.4));
        compare(&[row[1], row[2], lost.absorbed], &expected, within, &[], |k| {
            format!("the card's {what} below: {}", ["lid", "card", "absorbed"][k])
        })
    };
    judge(down.clone(), [rest, card, 0.0], "front")
        .and(|| judge(down.flipped(), [rest, 0.0, card], "back"))
}

/// A box without lid: what the lid would get, escapes.
pub fn open(work: &Work, stream: &mut Stream) -> Verdict {
    const N: usize = 64;
    let mut half = || uniform(stream, 0.4, 1.5);
    let mut walls = room(dvec3(half(), half(), half()));
    let eye = walls[0].centroid();
    let lid = walls.pop().map_or(0.0, |lid| lambert_polygon(eye, DVec3::Z, &lid));
    let (row, lost) = match seen(work, &walls, N) {
        Ok(seen) => seen,
        Err(wrong) => return wrong,
    };
    let within = Within::Absolute(bound(N, 8.0));
    let place = |k: usize| ["escaped", "the sum of the row"][k].to_string();
    let got = [lost.escaped, row.iter().sum::<f64>()];
    compare(&got, &[lid, 1.0 - lid], within, &[], place)
}
