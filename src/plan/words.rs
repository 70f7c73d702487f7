//! What was decided, in sentences.

use super::{Decision, Pieces, PlannedWay, Predicted, Survey};
use crate::solution::Goal;

/// One decision for each thing that was looked at, in the order of the work.
pub(super) fn decisions(
    survey: &Survey,
    pieces: &Pieces,
    way: &PlannedWay,
    predicted: &Predicted,
    tolerance: f64,
) -> Vec<Decision> {
    let mut said = vec![room(survey), way_through(survey)];
    let PlannedWay::Smooth(how) = way else {
        said.push(everywhere(survey));
        said.extend(specular(survey));
        return said;
    };
    let bounces = how.reflected.is_finite();
    said.push(lamps(survey, pieces));
    said.push(shadows(pieces));
    if bounces {
        said.push(brightness(survey, tolerance));
        said.push(solver(predicted));
        said.push(nearness(pieces));
        said.push(patches(pieces, how.hemicube));
    } else {
        said.push(darkness(survey, tolerance));
    }
    said.extend(sky(survey));
    said.extend(specular(survey));
    said.push(work(predicted));
    let most = Goal::default().most_patches;
    if pieces.patches > most || predicted.elements >= how.most_elements as f64 {
        said.push(out_of_reach(pieces, most, tolerance));
    }
    said
}

fn room(survey: &Survey) -> Decision {
    let (escaping, lamps) = (survey.escaping, survey.escaping_lamps);
    let why = match survey.is_closed() {
        true => format!(
            "closed: none of {} rays found a way out, so all light ends on a surface",
            survey.rays
        ),
        false if escaping + lamps > 0.0 => format!(
            "open: {} of what the lamps send leaves the scene at once, and {} of what the \
             surfaces send",
            percent(lamps),
            percent(escaping)
        ),
        false => format!(
            "no way out, but {} of what the surfaces send falls on black backs",
            percent(survey.on_backs)
        ),
    };
    Decision { what: "room", why, value: lamps }
}

fn way_through(survey: &Survey) -> Decision {
    let why = match survey.blockers {
        0 => "no surface can hide another from a third: Lambert's formula needs no \
              visibility"
            .into(),
        1 => {
            "one surface or solid can stand between two others: it is cut out of what they see of \
              each other"
                .into()
        }
        n => format!(
            "{n} surfaces or solids can stand between two others: they are cut out, where they reach in"
        ),
    };
    Decision { what: "blockers", why, value: survey.blockers as f64 }
}

fn everywhere(survey: &Survey) -> Decision {
    let value = survey.everywhere.map_or(0.0, |b| b.max_element());
    Decision {
        what: "answer",
        why: format!(
            "each surface has E/(1 − ρ) = {value:.4} W/m² in its brightest channel, so each \
             sees what it is itself: that is the answer everywhere, one element a surface"
        ),
        value,
    }
}

fn lamps(survey: &Survey, pieces: &Pieces) -> Decision {
    let (n, lamps) = (survey.emitters, survey.lamps);
    let few = match (n, lamps) {
        (1, _) => "one emitting surface: its light is".into(),
        (n, 1) => format!("{n} emitting surfaces, tiles of one lamp: its light is"),
        (n, k) if k < n => {
            format!("{n} emitting surfaces, tiles of {k} lamps: their light is")
        }
        (n, _) => format!("{n} emitting surfaces: their light is"),
    };
    let why = match survey.sums_all_lamps {
        true => format!(
            "{few} summed exactly, by Lambert's formula, on {} patches",
            pieces.patches
        ),
        false => format!(
            "{few} summed by Lambert's formula on {} patches: on each that of the strongest, \
             and of some others by chance",
            pieces.patches
        ),
    };
    Decision { what: "lamps", why, value: n as f64 }
}

fn shadows(pieces: &Pieces) -> Decision {
    let s = pieces.shadowed;
    let why = if s == 0.0 {
        "none: light is smooth, elements are split only where it bends".into()
    } else {
        format!(
            "before {} of the patches something may hide part of a lamp: there elements are \
             split until direct light is linear between corners",
            percent(s)
        )
    };
    Decision { what: "shadows", why, value: s }
}

fn brightness(survey: &Survey, tolerance: f64) -> Decision {
    let n = survey.bounces(tolerance);
    Decision {
        what: "bounces",
        why: format!(
            "surfaces reflect {} on the average, {} at the most, and {} of that comes to \
             another surface: {} before less than {} is left",
            percent(survey.mean_reflectance),
            percent(survey.brightest),
            percent((1.0 - survey.escaping - survey.on_backs).max(0.0)),
            if n == 1.0 { "one bounce".into() } else { format!("{n} bounces") },
            percent(tolerance)
        ),
        value: n,
    }
}

