//! Report question of the lab `radiometry`: how much light comes from a small sun?
//!
//! ```sh
//! cargo run -p labs --example small_sun            # your integral
//! cargo run -p labs --example small_sun -- answer  # the answer's
//! ```
//! Change the sizes, and look at what follows.

use labs::lab::chosen;
use labs::radiometry::report::suns;
use labs::radiometry::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("half-angle   rings   missed   rms error");
    for degrees in [0.27_f64, 1.0, 5.0] {
        for rings in [32, 64, 128] {
            let found = suns(work, degrees.to_radians(), rings, 500);
            let (missed, rms) = (100.0 * found.missed, 100.0 * found.rms);
            println!("{degrees:8.2} °   {rings:5}   {missed:4.0} %   {rms:7.1} %");
        }
    }
}
