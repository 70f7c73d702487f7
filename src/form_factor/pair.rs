//! The form factor of two polygons.

use super::Accuracy;
use super::analytic::{Analytic, exchange};
use crate::geometry::Polygon;
use crate::material::{Coefficients, Material};
use crate::mesh::{ElementId, Mesh};
use crate::scene::{Camera, Face, FaceId, MaterialId, Scene, Side, Surface};
use glam::DVec3;

/// `F_ij`: the dimensionless fraction, in `[0, 1]`, of the power leaving the front of `i`
/// that arrives at the front of `j`, with nothing between them.
///
/// ```text
/// F_ij = 1/A_i ∫∫ cosθ_i cosθ_j / (π r²) dA_j dA_i          A_i F_ij = A_j F_ji
/// ```
/// What lies behind the other's plane neither sends nor receives; so polygons in one plane,
/// or back to back, have 0.
///
/// # Accuracy
/// A relative 1e-9, shared edges and pairs that all but touch among them; see [`exchange`].
///
/// ```
/// use radiosity::form_factor::form_factor;
/// use radiosity::prelude::*;
///
/// let square = |z: f64| {
///     let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
///     Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec()).unwrap()
/// };
/// let (floor, ceiling) = (square(0.0), square(1.0).flipped());
/// // Of a cube: Howell's catalogue, C-11.
/// assert!((form_factor(&floor, &ceiling) - 0.199_824_895_698_387).abs() < 1e-12);
/// assert_eq!(form_factor(&floor, &square(1.0)), 0.0); // it turns its back
/// ```
pub fn form_factor(i: &Polygon, j: &Polygon) -> f64 {
    exchange(i, j, Accuracy::Best) / i.area()
}

/// `F_ij`, as [`form_factor`], past `blockers`, which are opaque from both sides.
///
/// # Accuracy
/// About what is asked for ([`Analytic::exchange_and_error`] tells how well that went).
/// Where a blocker hides a part, halving goes to 1/1024 of the edges, whatever is asked
/// for: [`Accuracy::Best`] may take seconds a pair. Blockers in the plane of `i` or `j`
/// hide nothing.
///
/// ```
/// use radiosity::form_factor::{form_factor, form_factor_past};
/// use radiosity::prelude::*;
///
/// let square = |z: f64, size: f64| {
///     let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
///     let corners = corners.map(|(x, y)| dvec3(size * x, size * y, z));
///     Polygon::new(corners.to_vec()).unwrap()
/// };
/// let (floor, ceiling) = (square(0.0, 1.0), square(2.0, 1.0).flipped());
/// let open = form_factor(&floor, &ceiling);
/// let past = |blocker| form_factor_past(&floor, &ceiling, &[blocker], 1e-6);
/// assert!((past(square(3.0, 1.0)) - open).abs() < 1e-6); // not between them
/// assert_eq!(past(square(1.0, 2.0)), 0.0);
/// let half = past(square(1.0, 0.5));
/// assert!(0.0 < half && half < open);
/// ```
pub fn form_factor_past(
    i: &Polygon,
    j: &Polygon,
    blockers: &[Polygon],
    accuracy: impl Into<Accuracy>,
) -> f64 {
    let scene = black([i, j].into_iter().chain(blockers));
    let mesh = Mesh::whole(&scene);
    let method = Analytic::new(&scene, &mesh, accuracy, 0).without_losses();
    method.exchange(ElementId(0), ElementId(1)) / i.area()
}

/// Black polygons as they are, each a face by itself.
fn black<'a>(polygons: impl Iterator<Item = &'a Polygon>) -> Scene {
    let material = MaterialId(0);
    let surface = |(k, polygon): (u32, &Polygon)| Surface {
        polygon: polygon.clone(),
        material,
        face: FaceId(k),
        side: Side::Front,
        back: None,
    };
    let surfaces: Vec<Surface> = (0u32..).zip(polygons).map(surface).collect();
    let outline = |s: &Surface| s.polygon.vertices().to_vec();
    let black = Material::new("black", Coefficients::default());
    Scene {
        name: "pair".into(),
        faces: surfaces
            .iter()
            .map(|s| Face { outline: outline(s), material })
            .collect(),
        camera: Camera::showing(&surfaces, DVec3::Y),
        materials: vec![black.expect("black is passive")],
        surfaces,
        sky: None,
    }
}
