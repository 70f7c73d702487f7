//! Scenes with mirrors and panes.

use super::rooms::rectangle;
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::virtual_world::VirtualWorld;

/// A scene of faces, each with what it is made of.
pub fn scene_of(faces: impl IntoIterator<Item = (Polygon, Coefficients)>) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, coefficients)) in faces.into_iter().enumerate() {
        materials.push(Material::new(format!("m{k}"), coefficients).unwrap());
        let material = MaterialId(k as u32);
        outlines.push(Face { outline: polygon.vertices().to_vec(), material });
    }
    Scene::assemble("test", materials, outlines, None).unwrap().0
}

/// A mirror that reflects this share.
pub fn mirror(share: f64) -> Coefficients {
    let shine = Shine::Mirror { reflectance: Rgb::splat(share) };
    Coefficients { shine, ..Default::default() }
}

/// A clear pane.
pub fn pane(index: f64) -> Coefficients {
    let shine = Shine::Pane { index, tint: Rgb::ONE };
    Coefficients { shine, ..Default::default() }
}

/// A grey diffuse surface that also emits.
pub fn diffuse(emission: f64, reflectance: f64) -> Coefficients {
    let [emission, diffuse] = [emission, reflectance].map(Rgb::splat);
    Coefficients { emission, diffuse, ..Default::default() }
}

/// The unit square 1 above the origin, looking down.
pub fn lamp() -> Polygon {
    rectangle(dvec3(-0.5, -0.5, 1.0), DVec3::Y, DVec3::X)
}

/// A small floor about the origin, looking up.
pub fn spot() -> Polygon {
    rectangle(dvec3(-0.01, -0.01, 0.0), 0.02 * DVec3::X, 0.02 * DVec3::Y)
}

/// The factor from a point of `piece` to all images of `target`.
pub fn factor(
    world: &VirtualWorld,
    x: DVec3,
    piece: &Polygon,
    target: &Polygon,
) -> Rgb {
    let sights = world.sights(piece, target);
    sights.iter().map(|sight| sight.factor(x, piece.normal())).sum()
}

/// The factor from the middle of [`spot`] to [`lamp`] by one reflection.
pub fn reflected(world: &VirtualWorld) -> f64 {
    let sights = world.sights(&spot(), &lamp());
    let once = sights.iter().filter(|s| s.level() == 1);
    once.map(|s| s.factor(DVec3::ZERO, DVec3::Z).x).sum()
}
