//! The drawing of a chart: logarithmic both ways, as an SVG that takes the page's colours.

use std::fmt::Write;

/// A mark of a line: where it lies, and what is written at the first and the last of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Across; above 0.
    pub x: f64,
    /// Upward; what is below [`Chart::least`] stands on the lower edge.
    pub y: f64,
    /// The setting that led there: a resolution, a tolerance. May be empty.
    pub label: String,
}

/// Marks that belong together and are joined.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Stands at the end of the line.
    pub name: String,
    /// In order along the line.
    pub marks: Vec<Mark>,
}

/// A chart with two logarithmic axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// What it shows, in a sentence.
    pub title: String,
    /// What is measured across.
    pub across: String,
    /// What is measured upward.
    pub upward: String,
    /// Smaller `y` cannot be told apart: an error of nothing has no logarithm.
    pub least: f64,
    /// Mark what nothing else beats in both: less across and less upward.
    pub frontier: bool,
    /// The truth is known to this: below it errors mean nothing. A dotted line.
    pub truth: Option<f64>,
    /// In the order of their colours.
    pub lines: Vec<Line>,
}

/// Width and height of the plot, and its left and top margin, in pixels.
const PLOT: [f64; 4] = [480.0, 320.0, 70.0, 20.0];

/// Mid-tones that stand out on white and on navy, and apart for the colour-blind.
const COLOURS: [&str; 6] =
    ["#d55e00", "#3b8fd0", "#00a078", "#b765a0", "#a08a00", "#808080"];

/// The shapes of marks, about the origin, for those who see no colours: disc, square, diamond,
/// triangles, cross.
const SHAPES: [&str; 6] = [
    "M-4 0A4 4 0 1 0 4 0A4 4 0 1 0 -4 0Z",
    "M-3.5 -3.5H3.5V3.5H-3.5Z",
    "M0 -5L5 0L0 5L-5 0Z",
    "M0 -5L4.5 3.5H-4.5Z",
    "M0 5L4.5 -3.5H-4.5Z",
    "M-4 -1.2H-1.2V-4H1.2V-1.2H4V1.2H1.2V4H-1.2V1.2H-4Z",
];

/// Keeps the grid out of a label: an outline in the page's background.
const HALO: &str =
    " stroke=\"var(--bg, white)\" stroke-width=\"4\" paint-order=\"stroke\"";

/// A logarithmic axis of whole decades.
struct Axis {
    low: i32,
    high: i32,
}

impl Axis {
    /// Room for all these values; those that have no logarithm need none.
    fn of(values: impl Iterator<Item = f64>) -> Axis {
        let decades = values.map(f64::log10).filter(|e| e.is_finite());
        let [low, high] = decades
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], e| [l.min(e), h.max(e)]);
        if low > high {
            return Axis { low: 0, high: 1 };
        }
        let low = low.floor() as i32;
        Axis { low, high: (high.ceil() as i32).max(low + 1) }
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

    /// Whole decades.
    fn decades(&self) -> impl Iterator<Item = f64> + '_ {
        self.grid().filter(|(_, whole)| *whole).map(|(v, _)| v)
    }
}

/// A whole decade, in the shorter of two ways.
fn number(v: f64) -> String {
    if (5e-5..5e5).contains(&v) { format!("{v}") } else { format!("{v:.0e}") }
}

/// A chart that is being drawn.
struct Sheet {
    svg: String,
    across: Axis,
    upward: Axis,
    /// Start, height and width of what no label may cover: marks, and labels so far.
    taken: Vec<[f64; 3]>,
}

impl Sheet {
    fn x(&self, v: f64) -> f64 {
        PLOT[2] + PLOT[0] * self.across.place(v)
    }

    fn y(&self, v: f64) -> f64 {
        PLOT[3] + PLOT[1] * (1.0 - self.upward.place(v))
    }

    // Writing to a string cannot fail.
    fn text(&mut self, [x, y]: [f64; 2], anchor: &str, style: &str, text: &str) {
        let _ = writeln!(
            self.svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\"{style}>{text}</text>"
        );
    }

