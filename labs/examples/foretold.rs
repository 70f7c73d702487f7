//! Report question of the lab `break-it`: what is foretold, and what is found.
//!
//! ```sh
//! cargo run -p labs --example foretold            # your functions
//! cargo run -p labs --example foretold -- answer  # the answer's
//! ```
//! Change the numbers, and look at what follows.

use labs::break_it::report::{Found, errors, growth, misses};
use labs::break_it::{answer, starter};
use labs::lab::chosen;

fn table(title: &str, rows: &[Found]) {
    println!("{title}\n      knob    foretold       found");
    for Found { knob, foretold, found } in rows {
        println!("{knob:10.4}  {foretold:10.4}  {found:10.4}");
    }
}

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    table("Two squares at this distance: by which share too large?", &errors(work));
    table("A lamp of this side, 32 × 32 cells: missed how often?", &misses(work));
    table("A cube of k × k a wall, ρ = 0.9: a bounce leaves", &growth(work));
}
