//! How much work it will be, counted, and in seconds of one processor.
//!
//! ```text
//! hemicubes = corners + patches (1 + 3 (0.01/ε)^¾)         ε asked for
//! elements  = patches (1 + (3 + 16 s) √(0.01/ε))           s: share with hidden lamps
//! seconds   = hemicubes (50 µs + 0.16 µs patches) + 10 µs elements + 0.15 s + 9.5 ms rays
//! ```
//! With nothing in the way, `hemicubes = corners + patches` and `elements = patches`. The
//! powers are near those by which light that bends is split. The factors were fitted to the
//! built-in scenes, and the seconds to one machine; `rays` are those of a gather of the
//! certificate, which looks once. They decide nothing.

use super::{Pieces, Survey};
use crate::field::Fineness;
use crate::scene::Scene;
use crate::solution::sampling_for;

/// Predicted work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Predicted {
    /// Patches of the first pass.
    pub patches: f64,
    /// Hemicubes, if one pass is enough.
    pub hemicubes: f64,
    /// Elements that light is shown on.
    pub elements: f64,
    /// Rounds of the solver.
    pub rounds: f64,
    /// Seconds of one processor.
    pub seconds: f64,
}

/// Seconds that a certificate takes for each ray of its gathers, and besides.
const PER_RAY: f64 = 9.5e-3;
const BESIDES: f64 = 0.15;

fn certificate(tolerance: f64) -> f64 {
    BESIDES + PER_RAY * sampling_for(tolerance).rays as f64
}

impl Predicted {
    /// When the answer is known beforehand, only the certificate is left.
    pub(super) fn nothing(scene: &Scene, tolerance: f64) -> Predicted {
        let surfaces = scene.surfaces.len() as f64;
        Predicted {
            patches: surfaces,
            hemicubes: 0.0,
            elements: surfaces,
            rounds: 0.0,
            seconds: certificate(tolerance),
        }
    }

    /// What resolving light at `how` will be.
    pub(super) fn of(
        survey: &Survey,
        pieces: &Pieces,
        how: &Fineness,
        tolerance: f64,
    ) -> Predicted {
        let patches = pieces.patches as f64;
        let finer = 0.01 / tolerance;
        let in_the_way = (survey.blockers > 0) as u8 as f64;
        let bounces = how.reflected.is_finite();
        let split = 1.0 + 3.0 * in_the_way * finer.powf(0.75);
        let looks = pieces.corners as f64 + patches * split;
        let hemicubes = if bounces { looks } else { 0.0 };
        let bends = in_the_way * (3.0 + 16.0 * pieces.shadowed);
        let elements = patches * (1.0 + bends * finer.sqrt());
        let elements = elements.min(how.most_elements as f64);
        Predicted {
            patches,
            hemicubes,
            elements,
            rounds: if bounces { rounds(survey, how.solver) } else { 0.0 },
            seconds: hemicubes * (5e-5 + 1.6e-7 * patches)
                + 1e-5 * elements
                + certificate(tolerance),
        }
    }
}

/// Rounds of a Krylov method, each of which lessens the error by `q/(1 + √(1 − q²))`,
/// until the residual is this share of the light times `1 − ρ_max`.
fn rounds(survey: &Survey, enough: f64) -> f64 {
    let q = survey.kept();
    let rate = q / (1.0 + (1.0 - q * q).sqrt());
    if rate == 0.0 {
        return 1.0;
    }
    let left = 0.5 * enough * (1.0 - survey.brightest);
    (left.ln() / rate.ln()).ceil().max(1.0)
}
