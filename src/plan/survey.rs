//! Looking at a scene: openings, blockers, lamps, brightness, nearness, shadows.

use crate::form_factor::ray_from;
use crate::geometry::{Frame, Polygon, Rgb};
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::room::Room;
use crate::scene::Scene;
use crate::sky::Sky;
use crate::visibility::Visibility;

/// What a scene is like.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// How many surfaces.
    pub surfaces: usize,
    /// How many rays were cast from them.
    pub rays: usize,
    /// The share of the light leaving surfaces, by area, that leaves the scene.
    pub escaping: f64,
    /// The same of what the lamps send, by power.
    pub escaping_lamps: f64,
    /// The share of the light leaving surfaces that falls on black backs.
    pub on_backs: f64,
    /// How many sheets and convex solids can stand between two others.
    pub blockers: usize,
    /// Surfaces that emit.
    pub emitters: usize,
    /// Lamps: tiles of one count once.
    pub lamps: usize,
    /// Are they few enough to be summed exactly? Else some are, by chance.
    pub sums_all_lamps: bool,
    /// Largest `ρ + τ`, brightest channel.
    pub brightest: f64,
    /// `ρ̄`, mean over the area, brightest channel.
    pub mean_reflectance: f64,
    /// Materials in use that mirror, shine or let light through: what pass 2 is for.
    pub specular: usize,
    /// Images of the scene in flat mirrors and panes whose lamps are summed exactly.
    pub images: usize,
    /// Materials among the specular ones that have no image: gloss, and glass that bends.
    pub bent: usize,
    /// Is there a sky that shines?
    pub sky: bool,
    /// Openings through which it is summed exactly; 0 when it is also seen otherwise.
    pub openings: usize,
    /// The radiosity, in W/m², that is everywhere the same, if it is.
    pub everywhere: Option<Rgb>,
}

/// Rays by area, and as many by emitted power.
const RAYS: f64 = 8192.0;

/// Rays from each surface, however small.
const FEWEST_RAYS: usize = 16;

impl Survey {
    /// Looks at a room.
    pub fn of(room: &Room) -> Survey {
        let scene = room.scene;
        let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
        let sent = |k: usize| {
            let s = &scene.surfaces[k];
            s.polygon.area() * scene.material(s).emission().element_sum()
        };
        let power: f64 = (0..scene.surfaces.len()).map(sent).sum();
        let (visibility, direct) = (room.visibility(), room.lamps());
        let mut found = Survey {
            surfaces: scene.surfaces.len(),
            rays: 0,
            escaping: 0.0,
            escaping_lamps: 0.0,
            on_backs: 0.0,
            blockers: room.blockers().all().len(),
            emitters: 0,
            lamps: direct.lamps().all().len(),
            sums_all_lamps: direct.sums_all_lamps(),
            brightest: 0.0,
            mean_reflectance: 0.0,
            specular: 0,
            images: direct.images() - 1,
            bent: 0,
            sky: scene.sky.as_ref().is_some_and(Sky::shines),
            openings: direct.openings(),
            everywhere: None,
        };
        let mut mean = Rgb::ZERO;
        let mut specular = vec![None; scene.materials.len()];
        for (k, surface) in scene.surfaces.iter().enumerate() {
            let share = surface.polygon.area() / area;
            let of_power = if power > 0.0 { sent(k) / power } else { 0.0 };
            let rays = FEWEST_RAYS + (RAYS * (share + of_power)) as usize;
            let (escaping, on_back) = lost(visibility, &surface.polygon, k, rays);
            found.rays += rays;
            found.escaping += share * escaping;
            found.escaping_lamps += of_power * escaping;
            found.on_backs += share * on_back;
            let material = scene.material(surface);
            found.emitters += material.emits() as usize;
            found.brightest = found.brightest.max(material.scattered().max_element());
            mean += share * material.scattered();
            let shine = Some(material.shine()).filter(|shine| !shine.is_dull());
            specular[surface.material] = shine;
        }
        found.mean_reflectance = mean.max_element();
        found.specular = specular.iter().flatten().count();
        found.bent = specular.iter().flatten().filter(|shine| shine.bends()).count();
        let plain =
            found.specular == 0 && scene.surfaces.iter().all(|s| s.back.is_none());
        found.everywhere = everywhere(scene).filter(|_| plain && found.is_closed());
        found
    }

