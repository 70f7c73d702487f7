//! A room: a scene made ready for light, once, and borrowed by everybody.
//!
//! ```text
//! H_direct(x) = Σ_k E_k Σ_images k_s F(x → what x sees of the image of emitter k)
//! ```
//!
//! | part       | use it when                              | it fails when                |
//! |------------|------------------------------------------|------------------------------|
//! | [`Direct`] | light comes straight from lamps or sky   | mirrors are curved: rays     |
//!
//! **Not here:** light that was reflected diffusely ([`crate::field`]).
//! Chapters *Patches and elements*, *Mirrors and windows* (L17, L18), *Light from the sky*
//! (L21). Sources: Lambert 1760; Wallace, Cohen & Greenberg 1987 (images of lamps).

mod direct;
mod peaks;
mod portals;

pub use direct::{Direct, OnPiece};
