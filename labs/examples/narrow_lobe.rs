//! Report question of the lab `brdf`: how narrow may a lobe be?
//!
//! ```sh
//! cargo run -p labs --example narrow_lobe            # your functions
//! cargo run -p labs --example narrow_lobe -- answer  # the answer's
//! ```
//! Change the exponents and the rings, and look at what follows.

use labs::brdf::report::errors;
use labs::brdf::{answer, starter};
use labs::lab::chosen;

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("rings   exponent   by rings   by samples");
    for rings in [8, 16, 32] {
        for exponent in [10.0, 100.0, 1e3, 1e4, 1e5] {
            let e = errors(work, exponent, rings, 32);
            println!(
                "{rings:5}   {exponent:8.0e}   {:8.1e}   {:10.1e}",
                e.grid, e.samples
            );
        }
    }
}
