//! Light straight from the emitters, exactly.
//!
//! ```text
//! H_direct(x) = Σ_k E_k F(x → what x sees of emitter k)
//! ```
//! Each factor is Lambert's formula of the emitter with its hidden parts cut away
//! ([`lambert_visible`]): no ray, no noise, a shadow edge where it belongs. So the solvers
//! need only find the light that was reflected at least once, which varies slowly.

use crate::form_factor::{Blocker, Blockers, lambert_visible};
use crate::geometry::{Polygon, Rgb};
use crate::scene::Scene;
use crate::specular::Chain;
use glam::DVec3;

/// Scenes with more emitting surfaces than this have no light summed exactly.
const MOST_EMITTERS: usize = 32;

/// The emitters of a scene, and what may stand before them.
pub struct Direct<'a> {
    emitters: Vec<(&'a Polygon, Rgb)>,
    blockers: Blockers,
}

impl<'a> Direct<'a> {
    /// Those of a scene; without any when there are more than 32, whose light then has to
    /// be gathered as all other light is.
    pub fn of(scene: &'a Scene) -> Direct<'a> {
        let emitting = scene.surfaces.iter().filter(|s| scene.material(s).emits());
        let mut emitters: Vec<(&Polygon, Rgb)> =
            emitting.map(|s| (&s.polygon, scene.material(s).emission())).collect();
        if emitters.len() > MOST_EMITTERS {
            emitters.clear();
        }
        Direct { emitters, blockers: Blockers::of(scene) }
    }

    /// Is light of lamps summed that comes this way?
    pub fn sums(&self, chain: &Chain) -> bool {
        self.sums_emitters() && *chain == Chain::default()
    }

    /// Is light of the sky summed that comes this way?
    pub fn sums_sky(&self, _: &Chain) -> bool {
        false
    }

    /// Is there an emitter whose light is summed here?
    pub fn sums_emitters(&self) -> bool {
        !self.emitters.is_empty()
    }

    /// The light on `piece`, a part of a surface: only what reaches into the shafts between
    /// it and the emitters is asked about.
    pub fn on(&self, piece: &Polygon) -> OnPiece<'_> {
        let between = |&(emitter, e)| Lamp {
            emitter,
            e,
            past: self.blockers.between(piece, emitter),
        };
        let above = |lamp: &&(&Polygon, Rgb)| {
            let corners = |p: &Polygon, q: &Polygon| {
                q.vertices().iter().any(|&v| p.plane().height(v) > 0.0)
            };
            corners(piece, lamp.0) && corners(lamp.0, piece)
        };
        let lamps = self.emitters.iter().filter(above).map(between).collect();
        OnPiece { normal: piece.normal(), lamps }
    }
}

struct Lamp<'a> {
    emitter: &'a Polygon,
    e: Rgb,
    past: Vec<&'a Blocker>,
}

/// The emitters as they light a piece of a surface.
pub struct OnPiece<'a> {
    normal: DVec3,
    lamps: Vec<Lamp<'a>>,
}

impl OnPiece<'_> {
    /// `H_direct`, W/m², at the point `x` of the piece.
    pub fn irradiance(&self, x: DVec3) -> Rgb {
        let from = |lamp: &Lamp| {
            lamp.e * lambert_visible(x, self.normal, lamp.emitter, &lamp.past)
        };
        self.lamps.iter().map(from).sum()
    }

    /// Can nothing come between the piece and its emitters?
    pub fn is_free(&self) -> bool {
        self.lamps.iter().all(|lamp| lamp.past.is_empty())
    }
}
