//! `cargo lab` as students, lecturers and other programs meet it.

use serde_json::Value;
use std::process::{Command, Output};

fn lab(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab"));
    command.args(arguments).output().expect("the grader starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

fn graded(arguments: &[&str]) -> Value {
    let output = lab(&[&["grade", "hemicube"], arguments].concat());
    serde_json::from_slice(&output.stdout).expect("one JSON object, and nothing else")
}

#[test]
fn exit_codes_tell_passed_failed_and_not_understood() {
    for (arguments, code) in [
        (&["run", "hemicube", "--answer"][..], 0),
        (&["grade", "hemicube", "--answer", "--json"], 0),
        (&["run", "hemicube", "--wrong", "no-pi"], 1),
        (&["grade", "hemicube", "--wrong", "no-pi"], 1),
        (&["grade", "--wrong", "no-pi"], 2), // whose? Each lab has its own
        (&["run", "hemicub"], 2),
        (&["run", "hemicube", "--task", "7"], 2),
        (&["run", "hemicube", "--task", "0"], 2),
        (&["run", "hemicube", "--wrong", "nobody"], 2),
        (&["run", "hemicube", "--limit", "0"], 2),
        (&["hint", "hemicube", "7"], 2),
        (&["grade", "hemicube", "--answer", "-o", "no/such/folder/grade.md"], 2),
        (&["run", "hemicube", "--answer", "--cohort=--odd name"], 0),
        (&["list"], 0),
        (&["list", "hemicube"], 0),
        (&["nonsense"], 2),
    ] {
        let output = lab(arguments);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {output:?}");
        assert!(code != 2 || output.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn a_grade_names_every_test_its_points_and_its_deviation() {
    let grade = graded(&["--json", "--answer", "--cohort", "ws26"]);
    assert_eq!(grade["cohort"], "ws26");
    assert_eq!(grade["points"], grade["max"]);
    let tests = grade["tests"].as_array().expect("tests");
    assert!(!tests.is_empty());
    let sum: u64 = tests.iter().filter_map(|test| test["max"].as_u64()).sum();
    assert_eq!(grade["max"], sum);
    for test in tests {
        let (metric, tolerance) = (&test["metric"], &test["tolerance"]);
        assert!(metric.as_f64() <= tolerance.as_f64(), "{test}");
        assert!(test["passed"] == true && test["message"].is_null(), "{test}");
        assert!(test["id"].is_string() && test["seconds"].is_f64(), "{test}");
    }
}

#[test]
fn a_wrong_answer_is_told_its_mistake_in_every_format() {
    let wrong = ["--wrong", "normalised-solid-angle"];
    let grade = graded(&[&wrong[..], &["--json"]].concat());
    let tests = grade["tests"].as_array().expect("tests");
    let known = tests.iter().find(|t| t["id"] == "hemicube.6.known").expect("known");
    assert_eq!(known["bug"], "normalised-away");
    let message = known["message"].as_str().expect("a message");
    // The known wrong program: .128 where .2395 is right, with rows that sum to 1.
    assert!(message.contains("got 0.128"), "{message}");
    assert!(message.contains("46 % low"), "{message}");
    assert!(message.contains("sums to 1.000"), "{message}");

    let scope = graded(&[&wrong[..], &["--format", "gradescope"]].concat());
    assert_eq!(scope["score"], grade["points"]);
    assert_eq!(scope["tests"].as_array().map(Vec::len), Some(tests.len()));
    for format in ["junit", "markdown"] {
        let arguments = ["grade", "hemicube", "--format", format];
        let output = lab(&[&arguments[..], &wrong].concat());
        assert!(text(&output.stdout).contains("divided away?"), "{format}");
    }
}

#[test]
fn junit_counts_its_failures() {
    let output =
        lab(&["grade", "hemicube", "--format", "junit", "--wrong", "transposed"]);
    let xml = text(&output.stdout);
    assert!(xml.contains("failures=\"1\""), "{xml}");
    assert_eq!(xml.matches("<testcase").count(), xml.matches("time=").count());
    assert_eq!(xml.matches("<failure").count(), 1);
}

#[test]
fn a_cohort_varies_the_numbers_and_nothing_else() {
    let of = |cohort: &str| {
        let mut grade = graded(&["--json", "--wrong", "no-area", "--cohort", cohort]);
        for test in grade["tests"].as_array_mut().expect("tests") {
            test["seconds"] = Value::Null;
        }
        grade
    };
    assert_eq!(of("one"), of("one"), "the same cohort, the same record");
    let (one, two) = (of("one"), of("two"));
    assert_eq!(one["points"], two["points"]);
    assert_ne!(one["tests"][0]["message"], two["tests"][0]["message"]);
}

#[test]
fn what_a_student_prints_is_passed_on_and_does_not_disturb() {
    let output = lab(&["grade", "hemicube", "--json", "--wrong", "panics"]);
    assert!(text(&output.stderr).contains("40 cells"));
    let grade: Value = serde_json::from_slice(&output.stdout).expect("JSON alone");
    let test = &grade["tests"][4];
    assert_eq!(test["bug"], "panic");
    let message = test["message"].as_str().expect("a message");
    assert!(message.starts_with("panicked at labs/src/hemicube/"), "{message}");
}

#[test]
fn the_limit_holds_for_one_task_and_spares_the_others() {
    let grade = graded(&["--json", "--wrong", "endless", "--limit", "0.5"]);
    let tests = grade["tests"].as_array().expect("tests");
    for test in tests.iter().filter(|test| test["task"] != 5) {
        // A limit so short may catch others on a busy machine; nobody else is endless.
        let late = test["bug"] == "endless";
        assert!(test["passed"] == true || late, "{test}");
    }
    let endless = tests.iter().find(|test| test["task"] == 5).expect("task 5");
    assert_eq!(endless["message"], "did not finish in 0.5 s");
    assert!(endless["seconds"].as_f64() < Some(60.0));
}

#[test]
fn hints_come_from_the_brief_and_from_its_task_alone() {
    let output = lab(&["hint", "hemicube", "2"]);
    let hints = text(&output.stdout);
    assert!(hints.contains("one cosine is missing"), "{hints}");
    assert!(!hints.contains("details") && !hints.contains("Hints for task 3"));
}
