//! The mistakes that the checks of the lab `solid-angle` can name.

use crate::check::bugs;

bugs! {
    /// A/r².
    NO_COSINE "no-cosine"
        "Is the cosine missing? A surface seen aslant looks smaller.";
    /// A cosθ/r.
    ONE_DISTANCE "one-distance"
        "One distance r is missing. Is r squared, and is the cosine taken between \
         vectors of unit length?";
    /// A cosθ/(π r²).
    OVER_PI "over-pi"
        "Was it divided by π? That makes a form factor. A solid angle has no π.";
    /// The back counts.
    FROM_BEHIND "from-behind"
        "From behind a surface the answer is 0. Is a negative cosine cut off?";
    /// The front is taken for the back.
    WRONG_SIDE "wrong-side"
        "Fronts give 0 and backs count: the normal of a front points against the \
         direction from the eye to the surface.";
    /// Ω/2.
    HALVED "halved"
        "Half of the right angle: the formula gives tan(Ω/2). Is the factor 2 missing?";
    /// atan in place of atan2.
    ATAN "atan"
        "Right for small triangles, wrong by 2π for large ones: the denominator may be \
         negative. Is it `atan` where `atan2` belongs?";
    /// −Ω.
    REVERSED "reversed"
        "The sign is the wrong way round: positive is counter-clockwise as seen from \
         the point.";
    /// |Ω|.
    UNSIGNED "unsigned"
        "Was the sign dropped? A triangle seen from behind counts negative. Sums need \
         it.";
    /// 1 where the lengths belong.
    NOT_UNIT "not-unit"
        "That is the formula for corners at distance 1. Multiply by the lengths, or \
         make the vectors unit vectors first.";
    /// A dot product goes with the wrong length, or the product of all three is missing.
    LENGTHS "lengths"
        "Look at the denominator: the product of all three lengths, and each dot \
         product times the length of the corner that is not in it.";
    /// A cosθ/r² at the triangle's centre.
    FLAT "flat"
        "That is A cosθ/r² at the centre, which is good for small triangles only.";
    /// The sum of the angles.
    NO_EXCESS "no-excess"
        "Off by π: the solid angle is what the three angles have *more* than a flat \
         triangle, A + B + C − π.";
    /// The cosine of Ω/2.
    FLAT_COSINE "flat-cosine"
        "Large triangles are right, but small ones have lost their digits. Is Ω found \
         from its cosine? Near 1 the cosine is flat, and `acos` finds noise.";
    /// Digits are lost in a difference.
    CANCELS "cancels"
        "Good down to 1e-8 sr, no further. Somewhere large numbers nearly cancel: \
         A + B + C − π, an `acos` of a side, or a·(b×c) of three nearly equal vectors. \
         Of edges that product keeps its digits: a·((b−a)×(c−a)) is the same number.";
    /// Seen from the origin.
    NOT_MOVED "not-moved"
        "Is the polygon seen from the origin? Subtract `point` from each corner.";
    /// A triangle of the fan is missing.
    FAN_SHORT "fan-short"
        "A polygon of n corners has n − 2 triangles. Is the last one missing?";
    /// Triangles of three consecutive corners.
    STRIP "strip"
        "All triangles of a fan share one corner. Were three consecutive corners taken \
         each time?";
    /// Faces seen from behind are skipped.
    FRONTS_ONLY "fronts-only"
        "Are faces seen from behind skipped? They must be taken away again.";
    /// Ω/4π.
    SHARE "share"
        "That is the share of all directions. In steradians, all directions are 4π.";
}
