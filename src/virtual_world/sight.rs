//! What a piece of a surface may see of a polygon by one image.

use super::image::{clip_to, pyramid};
use super::{Image, Pane, VirtualWorld};
use crate::geometry::{Outline, Plane, Polygon, Rgb};
use crate::occlusion::{Blocker, Shaft, lambert_visible, parted, visible_parts};
use crate::radiometry::projected_solid_angle;
use glam::{DAffine3, DMat3, DVec3};
use smallvec::SmallVec;
use std::borrow::Cow;
use std::f64::consts::PI;

/// A polygon as a piece of a surface may see it by one image: where it seems to be, through
/// which windows, past what, behind which panes.
#[derive(Clone, Debug)]
pub struct Sight {
    /// The image, less what lies on the wrong side of the last mirror.
    target: Polygon,
    /// Those windows whose edges may cut off some of it.
    windows: Vec<Polygon>,
    blockers: Vec<Blocker>,
    /// What passes and what is mirrored, where that depends on the angle.
    by_angle: Vec<ByAngle>,
    veils: Vec<Veil>,
    /// What the mirrors send on whatever the angle.
    pub(super) reflectance: Rgb,
    level: u32,
    /// Takes directions of sight to those of the world itself.
    folded: DMat3,
}

/// A mirror whose share depends on the angle.
#[derive(Clone, Debug)]
struct ByAngle {
    normal: DVec3,
    mirror: super::Mirror,
}

/// A pane where it is seen; only what lies behind it is weakened.
#[derive(Clone, Debug)]
struct Veil {
    outline: Polygon,
    pane: Pane,
}

impl VirtualWorld {
    /// All ways in which points of `piece` may see some of the front of `target`: directly,
    /// and by each image. Of the world only what may matter is kept.
    pub fn sights(&self, piece: &Polygon, target: &Polygon) -> Vec<Sight> {
        self.images
            .iter()
            .filter_map(|image| self.sight(image, piece, target))
            .collect()
    }

    /// How points of `piece` may see some of `target` by this image.
    pub fn sight(
        &self,
        image: &Image,
        piece: &Polygon,
        target: &Polygon,
    ) -> Option<Sight> {
        let above = |p: &Polygon, q: &Polygon| {
            q.vertices().iter().any(|&v| p.plane().height(v) > self.margin)
        };
        let seen = image.of_polygon(target);
        if !above(&seen, piece) || !above(piece, &seen) {
            return None;
        }
        let mut windows = image.windows().iter();
        if !windows.all(|w| above(w, piece) && above(&w.flipped(), &seen)) {
            return None;
        }
        let seen = match image.windows().last() {
            Some(window) => seen.clipped(window.plane().flipped())?,
            None => seen,
        };
        let shaft = Shaft::between(piece, &seen, self.margin);
        if image.windows().iter().any(|w| shaft.misses_all(w.vertices())) {
            return None;
        }
        let cuts = |w: &&Polygon| !surrounds(w, piece, &seen, self.margin);
        let windows = image.windows().iter().filter(cuts).cloned().collect();
        let mut sight = Sight {
            target: seen,
            windows,
            blockers: Vec::new(),
            by_angle: Vec::new(),
            veils: Vec::new(),
            reflectance: Rgb::ONE,
            level: image.level(),
            folded: image.transform().matrix3.transpose(),
        };
        self.add_mirrors(image, &mut sight);
        for leg in 0..=image.mirrors.len() {
            let (blockers, veils) = self.on_leg(image, leg, piece, target);
            sight.blockers.extend(blockers);
            sight.veils.extend(veils);
        }
        (!sight.is_hidden(piece)).then_some(sight)
    }

    fn add_mirrors(&self, image: &Image, sight: &mut Sight) {
        for (&k, window) in image.mirrors.iter().zip(image.windows()) {
            let mirror = &self.mirrors[k as usize];
            if mirror.pane.is_none() {
                sight.reflectance *= mirror.most();
            } else {
                let (normal, mirror) = (window.normal(), mirror.clone());
                sight.by_angle.push(ByAngle { normal, mirror });
            }
        }
    }

    /// What may stand in the way on one leg, between the mirrors at its ends, moved to where
    /// it is seen: what hides, and panes.
    fn on_leg(
        &self,
        image: &Image,
        leg: usize,
        piece: &Polygon,
        target: &Polygon,
    ) -> (Vec<Blocker>, Vec<Veil>) {
        let mirror = |k: usize| &self.mirrors[image.mirrors[k] as usize].outline;
        let unfold = &image.legs()[leg];
        let from = piece.moved(&unfold.inverse());
        let to = if leg < image.mirrors.len() { mirror(leg) } else { target };
        let ends = [leg.checked_sub(1), (leg < image.mirrors.len()).then_some(leg)];
        let ends: Vec<Plane> =
            ends.into_iter().flatten().map(|k| mirror(k).plane()).collect();
        // ANCHOR: leg
        let mut found: Vec<Blocker> =
            self.blockers.between(&from, to).into_iter().cloned().collect();
        for &end in &ends {
            found = found.iter().flat_map(|b| b.in_front(end, self.margin)).collect();
        }
        let blockers = found.iter().map(|b| b.moved(unfold)).collect();
        // ANCHOR_END: leg
        if self.panes.is_empty() {
            return (blockers, Vec::new());
        }
        let last = leg == image.mirrors.len();
        let before = last.then(|| target.plane());
        let shaft = Shaft::between(&from, to, self.margin);
        (blockers, self.veils(&shaft, &ends, before, unfold))
    }

