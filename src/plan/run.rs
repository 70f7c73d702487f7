//! Doing what was planned.

use super::{Plan, PlannedWay};
use crate::field::{Cannot, Everywhere, Smooth};
use crate::room::Room;
use crate::solution::{Goal, Solution, solve, solve_from};
use crate::work::Work;

/// What came of a plan.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The light.
    pub solution: Solution,
    /// What was decided beforehand, and what came of it: one line each.
    pub decisions: Vec<String>,
}

impl Plan {
    /// Does what was planned for `room`, within the limits of `goal`, until the certificate
    /// says that the tolerance is met.
    ///
    /// # Errors
    /// When the room has no surface, or one so far off that rounding spoils it.
    pub fn run(
        &self,
        room: &Room,
        goal: &Goal,
        work: &Work,
    ) -> Result<Planned, Cannot> {
        let mut decisions = self.lines();
        let goal = Goal { tolerance: self.tolerance, ..*goal };
        let solution = match &self.way {
            PlannedWay::Smooth(first) => {
                solve_from(room, &Smooth, *first, &goal, work)?
            }
            PlannedWay::Everywhere(radiosity) => {
                let known = solve(room, &Everywhere(*radiosity), &goal, work)?;
                if known.converged {
                    let said = "run: nothing to solve, and the certificate agrees";
                    decisions.push(said.into());
                    return Ok(Planned { solution: known, decisions });
                }
                let said = "run: the certificate disagrees, so it was solved";
                decisions.push(said.into());
                solve(room, &Smooth, &goal, work)?
            }
        };
        for (k, attempt) in solution.attempts.iter().enumerate() {
            decisions.push(format!(
                "run: pass {}: {} patches, {} elements, {} hemicubes: certified to {:.2} %",
                k + 1,
                attempt.patches,
                attempt.elements,
                attempt.rows,
                100.0 * attempt.certificate.worst()
            ));
        }
        Ok(Planned { solution, decisions })
    }
}
