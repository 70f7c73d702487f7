//! Pass 1 as it is asked for by an error: find, certify, and finer until it suffices.
//!
//! ```text
//! ‖B* − B‖ / ‖B* − E‖ ≤ tolerance, certified
//! ```
//! There is one loop for all methods. It ends when the certificate meets the tolerance, when
//! a finer attempt is beyond the limits, or when the last gained less than half of what it
//! was to gain. Of all attempts the one with the least certified error is kept.
//!
//! | entry                     | use it when                        | it fails when            |
//! |---------------------------|------------------------------------|--------------------------|
//! | [`solve`]                 | light is wanted, to an error       | the limits are reached   |
//! | [`solve_from`]            | the first fineness is known        | it is too fine           |
//! | [`solve_on`]              | the mesh is given                  | it is too coarse         |
//! | [`Solution::of`]          | a field is there, to be certified  | never: it says how wrong |
//!
//! ```
//! use radiosity::{field::Smooth, room::Room, scene::built_in, work::Work};
//! use radiosity::solution::{Goal, solve};
//! let scene = built_in("furnace").unwrap();
//! let found = solve(&Room::of(&scene), &Smooth, &Goal::within(0.05), &Work::quiet());
//! let found = found.unwrap();
//! assert!(found.converged && found.certificate.high <= 0.05);
//! assert!((found.radiosity[0].x - 2.0).abs() < 0.1); // E/(1 − ρ), E = 1, ρ = 1/2
//! ```
//!
//! **Not here:** what a scene needs ([`crate::plan`]).
//! Beyond the lecture: chapters *What does this scene need?* and *How wrong is it?*.
//! Sources: Lischinski, Smits & Greenberg 1994.

use crate::certificate::{Audit, Certificate, Judged, Sampling, audit};
use crate::field::{Cannot, Classical, Dropped, Field, Fineness, Pass1};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::room::Room;
use crate::work::Work;

/// What a solution must reach, and what it may cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// The largest certified error asked for, relative; see [`Certificate`].
    pub tolerance: f64,
    /// Names the random streams.
    pub seed: u64,
    /// The most patches: the work grows as their square.
    pub most_patches: usize,
    /// The most elements.
    pub most_elements: usize,
}

impl Default for Goal {
    fn default() -> Goal {
        Goal { tolerance: 0.01, seed: 0, most_patches: 4000, most_elements: 60_000 }
    }
}

impl Goal {
    /// An error of at most this, relative, in `(0, ∞)`.
    pub fn within(tolerance: f64) -> Goal {
        Goal { tolerance, ..Goal::default() }
    }
}

/// One attempt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempt {
    /// How finely it resolved light.
    pub fineness: Fineness,
    /// What shines on what.
    pub patches: usize,
    /// What light is shown on.
    pub elements: usize,
    /// How many hemicubes were drawn, or rows of factors computed.
    pub rows: usize,
    /// What came out.
    pub certificate: Certificate,
}

/// The light of a scene, and how wrong it is.
#[derive(Clone, Debug)]
#[must_use]
pub struct Solution {
    /// The light, on its mesh.
    pub field: Field,
    /// `B`, W/m², mean of each element.
    pub radiosity: Vec<Rgb>,
    /// `H`, W/m², mean of each element, on the front.
    pub irradiance: Vec<Rgb>,
    /// `B`, W/m², per vertex of the mesh: what smooth shading shows, and is certified.
    pub vertex_radiosity: Vec<Rgb>,
    /// How far the smooth field is from the truth.
    pub certificate: Certificate,
    /// Is the certified error below the tolerance asked for?
    pub converged: bool,
    /// All attempts, in order; this is the best of them.
    pub attempts: Vec<Attempt>,
    /// What the method left out, where there was such.
    pub dropped: Option<Dropped>,
}

/// Attempts at the most.
const MOST_ATTEMPTS: usize = 6;

/// A finer attempt aims at this share of the tolerance.
const AIM: f64 = 0.75;

