//! The failures of all methods, as curves: one knob, one quantity, and where theory
//! says it lies. The tests in `tests/stability` assert them, the book's page *Where methods
//! fail* draws them; both call the same functions, so that what is shown is what is
//! tested.
//!
//! The wrong methods live here and not in the crate: the crate has what works. A test
//! that has these modules takes its [`rooms`], [`shapes`], [`paths`] and [`mirrored`]
//! from here, too.
#![allow(dead_code)] // each test uses its part

pub mod display;
pub mod exact;
pub mod factors;
pub mod hemicube;
pub mod matrices;
pub mod meshing;
#[allow(clippy::duplicate_mod)]
#[path = "../common/mirrored.rs"]
pub mod mirrored;
pub mod mirrors;
pub mod outlines;
pub mod pairs;
pub mod passes;
#[allow(clippy::duplicate_mod)]
#[path = "../common/paths.rs"]
pub mod paths;
pub mod raster;
pub mod rays;
#[allow(clippy::duplicate_mod)]
#[path = "../common/rooms.rs"]
pub mod rooms;
#[allow(clippy::duplicate_mod)]
#[path = "../common/shapes.rs"]
pub mod shapes;
pub mod skies;
pub mod solver;
pub mod visibility;

/// A row of the table of failures.
#[derive(Clone, Copy)]
pub struct Row {
    /// From 1 to 82.
    pub number: u8,
    /// What fails, in a few words: "The centre is not the mean".
    pub name: &'static str,
    /// Why it fails: the assumption that is broken, in one sentence.
    pub why: &'static str,
    /// How large it is, or that ours does not suffer it, in one sentence with numbers.
    pub size: &'static str,
    /// What holds against it: one sentence.
    pub remedy: &'static str,
    /// The tests of `tests/stability` that assert it: `pairs::row_02_…`; none if left
    /// out.
    pub tests: &'static [&'static str],
    /// What the gallery shows.
    pub shown: Shown,
}

/// The picture of a row.
#[derive(Clone, Copy)]
pub enum Shown {
    /// A curve, computed when the page is made.
    Curve(fn() -> Sweep),
    /// A snapshot under `book/src/pictures`, and what is seen on it.
    Picture(&'static str, &'static str),
    /// Not shown, and why.
    Nothing(&'static str),
}

/// A failure as a curve.
#[derive(Clone, Debug)]
pub struct Sweep {
    // ANCHOR: sweep
    /// What is turned, and its unit: "distance / side".
    pub knob: &'static str,
    /// What is watched, and its unit: "error of F, %".
    pub quantity: &'static str,
    /// What was found: knob and quantity, a line for each method, at most four.
    pub found: Vec<Found>,
    /// Where theory says it lies: a closed form, a law, an exact value; may be the
    /// level that must not be passed.
    pub theory: Vec<[f64; 2]>,
    /// What the theory is: "|F − F*|, Lambert's exact".
    pub law: &'static str,
    // ANCHOR_END: sweep
    /// Is the knob's axis logarithmic? Is the quantity's?
    pub logarithmic: [bool; 2],
}

/// What one method gave.
#[derive(Clone, Debug)]
pub struct Found {
    /// The method.
    pub method: &'static str,
    /// Knob and quantity.
    pub points: Vec<[f64; 2]>,
}

impl Sweep {
    /// The quantity that the first method gave at a place of the knob.
    pub fn at(&self, knob: f64) -> f64 {
        self.by(0, knob)
    }

    /// The same of the method in this place of the list.
    pub fn by(&self, method: usize, knob: f64) -> f64 {
        place(&self.found[method].points, knob)
    }

    /// What theory says at a place of the knob.
    pub fn expected(&self, knob: f64) -> f64 {
        place(&self.theory, knob)
    }
}

/// NaN where there is no point.
fn place(points: &[[f64; 2]], knob: f64) -> f64 {
    let near = |p: &&[f64; 2]| (p[0] - knob).abs() <= 1e-9 * knob.abs().max(1e-300);
    points.iter().find(near).map_or(f64::NAN, |p| p[1])
}

/// A line: the quantity at each place of the knob.
pub fn curve(knobs: &[f64], mut quantity: impl FnMut(f64) -> f64) -> Vec<[f64; 2]> {
    knobs.iter().map(|&knob| [knob, quantity(knob)]).collect()
}

impl Found {
    /// What a method gives at each place of the knob.
    pub fn over(
        method: &'static str,
        knobs: &[f64],
        quantity: impl FnMut(f64) -> f64,
    ) -> Found {
        Found { method, points: curve(knobs, quantity) }
    }
}

/// All rows, in order.
pub fn rows() -> Vec<Row> {
    let families = [
        factors::ROWS,
        pairs::ROWS,
        outlines::ROWS,
        matrices::ROWS,
        hemicube::ROWS,
        raster::ROWS,
        visibility::ROWS,
        meshing::ROWS,
        solver::ROWS,
        mirrors::ROWS,
        passes::ROWS,
        rays::ROWS,
        skies::ROWS,
        display::ROWS,
    ];
    let mut rows = families.concat();
    rows.sort_by_key(|row| row.number);
    rows
}
