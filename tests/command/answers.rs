//! What is said on standard output and standard error.

use super::Folder;
use std::process::Stdio;

/// The keys of the contract, in its order.
const SOLVED: [&str; 9] = [
    "elements",
    "patches",
    "seconds",
    "tolerance",
    "converged",
    "solver_residual",
    "certificate",
    "ledger",
    "plan",
];

#[test]
fn solve_answers_other_programs_with_one_object() {
    let folder = Folder::new();
    let answer =
        folder.run("solve facing-squares -o x.csv --json --tolerance 4%").done();
    assert_eq!(answer.err, "");
    let json = answer.json();
    assert_eq!(json.keys().collect::<Vec<_>>(), SOLVED);
    assert_eq!(json["tolerance"], 0.04);
    let plan: Vec<&str> = json["plan"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|line| line.as_str().expect("a line"))
        .collect();
    assert!(plan[0].starts_with("room: open: 80 %"), "{plan:?}");
    assert!(plan.iter().any(|line| line.starts_with("run: pass 1: ")), "{plan:?}");
    assert!(json["patches"].as_u64() > Some(2), "{json:?}");
    assert_eq!(json["converged"], true);
    let certificate = json["certificate"].as_object().unwrap();
    assert_eq!(
        certificate.keys().collect::<Vec<_>>(),
        ["error", "low", "high", "confidence", "irradiance", "unseen"]
    );
    let of_h = certificate["irradiance"].as_object().unwrap();
    assert_eq!(of_h.keys().collect::<Vec<_>>(), ["error", "low", "high"]);
    let of = |key: &str| certificate[key].as_f64().expect("a number");
    assert!(of("low") <= of("error") && of("error") <= of("high"), "{certificate:?}");
    let ledger = json["ledger"].as_object().unwrap();
    let entries = ["emitted", "absorbed", "escaped", "unshot", "imbalance"];
    assert_eq!(ledger.keys().collect::<Vec<_>>(), entries);
    let rgb = |key: &str, k: usize| ledger[key][k].as_f64().expect("a number");
    for k in 0..3 {
        let spent: f64 = entries[1..].iter().map(|key| rgb(key, k)).sum();
        assert!((rgb("emitted", k) - spent).abs() < 1e-9, "{ledger:?}");
        assert!((rgb("emitted", k) - 1.0).abs() < 1e-12, "{ledger:?}");
    }
}

#[test]
fn a_tolerance_out_of_reach_is_a_value_not_an_error() {
    let folder = Folder::new();
    let json = folder.run("solve facing-squares --json --tolerance 1e-6").done().json();
    assert_eq!(json["converged"], false);
}

#[test]
fn render_and_form_factors_answer_with_one_object_too() {
    let folder = Folder::new();
    let json = folder.run("render furnace -o x.png --size 16x16 --json").done().json();
    assert_eq!(json.keys().take(9).collect::<Vec<_>>(), SOLVED);
    assert!(json["exposure"].as_f64() > Some(0.0) && json["clamped"].is_number());
    let json = folder.run("form-factors furnace --json").done().json();
    let keys =
        ["n", "seconds", "open", "closure_max", "reciprocity_max", "error_estimate"];
    assert_eq!(json.keys().collect::<Vec<_>>(), keys);
}

#[test]
fn people_get_the_ledger_and_the_certificate() {
    let folder = Folder::new();
    let answer = folder.run("render furnace -o x.png --size 16x16").done();
    for words in ["imbalance", "unshot", "reflected light", "clamped", "x.png"] {
        assert!(answer.out.contains(words), "{words}: {}", answer.out);
    }
    assert_eq!(answer.err, "");
    let quiet = folder.run("render furnace -o x.png --size 16x16 --quiet").done();
    assert_eq!((quiet.out.as_str(), quiet.err.as_str()), ("", ""));
}

