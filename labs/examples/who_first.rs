//! Report question of the lab `shoot`: who goes first where lamps are small?
//!
//! ```sh
//! cargo run -p labs --example who_first            # your functions
//! cargo run -p labs --example who_first -- answer  # the answer's
//! ```
//! Change the numbers, and look at what follows.

use labs::lab::chosen;
use labs::shoot::given::By;
use labs::shoot::report::{specks, unshot};
use labs::shoot::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!("unshot, of what is emitted, after");
    println!("specks   each   by           1 shot   10 shots   50 shots   100 shots");
    for (count, brighter) in [(10, 5.0), (50, 5.0), (50, 0.5)] {
        let room = specks(count, brighter);
        for (name, by) in [("power", By::Power), ("radiosity", By::Radiosity)] {
            let left = unshot(work, &room, by, 100);
            let [one, ten, fifty, all] = [0, 9, 49, 99].map(|k: usize| 100.0 * left[k]);
            println!(
                "{count:6}   {brighter:4}   {name:9}   {one:6.1} %   {ten:6.1} %   \
                 {fifty:6.1} %    {all:6.1} %"
            );
        }
    }
}
