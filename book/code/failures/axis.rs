//! An axis of a small curve: a few ticks, linear or logarithmic.

/// One direction of a curve: which values it spans, and where they lie.
pub struct Axis {
    logarithmic: bool,
    /// The ends; of a logarithmic axis as decades.
    ends: [f64; 2],
    /// A logarithmic axis has a place for nothing, below all: zero has no logarithm.
    zero: Option<f64>,
    /// The values that are told.
    pub ticks: Vec<f64>,
}

/// How many ticks are few.
const FEW: usize = 6;

impl Axis {
    /// Spans these values; `round` widens the ends to ticks.
    pub fn of(values: &[f64], logarithmic: bool, round: bool) -> Axis {
        if logarithmic { Axis::of_decades(values) } else { Axis::linear(values, round) }
    }

    fn linear(values: &[f64], round: bool) -> Axis {
        let [mut low, mut high] = span(values);
        if round && low > 0.0 && low < 0.5 * high {
            low = 0.0; // what is so near shows how far it is from nothing
        }
        if high - low <= 1e-9 * high.abs() {
            [low, high] = if low == 0.0 {
                [0.0, 1.0]
            } else {
                [low - 0.5 * low.abs(), high + 0.5 * high.abs()]
            };
        }
        let step = step(high - low);
        if round {
            [low, high] = [
                (low / step + 1e-9).floor() * step,
                (high / step - 1e-9).ceil() * step,
            ];
        }
        let ticks = steps(low, high, step);
        Axis { logarithmic: false, ends: [low, high], zero: None, ticks }
    }

    fn of_decades(values: &[f64]) -> Axis {
        let positive: Vec<f64> = values.iter().copied().filter(|v| *v > 0.0).collect();
        let [low, high] = span(&positive).map(f64::log10);
        let (mut low, mut high) =
            if low.is_finite() { (low, high) } else { (-1.0, 0.0) };
        if high - low < 0.2 {
            (low, high) = (low - 0.2, high + 0.2);
        }
        let zero = (positive.len() < values.len()).then(|| {
            let place = low - 0.12 * (high - low);
            low = place;
            place
        });
        let floor = zero.map_or(low, |place| place + 0.1 * (high - low));
        let mut ticks = decades(floor, high);
        if zero.is_some() {
            ticks.insert(0, 0.0);
        }
        Axis { logarithmic: true, ends: [low, high], zero, ticks }
    }

    /// Where `v` lies, from 0 to 1.
    pub fn place(&self, v: f64) -> f64 {
        let at = match (self.logarithmic, self.zero) {
            (true, Some(place)) if v <= 0.0 => place,
            (true, _) => v.log10(),
            (false, _) => v,
        };
        (at - self.ends[0]) / (self.ends[1] - self.ends[0])
    }
}

fn span(values: &[f64]) -> [f64; 2] {
    let wider = |[l, h]: [f64; 2], &v: &f64| [l.min(v), h.max(v)];
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], wider)
}

/// 1, 2 or 5 times a power of ten: a width that has at most five steps or so.
fn step(width: f64) -> f64 {
    let power = 10f64.powf((width / 4.0).log10().floor());
    let fits = |k: &f64| width / (k * power) <= 5.0;
    [1.0, 2.0, 5.0].into_iter().find(fits).unwrap_or(10.0) * power
}

fn steps(low: f64, high: f64, step: f64) -> Vec<f64> {
    let (first, last) =
        ((low / step - 1e-6).ceil() as i64, (high / step + 1e-6).floor() as i64);
    (first..=last).map(|k| k as f64 * step).collect()
}

/// Whole decades from `low` to `high` (themselves decades), not all if they are many;
/// with 2 and 5 between where they are few.
fn decades(low: f64, high: f64) -> Vec<f64> {
    let (first, last) = ((low - 1e-6).ceil() as i32, (high + 1e-6).floor() as i32);
    let every = 1 + ((last - first).max(0) as usize) / FEW;
    let whole: Vec<f64> =
        (first..=last).rev().step_by(every).map(|e| 10f64.powi(e)).collect();
    if whole.len() > 2 {
        return whole.into_iter().rev().collect();
    }
    let within = |v: &f64| (low - 1e-6..=high + 1e-6).contains(&v.log10());
    let of_decade = |e: i32| [1.0, 2.0, 5.0].map(|k| k * 10f64.powi(e));
    let between: Vec<f64> =
        (first - 1..=last).flat_map(of_decade).filter(within).collect();
    if between.len() > 1 {
        return between;
    }
    let [low, high] = [low, high].map(|e| 10f64.powf(e));
    steps(low, high, step(high - low))
}

/// A number as a tick tells it: short.
pub fn number(v: f64) -> String {
    let (v, size) = (v + 0.0, v.abs()); // no −0
    if v == 0.0 || (1e-3 * (1.0 - 1e-9)..1e5).contains(&size) {
        let digits =
            if v == 0.0 { 0 } else { (3.0 - size.log10().floor()).max(0.0) as usize };
        let text = format!("{v:.digits$}");
        let short = if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.')
        } else {
            &text
        };
        return short.replace('-', "−");
    }
    let power = size.log10().floor() as i32;
    let factor = (v / 10f64.powi(power) * 100.0).round() / 100.0;
    let raised: String = power.to_string().chars().map(superscript).collect();
    if factor == 1.0 {
        format!("10{raised}")
    } else {
        format!("{factor}·10{raised}").replace('-', "−")
    }
}

fn superscript(c: char) -> char {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize])
}
