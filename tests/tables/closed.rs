//! Closed forms that only the tables need: crossed strings, discs.

use glam::DVec2;

/// Form factor from segment `a` to segment `b` of the plane: the sections of two strips
/// that are long without end (Hottel 1954). Dimensionless, in `[0, 1]`.
///
/// ```text
/// F = (Σ crossed − Σ uncrossed)/(2 L)     strings between the ends, L the length of a
/// ```
/// The segments may touch at their ends; neither may cut the other's line.
///
/// # Accuracy
/// Exact: 1e-12 relative, from a thousandth of the width to a thousand widths.
pub(super) fn crossed_strings(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    // |p| − |q| = (p − q)·(p + q)/(|p| + |q|), which does not cancel
    let longer = |from: DVec2| {
        let (p, q) = (b[0] - from, b[1] - from);
        (p - q).dot(p + q) / (p.length() + q.length())
    };
    (longer(a[0]) - longer(a[1])).abs() / (2.0 * a[0].distance(a[1]))
}

/// The same of what passes a gap: strings from `a` to `b` keep `left` on their left and
/// `right` on their right, and are pulled taut around them. `None`: no end on that side.
///
/// A screen with several gaps lets through the sum over them; a fin that stands on a
/// segment divides it in two, and each part looks past the fin's tip. All strings must
/// cross the line of the gap.
///
/// # Accuracy
/// Exact: rounding of the strings, 1e-15 of the longest, over twice the length of `a`.
pub(super) fn crossed_strings_past(
    a: [DVec2; 2],
    b: [DVec2; 2],
    left: Option<DVec2>,
    right: Option<DVec2>,
) -> f64 {
    let string = |from: DVec2, to: DVec2| {
        let side = |corner: DVec2| (to - from).perp_dot(corner - from);
        let bend = left.filter(|&l| side(l) < 0.0);
        let bend = bend.or(right.filter(|&r| side(r) > 0.0));
        match bend {
            Some(corner) => from.distance(corner) + corner.distance(to),
            None => from.distance(to),
        }
    };
    let same = string(a[0], b[0]) + string(a[1], b[1]);
    let other = string(a[0], b[1]) + string(a[1], b[0]);
    (same - other).abs() / (2.0 * a[0].distance(a[1]))
}

/// From a disc of radius `r1` to one of radius `r2` on the same axis at distance `h`, face
/// to face; positive lengths in one unit. In `(0, 1)`.
///
/// ```text
/// F = ½ (S − √(S² − 4q²)) = 2q²/(S + √((S − 2q)(S + 2q)))
/// q = r2/r1      S ± 2q = (1 ± q)² + h²/r1²
/// ```
///
/// # Accuracy
/// Rounding, at all distances.
pub(super) fn parallel_discs(r1: f64, r2: f64, h: f64) -> f64 {
    let (q, apart) = (r2 / r1, (h / r1).powi(2));
    let (less, more) = ((1.0 - q).powi(2) + apart, (1.0 + q).powi(2) + apart);
    2.0 * q * q / (0.5 * (less + more) + (less * more).sqrt())
}

/// From a differential area under the middle of a disc of this `radius` at `distance` that
/// it faces; positive lengths in one unit. In `(0, 1)`: `F = R²/(R² + d²)`.
///
/// # Accuracy
/// Rounding.
pub(super) fn point_to_disc_on_axis(radius: f64, distance: f64) -> f64 {
    let square = radius * radius;
    square / (square + distance * distance)
}
