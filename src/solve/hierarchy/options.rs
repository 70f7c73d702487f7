//! How finely a hierarchy is refined.

use crate::scene::Scene;

/// What is asked of a hierarchy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HierarchyOptions {
    /// The relative error `ε` aimed at, in root mean square over the area.
    pub error: f64,
    /// No element is smaller than this, in scene units squared; elements that a contact
    /// line or the scene itself makes small excepted.
    pub smallest: f64,
    /// There are no more elements than this, but for what the scene has anyway.
    pub most_elements: usize,
    /// Names the random streams.
    pub seed: u64,
}

impl HierarchyOptions {
    /// Aims at a relative error, with elements no smaller than `ε²/64` of all area: an
    /// eighth of the edge of an even mesh with that error.
    pub fn aiming_at(error: f64, scene: &Scene) -> HierarchyOptions {
        let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
        HierarchyOptions {
            error,
            smallest: area * error * error / 64.0,
            most_elements: 200_000,
            seed: 0,
        }
    }
}
