//! The checks of this lab. Everything is a sum of a few numbers: what is asked is 1e-9.

use super::Work;
use super::answer;
use super::bugs::*;
use super::given::{Anchor, Room, Sample};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use crate::lab::{Check, check};
use radiosity::random::Stream;
use std::cell::RefCell;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "rows", "an element looks at all patches but its own", 2, rows),
    check(1, "cost", "each pair is asked for once: n (m − 1) factors", 1, cost),
    check(2, "means", "a patch is the mean of its elements by area", 3, means),
    check(3, "gather", "an element reflects what it gets from the patches", 2, gather),
    check(3, "agree", "the mean of the elements is the patch", 1, agree),
    check(4, "marks", "large shares of the error are split", 2, marks),
    check(4, "minimum", "what is small enough stays", 1, minimum),
    check(5, "anchor", "a T-vertex lies on its edge", 1, anchors),
    check(5, "chain", "also when the edge ends in a T-vertex", 1, chain),
];

const EXACT: Within = Within::Absolute(1e-9);

fn flat(rows: &[Vec<f64>]) -> Vec<f64> {
    rows.concat()
}

/// A few elements in patches, and what `factor` answers for each pair.
fn pairs(stream: &mut Stream) -> (Vec<usize>, usize, Vec<Vec<f64>>) {
    let m = whole_number(stream, 3, 6);
    let of = |stream: &mut Stream, p: usize| vec![p; whole_number(stream, 1, 4)];
    let patch_of: Vec<usize> = (0..m).flat_map(|p| of(stream, p)).collect();
    let row = |_| (0..m).map(|_| uniform(stream, 0.05, 0.3)).collect();
    let table: Vec<Vec<f64>> = (0..patch_of.len()).map(row).collect();
    (patch_of, m, table)
}

/// The student's rows, and the pairs that were asked for.
fn asked(
    work: &Work,
    (patch_of, m, table): &(Vec<usize>, usize, Vec<Vec<f64>>),
) -> (Vec<Vec<f64>>, Vec<[usize; 2]>) {
    let log = RefCell::new(Vec::new());
    let factor = |e: usize, q: usize| {
        log.borrow_mut().push([e, q]);
        // Indices exchanged or out of range are told by the check.
        table.get(e).and_then(|row| row.get(q)).copied().unwrap_or(f64::NAN)
    };
    let rows = (work.rows)(patch_of, *m, &factor);
    (rows, log.into_inner())
}

fn rows(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn = pairs(stream);
    let (patch_of, m, table) = &drawn;
    let (got, _) = asked(work, &drawn);
    let n = patch_of.len();
    if got.len() != n || got.iter().any(|row| row.len() != *m) {
        let turned = got.len() == *m && got.iter().all(|row| row.len() == n);
        let wide = format!(
            "{} rows, the first of {}",
            got.len(),
            got.first().map_or(0, Vec::len)
        );
        let bug = turned.then_some(TRANSPOSED);
        return Verdict::fail(format!("got {wide}; expected {n} rows of {m}"), bug);
    }
    let expected = answer::rows(patch_of, *m, &|e, q| table[e][q]);
    let suspects = [(OWN_PATCH, flat(table))];
    let place = |k: usize| {
        let (e, q) = (k / m, k % m);
        format!("element {e}, of patch {}, to patch {q}", patch_of[e])
    };
    compare(&flat(&got), &flat(&expected), EXACT, &suspects, place)
}

fn cost(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn = pairs(stream);
    let (patch_of, m, _) = &drawn;
    let (_, log) = asked(work, &drawn);
    let least = patch_of.len() * (m - 1);
    if let Some([e, q]) = log.iter().find(|[e, q]| patch_of.get(*e) == Some(q)) {
        let message = format!("factor({e}, {q}) was asked for: its own patch");
        return Verdict::fail(message, Some(OWN_PATCH));
    }
    let mut pairs = log.clone();
    pairs.sort_unstable();
    pairs.dedup();
    let message = format!("{} factors asked for, {least} are due", log.len());
    match (log.len(), pairs.len()) {
        (asked, different) if asked == least && different == least => {
            Verdict::pass(0.0, 0.0)
        }
        (asked, _) if asked > least => Verdict::fail(message, Some(ALL_PAIRS)),
        _ => Verdict::fail(message, None),
    }
}

