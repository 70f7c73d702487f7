//! A view: which trials of a suite become the lines of one chart, and over what.

use super::trial::number;
use super::{Chart, Line, Mark, Trial};

/// A column of the table that can be an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// The setting: a number of elements, a tolerance, a resolution.
    Setting,
    /// Processor time, s.
    Seconds,
    /// Form factors or links.
    Factors,
    /// Rays or points.
    Rays,
    /// Hemicube cells or pixels.
    Pixels,
    /// Sweeps or shots.
    Steps,
    /// Bytes that must be kept.
    Bytes,
    /// Bytes that were held.
    Memory,
    /// How far off.
    Error,
    /// Light made or lost.
    Energy,
}

impl Column {
    /// Its value in a trial; NaN where it has none.
    pub fn of(self, trial: &Trial) -> f64 {
        let work = trial.work;
        match self {
            Column::Setting => trial.setting,
            Column::Seconds => trial.seconds,
            Column::Factors => work.factors as f64,
            Column::Rays => work.rays as f64,
            Column::Pixels => work.pixels as f64,
            Column::Steps => work.steps as f64,
            Column::Bytes => work.bytes as f64,
            Column::Memory => trial.memory as f64,
            Column::Error => trial.error,
            Column::Energy => trial.energy.map_or(f64::NAN, f64::abs),
        }
    }
}

/// One chart of a suite.
#[derive(Debug, Clone, Copy)]
pub struct ChartView {
    /// Its file's name, without ending.
    pub file: &'static str,
    /// What it shows, in a sentence.
    pub title: &'static str,
    /// Across, with its name on the axis.
    pub across: (Column, &'static str),
    /// Upward, with its name.
    pub upward: (Column, &'static str),
    /// Smaller values upward stand on the lower edge.
    pub least: f64,
    /// Which trials: scene and method.
    pub shows: fn(&Trial) -> bool,
}

impl ChartView {
    /// The chart: a line for each method, named by its scene, too, if there are several. Of
    /// errors over effort the frontier is marked: who is not on it is beaten both ways.
    pub fn chart(&self, trials: &[Trial]) -> Chart {
        let shown: Vec<&Trial> = trials.iter().filter(|t| (self.shows)(t)).collect();
        let scenes = shown.chunk_by(|a, b| a.scene == b.scene).count();
        let alike = |a: &&Trial, b: &&Trial| a.method == b.method && a.scene == b.scene;
        let line = |of: &[&Trial]| Line {
            name: match scenes {
                0 | 1 => of[0].method.clone(),
                _ => format!("{}, {}", of[0].scene, of[0].method),
            },
            marks: of.iter().map(|t| self.mark(t)).collect(),
        };
        let effort = !matches!(self.across.0, Column::Setting | Column::Error);
        let judged = matches!(self.upward.0, Column::Error | Column::Energy);
        let known = shown.iter().map(|t| t.uncertainty).fold(0.0, f64::max);
        Chart {
            title: self.title.into(),
            across: self.across.1.into(),
            upward: self.upward.1.into(),
            least: self.least,
            frontier: effort && judged && scenes < 2,
            truth: Some(known)
                .filter(|u| *u > self.least && self.upward.0 == Column::Error),
            lines: shown.chunk_by(alike).map(line).collect(),
        }
    }

    fn mark(&self, trial: &Trial) -> Mark {
        let label = match self.across.0 {
            Column::Setting => String::new(),
            _ => number(trial.setting),
        };
        Mark { x: self.across.0.of(trial), y: self.upward.0.of(trial), label }
    }
}

/// The exponent of `upward` over `across`, fitted to the trials by least squares of their
/// logarithms; trials without a logarithm do not count. NaN for fewer than two.
pub fn exponent(trials: &[&Trial], across: Column, upward: Column) -> f64 {
    let logs = trials.iter().map(|t| [across.of(t).ln(), upward.of(t).ln()]);
    let logs: Vec<_> = logs.filter(|p| p.iter().all(|v| v.is_finite())).collect();
    let mean = |k: usize| logs.iter().map(|p| p[k]).sum::<f64>() / logs.len() as f64;
    let [x, y] = [mean(0), mean(1)];
    let over = |k: usize| -> f64 {
        logs.iter().map(|p| (p[0] - x) * (p[k] - [x, y][k])).sum()
    };
    over(1) / over(0)
}
