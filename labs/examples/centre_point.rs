//! Report question of the lab `lambert`: a patch taken at its centre.
//!
//! ```sh
//! cargo run -p labs --example centre_point            # your formula
//! cargo run -p labs --example centre_point -- answer  # the answer's
//! ```
//! Change the distances, and look at what follows.

use labs::lab::chosen;
use labs::lambert::report::{Factors, opposed};
use labs::lambert::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("distance   from the centre    from all of it     error");
    for distance in [0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0] {
        let Factors { from_centre, exact } = opposed(work, distance);
        let percent = 100.0 * (from_centre / exact - 1.0);
        println!(
            "{distance:8.2}   {from_centre:15.6}   {exact:15.6}   {percent:5.2} %"
        );
    }
}
