//! Writes the generated files of the book: `cargo run -p book --bin generate`.

use std::fs;
use std::io;

fn main() -> io::Result<()> {
    for (path, text) in book::generated::files() {
        fs::write(&path, text)?;
        println!("wrote {}", path.display());
    }
    Ok(())
}
