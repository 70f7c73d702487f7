//! Final gathering: the light on one point, from all sides.

use super::lamps::Lamps;
use super::tree::{Journey, Shade, Tally, Tree};
use crate::geometry::{Frame, Ray, Rgb};
use crate::radiometry::cosine_direction;
use glam::{DVec3, dvec2};

/// Irradiance, W/m², of the point `x` of a surface with this `normal`: the lamps exactly,
/// all else by so many `rays`, spread evenly over the projected hemisphere.
///
/// ```text
/// H = Σ_lamps E F(x → lamp) + π mean of L(x ← ω)        ω of density cosθ/π
/// ```
/// No distance and no cosine stand in the mean: a corner next to `x` counts as what it
/// looks, and no ray counts more than another.
// ANCHOR: gathered
pub(super) fn gathered(
    (tree, lamps): (&Tree, &Lamps),
    (surface, x, normal): (u32, DVec3, DVec3),
    rays: usize,
    (journey, tally): (&Journey, &mut Tally),
    shade: Shade,
) -> Rgb {
    let direct = lamps.irradiance((surface, x, normal), |_| Rgb::ONE);
    let frame = Frame::about(normal);
    let share = Rgb::splat(1.0 / rays as f64);
    let mut sum = Rgb::ZERO;
    for u in tally.points(rays) {
        let local = cosine_direction(dvec2(u[0], u[1]));
        let ray = Ray { origin: x, direction: frame.world_from_local(local) };
        let lamps_are_counted = lamps.are_counted();
        let on = Journey {
            weight: journey.weight * share,
            one_of: journey.one_of * rays as f64,
            depth: journey.depth + 1,
            media: journey.media.clone(),
            lamps_are_counted,
        };
        sum += share * tree.arriving((&ray, Some(surface)), &on, tally, shade);
    }
    direct + std::f64::consts::PI * sum
}
// ANCHOR_END: gathered
