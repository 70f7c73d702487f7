//! The mistakes that the checks of the lab `brdf` can name.

use crate::check::bugs;

bugs! {
    /// f = ρ.
    NO_PI "no-pi"
        "Is the 1/π missing? A BRDF of ρ sends back ∫ ρ cosθ dω = πρ of the light: more \
         than came from ρ = 0.32 on.";
    /// f = ρ/2π or πρ.
    OTHER_PI "other-pi"
        "The π stands there in another way. It is ∫ cosθ dω over the hemisphere, which is \
         π and not 2π, and the BRDF is divided by it.";
    /// f cosθ.
    COSINE_INSIDE "cosine-inside"
        "Is a cosine in the BRDF? It belongs to the irradiance: in ∫ f L cosθ dω it \
         would be counted twice.";
    /// f/cosθ.
    OVER_COSINE "over-cosine"
        "The lobe is divided by a cosine: Phong's own formula, which takes radiance to \
         radiance. At grazing light it sends back more than came, without bound.";
    /// Something below the horizon.
    THROUGH "through"
        "Below the horizon there is neither light nor eye: the BRDF is 0 as soon as `wi` \
         or `wo` has z ≤ 0. Are both asked? The lobe dips below the horizon.";
    /// cosα < 0.
    LOBE_BEHIND "lobe-behind"
        "A lobe has one side. Where cosα is negative the BRDF is 0; an even power makes \
         it positive, an odd one makes negative light. Cut cosα off at 0.";
    /// No constant.
    NO_CONSTANT "no-constant"
        "Is that cosⁿα with nothing in front? Its albedo is 2π/(n + 2): twice what came \
         for n = 1, an eighth for n = 48.";
    /// (n + 1)/2π in the BRDF.
    OF_DENSITY "of-density"
        "(n + 1)/2π makes a *density* of cosⁿα, whose integral is 1. In the albedo one \
         more cosine is integrated: (n + 2)/2π. Straight in, 1/(n + 2) of the light is lost.";
    /// (n + 2)/2π in the density.
    OF_BRDF "of-brdf"
        "(n + 2)/2π is the constant of the BRDF. The density has no cosine of the surface \
         in its integral: (n + 1)/2π.";
    /// The lobe points back.
    RETRO "retro"
        "The lobe points back to where the light comes from. Of which direction is the \
         mirror image taken? x and y change their signs, z does not.";
    /// The lobe stands on the normal.
    ABOUT_NORMAL "about-normal"
        "The lobe stands about the normal. It stands about the mirror image of `wo`.";
    /// Blinn's lobe.
    HALFWAY "halfway"
        "That is the lobe of the halfway vector (Blinn). It is wider by a factor of two, \
         and this constant does not belong to it.";
    /// f(a, b) ≠ f(b, a).
    NOT_RECIPROCAL "not-reciprocal"
        "Not reciprocal: exchange lamp and eye, and the value changes. Light could not go \
         back on its way, and a path from the eye would find other light than one from \
         the lamp.";
    /// ∫ f dω.
    NO_COSINE "no-cosine"
        "Is cosθ missing in the integral? Light that comes in aslant brings less flux.";
    /// ∫ f cos²θ dω.
    COSINE_TWICE "cosine-twice"
        "Is the cosine counted twice? One belongs to the integral, none to the BRDF.";
    /// Of wo, where that of wi belongs.
    OTHER_COSINE "other-cosine"
        "That is the cosine of `wo`, which stands still. What is integrated over is `wi`.";
    /// ∫ f cosθ dθ dφ.
    NO_SINE "no-sine"
        "Is sinθ missing? A ring near the normal is short: dω = sinθ dθ dφ.";
    /// φ to π.
    HALF_TURN "half-turn"
        "Do the pieces of a ring go only half round? φ runs from 0 to 2π.";
    /// A π more, or less.
    PI_AGAIN "pi-again"
        "A π too many or too few. None is put into the integral by hand: Lambert's albedo \
         comes out as ρ because his BRDF has 1/π.";
    /// A direction is not of unit length.
    NOT_UNIT "not-unit"
        "The direction has not unit length. In the lobe's frame it is (sinα cosφ, sinα \
         sinφ, cosα), with sinα = √(1 − cos²α).";
    /// u^(1/n).
    ROOT "root"
        "The samples are too wide or too narrow for their density. Within α lies the share \
         1 − cosⁿ⁺¹α of them; solve for cosα: a root of order n + 1.";
    /// cosα = u.
    UNIFORM "uniform"
        "The samples are spread evenly, whatever the exponent. They should be dense where \
         cosⁿα is large.";
    /// kd ≤ 1 and ks ≤ 1.
    EACH_ALONE "each-alone"
        "Each reflectance is at most 1, but their sum is not: `kd` + `ks` of one channel \
         leave together.";
    /// Mean over the channels.
    MEAN_OF_CHANNELS "mean-of-channels"
        "A mean or a sum over the channels hides a channel that creates light. Each has to \
         keep energy by itself: red light does not turn green.";
    /// sum < 1.
    STRICT "strict"
        "A sum of exactly 1 is refused. A perfect mirror creates no light.";
}
