//! The media that a ray is in.

use super::Meeting;
use super::solids::Solids;
use crate::geometry::Ray;
use smallvec::SmallVec;

/// The solids that a ray is in: nothing is known of a ray that has just begun.
///
/// A solid counts as often as its boundary winds about the ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Media {
    /// In order, so that the last one holds the place.
    solids: Inside,
    known: bool,
}

/// Solids, in order; more than once where the same one overlaps itself.
type Inside = SmallVec<[u32; 4]>;

impl Media {
    /// Outside of all solids.
    fn air() -> Media {
        Media { solids: Inside::new(), known: true }
    }

    /// The solid that holds this place: the last one in the file.
    fn holder(&self) -> Option<u32> {
        self.solids.last().copied()
    }

    fn contains(&self, solid: u32) -> bool {
        self.solids.contains(&solid)
    }

    fn enter(&mut self, solid: u32) {
        let at = self.solids.partition_point(|&s| s <= solid);
        self.solids.insert(at, solid);
    }

    fn leave(&mut self, solid: u32) {
        if let Some(at) = self.solids.iter().position(|&s| s == solid) {
            self.solids.remove(at);
        }
    }
}

/// What a ray finds at the face of a solid.
pub(super) struct Crossing {
    /// The index of refraction on this side over that beyond; `None` where the same solid
    /// holds both sides, so that the face is not there for the ray.
    pub eta: Option<f64>,
    /// How many times what it is beyond radiance is on this side.
    pub denser: f64,
    /// The media beyond.
    pub after: Media,
}

impl Solids {
    /// What a ray finds that crosses the face of a solid; if it does not know yet what it
    /// is in, that is found.
    pub(super) fn cross(&self, met: &Meeting, media: &mut Media) -> Crossing {
        self.find(met, media);
        self.crossing(met, media)
    }

    /// The index of refraction before a surface that is no boundary of a solid.
    pub(super) fn index_here(&self, met: &Meeting, media: &mut Media) -> f64 {
        if self.is_empty() {
            return 1.0;
        }
        self.find(met, media);
        self.index(media)
    }

    // ANCHOR: crossing
    /// The same of a ray that knows what it is in.
    pub(super) fn crossing(&self, met: &Meeting, media: &Media) -> Crossing {
        let (mut before, mut after) = (media.clone(), media.clone());
        if self.in_plane(met.normal, met.origin, met.point) {
            return Crossing { eta: None, denser: 1.0, after }; // crossed where it began
        }
        for (solid, entering) in self.faces_at(met.face, met.outside, met.point) {
            let open = !self.is_closed(solid);
            match (entering, media.contains(solid)) {
                (true, true) if open => before.leave(solid),
                (true, _) => after.enter(solid),
                (false, true) => after.leave(solid),
                // Only rounding, or a hole, can have led the ray in.
                (false, false) => before.enter(solid),
            }
        }
        let same = before.holder() == after.holder();
        let eta = (!same).then(|| self.index(&before) / self.index(&after));
        let denser =
            (self.index_of_radiance(media) / self.index_of_radiance(&after)).powi(2);
        Crossing { eta, denser, after }
    }
    // ANCHOR_END: crossing

    /// The index of refraction of these media.
    fn index(&self, media: &Media) -> f64 {
        media.holder().map_or(1.0, |solid| self.index_of(solid))
    }

    /// The same as far as radiance is concerned: where a solid is open, light would come in
    /// by one index and go out by the other, and grow.
    fn index_of_radiance(&self, media: &Media) -> f64 {
        let closed = media.holder().filter(|&solid| self.is_closed(solid));
        closed.map_or(1.0, |solid| self.index_of(solid))
    }

    /// Finds what the ray is in that comes to this meeting.
    fn find(&self, met: &Meeting, media: &mut Media) {
        if media.known {
            return;
        }
        // Half way nothing is met: the media are those at its beginning.
        let origin = met.origin.midpoint(met.point);
        *media = self.around(&Ray { origin, direction: met.direction });
    }

    // ANCHOR: around
    /// The media about the origin of a ray that is on no face: of the closed solids, those
    /// that the ray leaves more often than it enters, on its way straight on.
    fn around(&self, ray: &Ray) -> Media {
        let mut media = Media::air();
        let near: SmallVec<[u32; 4]> = self.near(ray.origin).collect();
        if near.is_empty() {
            return media;
        }
        let mut winds: SmallVec<[i32; 4]> = near.iter().map(|_| 0).collect();
        self.along(ray, |solid, entering| {
            if let Some(k) = near.iter().position(|&s| s == solid) {
                winds[k] += if entering { -1 } else { 1 };
            }
        });
        for (&solid, &winds) in near.iter().zip(&winds) {
            (0..winds).for_each(|_| media.enter(solid));
        }
        media
    }
    // ANCHOR_END: around
}
