//! The command `radiosity`.
fn main() {}
