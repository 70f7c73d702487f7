//! What is told of a file that is read nevertheless.

use super::{DEFAULT_REFLECTANCE, at};
use crate::geometry::Rgb;
use crate::scene::Repair;
use std::fmt;
use std::path::{Path, PathBuf};

/// Something in a file that was repaired or ignored.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Warning {
    /// The OBJ or one of its MTL files.
    pub file: PathBuf,
    /// The line, from 1; `None` when the file as a whole is meant.
    pub line: Option<usize>,
    /// What it was.
    pub cause: Cause,
}

/// What was repaired or ignored.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// A statement of this key is not read; the first one is told.
    NotRead {
        /// The key.
        key: String,
    },
    /// A comment that begins as a camera does is none.
    Camera,
    /// A comment that begins as a sky does is none.
    Sky,
    /// So many faces have no material.
    NoMaterial {
        /// How many.
        faces: usize,
    },
    /// A material is defined twice; the last definition counts.
    Redefined {
        /// Its name.
        material: String,
    },
    /// A material is partly transparent, but no glass.
    Opaque {
        /// Its name.
        material: String,
    },
    /// A glass has `Ks`; Fresnel's law counts.
    Fresnel {
        /// Its name.
        material: String,
        /// `Ks`.
        reflectance: Rgb,
    },
    /// Of a texture the mean counts.
    Texture {
        /// The material's name.
        material: String,
        /// The file.
        texture: String,
        /// What it changes: `Kd` or `Ke`.
        key: &'static str,
        /// What that is in the mean.
        value: Rgb,
    },
    /// A solid has an edge at which only one face ends.
    Open {
        /// The material's name.
        material: String,
    },
    /// The normals of a solid lead inwards.
    InsideOut {
        /// The material's name.
        material: String,
    },
    /// A face was changed.
    Face {
        /// How.
        repair: Repair,
        /// The line of the face that it had to give way to.
        by: Option<usize>,
    },
    /// So many more warnings are not told.
    More {
        /// How many.
        warnings: usize,
    },
}

impl Warning {
    pub(super) fn new(
        file: &Path,
        line: impl Into<Option<usize>>,
        cause: Cause,
    ) -> Warning {
        Warning { file: file.into(), line: line.into(), cause }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}{}", at(&self.file, self.line), self.cause)
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Cause::NotRead { key } => {
                write!(f, "`{key}` statements are not read; only flat faces (`f`) are")
            }
            Cause::Camera => f.write_str(
                "this camera is not understood and ignored; write `# camera eye x y z \
                 target x y z up x y z fov degrees`",
            ),
            Cause::Sky => f.write_str(
                "this sky is not understood and ignored; write `# sky uniform r g b up x y \
                 z`, or `# sky overcast r g b up x y z`, or `# sky panorama up x y z file \
                 NAME.hdr`",
            ),
            Cause::NoMaterial { faces } => write!(
                f,
                "faces without `usemtl`: {faces}; they reflect {DEFAULT_REFLECTANCE}"
            ),
            Cause::Face { repair, by: None } => repair.fmt(f),
            Cause::Face { repair, by: Some(line) } => {
                let by = repair.by().map_or(0, |by| by.0);
                write!(f, "{repair}; face {by} is on line {line}")
            }
            Cause::More { warnings } => write!(f, "{warnings} more warnings like these"),
            _ => self.of_material(f),
        }
    }
}

impl Cause {
    fn of_material(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Cause::Redefined { material } => write!(
                f,
                "material `{material}` is defined again below; the last one counts"
            ),
            Cause::Opaque { material } => write!(
                f,
                "material `{material}` is partly transparent but no glass (illum 4, 6, 7 \
                 or 9); it is taken as opaque"
            ),
            Cause::Fresnel { material, reflectance: Rgb { x, y, z } } => write!(
                f,
                "material `{material}` has Ks ({x}, {y}, {z}), which is ignored: glass \
                 reflects as Fresnel's law says"
            ),
            Cause::Texture { material, texture, key, value } => {
                let Rgb { x, y, z } = (1e4 * value).round() / 1e4;
                let texture = super::lines::shown(texture);
                write!(
                    f,
                    "material `{material}` has a texture `{texture}`, of which the mean \
                     counts, not the pattern: {key} ({x}, {y}, {z})"
                )
            }
            Cause::Open { material } => write!(
                f,
                "the solid of `{material}` (illum 6 or 7) does not close: this face has an \
                 edge that no other face meets; close it, or write illum 4 for a thin pane"
            ),
            Cause::InsideOut { material } => write!(
                f,
                "the solid of `{material}` (illum 6 or 7) is inside out: the corners of its \
                 faces must run counter-clockwise seen from outside; turn them round"
            ),
            _ => Ok(()), // of no material
        }
    }
}
