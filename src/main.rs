//! The command `radiosity`: arguments in, files and a short report out.
#![forbid(unsafe_code)]

mod command;

fn main() -> std::process::ExitCode {
    command::run()
}
