//! The labs of *Light, Patch by Patch*: what students write, and what judges it.
//!
//! A lab is a folder here and a line in [`LABS`]. The folder holds
//!
//! | file         | what it is                                                        |
//! |--------------|-------------------------------------------------------------------|
//! | `mod.rs`     | the lab's [`Lab`]; the contract of what is to be written          |
//! | `given.rs`   | what the student is given                                         |
//! | `starter.rs` | what the student edits: it compiles, and fails every task         |
//! | `answer.rs`  | one right answer                                                  |
//! | `bugs.rs`    | the mistakes that can be named                                    |
//! | `checks.rs`  | the checks; each failure names the likely [`Bug`]                 |
//! | `wrong.rs`   | played students: each makes one mistake, which must be named      |
//! | `report.rs`  | the experiment of the report question                             |
//!
//! and its brief is a page of the book, `book/src/labs/NAME.md`.
//!
//! `cargo lab` lists, runs, hints and grades; `cargo lab ci` proves that the starter
//! fails, that the answer passes, and that each played student is caught and named.
//!
//! **Not here:** secrets. The answers are public: they lie beside the starter. A *cohort*
//! seed varies scenes and numbers, so that copied results do not transfer; copied code
//! does. Nor a sandbox: a task runs in a process of its own with a limit on its time, but
//! not on its memory, its files or its network. Grade strangers' code inside one.
#![forbid(unsafe_code)]

pub mod check;
pub mod draw;
pub mod shapes;
pub mod lab;
pub mod grade;
pub mod run;
pub mod show;
pub mod proof;
pub mod solid_angle;
pub mod radiometry;
pub mod brdf;
pub mod gather;
pub mod lambert;
pub mod sampling;
pub mod hemicube;
pub mod substructure;
pub mod shoot;
pub mod certify;
pub mod mirror_world;
pub mod window;
pub mod cone;
pub mod sky;
pub mod race;
pub mod break_it;

pub use check::{Bug, Verdict};
pub use lab::{Lab, Who};

/// All labs, in the order of the course. A new lab is one more line.
pub const LABS: &[&Lab] = &[
    &solid_angle::LAB,
    &radiometry::LAB,
    &brdf::LAB,
    &gather::LAB,
    &lambert::LAB,
    &sampling::LAB,
    &hemicube::LAB,
    &substructure::LAB,
    &shoot::LAB,
    &certify::LAB,
    &mirror_world::LAB,
    &window::LAB,
    &cone::LAB,
    &sky::LAB,
    &race::LAB,
    &break_it::LAB,
];