/// Solves a room by a method until the certificate says that the goal is met, or more would
/// be needed than is allowed, or finer attempts gain nothing.
///
/// Deterministic: the same at any number of threads.
///
/// # Errors
/// When the method does not know something that the room has.
pub fn solve(
    room: &Room,
    method: &dyn Pass1,
    goal: &Goal,
    work: &Work,
) -> Result<Solution, Cannot> {
    Cannot::in_any_case(room.scene)?;
    solve_from(room, method, method.first(room, goal.tolerance), goal, work)
}

/// The same, from a given fineness on.
///
/// # Errors
/// As [`solve`].
pub fn solve_from(
    room: &Room,
    method: &dyn Pass1,
    first: Fineness,
    goal: &Goal,
    work: &Work,
) -> Result<Solution, Cannot> {
    Cannot::in_any_case(room.scene)?;
    method.knows(room)?;
    let most_elements = first.most_elements.min(goal.most_elements);
    let most_patches = first.most_patches.min(goal.most_patches);
    let mut how = Fineness { most_elements, most_patches, seed: goal.seed, ..first };
    let mut best: Option<Solution> = None;
    let mut attempts: Vec<Attempt> = Vec::new();
    // ANCHOR: finer
    loop {
        // Each attempt is judged by samples that have steered nothing.
        let goal = &Goal { seed: unused(goal.seed, attempts.len()), ..*goal };
        let found = Solution::of(room, method.field(room, &how, work), goal, work);
        attempts.push(found.attempt(how));
        let full = found.field.mesh.elements.len() >= how.most_elements;
        let converged = found.converged;
        if best
            .as_ref()
            .is_none_or(|b| found.certificate.worst() < b.certificate.worst())
        {
            best = Some(found);
        }
        let share = aimed_at(&attempts, goal);
        let possible =
            !converged && !full && gains(&attempts, goal) && !work.is_spent();
        match method.finer(room, &how, share).filter(|_| possible) {
            Some(finer) if attempts.len() < MOST_ATTEMPTS => how = finer,
            _ => break,
        }
    }
    // ANCHOR_END: finer
    let mut solution = best.ok_or(Cannot::NoSurfaces)?;
    (solution.attempts, solution.dropped) = (attempts, method.drops(room));
    Ok(solution)
}

/// The share of the last attempt's error that the next is to have.
fn aimed_at(attempts: &[Attempt], goal: &Goal) -> f64 {
    let high = attempts.last().map_or(f64::INFINITY, |a| a.certificate.worst());
    (AIM * goal.tolerance / high).clamp(0.4, 0.8)
}

/// Did the last attempt gain at least half of what it was to gain on the one before? What
/// does not is noise, which stays.
fn gains(attempts: &[Attempt], goal: &Goal) -> bool {
    let Some((last, before)) = attempts.split_last() else { return true };
    let Some(previous) = before.last() else { return true };
    let hoped = 0.5 * (1.0 + aimed_at(before, goal));
    last.certificate.error <= hoped * previous.certificate.error
}

/// Solves a room by a method of the lecture on a mesh that is given.
///
/// # Errors
/// As [`solve`].
pub fn solve_on(
    room: &Room,
    method: &Classical,
    mesh: Mesh,
    goal: &Goal,
    work: &Work,
) -> Result<Solution, Cannot> {
    Cannot::in_any_case(room.scene)?;
    method.knows(room)?;
    let how = Fineness { seed: goal.seed, ..method.first(room, goal.tolerance) };
    let found = Solution::of(room, method.on(room, mesh, &how, work), goal, work);
    Ok(Solution { dropped: method.drops(room), ..found })
}

