//! Wavefront OBJ and MTL files to a [`Scene`], and back.
//!
//! ```text
//! file ──scan──→ checked statements ──tobj──→ faces, materials ──assemble──→ Scene
//! ```
//!
//! Every `f` is one face, front side counter-clockwise, in file order whatever groups and
//! materials it belongs to. tobj reads the numbers; it gives no line numbers, and some
//! input makes it panic. The scan before it checks every statement, knows its line, and
//! hands on a plain copy.
//!
//! | in the OBJ     | meaning                                                          |
//! |----------------|------------------------------------------------------------------|
//! | `v x y z`      | a corner, in scene units; what follows `z` is ignored            |
//! | `f a b c …`    | a face of 3 corners or more, all above it; `a/t/n`, `-1` allowed |
//! | `usemtl NAME`  | material of the faces below; `NAME` must be defined              |
//! | `mtllib FILE`  | where materials are defined, relative to the OBJ                 |
//! | `# camera …`   | a view (ours): `eye x y z target x y z up x y z fov degrees`     |
//! | `# sky …`      | what shines around (ours): `uniform r g b up x y z`, or overcast |
//! |                | (the zenith's), or `panorama up x y z file NAME.hdr`             |
//!
//! | in the MTL         | meaning                                                      |
//! |--------------------|--------------------------------------------------------------|
//! | `Ke r g b`         | emitted radiosity of the front, W/m² (radiance is `Ke/π`)    |
//! | `Kd r g b`         | diffuse reflectance, `< 1`; 0 when absent                    |
//! | `Td r g b`         | diffuse transmittance (ours), of both sides; `Kd + Td < 1`   |
//! | `Ks r g b`         | specular reflectance: a mirror with `illum` 3, 5, 8; else    |
//! |                    | gloss, a lobe of exponent `Ns`                               |
//! | `illum` 4, 9       | a thin pane of index `Ni`; light goes straight through       |
//! | `illum` 6, 7       | the boundary of a solid, normals outward: rays bend          |
//! | `Tf r g b`         | what panes and glass let through; else `d`, else `1 − Tr`    |
//! | `map_Kd`, `map_Ke` | textures: their mean, in linear light, times the constant    |
//!
//! One number stands for three equal ones. A face without `usemtl` reflects 0.5. Panes and
//! glass need no `Ks`: Fresnel's law reflects.
//! Everything that is ignored although it changes the light is warned of.
//!
//! ```
//! use radiosity::obj;
//! use std::{io, path::Path};
//! let text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n";
//! let nothing = |_: &Path| Err(io::ErrorKind::NotFound.into());
//! let (scene, warnings) = obj::read(Path::new("a.obj"), text.as_bytes(), nothing).unwrap();
//! assert_eq!(scene.face_areas(), [2.0]);
//! assert_eq!(warnings[0].to_string(), "a.obj: faces without `usemtl`: 1; they reflect 0.5");
//! ```
//!
//! **Not here:** curves and surfaces, the patterns of textures.
//! Chapter *The pipeline* (L08). Sources: Wavefront, *Object Files* and *MTL* (1995).

mod export;
mod lines;
mod map;
mod mtl;
mod scan;
mod sky;
mod solid;
mod warning;

pub use export::export;
pub use warning::{Cause, Warning};

use crate::geometry::Rgb;
use crate::material::{Coefficients, Material};
use crate::scene::{Face, FaceId, MaterialId, Scene, SceneError};
use glam::DVec3;
use std::path::{Path, PathBuf};
use std::{fmt, fs, io};

/// Reflectance of faces without a material.
const DEFAULT_REFLECTANCE: f64 = 0.5;

/// At most so many warnings are given one by one.
const MOST_WARNINGS: usize = 20;

/// Why a file makes no scene.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ObjError {
    /// The file at fault: the OBJ or one of its MTL files.
    pub file: PathBuf,
    /// The line at fault, from 1; `None` when the file as a whole is.
    pub line: Option<usize>,
    /// What is wrong, with its value, and what to do about it.
    pub message: String,
}

impl fmt::Display for ObjError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", at(&self.file, self.line))?;
        write!(f, "{}", self.message)
    }
}

impl std::error::Error for ObjError {}

impl ObjError {
    fn new(
        file: &Path,
        line: impl Into<Option<usize>>,
        message: impl ToString,
    ) -> Self {
        ObjError { file: file.into(), line: line.into(), message: message.to_string() }
    }
}

/// `room.obj, line 7: `, the beginning of errors and warnings.
fn at(file: &Path, line: Option<usize>) -> String {
    match line {
        Some(line) => format!("{}, line {line}: ", file.display()),
        None => format!("{}: ", file.display()),
    }
}

/// Reads an OBJ file and the MTL files that it names.
///
/// Returns the scene, named as the file without its extension, and a [`Warning`] of each
/// thing that was repaired or ignored. A scene without any emitter is returned as it is.
///
/// # Errors
/// When a file cannot be read, is no text, or has a statement that makes no sense; when a
/// corner is missing or not finite, a face has no area or crosses itself; when a material
/// is missing or not passive. The error names file, line, value and remedy.
pub fn load(path: impl AsRef<Path>) -> Result<(Scene, Vec<Warning>), ObjError> {
    let path = path.as_ref();
    let bytes = fs::read(path).map_err(|error| {
        ObjError::new(path, None, format!("cannot be read ({error}); check the path"))
    })?;
    read(path, &bytes, |path| fs::read(path))
}

