//! Light straight from the emitters, exactly: also by flat mirrors, and through panes.
//! (Of hundreds of lamps some are drawn by chance: [`super::lamps`].)
//!
//! ```text
//! H_direct(x) = Σ_k E_k Σ_images k_s F(x → what x sees of the image of emitter k)
//! ```
//! Each factor is Lambert's formula of the emitter with its hidden parts cut away: no ray,
//! no noise, a shadow edge where it belongs. In a mirror it is seen as its image
//! ([`VirtualWorld`]). So the solvers need only find the light that was reflected
//! diffusely at least once, which varies slowly. An opening through which the sky is seen
//! is an emitter, too: one whose radiance depends on the direction. So is a sun in the sky:
//! one that is far away.

use super::lamps::{Lamp, LampChoice, Lamps, Receiver};
use super::portals::portals;
use crate::geometry::{Polygon, Rgb};
use crate::radiometry::solid_angle;
use crate::scene::Scene;
use crate::sky::{Sky, Sun};
use crate::virtual_world::{Sight, VirtualWorld};
use crate::ways::Chain;
use glam::DVec3;
use std::f64::consts::PI;
use std::sync::Arc;

/// Of the lamps before a piece so many are summed: all, in most scenes.
const ASKED: LampChoice = LampChoice { strongest: 192, drawn: 64 };

/// So many images of each emitter: a second level of reflections, if it keeps within this.
const MOST_IMAGES: usize = 64;

/// A texel that sends more than this share of the sky's light is summed as a lamp is.
const SUN: f64 = 0.005;
const MOST_SUNS: usize = 16;

/// So many times the size of the scene a sun is away: it stands still.
const FAR: f64 = 1e5;

/// The sun as a lamp: its emission such that it sends what the texel does.
fn lamp_far_away(sun: &Sun, scene: &Scene) -> Option<(Polygon, Rgb)> {
    let (low, high) = scene.bounds();
    let (middle, away) = (low.midpoint(high), FAR * scene.diagonal());
    let corners = sun.corners.iter().rev().map(|&c| middle + away * c).collect();
    let mut lamp = Polygon::new(corners).ok()?;
    if lamp.plane().height(middle) < 0.0 {
        lamp = lamp.flipped();
    }
    let seen = solid_angle(middle, &lamp);
    Some((lamp, PI * sun.radiance * (sun.solid_angle / seen)))
}

/// The emitters of a scene, their images, and what may stand before them.
#[derive(Debug)]
pub struct Direct<'a> {
    lamps: Arc<Lamps>,
    /// Openings to the sky; none when it is also seen elsewhere.
    portals: Vec<Polygon>,
    /// Texels of the sky that are lamps of their own: far away.
    suns: Vec<(Polygon, Rgb)>,
    sky: Option<&'a Sky>,
    /// A usual radiance of it: what varies little beside that is even.
    typical: f64,
    /// The sky without them.
    rest: Option<Sky>,
    world: VirtualWorld,
}

