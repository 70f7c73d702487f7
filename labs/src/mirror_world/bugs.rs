//! The mistakes that the checks of the lab `mirror-world` can name.

use crate::check::bugs;

bugs! {
    /// x − h n.
    ON_THE_MIRROR "on-the-mirror"
        "That is the foot of the point on the mirror. The image is as far *behind* it: \
         twice the height.";
    /// x + 2 h n.
    AWAY "away"
        "The point moved away from the mirror. Heights in front are positive and the \
         normal points to the front: subtract.";
    /// x − 2 (n·x) n.
    THROUGH_ORIGIN "through-origin"
        "That is right for mirrors through the origin. The height over this one is \
         n·x − offset; `Plane::height` knows it.";
    /// −x, or the point mirrored in a point.
    IN_A_POINT "in-a-point"
        "Was the point mirrored in a point? A mirror changes only what is along its \
         normal.";
    /// The order of the corners is kept.
    TURNED "turned"
        "The image shows its back: a mirror makes clockwise of counter-clockwise. \
         Reverse the order of the corners.";
    /// What is behind the mirror is mirrored too.
    BEHIND "behind"
        "What lies behind the mirror was mirrored to its front. Clip the outline to \
         the front of the mirror first.";
    /// What is in front is dropped.
    WRONG_HALF "wrong-half"
        "The part in front of the mirror was dropped and the part behind kept.";
    /// Nothing is cut.
    NOT_CLIPPED "not-clipped"
        "The whole outline is kept. A mirror shows no more than a window of its size: \
         clip to the planes through the eye and its edges.";
    /// The planes look outwards.
    OUTSIDE "outside"
        "What lies outside the window was kept. Seen from the eye the corners run \
         counter-clockwise: which side of the plane through the eye and an edge is \
         inside?";
    /// The closing edge is not cut.
    GAP "gap"
        "One edge of the window does not cut: is it the one from the last corner to \
         the first?";
    /// What stands before the window is kept.
    BEFORE "before"
        "What stands on the eye's side of the window is not seen *through* it: clip to \
         the far side of its plane as well.";
    /// The back of a window or mirror works too.
    FROM_BEHIND "from-behind"
        "A mirror has one side. From behind it nothing is seen: is the eye in front?";
    /// 0.
    DARK "dark"
        "By the mirror comes no light at all. Does the image show its back (task 2)? \
         Or does clipping leave nothing of it (task 3)?";
    /// The lamp is seen directly.
    DIRECT "direct"
        "That is the factor to the lamp itself, not to its image.";
    /// Both ways are added.
    BOTH_WAYS "both-ways"
        "The straight way was added. Asked is what comes by the mirror alone.";
    /// No card is looked at.
    NO_CARDS "no-cards"
        "Are the cards looked at? One that stands in the way lets nothing through.";
    /// Only the leg at the eye is looked at.
    EYE_LEG "eye-leg"
        "Cards between the mirror and the lamp are not found. A path by a mirror has \
         two legs: from `p` to the mirror, and from there to `x`.";
    /// Only the leg at the lamp is looked at.
    LAMP_LEG "lamp-leg"
        "Cards between `p` and the mirror are not found. A path by a mirror has two \
         legs: from `p` to the mirror, and from there to `x`.";
    /// The line from p to the image is tested.
    TO_THE_IMAGE "to-the-image"
        "Is the line from `p` to the *image* tested against the cards? Beyond the \
         mirror it runs through the virtual world: cards behind the mirror do not \
         matter, and the images of the cards in front of it do.";
    /// The line from p to x is tested.
    STRAIGHT "straight"
        "Is the straight line from `p` to `x` tested? Light goes by way of the mirror.";
    /// The mirror has no end.
    NO_END "no-end"
        "Light was reflected where there is no mirror. Does the line to the image go \
         through its outline?";
    /// Images on one side only.
    ONE_SIDE "one-side"
        "Are the images on one side missing? Each level has two: one seen first in the \
         right mirror, one in the left.";
    /// ρ for ρᵏ.
    ONCE_DIMMED "once-dimmed"
        "Every image is dimmed the same. Image k has been reflected k times and keeps \
         ρᵏ.";
    /// ρ is left out.
    NOT_DIMMED "not-dimmed"
        "Is the reflectance missing? Each reflection keeps the share ρ.";
    /// L + 1 or L − 1 levels.
    OFF_BY_ONE "off-by-one"
        "The numbers are those of another level. Level 0 is the lamp alone, level 1 \
         adds the two images next to it.";
    /// The lamp is counted twice.
    LAMP_TWICE "lamp-twice"
        "Was the lamp itself counted twice? It has one place, its images of each level \
         have two.";
    /// Images of images double.
    DOUBLED "doubled"
        "There are 2ᵏ ways to order k reflections, but a mirror does not reflect in \
         itself twice in a row: from one image to the next the mirrors take turns, and \
         of each level there are two.";
}
