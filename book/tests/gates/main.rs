//! The gates over the book's sources.
#![allow(missing_docs)]

mod charts;
mod failures;
mod house;
mod names;
mod samples;
mod sources;
