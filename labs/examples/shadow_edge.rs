//! Report question of the lab `substructure`: what is a shadow's edge worth?
//!
//! ```sh
//! cargo run -p labs --example shadow_edge            # your function
//! cargo run -p labs --example shadow_edge -- answer  # the answer's
//! ```
//! Change the tolerance and the smallest area, and look at what follows.

use labs::lab::chosen;
use labs::substructure::report::rounds;
use labs::substructure::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("tolerance   rounds   elements    error   all split");
    for tolerance in [0.1, 0.05, 0.025, 0.0125] {
        let done = rounds(work, tolerance, 1e-7, 14);
        let Some(last) = done.last() else { continue };
        let all = 4_f64.powi(done.len() as i32 - 1);
        println!(
            "{tolerance:9}   {:6}   {:8}   {:6.4}   {all:9.0}",
            done.len() - 1,
            last.elements,
            last.error
        );
    }
}
