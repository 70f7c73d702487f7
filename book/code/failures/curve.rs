//! A failure as a small curve: an SVG that takes the colours of the page.
//!
//! Methods differ in colour and in the shape of their marks; theory is a dashed line.
//! All names stand below, so that none runs over a curve.

use super::axis::{Axis, number};
use super::rows::{Row, Sweep};
use std::fmt::Write;

/// Width of the picture, and how wide a letter is at most on the average, in pixels.
pub const WIDTH: f64 = 340.0;
/// See [`WIDTH`].
pub const LETTER: f64 = 6.1;

/// Left edge, width and height of the plot.
const PLOT: [f64; 3] = [48.0, 278.0, 150.0];
/// From one line of text to the next.
const LINE: f64 = 15.0;
/// Keeps marks off the edges of the plot.
const INSET: f64 = 7.0;
/// Marks nearer than this, in pixels, are left out: the line says enough.
const APART: f64 = 9.0;

/// Mid-tones that stand out on white and on navy, and apart for the colour-blind.
const COLOURS: [&str; 4] = ["#d55e00", "#3b8fd0", "#00a078", "#b765a0"];

/// The curve of a row.
pub fn svg(row: &Row, sweep: &Sweep) -> String {
    let (row, name) = (row.number, row.name);
    let mut sheet = Sheet::of(sweep);
    sheet.axes(sweep);
    for (k, found) in sweep.found.iter().enumerate() {
        sheet.found(k, &found.points);
    }
    sheet.theory(&sweep.theory);
    let methods = sweep.found.iter().map(|f| f.method).enumerate();
    let mut key: Vec<(Option<usize>, &str)> =
        methods.map(|(k, m)| (Some(k), m)).collect();
    if !sweep.theory.is_empty() {
        key.push((None, sweep.law));
    }
    sheet.key(&key);
    let height = sheet.bottom;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" \
         width=\"{WIDTH}\" height=\"{height}\" role=\"img\" fill=\"currentColor\" \
         font-size=\"11\" aria-labelledby=\"f{row:02}-title f{row:02}-desc\">\n\
         <title id=\"f{row:02}-title\">{row}: {}</title>\n\
         <desc id=\"f{row:02}-desc\">{}</desc>\n{}</svg>\n",
        escaped(name),
        escaped(&description(sweep)),
        sheet.svg
    )
}

/// What a curve says, for those who cannot see it: the ends of each line.
fn description(sweep: &Sweep) -> String {
    let says = |[x, y]: &[f64; 2]| format!("{} at {}", number(*y), number(*x));
    let ends = |name: &str, points: &[[f64; 2]]| match points {
        [] => String::new(),
        [one] => format!(" {name}: {}.", says(one)),
        [first, .., last] => {
            format!(" {name}: from {} to {}.", says(first), says(last))
        }
    };
    let found: String = sweep.found.iter().map(|f| ends(f.method, &f.points)).collect();
    let theory = ends(sweep.law, &sweep.theory);
    format!("{} over {}.{found}{theory}", sweep.quantity, sweep.knob)
}

/// Text as XML takes it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Cuts a text into lines that are at most so many pixels wide.
fn lines(text: &str, width: f64) -> Vec<String> {
    let most = (width / LETTER) as usize;
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let line = lines.last_mut().expect("there is one");
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > most {
            lines.push(word.into());
        } else {
            let space = if line.is_empty() { "" } else { " " };
            *line += &format!("{space}{word}");
        }
    }
    lines
}

/// A curve that is being drawn.
struct Sheet {
    svg: String,
    knob: Axis,
    quantity: Axis,
    top: f64,
    /// Where the next line of text goes, and the lower edge in the end.
    bottom: f64,
}

