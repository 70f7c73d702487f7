//! The second pass: what a camera sees, by rays that shiny surfaces send on.
//!
//! ```text
//! L(x → o) = B(x)/π + ∫ f_s(i, o) L(x ← i) cosθ_i dω_i     diffuse: stored; specular: followed
//! L(x ← i) = L(y → −i)                                     y: what x sees in direction i
//! ```
//! A mirror, a pane and glass have single directions in their `f_s`: a ray follows each.
//! Gloss has a lobe: a cone of directions.
//!
//! | method         | use it when                             | it fails when              |
//! |----------------|-----------------------------------------|----------------------------|
//!
//! **Not here:** the light that diffuse surfaces send: pass 1 ([`crate::solve`]) brings it.
//! Chapter *The second pass* (L19, L20). Sources: Whitted 1980 (ray tracing); Wallace,
//! Cohen & Greenberg 1987, Sillion & Puech 1989 (two passes).
