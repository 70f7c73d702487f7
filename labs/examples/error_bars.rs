//! Report question of the lab `sampling`: are the error bars to be believed?
//!
//! ```sh
//! cargo run -p labs --example error_bars            # your functions
//! cargo run -p labs --example error_bars -- answer  # the answer's
//! ```
//! Change the numbers, and look at what follows.

use labs::lab::chosen;
use labs::sampling::report::{bars, parallel, touching};
use labs::sampling::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    println!(
        "squares    by       samples   typical   worst     stated    bars that miss"
    );
    for (name, squares) in [("parallel", parallel()), ("touching", touching())] {
        for (by, rays) in [("rays", true), ("points", false)] {
            for samples in [100, 1000, 10_000] {
                let b = bars(work, &squares, rays, samples, 200);
                let [typical, worst, stated, missed] =
                    [b.typical, b.worst, b.stated, b.missed].map(|x| 100.0 * x);
                println!(
                    "{name:8}   {by:6}   {samples:7}   {typical:5.2} %   {worst:5.1} %   \
                     {stated:5.2} %   {missed:4.1} %"
                );
            }
        }
    }
}
