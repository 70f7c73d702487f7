//! Report question of the lab `certify`: how many rays until the noise is gone?
//!
//! ```sh
//! cargo run -p labs --example past_the_noise            # your functions
//! cargo run -p labs --example past_the_noise -- answer  # the answer's
//! ```
//! Change the numbers, and look at what follows.

use labs::certify::report::norms;
use labs::certify::{answer, starter};
use labs::lab::chosen;

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("points     rays   truth    two, multiplied   one, squared");
    for points in [100, 10_000] {
        for rays in [1, 4, 16, 64, 256, 1024] {
            let found = norms(work, points, rays);
            println!(
                "{points:6}   {rays:6}   {:5.2} %   {:13.2} %   {:10.2} %",
                100.0 * found.truth,
                100.0 * found.product,
                100.0 * found.square
            );
        }
    }
}
