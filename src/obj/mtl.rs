//! Materials: the statements of MTL files checked, read by tobj, and made passive.

use super::lines::{Statement, numbers, shown, statements, without_comment};
use super::map::{self, Maps};
use super::{Cause, ObjError, Warning};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material, MaterialError, Shine};
use std::collections::{HashMap, HashSet};
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

/// Where something is written.
type LinePlace = (PathBuf, usize);

/// All materials of all MTL files.
#[derive(Default)]
pub(super) struct Library {
    /// In file order.
    pub materials: Vec<Material>,
    /// Which material a name means; the last of that name.
    pub index: HashMap<String, usize>,
    /// As tobj has them.
    raw: Vec<tobj::Material>,
    /// Warnings about materials that count only when they are used.
    notes: Vec<(usize, Warning)>,
    /// Warnings that count always.
    warnings: Vec<Warning>,
}

/// Reads the MTL files `named` by the OBJ file `obj`, each once, and the textures of the
/// materials that are `used`.
pub(super) fn read(
    obj: &Path,
    named: &[(String, usize)],
    used: &HashSet<&str>,
    open: impl Fn(&Path) -> io::Result<Vec<u8>>,
) -> Result<Library, ObjError> {
    let folder = obj.parent().unwrap_or(Path::new(""));
    let mut read: Vec<PathBuf> = Vec::new();
    let mut scan = MtlScan::default();
    for (name, line) in named {
        let files = files(folder, name, &open).map_err(|(file, error)| {
            let message = format!(
                "its material file `{}` cannot be read ({error}); put it there or remove \
                 the `mtllib` line",
                file.display()
            );
            ObjError::new(obj, *line, message)
        })?;
        for (file, bytes) in files {
            if !read.contains(&file) {
                scan.file(&file, &bytes)?;
                read.push(file);
            }
        }
    }
    scan.library(obj, used, &open)
}

/// A file, and its bytes.
type OpenFile = (PathBuf, Vec<u8>);

/// The files that an `mtllib` statement names. A name may hold spaces
/// and `#`; else a comment stands there, or several names do.
fn files(
    folder: &Path,
    named: &str,
    open: impl Fn(&Path) -> io::Result<Vec<u8>>,
) -> Result<Vec<OpenFile>, (PathBuf, io::Error)> {
    let file = |name: &str| {
        let file = folder.join(name);
        match open(&file) {
            Ok(bytes) => Ok((file, bytes)),
            Err(error) => Err((file, error)),
        }
    };
    let plain = without_comment(named);
    let whole = || file(named).or_else(|_| file(plain)).map(|file| vec![file]);
    whole().or_else(|_| plain.split_whitespace().map(file).collect())
}

/// Checked statements of MTL files.
#[derive(Default)]
struct MtlScan {
    /// The plain copy that tobj reads.
    text: String,
    /// Where each material begins.
    places: Vec<LinePlace>,
    /// For each material, where its keys stand.
    keys: Vec<HashMap<String, LinePlace>>,
    warnings: Vec<Warning>,
}

impl MtlScan {
    fn file(&mut self, file: &Path, bytes: &[u8]) -> Result<(), ObjError> {
        let mut begun = false;
        for statement in statements(file, bytes)? {
            let (key, rest) = statement.key();
            let failed = |message: String| ObjError::new(file, statement.line, message);
            let place = (file.to_path_buf(), statement.line);
            let words = match key {
                _ if statement.is_comment() => continue,
                "newmtl" if rest.is_empty() => {
                    return Err(failed("`newmtl` names nothing; add the name".into()));
                }
                "newmtl" => {
                    begun = true;
                    self.places.push(place.clone());
                    self.keys.push(HashMap::new());
                    rest.into()
                }
                "Kd" | "Ks" | "Ke" | "Td" | "Tf" => {
                    triple(&statement).map_err(failed)?
                }
                "Ns" | "Ni" | "d" | "Tr" => single(&statement).map_err(failed)?,
                "illum" => model(rest).map_err(failed)?,
                "map_Kd" | "map_Ke" => map::file(rest).map_err(failed)?,
                _ => continue, // other reflection models, and how it is displayed
            };
            if !begun {
                let message =
                    format!("`{key}` stands before any `newmtl`; move it below");
                return Err(failed(message));
            }
            let _ = writeln!(self.text, "{key} {words}"); // a String takes all
            if let Some(keys) = self.keys.last_mut() {
                keys.insert(key.into(), place);
            }
        }
        Ok(())
    }

