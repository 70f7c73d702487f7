//! Patch by patch: the mean irradiance of 8 × 8 patches a wall, by smooth light and by
//! walks.
//!
//! ```text
//! error = ‖H − H*‖/‖H*‖          over patches, area norm, worst channel
//! ```

use super::{Chart, Line, Mark};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::solve::{Resolution, Smooth, gather_unbiased, resolution_for, smooth};
use std::fmt::Write;

/// One run: who, how finely, how wrong, how long.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// The method.
    pub method: &'static str,
    /// What it was asked for: patches, or walks a patch.
    pub setting: usize,
    /// `‖H − H*‖/‖H*‖`; of walks, as their spread tells it.
    pub error: f64,
    /// Seconds of one processor.
    pub seconds: f64,
}

/// The patches of a scene and what is known of them.
pub struct Patches<'a> {
    scene: &'a Scene,
    patches: Mesh,
    truth: Vec<Rgb>,
}

/// The truth is the light with an error ten times below what is to be told.
const TRUTH: f64 = 0.001;

impl<'a> Patches<'a> {
    /// Patches with edges no longer than `edge`, in scene units, and their true light.
    pub fn new(scene: &'a Scene, edge: f64) -> Patches<'a> {
        let patches = Mesh::patched(scene, edge);
        let how = resolution_for(scene, TRUTH);
        let how = Resolution { patch: how.patch.min(0.5 * edge), hemicube: 96, ..how };
        let truth = means(&patches, &smooth(scene, &how, &|_, _, _| {}));
        Patches { scene, patches, truth }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.truth.len()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.truth.is_empty()
    }

    /// Smooth light as it is resolved for this `tolerance` of the field.
    pub fn by_smooth(&self, tolerance: f64, clock: &dyn Fn() -> f64) -> Trial {
        let how = resolution_for(self.scene, tolerance);
        let start = clock();
        let light = smooth(self.scene, &how, &|_, _, _| {});
        let seconds = clock() - start;
        let found = means(&self.patches, &light);
        let off = found.iter().zip(&self.truth).map(|(&h, &t)| h - t);
        let error = self.relative(off.collect());
        Trial { method: "smooth light", setting: light.patches, error, seconds }
    }

    /// Random walks, so many from each patch.
    pub fn by_walks(&self, walks: usize, clock: &dyn Fn() -> f64) -> Trial {
        let start = clock();
        let found = gather_unbiased(self.scene, &self.patches, walks, 0);
        let seconds = clock() - start;
        let error = self.relative(found.iter().map(|g| g.error).collect());
        Trial { method: "unbiased gathering", setting: walks, error, seconds }
    }

    fn relative(&self, off: Vec<Rgb>) -> f64 {
        let norm = |of: &[Rgb]| -> Rgb {
            let squares = of.iter().zip(&self.patches.elements);
            squares.map(|(&x, e)| e.polygon.area() * x * x).sum()
        };
        (norm(&off) / norm(&self.truth)).max_element().sqrt()
    }
}

/// The mean irradiance of each of `patches`.
fn means(patches: &Mesh, light: &Smooth) -> Vec<Rgb> {
    let of_elements = light.mesh.element_means(&light.irradiance);
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

/// The trials as a table for people.
pub fn table(trials: &[Trial]) -> String {
    let mut text =
        format!("{:<20}{:>10}{:>12}{:>12}\n", "", "setting", "error", "CPU s");
    for Trial { method, setting, error, seconds } in trials {
        let error = format!("{:.2} %", 100.0 * error);
        let _ = writeln!(text, "{method:<20}{setting:>10}{error:>12}{seconds:>12.3}");
    }
    text
}

/// The trials as a table for programs; `origin` says what they are.
pub fn csv(origin: &str, trials: &[Trial]) -> String {
    let mut text: String = origin.lines().map(|line| format!("# {line}\n")).collect();
    text += "method,setting,error,seconds\n";
    for Trial { method, setting, error, seconds } in trials {
        let _ = writeln!(text, "{method},{setting},{error:e},{seconds:e}");
    }
    text
}

/// Error against time.
pub fn chart(trials: &[Trial]) -> Chart {
    let lines = trials.chunk_by(|a, b| a.method == b.method).map(|line| Line {
        name: line[0].method.into(),
        marks: line
            .iter()
            .map(|t| Mark { x: t.seconds, y: t.error, label: t.setting.to_string() })
            .collect(),
    });
    Chart {
        title: "Error of the patches' irradiance against processor time".into(),
        across: "CPU seconds".into(),
        upward: "error".into(),
        least: 1e-5,
        frontier: true,
        lines: lines.collect(),
        ..Chart::default()
    }
}
