//! Ctrl-C ends the command with 130 and leaves no file behind.
#![cfg(unix)]

use super::Folder;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

#[test]
fn an_interrupt_ends_with_130_and_writes_nothing() {
    let folder = Folder::new();
    folder.run("scenes --export .").done();
    let before = folder.names();
    // The red wall is off its plane: the warning says that the work has begun.
    let arguments =
        "solve cornell.obj -o x.csv --form-factors analytic --tolerance 1e-9";
    let mut command = folder.command(arguments);
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command runs");
    let mut said = BufReader::new(child.stderr.take().expect("standard error"));
    let mut line = String::new();
    said.read_line(&mut line).expect("a line");
    assert!(line.starts_with("warning: "), "{line}");
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("kill").success());
    assert_eq!(child.wait().expect("an end").code(), Some(130));
    assert_eq!(folder.names(), before);
}
