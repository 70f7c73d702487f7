//! What the other side of a face has in the same place.

use super::{Element, Mesh, wachspress};
use crate::geometry::Rgb;
use crate::scene::Scene;
use glam::DVec3;

/// Values at the vertices of one side of faces, from those of the other.
///
/// The two sides of a translucent sheet are meshed each for itself: where one has a vertex,
/// the other may have an element. Empty unless the scene has faces with two sides.
#[derive(Clone, Debug, Default)]
pub struct Backs {
    /// A vertex, another one in the same place or near it, and what it counts.
    shares: Vec<(u32, u32, f64)>,
}

impl Backs {
    /// Those of a mesh.
    pub fn of(scene: &Scene, mesh: &Mesh) -> Backs {
        let sided = |e: &Element| scene.surfaces[mesh.surface_of(e) as usize].back;
        let of_surface = mesh.elements_with_backs(scene);
        let mut done = vec![false; mesh.vertices.len()];
        let mut shares = Vec::new();
        for element in &mesh.elements {
            let Some(back) = sided(element) else { continue };
            for corner in element.corners.iter().map(|c| c.0) {
                if std::mem::replace(&mut done[corner as usize], true) {
                    continue;
                }
                let at = mesh.vertices[corner as usize];
                // A hair inside: on this side of the lines where others touch the face.
                let inside = at.lerp(element.polygon.centroid(), 1e-3);
                let other = mesh.nearest_of(&of_surface[back as usize], inside);
                let Some(other) = other.map(|k| &mesh.elements[k as usize]) else {
                    continue;
                };
                let weights = wachspress(&other.polygon, at);
                for (c, &weight) in other.corners.iter().zip(&weights) {
                    if weight > 1e-9 {
                        shares.push((corner, c.0, weight));
                    }
                }
            }
        }
        Backs { shares }
    }

    /// Has no face two sides?
    pub fn is_empty(&self) -> bool {
        self.shares.is_empty()
    }

    /// For each vertex, the value on the other side; 0 where there is none.
    pub fn apply(&self, of_vertices: &[Rgb]) -> Vec<Rgb> {
        let mut values = vec![Rgb::ZERO; of_vertices.len()];
        for &(vertex, other, weight) in &self.shares {
            values[vertex as usize] += weight * of_vertices[other as usize];
        }
        values
    }
}

impl Mesh {
    /// Marks for splitting, of faces with two sides, what lies behind all that is marked: so
    /// that the light of either side is shown on elements that suit it.
    pub fn mark_backs(&self, scene: &Scene, marks: &mut [bool]) {
        if scene.surfaces.iter().all(|s| s.back.is_none()) {
            return;
        }
        let of_surface = self.elements_with_backs(scene);
        let marked: Vec<usize> = (0..marks.len()).filter(|&k| marks[k]).collect();
        for element in marked.into_iter().map(|k| &self.elements[k]) {
            let back = scene.surfaces[self.surface_of(element) as usize].back;
            let Some(back) = back else { continue };
            let at = element.polygon.centroid();
            if let Some(other) = self.nearest_of(&of_surface[back as usize], at) {
                marks[other as usize] = true;
            }
        }
    }

    /// For each surface that has another side its elements; none for the others.
    fn elements_with_backs(&self, scene: &Scene) -> Vec<Vec<u32>> {
        let mut of_surface: Vec<Vec<u32>> = vec![Vec::new(); scene.surfaces.len()];
        for (k, element) in (0u32..).zip(&self.elements) {
            let surface = self.surface_of(element) as usize;
            if scene.surfaces[surface].back.is_some() {
                of_surface[surface].push(k);
            }
        }
        of_surface
    }

    /// Of some elements of one surface, the one that holds `p`, or comes nearest to it.
    pub fn nearest_of(&self, elements: &[u32], p: DVec3) -> Option<u32> {
        let outside = |k: u32| self.elements[k as usize].polygon.distance_outside(p);
        let mut best = None;
        for &k in elements {
            let d = outside(k);
            if best.is_none_or(|(_, least)| d < least) {
                best = Some((k, d));
            }
        }
        best.map(|(k, _)| k)
    }
}
