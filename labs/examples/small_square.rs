//! Report question of the lab `hemicube`: how often is a small square missed, and how far is it off?
//!
//! ```sh
//! cargo run -p labs --example small_square            # your hemicube
//! cargo run -p labs --example small_square -- answer  # the answer's
//! ```
//! Change the sizes, and look at what follows.

use labs::hemicube::report::small_squares;
use labs::hemicube::{answer, starter};
use labs::lab::chosen;

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("   n   side   missed   rms error");
    for side in [0.02, 0.1] {
        for n in [32, 64, 128] {
            let seen = small_squares(work, n, side, 500);
            let (missed, rms) = (100.0 * seen.missed, 100.0 * seen.rms);
            println!("{n:4}   {side:.2}   {missed:4.0} %   {rms:7.1} %");
        }
    }
}
