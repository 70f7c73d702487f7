//! What can happen to a ray that meets a surface, in whatever medium.
//!
//! ```text
//! L(x ← ω) = Σ over the ways on of share · denser · L(there)     Σ of the shares ≤ 1
//! denser = (n here / n there)²       L/n² is what Snell's law leaves alone
//! ```
//! Light that reaches an eye, or a surface, is followed backwards. At each surface on its
//! way it came by one of a few [`Way`]s: scattered by a lobe, mirrored, straight on, bent.
//! Whoever follows rays asks [`ways()`] and differs only in what is done with the answer.
//!
//! | what is done with the ways         | by                                           |
//! |------------------------------------|----------------------------------------------|
//! | all are followed                   | the tree of rays of [`crate::trace`]         |
//! | one, [drawn by chance](choose)     | the path tracer of [`crate::trace`]          |
//! | only the straight one              | [`straight()`]: a lamp seen through panes    |
//! | either, until the ray is used up   | [`Specular::follow`]: what arrives           |
//!
//! **Media.** The faces of glass that hang together are a solid ([`Solids`]). A ray carries
//! the solids that it is in ([`Media`]). Where solids overlap, the later one in the file
//! holds the overlap, from whichever side a ray comes; a face that is no boundary of the
//! one that holds both its sides is not there for a ray. A ray that begins somewhere learns
//! where it is when it first meets something clear.
//!
//! ```
//! use radiosity::ways::choose;
//! let odds = [0.25, 0.0, 0.75]; // mirrored, scattered, straight on
//! assert_eq!(choose(odds.into_iter(), 0.2), Some((0, 0.25)));
//! assert_eq!(choose(odds.into_iter(), 0.9), Some((2, 0.75)));
//! ```
//!
//! **Not here:** pictures ([`crate::trace`]); images in flat mirrors
//! ([`crate::virtual_world`]), which need no rays. Chapter *Mirrors and windows* (L17, L18). Sources: Fresnel 1823; Veach 1997 (radiance in media); Whitted 1980; Schmidt & Budge 2002
//! (overlapping solids, by rank).

mod follow;
mod media;
mod solids;

pub use follow::{Arrival, Branching, Chain, MOST_BOUNCES, Met, Specular};
pub use media::Media;
pub use solids::Solids;

use crate::geometry::{Ray, Rgb};
use crate::material::optics::{fresnel, pane, reflect, refract};
use crate::material::{Lobe, Material, Shine};
use crate::scene::{FaceId, Scene, Side};
use crate::visibility::Hit;
use glam::DVec3;
use smallvec::SmallVec;

/// One letter of a path's word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letter {
    /// Scattered diffusely, to the same side or through the sheet.
    D,
    /// Passed on: by a mirror, a pane, glass or gloss.
    S,
}

/// A point where a ray meets a surface.
#[derive(Clone, Copy, Debug)]
pub struct Meeting<'s> {
    /// Which of [`Scene::surfaces`]: the side that was met, if it is one.
    pub surface: u32,
    /// Its material.
    pub material: &'s Material,
    /// Was the surface met on its front, where it acts with all it has? From behind it is
    /// black, or only passes light.
    pub front: bool,
    /// Where the ray began.
    pub origin: DVec3,
    /// Of the ray, of unit length.
    pub direction: DVec3,
    /// Where it met the surface.
    pub point: DVec3,
    /// Unit normal on the side that was met.
    pub normal: DVec3,
    face: FaceId,
    /// Is it the front of the face: the outside of a solid?
    outside: bool,
    solids: &'s Solids,
}

impl<'s> Meeting<'s> {
    /// Where `ray` meets a surface of the scene: `hit.item` is which.
    pub fn of(
        scene: &'s Scene,
        solids: &'s Solids,
        ray: &Ray,
        hit: &Hit,
    ) -> Meeting<'s> {
        let (mut k, mut front) = (hit.item, hit.front);
        let surface = &scene.surfaces[k as usize];
        if let (false, Some(back)) = (hit.front, surface.back) {
            (k, front) = (back, true); // the other side is a surface of its own
        }
        let side = &scene.surfaces[k as usize];
        let towards = if front { 1.0 } else { -1.0 };
        Meeting {
            surface: k,
            material: scene.material(side),
            front,
            origin: ray.origin,
            direction: ray.direction,
            point: ray.origin + hit.distance * ray.direction,
            normal: towards * side.polygon.normal(),
            face: surface.face,
            outside: (surface.side == Side::Front) == hit.front,
            solids,
        }
    }

    /// The media behind the surface, of a ray that comes through these.
    pub fn beyond(&self, media: &Media) -> Media {
        self.solids.crossing(self, media).after
    }
}

/// What happened to light where a ray, followed backwards, meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// It was scattered by a lobe about this normal, which is on the side it comes from.
    Scattered {
        /// The shape of the scattering.
        lobe: Lobe,
        /// Of unit length.
        normal: DVec3,
    },
    /// It was mirrored, and comes from this direction.
    Mirrored(DVec3),
    /// It came straight on.
    Passed,
    /// It was bent, and comes from this direction.
    Bent(DVec3),
}

