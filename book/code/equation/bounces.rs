//! The light, bounce by bounce: the terms of the Neumann series, and their sums.

use super::system::{ALL, cornell};
use radiosity::film::RgbImage;
use std::fmt::Write;

/// The terms that are drawn alone.
pub const SHOWN: [u32; 4] = [0, 1, 2, 3];

/// The most bounces of the opening pictures, before the one of [`ALL`].
pub const SUMS: u32 = 4;

/// The light that has bounced at most so many times, at exposure 1.
pub fn sum_picture(bounces: u32) -> RgbImage {
    let room = cornell();
    room.picture(&room.after(bounces), 1.0)
}

/// How much brighter a term is shown than it is.
fn exposure(bounces: u32) -> f64 {
    f64::from(1 << bounces.saturating_sub(1))
}

/// The light that has bounced so many times, no more and no fewer.
pub fn alone_picture(bounces: u32) -> RgbImage {
    let room = cornell();
    room.picture(&room.alone(bounces), exposure(bounces))
}

/// The caption under it.
pub fn alone_caption(bounces: u32) -> String {
    let room = cornell();
    let power = room.power(&room.alone(bounces));
    let share = 100.0 * power / room.power(&room.after(ALL));
    let times = match bounces {
        0 => String::new(),
        1 => "One: ".into(),
        k => format!("{k}, shown × {}: ", exposure(k)),
    };
    format!("{times}{power:.2} W, {share:.0} % of all that leaves")
}

/// The caption of the opening picture.
pub fn caption() -> String {
    let room = cornell();
    let drawn: Vec<String> = (0..SUMS).map(|bounces| bounces.to_string()).collect();
    format!(
        "Scene <code>cornell</code>, {} elements with edges up to 0.05 m, analytic \
         form factors, exposure 1, smooth shading. Light after at most {} and {SUMS} \
         bounces, and after {ALL}.",
        room.mesh.elements.len(),
        drawn.join(", ")
    )
}

/// Where the light is after each bounce, all channels together.
pub fn ledger() -> String {
    let room = cornell();
    let emitted = room.power(&room.enclosure.emission);
    let mut text = String::from(
        "| after bounce | absorbed, W | escaped, W | under way, W | imbalance, W |\n\
         |---|---|---|---|---|\n",
    );
    let (mut absorbed, mut escaped) = (0.0, 0.0);
    let mut b = room.enclosure.emission.clone();
    for bounce in 0..=ALL {
        let moving = room.power(&b);
        if bounce <= 5 || bounce == 10 || bounce == ALL {
            let off = emitted - absorbed - escaped - moving;
            let off = if off.abs() < 5e-5 { 0.0 } else { off };
            let _ = writeln!(
                text,
                "| {bounce} | {absorbed:.4} | {escaped:.4} | {moving:.4} | \
                 {off:.4} |"
            );
        }
        let arriving = room.power(&room.arriving(&b));
        for (i, row) in room.factors.rows().iter().enumerate() {
            let sent = room.enclosure.area[i] * b[i].element_sum();
            escaped += sent * row.lost().escaped;
            absorbed += sent * row.lost().absorbed; // by black backs
        }
        b = room.bounced(&b);
        absorbed += arriving - room.power(&b);
    }
    let _ = write!(text, "\nEmitted: {emitted:.4} W.\n");
    text
}
