//! Speed against accuracy: methods run side by side, and what came out as a table and a
//! picture.
//!
//! ```text
//! seconds of one processor                   time, of this machine: the median of runs
//! factors, rays, cells, steps, bytes         work, the same on any machine
//! error, and how far the truth may be off    accuracy, in the measure of the scene
//! ```
//!
//! | part       | use it when                             | it fails when                   |
//! |------------|-----------------------------------------|---------------------------------|
//! | [`Contest`]| methods do one task, at settings        | its truth is not finer          |
//! | [`suites`] | the charts of the book are made anew    | the machine does something else |
//! | [`Race`]   | solvers go for one accuracy             | as above                        |
//! | [`Comparison`] | pictures are to be compared         | the reference is noisy          |
//! | [`Chart`]  | numbers span decades, both ways         | a value is 0: it has no decade  |
//!
//! ```
//! use radiosity::chart::{Bench, Contest, Method, Verdict, WorkDone};
//! // π by the corners of a polygon: how wrong, with how many?
//! let corners = |n: f64, _| (n * (std::f64::consts::PI / n).sin(), WorkDone::default());
//! let method = Method::new("inscribed", &[6.0, 12.0], corners);
//! let off = |pi: &f64| Verdict::of((pi / std::f64::consts::PI - 1.0).abs());
//! let trials = Contest::new("circle", 0.0, off).with(method).run("pi", &Bench::SILENT);
//! assert!((3.8..4.2).contains(&(trials[0].error / trials[1].error))); // second order
//! ```
//!
//! **Not here:** where numbers are written to, and the clock: the command brings both as a
//! [`Meter`].
//! Chapters *Speed against accuracy*, *Side by side* (L22) and *Solving it* (L13, L14).
//! Sources: Gortler, Cohen & Slusallek 1994, who compared relaxations by their work; the
//! frontier is Pareto's (1906).

mod contest;
pub mod patches;
pub mod race;
mod side_by_side;
pub mod suites;
mod svg;
mod trial;
mod view;

pub use contest::{Bench, Contest, Meter, Method, Run, Unmetered, Verdict};
pub use race::Race;
pub use side_by_side::{Comparison, Effort, Panel};
pub use suites::{SUITES, Suite, suite};
pub use svg::{Chart, Line, Mark};
pub use trial::{COLUMNS, Trial, WorkDone, csv, number, read};
pub use view::{ChartView, Column, exponent};
