//! The mistakes that the checks of the lab `radiometry` can name.

use crate::check::bugs;

bugs! {
    /// Φ A.
    TIMES_AREA "times-area"
        "Was the flux multiplied by the area? Radiosity is flux *for each* m².";
    /// L = B.
    NO_PI "no-pi"
        "Radiosity and radiance differ by π: B = π L. Is the π missing?";
    /// L = π B.
    PI_UPSIDE_DOWN "pi-upside-down"
        "The π stands on the wrong side: B = π L, so that the radiance is the smaller \
         number.";
    /// L = B/2π.
    TWO_PI "two-pi"
        "Was it divided by 2π, the solid angle of the hemisphere? The light leaves \
         weighted by its cosine: ∫ cosθ dω is π.";
    /// B = ρH/π.
    PI_TOO_EARLY "pi-too-early"
        "Radiosity has no π: B = ρ H. The π comes with the radiance.";
    /// A cosine is missing at the receiver.
    NO_COSINE "no-cosine"
        "Is the receiver's cosine missing? Light that comes in aslant spreads over more \
         area.";
    /// A cosine is missing at the source.
    NO_SOURCE_COSINE "no-source-cosine"
        "Is the source's cosine missing? Seen aslant the source looks smaller.";
    /// No cosine at all.
    NO_COSINES "no-cosines"
        "There are two cosines, the source's and the receiver's. Are both missing?";
    /// The distance is not squared.
    DISTANCE "distance"
        "The power of r is wrong. Is r squared, and are the cosines taken between \
         vectors of unit length?";
    /// 2π or π where 4π belongs.
    NOT_ALL_ROUND "not-all-round"
        "The bulb shines all round: its flux spreads over the sphere, 4π r².";
    /// The back receives, or sends.
    FROM_BEHIND "from-behind"
        "Nothing arrives at a back, nor leaves one. Two negative cosines make a \
         positive product: cut each off at 0 by itself.";
    /// cosθ is missing in the integral.
    INTEGRAL_NO_COSINE "integral-no-cosine"
        "Is cosθ missing in the integral? ∫ L dω alone is no irradiance.";
    /// sinθ is missing in the integral.
    NO_SINE "no-sine"
        "Is sinθ missing? A ring near the zenith is short: dω = sinθ dθ dφ.";
    /// π or 2π around the axis.
    HALF_TURN "half-turn"
        "Do the pieces of a ring go only half round? φ runs from 0 to 2π.";
    /// θ to π.
    BELOW "below"
        "Rings below the horizon are counted. θ runs from 0 to π/2.";
    /// θ to π/4 or so.
    NOT_TO_HORIZON "not-to-horizon"
        "Do the rings end before the horizon? θ runs from 0 to π/2.";
    /// A step in degrees.
    DEGREES "degrees"
        "Is something in degrees? `sin` and `cos` want radians, and so do dθ and dφ.";
    /// A step is missing.
    NO_STEP "no-step"
        "The number depends on the number of rings: is dθ or dφ missing?";
    /// A mean in place of an integral.
    MEAN "mean"
        "That is a mean over the cells. An integral is the mean times the size of what \
         is integrated over, π/2 times 2π.";
    /// The direction is not of unit length.
    NOT_A_DIRECTION "not-a-direction"
        "The direction has not unit length. It is (sinθ cosφ, sinθ sinφ, cosθ).";
    /// π too many, or too few.
    PI_AGAIN "pi-again"
        "Is there a π too many or too few? From radiance to irradiance none is put in \
         by hand: it comes out of the integral by itself.";
    /// 1 − ρ.
    ABSORBED "absorbed"
        "That is what is absorbed, 1 − ρ. Reflected is the share ρ.";
    /// ρ is missing.
    NO_REFLECTANCE "no-reflectance"
        "Is the reflectance missing? Some of the light stays.";
}
