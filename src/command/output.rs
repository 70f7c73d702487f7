//! Where the command writes: standard output and error, the progress bar, files.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use radiosity::film::write_atomically_by;
use std::io::{self, Write};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Why something cannot be done: one sentence that names what, and what to do about it.
#[derive(Debug)]
pub struct Refusal(pub String);

impl<E: std::error::Error> From<E> for Refusal {
    fn from(error: E) -> Refusal {
        Refusal(error.to_string())
    }
}

/// Where a person or a program reads what the command has to say.
pub struct Terminal {
    quiet: bool,
    json: bool,
    bar: ProgressBar,
}

impl Terminal {
    /// Shows a progress bar unless it should be `quiet` or nobody looks.
    pub fn new(quiet: bool, json: bool) -> Terminal {
        // On standard error; the library hides it where that is no terminal.
        let target = if quiet {
            ProgressDrawTarget::hidden()
        } else {
            ProgressDrawTarget::stderr()
        };
        let bar = ProgressBar::with_draw_target(None, target);
        let style = "{msg:>14} {wide_bar} {pos}/{len} {elapsed}";
        if let Ok(style) = ProgressStyle::with_template(style) {
            bar.set_style(style);
        }
        Terminal { quiet, json, bar }
    }

    /// Moves the bar: what is being done, steps done, steps in all.
    pub fn progress(&self, what: &'static str, done: usize, all: usize) {
        if !self.bar.is_hidden() {
            if self.bar.message() != what {
                self.bar.set_message(what);
            }
            self.bar.set_length(all as u64);
            self.bar.set_position(done as u64);
        }
    }

    /// Tells of something that was repaired or ignored.
    pub fn warn(&self, warning: &str) {
        if !self.quiet {
            self.tell(&format!("warning: {warning}"));
        }
    }

    /// Tells why nothing was done, in one line.
    pub fn refuse(&self, Refusal(why): &Refusal) {
        let line: Vec<&str> = why.split_whitespace().collect();
        self.tell(&format!("error: {}", line.join(" ")));
    }

    fn tell(&self, line: &str) {
        self.bar.finish_and_clear();
        // Standard error may be closed; then nobody wants to know.
        let _ = writeln!(io::stderr(), "{line}");
    }

    /// The report at the end: the JSON object where that was asked for, else the text.
    ///
    /// A reader that closes the pipe early (`| head -1`) has had what it wanted.
    pub fn report(
        &self,
        text: &str,
        json: impl FnOnce() -> serde_json::Value,
    ) -> Result<(), Refusal> {
        self.bar.finish_and_clear();
        let written = if self.json {
            writeln!(io::stdout(), "{}", json())
        } else if self.quiet {
            Ok(())
        } else {
            io::stdout().write_all(text.as_bytes())
        };
        match written.and_then(|()| io::stdout().flush()) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                Err(Refusal(format!("cannot write to standard output: {error}")))
            }
            _ => Ok(()),
        }
    }
}

/// Held while files are written, so that an interrupt finds them whole or not there.
static WRITING: Mutex<()> = Mutex::new(());

/// Lets no interrupt end the command while the guard lives.
pub fn uninterrupted() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the command with exit code 130 on Ctrl-C, once no file is being written.
pub fn watch_for_interrupts() -> Result<(), Refusal> {
    ctrlc::set_handler(|| {
        let _whole = uninterrupted();
        let _ = writeln!(io::stderr(), "\ninterrupted");
        std::process::exit(130);
    })?;
    Ok(())
}

/// Checks, before hours of work, that `path` can be written.
pub fn check_writable(path: &Path) -> Result<(), Refusal> {
    if path.is_dir() || path.file_name().is_none() {
        return Err(Refusal(format!("{} is a folder; name a file", path.display())));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    match folder {
        Some(folder) if !folder.is_dir() => Err(Refusal(format!(
            "{} cannot be written: there is no folder {}; make it first",
            path.display(),
            folder.display()
        ))),
        _ => Ok(()),
    }
}

/// The extension of `path` in small letters, if it is one of `known`.
pub fn extension<'a>(path: &Path, known: &[&'a str]) -> Result<&'a str, Refusal> {
    let given = path.extension().unwrap_or_default().to_string_lossy();
    let found = known.iter().find(|known| given.eq_ignore_ascii_case(known));
    found.copied().ok_or_else(|| {
        let last = known.len() - 1;
        let names = format!(".{} or .{}", known[..last].join(", ."), known[last]);
        Refusal(format!(
            "{} has no ending that is known; end it in {names}",
            path.display()
        ))
    })
}

/// Writes a file, whole or not at all.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Refusal> {
    write_by(path, |file| file.write_all(bytes))
}

/// Writes a file piece by piece, whole or not at all.
pub fn write_by(
    path: &Path,
    pieces: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Refusal> {
    let _whole = uninterrupted();
    write_atomically_by(path, pieces).map_err(|error| {
        Refusal(format!(
            "{} cannot be written ({error}); choose another place",
            path.display()
        ))
    })
}
