//! The race of the solvers and the drawing of charts.

use radiosity::chart::race::{Finish, contestants};
use radiosity::chart::{
    Bench, Chart, ChartView, Column, Contest, Line, Mark, Method, Race, Trial, Verdict,
    WorkDone, csv, exponent, read,
};

/// All come in, each as many times as its theory says: Jacobi needs the bounces until
/// `ρ^k` is the accuracy, Gauss–Seidel half of them, conjugate gradients hardly more for
/// light that lasts ten times as long.
#[test]
fn all_solvers_come_in() {
    let race = Race::new(1.5, 1e-4);
    let finish = |rho: f64| contestants().map(|c| (c.name, race.run(&c, rho)));
    let (short, long) = (finish(0.9), finish(0.99));
    for (name, f) in short.iter().chain(&long) {
        assert!(f.converged && f.bound <= 1e-4 && f.work.steps > 0, "{name}: {f:?}");
    }
    let steps = |of: &[(&str, Finish)], name: &str| {
        of.iter().find(|f| f.0 == name).map_or(0, |f| f.1.work.steps) as f64
    };
    let bounces = 1e-4_f64.ln() / 0.99_f64.ln();
    let jacobi = steps(&long, "Jacobi") / bounces;
    assert!((jacobi - 1.0).abs() < 0.02, "{jacobi}");
    let saved = steps(&long, "Gauss-Seidel") / steps(&long, "Jacobi");
    assert!((0.45..0.6).contains(&saved), "{saved}");
    let grown = |name| steps(&long, name) / steps(&short, name);
    assert!(grown("Jacobi") > 9.0 && grown("conjugate gradients") < 2.0);
}

/// A contest runs every method at every setting. The error of a random method is the root
/// mean square over its seeds; that of others is their one error.
#[test]
fn a_contest_tells_errors_and_work() {
    let work = |n: f64| WorkDone { rays: n as u64, ..WorkDone::default() };
    let contest =
        Contest::new("a number", 1e-3, |x: &f64| Verdict::of((x - 1.0).abs()))
            .with(Method::new("series", &[1.0, 2.0, 3.0], |n, seed| {
                assert_eq!(seed, 0);
                (1.0 + 0.1_f64.powf(n), work(n))
            }))
            .with(Method::random("coin", &[5.0], |n, seed| {
                (1.0 + if seed % 2 == 0 { 0.3 } else { -0.4 }, work(n))
            }));
    let trials = contest.run("test", &Bench::SILENT);
    let told: Vec<_> =
        trials.iter().map(|t| (&*t.method, t.setting, t.work.rays)).collect();
    let expected =
        [("series", 1.0, 1), ("series", 2.0, 2), ("series", 3.0, 3), ("coin", 5.0, 5)];
    assert_eq!(told, expected);
    let coin = (0.5 * (0.3_f64.powi(2) + 0.4_f64.powi(2))).sqrt();
    for (trial, error) in trials.iter().zip([0.1, 0.01, 0.001, coin]) {
        assert!((trial.error - error).abs() < 1e-15, "{trial:?}");
        assert_eq!((trial.uncertainty, trial.seconds), (1e-3, 0.0));
    }
}

fn trial(method: &str, seconds: f64, error: f64) -> Trial {
    let [suite, scene] = ["suite", "scene"].map(String::from);
    let (work, method) =
        (WorkDone { factors: 7, ..WorkDone::default() }, method.into());
    let (uncertainty, energy) = (1e-6, Some(0.25));
    let (setting, runs, memory) = (2.0, 3, 1 << 40);
    Trial {
        suite,
        scene,
        method,
        setting,
        seconds,
        runs,
        work,
        memory,
        error,
        uncertainty,
        energy,
    }
}

/// What is written is read again; a line that does not fit is named.
#[test]
fn a_table_is_read_as_it_was_written() {
    let mut trials = vec![trial("a", 0.5, 1e-3), trial("b", 0.25, 2e-3)];
    trials[1].energy = None;
    let table = csv("one\ntwo", &trials);
    assert!(table.starts_with("# one\n# two\nsuite,scene,method,"));
    assert_eq!(read(&table).as_ref(), Ok(&trials));
    let broken = table.replace("5.000e-1", "soon");
    assert_eq!(read(&broken), Err("line 4: `soon` is no number".into()));
    let short =
        table.lines().map(|l| l.rsplit_once(',').map_or(l, |p| p.0).to_string());
    assert!(read(&short.collect::<Vec<_>>().join("\n")).is_err());
}

/// The frontier: who is slower and no better than somebody else is not on it.
#[test]
fn the_frontier_is_what_nothing_beats() {
    let trials = [
        trial("a", 1.0, 0.1),
        trial("a", 10.0, 0.001),
        trial("b", 2.0, 0.2), // beaten by the first
        trial("b", 5.0, 0.05),
    ];
    let view = ChartView {
        file: "test",
        title: "Test",
        across: (Column::Seconds, "s"),
        upward: (Column::Error, "error"),
        least: 1e-9,
        shows: |_| true,
    };
    let svg = view.chart(&trials).svg();
    assert_eq!(svg.matches("fill=\"var(--bg, white)\"").count(), 1, "{svg}");
    assert_eq!(svg.matches("class=\"frontier\"").count(), 1);
    assert!(svg.contains("the truth is known to here"));
    let over_setting =
        ChartView { across: (Column::Setting, "n"), ..view }.chart(&trials).svg();
    assert!(!over_setting.contains("frontier"), "a setting is no effort");
}

/// The fitted exponent of a power law is its exponent.
#[test]
fn exponents_are_found() {
    let law = |x: f64| trial("a", x, 3.0 * x.powf(-1.5));
    let trials: Vec<Trial> = [1.0, 3.0, 10.0, 70.0].map(law).into();
    let all: Vec<&Trial> = trials.iter().collect();
    let found = exponent(&all, Column::Seconds, Column::Error);
    assert!((found + 1.5).abs() < 1e-12, "{found}");
    assert!(exponent(&all[..1], Column::Seconds, Column::Error).is_nan());
}

fn chart(values: &[(f64, f64)]) -> String {
    let mark = |&(x, y): &(f64, f64)| Mark { x, y, label: String::new() };
    let lines =
        vec![Line { name: "a line".into(), marks: values.iter().map(mark).collect() }];
    let [title, across, upward] = ["Title", "x", "y"].map(String::from);
    Chart { title, across, upward, least: 0.0, lines, ..Chart::default() }.svg()
}

/// Values that have no logarithm are left out, one value alone has a decade about it, and
/// none at all make an empty sheet: no chart holds a number that is none.
#[test]
fn a_chart_of_anything_can_be_drawn() {
    for (values, drawn) in [
        (&[(1.0, 10.0), (10.0, 1.0)][..], 2),
        (&[(1.0, 1.0)], 1),
        (&[(0.0, 1.0), (1.0, 0.0), (f64::NAN, 1.0), (2.0, f64::INFINITY)], 0),
        (&[], 0),
    ] {
        let svg = chart(values);
        assert_eq!(svg.matches("class=\"mark\"").count(), drawn, "{values:?}");
        let points = svg.split("points=\"").nth(1).and_then(|s| s.split('"').next());
        assert!(!points.unwrap().contains(['N', 'i']), "{svg}");
        assert!(svg.contains("<title>Title</title>") && svg.ends_with("</svg>\n"));
    }
}
