//! Report question of the lab `solid-angle`: how many digits are right?
//!
//! ```sh
//! cargo run -p labs --example digits            # your functions
//! cargo run -p labs --example digits -- answer  # the answer's
//! ```
//! Change the sizes, and look at what follows.

use labs::lab::chosen;
use labs::solid_angle::report::errors;
use labs::solid_angle::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("   edge   A cosθ/r²   your triangle   by the cosine");
    for exponent in 0..8 {
        let size = 0.1_f64.powi(exponent);
        let e = errors(work, size, 200);
        println!(
            "{size:7.0e}   {:9.1e}   {:13.1e}   {:13.1e}",
            e.small, e.triangle, e.by_cosine
        );
    }
}
