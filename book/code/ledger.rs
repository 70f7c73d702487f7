//! The energy ledger of a solution, as a Markdown table.

use glam::DVec3;
use radiosity::solution::Solution;
use radiosity::solve::Ledger;

/// Where the light went: a line for each entry, channel by channel, in W and as a share.
pub fn table(solution: &Solution) -> String {
    of(&solution.field.ledger)
}

/// The same of a ledger by itself.
pub fn of(ledger: &Ledger) -> String {
    let Ledger { emitted, absorbed, escaped, unshot, imbalance } = *ledger;
    let mut text = String::from(
        "| power, W | red | green | blue | share |\n|---|---|---|---|---|\n",
    );
    let mut line = |name: &str, w: DVec3| {
        // No −0.0000: what is below the last digit counts 0.
        let [x, y, z] = w.to_array().map(|v| if v.abs() < 5e-5 { 0.0 } else { v });
        let share = 100.0 * w.element_sum() / emitted.element_sum();
        let share = if share.abs() < 5e-3 { 0.0 } else { share };
        text.push_str(&format!(
            "| {name} | {x:.4} | {y:.4} | {z:.4} | {share:.2} % |\n"
        ));
    };
    line("emitted", emitted);
    line("absorbed", absorbed);
    line("escaped", escaped);
    line("unshot", unshot);
    line("imbalance", imbalance);
    text
}
