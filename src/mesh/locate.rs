//! Which of the pieces of a surface holds a point of it?

use crate::geometry::{Frame, Polygon};
use crate::scene::Scene;
use glam::{DVec2, DVec3, dvec2};

/// The pieces of each surface, in a grid of cells of its plane.
#[derive(Clone, Debug)]
pub struct Locator {
    grids: Vec<SurfaceGrid>,
}

/// Cells of one surface, about as many as it has pieces.
#[derive(Clone, Debug)]
struct SurfaceGrid {
    frame: Frame,
    low: DVec2,
    /// Cells for each scene unit.
    scale: DVec2,
    cells: [usize; 2],
    /// Where the pieces of each cell begin in `pieces`; one more at the end.
    starts: Vec<u32>,
    pieces: Vec<u32>,
}

impl Locator {
    /// That of `pieces`, each with the surface that it is part of: the elements of a mesh,
    /// or parts of them.
    pub fn of<'p>(
        scene: &Scene,
        pieces: impl Iterator<Item = (u32, &'p Polygon)>,
    ) -> Locator {
        let mut of_surface = vec![Vec::new(); scene.surfaces.len()];
        for (id, (surface, polygon)) in (0u32..).zip(pieces) {
            of_surface[surface as usize].push((id, polygon));
        }
        let grid = |(surface, pieces): (&crate::scene::Surface, &Vec<_>)| {
            SurfaceGrid::of(Frame::about(surface.polygon.normal()), pieces)
        };
        let surfaces = scene.surfaces.iter().zip(&of_surface);
        Locator { grids: surfaces.map(grid).collect() }
    }

    /// The piece of `surface` at `point`, or the nearest to it; `None` where the surface
    /// has none. `outline` tells the outline of a piece.
    pub fn piece<'p>(
        &self,
        surface: u32,
        point: DVec3,
        outline: impl Fn(u32) -> &'p Polygon,
    ) -> Option<u32> {
        let grid = &self.grids[surface as usize];
        let outside = |&id: &u32| {
            // How far outside of its edges: at most 0 inside.
            let polygon = outline(id);
            let off = |(a, b): (DVec3, DVec3)| {
                let across = polygon.normal().cross(b - a);
                across.dot(a - point) / across.length()
            };
            polygon.edges().map(off).fold(f64::NEG_INFINITY, f64::max)
        };
        let here = grid.at(point);
        if let Some(&id) = here.iter().find(|id| outside(id) <= 0.0) {
            return Some(id);
        }
        let nearest = |all: &[u32]| {
            all.iter().copied().min_by(|a, b| outside(a).total_cmp(&outside(b)))
        };
        nearest(here).or_else(|| nearest(&grid.pieces))
    }
}

impl SurfaceGrid {
    fn of(frame: Frame, all: &[(u32, &Polygon)]) -> SurfaceGrid {
        let plane = |v: &DVec3| dvec2(frame.x.dot(*v), frame.y.dot(*v));
        let bounds = |(_, polygon): &(u32, &Polygon)| {
            let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            let corners = polygon.vertices().iter().map(plane);
            corners.fold(empty, |(l, h), p| (l.min(p), h.max(p)))
        };
        let boxes: Vec<(DVec2, DVec2)> = all.iter().map(bounds).collect();
        let low = boxes.iter().fold(DVec2::INFINITY, |m, b| m.min(b.0));
        let high = boxes.iter().fold(DVec2::NEG_INFINITY, |m, b| m.max(b.1));
        let size = (high - low).max(DVec2::ZERO);
        let per_unit = (all.len() as f64 / (size.x * size.y)).sqrt();
        let count = |k: usize| (size[k] * per_unit).ceil().clamp(1.0, 4096.0) as usize;
        let cells = [count(0), count(1)];
        let scale = dvec2(cells[0] as f64, cells[1] as f64) / size;
        let mut grid =
            SurfaceGrid { frame, low, scale, cells, starts: vec![], pieces: vec![] };
        let mut lists = vec![Vec::new(); cells[0] * cells[1]];
        for (&(id, _), &(low, high)) in all.iter().zip(&boxes) {
            let ([i0, j0], [i1, j1]) = (grid.cell(low), grid.cell(high));
            for j in j0..=j1 {
                lists[j * cells[0] + i0..=j * cells[0] + i1]
                    .iter_mut()
                    .for_each(|list| list.push(id));
            }
        }
        grid.starts.push(0);
        for list in lists {
            grid.pieces.extend(list);
            grid.starts.push(grid.pieces.len() as u32);
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
        &self.pieces[self.starts[k] as usize..self.starts[k + 1] as usize]
    }
}