// Writing to a string cannot fail.
impl Sheet {
    fn of(sweep: &Sweep) -> Sheet {
        let points = || {
            let found = sweep.found.iter().flat_map(|f| &f.points);
            found.chain(&sweep.theory)
        };
        let values = |k: usize| points().map(|p| p[k]).collect::<Vec<f64>>();
        let mut sheet = Sheet {
            svg: String::new(),
            knob: Axis::of(&values(0), sweep.logarithmic[0], false),
            quantity: Axis::of(&values(1), sweep.logarithmic[1], true),
            top: 0.0,
            bottom: 0.0,
        };
        for line in lines(sweep.quantity, WIDTH - 4.0) {
            sheet.bottom += LINE;
            sheet.text(2.0, sheet.bottom - 3.0, "start", &line);
        }
        sheet.top = sheet.bottom + 6.0;
        sheet.bottom = sheet.top + PLOT[2];
        sheet
    }

    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [left, width, height] = PLOT;
        let inner = |p: f64, size: f64| INSET + p * (size - 2.0 * INSET);
        let up = inner(self.quantity.place(y), height);
        [left + inner(self.knob.place(x), width), self.top + height - up]
    }

    fn text(&mut self, x: f64, y: f64, anchor: &str, text: &str) {
        let text = escaped(text);
        let _ = writeln!(
            self.svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>"
        );
    }

    fn axes(&mut self, sweep: &Sweep) {
        let [left, width, height] = PLOT;
        let (right, low) = (left + width, self.top + height);
        let mut grid = String::new();
        let (across, up) = (self.knob.ticks.clone(), self.quantity.ticks.clone());
        for v in across {
            let [x, _] = self.at([v, 0.0]);
            let _ = write!(grid, "M{x:.1} {:.1}V{low:.1}", self.top);
            self.text(x, low + 12.0, "middle", &number(v));
        }
        for v in up {
            let [_, y] = self.at([0.0, v]);
            let _ = write!(grid, "M{left} {y:.1}H{right}");
            self.text(left - 4.0, y + 4.0, "end", &number(v));
        }
        let _ = writeln!(
            self.svg,
            "<path d=\"{grid}\" stroke=\"currentColor\" stroke-opacity=\"0.15\"/>\n\
             <path d=\"M{left} {:.1}V{low:.1}H{right}\" fill=\"none\" \
             stroke=\"currentColor\" stroke-opacity=\"0.6\"/>",
            self.top
        );
        self.bottom += 13.0;
        for line in lines(sweep.knob, width) {
            self.bottom += LINE;
            self.text(left + width / 2.0, self.bottom - 2.0, "middle", &line);
        }
    }

    fn path(&self, points: &[[f64; 2]]) -> String {
        let place = |&p: &[f64; 2]| {
            let [x, y] = self.at(p);
            format!("{x:.1},{y:.1}")
        };
        points.iter().map(place).collect::<Vec<_>>().join(" ")
    }

    fn found(&mut self, k: usize, points: &[[f64; 2]]) {
        let (path, colour) = (self.path(points), COLOURS[k % COLOURS.len()]);
        let _ = writeln!(
            self.svg,
            "<polyline points=\"{path}\" fill=\"none\" stroke=\"{colour}\" \
             stroke-width=\"1.8\"/>"
        );
        let mut before = [f64::NEG_INFINITY; 2];
        for at in points.iter().map(|&p| self.at(p)).collect::<Vec<_>>() {
            if (at[0] - before[0]).hypot(at[1] - before[1]) >= APART {
                self.mark(k, at);
                before = at;
            }
        }
    }

    /// Circle, square, triangle, diamond.
    fn mark(&mut self, k: usize, [x, y]: [f64; 2]) {
        let shape = match k % 4 {
            0 => format!(
                "M{:.1} {y:.1}a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0z",
                x - 3.2
            ),
            1 => format!("M{:.1} {:.1}h5.6v5.6h-5.6z", x - 2.8, y - 2.8),
            2 => format!("M{x:.1} {:.1}l3.8 6.6h-7.6z", y - 4.2),
            _ => format!("M{x:.1} {:.1}l4 4l-4 4l-4 -4z", y - 4.0),
        };
        let colour = COLOURS[k % COLOURS.len()];
        let _ = writeln!(self.svg, "<path d=\"{shape}\" fill=\"{colour}\"/>");
    }

    fn theory(&mut self, points: &[[f64; 2]]) {
        if !points.is_empty() {
            let path = self.path(points);
            self.dashed(&path);
        }
    }

    fn dashed(&mut self, path: &str) {
        let _ = writeln!(
            self.svg,
            "<polyline points=\"{path}\" fill=\"none\" stroke=\"currentColor\" \
             stroke-width=\"1.3\" stroke-dasharray=\"5 3\"/>"
        );
    }

    /// Mark and name of each method, and the law of the theory; one after the other
    /// where they fit in a line.
    fn key(&mut self, entries: &[(Option<usize>, &str)]) {
        let (sample, gap) = (24.0, 14.0);
        let mut x = WIDTH;
        for (what, name) in entries {
            let wide = lines(name, WIDTH - sample - 4.0);
            let width = sample + LETTER * wide[0].chars().count() as f64;
            if x + width > WIDTH - 2.0 {
                self.bottom += LINE;
                x = 2.0;
            }
            let y = self.bottom - 4.0;
            match what {
                Some(k) => {
                    let colour = COLOURS[k % COLOURS.len()];
                    let _ = writeln!(
                        self.svg,
                        "<path d=\"M{x:.1} {y:.1}h18\" stroke=\"{colour}\" \
                         stroke-width=\"1.8\"/>"
                    );
                    self.mark(*k, [x + 9.0, y]);
                }
                None => self.dashed(&format!("{x:.1},{y:.1} {:.1},{y:.1}", x + 19.0)),
            }
            self.text(x + sample, y + 4.0, "start", &wide[0]);
            for line in &wide[1..] {
                self.bottom += LINE;
                self.text(x + sample, self.bottom, "start", line);
            }
            x = if wide.len() > 1 { WIDTH } else { x + width + gap };
        }
        self.bottom += 6.0;
    }
}
