//! Checks the statements of an OBJ file and writes the plain copy that tobj reads.

use super::lines::{Statement, numbers, shown, statements, without_comment};
use super::{Cause, ObjError, Warning};
use crate::scene::Camera;
use glam::DVec3;
use std::fmt::Write;
use std::path::Path;

/// What an OBJ file says, checked.
#[derive(Default)]
pub(super) struct Scan {
    /// Its `v`, `f` and `usemtl` statements as tobj likes them.
    pub text: String,
    /// For each face its line and its text, for messages.
    pub faces: Vec<(usize, String)>,
    /// The `mtllib` statements, with their lines.
    pub libraries: Vec<(String, usize)>,
    /// The `usemtl` statements, with their lines.
    pub uses: Vec<(String, usize)>,
    /// The camera, if a comment gives one.
    pub camera: Option<Camera>,
    /// The sky, if a comment gives one, and the line of it.
    pub sky: Option<(String, usize)>,
    /// What was ignored.
    pub warnings: Vec<Warning>,
}

/// Statements that do not change the light: indices, groups, display.
const HARMLESS: [&str; 18] = [
    "vt",
    "vn",
    "vp",
    "g",
    "o",
    "s",
    "l",
    "p",
    "mg",
    "lod",
    "bevel",
    "c_interp",
    "d_interp",
    "shadow_obj",
    "trace_obj",
    "maplib",
    "usemap",
    "end",
];

/// How descriptions of skies begin.
const SKIES: [&str; 4] = ["uniform ", "overcast ", "cie ", "panorama "];

/// Checks every statement of the OBJ file `file`.
pub(super) fn scan(file: &Path, bytes: &[u8]) -> Result<Scan, ObjError> {
    let mut scan = Scan::default();
    // tobj asks for all materials at once, before any face.
    scan.text.push_str("mtllib all\n");
    let mut corners = 0;
    let mut unknown: Vec<String> = Vec::new();
    for statement in statements(file, bytes)? {
        let failed = |message: String| ObjError::new(file, statement.line, message);
        let (key, rest) = statement.key();
        match key {
            "v" => {
                let position = corner(rest).map_err(failed)?;
                let _ = writeln!(scan.text, "v {position}"); // a String takes all
                corners += 1;
            }
            "f" => {
                let face = indices(rest, corners).map_err(failed)?;
                let _ = writeln!(scan.text, "f{face}");
                scan.faces.push((statement.line, shown(&statement.text)));
            }
            "usemtl" | "mtllib" if rest.is_empty() => {
                return Err(failed(format!("`{key}` names nothing; add the name")));
            }
            "usemtl" => {
                let _ = writeln!(scan.text, "usemtl {rest}");
                scan.uses.push((rest.into(), statement.line));
            }
            "mtllib" => scan.libraries.push((rest.into(), statement.line)),
            _ if statement.is_comment() => scan.comment(file, &statement),
            _ if HARMLESS.contains(&key) => {}
            _ if unknown.iter().any(|known| known == key) => {}
            _ => {
                let cause = Cause::NotRead { key: shown(key) };
                scan.warnings.push(Warning::new(file, statement.line, cause));
                unknown.push(key.into());
            }
        }
    }
    match scan.faces.is_empty() {
        true => Err(no_face(file, bytes)),
        false => Ok(scan),
    }
}

fn no_face(file: &Path, bytes: &[u8]) -> ObjError {
    let empty = bytes.iter().all(u8::is_ascii_whitespace);
    let what = if empty { "is empty" } else { "has no face" };
    let message = format!("{what}; a scene needs at least one `f` statement");
    ObjError::new(file, None, message)
}

impl Scan {
    /// Takes up what a comment says of the sky or the camera.
    fn comment(&mut self, file: &Path, statement: &Statement) {
        if let Some(sky) = statement.text.strip_prefix("# sky ") {
            // Whatever else is said of the sky is no description of one.
            if SKIES.iter().any(|kind| sky.starts_with(kind)) {
                self.sky = Some((sky.into(), statement.line));
            }
        }
        let camera = statement.text.strip_prefix("# camera ").map(without_comment);
        if let Some(camera) = camera.filter(|text| text.starts_with("eye ")) {
            self.camera = parse_camera(camera);
            if self.camera.is_none() {
                self.warnings.push(Warning::new(file, statement.line, Cause::Camera));
            }
        }
    }
}

/// The three coordinates, in words; more numbers (weight, colour) are dropped.
fn corner(rest: &str) -> Result<String, String> {
    let rest = rest.split('#').next().unwrap_or_default();
    if numbers(rest)?.len() < 3 {
        let shown = shown(rest);
        return Err(format!("corner `v {shown}` needs three coordinates; complete it"));
    }
    Ok(rest.split_whitespace().take(3).collect::<Vec<_>>().join(" "))
}

/// The corner numbers of a face, of which `corners` are known, in words.
fn indices(rest: &str, corners: i64) -> Result<String, String> {
    let rest = rest.split('#').next().unwrap_or_default();
    let mut face = String::new();
    let mut count = 0;
    for word in rest.split_whitespace() {
        let mut parts = word.split('/');
        let index = parts.next().unwrap_or_default();
        let others = parts.clone().count() <= 2
            && parts.all(|p| p.is_empty() || p.parse::<i64>().is_ok());
        let digits = index.trim_start_matches(['-', '+']);
        if !others || digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            let word = shown(word);
            return Err(format!("`{word}` is not a corner of a face; write `f 1 2 3`"));
        }
        let known = match index.parse::<i64>() {
            Ok(k) => (1..=corners).contains(&k) || (-corners..0).contains(&k),
            Err(_) => false, // too many digits, or two signs
        };
        if !known {
            return Err(format!(
                "corner {} does not exist: {corners} stand above this face, counted from \
                 1, or back from -1; correct the number",
                shown(index)
            ));
        }
        face.push(' ');
        face.push_str(index);
        count += 1;
    }
    if count < 3 {
        return Err(format!(
            "a face needs at least 3 corners, not {count}; complete it"
        ));
    }
    Ok(face)
}

/// Reads `eye x y z target x y z up x y z fov d`; `None` when it is not that.
fn parse_camera(text: &str) -> Option<Camera> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let &["eye", ax, ay, az, "target", bx, by, bz, "up", ux, uy, uz, "fov", fov] =
        &words[..]
    else {
        return None;
    };
    let vector = |x: &str, y: &str, z: &str| {
        let v = numbers(&format!("{x} {y} {z}")).ok()?;
        Some(DVec3::from_slice(&v))
    };
    let camera = Camera {
        eye: vector(ax, ay, az)?,
        target: vector(bx, by, bz)?,
        up: vector(ux, uy, uz)?,
        fov: fov.parse().ok()?,
    };
    let across = (camera.target - camera.eye).cross(camera.up);
    let usable = across != DVec3::ZERO && camera.fov > 0.0 && camera.fov < 180.0;
    usable.then_some(camera)
}
