//! A named repair: makes the rows of a closed scene's matrix sum to one.
//!
//! ```text
//! A_i F'_ij = d_i A_i F_ij d_j,   Σ_j F'_ij = 1       one factor d per face, near 1
//! ```
//! Reciprocity is kept (or made: of `A_i F_ij` and `A_j F_ji` the mean is taken first), no
//! factor changes its sign, and zeros stay zeros. **It hides errors, it does not mend
//! them**: a matrix that a wrong method made has perfect sums afterwards and is as wrong as
//! before. So nothing in this crate calls it unasked, and what it changed is reported.
//!
//! Sources: Sinkhorn & Knopp 1967 (scaling a matrix); van Leersum 1989 (view factors).

/// What [`close`] did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// `max |1 − Σ F|` before.
    pub before: f64,
    /// `max |1 − Σ F|` after.
    pub after: f64,
    /// The largest absolute change of a factor.
    pub change: f64,
}

const MOST_ROUNDS: usize = 1000;

/// Scales the factors of a closed scene so that each row sums to one.
///
/// `rows[i]` holds `(j, F_ij)` in order of `j`. Rows of zeros stay: a face that sees
/// nothing, or has no area.
pub fn close(rows: &mut [Vec<(u32, f64)>], areas: &[f64]) -> Closing {
    let before = closure(rows);
    let exchanges = symmetric(rows, areas);
    let mut scale = vec![1.0_f64; rows.len()];
    let mut last = f64::INFINITY;
    for _ in 0..MOST_ROUNDS {
        let mut worst = 0.0_f64;
        for (i, row) in exchanges.iter().enumerate() {
            let sum: f64 = row.iter().map(|&(j, g)| g * scale[j as usize]).sum();
            if sum > 0.0 {
                // Half way (in logarithms): the full step, for both ends of a pair, would
                // swing to and fro.
                let full = areas[i] / sum;
                worst = worst.max((full / scale[i] - 1.0).abs());
                scale[i] = (scale[i] * full).sqrt();
            }
        }
        // The sums of long rows have a rounding of their own: nothing gets better there.
        if worst < 1e-14 || (worst < 1e-12 && worst >= last) {
            break;
        }
        last = worst;
    }
    let mut change = 0.0_f64;
    for (i, (row, exchanges)) in rows.iter_mut().zip(&exchanges).enumerate() {
        let old = std::mem::take(row);
        let closed =
            |&(j, g): &(u32, f64)| (j, g * scale[i] * scale[j as usize] / areas[i]);
        *row = exchanges.iter().map(closed).collect();
        for &(j, f) in row.iter() {
            let was = old.binary_search_by_key(&j, |e| e.0).map_or(0.0, |k| old[k].1);
            change = change.max((f - was).abs());
        }
    }
    Closing { before, after: closure(rows), change }
}

/// `max |1 − Σ F|` over the rows that are not empty.
pub fn closure(rows: &[Vec<(u32, f64)>]) -> f64 {
    let sums = rows.iter().filter(|row| !row.is_empty());
    let sums = sums.map(|row| row.iter().map(|f| f.1).sum::<f64>());
    sums.map(|sum| (1.0 - sum).abs()).fold(0.0, f64::max)
}

/// `½ (A_i F_ij + A_j F_ji)`, row by row.
fn symmetric(rows: &[Vec<(u32, f64)>], areas: &[f64]) -> Vec<Vec<(u32, f64)>> {
    let mut found: Vec<Vec<(u32, f64)>> = vec![Vec::new(); rows.len()];
    for (i, row) in (0u32..).zip(rows) {
        for &(j, f) in row {
            let half = 0.5 * areas[i as usize] * f;
            found[i as usize].push((j, half));
            found[j as usize].push((i, half));
        }
    }
    for row in &mut found {
        row.sort_by_key(|e| e.0);
        row.dedup_by(|b, a| {
            let same = a.0 == b.0;
            a.1 += if same { b.1 } else { 0.0 };
            same
        });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube whose factors are rounded to three digits, one of them badly.
    #[test]
    fn rows_sum_to_one_and_reciprocity_is_kept() {
        let opposite = |i: usize| i ^ 1;
        let mut rows: Vec<Vec<(u32, f64)>> = (0..6)
            .map(|i| {
                let seen = (0..6).filter(|&j| j != i);
                let factor = |j| if j == opposite(i) { 0.199 } else { 0.201 };
                seen.map(|j| (j as u32, factor(j))).collect()
            })
            .collect();
        rows[0][1].1 = 0.21;
        let areas = [1.0; 6];
        let closing = close(&mut rows, &areas);
        assert!((closing.before - 0.012).abs() < 1e-12, "{closing:?}");
        assert!(closing.after < 1e-12 && closing.change < 0.01, "{closing:?}");
        for i in 0..6u32 {
            for &(j, f) in &rows[i as usize] {
                let back = rows[j as usize].iter().find(|e| e.0 == i).unwrap().1;
                assert!((f - back).abs() < 1e-14);
            }
        }
    }

    /// The repair makes a wrong matrix's sums right, and leaves it wrong: that is why it
    /// must be asked for by name.
    #[test]
    fn it_hides_what_it_does_not_mend() {
        // Point-to-point factors in a cube: 1/π opposite, 2/π beside (Σ = 2.86).
        let pi = std::f64::consts::PI;
        let factor = |i: usize, j: usize| if j == i ^ 1 { 1.0 / pi } else { 2.0 / pi };
        let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); 6];
        for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
            if i != j {
                rows[i].push((j as u32, factor(i, j)));
            }
        }
        assert!(close(&mut rows, &[1.0; 6]).after < 1e-12);
        let opposite = rows[0].iter().find(|e| e.0 == 1).unwrap().1;
        assert!((opposite - 1.0 / 9.0).abs() < 1e-12); // the exact one is 0.19982
    }
}
