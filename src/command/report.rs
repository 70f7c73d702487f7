//! What a solution says of itself: the ledger, the certificate, the JSON object.

use radiosity::certificate::Certificate;
use radiosity::geometry::Rgb;
use radiosity::scene::Scene;
use radiosity::solution::Solution;
use radiosity::solve::Ledger;
use radiosity::tables;
use serde_json::{Value, json};
use std::fmt::Write;

/// `[r, g, b]`.
pub fn rgb(value: Rgb) -> Value {
    json!(value.to_array())
}

/// The object that `--json` prints for a solution and what was decided on the way; the
/// seconds that it took stand after the patches.
pub fn json_timed(
    solution: &Solution,
    plan: &[String],
    tolerance: f64,
    seconds: f64,
) -> Value {
    let mut object = serde_json::Map::new();
    let summary = tables::summary(solution, plan, tolerance);
    if let Ok(Value::Object(entries)) = serde_json::from_str(&summary) {
        for (key, value) in entries {
            if key == "tolerance" {
                object.insert("seconds".into(), json!(seconds));
            }
            object.insert(key, value);
        }
    }
    Value::Object(object)
}

/// The summary for people.
pub fn text(
    scene: &Scene,
    solution: &Solution,
    tolerance: f64,
    seconds: f64,
) -> String {
    let (elements, patches) =
        (solution.field.mesh.elements.len(), solution.field.patches);
    let mut text = format!(
        "{}: {elements} elements on {patches} patches, {} steps, {seconds:.1} s\n",
        scene.name, solution.field.steps
    );
    text += &ledger(&solution.field.ledger);
    text += &certificate(&solution.certificate);
    let reached = match solution.converged {
        true => "reached",
        false => "not reached within the limit of elements",
    };
    let _ = writeln!(text, "asked for: {}, {reached}", percent(tolerance));
    text
}

/// The energy account as a table, in W, and how well it closes.
fn ledger(ledger: &Ledger) -> String {
    let mut text =
        format!("{:<10}{:>14}{:>14}{:>14}\n", "power, W", "red", "green", "blue");
    let rows = [
        ("emitted", ledger.emitted),
        ("absorbed", ledger.absorbed),
        ("escaped", ledger.escaped),
        ("unshot", ledger.unshot),
        ("imbalance", ledger.imbalance),
    ];
    for (name, Rgb { x, y, z }) in rows {
        let cells = [x, y, z].map(number);
        let _ = writeln!(
            text,
            "{name:<10}{:>14}{:>14}{:>14}",
            cells[0], cells[1], cells[2]
        );
    }
    let share = percent(ledger.worst_imbalance());
    let _ = writeln!(text, "the account closes to {share} of what is emitted");
    text
}

fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        1e-3..1e6 => format!("{x:.4}"),
        _ => format!("{x:.3e}"),
    }
}

fn certificate(certificate: &Certificate) -> String {
    let Certificate { error, low, high, confidence, irradiance, .. } = *certificate;
    let most = |high: f64| match high.is_finite() {
        true => format!("at most {}", percent(high)),
        false => "an upper bound cannot be given".into(),
    };
    let mut text = format!(
        "the field is off by about {} of the reflected light: at least {}, {} \
         ({confidence:.0} % sure)\n\
         and by about {} of the light that arrives: at least {}, {}\n",
        percent(error),
        percent(low),
        most(high),
        percent(irradiance.error),
        percent(irradiance.low),
        most(irradiance.high),
        confidence = 100.0 * confidence,
    );
    if certificate.unseen > certificate.reflected {
        text += &format!(
            "of what the lamps and the sky send, up to {} may go where no ray has found it: \
             more than is seen reflected\n",
            percent(certificate.unseen)
        );
    }
    text
}

/// `0.0314` as `3.1 %`.
pub fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".into(),
        p if p.abs() < 0.01 => format!("{p:.1e} %"),
        p if p.abs() < 1.0 => format!("{p:.2} %"),
        p => format!("{p:.1} %"),
    }
}
