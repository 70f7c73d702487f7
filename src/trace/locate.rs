//! Which element of a mesh holds a point of a surface?

use crate::geometry::Frame;
use crate::mesh::{ElementId, Mesh};
use crate::scene::Scene;
use glam::{DVec2, DVec3, dvec2};

/// The elements of each surface, in a grid of cells of its plane.
#[derive(Clone, Debug)]
pub(super) struct Locate {
    grids: Vec<SurfaceGrid>,
}

/// Cells of one surface, about as many as it has elements.
#[derive(Clone, Debug)]
struct SurfaceGrid {
    frame: Frame,
    low: DVec2,
    /// Cells for each scene unit.
    scale: DVec2,
    cells: [usize; 2],
    /// Where the elements of each cell begin in `elements`; one more at the end.
    starts: Vec<u32>,
    elements: Vec<u32>,
}

impl Locate {
    pub(super) fn of(scene: &Scene, mesh: &Mesh) -> Locate {
        let mut of_surface = vec![Vec::new(); scene.surfaces.len()];
        for (id, element) in (0u32..).zip(&mesh.elements) {
            of_surface[mesh.surface_of(element) as usize].push(id);
        }
        let surfaces = scene.surfaces.iter().zip(&of_surface);
        let grid = |(surface, elements): (&crate::scene::Surface, &Vec<u32>)| {
            SurfaceGrid::of(Frame::about(surface.polygon.normal()), mesh, elements)
        };
        Locate { grids: surfaces.map(grid).collect() }
    }

    /// The element of `surface` at `point`, or the nearest to it; `None` where the
    /// surface has none.
    pub(super) fn element(
        &self,
        mesh: &Mesh,
        surface: u32,
        point: DVec3,
    ) -> Option<ElementId> {
        let grid = &self.grids[surface as usize];
        let outside = |&id: &u32| {
            // How far outside of its edges: at most 0 inside.
            let polygon = &mesh.elements[id as usize].polygon;
            let off = |(a, b): (DVec3, DVec3)| {
                let across = polygon.normal().cross(b - a);
                across.dot(a - point) / across.length()
            };
            polygon.edges().map(off).fold(f64::NEG_INFINITY, f64::max)
        };
        let here = grid.at(point);
        if let Some(&id) = here.iter().find(|id| outside(id) <= 0.0) {
            return Some(ElementId(id));
        }
        let nearest = |all: &[u32]| {
            all.iter().copied().min_by(|a, b| outside(a).total_cmp(&outside(b)))
        };
        nearest(here).or_else(|| nearest(&grid.elements)).map(ElementId)
    }
}

impl SurfaceGrid {
    fn of(frame: Frame, mesh: &Mesh, ids: &[u32]) -> SurfaceGrid {
        let plane = |v: &DVec3| dvec2(frame.x.dot(*v), frame.y.dot(*v));
        let bounds = |id: &u32| {
            let corners = mesh.elements[*id as usize].polygon.vertices();
            let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            corners.iter().map(plane).fold(empty, |(l, h), p| (l.min(p), h.max(p)))
        };
        let boxes: Vec<(DVec2, DVec2)> = ids.iter().map(bounds).collect();
        let low = boxes.iter().fold(DVec2::INFINITY, |m, b| m.min(b.0));
        let high = boxes.iter().fold(DVec2::NEG_INFINITY, |m, b| m.max(b.1));
        let size = (high - low).max(DVec2::ZERO);
        let per_unit = (ids.len() as f64 / (size.x * size.y)).sqrt();
        let count = |k: usize| (size[k] * per_unit).ceil().clamp(1.0, 4096.0) as usize;
        let cells = [count(0), count(1)];
        let scale = dvec2(cells[0] as f64, cells[1] as f64) / size;
        let mut grid =
            SurfaceGrid { frame, low, scale, cells, starts: vec![], elements: vec![] };
        let mut lists = vec![Vec::new(); cells[0] * cells[1]];
        for (&id, &(low, high)) in ids.iter().zip(&boxes) {
            let ([i0, j0], [i1, j1]) = (grid.cell(low), grid.cell(high));
            for j in j0..=j1 {
                lists[j * cells[0] + i0..=j * cells[0] + i1]
                    .iter_mut()
                    .for_each(|list| list.push(id));
            }
        }
        grid.starts.push(0);
        for list in lists {
            grid.elements.extend(list);
            grid.starts.push(grid.elements.len() as u32);
        }
        grid
    }

    /// The cell of a place in the plane, or the nearest one.
    fn cell(&self, at: DVec2) -> [usize; 2] {
        let place = (at - self.low) * self.scale;
        // A cast of NaN, of an empty grid, is 0.
        [0, 1].map(|k| (place[k].max(0.0) as usize).min(self.cells[k] - 1))
    }

    fn at(&self, p: DVec3) -> &[u32] {
        let [i, j] = self.cell(dvec2(self.frame.x.dot(p), self.frame.y.dot(p)));
        let k = j * self.cells[0] + i;
        &self.elements[self.starts[k] as usize..self.starts[k + 1] as usize]
    }
}
