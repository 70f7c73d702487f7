//! The command `radiosity`: arguments in, files and a short report out.
#![forbid(unsafe_code)]

mod command;

/// Counts what is held: `chart` tells the most.
#[cfg(feature = "memory")]
#[global_allocator]
static MEMORY: peak_alloc::PeakAlloc = peak_alloc::PeakAlloc;

fn main() -> std::process::ExitCode {
    command::run()
}
