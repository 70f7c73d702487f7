//! `radiosity scenes`: what is built in.

use super::output::{Refusal, Terminal, uninterrupted};
use super::values;
use clap::Args;
use radiosity::mesh::Mesh;
use radiosity::obj;
use radiosity::scene::{BuiltIn, Scene, builtins};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Lists the built-in scenes, or writes them as OBJ and MTL files
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity scenes
  radiosity scenes --export scenes
  radiosity scenes cornell-regular --export tiles --edge 0.5
  radiosity solve scenes/cornell.obj -o cornell.csv

With --edge, faces are cut as a mesh of even fineness is: into cells, and these along the
lines where other faces touch them. So every program that reads the file works on the same
pieces.")]
pub struct Scenes {
    /// Only these scenes [default: all]
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Write each scene as NAME.obj and NAME.mtl into this folder
    #[arg(long, value_name = "DIR")]
    export: Option<PathBuf>,
    /// Write elements instead of faces, one `f` each: cells with no edge longer than this,
    /// in the scene's units
    #[arg(long, value_name = "LENGTH", requires = "export")]
    #[arg(allow_hyphen_values = true)]
    edge: Option<f64>,
}

/// More elements than this in one file are a slip of the keyboard.
const MOST_ELEMENTS: f64 = 1e6;

impl Scenes {
    /// Lists or writes.
    pub fn run(&self, terminal: &Terminal) -> Result<(), Refusal> {
        let chosen = self.chosen()?;
        if let Some(edge) = self.edge {
            sensible(edge, &chosen)?;
        }
        let mut list = Vec::new();
        let mut text = String::new();
        for built_in in chosen {
            let mut entry = json!({ "name": built_in.name, "about": built_in.about });
            text += &format!("{:<16} {}\n", built_in.name, built_in.about);
            if let Some(folder) = &self.export {
                let files = self.export(&(built_in.make)(), folder)?;
                entry["files"] = json!(files);
                for file in files {
                    text += &format!("{:<16} -> {}\n", "", file.display());
                }
            }
            list.push(entry);
        }
        terminal.report(&text, || json!({ "scenes": list }))
    }

    /// The scenes that are asked for, in the order of the list.
    fn chosen(&self) -> Result<Vec<BuiltIn>, Refusal> {
        let mut all = builtins();
        let known = |name: &&String| all.iter().any(|b| b.name == name.as_str());
        if let Some(name) = self.names.iter().find(|name| !known(name)) {
            return Err(Refusal(format!(
                "there is no built-in scene `{name}`; `radiosity scenes` lists them"
            )));
        }
        all.retain(|b| self.names.is_empty() || self.names.iter().any(|n| n == b.name));
        Ok(all)
    }

    fn export(&self, scene: &Scene, folder: &Path) -> Result<Vec<PathBuf>, Refusal> {
        let tiled = match self.edge {
            Some(edge) => Some(Mesh::uniform(scene, edge).as_faces(scene)?),
            None => None,
        };
        let _whole = uninterrupted();
        obj::export(tiled.as_ref().unwrap_or(scene), folder).map_err(|error| {
            let folder = folder.display();
            Refusal(format!(
                "{folder} cannot be written to ({error}); choose another folder"
            ))
        })
    }
}

/// Refuses an edge that is no length, or so short that files would not fit.
fn sensible(edge: f64, scenes: &[BuiltIn]) -> Result<(), Refusal> {
    let edge = values::positive("--edge", edge)?;
    for BuiltIn { name, make, .. } in scenes {
        let elements = Mesh::count_uniform(&make(), edge);
        if elements > MOST_ELEMENTS {
            return Err(Refusal(format!(
                "--edge {edge} would cut {name} into {elements:.0} elements, and at most \
                 {MOST_ELEMENTS} are written to a file; choose a longer edge"
            )));
        }
    }
    Ok(())
}
