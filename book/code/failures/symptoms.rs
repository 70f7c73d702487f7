//! What to suspect first: from what is seen to the rows that may be behind it.

use super::rows::rows;
use super::{FAMILIES, page};

/// What is seen, which rows may be behind it, and the turn of a knob that tells them apart.
pub struct Symptom {
    /// What one sees or measures.
    pub seen: &'static str,
    /// The likeliest first.
    pub rows: &'static [u8],
    /// What to do next.
    pub turn: &'static str,
}

const fn symptom(
    seen: &'static str,
    rows: &'static [u8],
    turn: &'static str,
) -> Symptom {
    Symptom { seen, rows, turn }
}

/// Every row that is asserted stands behind one of these.
pub const SYMPTOMS: [Symptom; 17] = [
    symptom(
        "light grows with each sweep, or never settles",
        &[2, 3, 48, 53, 55, 47, 69],
        "Sum the rows of F and look for ρ ≥ 1. Rows above 1: the factors. Rows right: the solver.",
    ),
    symptom(
        "the room is too bright or too dark as a whole",
        &[15, 77, 16, 17, 51, 64, 66, 65, 27, 21],
        "Read the ledger. An imbalance: factors. None, and a factor of π: display.",
    ),
    symptom(
        "wrong where surfaces touch or are near",
        &[1, 4, 5, 6, 7, 8, 9, 11, 44, 72, 24],
        "Move them apart by five sizes. Gone: proximity. Not gone: visibility.",
    ),
    symptom(
        "wrong everywhere, while all rows sum to 1",
        &[14, 16, 45, 12, 10],
        "Compare one factor with its closed form: laws do not show it.",
    ),
    symptom(
        "speckles, or lamps that come and go",
        &[18, 19, 20, 22, 38, 75, 56, 50],
        "Double the resolution or the rays. Half as many speckles: sampling. As many: size.",
    ),
    symptom(
        "light where a wall is in the way",
        &[35, 28, 52, 33, 32, 62],
        "Halve the elements. It gets narrower and not dimmer: a leak of the mesh.",
    ),
    symptom(
        "shadows miss, float, or end in stairs",
        &[36, 37, 29, 23, 33, 32],
        "Halve the elements of the receiver only, then of the sender only.",
    ),
    symptom(
        "cracks, pinholes, single black pixels",
        &[39, 31, 26, 25, 30, 24],
        "Shift the eye by a millionth. It moves: the raster. It stays: the mesh.",
    ),
    symptom(
        "bands or edges on smooth walls",
        &[40, 41, 39, 42, 78],
        "Look at the numbers in false colour. Smooth there: the display.",
    ),
    symptom(
        "the answer depends on scale, order, seed or threads",
        &[30, 54, 58, 56, 10],
        "Run it in millimetres, then with another seed, then sorted otherwise.",
    ),
    symptom(
        "it says it is done, and is not",
        &[49, 43, 11, 38, 47],
        "Ask the certificate, which gathers where nobody looked.",
    ),
    symptom(
        "it takes for ever",
        &[47, 44, 63, 34, 53],
        "Count: sweeps, links, images, tests for a ray. One of them does not fit the scene.",
    ),
    symptom(
        "mirrors and panes show too much, too little or the wrong place",
        &[60, 61, 62, 63, 67, 68, 73, 64],
        "Replace the mirror by the room behind it: both must agree.",
    ),
    symptom(
        "gloss and glass are noisy, banded or dark",
        &[70, 71, 57, 73, 72],
        "Put it into a room that glows evenly: it must vanish.",
    ),
    symptom(
        "the sky is too bright or turns with the picture",
        &[74, 76, 75],
        "Light a plane by a constant map at every tilt: ½(1 + cosβ).",
    ),
    symptom(
        "colours, greys or textures are off",
        &[78, 46, 59, 79, 77, 42],
        "Show a ramp of known light, then a white furnace.",
    ),
    symptom(
        "the scene is not the one that was drawn",
        &[80, 13, 28, 81, 82, 12],
        "Read the warnings, then sum areas and look at ids in colours.",
    ),
];

/// The table of all symptoms, each row by number and name.
pub fn table() -> String {
    let all = rows();
    let link = |number: &u8| {
        let row = all.iter().find(|row| row.number == *number)?;
        let family = FAMILIES.iter().find(|f| f.rows.contains(number))?;
        let (name, page) = (page::plain(row.name), family.page);
        Some(format!(
            "[{number}]({page}.md#row-{number:02} \"{}\")",
            name.replace('"', "'")
        ))
    };
    let mut text = String::from(
        "| what is seen | suspect, the likeliest first | turn this next |\n|---|---|---|\n",
    );
    for Symptom { seen, rows, turn } in &SYMPTOMS {
        let links: Vec<String> = rows.iter().filter_map(link).collect();
        text += &format!("| {seen} | {} | {turn} |\n", links.join(", "));
    }
    text
}
