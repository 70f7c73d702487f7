//! Patch by patch: the mean irradiance of 8 × 8 patches a wall, by smooth light and by
//! walks.
//!
//! ```text
//! error = ‖H − H*‖/‖H*‖          over patches, area norm, worst channel
//! ```

use super::{Verdict, WorkDone};
use crate::field::{Field, Fineness, Pass1, Smooth, gather_unbiased};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::room::Room;
use crate::scene::Scene;

/// The patches of a scene and what is known of them.
#[derive(Debug)]
pub struct Patches<'a> {
    scene: &'a Scene,
    patches: Mesh,
    truth: Vec<Rgb>,
}

impl<'a> Patches<'a> {
    /// The truth is the light with an error ten times below what is to be told.
    pub const TRUTH: f64 = 0.001;

    /// Patches with edges no longer than `edge`, in scene units, and their true light.
    pub fn new(scene: &'a Scene, edge: f64) -> Patches<'a> {
        let unjudged = Patches::unjudged(scene, edge);
        let room = Room::of(scene);
        let how = Smooth.first(&room, Patches::TRUTH);
        let how = Fineness { patch: how.patch.min(0.5 * edge), hemicube: 96, ..how };
        let light = Smooth.field(&room, &how, &crate::work::Work::quiet());
        let truth = means(&unjudged.patches, &light);
        Patches { truth, ..unjudged }
    }

    /// The same without the truth: nothing can be judged.
    pub fn unjudged(scene: &'a Scene, edge: f64) -> Patches<'a> {
        Patches { scene, patches: Mesh::patched(scene, edge), truth: vec![] }
    }

    /// The patches: each is one element.
    pub fn mesh(&self) -> &Mesh {
        &self.patches
    }

    /// Smooth light as it is resolved for this `tolerance` of the field: the mean irradiance
    /// of each patch, and the work.
    pub fn by_smooth(&self, tolerance: f64) -> (Vec<Rgb>, WorkDone) {
        let room = Room::of(self.scene);
        let how = Smooth.first(&room, tolerance);
        let light = Smooth.field(&room, &how, &crate::work::Work::quiet());
        let pixels = 3 * u64::from(how.hemicube).pow(2) * light.rows as u64;
        let (patches, steps) = (light.patches as u64, light.steps as u64);
        let work = WorkDone {
            pixels,
            steps,
            factors: patches * patches,
            ..WorkDone::default()
        };
        (means(&self.patches, &light), work)
    }

    /// The same by so many random walks from each patch.
    pub fn by_walks(&self, walks: usize, seed: u64) -> (Vec<Rgb>, WorkDone) {
        let found = gather_unbiased(&Room::of(self.scene), &self.patches, walks, seed);
        let rays = (walks * self.patches.elements.len()) as u64;
        let work = WorkDone { rays, ..WorkDone::default() };
        (found.iter().map(|g| g.irradiance).collect(), work)
    }

    /// How far off the irradiance of the patches is: `‖H − H*‖/‖H*‖`.
    pub fn verdict(&self, irradiance: &[Rgb]) -> Verdict {
        let norm = |of: &mut dyn Iterator<Item = Rgb>| -> Rgb {
            let squares = of.zip(&self.patches.elements);
            squares.map(|(x, e)| e.polygon.area() * x * x).sum()
        };
        let off = norm(&mut irradiance.iter().zip(&self.truth).map(|(&h, &t)| h - t));
        let all = norm(&mut self.truth.iter().copied());
        Verdict::of((off / all).max_element().sqrt())
    }
}

/// The mean irradiance of each of `patches`.
fn means(patches: &Mesh, light: &Field) -> Vec<Rgb> {
    let of_elements = light.irradiance();
    let mean = |patch: &crate::mesh::Element| {
        let surface = patches.surface_of(patch);
        let (mut sum, mut all) = (Rgb::ZERO, 0.0);
        for (element, &h) in light.mesh.elements.iter().zip(&of_elements) {
            if light.mesh.surface_of(element) != surface {
                continue;
            }
            // Of an element that straddles the patch's rim, its part inside.
            let area = common_area(&patch.polygon, &element.polygon);
            sum += area * h;
            all += area;
        }
        sum / all
    };
    patches.elements.iter().map(mean).collect()
}

/// The area that two polygons of one plane have in common.
fn common_area(
    patch: &crate::geometry::Polygon,
    element: &crate::geometry::Polygon,
) -> f64 {
    let mut rest = element.clone();
    for (a, b) in patch.edges() {
        let inward = patch.normal().cross(b - a).normalize();
        let side = crate::geometry::Plane::through(a, inward);
        match rest.clipped(side) {
            Some(inside) => rest = inside,
            None => return 0.0,
        }
    }
    rest.area()
}