/// Another seed for each attempt: nobody is to be judged by what has steered him.
fn unused(seed: u64, attempt: usize) -> u64 {
    seed ^ (attempt as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// How wrong `field` is, and where: [`audit`] with what the room has ready.
pub fn audited(room: &Room, field: &Judged, sampling: Sampling) -> Audit {
    audit(room.scene, room.visibility(), field, sampling)
}

impl Solution {
    /// A field with its certificate.
    pub fn of(room: &Room, field: Field, goal: &Goal, work: &Work) -> Solution {
        let certificate = certified(room, &field, goal, work);
        let irradiance = field.irradiance();
        let explained = books_close(&field, &irradiance, &certificate);
        Solution {
            radiosity: field.radiosity(room.scene),
            irradiance,
            vertex_radiosity: field.vertex_radiosity(room.scene),
            converged: explained && certificate.meets(goal.tolerance),
            certificate,
            field,
            attempts: Vec::new(),
            dropped: None,
        }
    }

    fn attempt(&self, fineness: Fineness) -> Attempt {
        Attempt {
            fineness,
            patches: self.field.patches,
            elements: self.field.mesh.elements.len(),
            rows: self.field.rows,
            certificate: self.certificate,
        }
    }
}

/// Points and rays of a certificate: its doubt is about a quarter of one per cent.
const POINTS: usize = 1600;
const RAYS: usize = 256;

/// A larger error may be in more doubt: the square of what noise adds falls with the rays.
const FEWEST_RAYS: usize = 32;

/// From so many to so many times as many are cast when chance is in doubt, and so often it is
/// looked.
const MORE: [f64; 2] = [1.5, 4.0];
const LOOKS: usize = 3;

/// The points and rays that tell whether an error meets the tolerance.
pub fn sampling_for(tolerance: f64) -> Sampling {
    let rays = (RAYS as f64 * 0.01 / tolerance) as usize;
    let rays = rays.clamp(FEWEST_RAYS, RAYS);
    Sampling { points: POINTS, rays, unseen: tolerance, seed: 0 }
}

/// The certificate: with more rays, and by other samples, where only chance may keep it from
/// the tolerance.
fn certified(room: &Room, field: &Field, goal: &Goal, work: &Work) -> Certificate {
    let [front, behind] = field.vertex_irradiance();
    let at = |id, x| [field.at(id, x, &front), field.at(id, x, &behind)];
    let judged = Judged { mesh: &field.mesh, irradiance: &at };
    let mut sampling = Sampling { seed: goal.seed, ..sampling_for(goal.tolerance) };
    work.tell("certifying", 0, LOOKS);
    let mut certificate = audited(room, &judged, sampling).certificate;
    for look in 1..LOOKS {
        work.tell("certifying", look, LOOKS);
        let Certificate { error, low, irradiance, .. } = certificate;
        let likely = error.max(irradiance.error) <= goal.tolerance;
        let by_chance = likely || low.max(irradiance.low) < 0.25 * goal.tolerance;
        if certificate.worst() <= goal.tolerance || !by_chance {
            break;
        }
        sampling.rays =
            (sampling.rays as f64 * more(&certificate, goal.tolerance)) as usize;
        sampling.seed = sampling.seed.wrapping_add(1);
        certificate = audited(room, &judged, sampling).certificate;
    }
    work.tell("certifying", LOOKS, LOOKS);
    certificate
}

/// How many times as many rays will do: what chance adds to the square of an error falls as
/// they grow.
fn more(certificate: &Certificate, tolerance: f64) -> f64 {
    let times = |error: f64, high: f64| {
        let room = (0.9 * tolerance).powi(2) - error * error;
        if room > 0.0 { (high * high - error * error) / room } else { f64::INFINITY }
    };
    let Certificate { error, high, irradiance: h, .. } = *certificate;
    times(error, high).max(times(h.error, h.high)).clamp(MORE[0], MORE[1])
}

/// What is missing in the books, and what was not sent, may be no more than the certified
/// error explains; and all of it are numbers.
///
/// ```text
/// |∫ (H* − H) dA| ≤ √A ‖H* − H‖ ≤ √A · high · ‖H*‖          Cauchy and Schwarz
/// ```
/// What escapes arrives, too: on what is around, evenly.
fn books_close(field: &Field, irradiance: &[Rgb], certificate: &Certificate) -> bool {
    let elements = field.mesh.elements.iter().zip(irradiance);
    let (mut area, mut squares) = (0.0, Rgb::ZERO);
    for (element, h) in elements {
        area += element.polygon.area();
        squares += element.polygon.area() * h * h;
    }
    let high = certificate.irradiance.high.max(certificate.high);
    let ledger = &field.ledger;
    let arrives = (area * squares).map(f64::sqrt) * (1.0 + high) + ledger.escaped;
    let most = high * arrives;
    let [imbalance, unshot] = [ledger.imbalance.abs(), ledger.unshot.abs()];
    ledger.is_finite() && imbalance.cmple(most).all() && unshot.cmple(most).all()
}
