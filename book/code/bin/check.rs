//! Runs the gates over the built book: `cargo run -p book --bin check -- book/book`.

use std::env;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Some(folder) = env::args().nth(1) else {
        eprintln!("which folder? usage: check book/book");
        return ExitCode::from(2);
    };
    match book::html::faults(Path::new(&folder)) {
        Ok(faults) if faults.is_empty() => {
            println!("{folder}: every gate passed");
            ExitCode::SUCCESS
        }
        Ok(faults) => {
            faults.iter().for_each(|fault| eprintln!("{fault}"));
            eprintln!("{folder}: {} faults", faults.len());
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("{folder}: {error}; run `mdbook build book` first");
            ExitCode::FAILURE
        }
    }
}