/// The elements of a patch.
fn of(room: &Room, p: usize) -> impl Iterator<Item = usize> + '_ {
    (0..room.area.len()).filter(move |&e| room.patch_of[e] == p)
}

/// `Σ weight(e) F_eq / below(p, q)` for all pairs of patches.
fn sums(
    room: &Room,
    weight: impl Fn(usize) -> f64,
    below: impl Fn(usize, usize) -> f64,
) -> Vec<f64> {
    let m = room.patches();
    let pair = |k: usize| {
        let (p, q) = (k / m, k % m);
        of(room, p).map(|e| weight(e) * room.rows[e][q]).sum::<f64>() / below(p, q)
    };
    (0..m * m).map(pair).collect()
}

fn means(work: &Work, stream: &mut Stream) -> Verdict {
    let room = Room::draw(stream);
    let m = room.patches();
    let got = (work.patch_factors)(&room);
    if got.len() != m || got.iter().any(|row| row.len() != m) {
        return Verdict::fail(format!("expected {m} rows of {m}"), None);
    }
    let area = |p: usize| of(&room, p).map(|e| room.area[e]).sum::<f64>();
    let by_area = |e: usize| room.area[e];
    let expected = sums(&room, by_area, |p, _| area(p));
    let turned = (0..m * m).map(|k| expected[k % m * m + k / m]).collect();
    let suspects: Vec<Suspect> = vec![
        (NO_AREAS, sums(&room, |_| 1.0, |p, _| of(&room, p).count() as f64)),
        (NOT_DIVIDED, sums(&room, by_area, |_, _| 1.0)),
        (WRONG_AREA, sums(&room, by_area, |_, q| area(q))),
        (SUMMED, sums(&room, |_| 1.0, |_, _| 1.0)),
        (TRANSPOSED, turned),
    ];
    let place = |k: usize| format!("from patch {} to patch {}", k / m, k % m);
    compare(&flat(&got), &expected, EXACT, &suspects, place)
}

/// Patches that shine, each by itself.
fn shining(room: &Room, stream: &mut Stream) -> Vec<f64> {
    room.emission.iter().map(|e| e + uniform(stream, 0.1, 1.0)).collect()
}

/// What an element is, from its patch, what arrives at it, and that as the sender's
/// reflectance makes it.
fn elements(
    room: &Room,
    patches: &[f64],
    of: impl Fn(usize, f64, f64) -> f64,
) -> Vec<f64> {
    let element = |e: usize| {
        let seen = || room.rows[e].iter().zip(patches).map(|(f, b)| f * b);
        let dimmed = seen().zip(&room.reflectance).map(|(h, rho)| h * rho).sum();
        of(room.patch_of[e], seen().sum(), dimmed)
    };
    (0..room.area.len()).map(element).collect()
}

fn gather(work: &Work, stream: &mut Stream) -> Verdict {
    let room = Room::draw(stream);
    let patches = shining(&room, stream);
    let (emission, rho) = (&room.emission, &room.reflectance);
    let got = (work.gather)(&room, &patches);
    let expected = elements(&room, &patches, |p, h, _| emission[p] + rho[p] * h);
    let alike = |got: &Vec<f64>| {
        got.len() == expected.len()
            && (0..room.patches()).all(|p| {
                let first = of(&room, p).next().map_or(0.0, |e| got[e]);
                of(&room, p).all(|e| (got[e] - first).abs() < 1e-12)
            })
    };
    let suspects = [
        (
            EMITTED_TWICE,
            elements(&room, &patches, |p, h, _| 2.0 * emission[p] + rho[p] * h),
        ),
        (NO_EMISSION, elements(&room, &patches, |p, h, _| rho[p] * h)),
        (SENDERS_RHO, elements(&room, &patches, |p, _, dimmed| emission[p] + dimmed)),
        (NO_RHO, elements(&room, &patches, |p, h, _| emission[p] + h)),
    ];
    let place = |e: usize| format!("element {e}, of patch {}", room.patch_of[e]);
    let verdict = compare(&got, &expected, EXACT, &suspects, place);
    match verdict.passed() || verdict.bug.is_some() || !alike(&got) {
        true => verdict,
        false => Verdict { bug: Some(ALL_ALIKE), ..verdict },
    }
}

