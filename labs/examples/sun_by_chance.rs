//! Report question of the lab `sky`: what does a small sun cost?
//!
//! ```sh
//! cargo run -p labs --example sun_by_chance            # your functions
//! cargo run -p labs --example sun_by_chance -- answer  # the answer's
//! ```
//! Change the number of rays, and look at what follows.

use labs::lab::chosen;
use labs::sky::report::errors;
use labs::sky::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("panorama      even   by brightness      of 256 rays");
    for width in [8, 16, 32, 64, 128] {
        let e = errors(work, width, 256, 200);
        println!(
            "{:>4} × {:<3} {:7.1} % {:13.1} %",
            width,
            width / 2,
            100.0 * e.even,
            100.0 * e.bright
        );
    }
}
