//! A scene written as OBJ and MTL, such that [`load`](super::load) makes the same scene.

use super::sky;
use crate::geometry::Rgb;
use crate::material::Shine;
use crate::scene::{Camera, Scene};
use crate::sky::{Kind, Sky};
use glam::DVec3;
use std::collections::{HashMap, HashSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Writes `NAME.obj` and `NAME.mtl` into `folder`, which is made if need be, and
/// `NAME.hdr` where the sky is a panorama.
///
/// Faces are written as they were given, uncut, in order of their ids; numbers with as
/// many digits as it takes to read them back bit for bit, but for a panorama, which comes
/// back as exactly as `.hdr` files are. Each file is written under a temporary name and
/// renamed. Returns the paths, the OBJ's first.
///
/// # Errors
/// When the folder cannot be made or written to; the error names the path.
pub fn export(scene: &Scene, folder: impl AsRef<Path>) -> io::Result<Vec<PathBuf>> {
    let folder = folder.as_ref();
    fs::create_dir_all(folder).map_err(|error| naming(folder, error))?;
    let stem = file_name(&scene.name);
    let names = material_names(scene);
    let obj = folder.join(format!("{stem}.obj"));
    let mtl = folder.join(format!("{stem}.mtl"));
    let mut files = vec![obj, mtl];
    if let Some(Kind::Panorama(panorama)) = scene.sky.as_ref().map(Sky::kind) {
        let path = folder.join(format!("{stem}.hdr"));
        let bytes = panorama.encode().map_err(io::Error::other);
        write(&path, &bytes.map_err(|error| naming(&path, error))?)?;
        files.push(path);
    }
    write(&files[1], mtl_text(scene, &names).as_bytes())?;
    write(&files[0], obj_text(scene, &names, &stem).as_bytes())?;
    Ok(files)
}

/// The name with all that file systems dislike replaced by `-`.
fn file_name(name: &str) -> String {
    let fit = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '-' };
    let fit: String = name.chars().map(fit).collect();
    if fit.trim_matches('.').is_empty() { "scene".into() } else { fit }
}

/// The name of each material, on one line, and of no other.
fn material_names(scene: &Scene) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for material in &scene.materials {
        let plain: Vec<&str> = material.name().split_whitespace().collect();
        let plain = if plain.is_empty() { "material".into() } else { plain.join(" ") };
        let numbered = (2..).map(|k| format!("{plain}-{k}"));
        let mut free = std::iter::once(plain.clone()).chain(numbered);
        names.extend(free.find(|name| !names.contains(name)));
    }
    names
}

fn mtl_text(scene: &Scene, names: &[String]) -> String {
    let mut text = format!("# materials of {}\n", one_line(&scene.name));
    // Not those of backs, which come of themselves.
    let named: HashSet<u32> = scene.faces.iter().map(|f| f.material.0).collect();
    let all = (0u32..).zip(scene.materials.iter().zip(names));
    for (_, (material, name)) in all.filter(|(k, _)| named.contains(k)) {
        let rgb = |key: &str, c: Rgb| match c {
            Rgb::ZERO => String::new(),
            Rgb { x, y, z } => format!("{key} {x} {y} {z}\n"),
        };
        let Rgb { x, y, z } = material.diffuse();
        let _ = write!(text, "\nnewmtl {name}\nKd {x} {y} {z}\n");
        text += &rgb("Ke", material.emission());
        text += &rgb("Td", material.translucence());
        text += &match material.shine() {
            Shine::Dull => String::new(),
            Shine::Mirror { reflectance } => rgb("Ks", reflectance) + "illum 3\n",
            Shine::Gloss { reflectance, exponent } => {
                rgb("Ks", reflectance) + &format!("Ns {exponent}\nillum 2\n")
            }
            Shine::Pane { index, tint } => glass(index, tint, 4),
            Shine::Glass { index, tint } => glass(index, tint, 6),
        };
    }
    text
}

fn glass(index: f64, tint: Rgb, model: u32) -> String {
    let Rgb { x, y, z } = tint;
    format!("Ni {index}\nTf {x} {y} {z}\nillum {model}\n")
}

fn obj_text(scene: &Scene, names: &[String], stem: &str) -> String {
    let mut text = format!("# {}\n", one_line(&scene.name));
    let triple = |v: DVec3| format!("{} {} {}", v.x, v.y, v.z);
    let Camera { eye, target, up, fov } = scene.camera;
    let (eye, target, up) = (triple(eye), triple(target), triple(up));
    let _ = writeln!(text, "# camera eye {eye} target {target} up {up} fov {fov}");
    if let Some(sky) = &scene.sky {
        let _ = writeln!(text, "{}", sky::line(sky, &format!("{stem}.hdr")));
    }
    let _ = writeln!(text, "mtllib {stem}.mtl\n");

    let mut numbers: HashMap<[u64; 3], usize> = HashMap::new();
    let mut faces = String::new();
    let mut current = None;
    for face in &scene.faces {
        if current != Some(face.material) {
            current = Some(face.material);
            let _ = writeln!(faces, "usemtl {}", names[face.material]);
        }
        faces += "f";
        for &corner in &face.outline {
            let next = numbers.len() + 1;
            let bits = corner.to_array().map(f64::to_bits);
            let number = *numbers.entry(bits).or_insert_with(|| {
                let _ = writeln!(text, "v {}", triple(corner));
                next
            });
            let _ = write!(faces, " {number}");
        }
        faces += "\n";
    }
    text + "\n" + &faces
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Writes a file under a temporary name and renames it.
fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut temporary = path.as_os_str().to_owned();
    temporary.push(".part");
    let temporary = PathBuf::from(temporary);
    let written =
        fs::write(&temporary, bytes).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|error| {
        let _ = fs::remove_file(&temporary); // the first error is the one to tell
        naming(path, error)
    })
}

/// The error with the path that it is about.
fn naming(path: &Path, error: io::Error) -> io::Error {
    io::Error::new(
        error.kind(),
        format!("{} cannot be written: {error}", path.display()),
    )
}
