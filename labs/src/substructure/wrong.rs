//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, anchor, gather, marks, patch_factors, rows};
use super::bugs::*;
use super::given::{Room, Sample};
use crate::lab::{Wrong, plays};

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays(
        "own-patch",
        "all patches are alike",
        &[OWN_PATCH],
        Work {
            rows: |patch_of, patches, factor| {
                let row = |e| (0..patches).map(|q| factor(e, q)).collect();
                (0..patch_of.len()).map(row).collect()
            },
            ..WORK
        },
    ),
    plays(
        "asks-then-zeroes",
        "set the own factor to 0 afterwards",
        &[OWN_PATCH],
        Work {
            rows: |patch_of, patches, factor| {
                let all = rows(&vec![patches; patch_of.len()], patches, factor);
                rows(patch_of, patches, &|e, q| all[e][q])
            },
            ..WORK
        },
    ),
    plays(
        "asks-again",
        "ask once to see whether it is zero",
        &[ALL_PAIRS],
        Work {
            rows: |patch_of, patches, factor| {
                rows(patch_of, patches, &|e, q| match factor(e, q) > 0.0 {
                    true => factor(e, q),
                    false => 0.0,
                })
            },
            ..WORK
        },
    ),
    plays(
        "patches-look",
        "a row for each patch",
        &[TRANSPOSED],
        Work {
            rows: |patch_of, patches, factor| {
                let by_element = rows(patch_of, patches, factor);
                let column = |q: usize| by_element.iter().map(|row| row[q]).collect();
                (0..patches).map(column).collect()
            },
            ..WORK
        },
    ),
    plays(
        "without-areas",
        "the mean is the sum over the number",
        &[NO_AREAS],
        Work {
            patch_factors: |room| {
                let even = Room { area: vec![1.0; room.area.len()], ..room.clone() };
                patch_factors(&even)
            },
            ..WORK
        },
    ),
    plays(
        "not-divided",
        "weigh with the areas",
        &[NOT_DIVIDED],
        Work {
            patch_factors: |room| {
                let mut factors = vec![vec![0.0; room.patches()]; room.patches()];
                for ((row, area), &p) in
                    room.rows.iter().zip(&room.area).zip(&room.patch_of)
                {
                    factors[p].iter_mut().zip(row).for_each(|(f, x)| *f += area * x);
                }
                factors
            },
            ..WORK
        },
    ),
    plays(
        "wrong-area",
        "divide by A_q",
        &[WRONG_AREA],
        Work {
            patch_factors: |room| {
                let mut areas = vec![0.0; room.patches()];
                room.patch_of.iter().zip(&room.area).for_each(|(&p, a)| areas[p] += a);
                let mut factors = patch_factors(room);
                for (row, area) in factors.iter_mut().zip(&areas) {
                    row.iter_mut().zip(&areas).for_each(|(f, to)| *f *= area / to);
                }
                factors
            },
            ..WORK
        },
    ),
    plays(
        "summed",
        "the whole sends what its parts send",
        &[SUMMED],
        Work {
            patch_factors: |room| {
                let mut factors = vec![vec![0.0; room.patches()]; room.patches()];
                for (row, &p) in room.rows.iter().zip(&room.patch_of) {
                    factors[p].iter_mut().zip(row).for_each(|(f, x)| *f += x);
                }
                factors
            },
            ..WORK
        },
    ),
    plays(
        "emitted-twice",
        "B starts as E, and E is added",
        &[EMITTED_TWICE],
        Work {
            gather: |room, patches| {
                let mut all = gather(room, patches);
                all.iter_mut()
                    .zip(&room.patch_of)
                    .for_each(|(b, &p)| *b += room.emission[p]);
                all
            },
            ..WORK
        },
    ),
    plays(
        "no-emission",
        "the elements only reflect",
        &[NO_EMISSION],
        Work {
            gather: |room, patches| {
                gather(
                    &Room { emission: vec![0.0; room.patches()], ..room.clone() },
                    patches,
                )
            },
            ..WORK
        },
    ),
    plays(
        "senders-rho",
        "ρ belongs to F and B",
        &[SENDERS_RHO],
        Work {
            gather: |room, patches| {
                let dimmed: Vec<f64> = patches
                    .iter()
                    .zip(&room.reflectance)
                    .map(|(b, rho)| b * rho)
                    .collect();
                gather(
                    &Room { reflectance: vec![1.0; patches.len()], ..room.clone() },
                    &dimmed,
                )
            },
            ..WORK
        },
    ),
    plays(
        "no-rho",
        "B = E + H",
        &[NO_RHO],
        Work {
            gather: |room, patches| {
                gather(
                    &Room { reflectance: vec![1.0; patches.len()], ..room.clone() },
                    patches,
                )
            },
            ..WORK
        },
    ),
    plays(
        "all-alike",
        "the patch's factors for all its elements",
        &[ALL_ALIKE],
        Work {
            gather: |room, patches| {
                let factors = patch_factors(room);
                let rows = room.patch_of.iter().map(|&p| factors[p].clone()).collect();
                gather(&Room { rows, ..room.clone() }, patches)
            },
            ..WORK
        },
    ),
    plays(
        "no-minimum",
        "as fine as the light asks for",
        &[NO_MINIMUM],
        Work { marks: |elements, share, _| marks(elements, share, 0.0), ..WORK },
    ),
    plays(
        "no-area",
        "split where Δ is large",
        &[NO_AREA],
        Work {
            marks: |elements, share, smallest| {
                let of_one = |e: &Sample| Sample { area: 1.0, ..e.clone() };
                let unit: Vec<Sample> = elements.iter().map(of_one).collect();
                let large = elements.iter().map(|e| e.area > smallest);
                marks(&unit, share, 0.0)
                    .into_iter()
                    .zip(large)
                    .map(|(a, b)| a && b)
                    .collect()
            },
            ..WORK
        },
    ),
    plays(
        "not-squared",
        "A Δ/12",
        &[NOT_SQUARED],
        Work {
            marks: |elements, share, smallest| {
                let root = |e: &Sample| {
                    let low = e.radiosity.iter().copied().fold(f64::INFINITY, f64::min);
                    let to = |b: &f64| (b - low).sqrt();
                    Sample {
                        area: e.area,
                        radiosity: e.radiosity.iter().map(to).collect(),
                    }
                };
                marks(&elements.iter().map(root).collect::<Vec<_>>(), share, smallest)
            },
            ..WORK
        },
    ),
    plays(
        "no-twelfth",
        "A Δ²",
        &[NO_TWELFTH],
        Work {
            marks: |elements, share, smallest| marks(elements, share / 12.0, smallest),
            ..WORK
        },
    ),
    plays(
        "two-places",
        "from the first corner to the middle",
        &[TWO_PLACES],
        Work {
            marks: |elements, share, smallest| {
                let ends = |e: &Sample| {
                    let radiosity =
                        vec![e.radiosity[0], e.radiosity[e.radiosity.len() - 1]];
                    Sample { radiosity, ..e.clone() }
                };
                marks(&elements.iter().map(ends).collect::<Vec<_>>(), share, smallest)
            },
            ..WORK
        },
    ),
    plays(
        "reversed",
        "true is good enough",
        &[REVERSED],
        Work {
            marks: |elements, share, smallest| {
                marks(elements, share, smallest).into_iter().map(|mark| !mark).collect()
            },
            ..WORK
        },
    ),
    plays(
        "not-anchored",
        "every vertex has its own light",
        &[NOT_ANCHORED],
        Work { anchor: |_, _| (), ..WORK },
    ),
    plays(
        "backwards",
        "t a + (1 − t) b",
        &[BACKWARDS],
        Work {
            anchor: |values, anchors| {
                for a in anchors {
                    let [from, to] = a.ends.map(|end| values[end]);
                    values[a.vertex] = to + a.at * (from - to);
                }
            },
            ..WORK
        },
    ),
    plays(
        "always-half",
        "a T-vertex is a midpoint",
        &[ALWAYS_HALF],
        Work {
            anchor: |values, anchors| {
                for a in anchors {
                    values[a.vertex] = (values[a.ends[0]] + values[a.ends[1]]) / 2.0;
                }
            },
            ..WORK
        },
    ),
    plays(
        "half-anchored",
        "meet in the middle",
        &[HALF_ANCHORED],
        Work {
            anchor: |values, anchors| {
                for a in anchors {
                    let own = values[a.vertex];
                    anchor(values, &[*a]);
                    values[a.vertex] = (values[a.vertex] + own) / 2.0;
                }
            },
            ..WORK
        },
    ),
    plays(
        "old-ends",
        "all from the values as they came",
        &[OLD_ENDS],
        Work {
            anchor: |values, anchors| {
                let old = values.to_vec();
                for a in anchors {
                    let mut copy = old.clone();
                    anchor(&mut copy, &[*a]);
                    values[a.vertex] = copy[a.vertex];
                }
            },
            ..WORK
        },
    ),
];
