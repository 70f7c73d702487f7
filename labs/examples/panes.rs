//! Report question of the lab `window`: what do the shortcuts cost?
//!
//! ```sh
//! cargo run -p labs --example panes            # your functions
//! cargo run -p labs --example panes -- answer  # the answer's
//! ```
//! Change the index and the angles, and look at what follows.

use labs::lab::chosen;
use labs::window::report::at;
use labs::window::{answer, starter};

fn main() {
    let work = chosen(&starter::WORK, &answer::WORK);
    let index = 1.5;
    println!("angle   passes   one face   two faces   mean first");
    for degrees in [0.0, 30.0, 45.0, 60.0, 70.0, 75.0, 80.0, 85.0, 89.0] {
        let passed = at(work, degrees, index);
        let off = |shortcut: f64| 100.0 * (shortcut / passed.all - 1.0);
        println!(
            "{degrees:4}°   {:.4}   {:+6.2} %   {:+7.2} %   {:+8.2} %",
            passed.all,
            off(passed.one_face),
            off(passed.two_faces),
            off(passed.mean_first)
        );
    }
    println!("diffuse light: {:.4} passes", (work.mean)(index, 500));
}
