//! The mistakes that the checks of the lab `sampling` can name.

use crate::check::bugs;

bugs! {
    /// Σ in place of the mean.
    SUM "sum"
        "That is the sum. A mean is divided by the number of values.";
    /// s in place of s/√n.
    SPREAD "spread"
        "That is how far the values scatter. Their mean scatters less: divide by √n.";
    /// s²/n.
    VARIANCE "variance"
        "That is the variance of the mean. Is the square root missing?";
    /// s/n.
    OVER_N "over-n"
        "Was it divided by n? Errors add in squares: the error of a mean falls as 1/√n.";
    /// 1/√n.
    NO_SPREAD "no-spread"
        "Does the error depend on n alone? Values that scatter more have a larger one.";
    /// √ of a negative number.
    ROOT_OF_NEGATIVE "root-of-negative"
        "Not a number for equal values: the mean of squares less the square of the mean \
         may come out below 0. Sum (value − mean)² instead.";
    /// Directions uniform over the hemisphere.
    UNIFORM "uniform"
        "Directions are spread evenly over the hemisphere. Rays that count alike must be \
         as dense as the cosine.";
    /// θ uniform.
    EVEN_ANGLES "even-angles"
        "Is θ = u π/2? Then directions crowd about the normal: the rings there are \
         short.";
    /// The radius on the disc is u.
    NO_ROOT "no-root"
        "Points crowd in the middle of the disc: its radius is √u, since rings farther \
         out hold more.";
    /// φ to π.
    HALF_TURN "half-turn"
        "Do directions go only half round? φ runs from 0 to 2π.";
    /// One number for both.
    SAME_NUMBER "same-number"
        "One random number was taken for two things that must not depend on each \
         other.";
    /// Below the horizon.
    BELOW "below"
        "A direction points below the surface.";
    /// Not of unit length.
    NOT_A_DIRECTION "not-a-direction"
        "The direction has not unit length.";
    /// Directions in the world's frame.
    NOT_TURNED "not-turned"
        "Directions are about z. Turn them to the surface's normal, with a `Frame`.";
    /// Rays from the centre.
    FROM_CENTRE "from-centre"
        "Do all rays start at the centre? They start anywhere on the surface.";
    /// A weight by the cosine beside directions by the cosine.
    COSINE_TWICE "cosine-twice"
        "Is the cosine there twice? Directions that are as dense as the cosine hold it \
         already: each ray counts 1.";
    /// Anything hit counts.
    ANYTHING "anything"
        "Rays count that meet a blocker. Only the front of the target counts.";
    /// Blockers are ignored.
    NO_VISIBILITY "no-visibility"
        "Blockers do not block. Does a point see the other, does a ray meet the target \
         *first*?";
    /// Both cosines, or one.
    ONE_COSINE "one-cosine"
        "There are two cosines, one at each point. Is one of them missing?";
    /// No cosines.
    NO_COSINES "no-cosines"
        "Are both cosines missing?";
    /// π is missing.
    NO_PI "no-pi"
        "π times too large: is the division by π missing?";
    /// The area is missing.
    NO_AREA "no-area"
        "Is the area missing? The mean over y stands for an integral over the area of \
         `to`.";
    /// The area of the wrong surface.
    WRONG_AREA "wrong-area"
        "That is the factor the other way round: the mean is multiplied by the area of \
         `to`, not of `from`.";
    /// The power of r.
    DISTANCE "distance"
        "The power of r is wrong. Is r squared, and are the cosines taken between \
         vectors of unit length?";
    /// Backs count.
    BACKS "backs"
        "Points behind a surface count, perhaps as negative light. A sample with a \
         negative cosine is 0.";
    /// V̄ F̄.
    MEAN_VISIBILITY "mean-visibility"
        "That is the mean visibility times the mean of the rest. The two go together: \
         pairs that see each other are not like all pairs. Take the mean of the \
         product.";
    /// The mean over what is visible.
    VISIBLE_ONLY "visible-only"
        "Were hidden pairs left out of the mean? They count, as 0.";
    /// The same two numbers for both points.
    SAME_POINTS "same-points"
        "Both points, or the point and the direction, come from the same two numbers. \
         Draw four for each sample.";
}
