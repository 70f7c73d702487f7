//! What a scene needs: from the error asked for to the work that reaches it, and why.
//!
//! ```text
//! ‖B − E − ρ H_direct‖ ≤ ρ_max ‖B − E‖       light reflected twice or more, closed or not
//! bounces that matter = ln tolerance / ln q      q = ρ̄ (1 − escaping)
//! E/(1 − ρ) the same everywhere, room closed     ⇒ B = E/(1 − ρ): nothing to solve
//! ```
//! A plan looks at the scene, which costs some thousand rays, and decides. Each
//! [`Decision`] is one sentence with the number that it rests on. What is predicted decides
//! nothing: the certificate says when it is enough.
//!
//! | part             | use it when                              | it fails when              |
//! |------------------|------------------------------------------|----------------------------|
//! | [`Survey`]       | the scene is to be known, cheaply        | an opening is smaller than |
//! |                  |                                          | a ray finds                |
//! | [`Plan::of`]     | it is to be told what will be done       | materials shine            |
//! | [`Plan::run`]    | it is to be done                         | the limits are reached     |
//! | [`Predicted`]    | a person asks how long it will take      | the machine is another     |
//!
//! ```
//! use radiosity::plan::{Plan, PlannedWay};
//! use radiosity::{room::Room, scene::built_in};
//! let furnace = built_in("furnace").unwrap(); // closed, all walls alike
//! let plan = Plan::of(&Room::of(&furnace), 0.01);
//! assert!(matches!(plan.way, PlannedWay::Everywhere(b) if (b.x - 2.0).abs() < 1e-12));
//! ```
//!
//! **Not here:** how light is resolved and certified ([`crate::solve`]).
//! Beyond the lecture: chapter *What does this scene need?*. Sources: Lischinski,
//! Smits & Greenberg 1994 (bounds that tell where to work); Smits, Arvo & Salesin 1992 (no
//! more work than the result needs).

mod predict;
mod run;
mod survey;
mod words;

pub use predict::Predicted;
pub use run::Planned;
pub use survey::{Pieces, Survey};

use crate::field::{Fineness, Pass1, Smooth};
use crate::geometry::Rgb;
use crate::room::Room;
use crate::solution::Goal;
use std::fmt;

/// One thing that was decided, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// What it is about: one word or two.
    pub what: &'static str,
    /// The sentence, with its number.
    pub why: String,
    /// The number itself; its unit is told by the sentence.
    pub value: f64,
}

/// The longest line that is printed.
const WIDTH: usize = 78;

/// The column where sentences begin.
const MARGIN: usize = 9;

/// The word at the margin, and the sentence beside it, broken at spaces.
impl fmt::Display for Decision {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:<MARGIN$}", self.what)?;
        let mut column = MARGIN;
        for word in self.why.split(' ') {
            let length = 1 + word.chars().count();
            // `9 %` stays together.
            if column + length > WIDTH && word != "%" {
                write!(f, "\n{:MARGIN$}", "")?;
                column = MARGIN;
            }
            write!(f, " {word}")?;
            column += length;
        }
        writeln!(f)
    }
}

/// How a scene is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlannedWay {
    /// Not at all: this radiosity, in W/m², is everywhere.
    Everywhere(Rgb),
    /// Direct light exactly, and what is reflected, if it is, by hemicubes on patches; to
    /// begin with at this resolution.
    Smooth(Fineness),
}

/// What is done to a scene, and why.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The relative error that was asked for.
    pub tolerance: f64,
    /// What was found.
    pub survey: Survey,
    /// What will be done.
    pub way: PlannedWay,
    /// Why.
    pub decisions: Vec<Decision>,
    /// The work that this will be, as far as can be told.
    pub predicted: Predicted,
}

/// Light that was reflected twice may be left out when it is at most this share of the
/// tolerance: the mesh has the rest.
const SHARE_OF_BOUNCES: f64 = 0.25;

impl Plan {
    /// The plan for a room that is to be right to `tolerance` (relative, positive).
    /// The scene has an emitter, else there is nothing to plan.
    ///
    /// Deterministic, and the same at any number of threads.
    pub fn of(room: &Room, tolerance: f64) -> Plan {
        let scene = room.scene;
        // ANCHOR: way
        let survey = Survey::of(room);
        let first = Smooth.first(room, tolerance);
        let enough = SHARE_OF_BOUNCES * tolerance;
        let way = match survey.everywhere {
            Some(radiosity) => PlannedWay::Everywhere(radiosity),
            None if survey.brightest <= enough
                && survey.specular == 0
                && scene.sky.is_none() =>
            {
                PlannedWay::Smooth(Fineness { reflected: f64::INFINITY, ..first })
            }
            None => PlannedWay::Smooth(first),
        };
        // ANCHOR_END: way
        let pieces = Pieces::of(room, first.patch, Goal::default().most_patches);
        let predicted = match &way {
            PlannedWay::Everywhere(_) => Predicted::nothing(scene, tolerance),
            PlannedWay::Smooth(how) => Predicted::of(&survey, &pieces, how, tolerance),
        };
        let decisions = words::decisions(&survey, &pieces, &way, &predicted, tolerance);
        Plan { tolerance, survey, way, decisions, predicted }
    }

    /// One line for each decision.
    pub fn lines(&self) -> Vec<String> {
        self.decisions.iter().map(|d| format!("{}: {}", d.what, d.why)).collect()
    }
}
