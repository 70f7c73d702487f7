//! The mistakes that the checks of the lab `break-it` can name.

use crate::check::bugs;

bugs! {
    /// The error is below what is wanted.
    TOO_MILD "too-mild"
        "That does not hurt enough. How does the error grow as the squares come \
         nearer: as 1/d, or as 1/d²?";
    /// The error is above twice that.
    TOO_NEAR "too-near"
        "That breaks it beyond what was asked: anybody sees such an error. How does it \
         fall with the distance: as 1/d, or as 1/d²?";
    /// 100 times.
    PER_CENT "per-cent"
        "Is the error in per cent? A share is asked for: 0.1, not 10.";
    /// ⅓/d².
    ONE_OF_TWO "one-of-two"
        "That is the error when one square is taken at its middle. Here both are: the \
         distance between two random points of them varies twice as much.";
    /// F/F* − 1 < 0.
    SIGN "sign"
        "Too large or too small? All other pairs of points are farther apart than the \
         middles are: the middles say too much.";
    /// 1 + error.
    RATIO "ratio"
        "That is the factor over the right one. By which share is it too large?";

    /// A cell of 1/n.
    HALF_A_CELL "half-a-cell"
        "How wide is a cell? The top of a hemicube of half-width 1 is 2 m wide, not 1 \
         m.";
    /// Side = cell × (1 − missed).
    A_LINE "a-line"
        "Is it a side that is compared with a side? A lamp has to meet the middle of a \
         cell in two directions at once: areas count.";
    /// Side = cell × √missed.
    SEEN_FOR_MISSED "seen-for-missed"
        "That is the size of a lamp that is *seen* so often. The larger it is, the \
         more often it is seen.";
    /// 1.
    RIGHT_WHERE_SEEN "right-where-seen"
        "Is it right where it is seen? It gets a whole cell there, and is smaller than \
         one.";
    /// 1 − missed.
    TOO_DARK "too-dark"
        "Is it too dark? That is the share of the cell that it fills, and what it gets \
         is the whole cell: the other way round.";
    /// 1/missed.
    OVER_MISSED "over-missed"
        "Over which share? In the mean over all places the light is right: what is \
         missing where the lamp is missed is too much where it is seen.";

    /// 1.
    WHITE "white"
        "1 is the limit when rows sum to 1. By middles they do not: sum one.";
    /// Over the largest row.
    LARGEST_ROW "largest-row"
        "That is over the largest row sum. No solver runs away below it; but does one \
         above it? Light does not stay at the element that sends most.";
    /// Over the mean row.
    MEAN_ROW "mean-row"
        "That is over the mean of the row sums. But light is not spread evenly: it \
         gathers where it is kept best. What is it like after a hundred bounces?";
    /// Over the smallest row.
    SMALLEST_ROW "smallest-row"
        "That is over the smallest row sum: above it every element gains with each \
         bounce. The solver runs away long before.";
    /// λ.
    UPSIDE_DOWN "upside-down"
        "That is how much a bounce adds when all is white. With which reflectance does \
         it add nothing?";

    /// ρ = 1 − 1/k.
    RULE_OF_THUMB "rule-of-thumb"
        "1 − 1/k? That many bounces leave a third, e⁻¹, whatever is asked for. Where \
         is the logarithm of the missing share?";
    /// Common for natural logarithm.
    COMMON_LOGARITHM "common-logarithm"
        "Is it a logarithm to base 10 where the exponential is to base e? They differ \
         by 2.3.";
    /// Till the update is small.
    UPDATE_STOPS "update-stops"
        "So many bounces until the *last bounce* adds no more than that share. What is \
         missing then is 1/(1 − ρ) times as much.";
    /// 1.
    UPDATE_IS_ERROR "update-is-error"
        "Is what is missing as much as the last bounce has added? The next adds ρ \
         times that, the one after ρ² times, and so on. Sum them all.";
    /// (1 − ρ)/ρ.
    TURNED_ROUND "turned-round"
        "The other way round: missing light over that of the last bounce.";

    /// Rows do not sum to 1.
    NOT_CLOSED "not-closed"
        "A row does not sum to 1: what one element gets more of, others must get less \
         of.";
    /// A_i F_ij ≠ A_j F_ji.
    ONE_WAY "one-way"
        "Not reciprocal. When floor to ceiling is changed, so is ceiling to floor: \
         A_i F_ij = A_j F_ji.";
    /// Below 0.
    NEGATIVE "negative"
        "A factor is negative. Take from larger ones.";
    /// F as it is.
    HONEST "honest"
        "The factor from floor to ceiling is right. It was to be wrong.";
    /// Twice, or too small.
    OTHER_SIZE "other-size"
        "It is wrong, but not by the share that was asked for. Is it changed twice, or \
         the wrong way?";
}
