//! Report question of the lab `gather`: how much is missing when a change is small?
//!
//! ```sh
//! cargo run -p labs --example last_change            # your functions
//! cargo run -p labs --example last_change -- answer  # the answer's
//! ```
//! Change the numbers, and look at what follows.

use labs::gather::report::until_small;
use labs::gather::{answer, starter};
use labs::lab::chosen;

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("reflectance   by        steps   last change   error     error/change");
    for reflectance in [0.5, 0.9, 0.99, 0.999] {
        for (by, newest) in [("bounces", false), ("sweeps", true)] {
            let stop = until_small(work, reflectance, 1e-3, newest);
            println!(
                "{reflectance:<11}   {by:7}   {:5}   {:11.2e}   {:.2e}   {:12.1}",
                stop.steps,
                stop.change,
                stop.error,
                stop.error / stop.change
            );
        }
    }
}
