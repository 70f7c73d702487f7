//! The figures and numbers of the chapter *The hemicube*.
//!
//! [`view`] unfolds what an eye sees, [`sheet`] shows where small lamps are missed,
//! [`table`] measures by how much, [`section`] draws the
//! idea, [`cost`] the chart; [`ledger`] closes the page.

pub mod cost;
pub mod ledger;
pub mod section;
pub mod sheet;
pub mod table;
pub mod view;
