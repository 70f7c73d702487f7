//! The second pass: what a camera sees, by rays that shiny surfaces send on.
//!
//! ```text
//! L(x → o) = B(x)/π + ∫ f_s(i, o) L(x ← i) cosθ_i dω_i     diffuse: stored; specular: followed
//! L(x ← i) = L(y → −i)                                     y: what x sees in direction i
//! E S* L,  E S* D (D|S)* L        paths as words: pass 2 owns the S next to the eye
//! ```
//! A mirror, a pane and glass have single directions in their `f_s`: a ray follows each.
//! Gloss has a lobe: a cone of directions.
//!
//! | method         | use it when                             | it fails when              |
//! |----------------|-----------------------------------------|----------------------------|
//! | [`Whitted`]    | lamps and mirrors are all that matters  | light bounces: it is dark  |
//! | [`TwoPass`]    | pass 1 has found the diffuse light      | that was found too coarsely|
//! | [`PathTracer`] | the right answer is wanted, with errors | time is short: noise       |
//! | [`Class`]      | light is to be told by its path         | never                      |
//! | [`PictureMethod`] | the best picture of a room is wanted | never                      |
//!
//! ```
//! use radiosity::{scene::built_in, trace::PictureMethod};
//! let best = |name| PictureMethod::best_for(&built_in(name).unwrap());
//! assert_eq!(best("cornell"), PictureMethod::Radiosity); // nothing shines
//! assert_eq!(best("mirror-room"), PictureMethod::TwoPass);
//! ```
//!
//! **Not here:** the light that diffuse surfaces send: pass 1 ([`crate::solve`]) brings it.
//! Chapters *The second pass* (L19, L20) and *Who carries which light?* (L15). Sources:
//! Kajiya 1986 (path tracing); Whitted 1980 (ray tracing); Heckbert 1990 (words); Wallace,
//! Cohen & Greenberg 1987, Sillion & Puech 1989 (two passes).

mod class_table;
mod classes;
mod cone;
mod expose;
mod gather;
mod gloss;
mod look;
mod method;
mod path;
mod tree;
mod two_pass;
mod whitted;

pub use class_table::ByClass;
pub use classes::{CLASSES, Class, ClassRow, Letter, Light, Owner, Table, Word};
pub use cone::Cone;
pub use expose::{Along, Shown};

pub use look::{LobeAs, Look};
pub use method::{Drawing, PictureMethod, Rendered};
pub use path::{Estimate, PathTracer, Strategy, Traced};
pub use two_pass::TwoPass;
pub use whitted::Whitted;
