//! The mistakes that the checks of the lab `lambert` can name.

use crate::check::bugs;

bugs! {
    /// a × b.
    REVERSED "reversed"
        "The sign is the wrong way round: Γ points along b × a, not a × b. So fronts \
         count positive.";
    /// The cross product as it is.
    NOT_A_UNIT "not-a-unit"
        "Γ has length 1. Was the cross product not divided by its length?";
    /// Divided by |a||b|.
    SINE_LEFT "sine-left"
        "Was the cross product divided by |a||b|? Then a sine is left in it. Γ has \
         length 1: divide by |b × a|.";
    /// n·Γ alone.
    NO_ANGLE "no-angle"
        "Is the angle γ missing?";
    /// γ alone.
    NO_NORMAL "no-normal"
        "Is n·Γ missing? Every edge counts by how it stands to the normal.";
    /// |γ n·Γ|.
    UNSIGNED "unsigned"
        "Was the sign dropped? Edges count positive or negative.";
    /// γ in degrees.
    DEGREES "degrees"
        "Is the angle in degrees?";
    /// γ by asin.
    ARCSINE "arcsine"
        "Right up to 90°, wrong beyond: the sine of γ is that of 180° − γ. Take `atan2` \
         of sine and cosine.";
    /// γ by acos.
    FLAT_COSINE "flat-cosine"
        "Long edges are right, short ones have lost their digits. Is γ the `acos` of a \
         cosine near 1? There the cosine is flat. Take `atan2` of sine and cosine.";
    /// 0/0.
    ZERO_BY_ZERO "zero-by-zero"
        "Two corners in one direction: 0 divided by 0. Such an edge adds 0.";
    /// Σ/π.
    NO_HALF "no-half"
        "Twice too large: the sum is divided by 2π. Is the ½ missing?";
    /// Σ/2.
    NO_PI "no-pi"
        "That is the projected solid angle, in sr. The form factor is a share of π.";
    /// F/π.
    PI_TWICE "pi-twice"
        "Was it divided by π twice?";
    /// The last edge is missing.
    OPEN "open"
        "An outline is closed: is the edge from the last corner to the first missing?";
    /// The back counts.
    FROM_BEHIND "from-behind"
        "To a back the form factor is 0: the sum is negative there.";
    /// The lower part is kept.
    KEPT_BELOW "kept-below"
        "Was the part below the horizon kept, and the part above dropped?";
    /// No new corners.
    DROPPED "dropped"
        "Corners below were dropped, but the outline needs new ones where its edges cross \
         the horizon: two, for a convex one.";
    /// Corners below are lifted to the horizon.
    LIFTED "lifted"
        "Were corners below lifted straight up to the horizon? The outline is cut where \
         its edges cross it.";
    /// The crossing at a wrong place.
    WRONG_PLACE "wrong-place"
        "The new corners are not where the edges cross the horizon: there n·x = 0. With \
         heights h_a and h_b it is at h_a/(h_a − h_b) of the way.";
    /// The edge from the last corner to the first is not cut.
    GAP "gap"
        "The edge from the last corner to the first can cross the horizon too.";
    /// Nothing is cut.
    NOT_CLIPPED "not-clipped"
        "Nothing is cut off: what lies below the horizon of the point must not count.";
    /// All, or nothing.
    ALL_OR_NOTHING "all-or-nothing"
        "The polygon is taken whole or not at all. A part of it lies above the horizon.";
    /// Seen from the origin.
    NOT_MOVED "not-moved"
        "Is the polygon seen from the origin? Subtract `p` from each corner.";
    /// The horizon goes through the origin.
    HORIZON_AT_ORIGIN "horizon-at-origin"
        "The horizon goes through `p`, not through the origin: subtract `p` before you \
         clip.";
}
