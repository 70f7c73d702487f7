//! What is read and written: scenes, OBJ and MTL, pictures.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;

mod film;
mod interpolation;
mod obj;
mod obj_comments;
mod obj_garbage;
mod obj_limits;
mod obj_shiny;
mod scenes;
mod scenes_camera;
mod scenes_overlap;
mod split;