/// The patches solved with the right factors, the student's elements, and their means.
fn agree(work: &Work, stream: &mut Stream) -> Verdict {
    let room = Room::draw(stream);
    let factors = answer::patch_factors(&room);
    let mut patches = room.emission.clone();
    for _ in 0..300 {
        for p in 0..patches.len() {
            let seen: f64 = factors[p].iter().zip(&patches).map(|(f, b)| f * b).sum();
            patches[p] = room.emission[p] + room.reflectance[p] * seen;
        }
    }
    let elements = (work.gather)(&room, &patches);
    if elements.len() != room.area.len() {
        return Verdict::fail("one radiosity for each element is due", None);
    }
    let mean = |p: usize| {
        let power: f64 = of(&room, p).map(|e| room.area[e] * elements[e]).sum();
        power / of(&room, p).map(|e| room.area[e]).sum::<f64>()
    };
    let got: Vec<f64> = (0..patches.len()).map(mean).collect();
    compare(&got, &patches, EXACT, &[], |p| format!("the mean over patch {p}"))
}

/// Elements about the border: area, rise, share; none in doubt.
fn samples(stream: &mut Stream) -> (Vec<Sample>, f64) {
    let share = uniform(stream, 0.002, 0.01);
    let mut sample = |_| {
        let area = uniform(stream, 0.02, 2.0);
        // A Δ²/12 of a twentieth to twenty shares, not just about one.
        let factor = uniform(stream, 1.1, 20.0);
        let of_share = if stream.next() < 0.5 { factor } else { 1.0 / factor };
        let rise = (12.0 * share * of_share / area).sqrt();
        let low = uniform(stream, 0.0, 3.0);
        let inner: Vec<f64> =
            (0..3).map(|_| low + rise * uniform(stream, 0.3, 0.7)).collect();
        let mut radiosity = vec![inner[0], low, inner[1], low + rise, inner[2]];
        radiosity.rotate_left(whole_number(stream, 0, 5));
        Sample { area, radiosity }
    };
    let drawn = (0..200).map(&mut sample).collect();
    (drawn, share)
}

fn rise(e: &Sample) -> f64 {
    let most = e.radiosity.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - e.radiosity.iter().copied().fold(f64::INFINITY, f64::min)
}

/// What is wrong, and what is marked then.
type Marks<'a> = (Bug, &'a dyn Fn(&Sample) -> bool);

/// Compares marks, as 1 and 0.
fn marked(
    work: &Work,
    (drawn, share, smallest): (&[Sample], f64, f64),
    suspects: &[Marks],
) -> Verdict {
    let number = |mark: bool| if mark { 1.0 } else { 0.0 };
    let got = (work.marks)(drawn, share, smallest).into_iter().map(number);
    let expected = answer::marks(drawn, share, smallest).into_iter().map(number);
    let suspects: Vec<Suspect> = suspects
        .iter()
        .map(|(bug, marks)| (*bug, drawn.iter().map(|e| number(marks(e))).collect()))
        .collect();
    let place = |k: usize| {
        let e = &drawn[k];
        format!(
            "A = {:.4}, Δ = {:.4}, share {share:.4}, smallest {smallest:.4}: 1 is split",
            e.area,
            rise(e)
        )
    };
    let (got, expected): (Vec<f64>, Vec<f64>) = (got.collect(), expected.collect());
    compare(&got, &expected, EXACT, &suspects, place)
}

