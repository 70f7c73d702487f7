//! The suites: what is compared with what. A new method or scene is one entry in one of
//! them.

pub mod certificate;
pub mod directional;
pub mod field;
pub mod form_factors;
pub mod light;
pub mod look;
pub mod meshes;
pub mod pictures;
pub mod plan;
pub mod scaling;
pub mod second_pass;
pub mod sky;
pub mod solvers;
mod truth;

use super::{Bench, ChartView, Trial};

/// Contests that belong together, and the charts that are drawn of them.
#[derive(Debug)]
pub struct Suite {
    /// Its name, that of its table and of its charts.
    pub name: &'static str,
    /// What it compares.
    pub about: &'static str,
    /// Runs it.
    pub measure: fn(&Bench) -> Vec<Trial>,
    /// Its charts.
    pub views: &'static [ChartView],
}

/// All suites, in the order of the book.
pub const SUITES: [Suite; 11] = [
    light::SUITE,
    scaling::SUITE,
    form_factors::SUITE,
    solvers::SUITE,
    meshes::SUITE,
    certificate::SUITE,
    directional::SUITE,
    second_pass::SUITE,
    sky::SUITE,
    pictures::SUITE,
    plan::SUITE,
];

/// The suite of this name.
pub fn suite(name: &str) -> Option<&'static Suite> {
    const ALL: &[Suite] = &SUITES;
    ALL.iter().find(|suite| suite.name == name)
}