    /// Did no ray find a way out, or a back?
    pub fn is_closed(&self) -> bool {
        self.escaping == 0.0 && self.on_backs == 0.0
    }

    /// The share of reflected light that is reflected once more, about.
    pub fn kept(&self) -> f64 {
        self.mean_reflectance * (1.0 - self.escaping - self.on_backs).max(0.0)
    }

    /// How often light is reflected until less than `tolerance` of it is left.
    pub fn bounces(&self, tolerance: f64) -> f64 {
        match self.kept() {
            0.0 => 1.0,
            kept => (tolerance.ln() / kept.ln()).ceil().max(1.0),
        }
    }
}

/// The shares of rays from surface `k` that leave the scene, and that meet backs.
fn lost(all: &Visibility, polygon: &Polygon, k: usize, rays: usize) -> (f64, f64) {
    // ANCHOR: lost
    let frame = Frame::about(polygon.normal());
    let (mut escaped, mut backs) = (0, 0);
    for u in Stream::named(0, &[k as u64]).points(rays) {
        match all.closest(&ray_from(polygon, &frame, u), Some(k as u32)) {
            None => escaped += 1,
            Some(hit) if !hit.front => backs += 1,
            Some(_) => {}
        }
    }
    // ANCHOR_END: lost
    (escaped as f64 / rays as f64, backs as f64 / rays as f64)
}

/// `E/(1 − ρ)` where it is the same on all surfaces: then each sees what it is itself.
fn everywhere(scene: &Scene) -> Option<Rgb> {
    let of = |k: usize| {
        let material = scene.material(&scene.surfaces[k]);
        material.emission() / (Rgb::ONE - material.diffuse())
    };
    let first = (!scene.surfaces.is_empty()).then(|| of(0))?;
    let same = |k: usize| (of(k) - first).abs().max_element() <= 1e-12 * first.length();
    (0..scene.surfaces.len()).all(same).then_some(first)
}

/// What the scene is like when it is cut into patches of some size.
#[derive(Clone, Debug, PartialEq)]
pub struct Pieces {
    /// How many patches; more than the most that are allowed are not made.
    pub patches: usize,
    /// Their corners, from which hemicubes look.
    pub corners: usize,
    /// The share of pairs that face each other and are closer than 1.5 diameters.
    pub near: f64,
    /// The share of patches before which something may hide part of a lamp.
    pub shadowed: f64,
}

/// A patch is near when its middle is closer than this many diameters.
const NEAR: f64 = 1.5;

/// So many patches are asked for all others.
const ASKED: usize = 200;

/// So many patches are asked for blockers before lamps.
const ASKED_FOR_SHADOWS: usize = 2000;

impl Pieces {
    /// Cuts a scene into patches with edges of at most `edge`, scene units.
    pub fn of(room: &Room, edge: f64, most: usize) -> Pieces {
        let (scene, direct) = (room.scene, room.lamps());
        let count = Mesh::count_uniform(scene, edge);
        // More than will be made, or a mesh that no memory holds, is only counted.
        let coarse = (count / most as f64).sqrt().max(1.0);
        let mesh = Mesh::patched(scene, coarse * edge);
        let n = mesh.elements.len();
        let scale = coarse * coarse;
        let corners = mesh.places(0.0).iter().flatten().count();
        let (mut pairs, mut near) = (0usize, 0usize);
        for k in (0..n).step_by(n.div_ceil(ASKED).max(1)) {
            let patch = &mesh.elements[k].polygon;
            for other in mesh.polygons() {
                let above = |p: &Polygon, q: &Polygon| {
                    p.plane().height(q.centroid()) > 1e-9 * p.diameter()
                };
                if above(patch, other) && above(other, patch) {
                    let apart = patch.centroid().distance(other.centroid());
                    pairs += 1;
                    near += (apart < NEAR * other.diameter()) as usize;
                }
            }
        }
        let hidden = |p: &&Polygon| !direct.on(p).is_free();
        let asked = || mesh.polygons().step_by(n.div_ceil(ASKED_FOR_SHADOWS).max(1));
        let shadowed = asked().filter(hidden).count() as f64;
        Pieces {
            patches: (scale * n as f64) as usize,
            corners: (scale * corners as f64) as usize,
            near: near as f64 / pairs.max(1) as f64,
            shadowed: shadowed / asked().count().max(1) as f64,
        }
    }
}
