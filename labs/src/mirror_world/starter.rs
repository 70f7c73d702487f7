//! Your work. The brief is `book/src/labs/mirror-world.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run mirror-world --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::given::{clip, crossing, lambert, plane};
use super::{Cards, Work};
use radiosity::prelude::{DVec3, Plane, dvec3};

/// Task 1: the image of a point.
pub fn image(mirror: Plane, x: DVec3) -> DVec3 {
    todo!("mirror-world, task 1: the image of a point")
}

/// Task 2: the image of what of an outline lies in front of the mirror.
pub fn image_of(mirror: Plane, corners: &[DVec3]) -> Vec<DVec3> {
    todo!("mirror-world, task 2: the image of an outline")
}

/// Task 3: what of an outline is seen through a window.
pub fn through(eye: DVec3, window: &[DVec3], corners: &[DVec3]) -> Vec<DVec3> {
    todo!("mirror-world, task 3: through a window")
}

/// Task 4: the form factor to a lamp by way of a mirror.
pub fn by_mirror(p: DVec3, n: DVec3, mirror: &[DVec3], lamp: &[DVec3]) -> f64 {
    todo!("mirror-world, task 4: the form factor by a mirror")
}

/// Task 5: does light from `x` reach `p` by way of the mirror?
pub fn reaches(x: DVec3, p: DVec3, mirror: &[DVec3], cards: Cards) -> bool {
    todo!("mirror-world, task 5: what stands in the way")
}

/// Task 6: the lamp between two mirrors that face each other.
pub fn corridor(reflectance: f64, levels: usize) -> f64 {
    todo!("mirror-world, task 6: mirrors in mirrors")
}

/// What is handed in.
pub const WORK: Work = Work { image, image_of, through, by_mirror, reaches, corridor };
