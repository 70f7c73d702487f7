//! Final gathering: the light on one point, from all sides.

use super::tree::{Journey, Shade, Tally, Tree};
use crate::geometry::{Frame, Ray, Rgb};
use crate::radiometry::cosine_direction;
use crate::room::LampsSeen;
use glam::{DVec3, dvec2};

/// A point of a surface on which light is gathered.
pub(super) struct GatherPoint {
    pub surface: u32,
    pub at: DVec3,
    pub normal: DVec3,
}

/// What gathers: the lamps exactly, all else by so many `rays`, spread evenly over the
/// projected hemisphere.
pub(super) struct FinalGather<'t, 's> {
    pub tree: &'t Tree<'s>,
    pub lamps: &'t LampsSeen<'s>,
    pub rays: usize,
}

impl FinalGather<'_, '_> {
    /// Irradiance, W/m², of a point.
    ///
    /// ```text
    /// H = Σ_lamps E F(x → lamp) + π mean of L(x ← ω)        ω of density cosθ/π
    /// ```
    /// No distance and no cosine stand in the mean: a corner next to `x` counts as what it
    /// looks, and no ray counts more than another.
    pub(super) fn irradiance(
        &self,
        &GatherPoint { surface, at, normal }: &GatherPoint,
        journey: &Journey,
        tally: &mut Tally,
        shade: Shade,
    ) -> Rgb {
        let direct = self.lamps.irradiance((surface, at), |_| Rgb::ONE);
        let frame = Frame::about(normal);
        let share = Rgb::splat(1.0 / self.rays as f64);
        let on = Journey {
            weight: journey.weight * share,
            one_of: journey.one_of * self.rays as f64,
            depth: journey.depth + 1,
            media: journey.media.clone(),
            leaving: Some(surface),
            lamps_are_counted: true,
        };
        let mut sum = Rgb::ZERO;
        // ANCHOR: gathered
        for u in tally.points(self.rays) {
            let local = cosine_direction(dvec2(u[0], u[1]));
            let ray = Ray { origin: at, direction: frame.world_from_local(local) };
            sum += share * self.tree.arriving(&ray, &on, tally, shade);
        }
        direct + std::f64::consts::PI * sum
        // ANCHOR_END: gathered
    }
}