fn solver(predicted: &Predicted) -> Decision {
    Decision {
        what: "solver",
        why: format!(
            "rounds that learn from one another (Anderson): about {} until the rest is far \
             below the budget, whatever the number of bounces",
            predicted.rounds
        ),
        value: predicted.rounds,
    }
}

fn darkness(survey: &Survey, tolerance: f64) -> Decision {
    let why = match survey.brightest {
        0.0 => "all surfaces are black: direct light is all there is, and reflected light is \
                skipped"
            .into(),
        rho => format!(
            "no surface reflects more than {}, so light reflected twice is at most that \
             share of it, far below {}: skipped",
            percent(rho),
            percent(tolerance)
        ),
    };
    Decision { what: "bounces", why, value: survey.brightest }
}

fn nearness(pieces: &Pieces) -> Decision {
    let why = match pieces.near {
        0.0 => "no two patches that face each other are closer than 1.5 diameters: each is \
                drawn whole"
            .into(),
        near => format!(
            "{} of the pairs that face each other are closer than 1.5 diameters: drawn \
             element by element, the others whole",
            percent(near)
        ),
    };
    Decision { what: "nearness", why, value: pieces.near }
}

fn patches(pieces: &Pieces, hemicube: u32) -> Decision {
    Decision {
        what: "patches",
        why: format!(
            "{} patches send light; hemicubes of {hemicube} cells look from their {} \
             corners, and light is linear between: smooth shading, not flat",
            pieces.patches, pieces.corners
        ),
        value: pieces.patches as f64,
    }
}

fn sky(survey: &Survey) -> Option<Decision> {
    let value = survey.openings as f64;
    let why = match survey.openings {
        _ if !survey.sky => return None,
        0 => {
            "seen by hemicubes, since it is not only seen through flat openings".into()
        }
        1 => "seen through one flat opening only, which is summed as a lamp is".into(),
        n => format!(
            "seen through {n} flat openings only, which are summed as lamps are"
        ),
    };
    Some(Decision { what: "sky", why, value })
}

fn specular(survey: &Survey) -> Vec<Decision> {
    let mut said = Vec::new();
    if survey.images > 0 {
        let why = format!(
            "{} images of the lamps in flat mirrors and panes are summed exactly; what is \
             reflected more often, rays follow: nothing is cut",
            survey.images
        );
        said.push(Decision { what: "mirrors", why, value: survey.images as f64 });
    }
    if survey.bent > 0 {
        let why = format!(
            "{} of the specular materials, gloss or glass that bends light, have no image: \
             rays carry what they send onto other surfaces",
            survey.bent
        );
        said.push(Decision { what: "rays", why, value: survey.bent as f64 });
    }
    let why = match survey.specular {
        0 => "no specular material: pass 2 would change nothing, skipped".into(),
        n => format!(
            "specular materials: {n}; rays show what they mirror and let through"
        ),
    };
    said.push(Decision { what: "pass 2", why, value: survey.specular as f64 });
    said
}

fn work(predicted: &Predicted) -> Decision {
    let Predicted { hemicubes, elements, seconds, .. } = *predicted;
    Decision {
        what: "work",
        why: format!(
            "about {} elements and {} hemicubes, some {:.1} s of one processor (a guess from \
             other scenes: the certificate decides when it is enough)",
            round(elements),
            round(hemicubes),
            seconds
        ),
        value: seconds,
    }
}

fn out_of_reach(pieces: &Pieces, most: usize, tolerance: f64) -> Decision {
    Decision {
        what: "reach",
        why: format!(
            "{} is likely out of reach: it asks for {} patches and the limit is {most}; the \
             best within the limits is given, and certified",
            percent(tolerance),
            pieces.patches
        ),
        value: pieces.patches as f64,
    }
}

/// `0.0314` as `3.1 %`, whole from 10 % on.
fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".into(),
        p if p < 0.095 => format!("{p:.1e} %"),
        p if p < 9.95 => format!("{} %", (10.0 * p).round() / 10.0),
        p => format!("{p:.0} %"),
    }
}

/// Two digits are enough for a guess.
fn round(x: f64) -> f64 {
    if x < 1.0 {
        return 0.0;
    }
    let unit = 10_f64.powf(x.log10().floor() - 1.0).max(1.0);
    (x / unit).round() * unit
}
