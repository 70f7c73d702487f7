//! One shot, right and wrong.

use super::TIGHT;
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use crate::gather::given::Room;
use crate::gather::rooms::{coloured, draw, light as values};
use crate::shoot::Work;
use crate::shoot::bugs::*;
use crate::shoot::given::Light;
use radiosity::random::Stream;

/// Any light, of which a part is unshot.
pub(super) fn any_light(room: &Room, stream: &mut Stream) -> Light {
    let (irradiance, radiosity) = (values(room, stream), values(room, stream));
    let unshot = radiosity.iter().map(|b| b * uniform(stream, 0.1, 0.9)).collect();
    Light { irradiance, radiosity, unshot }
}

pub(super) fn flat(light: &Light) -> Vec<f64> {
    [&light.irradiance[..], &light.radiosity, &light.unshot].concat()
}

/// What arrives at `j` of a shot from `i`; what share of it is reflected.
type Arrives = fn(&Room, &Light, usize, usize) -> f64;
type Paint = fn(&Room, usize, usize) -> f64;

pub(super) const ARRIVES: Arrives =
    |r, l, i, j| r.factors[i][j] * r.area[i] / r.area[j] * l.unshot[i];
pub(super) const PAINT: Paint = |r, _, j| r.reflectance[j];

const WRONG_ARRIVALS: [(Bug, Arrives); 4] = [
    (NO_AREAS, |r, l, i, j| r.factors[i][j] * l.unshot[i]),
    (UPSIDE_DOWN, |r, l, i, j| r.factors[i][j] * r.area[j] / r.area[i] * l.unshot[i]),
    (SLIDE, |r, l, i, j| r.factors[j][i] * r.area[i] / r.area[j] * l.unshot[i]),
    (SENDS_ALL, |r, l, i, j| r.factors[j][i] * l.radiosity[i]),
];

const WRONG_PAINTS: [(Bug, Paint); 2] =
    [(SENDERS_PAINT, |r, i, _| r.reflectance[i]), (NO_PAINT, |_, _, _| 1.0)];

/// What else may be made of the light `before` and, shot right, `after`.
type Slip = fn(&Light, &mut Light, &Room, usize);

/// What each element gained in radiosity.
fn gained(before: &Light, after: &Light) -> Vec<f64> {
    let both = after.radiosity.iter().zip(&before.radiosity);
    both.map(|(after, before)| after - before).collect()
}

const SLIPS: [(Bug, Slip); 10] = [
    (NOT_CLEARED, |before, after, _, i| after.unshot[i] += before.unshot[i]),
    (CLEARED_LAST, |_, after, _, i| after.unshot[i] = 0.0),
    (NOTHING_SENT, |before, after, _, i| {
        *after = before.clone();
        after.unshot[i] = 0.0;
    }),
    (NOT_PASSED_ON, |before, after, _, i| {
        after.unshot.clone_from(&before.unshot);
        after.unshot[i] = 0.0;
    }),
    (OVERWRITES, |before, after, _, _| after.radiosity = gained(before, after)),
    (OVERWRITES, |before, after, _, _| after.unshot = gained(before, after)),
    (OVERWRITES, |before, after, _, _| {
        after.radiosity = gained(before, after);
        after.unshot = after.radiosity.clone();
    }),
    (GOES_OUT, |_, after, _, i| after.radiosity[i] = 0.0),
    (GOES_OUT, |before, after, _, i| after.radiosity[i] -= before.radiosity[i]),
    (REFLECTED_ARRIVES, |before, after, _, _| {
        let gained = gained(before, after);
        let irradiance = before.irradiance.iter().zip(gained).map(|(h, g)| h + g);
        after.irradiance = irradiance.collect();
    }),
];

/// The light after a shot.
pub(super) fn after(
    room: &Room,
    light: &Light,
    i: usize,
    arrives: Arrives,
    paint: Paint,
) -> Light {
    let mut after = light.clone();
    after.unshot[i] = 0.0;
    for j in 0..room.area.len() {
        let arriving = arrives(room, light, i, j);
        let reflected = paint(room, i, j) * arriving;
        after.irradiance[j] += arriving;
        after.radiosity[j] += reflected;
        after.unshot[j] += reflected;
    }
    after
}

pub(super) fn shot(work: &Work, stream: &mut Stream, curved: bool) -> Verdict {
    let mut verdict = Verdict::pass(0.0, TIGHT);
    for _ in 0..3 {
        let room = draw(stream, curved);
        let room = coloured(room, stream);
        let light = any_light(&room, stream);
        let n = room.area.len();
        let from = whole_number(stream, 0, n);
        let right = after(&room, &light, from, ARRIVES, PAINT);
        let mut suspects: Vec<Suspect> = Vec::new();
        for (bug, arrives) in WRONG_ARRIVALS {
            suspects.push((bug, flat(&after(&room, &light, from, arrives, PAINT))));
        }
        for (bug, paint) in WRONG_PAINTS {
            suspects.push((bug, flat(&after(&room, &light, from, ARRIVES, paint))));
        }
        for (bug, slip) in SLIPS {
            let mut wrong = right.clone();
            slip(&light, &mut wrong, &room, from);
            suspects.push((bug, flat(&wrong)));
        }
        let mut got = light.clone();
        (work.shoot)(&room, &mut got, from);
        let place = |k: usize| {
            let what = ["H", "B", "ΔB"][(k / n).min(2)];
            format!("{what} of element {}, after a shot from {from} of {n}", k % n)
        };
        let within = Within::Absolute(1e3 * TIGHT);
        verdict = verdict
            .and(|| compare(&flat(&got), &flat(&right), within, &suspects, place));
    }
    verdict
}