/// One way on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// What happens.
    pub event: Event,
    /// Reflectance or transmittance, in `[0, 1]`: the share of the power.
    pub share: Rgb,
    /// Radiance is so many times what it is where the way leads: `(n here / n there)²`.
    pub denser: f64,
    /// Does the way lead through the face of a solid, into other [`Media`]
    /// ([`Meeting::beyond`])?
    pub crosses: bool,
}

/// All ways on, the scattered ones first.
pub type Ways = SmallVec<[Way; 4]>;

impl Way {
    /// The single direction, of unit length, from which light comes to a ray along
    /// `direction`; `None` where it is scattered.
    pub fn from(&self, direction: DVec3) -> Option<DVec3> {
        match self.event {
            Event::Scattered { .. } => None,
            Event::Passed => Some(direction),
            Event::Mirrored(from) | Event::Bent(from) => Some(from),
        }
    }

    /// What it writes into the word of a path.
    pub fn letter(&self) -> Letter {
        match self.event {
            Event::Scattered { lobe: Lobe::Lambert, .. } => Letter::D,
            _ => Letter::S,
        }
    }

    /// The weight with which chance chooses it.
    pub fn odds(&self) -> f64 {
        self.share.element_sum()
    }
}

/// All that can happen to a ray at a surface; nothing where it is black. If the ray does
/// not know yet what it is in, and has to, `media` are found.
///
/// ```text
/// Kd, Td: lobes     Ks: mirror or lobe     pane: s R, s Tf T     glass: s R, s Tf (1 − R)
/// ```
/// with `s` of [`Material::smooth_share`] and `R`, `T` by Fresnel's law for the indices on
/// both sides. The shares sum to at most one in every channel: no ray gains.
pub fn ways(met: &Meeting, media: &mut Media) -> Ways {
    let (material, shine) = (met.material, met.material.shine());
    let mut ways = Ways::new();
    if !(met.front || shine.passes()) {
        return ways;
    }
    let mut may = |share: Rgb, event: Event, (denser, crosses): (f64, bool)| {
        if share != Rgb::ZERO {
            ways.push(Way { event, share, denser, crosses });
        }
    };
    const HERE: (f64, bool) = (1.0, false);
    let crossing = shine.index_of_solid().map(|_| met.solids.cross(met, media));
    let there = crossing.as_ref().map_or(HERE, |c| (c.denser, true));
    let scattered = |lobe, normal| Event::Scattered { lobe, normal };
    if met.front {
        // ANCHOR: ways
        let (kd, td) = (material.diffuse(), material.translucence());
        may(kd, scattered(Lobe::Lambert, met.normal), HERE);
        may(td, scattered(Lobe::Lambert, -met.normal), there);
        // ANCHOR_END: ways
    }
    let mirrored = || Event::Mirrored(reflect(met.direction, met.normal));
    let cosine = (-met.direction.dot(met.normal)).clamp(0.0, 1.0);
    let smooth = material.smooth_share();
    match shine {
        Shine::Dull => {}
        // ANCHOR: shine
        Shine::Mirror { reflectance } => may(reflectance, mirrored(), HERE),
        Shine::Gloss { reflectance, exponent } => {
            may(reflectance, scattered(Lobe::Phong { exponent }, met.normal), HERE);
        }
        Shine::Pane { index, tint } => {
            let (r, t) = pane(cosine, index / met.solids.index_here(met, media));
            may(smooth * r, mirrored(), HERE);
            may(smooth * tint * t, Event::Passed, HERE);
        }
        // ANCHOR_END: shine
        Shine::Glass { tint, .. } => match crossing.and_then(|c| c.eta) {
            None => may(smooth, Event::Passed, there),
            Some(1.0) => may(smooth * tint, Event::Passed, there),
            Some(eta) => {
                let r = fresnel(cosine, eta).mean();
                may(smooth * r, mirrored(), HERE);
                if let Some(bent) = refract(met.direction, met.normal, eta) {
                    may(smooth * tint * (1.0 - r), Event::Bent(bent), there);
                }
            }
        },
    }
    ways
}

/// Of several things one, drawn by `u` in `[0, 1)` with these odds: which, and its chance.
/// `None` where there is none.
pub fn choose(odds: impl Iterator<Item = f64> + Clone, u: f64) -> Option<(usize, f64)> {
    // ANCHOR: choose
    let all: f64 = odds.clone().sum();
    let mut rest = u * all;
    let mut chosen = None;
    for (k, odds) in odds.enumerate() {
        chosen = Some((k, odds / all));
        if rest < odds {
            break;
        }
        rest -= odds;
    }
    chosen
    // ANCHOR_END: choose
}

/// What passes of light that goes straight on, the chance that a path does the same, and
/// the media there; `None` where the way is blocked.
pub fn straight(met: &Meeting, media: &mut Media) -> Option<(Rgb, f64)> {
    if !met.material.shine().passes() {
        return None;
    }
    let ways = ways(met, media);
    let all: f64 = ways.iter().map(Way::odds).sum();
    let passed = ways.iter().find(|way| way.event == Event::Passed)?;
    if passed.crosses {
        *media = met.beyond(media);
    }
    Some((passed.share, passed.odds() / all))
}
