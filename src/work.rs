//! Work: counted, told while it goes on, and limited.
//!
//! ```text
//! work = hemicubes drawn, rows of factors computed        counted at fixed places
//! ```
//! No clock decides a result: what is counted is the same on any machine and at any number of
//! threads, so that a limit of work gives the same answer everywhere.
//!
//! | part             | use it when                       | it fails when                    |
//! |------------------|-----------------------------------|----------------------------------|
//! | [`Work::quiet`]  | nobody waits                      | never                            |
//! | [`Work::told`]   | somebody waits, and wants to know | never: progress decides nothing  |
//! | [`Work::within`] | the answer may not cost more      | the first attempt costs more     |
//!
//! ```
//! use radiosity::work::Work;
//! let work = Work::quiet().within(100);
//! work.count(60);
//! assert!(!work.is_spent());
//! work.count(60);
//! assert!(work.is_spent() && work.counted() == 120);
//! ```
//!
//! **Not here:** seconds; what work a scene will be ([`crate::plan`]).
//! Beyond the lecture. Source: none, it is bookkeeping.

use std::sync::atomic::{AtomicU64, Ordering};

/// How far a computation has come: what it does, steps done, steps in all.
pub type Progress<'a> = &'a (dyn Fn(&'static str, usize, usize) + Sync);

/// The work of a computation: who is told of it, how much it was, how much it may be.
pub struct Work<'p> {
    progress: Progress<'p>,
    counted: AtomicU64,
    most: u64,
}

impl std::fmt::Debug for Work<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let counted = self.counted();
        f.debug_struct("Work")
            .field("counted", &counted)
            .field("most", &self.most)
            .finish()
    }
}

impl Work<'static> {
    /// Work of which nobody is told, without limit.
    pub fn quiet() -> Work<'static> {
        Work::told(&|_, _, _| {})
    }
}

impl<'p> Work<'p> {
    /// Work of which `progress` is told, without limit.
    pub fn told(progress: Progress<'p>) -> Work<'p> {
        Work { progress, counted: AtomicU64::new(0), most: u64::MAX }
    }

    /// The same with a limit: when so many rows and hemicubes are counted, nothing new is
    /// begun. What has begun is finished.
    pub fn within(self, most: u64) -> Work<'p> {
        Work { most, ..self }
    }

    /// Tells how far it has come.
    pub fn tell(&self, what: &'static str, done: usize, all: usize) {
        (self.progress)(what, done, all);
    }

    /// Who is told.
    pub fn progress(&self) -> Progress<'p> {
        self.progress
    }

    /// So many rows of factors or hemicubes more.
    pub fn count(&self, more: usize) {
        self.counted.fetch_add(more as u64, Ordering::Relaxed);
    }

    /// How many rows of factors and hemicubes so far.
    pub fn counted(&self) -> u64 {
        self.counted.load(Ordering::Relaxed)
    }

    /// Is it as much as it may be?
    pub fn is_spent(&self) -> bool {
        self.counted() >= self.most
    }
}
