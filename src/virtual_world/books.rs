//! Where the light of one element arrives, and what becomes of it there.

use super::VirtualWorld;
use crate::form_factor::Lost;
use crate::mesh::Mesh;

/// Shares of an element's power that are smaller than this are followed no further.
const NOTHING: f64 = 1e-9;

/// A row of factors while it is made.
pub(super) struct Books<'a> {
    pub(super) world: &'a VirtualWorld,
    pub(super) mesh: &'a Mesh,
    /// Colours are followed one by one.
    pub(super) channel: usize,
    pub(super) row: &'a mut [f64],
    pub(super) lost: Lost,
}

/// Something met.
#[derive(Clone, Copy)]
pub(super) struct RowMet {
    pub(super) element: u32,
    pub(super) front: bool,
    /// Between the light and the normal, either side: in `[0, 1]`.
    pub(super) cosine: f64,
}

impl Books<'_> {
    /// The `share` arrives. What goes on is returned: what is mirrored, and what passes.
    ///
    /// Mirrors are elements, too: all that arrives counts as their irradiance, and what they
    /// send on is taken off what is absorbed.
    pub(super) fn arrives(&mut self, share: f64, met: RowMet, left: u32) -> [f64; 2] {
        let surface = self.mesh.surface_of(&self.mesh.elements[met.element as usize]);
        let divided = self.world.divided(surface, met.front, met.cosine);
        // ANCHOR: arrives
        let [mirrored, passed] = divided.map(|rgb| share * rgb[self.channel]);
        if met.front {
            self.row[met.element as usize] += share;
        } else {
            self.lost.absorbed += share;
        }
        self.lost.absorbed -= mirrored + passed;
        // ANCHOR_END: arrives
        let passed = self.worth(passed);
        if left == 0 {
            self.lost.cut += mirrored;
            return [0.0, passed];
        }
        [self.worth(mirrored), passed]
    }

    /// The share, if it is worth following.
    fn worth(&mut self, share: f64) -> f64 {
        if share >= NOTHING {
            return share;
        }
        self.lost.cut += share;
        0.0
    }
}
