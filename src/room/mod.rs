//! A room: a scene made ready for light, once, and borrowed by everybody.
//!
//! ```text
//! scene → room: what rays meet · what stands between · lamps and openings · their images
//! H_direct(x) = Σ_k E_k Σ_images k_s F(x → what x sees of the image of emitter k)
//! ```
//! Each part is made when it is asked for first, and never again: [`Room::built`] counts.
//!
//! | part                 | use it when                              | it fails when           |
//! |----------------------|------------------------------------------|--------------------------|
//! | [`Room::visibility`] | rays meet surfaces                       | never                    |
//! | [`Room::blockers`]   | something may stand between two polygons | never                    |
//! | [`Room::lamps`]      | light comes straight from lamps or sky   | mirrors are curved: rays |
//! | [`Room::images`]     | mirrors and panes are flat               | they are curved: rays    |
//!
//! ```
//! use radiosity::{room::Room, scene::built_in};
//! let scene = built_in("cornell").unwrap();
//! let room = Room::of(&scene);
//! assert_eq!(room.built().visibility, 0); // nobody has asked
//! room.visibility();
//! room.visibility();
//! assert_eq!(room.built().visibility, 1);
//! ```
//!
//! **Not here:** light that was reflected diffusely ([`crate::field`]).
//! Chapters *Mirrors and windows* (L17, L18), *Light from the sky* (L21). Sources: Lambert
//! 1760; Wallace, Cohen & Greenberg 1987 (images of lamps).

mod direct;
pub mod lamps;
mod near_lamps;
mod portals;
mod sampler;
mod seen;

pub use direct::{Direct, OnPiece};
pub use sampler::{LightSampler, SampledLight};
pub use seen::{LampsSeen, Panes};

use crate::occlusion::Blockers;
use crate::scene::Scene;
use crate::virtual_world::VirtualWorld;
use crate::visibility::Visibility;
use crate::ways::Solids;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, OnceLock};

/// A scene made ready for light.
pub struct Room<'s> {
    /// The scene.
    pub scene: &'s Scene,
    visibility: OnceLock<Arc<Visibility>>,
    solids: OnceLock<Arc<Solids>>,
    lamps: OnceLock<Direct<'s>>,
    built: [AtomicU32; 3],
}

impl std::fmt::Debug for Room<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("Room")
            .field("scene", &self.scene.name)
            .field("built", &self.built())
            .finish_non_exhaustive()
    }
}

/// How often each part of a room was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Built {
    /// The hierarchy of rays.
    pub visibility: u32,
    /// The solids of glass.
    pub solids: u32,
    /// Lamps and openings, with the images of the scene and its blockers.
    pub lamps: u32,
}

impl<'s> Room<'s> {
    /// That of a scene; nothing is made yet.
    pub fn of(scene: &'s Scene) -> Room<'s> {
        let (visibility, solids) = (OnceLock::new(), OnceLock::new());
        let (lamps, built) = (OnceLock::new(), Default::default());
        Room { scene, visibility, solids, lamps, built }
    }

    // ANCHOR: once
    /// What rays meet: the surfaces, in order.
    pub fn visibility(&self) -> &Arc<Visibility> {
        self.visibility.get_or_init(|| {
            self.built[0].fetch_add(1, Ordering::Relaxed);
            let outlines = self.scene.surfaces.iter().map(|s| &s.polygon);
            Arc::new(Visibility::new(outlines))
        })
    }
    // ANCHOR_END: once

    /// The solids of glass, which tell the media that a ray is in.
    pub fn solids(&self) -> &Arc<Solids> {
        self.solids.get_or_init(|| {
            self.built[1].fetch_add(1, Ordering::Relaxed);
            Arc::new(Solids::of(self.scene))
        })
    }

    /// Lamps and openings to the sky, as points of surfaces see them: also by flat mirrors
    /// and through panes.
    pub fn lamps(&self) -> &Direct<'s> {
        self.lamps.get_or_init(|| {
            self.built[2].fetch_add(1, Ordering::Relaxed);
            Direct::of(self.scene)
        })
    }

    /// The images of the scene in flat mirrors and panes.
    pub fn images(&self) -> &VirtualWorld {
        self.lamps().world()
    }

    /// What may stand between two polygons.
    pub fn blockers(&self) -> &Blockers {
        self.images().blockers()
    }

    /// How often each part was made: once, or never.
    pub fn built(&self) -> Built {
        let [visibility, solids, lamps] =
            [0, 1, 2].map(|k: usize| self.built[k].load(Ordering::Relaxed));
        Built { visibility, solids, lamps }
    }
}
