//! Report question of the lab `cone`: how many rays does the rim of a lamp need?
//!
//! ```sh
//! cargo run -p labs --example lamp_in_cone            # your functions
//! cargo run -p labs --example lamp_in_cone -- answer  # the answer's
//! ```
//! Change the numbers of rays, and look at what follows.

use labs::cone::report::noise;
use labs::cone::{answer, starter};
use labs::lab::chosen;

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!(" rays   one in each cell   anywhere");
    for strata in [1, 2, 4, 8, 16, 32, 64] {
        let found = noise(work, strata, 400);
        println!(
            "{:5}   {:16.5}   {:8.5}",
            strata * strata,
            found.stratified,
            found.anywhere
        );
    }
}
