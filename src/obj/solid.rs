//! Solids of glass: are they closed, and do their normals lead outwards?

use super::{Cause, Warning};
use crate::material::{Material, Shine};
use crate::scene::{Face, MaterialId};
use glam::DVec3;
use std::collections::HashMap;
use std::path::Path;

/// A warning for each material of a solid that is open, or whose normals lead inwards.
/// `line` knows where a face stands.
///
/// Closed means that each edge of a face is, the other way round, an edge of another face
/// of some solid.
pub(super) fn warnings(
    path: &Path,
    faces: &[Face],
    materials: &[Material],
    line: impl Fn(usize) -> usize,
) -> Vec<Warning> {
    let solid = |id: MaterialId| {
        let shine = materials.get(id.0 as usize).map(Material::shine);
        matches!(shine, Some(Shine::Glass { .. }))
    };
    let glass = || faces.iter().enumerate().filter(|(_, face)| solid(face.material));
    let mut edges: HashMap<[[u64; 3]; 2], i32> = HashMap::new();
    for (a, b) in glass().flat_map(|(_, face)| edges_of(face)) {
        *edges.entry([bits(a), bits(b)]).or_default() += 1;
    }
    let alone =
        |(a, b)| edges.get(&[bits(b), bits(a)]) != edges.get(&[bits(a), bits(b)]);
    let mut told: Vec<MaterialId> = Vec::new();
    let mut warnings = Vec::new();
    for (k, face) in glass() {
        let id = face.material;
        let open = edges_of(face).any(alone);
        let last = || faces[k + 1..].iter().all(|later| later.material != id);
        if told.contains(&id) || !(open || last()) {
            continue;
        }
        told.push(id);
        let material = materials[id].name().into();
        let cause = if open {
            Cause::Open { material }
        } else if volume(faces.iter().filter(|face| face.material == id)) < 0.0 {
            Cause::InsideOut { material }
        } else {
            continue;
        };
        warnings.push(Warning::new(path, line(k), cause));
    }
    warnings
}

fn bits(corner: DVec3) -> [u64; 3] {
    (corner + 0.0).to_array().map(f64::to_bits) // −0 is 0
}

fn edges_of(face: &Face) -> impl Iterator<Item = (DVec3, DVec3)> {
    let corners = &face.outline;
    let next = corners.iter().cycle().skip(1);
    corners.iter().copied().zip(next.copied())
}

/// Six times the volume that closed `faces` bound; negative when they look inwards.
fn volume<'a>(faces: impl Iterator<Item = &'a Face>) -> f64 {
    let of_face = |face: &Face| {
        let apex = face.outline[0];
        edges_of(face).map(|(a, b)| apex.dot(a.cross(b))).sum::<f64>()
    };
    faces.map(of_face).sum()
}
