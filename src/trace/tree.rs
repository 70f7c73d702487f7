//! The tree of rays: what shiny surfaces make of one ray, followed branch by branch.

use crate::geometry::{Ray, Rgb};
use crate::material::optics::{fresnel, pane, reflect, refract};
use crate::material::{Material, Shine};
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::DVec3;
use smallvec::SmallVec;

/// How far rays are followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// So often one may be mirrored, refracted, passed on or scattered by gloss.
    pub depth: u32,
    /// Branches that count less than this in the picture are cut.
    pub weight: f64,
}

impl Default for Limits {
    /// Twenty-four times, and a five-hundredth.
    fn default() -> Limits {
        Limits { depth: 24, weight: 0.002 }
    }
}

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// Which of [`Scene::surfaces`].
    pub surface: u32,
    pub point: DVec3,
    /// Of the ray, of unit length.
    pub direction: DVec3,
    /// Is it the front that is met?
    pub front: bool,
}

/// How a ray came to where it is.
#[derive(Clone, Debug)]
pub(super) struct Journey {
    /// What its light counts in the picture: the product of all shares.
    pub weight: Rgb,
    /// Of how many rays, sent instead of one, it is one: none is too faint for that.
    pub one_of: f64,
    /// How often it was sent on.
    pub depth: u32,
    /// The indices of the solids that it is in, the innermost last.
    pub inside: SmallVec<[f64; 4]>,
    /// Are lamps that it meets next dark, because their light is counted already?
    pub lamps_are_counted: bool,
}

impl Journey {
    /// That of a ray from the eye.
    pub(super) fn start() -> Journey {
        let inside = SmallVec::new();
        let (weight, one_of) = (Rgb::ONE, 1.0);
        Journey { weight, one_of, depth: 0, inside, lamps_are_counted: false }
    }
}

/// One way on from a surface.
#[derive(Debug)]
struct Branch {
    direction: DVec3,
    /// What the light that comes from there counts.
    share: Rgb,
    /// By how much Snell's law thins its radiance: `(n here / n there)²`.
    thinner: f64,
    inside: SmallVec<[f64; 4]>,
}

/// What is counted while a sample of a pixel is traced, and what its random numbers are
/// called.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    pub rays: u64,
    /// The weights of the branches that were cut.
    pub cut: Rgb,
    pub seed: u64,
    pub pixel: u64,
    pub sample: u64,
    /// How often this sample has drawn points.
    pub draws: u64,
}

impl Tally {
    /// `n` points of the unit square. Those that a sample draws first go on where the
    /// sample of the pixel before it ended, so that a pixel's samples share the work.
    pub(super) fn points(
        &mut self,
        n: usize,
    ) -> impl Iterator<Item = [f64; 2]> + use<> {
        self.draws += 1;
        let first = self.draws == 1;
        let name = [self.pixel, if first { 0 } else { self.draws }, self.sample];
        let skipped = if first { n * self.sample as usize } else { 0 };
        let name = if first { &name[..1] } else { &name[..] };
        Stream::named(self.seed, name).points(skipped + n).skip(skipped)
    }

    /// A number in `[0, 1)`; those of a pixel's samples lie evenly.
    pub(super) fn offset(&self) -> f64 {
        let shift = Stream::named(self.seed, &[self.pixel, self.draws]).next();
        (shift + self.sample as f64 * GOLDEN).fract()
    }
}

/// Multiples of it leave no gap, modulo 1, for long.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// A scene, ready to follow rays through.
pub(super) struct Tree<'s> {
    pub scene: &'s Scene,
    pub visibility: Visibility,
    pub limits: Limits,
}

/// What a surface sends along a ray without mirroring or passing any: its diffuse light,
/// and its gloss.
pub(super) type Shade<'a> = &'a dyn Fn(&Meeting, &Journey, &mut Tally) -> Rgb;

impl<'s> Tree<'s> {
    pub(super) fn of(scene: &'s Scene, limits: Limits) -> Tree<'s> {
        let visibility = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
        Tree { scene, visibility, limits }
    }

    pub(super) fn material(&self, surface: u32) -> &'s Material {
        self.scene.material(&self.scene.surfaces[surface as usize])
    }

