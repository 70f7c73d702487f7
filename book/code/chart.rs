//! Charts of measurements that are kept with their date: error over time.

use radiosity::chart::{Chart, ChartView, Line, Mark, SUITES, Suite, Trial};

/// One measurement: a row of the CSV.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Which method; points of one method are joined.
    pub method: String,
    /// Its setting: a resolution, a number of rays, a tolerance.
    pub setting: String,
    /// Time, in milliseconds.
    pub milliseconds: f64,
    /// The largest error.
    pub error: f64,
}

/// Reads `method,setting,milliseconds,max_error,reference`; `None` when a line does not fit.
pub fn points(csv: &str) -> Option<Vec<Point>> {
    let point = |line: &str| {
        let mut cells = line.split(',');
        let (method, setting) = (cells.next()?.into(), cells.next()?.into());
        let milliseconds = cells.next()?.parse().ok()?;
        Some(Point {
            method,
            setting,
            milliseconds,
            error: cells.next()?.parse().ok()?,
        })
    };
    csv.lines().skip(1).map(point).collect()
}

/// Errors below this stand on the lower edge: what is right to rounding has no error that
/// a chart could show.
const EXACT: f64 = 1e-7;

/// The chart of these measurements.
pub fn svg(title: &str, points: &[Point], across: &str, upward: &str) -> String {
    let mut methods: Vec<&str> = points.iter().map(|p| p.method.as_str()).collect();
    methods.sort_unstable();
    methods.dedup();
    let mark =
        |p: &Point| Mark { x: p.milliseconds, y: p.error, label: p.setting.clone() };
    let line = |method: &str| Line {
        name: method.into(),
        marks: points.iter().filter(|p| p.method == method).map(mark).collect(),
    };
    let lines = methods.into_iter().map(line).collect();
    let [title, across, upward] = [title, across, upward].map(String::from);
    Chart { title, across, upward, least: EXACT, lines, ..Chart::default() }.svg()
}

/// Path and text of the charts of all suites, from the tables in `book/data`.
pub fn files() -> Vec<(String, String)> {
    let of_suite = |suite: &Suite| {
        let path = crate::generated::root().join(format!("data/{}.csv", suite.name));
        let csv = std::fs::read_to_string(&path);
        let trials = trials(&csv.unwrap_or_else(|e| panic!("{}: {e}", path.display())));
        let chart = |view: &ChartView| {
            (format!("../data/{}.svg", view.file), view.chart(&trials).svg())
        };
        suite.views.iter().map(chart).collect::<Vec<_>>()
    };
    SUITES.iter().flat_map(of_suite).collect()
}

/// The trials of a suite, from the table that `radiosity chart SUITE -o book/data` wrote.
pub fn trials(csv: &str) -> Vec<Trial> {
    radiosity::chart::read(csv).unwrap_or_else(|told| panic!("{told}"))
}

/// The trial of this method and setting on a scene.
pub fn find<'t>(
    trials: &'t [Trial],
    scene: &str,
    method: &str,
    setting: f64,
) -> &'t Trial {
    let fits = |t: &&Trial| {
        t.scene == scene
            && t.method == method
            && (t.setting / setting - 1.0).abs() < 1e-9
    };
    let found = trials.iter().find(fits);
    found.unwrap_or_else(|| panic!("{scene}, {method}, {setting} was not measured"))
}
