//! Scenes that shine, and how far a sampled number may be from the right one.

use super::rooms::{box_walls, moved};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::room::Room;
use radiosity::scene::{Camera, Face, MaterialId, Scene};
use radiosity::trace::PathTracer;
use std::f64::consts::{PI, TAU};

/// Emits this radiosity, reflects this share diffusely, and nothing else.
pub fn dull(emission: f64, diffuse: f64) -> Coefficients {
    Coefficients {
        emission: Rgb::splat(emission),
        diffuse: Rgb::splat(diffuse),
        ..Default::default()
    }
}

/// Shines, and nothing else.
pub fn shine(shine: Shine) -> Coefficients {
    Coefficients { shine, ..Default::default() }
}

/// A mirror of this reflectance.
pub fn mirror(reflectance: f64) -> Coefficients {
    shine(Shine::Mirror { reflectance: Rgb::splat(reflectance) })
}

/// A clear thin pane of index 1.5.
pub fn pane() -> Coefficients {
    shine(Shine::Pane { index: 1.5, tint: Rgb::ONE })
}

/// The boundary of a clear solid.
pub fn glass(index: f64) -> Coefficients {
    shine(Shine::Glass { index, tint: Rgb::ONE })
}

/// A scene of such faces.
pub fn shiny(faces: impl IntoIterator<Item = (Polygon, Coefficients)>) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, coefficients)) in faces.into_iter().enumerate() {
        materials.push(Material::new(format!("m{k}"), coefficients).unwrap());
        let material = MaterialId(k as u32);
        outlines.push(Face { outline: polygon.vertices().to_vec(), material });
    }
    Scene::assemble("test", materials, outlines, None).unwrap().0
}

/// A cube about the origin whose walls glow with radiance 1 and reflect nothing.
pub fn glow() -> impl Iterator<Item = (Polygon, Coefficients)> {
    let wall = |p: Polygon| moved(&p, |v| v - DVec3::splat(3.0));
    box_walls([6.0; 3]).into_iter().map(move |p| (wall(p), dull(PI, 0.0)))
}

/// A camera at `eye` that looks at `target`.
pub fn camera(eye: DVec3, target: DVec3, fov: f64) -> Camera {
    let up = if (target - eye).cross(DVec3::Z).length() > 1e-6 {
        DVec3::Z
    } else {
        DVec3::Y
    };
    Camera { eye, target, up, fov }
}

/// A sphere of triangles, fronts outwards.
pub fn sphere(centre: DVec3, radius: f64, rings: usize) -> Vec<Polygon> {
    let sectors = 2 * rings;
    let at = |i: usize, j: usize| {
        let theta = PI * i as f64 / rings as f64;
        let phi = TAU * (j % sectors) as f64 / sectors as f64;
        let (sin, cos) = if i == rings { (0.0, -1.0) } else { theta.sin_cos() };
        centre + radius * dvec3(sin * phi.cos(), sin * phi.sin(), cos)
    };
    let cell = |(i, j): (usize, usize)| {
        let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[0, 1, 2], [0, 2, 3]]
            .into_iter()
            .filter_map(move |k| Polygon::new(k.map(|n| corners[n]).to_vec()).ok())
    };
    let cells = (0..rings).flat_map(|i| (0..sectors).map(move |j| (i, j)));
    cells.flat_map(cell).collect()
}

/// The largest |z| that `count` right and independent numbers exceed together with a
/// chance of 1e-4 (Šidák 1967).
pub fn largest_z(count: usize) -> f64 {
    let each = 1.0 - (1.0 - 1e-4_f64).powf(1.0 / count as f64);
    // The normal tail by its continued fraction, good to 1e-9 from 2.5 on.
    let tail = |z: f64| {
        let fraction = (1..60).rev().fold(0.0, |below, k| k as f64 / (z + below));
        (-0.5 * z * z).exp() / TAU.sqrt() / (z + fraction)
    };
    let (mut low, mut high) = (2.5, 9.0);
    for _ in 0..60 {
        let z = 0.5 * (low + high);
        if 2.0 * tail(z) > each { low = z } else { high = z }
    }
    high
}

/// The distance of `got` from `right` in standard errors; 0 where they agree to rounding.
pub fn z(got: f64, error: f64, right: f64) -> f64 {
    let off = (got - right).abs();
    if off <= 1e-12 * right.abs() { 0.0 } else { off / error }
}

/// Holds all `(what, got, standard error, right)` to what chance allows of so many.
pub fn by_chance<S: std::fmt::Display>(all: &[(S, f64, f64, f64)]) {
    let most = largest_z(all.len());
    for (what, got, error, right) in all {
        let z = z(*got, *error, *right);
        assert!(z <= most, "{what}: {got} ± {error}, not {right}: z = {z} > {most}");
    }
}

/// Irradiance (red) at a point on the front of a surface: its mean and standard error.
pub fn irradiance(scene: &Scene, surface: u32, x: DVec3, samples: usize) -> (f64, f64) {
    let found = PathTracer::of(&Room::of(scene)).irradiance(surface, x, samples, 1);
    (found.mean.x, found.error.x)
}