    /// The radiance, W/(m² sr), that comes against a ray.
    pub(super) fn arriving(
        &self,
        (ray, leaving): (&Ray, Option<u32>),
        journey: &Journey,
        tally: &mut Tally,
        shade: Shade,
    ) -> Rgb {
        // ANCHOR: arriving
        tally.rays += 1;
        let Some(hit) = self.visibility.closest(ray, leaving) else {
            return self.sky(ray.direction);
        };
        let point = ray.origin + hit.distance * ray.direction;
        let (surface, direction, front) = (hit.item, ray.direction, hit.front);
        let at = Meeting { surface, point, direction, front };
        self.leaving(&at, journey, tally, shade)
        // ANCHOR_END: arriving
    }

    /// What a ray finds that leaves the scene.
    pub(super) fn sky(&self, direction: DVec3) -> Rgb {
        self.scene.sky.as_ref().map_or(Rgb::ZERO, |sky| sky.radiance(direction))
    }

    /// The radiance, W/(m² sr), that leaves a surface against the ray that meets it.
    pub(super) fn leaving(
        &self,
        at: &Meeting,
        journey: &Journey,
        tally: &mut Tally,
        shade: Shade,
    ) -> Rgb {
        // ANCHOR: leaving
        let mut sum = shade(at, journey, tally);
        for Branch { direction, share, thinner, inside } in
            self.branches(at, &journey.inside)
        {
            let Some(on) = self.sent_on(journey, share, inside, tally) else {
                continue;
            };
            let ray = Ray { origin: at.point, direction };
            let from = (&ray, Some(at.surface));
            sum += thinner * share * self.arriving(from, &on, tally, shade);
        }
        sum
        // ANCHOR_END: leaving
    }

    /// The journey after a bounce that keeps this share, unless it is cut.
    pub(super) fn sent_on(
        &self,
        journey: &Journey,
        share: Rgb,
        inside: SmallVec<[f64; 4]>,
        tally: &mut Tally,
    ) -> Option<Journey> {
        // ANCHOR: sent_on
        let (weight, depth) = (journey.weight * share, journey.depth + 1);
        let one_of = journey.one_of;
        let faint = one_of * weight.max_element() < self.limits.weight;
        if faint || depth > self.limits.depth {
            tally.cut += weight;
            return None;
        }
        Some(Journey { weight, one_of, depth, inside, lamps_are_counted: false })
        // ANCHOR_END: sent_on
    }

    /// The single directions from which light reaches the eye by way of `at`.
    fn branches(
        &self,
        at: &Meeting,
        inside: &SmallVec<[f64; 4]>,
    ) -> SmallVec<[Branch; 2]> {
        let surface = &self.scene.surfaces[at.surface as usize];
        let material = self.scene.material(surface);
        let front = surface.polygon.normal();
        let normal = if at.front { front } else { -front };
        let cosine = (-at.direction.dot(normal)).clamp(0.0, 1.0);
        let branch = |direction, share| Branch {
            direction,
            share,
            thinner: 1.0,
            inside: inside.clone(),
        };
        let mirrored = |share| branch(reflect(at.direction, normal), share);
        let s = material.smooth_share();
        let mut all: SmallVec<[Branch; 2]> = SmallVec::new();
        match material.shine() {
            Shine::Mirror { reflectance } if at.front => {
                all.push(mirrored(reflectance));
            }
            Shine::Pane { index, tint } => {
                let (r, t) = pane(cosine, index);
                all.extend([mirrored(r * s), branch(at.direction, t * s * tint)]);
            }
            Shine::Glass { index, tint } => {
                let (here, beyond, after) = across(index, at.front, inside);
                let eta = here / beyond;
                let r = fresnel(cosine, eta).mean();
                all.push(mirrored(r * s));
                if let Some(direction) = refract(at.direction, normal, eta) {
                    let (share, thinner) = ((1.0 - r) * s * tint, eta * eta);
                    all.push(Branch { direction, share, thinner, inside: after });
                }
            }
            Shine::Dull | Shine::Mirror { .. } | Shine::Gloss { .. } => {}
        }
        all.retain(|branch| branch.share != Rgb::ZERO);
        all
    }
}

/// The indices before and behind a face of a solid, and those of the solids that a ray is
/// in behind it.
fn across(
    index: f64,
    entering: bool,
    inside: &SmallVec<[f64; 4]>,
) -> (f64, f64, SmallVec<[f64; 4]>) {
    // ANCHOR: across
    let innermost = |inside: &[f64]| inside.last().copied().unwrap_or(1.0);
    let mut after = inside.clone();
    if entering {
        after.push(index);
        return (innermost(inside), index, after);
    }
    if let Some(k) = after.iter().rposition(|&n| n == index) {
        after.remove(k); // else the eye began in here
    }
    (index, innermost(&after), after)
    // ANCHOR_END: across
}