    fn library(
        self,
        obj: &Path,
        used: &HashSet<&str>,
        open: &impl Fn(&Path) -> io::Result<Vec<u8>>,
    ) -> Result<Library, ObjError> {
        let (raw, index) = tobj::load_mtl_buf(&mut self.text.as_bytes())
            .map_err(|error| ObjError::new(obj, None, error))?;
        let MtlScan { places, keys, mut warnings, .. } = self;
        let mut materials = Vec::with_capacity(raw.len());
        let mut notes = Vec::new();
        let mut maps = Maps::new(open);
        let used: HashSet<&str> =
            used.iter().map(|name| without_comment(name)).collect();
        for (k, raw) in raw.iter().enumerate() {
            let find = |key: &str| keys[k].get(key).unwrap_or(&places[k]);
            let failed = |(key, message): Note| {
                let (file, line) = find(key);
                ObjError::new(file, *line, message)
            };
            let seen = used.contains(without_comment(&raw.name));
            let [diffuse, emission] =
                [("map_Kd", &raw.diffuse), ("map_Ke", &raw.emissive)].map(
                    |(key, constant)| {
                        let texture = texture(raw, key).map(|name| {
                            // What nobody looks at is not opened.
                            let folder = find(key).0.parent().unwrap_or(Path::new(""));
                            if seen { maps.mean(folder, name) } else { Ok(Rgb::ZERO) }
                        });
                        let texture = texture.transpose().map_err(|why| {
                            failed((key, format!("{why} (texture of `{}`)", raw.name)))
                        });
                        texture.map(|texture| coloured(*constant, texture))
                    },
                );
            let material = passive(raw, diffuse?, emission?).map_err(failed)?;
            notes.extend(self::notes(raw, &material).into_iter().map(
                |(key, cause)| {
                    let (file, line) = find(key);
                    (k, Warning::new(file, *line, cause))
                },
            ));
            materials.push(material);
            if index[&raw.name] != k {
                let (file, line) = &places[k];
                let cause = Cause::Redefined { material: raw.name.clone() };
                warnings.push(Warning::new(file, *line, cause));
            }
        }
        Ok(Library { materials, index, raw, notes, warnings })
    }
}

impl Library {
    /// What tobj's loader of material files is to return.
    pub fn for_tobj(&self) -> tobj::MTLLoadResult {
        let index = self.index.iter().map(|(name, k)| (name.clone(), *k)).collect();
        Ok((self.raw.clone(), index))
    }

    /// Lets `name` mean what it says, or, when no material has that very name, what it says
    /// but for a comment behind it; `false` when that is nothing.
    pub fn knows(&mut self, name: &str) -> bool {
        let plain = without_comment(name);
        let alike = |raw: &tobj::Material| without_comment(&raw.name) == plain;
        let found = self.index.get(name).copied();
        let found = found.or_else(|| self.raw.iter().rposition(alike));
        found.is_some_and(|k| *self.index.entry(name.into()).or_insert(k) == k)
    }

    /// What is to be said, given which materials are `used`.
    pub fn warnings(&self, used: &[bool]) -> Vec<Warning> {
        let notes = self.notes.iter().filter(|(k, _)| used[*k]).map(|(_, note)| note);
        self.warnings.iter().chain(notes).cloned().collect()
    }
}

/// Three numbers; one stands for three equal ones.
fn triple(statement: &Statement) -> Result<String, String> {
    let (key, rest) = statement.key();
    match numbers(rest)?[..] {
        [x] => Ok(format!("{x} {x} {x}")),
        [x, y, z] => Ok(format!("{x} {y} {z}")),
        _ => Err(format!(
            "`{}` needs one or three numbers; write `{key} r g b`",
            shown(&statement.text)
        )),
    }
}

/// One number.
fn single(statement: &Statement) -> Result<String, String> {
    let (key, rest) = statement.key();
    let rest = rest.trim_start_matches("-halo");
    match numbers(rest)?[..] {
        [x] => Ok(x.to_string()),
        _ => Err(format!(
            "`{}` needs one number; write `{key} x`",
            shown(&statement.text)
        )),
    }
}

/// The number of an illumination model.
fn model(words: &str) -> Result<String, String> {
    match numbers(words).as_deref() {
        Ok(&[model]) if (0.0..=10.0).contains(&model) && model.fract() == 0.0 => {
            Ok(model.abs().to_string()) // −0 is 0
        }
        _ => Err(format!(
            "`illum {}` is not an illumination model; write 0 to 10",
            shown(words)
        )),
    }
}