    fn rule(&mut self, from: [f64; 2], to: [f64; 2], whole: bool) {
        let opacity = if whole { 0.5 } else { 0.15 };
        let ([x1, y1], [x2, y2]) = (from, to);
        let _ = writeln!(
            self.svg,
            "<path d=\"M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}\" stroke=\"currentColor\" \
             stroke-opacity=\"{opacity}\"/>"
        );
    }

    fn axes(&mut self, across: &str, upward: &str) {
        let [width, height, left, top] = PLOT;
        let (right, bottom) = (left + width, top + height);
        for (v, whole) in self.across.grid().collect::<Vec<_>>() {
            self.rule([self.x(v), top], [self.x(v), bottom], whole);
        }
        for (v, whole) in self.upward.grid().collect::<Vec<_>>() {
            self.rule([left, self.y(v)], [right, self.y(v)], whole);
        }
        for v in self.across.decades().collect::<Vec<_>>() {
            self.text([self.x(v), bottom + 18.0], "middle", "", &number(v));
        }
        for v in self.upward.decades().collect::<Vec<_>>() {
            self.text([left - 6.0, self.y(v) + 4.0], "end", "", &number(v));
        }
        self.text([left + width / 2.0, bottom + 40.0], "middle", "", across);
        let turned = format!(" transform=\"rotate(-90 14 {:.1})\"", top + height / 2.0);
        self.text([14.0, top + height / 2.0], "middle", &turned, upward);
    }

    fn line(&mut self, at: &[[f64; 2]], style: &str) {
        let path: Vec<String> =
            at.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        let path = path.join(" ");
        let _ =
            writeln!(self.svg, "<polyline points=\"{path}\" fill=\"none\"{style}/>");
    }

    /// A mark in the shape of its line; filled, or hollow if others beat it.
    fn mark(&mut self, [x, y]: [f64; 2], of: usize, filled: bool) {
        let colour = COLOURS[of % COLOURS.len()];
        self.taken.push([x - 5.0, y, 10.0]);
        let fill = if filled { colour } else { "var(--bg, white)" };
        let shape = SHAPES[of % SHAPES.len()];
        let _ = writeln!(
            self.svg,
            "<path class=\"mark\" d=\"{shape}\" transform=\"translate({x:.1} {y:.1})\" \
             fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"1.5\"/>"
        );
    }

    /// Steps along the marks that nothing beats.
    fn frontier(&mut self, mut best: Vec<[f64; 2]>) {
        best.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut steps = vec![];
        for (k, &[x, y]) in best.iter().enumerate() {
            if k > 0 {
                steps.push([x, best[k - 1][1]]);
            }
            steps.push([x, y]);
        }
        let style = " stroke=\"currentColor\" stroke-opacity=\"0.35\" stroke-width=\"6\" \
                     stroke-linejoin=\"round\" class=\"frontier\"";
        self.line(&steps, style);
    }

    /// Below this line the truth itself is not known.
    fn truth(&mut self, y: f64) {
        let (left, right) = (PLOT[2], PLOT[2] + PLOT[0]);
        let _ = writeln!(
            self.svg,
            "<path d=\"M{left} {y:.1}L{right} {y:.1}\" stroke=\"currentColor\" \
             stroke-width=\"2\" stroke-dasharray=\"2 5\"/>"
        );
        let said = "the truth is known to here";
        self.text([left + 6.0, y - 5.0], "start", HALO, said);
        self.taken.push([left + 6.0, y - 9.0, 175.0]);
    }

    /// A label beside a mark, before or after it, in the colour of its line; moved up or
    /// down to the nearest place where there is room.
    fn label(&mut self, [x, y]: [f64; 2], after: bool, of: usize, text: &str) {
        let width = 7.0 * text.chars().count() as f64;
        let start = if after { x + 8.0 } else { x - 8.0 - width };
        let hits = |&[at, height, wide]: &[f64; 3], y: f64| {
            (height - y).abs() < 12.0 && start < at + wide && at < start + width
        };
        let free = |y: &f64| !self.taken.iter().any(|taken| hits(taken, *y));
        let nearest =
            (0..40).flat_map(|k| [y - 4.0 * f64::from(k), y + 4.0 * f64::from(k)]);
        let y = nearest.filter(|y| *y < PLOT[3] + PLOT[1]).find(free).unwrap_or(y);
        self.taken.push([start, y, width]);
        let (x, anchor) = if after { (start, "start") } else { (x - 8.0, "end") };
        let colour = COLOURS[of % COLOURS.len()];
        self.text([x, y + 4.0], anchor, &format!("{HALO} fill=\"{colour}\""), text);
    }
}

