//! Occlusion: what stands between two polygons, and what of one is seen past it.
//!
//! ```text
//! V(x, y) = 1 − [y in the cone from x over a blocker]     cones of convex things are convex
//! F(x → what x sees of y) = F of the pieces of y outside all cones        Lambert, exactly
//! ```
//!
//! | part                | use it when                               | it fails when          |
//! |---------------------|-------------------------------------------|------------------------|
//! | [`Blockers`]        | which things of a scene may matter?       | never; finds too many  |
//! | [`Shaft`]           | may this stand between those two?         | never; says yes often  |
//! | [`Blocker`]         | one convex sheet or solid is looked at    | it is not convex       |
//! | [`lambert_visible`] | a factor past blockers must be exact      | dozens of them: slow   |
//! | [`visible_parts`]   | what is seen is to be weighed otherwise   | the same               |
//! | [`joined_tiles`]    | tiles of one wall are one thing           | they fill no outline   |
//!
//! ```
//! use radiosity::geometry::Polygon;
//! use radiosity::occlusion::{Blocker, lambert_visible};
//! use glam::{DVec3, dvec3};
//!
//! let square = |z: f64, half: f64| {
//!     let corner = |x: f64, y: f64| dvec3(half * x, half * y, z);
//!     Polygon::new(vec![corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)])
//! };
//! let (lamp, card) = (square(2.0, 1.0)?, Blocker::sheet(&square(1.0, 0.25)?));
//! let (all, past) = (
//!     lambert_visible(DVec3::ZERO, DVec3::Z, &lamp, &[]),
//!     lambert_visible(DVec3::ZERO, DVec3::Z, &lamp, &[&card]),
//! );
//! assert!(0.0 < past && past < all);
//! # Ok::<(), radiosity::geometry::PolygonError>(())
//! ```
//!
//! **Not here:** rays ([`crate::visibility`]), which need no blockers; factors between areas
//! ([`crate::form_factor`]). Chapter *Form factors* (L07).
//! Sources: Nishita & Nakamae 1985 (light sources cut by what hides them); Haines & Wallace
//! 1991 (shaft culling).

mod blocker;
mod blockers;
mod shaft;
mod tiles;
mod visible;

pub use blocker::Blocker;
pub use blockers::Blockers;
pub use shaft::Shaft;
pub use tiles::joined_tiles;
pub use visible::{inside, lambert_visible, parted, visible_parts};
