//! Radiosity and two-pass rendering, patch by patch: the code of the course
//! *Light, Patch by Patch*.
//!
//! The module list below is the dependency order: a module uses only those above it
//! (`tests/architecture/main.rs` holds this).
#![forbid(unsafe_code)]
#![deny(missing_debug_implementations)] // of the library: labs and book are no libraries

pub use glam;

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
pub mod trace;
pub mod plan;
pub mod chart;

/// What a chapter's example needs, in one `use`.
pub mod prelude {
    pub use crate::field::{Classical, Factors, Field, Smooth};
    pub use crate::film::Shot;
    pub use crate::geometry::{Frame, Plane, Polygon, Ray, Rgb};
    pub use crate::mesh::Mesh;
    pub use crate::obj::load;
    pub use crate::room::Room;
    pub use crate::scene::{Scene, built_in};
    pub use crate::solution::{Goal, Solution, solve, solve_on};
    pub use crate::work::Work;
    pub use glam::{DVec2, DVec3, dvec2, dvec3};
}
