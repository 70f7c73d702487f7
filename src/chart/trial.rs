//! One measurement: a line of the table from which every chart is drawn.

use std::fmt::Write;

/// What a method did, counted: the same on every machine. What it does not do is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorkDone {
    /// Form factors, or links, that were computed.
    pub factors: u64,
    /// Rays that were cast, or points that were asked.
    pub rays: u64,
    /// Cells of hemicubes, or pixels, that were drawn.
    pub pixels: u64,
    /// Sweeps, shots, rounds.
    pub steps: u64,
    /// Bytes that the method must keep.
    pub bytes: u64,
}

/// One method, at one setting, on one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// The suite that it belongs to.
    pub suite: String,
    /// What was to be found, and where.
    pub scene: String,
    /// Who did it.
    pub method: String,
    /// How finely: resolution, rays, tolerance, elements.
    pub setting: f64,
    /// Processor time of one run, s: the median of [`Trial::runs`].
    pub seconds: f64,
    /// How often it was run.
    pub runs: u64,
    /// What it did.
    pub work: WorkDone,
    /// The most that it held at one time, bytes; what was there before does not count.
    pub memory: u64,
    /// How far it was off: the scene says in which measure. Of a random method the root
    /// mean square over its runs.
    pub error: f64,
    /// How far the truth itself may be off, in the same measure.
    pub uncertainty: f64,
    /// Light made or lost, as a share of what is emitted.
    pub energy: Option<f64>,
}

/// The columns of the table.
pub const COLUMNS: &str = "suite,scene,method,setting,seconds,runs,factors,rays,pixels,\
                           steps,bytes,memory,error,uncertainty,energy";

/// The table, after the lines of `origin`: what was run, when and where.
pub fn csv(origin: &str, trials: &[Trial]) -> String {
    let mut csv: String = origin.lines().map(|line| format!("# {line}\n")).collect();
    csv += COLUMNS;
    csv.push('\n');
    for t in trials {
        let WorkDone { factors, rays, pixels, steps, bytes } = t.work;
        let energy = t.energy.map_or(String::new(), |e| format!("{e:.3e}"));
        // Writing to a string cannot fail.
        let _ = writeln!(
            csv,
            "{},{},{},{},{:.3e},{},{factors},{rays},{pixels},{steps},{bytes},{},{:.3e},\
             {:.1e},{energy}",
            t.suite,
            t.scene,
            t.method,
            number(t.setting),
            t.seconds,
            t.runs,
            t.memory,
            t.error,
            t.uncertainty,
        );
    }
    csv
}

/// A setting in few signs: `64`, `0.01`, `1e-10`.
pub fn number(v: f64) -> String {
    if v.fract() == 0.0 { format!("{v}") } else { format!("{v:?}") }
}

/// Reads what [`csv`] wrote; what is empty counts as 0, or as no energy.
///
/// # Errors
/// Names the first line that does not fit, and how.
pub fn read(csv: &str) -> Result<Vec<Trial>, String> {
    let mut lines = csv.lines().enumerate().filter(|(_, line)| !line.starts_with('#'));
    match lines.next() {
        Some((_, COLUMNS)) => {}
        _ => return Err(format!("the table must start with {COLUMNS}")),
    }
    let one = |(k, line): (usize, &str)| {
        trial(line).map_err(|told| format!("line {}: {told}", k + 1))
    };
    lines.map(one).collect()
}

fn trial(line: &str) -> Result<Trial, String> {
    let cells: Vec<&str> = line.split(',').collect();
    let [suite, scene, method, numbers @ ..] = &cells[..] else {
        return Err(format!("`{line}` has fewer than three columns"));
    };
    let of = |cell: &&str| match cell.trim() {
        "" => Ok(f64::NAN),
        text => text.parse::<f64>().map_err(|_| format!("`{text}` is no number")),
    };
    let numbers = numbers.iter().map(of).collect::<Result<Vec<f64>, String>>()?;
    let [setting, seconds, rest @ ..] = &numbers[..] else {
        return Err(format!("`{line}` has no time"));
    };
    let &[
        runs,
        factors,
        rays,
        pixels,
        steps,
        bytes,
        memory,
        error,
        uncertainty,
        energy,
    ] = rest
    else {
        return Err(format!("it has {} columns and not 15", cells.len()));
    };
    // What is missing is NaN, and that becomes 0.
    let count = |v: f64| v as u64;
    let [factors, rays, pixels, steps, bytes] =
        [factors, rays, pixels, steps, bytes].map(count);
    Ok(Trial {
        suite: suite.to_string(),
        scene: scene.to_string(),
        method: method.to_string(),
        setting: *setting,
        seconds: *seconds,
        runs: count(runs),
        work: WorkDone { factors, rays, pixels, steps, bytes },
        memory: count(memory),
        error,
        uncertainty: if uncertainty.is_nan() { 0.0 } else { uncertainty },
        energy: Some(energy).filter(|e| !e.is_nan()),
    })
}