/// As [`load`], with the bytes of the OBJ file `path` given and MTL files read by `open`.
///
/// # Errors
/// Those of [`load`].
pub fn read(
    path: &Path,
    bytes: &[u8],
    open: impl Fn(&Path) -> io::Result<Vec<u8>>,
) -> Result<(Scene, Vec<Warning>), ObjError> {
    let scan = scan::scan(path, bytes)?;
    let used = scan.uses.iter().map(|(name, _)| &name[..]).collect();
    let mut library = mtl::read(path, &scan.libraries, &used, &open)?;
    check_uses(path, &scan.uses, &mut library)?;
    let (faces, used) = faces(path, &scan.text, &library)?;
    let mut warnings = scan.warnings.clone();
    warnings.extend(library.warnings(&used));
    let mut materials = library.materials;
    let line = |face: FaceId| scan.faces[face].0;
    warnings.extend(add_default(path, &faces, &mut materials)?);
    warnings.extend(solid::warnings(path, &faces, &materials, |k| scan.faces[k].0));

    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let (mut scene, repairs) = Scene::assemble(name, materials, faces, scan.camera)
        .map_err(|error| match error {
            SceneError::Face { face, reason } => {
                let (line, text) = &scan.faces[face];
                ObjError::new(path, *line, format!("face `{text}` {reason}"))
            }
            error => ObjError::new(path, None, error),
        })?;
    warnings.extend(repairs.into_iter().map(|repair| {
        let by = repair.by().map(line);
        Warning::new(path, line(repair.face()), Cause::Face { repair, by })
    }));
    if let Some((text, line)) = &scan.sky {
        let folder = path.parent().unwrap_or(Path::new(""));
        scene.sky = sky::read(text, folder, &open)
            .map_err(|message| ObjError::new(path, *line, message))?;
        if scene.sky.is_none() {
            warnings.push(Warning::new(path, *line, Cause::Sky));
        }
    }
    Ok((scene, abridged(path, warnings)))
}

/// Refuses a `usemtl` that names what no library defines.
fn check_uses(
    path: &Path,
    uses: &[(String, usize)],
    library: &mut mtl::Library,
) -> Result<(), ObjError> {
    let unknown = uses.iter().find(|(name, _)| !library.knows(name));
    let Some((name, line)) = unknown else { return Ok(()) };
    let remedy = "define it with `newmtl` in a file named by `mtllib`";
    let message = format!("there is no material `{name}`; {remedy}");
    Err(ObjError::new(path, *line, message))
}

/// Adds the material of faces that name none, if there are any, and tells of it.
fn add_default(
    path: &Path,
    faces: &[Face],
    materials: &mut Vec<Material>,
) -> Result<Option<Warning>, ObjError> {
    let default = MaterialId(materials.len() as u32);
    let unnamed = faces.iter().filter(|face| face.material == default).count();
    if unnamed == 0 {
        return Ok(None);
    }
    let diffuse = Rgb::splat(DEFAULT_REFLECTANCE);
    let coefficients = Coefficients { diffuse, ..Default::default() };
    let grey = Material::new("default", coefficients);
    materials.push(grey.map_err(|error| ObjError::new(path, None, error))?);
    Ok(Some(Warning::new(path, None, Cause::NoMaterial { faces: unnamed })))
}

/// The first warnings, and how many more there are.
fn abridged(path: &Path, mut warnings: Vec<Warning>) -> Vec<Warning> {
    if warnings.len() > MOST_WARNINGS {
        let more = Cause::More { warnings: warnings.len() - MOST_WARNINGS };
        warnings.truncate(MOST_WARNINGS);
        warnings.push(Warning::new(path, None, more));
    }
    warnings
}

/// The faces in file order, as tobj reads them, and which materials they use.
///
/// tobj begins a new model at every change of group or material, in file order.
fn faces(
    path: &Path,
    text: &str,
    library: &mtl::Library,
) -> Result<(Vec<Face>, Vec<bool>), ObjError> {
    let failed = |error: tobj::LoadError| ObjError::new(path, None, error);
    let options = tobj::LoadOptions::default();
    let (models, _) =
        tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| library.for_tobj())
            .map_err(failed)?;
    let count = library.materials.len();
    let mut used = vec![false; count];
    let mut faces = Vec::new();
    for tobj::Model { mesh, .. } in &models {
        let material = mesh.material_id.unwrap_or(count);
        if let Some(used) = used.get_mut(material) {
            *used = true;
        }
        let corner = |&k: &u32| DVec3::from_slice(&mesh.positions[3 * k as usize..]);
        let mut rest = &mesh.indices[..];
        let mut arities = mesh.face_arities.iter();
        while !rest.is_empty() {
            // No arities: all triangles.
            let (face, others) =
                rest.split_at(arities.next().map_or(3, |&n| n as usize));
            let outline = face.iter().map(corner).collect();
            faces.push(Face { outline, material: MaterialId(material as u32) });
            rest = others;
        }
    }
    Ok((faces, used))
}
