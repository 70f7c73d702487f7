//! The equation with a slip in it: every one looks like light.

use super::system::{ALL, cornell};
use radiosity::film::RgbImage;
use radiosity::form_factor::Row;
use radiosity::geometry::Rgb;

/// What was written in place of `B_i = E_i + ρ_i Σ_j F_ij B_j`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slip {
    /// Nothing else.
    None,
    /// `ρ_j`: the sender's.
    Sender,
    /// `F_ji`: the factor the other way round.
    Transposed,
}

impl Slip {
    /// All of them.
    pub const ALL: [Slip; 3] = [Slip::None, Slip::Sender, Slip::Transposed];

    /// Its part of a file's name.
    pub fn file(self) -> &'static str {
        match self {
            Slip::None => "none",
            Slip::Sender => "sender",
            Slip::Transposed => "transposed",
        }
    }
}

/// The "radiosity" that the equation with this slip has.
pub fn solved(slip: Slip) -> Vec<Rgb> {
    let room = cornell();
    let (n, rho) = (room.mesh.elements.len(), &room.enclosure.reflectance);
    let mut rows = vec![Vec::new(); n];
    for (i, row) in room.factors.rows().iter().enumerate() {
        for &(j, factor) in row.factors() {
            match slip {
                Slip::Transposed => rows[j as usize].push((i as u32, factor)),
                _ => rows[i].push((j, factor)),
            }
        }
    }
    let rows: Vec<Row> =
        rows.into_iter().map(|row| Row::new(row, Default::default())).collect();
    let mut b = room.enclosure.emission.clone();
    for _ in 0..ALL {
        let gather = |(i, row): (usize, &Row)| {
            let term = |&(j, factor): &(u32, f64)| {
                let j = j as usize;
                let rho = if slip == Slip::Sender { rho[j] } else { rho[i] };
                factor * rho * b[j]
            };
            room.enclosure.emission[i] + row.factors().iter().map(term).sum::<Rgb>()
        };
        b = rows.iter().enumerate().map(gather).collect();
    }
    b
}

/// What becomes of the emitted power, as shares: absorbed by fronts and backs, and
/// escaped. They make 1 in the right solution.
pub fn shares(slip: Slip) -> [f64; 2] {
    let room = cornell();
    let b = solved(slip);
    let emitted = room.power(&room.enclosure.emission);
    let arriving = room.arriving(&b);
    let reflected: Vec<Rgb> = arriving
        .iter()
        .zip(&room.enclosure.reflectance)
        .map(|(h, rho)| h * rho)
        .collect();
    let mut kept = room.power(&arriving) - room.power(&reflected);
    let mut escaped = 0.0;
    for (i, row) in room.factors.rows().iter().enumerate() {
        let sent = room.enclosure.area[i] * b[i].element_sum();
        kept += sent * row.lost().absorbed;
        escaped += sent * row.lost().escaped;
    }
    [kept / emitted, escaped / emitted]
}

/// The solution as the camera sees it.
pub fn picture(slip: Slip) -> RgbImage {
    cornell().picture(&solved(slip), 1.0)
}

/// The caption under it.
pub fn caption(slip: Slip) -> String {
    let what = match slip {
        Slip::None => "Right",
        Slip::Sender => "The sender's ρ",
        Slip::Transposed => "F with its indices swapped",
    };
    let [absorbed, escaped] = shares(slip).map(|share| 100.0 * share);
    format!(
        "{what}: of each watt sent, {absorbed:.1} % are absorbed and {escaped:.1} % \
         escape, together {:.1} %",
        absorbed + escaped
    )
}
