//! One chain of mirrors, and the image of the world in it.

use super::{Mirror, VirtualWorld};
use crate::geometry::{Outline, Plane, Polygon, Rgb};
use crate::occlusion::{Shaft, inside};
use glam::{DAffine3, DVec3};

/// The world as it is seen in a chain of mirrors.
#[derive(Clone, Debug)]
pub struct Image {
    /// The mirrors, as indices into [`VirtualWorld::mirrors`], in the order in which a line
    /// of sight meets them. Empty: the world itself.
    pub mirrors: Vec<u32>,
    /// `R₁ … R_l` for `l = 0 … k`: takes the world of each leg to where it is seen.
    legs: Vec<DAffine3>,
    /// The outlines through which it is seen, each where it is seen itself.
    windows: Vec<Polygon>,
}

impl Image {
    /// The world itself.
    pub(super) fn identity() -> Image {
        let legs = vec![DAffine3::IDENTITY];
        Image { mirrors: Vec::new(), legs, windows: Vec::new() }
    }

    /// This chain and one more mirror behind it; `None` when no line can pass.
    pub(super) fn then(
        &self,
        mirrors: &[Mirror],
        k: usize,
        margin: f64,
    ) -> Option<Image> {
        let mirror = &mirrors[k];
        let mut outline = mirror.outline.clone();
        if let Some(&last) = self.mirrors.last() {
            let last = &mirrors[last as usize].outline;
            let sees = |p: &Polygon, q: &Polygon| {
                q.vertices().iter().any(|&v| p.plane().height(v) > margin)
            };
            if !sees(last, &outline) || !sees(&outline, last) {
                return None;
            }
            outline = outline.clipped(last.plane())?;
        }
        let window = outline.moved(self.transform());
        if let [.., before, last] = &self.windows[..] {
            // A line from the window before to the new one must pass the last one.
            let shaft = Shaft::between(&before.flipped(), &window, margin);
            if shaft.misses_all(last.vertices()) {
                return None;
            }
        }
        // ANCHOR: chain
        let mut image = self.clone();
        image.mirrors.push(k as u32);
        image.legs.push(*self.transform() * mirror.outline.plane().mirror());
        image.windows.push(window);
        Some(image)
        // ANCHOR_END: chain
    }

    /// How many reflections.
    pub fn level(&self) -> u32 {
        self.mirrors.len() as u32
    }

    /// Takes each point of the world to where it is seen: `R₁ R₂ … R_k`.
    pub fn transform(&self) -> &DAffine3 {
        &self.legs[self.mirrors.len()]
    }

    /// The transforms of all legs, from the world itself to [`Image::transform`].
    pub(super) fn legs(&self) -> &[DAffine3] {
        &self.legs
    }

    /// Where the point is seen.
    pub fn of_point(&self, p: DVec3) -> DVec3 {
        self.transform().transform_point3(p)
    }

    /// Where the polygon is seen; its front is its front.
    pub fn of_polygon(&self, polygon: &Polygon) -> Polygon {
        polygon.moved(self.transform())
    }

    /// The outlines through which the image is seen, in order; they look at the viewer.
    pub fn windows(&self) -> &[Polygon] {
        &self.windows
    }

    /// The product of the mirrors' shares along a line of this direction (unit length),
    /// from the viewer on; per channel, in `[0, 1]`.
    pub fn reflectance(&self, world: &VirtualWorld, direction: DVec3) -> Rgb {
        let of = |(&k, window): (&u32, &Polygon)| {
            let cosine = direction.dot(window.normal()).abs();
            world.mirrors()[k as usize].reflectance(cosine)
        };
        self.mirrors.iter().zip(&self.windows).map(of).product()
    }

    /// An upper bound of [`Image::reflectance`].
    pub fn most(&self, world: &VirtualWorld) -> Rgb {
        self.mirrors.iter().map(|&k| world.mirrors()[k as usize].most()).product()
    }

    /// What of an image the point `x` sees through all windows: `outline` lies in the image,
    /// already cut to what is behind the last window. `None` when nothing is seen, also when
    /// `x` is behind a window or in its plane.
    pub fn clip(&self, x: DVec3, outline: &[DVec3]) -> Option<Outline> {
        clip_to(&self.windows, x, outline)
    }
}

/// What of `outline` is seen from `x` through all `windows`.
pub(super) fn clip_to<'a>(
    windows: impl IntoIterator<Item = &'a Polygon>,
    x: DVec3,
    outline: &[DVec3],
) -> Option<Outline> {
    let mut seen = Outline::from(outline);
    // ANCHOR: clip_to
    for window in windows {
        if window.plane().height(x) <= 0.0 {
            return None;
        }
        let planes: Vec<Plane> = pyramid(x, window.vertices()).collect();
        seen = inside(&seen, &planes);
        if seen.len() < 3 {
            return None;
        }
    }
    // ANCHOR_END: clip_to
    Some(seen)
}

/// The planes through `x` and the edges of an outline that looks at it, facing inwards; not
/// of unit length.
pub(super) fn pyramid(x: DVec3, outline: &[DVec3]) -> impl Iterator<Item = Plane> {
    // ANCHOR: pyramid
    let edge = move |k: usize| {
        let (a, b) = (outline[k], outline[(k + 1) % outline.len()]);
        let normal = (b - x).cross(a - x);
        Plane { normal, offset: normal.dot(x) }
    };
    (0..outline.len()).map(edge)
    // ANCHOR_END: pyramid
}
