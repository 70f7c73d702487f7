//! The mistakes that the checks of the lab `sky` can name.

use crate::check::bugs;

bugs! {
    /// ΔφΔθ.
    NO_SINE "no-sine"
        "Is sinθ forgotten? All rows of the picture are as wide, but the parallels of \
         the sphere shorten towards the poles. Without the sine the zenith counts too \
         much.";
    /// sinθ at the upper edge of the row.
    UPPER_EDGE "upper-edge"
        "The sine is taken at the upper edge of the row: the first row would be worth \
         nothing. Take the middle, or the difference of the cosines.";
    /// θ from 0 to π/2.
    HALF_SPHERE "half-sphere"
        "The rows end at the horizon. The last row should be at the nadir: θ = π.";
    /// φ from 0 to π.
    HALF_TURN "half-width"
        "The columns go only half around: φ has 2π in it, θ has π.";
    /// The picture begins at its middle.
    TURNED "turned"
        "Turned by half a turn: the *middle* column looks along −z, and the seam \
         between the last column and the first is behind. Is the −½ missing?";
    /// Columns run to the left.
    MIRRORED "mirrored"
        "Left and right are exchanged. Columns run to the right, as seen from inside.";
    /// Row 0 is down.
    FLIPPED "flipped"
        "Upside down: row 0 is the zenith. Many picture libraries, and all of OpenGL, \
         have it the other way round.";
    /// The corner of the texel.
    CORNER "corner"
        "That is the corner of the texel. Its middle is half a texel further on, both \
         ways.";
    /// Up is z.
    Z_UP "z-up"
        "Up is y here, not z.";
    /// cos²θ.
    COSINE_TWICE "cosine-twice"
        "The cosine is in it twice. Irradiance has it once; the solid angle of a \
         texel has none.";
    /// ∫ L dω above the plane.
    NO_COSINE "no-cosine"
        "Is the cosine missing? Light that comes in aslant is spread over more of the \
         plane.";
    /// Light from behind is taken away.
    FROM_BEHIND "from-behind"
        "Texels behind the plane count negative. A plane gets no light from behind, \
         and loses none.";
    /// H/π.
    OVER_PI "over-pi"
        "Divided by π? A texel's value is a radiance already; π is for what a diffuse \
         surface makes of its irradiance.";
    /// The density over texels.
    PER_TEXEL "per-texel"
        "That is the probability of the texel. A density is per steradian: divide by \
         the texel's solid angle.";
    /// 1/4π.
    EVEN "even"
        "1/4π is the density of directions drawn evenly. Yours are drawn by \
         brightness.";
    /// Directions are drawn evenly.
    NOT_BRIGHT "not-bright"
        "Directions go everywhere alike. The more light comes from a texel, the more \
         often it should be drawn.";
}
