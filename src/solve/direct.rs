//! Light straight from the emitters, exactly: also by flat mirrors, and through panes.
//!
//! ```text
//! H_direct(x) = Σ_k E_k Σ_images k_s F(x → what x sees of the image of emitter k)
//! ```
//! Each factor is Lambert's formula of the emitter with its hidden parts cut away: no ray,
//! no noise, a shadow edge where it belongs. In a mirror it is seen as its image
//! ([`VirtualWorld`]). So the solvers need only find the light that was reflected
//! diffusely at least once, which varies slowly. An opening through which the sky is seen
//! is an emitter, too: one whose radiance depends on the direction.

use super::portals::portals;
use crate::geometry::{Polygon, Rgb};
use crate::scene::Scene;
use crate::sky::Sky;
use crate::specular::Chain;
use crate::virtual_world::{Sight, VirtualWorld};
use glam::DVec3;
use std::f64::consts::PI;

/// Scenes with more emitting surfaces than this have no light summed exactly.
const MOST_EMITTERS: usize = 32;

/// So many images of each emitter: a second level of reflections, if it keeps within this.
const MOST_IMAGES: usize = 64;

/// The emitters of a scene, their images, and what may stand before them.
pub struct Direct<'a> {
    emitters: Vec<(&'a Polygon, Rgb)>,
    /// Openings to the sky; none when it is also seen elsewhere.
    portals: Vec<Polygon>,
    sky: Option<&'a Sky>,
    world: VirtualWorld,
}

impl<'a> Direct<'a> {
    /// Those of a scene, by up to two mirrors if these are few; without any emitter when
    /// there are more than 32, whose light then has to be gathered as all other light is.
    pub fn of(scene: &'a Scene) -> Direct<'a> {
        let one = VirtualWorld::of(scene, 1);
        let mirrors = one.mirrors().len();
        let more = mirrors * mirrors.saturating_sub(1) + mirrors;
        let world = match mirrors > 0 && more <= MOST_IMAGES {
            true => VirtualWorld::of(scene, 2),
            false => one,
        };
        Direct::in_world(scene, world)
    }

    /// The same by the images of a given world.
    pub fn in_world(scene: &'a Scene, world: VirtualWorld) -> Direct<'a> {
        let emitting = scene.surfaces.iter().filter(|s| scene.material(s).emits());
        let mut emitters: Vec<(&Polygon, Rgb)> =
            emitting.map(|s| (&s.polygon, scene.material(s).emission())).collect();
        if emitters.len() > MOST_EMITTERS {
            emitters.clear();
        }
        let sky = scene.sky.as_ref().filter(|sky| sky.shines());
        let portals = if sky.is_some() { portals(scene) } else { Vec::new() };
        Direct { emitters, portals, sky, world }
    }

    /// How many images are looked at, the world itself being the first.
    pub fn images(&self) -> usize {
        self.world.images().len()
    }

    /// Openings through which the sky is summed.
    pub fn openings(&self) -> usize {
        self.portals.len()
    }

    /// Is there an emitter whose light is summed here?
    pub fn sums_emitters(&self) -> bool {
        !self.emitters.is_empty()
    }

    /// Is light of lamps summed that comes this way?
    pub fn sums(&self, chain: &Chain) -> bool {
        self.sums_emitters() && self.follows(chain)
    }

    /// Is light of the sky summed that comes this way?
    pub fn sums_sky(&self, chain: &Chain) -> bool {
        !self.portals.is_empty() && self.follows(chain)
    }

    fn follows(&self, chain: &Chain) -> bool {
        !chain.bent && chain.bounces <= self.world.levels()
    }

    /// The sky's part of the light in the middle of `piece`, W/m².
    pub fn of_sky(&self, piece: &Polygon) -> Rgb {
        match self.portals.is_empty() {
            true => Rgb::ZERO,
            false => self.on(piece).of_sky(piece.centroid()),
        }
    }

    /// The light on `piece`, a part of a surface: only what reaches into the shafts between
    /// it and the emitters is asked about.
    pub fn on(&self, piece: &Polygon) -> OnPiece<'_> {
        let lamp = |&(emitter, e): &(&Polygon, Rgb)| {
            let sights = self.world.sights(piece, emitter).into_iter();
            sights.map(move |sight| (sight, e))
        };
        let of_sky = |portal| self.world.sights(piece, portal).into_iter();
        OnPiece {
            normal: piece.normal(),
            lamps: self.emitters.iter().flat_map(lamp).collect(),
            portals: self.portals.iter().flat_map(of_sky).collect(),
            sky: self.sky,
        }
    }
}

/// The emitters as they light a piece of a surface.
pub struct OnPiece<'a> {
    normal: DVec3,
    lamps: Vec<(Sight, Rgb)>,
    portals: Vec<Sight>,
    sky: Option<&'a Sky>,
}

impl OnPiece<'_> {
    /// `H_direct`, W/m², at the point `x` of the piece.
    pub fn irradiance(&self, x: DVec3) -> Rgb {
        let from = |(sight, e): &(Sight, Rgb)| *e * sight.factor(x, self.normal);
        self.lamps.iter().map(from).sum::<Rgb>() + self.of_sky(x)
    }

    /// What of it is the sky's.
    pub fn of_sky(&self, x: DVec3) -> Rgb {
        let Some(sky) = self.sky else { return Rgb::ZERO };
        // Relative to a typical radiance, so that what is even is judged by that.
        let typical =
            (sky.irradiance(sky.up()).max_element() / PI).max(f64::MIN_POSITIVE);
        let radiance = |direction: DVec3| sky.radiance(direction) / typical;
        let from = |sight: &Sight| sight.irradiance(x, self.normal, &radiance);
        typical * self.portals.iter().map(from).sum::<Rgb>()
    }

    /// Can nothing come between the piece and its emitters?
    pub fn is_free(&self) -> bool {
        self.lamps.iter().all(|(sight, _)| sight.is_free())
            && self.portals.iter().all(Sight::is_free)
    }
}
