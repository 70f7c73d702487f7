//! Form factors by casting rays: the share of cosine-weighted rays that arrive.
//!
//! ```text
//! F_ij ≈ hits on j / rays          standard error ≤ √(F (1 − F) / rays)
//! ```
//!
//! **Use it when** patches are small, blockers many, or another method is to be checked: it
//! assumes nothing. **It fails** never, but its error falls only with the root of the rays
//! (somewhat faster here: the rays fill their space evenly).
//!
//! Sources: Malley 1988; Sillion & Puech 1989 (ray casting for form factors).

use super::{FormFactors, Lost, ray_from};
use crate::geometry::{Frame, Polygon};
use crate::mesh::{ElementId, Mesh};
use crate::random::Stream;
use crate::visibility::Visibility;

/// The method, ready for a scene.
#[derive(Debug)]
pub struct Cast {
    elements: Vec<Polygon>,
    visibility: Visibility,
    rays: usize,
    seed: u64,
}

impl Cast {
    /// Factors between the elements of `mesh` by so many rays from each (positive).
    pub fn new(mesh: &Mesh, rays: usize, seed: u64) -> Cast {
        assert!(rays > 0, "rays must be positive");
        let elements: Vec<Polygon> = mesh.polygons().cloned().collect();
        Cast { visibility: Visibility::new(&elements), elements, rays, seed }
    }

    /// An upper bound of the standard error of a factor `f` by `rays` rays:
    /// `√(f(1 − f)/rays)`, that of independent ones.
    pub fn standard_error(f: f64, rays: usize) -> f64 {
        (f * (1.0 - f) / rays as f64).sqrt()
    }
}

// ANCHOR: cast_row
impl FormFactors for Cast {
    fn len(&self) -> usize {
        self.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let element = &self.elements[from];
        let frame = Frame::about(element.normal());
        let share = 1.0 / self.rays as f64;
        let mut lost = Lost::default();
        row.fill(0.0);
        // ANCHOR: cast
        for u in Stream::named(self.seed, &[from.0 as u64]).points(self.rays) {
            let ray = ray_from(element, &frame, u);
            match self.visibility.closest(&ray, Some(from.0)) {
                Some(hit) if hit.front => row[hit.item as usize] += share,
                Some(_) => lost.absorbed += share,
                None => lost.escaped += share,
            }
        }
        // ANCHOR_END: cast
        lost
    }
}
// ANCHOR_END: cast_row
