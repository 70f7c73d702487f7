//! The book's pictures are snapshots of these tests, and its numbers are claims of theirs.
//!
//! To draw those of a file anew: `INSTA_UPDATE=always cargo test -p book --test pictures
//! sky`, and look.
#![allow(missing_docs)]

#[path = "../../../tests/common/picture.rs"]
mod picture;

mod certificate;
mod directional;
mod display;
mod equation;
mod figures;
mod links;
mod mirrors;
mod patches;
mod plan;
mod second_pass;
mod shooting;
mod side_by_side;
mod sky;
mod solving;
mod transport;
mod versus;
