//! Doing what was planned.

use super::{Plan, Way};
use crate::certificate::{Sampling, certify};
use crate::geometry::Rgb;
use crate::mesh::{ElementId, Mesh};
use crate::solution::{Ask, Pass, Solution, automatic, resolution_for};
use crate::solve::{Enclosure, Ledger};
use crate::work::Progress;
use glam::DVec3;

/// What came of a plan.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The light.
    pub solution: Solution,
    /// The attempts that it took, in order; none when there was nothing to solve.
    pub passes: Vec<Pass>,
    /// What was decided beforehand, and what came of it: one line each.
    pub decisions: Vec<String>,
}

impl Plan<'_> {
    /// Does what was planned, within the limits of `ask`, until the certificate says that
    /// the tolerance is met.
    pub fn run(&self, ask: &Ask, progress: Progress) -> Planned {
        let mut decisions = self.lines();
        let mut first = resolution_for(self.scene, self.tolerance);
        let known = match &self.way {
            Way::Everywhere(radiosity) => Some(self.everywhere(*radiosity, ask)),
            Way::Smooth(planned) => {
                first = *planned;
                None
            }
        };
        if let Some(solution) = known {
            if solution.converged {
                decisions
                    .push("run: nothing to solve, and the certificate agrees".into());
                return Planned { solution, passes: Vec::new(), decisions };
            }
            decisions.push("run: the certificate disagrees, so it was solved".into());
        }
        let ask = Ask { tolerance: self.tolerance, ..*ask };
        let (solution, passes) = automatic(self.scene, first, &ask, progress);
        for (k, pass) in passes.iter().enumerate() {
            decisions.push(format!(
                "run: pass {}: {} patches, {} elements, {} hemicubes: certified to {:.2} %",
                k + 1,
                pass.patches,
                pass.elements,
                pass.hemicubes,
                100.0 * pass.certificate.high
            ));
        }
        Planned { solution, passes, decisions }
    }

    /// One element a surface, and the same radiosity on all.
    fn everywhere(&self, radiosity: Rgb, ask: &Ask) -> Solution {
        let mesh = Mesh::whole(self.scene);
        let enclosure = Enclosure::of(self.scene, &mesh);
        let field = |_: ElementId, _: DVec3| radiosity;
        let sampling = Sampling { seed: ask.seed, ..Sampling::default() };
        let certificate = certify(self.scene, &mesh, &field, sampling);
        let emitted = enclosure.power(enclosure.emission.iter().copied());
        // Each point sees this radiosity all around it: the irradiance is the same.
        let kept =
            enclosure.reflectance.iter().map(|&rho| (Rgb::ONE - rho) * radiosity);
        let absorbed = enclosure.power(kept);
        let same = vec![radiosity; mesh.elements.len()];
        Solution {
            patches: mesh.elements.len(),
            irradiance: same.clone(),
            displayed: same.clone(),
            radiosity: same,
            vertex_radiosity: vec![radiosity; mesh.vertices.len()],
            mesh,
            ledger: Ledger {
                emitted,
                absorbed,
                imbalance: emitted - absorbed,
                ..Ledger::default()
            },
            solver_residual: 0.0,
            steps: 0,
            certificate,
            converged: certificate.high <= self.tolerance,
        }
    }
}
