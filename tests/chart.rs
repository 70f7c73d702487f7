//! The race of the solvers and the drawing of charts.

use radiosity::chart::race::{Finish, contestants, csv, table};
use radiosity::chart::{Chart, Line, Mark, Race};

/// All come in, each as many times as its theory says: Jacobi needs the bounces until
/// `ρ^k` is the accuracy, Gauss–Seidel half of them, conjugate gradients hardly more for
/// light that lasts ten times as long.
#[test]
fn all_solvers_come_in() {
    let race = Race::new(1.5, 1e-4);
    let finish = |rho: f64| -> Vec<Finish> {
        contestants().iter().map(|c| race.run(c, rho, &|| 0.0)).collect()
    };
    let (short, long) = (finish(0.9), finish(0.99));
    for f in short.iter().chain(&long) {
        assert!(f.converged && f.bound <= 1e-4 && f.steps > 0, "{f:?}");
    }
    let steps = |of: &[Finish], name: &str| {
        of.iter().find(|f| f.solver == name).map_or(0, |f| f.steps) as f64
    };
    let bounces = 1e-4_f64.ln() / 0.99_f64.ln();
    let jacobi = steps(&long, "Jacobi") / bounces;
    assert!((jacobi - 1.0).abs() < 0.02, "{jacobi}");
    let saved = steps(&long, "Gauss-Seidel") / steps(&long, "Jacobi");
    assert!((0.45..0.6).contains(&saved), "{saved}");
    let grown = |name| steps(&long, name) / steps(&short, name);
    assert!(grown("Jacobi") > 9.0 && grown("conjugate gradients") < 2.0);
}

/// A run without end is told as such: no number in the table, `false` in the CSV.
#[test]
fn who_does_not_come_in_has_no_number() {
    let race = Race::new(3.0, 1e-4);
    let [jacobi, ..] = contestants();
    let mut finish = race.run(&jacobi, 0.5, &|| 0.0);
    assert!(table(&[finish.clone()], |f| f.steps.to_string()).contains("13"));
    finish.converged = false;
    assert!(table(&[finish.clone()], |f| f.steps.to_string()).ends_with("-\n"));
    let csv = csv("one\ntwo", &[finish]);
    assert!(csv.starts_with("# one\n# two\nsolver,") && csv.ends_with("false\n"));
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