impl Chart {
    /// The chart as a picture that a page can hold; its `<desc>` tells the ends of each
    /// line to those who cannot see it. Marks without a logarithm are left out.
    pub fn svg(&self) -> String {
        let marks = || self.lines.iter().flat_map(|line| &line.marks);
        let mut sheet = Sheet {
            svg: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 400\" \
                 width=\"700\" height=\"400\" role=\"img\" fill=\"currentColor\" \
                 font-size=\"13\">\n<title>{}</title>\n<desc>{}</desc>\n",
                self.title,
                self.description()
            ),
            across: Axis::of(marks().map(|mark| mark.x)),
            upward: Axis::of(
                marks().map(|mark| mark.y.max(self.least)).chain(self.truth),
            ),
            taken: vec![],
        };
        sheet.axes(&self.across, &self.upward);
        let place =
            |sheet: &Sheet, m: &Mark| [sheet.x(m.x), sheet.y(m.y.max(self.least))];
        let best: Vec<&Mark> = marks().filter(|m| self.is_best(m)).collect();
        if self.frontier {
            sheet.frontier(best.iter().map(|m| place(&sheet, m)).collect());
        }
        if let Some(known) = self.truth {
            sheet.truth(sheet.y(known));
        }
        let mut labels = vec![]; // last, so that no line runs over them
        for (k, line) in self.lines.iter().enumerate() {
            let at = |m| (place(&sheet, m), m);
            let mut drawn: Vec<_> = line.marks.iter().map(at).collect();
            drawn.retain(|(at, _)| at.iter().all(|x| x.is_finite()));
            let at: Vec<[f64; 2]> = drawn.iter().map(|(at, _)| *at).collect();
            let colour = COLOURS[k % COLOURS.len()];
            sheet.line(&at, &format!(" stroke=\"{colour}\" stroke-width=\"2\""));
            for &(at, mark) in &drawn {
                sheet.mark(at, k, !self.frontier || self.is_best(mark));
            }
            if let [(at, first), _, ..] = drawn[..] {
                labels.push((at, false, k, first.label.clone()));
            }
            if let Some((at, last)) = drawn.last() {
                let both = [line.name.as_str(), last.label.as_str()];
                let said = both.into_iter().filter(|s| !s.is_empty());
                labels.push((*at, true, k, said.collect::<Vec<_>>().join(", ")));
            }
        }
        // From the lowest up, as they make room upward: their order is that of the lines.
        labels.sort_by(|a, b| b.0[1].total_cmp(&a.0[1]));
        for (at, after, k, text) in labels.iter().filter(|label| !label.3.is_empty()) {
            sheet.label(*at, *after, *k, text);
        }
        sheet.svg + "</svg>\n"
    }

    /// Does no other mark beat this one, in both?
    fn is_best(&self, mark: &Mark) -> bool {
        let y = |m: &Mark| m.y.max(self.least);
        let beats = |m: &&Mark| {
            m.x <= mark.x && y(m) <= y(mark) && (m.x < mark.x || y(m) < y(mark))
        };
        let has_place = |m: &Mark| m.x > 0.0 && y(m) > 0.0 && (m.x * m.y).is_finite();
        let mut others = self.lines.iter().flat_map(|line| &line.marks);
        has_place(mark) && !others.any(|m| has_place(m) && beats(&m))
    }

    fn description(&self) -> String {
        let ends = |line: &Line| {
            let [first, last] = [line.marks.first()?, line.marks.last()?];
            let says = |m: &Mark| format!("{:.2e} at {:.2e}", m.y.max(self.least), m.x);
            let (from, to) = (says(first), says(last));
            Some(format!("{}: from {from} to {to}. ", line.name))
        };
        let ends: String = self.lines.iter().filter_map(ends).collect();
        format!("{} over {}. {}", self.upward, self.across, ends.trim_end())
    }
}