    /// The panes in the shaft of a leg, between the mirrors at its `ends` and, on the
    /// last leg, before the plane of the target.
    fn veils(
        &self,
        shaft: &Shaft,
        ends: &[Plane],
        before: Option<Plane>,
        unfold: &DAffine3,
    ) -> Vec<Veil> {
        let mut veils = Vec::new();
        for pane in &self.panes {
            let mut rest = Some(self.standing_before(&pane.outline, before));
            for &end in ends.iter().chain(&before) {
                let high = |v: &DVec3| end.height(*v) > self.margin;
                rest = rest
                    .filter(|p| p.vertices().iter().any(high))
                    .and_then(|p| p.clipped(end));
            }
            let Some(rest) = rest.filter(|p| !shaft.misses_all(p.vertices())) else {
                continue;
            };
            veils.push(Veil { outline: rest.moved(unfold), pane: pane.clone() });
        }
        veils
    }

    /// A pane that lies in the plane of a target stands a hair before it, as one that fills
    /// an opening: light passes both.
    fn standing_before(&self, pane: &Polygon, target: Option<Plane>) -> Polygon {
        let flush = |plane: &Plane| {
            pane.vertices().iter().all(|&v| plane.height(v).abs() <= self.margin)
        };
        target.filter(flush).map_or_else(
            || pane.clone(),
            |plane| {
                let hair = 2.0 * self.margin * plane.normal;
                pane.moved(&DAffine3::from_translation(hair))
            },
        )
    }
}

/// Does every line from one polygon to the other pass the window?
fn surrounds(window: &Polygon, piece: &Polygon, seen: &Polygon, margin: f64) -> bool {
    let plane = window.plane();
    let passes = |&a: &DVec3, &b: &DVec3| {
        let (ha, hb) = (plane.height(a).max(0.0), plane.height(b).min(0.0));
        let at = if ha > hb { ha / (ha - hb) } else { 0.0 };
        window.contains(a + at * (b - a), margin)
    };
    let above = piece.vertices().iter().all(|&v| plane.height(v) >= -margin);
    let from = piece.vertices();
    above && from.iter().all(|a| seen.vertices().iter().all(|b| passes(a, b)))
}

impl Sight {
    /// How many reflections.
    pub fn level(&self) -> u32 {
        self.level
    }

    /// The image, less what lies on the wrong side of the last mirror.
    pub fn target(&self) -> &Polygon {
        &self.target
    }

    /// Can nothing cut off or hide any of the image?
    pub fn is_free(&self) -> bool {
        self.blockers.is_empty() && self.windows.is_empty() && self.veils.is_empty()
    }

    /// Is the share the same at all angles?
    pub(super) fn is_even(&self) -> bool {
        self.veils.is_empty() && self.by_angle.is_empty()
    }

    /// Does one blocker hide all from all of `piece`?
    fn is_hidden(&self, piece: &Polygon) -> bool {
        self.blockers.iter().any(|b| b.hides_all(piece, &self.target))
    }

    /// Form factor from a differential area at `x`, a point of the piece, with unit normal
    /// `n`, times what the mirrors and panes leave: per channel, in `[0, 1]`.
    ///
    /// # Accuracy
    /// Rounding; about 1e-4 of it where Fresnel's law weighs it, and to 2e-3 a hair away.
    pub fn factor(&self, x: DVec3, n: DVec3) -> Rgb {
        let Some(seen) = self.through_windows(x) else { return Rgb::ZERO };
        let blockers: SmallVec<[&Blocker; 8]> = self.blockers.iter().collect();
        if self.is_even() {
            return self.reflectance * lambert_visible(x, n, &seen, &blockers);
        }
        self.integral(x, n, &seen, &|_| Rgb::ONE)
    }

    /// Irradiance, W/m², of what is behind the target: `radiance`, in W/(m² sr), in each
    /// direction of the world itself, as light of the sky is.
    ///
    /// # Accuracy
    /// About 1e-4 of it where radiance is smooth and about 1; edges of radiance are found to
    /// a 64th of the target.
    pub fn irradiance(
        &self,
        x: DVec3,
        n: DVec3,
        radiance: &dyn Fn(DVec3) -> Rgb,
    ) -> Rgb {
        let Some(seen) = self.through_windows(x) else { return Rgb::ZERO };
        let in_world = |d: DVec3| radiance(self.folded * d);
        PI * self.integral(x, n, &seen, &in_world)
    }

