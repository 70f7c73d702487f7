//! What a surface does with a path: of several things one, drawn by chance.

use super::super::classes::Letter;
use crate::geometry::{Frame, Rgb};
use crate::material::optics::{fresnel, pane, reflect, refract};
use crate::material::{Lobe, Material, Shine};
use crate::scene::{Scene, Side};
use crate::visibility::Hit;
use glam::DVec3;
use smallvec::SmallVec;

/// A point where a path meets the scene.
pub(super) struct Met<'s> {
    /// Which of [`Scene::surfaces`]: the side that was met, if it is one.
    pub surface: u32,
    pub material: &'s Material,
    /// Does the material act here with all it has? Else it only lets light pass.
    pub acts: bool,
    /// Unit normal on the side that was met.
    pub normal: DVec3,
    /// Is it the front of the face: the outside of a solid?
    outside: bool,
}

impl<'s> Met<'s> {
    /// What a ray meets; `None` where it is black.
    pub fn of(scene: &'s Scene, hit: &Hit) -> Option<Met<'s>> {
        let mut k = hit.item;
        let mut acts = hit.front;
        let surface = &scene.surfaces[k as usize];
        if let (false, Some(back)) = (hit.front, surface.back) {
            (k, acts) = (back, true); // the other side is a surface of its own
        }
        let side = &scene.surfaces[k as usize];
        let material = scene.material(side);
        let towards = if acts { 1.0 } else { -1.0 };
        (acts || material.shine().passes()).then_some(Met {
            surface: k,
            material,
            acts,
            normal: towards * side.polygon.normal(),
            outside: (surface.side == Side::Front) == hit.front,
        })
    }
}

/// The refractive indices of the solids that a path is in, the innermost last.
pub(super) type Media = SmallVec<[f64; 4]>;

fn innermost(media: &Media) -> f64 {
    media.last().copied().unwrap_or(1.0)
}

/// One thing that may happen.
pub(super) enum Event {
    /// Light is scattered by a lobe about `frame.z`, which is on the side it comes from;
    /// `wo`, local, leads to where it goes.
    Scattered { lobe: Lobe, frame: Frame, wo: DVec3 },
    /// It goes straight on.
    Passed,
    /// It comes from a single direction, and from these media; radiance is this many times
    /// what it is there.
    Bent { direction: DVec3, media: Media, denser: f64 },
}

/// What may happen, and how much light it takes.
pub(super) struct Way {
    pub event: Event,
    /// Reflectance or transmittance: the share of the power.
    pub share: Rgb,
    pub letter: Letter,
}

impl Way {
    /// The weight with which chance chooses it.
    fn odds(&self) -> f64 {
        self.share.element_sum()
    }
}

/// All that may happen to a path that arrives along `direction`.
pub(super) fn ways(met: &Met, direction: DVec3, media: &Media) -> SmallVec<[Way; 4]> {
    let mut ways = SmallVec::new();
    let mut may = |letter, share: Rgb, event| {
        if share != Rgb::ZERO {
            ways.push(Way { event, share, letter });
        }
    };
    let normal = met.normal;
    let scattered = |lobe, z| {
        let frame = Frame::about(z);
        let wo = frame.local_from_world(-direction);
        Event::Scattered { lobe, frame, wo: wo.with_z(wo.z.abs()) }
    };
    let bent = |direction| Event::Bent { direction, media: media.clone(), denser: 1.0 };
    let mirrored = || bent(reflect(direction, normal));
    if met.acts {
        // ANCHOR: ways
        let (kd, td) = (met.material.diffuse(), met.material.translucence());
        may(Letter::D, kd, scattered(Lobe::Lambert, normal));
        may(Letter::D, td, scattered(Lobe::Lambert, -normal));
        // ANCHOR_END: ways
    }
    let (cosine, smooth) = (-direction.dot(normal), met.material.smooth_share());
    match met.material.shine() {
        Shine::Mirror { reflectance } => may(Letter::S, reflectance, mirrored()),
        Shine::Gloss { reflectance, exponent } => {
            may(Letter::S, reflectance, scattered(Lobe::Phong { exponent }, normal));
        }
        Shine::Pane { index, tint } => {
            let (r, t) = pane(cosine.min(1.0), index);
            may(Letter::S, smooth * r, mirrored());
            may(Letter::S, smooth * tint * t, Event::Passed);
        }
        Shine::Glass { index, tint } => {
            let (here, beyond, inner) = across(media, index, met.outside);
            let eta = here / beyond;
            let r = fresnel(cosine.min(1.0), eta).mean();
            may(Letter::S, smooth * r, mirrored());
            if let Some(direction) = refract(direction, normal, eta) {
                // Snell's law leaves L/n² alone.
                let event = Event::Bent { direction, media: inner, denser: eta * eta };
                may(Letter::S, smooth * tint * (1.0 - r), event);
            }
        }
        Shine::Dull => {}
    }
    ways
}

/// The index on this side of a solid's face, that beyond, and the media there.
fn across(media: &Media, index: f64, entering: bool) -> (f64, f64, Media) {
    let mut inner = media.clone();
    if entering {
        inner.push(index);
        return (innermost(media), index, inner);
    }
    match media.iter().rposition(|&m| m == index) {
        Some(k) => {
            inner.remove(k);
            (innermost(media), innermost(&inner), inner)
        }
        // The path began inside, or the solid is open.
        None => (index, innermost(media), inner),
    }
}

/// One of the `ways`, drawn by `u` in `[0, 1)`, and its chance; `None` where there is none.
pub(super) fn choose(ways: SmallVec<[Way; 4]>, u: f64) -> Option<(Way, f64)> {
    let all: f64 = ways.iter().map(Way::odds).sum();
    let mut rest = u * all;
    let last = ways.len().checked_sub(1)?;
    for (k, way) in ways.into_iter().enumerate() {
        let odds = way.odds();
        if rest < odds || k == last {
            return Some((way, odds / all));
        }
        rest -= odds;
    }
    None
}

/// What a pane lets pass of light that goes straight through it, and the chance that a path
/// does the same; `None` where the way is blocked.
pub(super) fn straight(met: &Met, direction: DVec3) -> Option<(Rgb, f64)> {
    if !matches!(met.material.shine(), Shine::Pane { .. }) {
        return None;
    }
    let ways = ways(met, direction, &Media::new());
    let all: f64 = ways.iter().map(Way::odds).sum();
    let passed = ways.iter().find(|way| matches!(way.event, Event::Passed))?;
    Some((passed.share, passed.odds() / all))
}
