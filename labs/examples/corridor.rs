//! Report question of the lab `mirror-world`: how many levels does a mirror need?
//!
//! ```sh
//! cargo run -p labs --example corridor            # your functions
//! cargo run -p labs --example corridor -- answer  # the answer's
//! ```
//! Change the reflectances, and look at what follows.

use labs::lab::chosen;
use labs::mirror_world::report::{by_mirror_up_to, missing};
use labs::mirror_world::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("missing   of ρ = 1    ρ = 0.9    ρ = 0.5");
    for levels in [0, 1, 2, 4, 8, 16, 32] {
        let of = |rho| 100.0 * missing(work, rho, levels);
        println!(
            "{levels:2} levels  {:7.3} %  {:7.3} %  {:7.3} %",
            of(1.0),
            of(0.9),
            of(0.5)
        );
    }
    println!();
    let whole = by_mirror_up_to(work, 10.0);
    for height in [0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7] {
        let factor = by_mirror_up_to(work, height);
        println!(
            "mirror up to {height:.2} m: F = {factor:.9}, {:.3} of all",
            factor / whole
        );
    }
}
