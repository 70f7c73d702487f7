//! Extended form factors by rays that go on where they meet a mirror or a pane.

use super::VirtualWorld;
use super::books::{Books, RowMet};
use crate::form_factor::{FormFactors, Lost, ray_from};
use crate::geometry::{Frame, Plane, Polygon, Ray};
use crate::mesh::{ElementId, Mesh};
use crate::random::Stream;
use crate::visibility::Visibility;

/// Rays that are followed through a virtual world; otherwise as
/// [`crate::form_factor::cast::Cast`].
///
/// At a pane a ray divides, so that no chance decides which way it goes. The standard error
/// of a factor is that of plain rays, or less.
#[derive(Debug)]
pub struct ExtendedCast<'a> {
    mesh: &'a Mesh,
    world: &'a VirtualWorld,
    visibility: Visibility,
    channel: usize,
    rays: usize,
    seed: u64,
}

/// A ray on its way.
struct MirroredLeg {
    ray: Ray,
    leaving: u32,
    share: f64,
    left: u32,
}

impl<'a> ExtendedCast<'a> {
    /// Factors of this `channel` (0, 1 or 2) by so many rays from each element.
    pub fn new(
        mesh: &'a Mesh,
        world: &'a VirtualWorld,
        channel: usize,
        rays: usize,
        seed: u64,
    ) -> ExtendedCast<'a> {
        assert!(rays > 0, "rays must be positive");
        let visibility = Visibility::new(mesh.polygons());
        ExtendedCast { mesh, world, visibility, channel, rays, seed }
    }

    /// Follows what leaves `element` along `ray` until nothing is left of it.
    fn follow(&self, ray: Ray, element: u32, share: f64, books: &mut Books) {
        let mut legs = vec![MirroredLeg {
            ray,
            leaving: element,
            share,
            left: self.world.levels(),
        }];
        while let Some(MirroredLeg { ray, leaving, share, left }) = legs.pop() {
            let Some(hit) = self.visibility.closest(&ray, Some(leaving)) else {
                books.lost.escaped += share;
                continue;
            };
            let polygon: &Polygon = &self.mesh.elements[hit.item as usize].polygon;
            let cosine = polygon.normal().dot(ray.direction).abs();
            let met = RowMet { element: hit.item, front: hit.front, cosine };
            let [mirrored, passed] = books.arrives(share, met, left);
            let origin = ray.origin + hit.distance * ray.direction;
            if passed > 0.0 {
                let ray = Ray { origin, direction: ray.direction };
                legs.push(MirroredLeg { ray, leaving: hit.item, share: passed, left });
            }
            if mirrored > 0.0 {
                let mirror = Plane::through(origin, polygon.normal()).mirror();
                let direction = mirror.transform_vector3(ray.direction);
                let ray = Ray { origin, direction };
                legs.push(MirroredLeg {
                    ray,
                    leaving: hit.item,
                    share: mirrored,
                    left: left - 1,
                });
            }
        }
    }
}

impl FormFactors for ExtendedCast<'_> {
    fn len(&self) -> usize {
        self.mesh.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        row.fill(0.0);
        let element = &self.mesh.element(from).polygon;
        let frame = Frame::about(element.normal());
        let (world, mesh, channel) = (self.world, self.mesh, self.channel);
        let mut books = Books { world, mesh, channel, row, lost: Lost::default() };
        let share = 1.0 / self.rays as f64;
        for u in Stream::named(self.seed, &[from.0 as u64]).points(self.rays) {
            self.follow(ray_from(element, &frame, u), from.0, share, &mut books);
        }
        books.lost
    }
}
