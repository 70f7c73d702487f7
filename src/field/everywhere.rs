//! Light that is the same everywhere: a closed room in which every surface has the same
//! `E/(1 − ρ)`.

use super::{Cannot, Field, Fineness, Pass1};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::room::Room;
use crate::solve::{Enclosure, Ledger};
use crate::work::Work;

/// Nothing to solve: one element a surface, and this radiosity, in W/m², on all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Everywhere(pub Rgb);

impl Pass1 for Everywhere {
    /// Whoever found the radiosity knew; the certificate judges.
    fn knows(&self, _: &Room) -> Result<(), Cannot> {
        Ok(())
    }

    fn first(&self, room: &Room, tolerance: f64) -> Fineness {
        super::Smooth.first(room, tolerance)
    }

    fn finer(&self, _: &Room, _: &Fineness, _: f64) -> Option<Fineness> {
        None
    }

    /// Each point sees this radiosity all around it: the irradiance is the same.
    fn field(&self, room: &Room, _: &Fineness, _: &Work) -> Field {
        let mesh = Mesh::whole(room.scene);
        let same = vec![self.0; mesh.elements.len()];
        let enclosure = Enclosure::of(room.scene, &mesh);
        let emitted = enclosure.power(enclosure.emission.iter().copied());
        let absorbed = enclosure
            .power(enclosure.reflectance.iter().map(|&rho| (Rgb::ONE - rho) * self.0));
        let imbalance = emitted - absorbed;
        let ledger = Ledger { emitted, absorbed, imbalance, ..Ledger::default() };
        Field { ledger, ..Field::constant(room.scene, mesh, same) }
    }
}