    /// What of the target lies behind all windows.
    fn through_windows(&self, x: DVec3) -> Option<Cow<'_, Polygon>> {
        if self.windows.is_empty() {
            return Some(Cow::Borrowed(&self.target));
        }
        let seen = clip_to(&self.windows, x, self.target.vertices())?;
        Polygon::piece(seen.to_vec(), self.target.normal()).map(Cow::Owned)
    }

    /// `1/π ∫ radiance · share · cosθ dω` over what is not hidden.
    fn integral(
        &self,
        x: DVec3,
        n: DVec3,
        seen: &Polygon,
        radiance: &dyn Fn(DVec3) -> Rgb,
    ) -> Rgb {
        if seen.plane().height(x) <= 0.0 {
            return Rgb::ZERO;
        }
        let blockers: SmallVec<[&Blocker; 8]> = self.blockers.iter().collect();
        let parts = visible_parts(x, seen, &blockers);
        let weighed = |part| self.weighed(x, n, part, radiance);
        self.reflectance * parts.into_iter().map(weighed).sum::<Rgb>()
    }

    /// The factor to `part`, seen past blockers: parted by the first veil, then the next.
    fn weighed(
        &self,
        x: DVec3,
        n: DVec3,
        part: Outline,
        radiance: &dyn Fn(DVec3) -> Rgb,
    ) -> Rgb {
        let mut behind: Vec<(Outline, Vec<&Veil>)> = vec![(part, Vec::new())];
        for veil in &self.veils {
            for (part, through) in std::mem::take(&mut behind) {
                let cone = veil.cone(x);
                let (veiled, clear) = parted(part, &cone);
                behind.extend(clear.into_iter().map(|p| (p, through.clone())));
                if veiled.len() >= 3 {
                    let mut through = through;
                    through.push(veil);
                    behind.push((veiled, through));
                }
            }
        }
        let of = |(part, through): &(Outline, Vec<&Veil>)| {
            let share = |d: DVec3| radiance(d) * self.share(d, through);
            let seen: Outline = part.iter().map(|&v| towards(v - x, n)).collect();
            integrated(n, &seen, &share, DEEPEST)
        };
        behind.iter().map(of).sum()
    }

    /// What is left of light of this direction behind these veils.
    fn share(&self, direction: DVec3, through: &[&Veil]) -> Rgb {
        let cosine = |normal: DVec3| direction.dot(normal).abs().min(1.0);
        let mirrored = |m: &ByAngle| m.mirror.reflectance(cosine(m.normal));
        let passed = |v: &&Veil| v.pane.transmittance(cosine(v.outline.normal()));
        self.by_angle.iter().map(mirrored).product::<Rgb>()
            * through.iter().map(passed).product::<Rgb>()
    }
}

impl Veil {
    /// The pyramid from `x` over the pane.
    fn cone(&self, x: DVec3) -> Vec<Plane> {
        let front = self.outline.plane().height(x) > 0.0;
        let outline = if front { self.outline.clone() } else { self.outline.flipped() };
        pyramid(x, outline.vertices()).collect()
    }
}

/// A piece is quartered at most this often.
const DEEPEST: u32 = 6;

/// A share that varies less than this over a piece is taken as quadratic there.
const EVEN: f64 = 2e-3;

/// The cosine of the angle between two corners of a piece over which nothing is taken as even:
/// of a target a hair away all corners lie at the horizon, and all of the light does not.
const WIDE: f64 = 0.5;

/// A normal lies in a cone if it is so far inside, in radians; its corner is not.
const INSIDE: f64 = 1e-9;

/// `1/π ∫ share cosθ dω` over the convex cone between these unit directions. If it is wide and
/// the normal lies in it, it is parted there.
fn integrated(
    n: DVec3,
    outline: &[DVec3],
    share: &dyn Fn(DVec3) -> Rgb,
    depth: u32,
) -> Rgb {
    let corners = outline.len();
    let next = |k: usize| outline[(k + 1) % corners];
    let left = |k: usize| outline[k].cross(next(k)).dot(n);
    let all = |side: f64| (0..corners).all(|k| side * left(k) > INSIDE);
    let about = all(1.0) || all(-1.0);
    let wide = (0..corners).any(|k| outline[k].dot(next(k)) < WIDE);
    let middle = if wide && about { n } else { towards(outline.iter().sum(), n) };
    let mean = outline.iter().map(|&v| share(v)).sum::<Rgb>() / corners as f64;
    let here = share(middle);
    if depth == 0 || !wide && (here - mean).abs().max_element() <= EVEN {
        let factor = projected_solid_angle(DVec3::ZERO, n, outline) / PI;
        return factor * (0.75 * here + 0.25 * mean);
    }
    let between = |a: DVec3, b: DVec3| towards(a + b, n);
    let corner = |k: usize| {
        let (before, a) = (outline[(k + corners - 1) % corners], outline[k]);
        [between(before, a), a, between(a, next(k)), middle]
    };
    (0..corners).map(|k| integrated(n, &corner(k), share, depth - 1)).sum()
}

/// The unit direction of `v`; the normal where it has none.
fn towards(v: DVec3, n: DVec3) -> DVec3 {
    v.try_normalize().unwrap_or(n)
}
