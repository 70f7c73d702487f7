//! Speed against accuracy: log error over log time, as an SVG that takes the page's colour.

use std::fmt::Write;

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

/// Width and height of the plot, and its left and top margin, in pixels.
const PLOT: [f64; 4] = [480.0, 320.0, 70.0, 20.0];

/// Mid-tones that stand out on white and on navy, and apart for the colour-blind.
const COLOURS: [&str; 6] =
    ["#d55e00", "#3b8fd0", "#00a078", "#b765a0", "#a08a00", "#808080"];

/// Keeps the grid out of a label: an outline in the page's background.
const HALO: &str = "stroke=\"var(--bg)\" stroke-width=\"4\" paint-order=\"stroke\"";

/// A logarithmic axis of whole decades.
struct Axis {
    low: i32,
    high: i32,
}

impl Axis {
    fn of(values: impl Iterator<Item = f64>) -> Axis {
        let (low, high) = values
            .fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        Axis { low: low.log10().floor() as i32, high: high.log10().ceil() as i32 }
    }

    /// Where `v` lies, from 0 to 1.
    fn place(&self, v: f64) -> f64 {
        (v.log10() - f64::from(self.low)) / f64::from(self.high - self.low)
    }

    /// Values of the grid's lines, and whether a whole decade stands there; of many
    /// decades nothing else.
    fn grid(&self) -> impl Iterator<Item = (f64, bool)> + '_ {
        let lines = if self.high - self.low > 8 { 2 } else { 10 };
        let decade =
            move |e| (1..lines).map(move |k| (f64::from(k) * 10f64.powi(e), k == 1));
        let end = (10f64.powi(self.high), true);
        (self.low..self.high).flat_map(decade).chain([end])
    }
}

/// A whole decade, in the shorter of two ways.
fn number(v: f64) -> String {
    if v < 5e-5 { format!("{v:.0e}") } else { format!("{v}") }
}

/// Errors below this stand on the lower edge: what is right to rounding has no error that
/// a chart could show.
const EXACT: f64 = 1e-7;

/// A height for a label of so many letters at `x`: `y`, or as far above it as is free.
fn free(placed: &mut Vec<[f64; 3]>, x: f64, mut y: f64, letters: usize) -> f64 {
    let width = 7.0 * letters as f64;
    let hits = |&[at, height, wide]: &[f64; 3], y: f64| {
        (height - y).abs() < 12.0 && x < at + wide && at < x + width
    };
    while placed.iter().any(|label| hits(label, y)) {
        y -= 4.0;
    }
    placed.push([x, y, width]);
    y
}

/// The chart of these measurements.
pub fn svg(title: &str, points: &[Point], across: &str, upward: &str) -> String {
    let [width, height, left, top] = PLOT;
    let x_axis = Axis::of(points.iter().map(|p| p.milliseconds));
    let y_axis = Axis::of(points.iter().map(|p| p.error.max(EXACT)));
    let x = |v: f64| left + width * x_axis.place(v);
    let y = |v: f64| top + height * (1.0 - y_axis.place(v.max(EXACT)));
    let (right, bottom) = (left + width, top + height);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 400\" width=\"700\" \
         height=\"400\" role=\"img\" fill=\"currentColor\" font-size=\"13\">\n\
         <title>{title}</title>\n"
    );
    let mut line = |x1: f64, y1: f64, x2: f64, y2: f64, whole: bool| {
        let opacity = if whole { 0.5 } else { 0.15 };
        let _ = writeln!(
            svg,
            "<path d=\"M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}\" stroke=\"currentColor\" \
             stroke-opacity=\"{opacity}\"/>"
        );
    };
    x_axis.grid().for_each(|(v, whole)| line(x(v), top, x(v), bottom, whole));
    y_axis.grid().for_each(|(v, whole)| line(left, y(v), right, y(v), whole));
    let mut text = |x: f64, y: f64, anchor: &str, style: &str, text: &str| {
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\"{style}>{text}</text>"
        );
    };
    for (v, _) in x_axis.grid().filter(|(_, whole)| *whole) {
        text(x(v), bottom + 18.0, "middle", "", &number(v));
    }
    for (v, _) in y_axis.grid().filter(|(_, whole)| *whole) {
        text(left - 6.0, y(v) + 4.0, "end", "", &number(v));
    }
    text(left + width / 2.0, bottom + 40.0, "middle", "", across);
    let turned = format!(" transform=\"rotate(-90 14 {:.1})\"", top + height / 2.0);
    text(14.0, top + height / 2.0, "middle", &turned, upward);
    let mut methods: Vec<&str> = points.iter().map(|p| p.method.as_str()).collect();
    methods.sort_unstable();
    methods.dedup();
    let mut labels = String::new(); // last, so that no line runs over them
    let mut placed = Vec::new();
    for (method, colour) in methods.iter().zip(COLOURS.iter().cycle()) {
        let of_method = points.iter().filter(|p| p.method == *method);
        let at: Vec<(f64, f64, &str)> =
            of_method.map(|p| (x(p.milliseconds), y(p.error), &*p.setting)).collect();
        let path: Vec<String> =
            at.iter().map(|(x, y, _)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" \
             stroke-width=\"2\"/>",
            path.join(" ")
        );
        for (k, &(x, y, setting)) in at.iter().enumerate() {
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{colour}\"/>"
            );
            let last = k + 1 == at.len();
            let label =
                if last { format!("{method}, {setting}") } else { setting.into() };
            if k == 0 || last {
                let wide = 7.0 * label.len() as f64;
                let (anchor, start) =
                    if last { ("start", x + 8.0) } else { ("end", x - 8.0 - wide) };
                let y = free(&mut placed, start, y, label.len()) + 4.0;
                let x = if last { start } else { x - 8.0 };
                let _ = writeln!(
                    labels,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" \
                     {HALO}>{label}</text>",
                );
            }
        }
    }
    svg.push_str(&labels);
    svg.push_str("</svg>\n");
    svg
}
