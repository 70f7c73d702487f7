//! OBJ and MTL texts read as files, for tests of what is read and of what is refused.
#![allow(dead_code, missing_docs)] // each test uses its part

use radiosity::obj;
use radiosity::scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// Reads `obj` as `room.obj`, beside which there is only `room.mtl`.
pub fn read(obj: &str, mtl: &str) -> Result<(Scene, Vec<String>), obj::ObjError> {
    let read =
        obj::read(Path::new("room.obj"), obj.as_bytes(), |path| match path.to_str() {
            Some("room.mtl") => Ok(mtl.into()),
            _ => Err(io::ErrorKind::NotFound.into()),
        });
    read.map(|(scene, warnings)| (scene, words(&warnings)))
}

/// What the warnings say.
pub fn words(warnings: &[obj::Warning]) -> Vec<String> {
    warnings.iter().map(|warning| warning.to_string()).collect()
}

pub fn sound(obj: &str, mtl: &str) -> (Scene, Vec<String>) {
    read(obj, mtl).unwrap_or_else(|error| panic!("{error}"))
}

pub fn message(obj: &str, mtl: &str) -> String {
    match read(obj, mtl) {
        Ok(_) => panic!("accepted:\n{obj}\n{mtl}"),
        Err(error) => error.to_string(),
    }
}

/// An empty folder of this test's own.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

pub const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
