//! What the hemicube and its cousins share: pictures of ids, drawn and added up.
//!
//! ```text
//! F_ij ≈ Σ ΔF_q    over the cells q that show the front of j
//! ```

use super::Lost;
use crate::geometry::Frame;
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::raster::{ItemBuffer, Seen, View};
use glam::DVec3;
use std::f64::consts::TAU;
use std::sync::Mutex;

/// Draws the elements of a mesh as ids.
#[derive(Debug)]
pub(super) struct Painter<'m> {
    pub(super) mesh: &'m Mesh,
    /// Turns each frame by an angle of its own, drawn from this seed.
    pub(super) turned: Option<u64>,
    /// One buffer for each thread that has been at work.
    spare: Mutex<Vec<ItemBuffer>>,
}

impl<'m> Painter<'m> {
    pub(super) fn new(mesh: &'m Mesh) -> Painter<'m> {
        Painter { mesh, turned: None, spare: Mutex::default() }
    }

    /// The frame in which the pictures around `point` are drawn.
    pub(super) fn frame(&self, point: DVec3, normal: DVec3) -> Frame {
        let frame = Frame::about(normal);
        let Some(seed) = self.turned else { return frame };
        let name = point.to_array().map(f64::to_bits);
        let angle = TAU * Stream::named(seed, &name).next();
        let x = frame.x * angle.cos() + frame.y * angle.sin();
        Frame { x, y: normal.cross(x), z: normal }
    }

    /// Lends a buffer to `work` and takes it back.
    pub(super) fn with_buffer(&self, work: impl FnOnce(&mut ItemBuffer)) {
        let spare = self.spare.lock().ok().and_then(|mut spare| spare.pop());
        let mut buffer = spare.unwrap_or_else(|| ItemBuffer::new(1, 1));
        work(&mut buffer);
        if let Ok(mut spare) = self.spare.lock() {
            spare.push(buffer);
        }
    }

    /// Draws the elements as `view` sees them, but for those of surface `own`: what
    /// is flat does not see itself.
    pub(super) fn paint(&self, view: &View, own: Option<u32>, buffer: &mut ItemBuffer) {
        // ANCHOR: paint
        for (id, element) in self.mesh.elements.iter().enumerate() {
            if Some(self.mesh.surface_of(element)) != own {
                buffer.draw(view, &element.polygon, id as u32);
            }
        }
        // ANCHOR_END: paint
    }
}

/// Adds the weights of the cells to the elements that they show, and to what is lost.
pub(super) fn gather(
    cells: &ItemBuffer,
    weights: &[f64],
    row: &mut [f64],
    lost: &mut Lost,
) {
    // ANCHOR: gather
    for (seen, first, end) in cells.runs() {
        let share: f64 = weights[first..end].iter().sum();
        match seen {
            Seen::Front(element) => row[element as usize] += share,
            Seen::Back(_) => lost.absorbed += share,
            Seen::Nothing => lost.escaped += share,
        }
    }
    // ANCHOR_END: gather
}