fn marks(work: &Work, stream: &mut Stream) -> Verdict {
    let (drawn, share) = samples(stream);
    let ends = |e: &Sample| (e.radiosity[0] - e.radiosity[e.radiosity.len() - 1]).abs();
    let neighbours = |e: &Sample| (e.radiosity[0] - e.radiosity[1]).abs();
    let squared = |area: f64, rise: f64| area * rise * rise / 12.0 > share;
    marked(
        work,
        (&drawn, share, 1e-6),
        &[
            (NO_AREA, &|e| squared(1.0, rise(e))),
            (NOT_SQUARED, &|e| e.area * rise(e) / 12.0 > share),
            (NO_TWELFTH, &|e| squared(12.0 * e.area, rise(e))),
            (TWO_PLACES, &|e| squared(e.area, ends(e))),
            (TWO_PLACES, &|e| squared(e.area, neighbours(e))),
            (REVERSED, &|e| !squared(e.area, rise(e))),
        ],
    )
}

/// A shadow's edge: everything rises too much, and some are small enough.
fn minimum(work: &Work, stream: &mut Stream) -> Verdict {
    let smallest = uniform(stream, 0.01, 0.1);
    let mut sample = |k: usize| {
        let area = smallest * if k.is_multiple_of(2) { 0.25 } else { 4.0 };
        let dark = uniform(stream, 0.0, 0.1);
        Sample { area, radiosity: vec![dark, dark + 10.0, dark, dark + 10.0, dark] }
    };
    let drawn: Vec<Sample> = (0..20).map(&mut sample).collect();
    marked(
        work,
        (&drawn, 1e-6, smallest),
        &[(NO_MINIMUM, &|_| true), (REVERSED, &|e| e.area <= smallest)],
    )
}

/// The value of a T-vertex, from the values so far and as they were.
type Value<'a> = &'a dyn Fn(&[f64], &[f64], Anchor) -> f64;

/// Compares what is left of values after the student's anchoring.
fn anchored(work: &Work, values: &[f64], anchors: &[Anchor]) -> Verdict {
    let by = |each: Value| {
        let mut new = values.to_vec();
        for &anchor in anchors {
            new[anchor.vertex] = each(&new, values, anchor);
        }
        new
    };
    let edge = |v: &[f64], Anchor { ends: [a, b], at, .. }: Anchor| {
        (1.0 - at) * v[a] + at * v[b]
    };
    let suspects = [
        (NOT_ANCHORED, values.to_vec()),
        (BACKWARDS, by(&|new, _, a| edge(new, Anchor { at: 1.0 - a.at, ..a }))),
        (ALWAYS_HALF, by(&|new, _, a| edge(new, Anchor { at: 0.5, ..a }))),
        (HALF_ANCHORED, by(&|new, _, a| 0.5 * (new[a.vertex] + edge(new, a)))),
        (OLD_ENDS, by(&|_, old, a| edge(old, a))),
    ];
    let mut got = values.to_vec();
    (work.anchor)(&mut got, anchors);
    compare(&got, &by(&|new, _, a| edge(new, a)), EXACT, &suspects, |k| {
        match anchors.iter().find(|a| a.vertex == k) {
            Some(Anchor { ends: [a, b], at, .. }) => {
                format!("vertex {k}, at {at:.3} from vertex {a} to vertex {b}")
            }
            None => format!("vertex {k}, which is no T-vertex"),
        }
    })
}

fn anchors(work: &Work, stream: &mut Stream) -> Verdict {
    let values: Vec<f64> = (0..12).map(|_| uniform(stream, 0.0, 5.0)).collect();
    let anchor = |k: usize| {
        let ends = [k, whole_number(stream, 4, 8)];
        Anchor { vertex: 8 + k, ends, at: uniform(stream, 0.1, 0.4) }
    };
    let anchors: Vec<Anchor> = (0..4).map(anchor).collect();
    anchored(work, &values, &anchors)
}

/// Vertex 2 lies between 0 and 1, 3 between 1 and 2, 4 between 2 and 3, and so on.
fn chain(work: &Work, stream: &mut Stream) -> Verdict {
    let values: Vec<f64> = (0..7).map(|_| uniform(stream, 0.0, 5.0)).collect();
    let anchor = |vertex: usize| {
        let at = uniform(stream, 0.1, 0.4);
        Anchor { vertex, ends: [vertex - 2, vertex - 1], at }
    };
    let anchors: Vec<Anchor> = (2..7).map(anchor).collect();
    anchored(work, &values, &anchors)
}