/// What is said of a material: the key that it is about, and the rest of the sentence.
type Note = (&'static str, String);

/// Does the material pass and mirror light by Fresnel's law?
fn is_glass(raw: &tobj::Material) -> bool {
    matches!(raw.illumination_model, Some(4 | 6 | 7 | 9))
}

fn rgb(values: Option<[f64; 3]>) -> Rgb {
    values.map_or(Rgb::ZERO, Rgb::from_array)
}

/// `Td`, which tobj hands on as text.
fn transmitted(raw: &tobj::Material) -> Rgb {
    let text = raw.unknown_param.get("Td");
    let values = text.and_then(|text| numbers(text).ok()).unwrap_or_default();
    values.try_into().map_or(Rgb::ZERO, Rgb::from_array)
}

/// The texture file that `key` names.
fn texture<'a>(raw: &'a tobj::Material, key: &str) -> Option<&'a str> {
    let named = match key {
        "map_Kd" => raw.diffuse_texture.as_ref(),
        _ => raw.unknown_param.get(key),
    };
    named.map(|name| &name[..])
}

/// A constant, 0 where there is none, or that times the mean of a texture, 1 where there
/// is none.
fn coloured(constant: Option<[f64; 3]>, texture: Option<Rgb>) -> Rgb {
    match texture {
        Some(mean) => constant.map_or(Rgb::ONE, Rgb::from_array) * mean,
        None => rgb(constant),
    }
}

/// Makes the material, or says which key forbids it.
fn passive(
    raw: &tobj::Material,
    diffuse: Rgb,
    emission: Rgb,
) -> Result<Material, Note> {
    let translucence = transmitted(raw);
    let shine = shine(raw);
    let coefficients = Coefficients { emission, diffuse, translucence, shine };
    Material::new(&raw.name, coefficients).map_err(|error| {
        let key = match error {
            MaterialError::Shine { key: "Tf", .. } => tint(raw).0,
            MaterialError::NotANumber { key, .. }
            | MaterialError::Shine { key, .. } => key,
            MaterialError::Diffuse { .. } if translucence != Rgb::ZERO => "Td",
            MaterialError::Diffuse { .. } => "Kd",
            MaterialError::NotPassive { .. } => "Ks",
        };
        (key, error.to_string())
    })
}

/// The gloss exponent where none is given: a wide highlight.
const DEFAULT_GLOSS: f64 = 10.0;

/// What the illumination model makes of `Ks`, `Ns`, `Ni` and `Tf`.
fn shine(raw: &tobj::Material) -> Shine {
    let reflectance = rgb(raw.specular);
    let index = raw.optical_density.unwrap_or(1.5);
    match raw.illumination_model {
        Some(4 | 9) => Shine::Pane { index, tint: tint(raw).1 },
        Some(6 | 7) => Shine::Glass { index, tint: tint(raw).1 },
        _ if reflectance == Rgb::ZERO => Shine::Dull,
        Some(3 | 5 | 8) => Shine::Mirror { reflectance },
        _ => {
            let exponent = raw.shininess.unwrap_or(DEFAULT_GLOSS);
            Shine::Gloss { reflectance, exponent }
        }
    }
}

/// `Tf`; else `d`, else `1 − Tr`, else 1; and which of them it is.
fn tint(raw: &tobj::Material) -> (&'static str, Rgb) {
    if let Some(&[r, g, b]) = given(raw, "Tf").as_deref() {
        return ("Tf", Rgb::new(r, g, b));
    }
    match (raw.dissolve, given(raw, "Tr").as_deref()) {
        (Some(d), _) => ("d", Rgb::splat(d)),
        (None, Some(&[tr])) => ("Tr", Rgb::splat(1.0 - tr)),
        _ => ("Tf", Rgb::ONE),
    }
}

/// The numbers of a key that tobj hands on as text.
fn given(raw: &tobj::Material, key: &str) -> Option<Vec<f64>> {
    numbers(raw.unknown_param.get(key)?).ok()
}

/// What of the material is ignored although it is given, and by which key.
fn notes(raw: &tobj::Material, material: &Material) -> Vec<(&'static str, Cause)> {
    let mut notes = Vec::new();
    let name = || raw.name.clone();
    let glass = is_glass(raw);
    let given = |key: &str| given(raw, key).unwrap_or_default();
    // Exporters write 1 for clear, and 0 for what lets nothing through.
    let tinted = given("Tf").iter().any(|x| *x != 0.0 && *x != 1.0);
    for (key, passes) in [
        ("d", raw.dissolve.is_some_and(|d| d != 1.0)),
        ("Tr", given("Tr").iter().any(|x| *x != 0.0)),
        ("Tf", tinted),
    ] {
        if passes && !glass {
            notes.push((key, Cause::Opaque { material: name() }));
        }
    }
    let reflectance = rgb(raw.specular);
    if glass && reflectance != Rgb::ZERO {
        notes.push(("Ks", Cause::Fresnel { material: name(), reflectance }));
    }
    for (map, key, value) in
        [("map_Kd", "Kd", material.diffuse()), ("map_Ke", "Ke", material.emission())]
    {
        if let Some(texture) = texture(raw, map) {
            let texture = texture.into();
            notes.push((map, Cause::Texture { material: name(), texture, key, value }));
        }
    }
    notes
}
