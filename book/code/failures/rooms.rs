//! How the plan's own defaults held in 500 random rooms: a table of what was found.

/// What `cargo test --test laws random_rooms::table -- --nocapture` printed.
const RECORD: &str = include_str!("../../data/random-rooms-2026-11-22.csv");

/// A line for each family of rooms, and their sum.
pub fn table() -> String {
    let mut text = String::from(
        "| rooms | how many | as right as asked for | error stated honestly | \
         most elements |\n|---|---|---|---|---|\n",
    );
    let mut sums = [0; 3];
    for line in RECORD.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells[k].parse::<u32>().expect("a count");
        let counts = [1, 2, 3].map(number);
        for (sum, count) in sums.iter_mut().zip(counts) {
            *sum += count;
        }
        let ([rooms, converged, honest], name) = (counts, cells[0].to_lowercase());
        let elements = number(8);
        text +=
            &format!("| {name} | {rooms} | {converged} | {honest} | {elements} |\n");
    }
    let [rooms, converged, honest] = sums;
    text + &format!("| **all** | {rooms} | {converged} | {honest} | |\n")
}