impl<'a> Direct<'a> {
    /// Those of a scene, by up to two mirrors if these are few.
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
        let sky = scene.sky.as_ref().filter(|sky| sky.shines());
        let portals = if sky.is_some() { portals(scene) } else { Vec::new() };
        let bright = sky.map_or(Rgb::ZERO, |sky| sky.irradiance(sky.up()));
        let typical = (bright.max_element() / PI).max(f64::MIN_POSITIVE);
        let parted = sky.and_then(|sky| sky.without_suns(SUN, MOST_SUNS));
        let (suns, rest) = parted.unzip();
        let far = |sun: &Sun| lamp_far_away(sun, scene);
        let suns = suns.iter().flatten().filter_map(far).collect();
        let lamps = Arc::new(Lamps::of(scene));
        Direct { lamps, portals, suns, sky, typical, rest, world }
    }

    /// How many images are looked at, the world itself being the first.
    pub fn images(&self) -> usize {
        self.world.images().len()
    }

    /// The world and its images.
    pub fn world(&self) -> &VirtualWorld {
        &self.world
    }

    /// Openings through which the sky is summed.
    pub fn openings(&self) -> usize {
        self.portals.len()
    }

    /// The lamps of the scene.
    pub fn lamps(&self) -> &Arc<Lamps> {
        &self.lamps
    }

    /// Are there so few lamps that each is summed everywhere? Else some are, by chance.
    pub fn sums_all_lamps(&self) -> bool {
        ASKED.takes_all(self.lamps.all().len())
    }

    /// The radiance, in W/(m² sr), of the sky for a ray that leaves the scene in this
    /// direction, but for what is summed here.
    pub fn other_sky(&self, direction: DVec3, chain: &Chain) -> Rgb {
        let Some(sky) = self.sky else { return Rgb::ZERO };
        match self.follows(chain) {
            true if !self.portals.is_empty() => Rgb::ZERO,
            true => self.rest.as_ref().unwrap_or(sky).radiance(direction),
            false => sky.radiance(direction),
        }
    }

    /// Is the light of lamps summed that comes this way, and that of openings?
    pub fn follows(&self, chain: &Chain) -> bool {
        !chain.bent && chain.bounces <= self.world.levels()
    }

    /// The sky's part of the light in the middle of `piece`, W/m².
    pub fn of_sky(&self, piece: &Polygon) -> Rgb {
        match self.portals.is_empty() && self.suns.is_empty() {
            true => Rgb::ZERO,
            false => self.on(piece).of_sky(piece.centroid()),
        }
    }

    /// By how much the lamps' own light changes over an element, W/m²; 0 where nothing can
    /// hide them: there the gradient says enough.
    pub fn rise(&self, element: &Polygon) -> Rgb {
        // ANCHOR: rise
        let light = self.on(element);
        if light.is_free() {
            return Rgb::ZERO;
        }
        let middle = element.centroid();
        // A hair inwards: a corner may lie in the plane of what stands there.
        let corners = element.vertices().iter().map(|v| v.lerp(middle, 1e-3));
        let values = corners.chain([middle]).map(|x| light.irradiance(x));
        let none = [Rgb::INFINITY, Rgb::NEG_INFINITY];
        let [low, high] = values.fold(none, |[low, high], v| [low.min(v), high.max(v)]);
        high - low
        // ANCHOR_END: rise
    }

    /// The lamps that are summed on a piece, and what each counts. Those by chance are the
    /// same all over the piece, so that light is smooth there.
    fn asked(&self, piece: &Polygon) -> Vec<(usize, f64)> {
        let all = self.lamps.all();
        if self.sums_all_lamps() {
            return (0..all.len()).map(|k| (k, 1.0)).collect();
        }
        let place = Receiver::piece(piece);
        let images = self.world.images();
        let weight = |lamp: &Lamp| {
            images.iter().map(|i| lamp.estimate(&place, i.transform())).sum()
        };
        let weights: Vec<f64> = all.iter().map(weight).collect();
        ASKED.choose(&weights, &place.middle.to_array().map(f64::to_bits))
    }

    /// The light on `piece`, a part of a surface: only what reaches into the shafts between
    /// it and the emitters is asked about.
    pub fn on(&self, piece: &Polygon) -> OnPiece<'_> {
        let lamp = |emitter: &Polygon, e: Rgb| {
            let sights = self.world.sights(piece, emitter).into_iter();
            sights.map(move |sight| (sight, e))
        };
        let asked = self.asked(piece);
        let of_lamp = |(k, counts): (usize, f64)| {
            let all = self.lamps.all();
            lamp(&all[k].outline, counts * all[k].emission)
        };
        let of_sky = |portal| self.world.sights(piece, portal).into_iter();
        OnPiece {
            normal: piece.normal(),
            lamps: asked.into_iter().flat_map(of_lamp).collect(),
            suns: self.suns.iter().flat_map(|l| lamp(&l.0, l.1)).collect(),
            portals: self.portals.iter().flat_map(of_sky).collect(),
            sky: self.rest.as_ref().or(self.sky),
            typical: self.typical,
        }
    }
}

/// The emitters as they light a piece of a surface.
#[derive(Debug)]
pub struct OnPiece<'a> {
    normal: DVec3,
    lamps: Vec<(Sight, Rgb)>,
    suns: Vec<(Sight, Rgb)>,
    portals: Vec<Sight>,
    sky: Option<&'a Sky>,
    typical: f64,
}

impl OnPiece<'_> {
    /// `H_direct`, W/m², at the point `x` of the piece.
    pub fn irradiance(&self, x: DVec3) -> Rgb {
        self.of_lamps(&self.lamps, x) + self.of_sky(x)
    }

    fn of_lamps(&self, lamps: &[(Sight, Rgb)], x: DVec3) -> Rgb {
        lamps.iter().map(|(sight, e)| *e * sight.factor(x, self.normal)).sum()
    }

    /// What of it is the sky's.
    pub fn of_sky(&self, x: DVec3) -> Rgb {
        let suns = self.of_lamps(&self.suns, x);
        let Some(sky) = self.sky.filter(|_| !self.portals.is_empty()) else {
            return suns;
        };
        let typical = self.typical;
        let radiance = |direction: DVec3| sky.radiance(direction) / typical;
        let from = |sight: &Sight| sight.irradiance(x, self.normal, &radiance);
        suns + typical * self.portals.iter().map(from).sum::<Rgb>()
    }

    /// Can nothing come between the piece and its emitters?
    pub fn is_free(&self) -> bool {
        self.lamps.iter().chain(&self.suns).all(|(sight, _)| sight.is_free())
            && self.portals.iter().all(Sight::is_free)
    }
}
