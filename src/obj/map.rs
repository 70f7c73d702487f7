//! Textures that materials name: found, read, and brought to their mean.

use super::lines::{shown, without_comment};
use crate::geometry::Rgb;
use crate::texture;
use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};

/// The means of texture files, each read once.
pub(super) struct Maps<'a, Open> {
    open: &'a Open,
    means: HashMap<PathBuf, Rgb>,
}

impl<'a, Open: Fn(&Path) -> io::Result<Vec<u8>>> Maps<'a, Open> {
    pub fn new(open: &'a Open) -> Self {
        Maps { open, means: HashMap::new() }
    }

    /// The mean, in linear light, of the texture `name` in `folder`.
    ///
    /// # Errors
    /// A sentence, when it cannot be read or is no texture.
    pub fn mean(&mut self, folder: &Path, name: &str) -> Result<Rgb, String> {
        let name = name.replace('\\', "/");
        let path = folder.join(&name);
        if let Some(mean) = self.means.get(&path) {
            return Ok(*mean);
        }
        let shown = path.display();
        let plain = || (self.open)(&folder.join(without_comment(&name)));
        let bytes = (self.open)(&path).or_else(|_| plain()).map_err(|error| {
            let remedy = "put it there, or remove the line";
            format!("the texture `{shown}` cannot be read ({error}); {remedy}")
        })?;
        let mean = texture::mean(&bytes)
            .map_err(|error| format!("the texture `{shown}` {error}"))?;
        self.means.insert(path, mean);
        Ok(mean)
    }
}

/// The file that a `map_` statement names after its options, such as `-s 2 2 1`.
///
/// # Errors
/// A sentence, when it names none or changes the colours.
pub(super) fn file(words: &str) -> Result<String, String> {
    let mut rest = words.trim();
    while let Some(option) =
        rest.split_whitespace().next().filter(|w| w.starts_with('-'))
    {
        rest = rest[option.len()..].trim_start();
        let most = match option {
            "-mm" => {
                let remedy = "write the colours that are meant into the picture";
                return Err(format!("`-mm` is not read; {remedy}"));
            }
            "-o" | "-s" | "-t" => 3,
            _ => 1,
        };
        for k in 0..most {
            let word = rest.split_whitespace().next().unwrap_or_default();
            if k > 0 && word.parse::<f64>().is_err() {
                break;
            }
            rest = rest[word.len()..].trim_start();
        }
    }
    match rest {
        "" => Err(format!("`{}` names no file; add the name", shown(words))),
        file => Ok(file.into()),
    }
}