#[test]
fn no_argument_draws_the_cornell_box() {
    let folder = Folder::new();
    let answer = folder.run("").done();
    assert!(answer.out.starts_with("cornell: "), "{}", answer.out);
    assert_eq!(folder.names(), ["out"]);
    let picture = image::open(folder.path().join("out/cornell.png")).expect("a PNG");
    let at = |x, y| picture.to_rgb8().get_pixel(x, y).0;
    let ([r, g, _], [s, h, _]) = (at(40, 200), at(470, 200));
    assert!(r > 3 * g.max(1) && h > s, "red left, green right: {r} {g}, {s} {h}");
}

#[test]
fn every_verb_explains_itself_with_examples() {
    let folder = Folder::new();
    for verb in ["", "scenes", "solve", "form-factors", "render", "compare", "chart"] {
        let help = folder.run(&format!("{verb} --help")).done().out;
        assert!(help.contains("Examples:") && help.contains("--json"), "{help}");
    }
}

/// `radiosity scenes | head -1`: the reader goes, and that is no failure.
#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    let folder = Folder::new();
    for arguments in ["scenes", "scenes --json", "--help", "form-factors furnace"] {
        let mut command = folder.command(arguments);
        let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("the command runs");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("an end");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{arguments}: {said}");
    }
}

/// A repair is done when it is named, and says what it did; in an open scene it would
/// invent light.
#[test]
fn closing_is_reported_and_open_scenes_are_not_closed() {
    let folder = Folder::new();
    let asked = "form-factors l-room -o F.csv --tolerance 1e-3 --json";
    let raw = folder.run(asked).done().json();
    assert!(raw.get("close").is_none() && raw["closure_max"].as_f64() > Some(1e-6));
    let closed = folder.run(&format!("{asked} --close")).done().json();
    assert!(closed["closure_max"].as_f64() < Some(1e-12), "{closed:?}");
    assert_eq!(closed["close"]["closure_before"], raw["closure_max"]);
    let change = closed["close"]["largest_change"].as_f64().unwrap();
    assert!((1e-9..1e-3).contains(&change), "{closed:?}");
    // What was missed before still stands in the estimate of the error.
    assert!(closed["error_estimate"].as_f64() >= raw["closure_max"].as_f64());

    let open = folder.run("form-factors facing-squares -o G.csv --close");
    assert_eq!(open.code, Some(1));
    assert!(open.err.contains("--close would invent light"), "{open:?}");
    assert_eq!(folder.names(), ["F.csv"]);
}

#[test]
fn explain_tells_what_and_why_and_after_a_run_what_was_spent() {
    let folder = Folder::new();
    let text = folder.run("explain cornell --tolerance 2%").done().out;
    assert!(text.starts_with("What cornell needs to be right to 2 %:"), "{text}");
    assert!(text.contains("pass 2 would change nothing, skipped"), "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    let json = folder.run("explain facing-squares --json").done().json();
    let keys = ["scene", "tolerance", "decisions", "predicted"];
    assert_eq!(json.keys().collect::<Vec<_>>(), keys);
    for decision in json["decisions"].as_array().expect("a list") {
        assert!(decision["what"].is_string() && decision["why"].is_string());
        assert!(decision["value"].is_number(), "{decision}");
    }
    let run = "explain facing-squares --json --run --tolerance 5%";
    let json = folder.run(run).done().json();
    let counts = ["patches", "hemicubes", "elements", "seconds"];
    let told = |key: &str| {
        let object = json[key].as_object().expect("an object");
        counts.map(|count| object[count].as_f64().expect("a number"))
    };
    let (predicted, spent) = (told("predicted"), told("spent"));
    assert_eq!(predicted[0], spent[0]);
    assert!(spent[3] > 0.0 && json["spent"]["converged"] == true, "{json:?}");
    assert!(json["spent"]["stages"]["certifying"].is_number(), "{json:?}");
    assert!(folder.names().is_empty(), "nothing is written");
}
