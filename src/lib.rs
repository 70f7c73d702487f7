//! Radiosity and two-pass rendering, patch by patch: the code of the course
//! *Light, Patch by Patch*.
//!
//! # A tour
//!
//! A scene from a file, its light to one per cent, what an element sends, what a camera
//! sees, and the form factor of two polygons:
//!
//! ```
//! use radiosity::prelude::*;
//! # let folder = std::env::temp_dir().join("radiosity-tour");
//! # let path = &radiosity::obj::export(&built_in("cornell")?, &folder)?[0];
//!
//! // A scene as other programs write it; what was repaired in it is told.
//! let (scene, warnings) = load(path)?;
//! warnings.iter().for_each(|warning| println!("{warning}"));
//!
//! // Made ready once, and its light found until a certificate says: at most 1 % off.
//! let room = Room::of(&scene);
//! let light = solve(&room, &Smooth, &Goal::within(0.01), &Work::quiet())?;
//! assert!(light.converged && light.certificate.high <= 0.01);
//!
//! // The radiosity, in W/m², of the element under a pixel: here the floor.
//! let shot = Shot { camera: scene.camera, width: 64, height: 64, samples: 2 };
//! let Seen::Front(k) = shot.items(&light.field.mesh).seen(32, 60) else { panic!() };
//! assert!(light.radiosity[k as usize].min_element() > 0.0);
//!
//! // The picture: stored light, and rays where something shines.
//! let eye = TwoPass::of(&room, &light.field, Look::default());
//! let picture = eye.picture(&shot, &|_, _, _| {}).picture;
//! let png = picture.encode(Format::Png, picture.auto_exposure())?;
//! # assert!(png.starts_with(b"\x89PNG"));
//!
//! // The floor and the ceiling of a unit cube; and past a plate that halves the way.
//! let square = |z: f64| {
//!     let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
//!     Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec())
//! };
//! let (floor, ceiling, plate) = (square(0.0)?, square(1.0)?.flipped(), square(0.5)?);
//! assert!((form_factor(&floor, &ceiling) - 0.199_824_895_698).abs() < 1e-12);
//! assert_eq!(form_factor_past(&floor, &ceiling, &[plate], 1e-6), 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The house
//!
//! The module list below is the dependency order, and as near as can be the lecture's: a
//! module uses only those above it (`tests/architecture` holds both).
#![forbid(unsafe_code)]
#![deny(missing_debug_implementations)] // of the library: labs and book are no libraries

pub use glam;

#[cfg(doctest)]
#[doc = include_str!("README.md")]
mod readme {}

pub mod geometry;
pub mod random;
pub mod work;
pub mod radiometry;
pub mod material;
pub mod texture;
pub mod sky;
pub mod scene;
pub mod mesh;
pub mod raster;
pub mod visibility;
pub mod occlusion;
pub mod form_factor;
pub mod solve;
pub mod obj;
pub mod film;
pub mod directional;
pub mod ways;
pub mod virtual_world;
pub mod room;
pub mod field;
pub mod certificate;
pub mod solution;
pub mod tables;
pub mod trace;
pub mod plan;
pub mod chart;

/// What a chapter's example needs, in one `use`.
pub mod prelude {
    pub use crate::field::{Classical, Factors, Field, Links, MatrixSolver, Smooth};
    pub use crate::film::{Format, Picture, Shot};
    pub use crate::form_factor::{form_factor, form_factor_past};
    pub use crate::geometry::{Frame, Plane, Polygon, Ray, Rgb};
    pub use crate::mesh::Mesh;
    pub use crate::obj::load;
    pub use crate::raster::Seen;
    pub use crate::room::Room;
    pub use crate::scene::{Scene, built_in};
    pub use crate::solution::{Goal, Solution, solve, solve_on};
    pub use crate::trace::{Look, TwoPass};
    pub use crate::work::Work;
    pub use glam::{DVec2, DVec3, dvec2, dvec3};
}
