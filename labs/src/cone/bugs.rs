//! The mistakes that the checks of the lab `cone` can name.

use crate::check::bugs;

bugs! {
    /// 2a for a, or a/2.
    WHOLE_ANGLE "whole-angle"
        "Off by the two between the half angle and the whole one: `half_angle` is from \
         the axis to the rim.";
    /// π sin²a.
    PROJECTED "projected"
        "That is the projected solid angle. A solid angle has no cosine in it.";
    /// π a².
    FLAT "flat"
        "π a² is the area of a flat disc: good for narrow cones, too large for wide.";
    /// 1 − cos a.
    CANCELS "cancels"
        "Wide cones are right, narrow ones have lost their digits: of 1 − cos a \
         nothing is left when a is small. It is the same as 2 sin²(a/2).";
    /// Ω cosθ.
    SOLID "solid"
        "That is Ω cosθ: the cosine at the axis, for all of the cone. Towards its rim \
         the cosine is another; the mean is smaller.";
    /// The cosine of the tilt is missing.
    NO_TILT "no-tilt"
        "Is the cosine of the tilt missing? Light that comes aslant is spread.";
    /// sin a.
    NOT_SQUARED "not-squared"
        "Areas go with the square: sin²a.";
    /// Without π.
    NO_PI "no-pi"
        "That is the share of the hemisphere's π. Asked is the angle, in sr.";
    /// Divided by the lamp.
    OF_THE_LAMP "of-the-lamp"
        "That is the share of the *lamp* that is in the cone. The mean over the cone \
         needs the share of the cone.";
    /// In sr.
    STERADIANS "steradians"
        "That is the overlap in sr. Divide by the solid angle of the cone.";
    /// All or nothing.
    ALL_OR_NOTHING "all-or-nothing"
        "The lamp counts all or not at all. A rim that runs through the cone leaves a \
         part: this is what a single ray sees.";
    /// Flat discs.
    FLAT_DISCS "flat-discs"
        "That is the overlap of two flat discs: good for small angles only. Caps of a \
         sphere have other segments.";
    /// The acos of what is no cosine.
    NO_TRIANGLE "no-triangle"
        "NaN: where the rims do not cross there is no triangle, and `acos` of a number \
         beyond ±1. Look first whether they lie apart, or one in the other.";
    /// θ = u a.
    EVEN_ANGLES "even-angles"
        "The rays crowd at the axis: equal steps of θ are not equal steradians. A zone \
         of the sphere is as large as it is *high*: cosθ is what is even.";
    /// θ = a √u.
    EVEN_DISC "even-disc"
        "θ = a√u is even on a flat disc: good for narrow cones only. On the sphere \
         cosθ is even.";
    /// sin²θ even.
    BY_COSINE "by-cosine"
        "These rays are even in the projected solid angle, with the density of the \
         cosine. Asked are even steradians.";
    /// φ up to π.
    HALF_TURN "half-turn"
        "Only half of the cone gets rays: φ goes all the way round, to 2π.";
    /// About z.
    ABOUT_Z "about-z"
        "The rays are about the z axis, not the cone's: turn them, with a `Frame`.";
    /// A vector that is not of unit length.
    NOT_UNIT "not-unit"
        "A direction has length 1.";
    /// Σ.
    SUM "sum"
        "That is the sum over the rays. A mean divides by their number.";
    /// ∫ L dω.
    INTEGRAL "integral"
        "Times Ω: that is the integral over the cone. Its mean was asked for.";
    /// One ray along the axis.
    ONE_RAY "one-ray"
        "That is the light along the axis: a mirror, not gloss.";
    /// Rays anywhere.
    NOT_STRATIFIED "not-stratified"
        "The mean is right, but as noisy as by rays that fall anywhere. One random ray \
         in *each* cell: ((i + u)/n, (j + v)/n).";
    /// The same rays each time.
    SAME_RAYS "same-rays"
        "Two runs give the very same. Rays at fixed places make bands in a picture: \
         move each at random within its cell.";
    /// Without L_own.
    OWN_LIGHT "own-light"
        "Is the surface's own light missing? A glossy floor is lit too.";
    /// Without k.
    NO_SHARE "no-share"
        "Gloss reflects the share `gloss` of the mean. As it is, none ever fades.";
    /// One level more or less.
    WRONG_DEPTH "wrong-depth"
        "Right but for one reflection: with depth 0 a surface shows its own light \
         alone, and each reflection goes one down.";
    /// No recursion.
    ONE_LEVEL "one-level"
        "What is met in the cone shows its own light only. It may be glossy as well: \
         look there with the same function.";
    /// The cone about d.
    STRAIGHT_ON "straight-on"
        "The cone goes straight on, into the surface. Its axis is the mirrored ray.";
    /// The cone about the normal.
    ABOUT_NORMAL "about-normal"
        "The cone stands on the normal. Its axis is the mirrored direction.";
    /// The cone about −d.
    BACK "back"
        "The cone looks back to the eye. Mirrored is d − 2 (d·n) n.";
}
