//! Pass 1 over links between nodes of any size.

use super::cannot::{Cannot, Feature};
use super::{Field, Fineness, Pass1};
use crate::room::Room;
use crate::solve::hierarchy::{Hierarchical, HierarchyOptions, solve_hierarchy};
use crate::work::Work;

/// Links, which bring their own mesh and form factors ([`crate::solve::hierarchy`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Links;

/// Links make do with so many elements.
const MOST_ELEMENTS: usize = 100_000;

/// Elements that are linear are better than their links were asked to be.
const FIRST: f64 = 2.0;

impl Pass1 for Links {
    /// No sky, nothing that shines or lets light through: dull faces.
    fn knows(&self, room: &Room) -> Result<(), Cannot> {
        let all = [Feature::Sky, Feature::Mirror, Feature::Pane, Feature::Glass];
        Cannot::check("hierarchy", room, &all)?;
        Cannot::check("hierarchy", room, &[Feature::Sheet])
    }

    fn drops(&self, room: &Room) -> Option<super::Dropped> {
        super::Dropped::gloss(room)
    }

    fn first(&self, room: &Room, tolerance: f64) -> Fineness {
        let reflected = FIRST * tolerance;
        let most_elements = MOST_ELEMENTS;
        Fineness { reflected, most_elements, ..super::Smooth.first(room, tolerance) }
    }

    fn finer(&self, _: &Room, last: &Fineness, share: f64) -> Option<Fineness> {
        Some(Fineness { reflected: share * last.reflected, ..*last })
    }

    fn field(&self, room: &Room, how: &Fineness, work: &Work) -> Field {
        let asked = HierarchyOptions {
            most_elements: how.most_elements,
            seed: how.seed,
            ..HierarchyOptions::aiming_at(how.reflected, room.scene)
        };
        let found = solve_hierarchy(room.scene, &asked, work.progress());
        let Hierarchical { mesh, irradiance, vertex_irradiance, .. } = found;
        work.count(mesh.elements.len());
        let mut field = Field::linear(room.scene, mesh, vertex_irradiance);
        field.sources[0].front.of_elements = irradiance;
        Field {
            ledger: found.ledger,
            solver_residual: found.solver_residual,
            steps: found.steps,
            rows: field.mesh.elements.len(),
            ..field
        }
    }
}
