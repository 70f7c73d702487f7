//! `radiosity scenes`: what is built in.

use super::output::{Refusal, Terminal, uninterrupted};
use clap::Args;
use radiosity::{obj, scene};
use serde_json::json;
use std::path::PathBuf;

/// Lists the built-in scenes, or writes them as OBJ and MTL files
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity scenes
  radiosity scenes --export scenes
  radiosity solve scenes/cornell.obj -o cornell.csv")]
pub struct Scenes {
    /// Write each scene as NAME.obj and NAME.mtl into this folder
    #[arg(long, value_name = "DIR")]
    export: Option<PathBuf>,
}

impl Scenes {
    /// Lists or writes.
    pub fn run(&self, terminal: &Terminal) -> Result<(), Refusal> {
        let mut list = Vec::new();
        let mut text = String::new();
        for built_in in scene::builtins() {
            let mut entry = json!({ "name": built_in.name, "about": built_in.about });
            text += &format!("{:<16} {}\n", built_in.name, built_in.about);
            if let Some(folder) = &self.export {
                let _whole = uninterrupted();
                let files = obj::export(&(built_in.make)(), folder).map_err(|error| {
                    let folder = folder.display();
                    Refusal(format!(
                        "{folder} cannot be written to ({error}); choose another folder"
                    ))
                })?;
                entry["files"] = json!(files);
                for file in files {
                    text += &format!("{:<16} -> {}\n", "", file.display());
                }
            }
            list.push(entry);
        }
        terminal.report(&text, || json!({ "scenes": list }))
    }
}
