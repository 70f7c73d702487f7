//! The gates over the book's sources.
#![allow(missing_docs)]

mod charts;
mod failures;
mod samples;
mod sources;
