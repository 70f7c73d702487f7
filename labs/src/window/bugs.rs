//! The mistakes that the checks of the lab `window` can name.

use crate::check::bugs;

bugs! {
    /// r for r².
    NOT_SQUARED "not-squared"
        "That is the amplitude. Power is its square.";
    /// [p, s].
    EXCHANGED "exchanged"
        "s and p are exchanged. It is p that vanishes at Brewster's angle.";
    /// n for 1/n.
    UPSIDE_DOWN "upside-down"
        "Is Snell's law upside down? Inside glass the sine is smaller: sinᵢ/n. (A sine \
         above 1 has no cosine: NaN.)";
    /// cosₜ = cosᵢ.
    NOT_BENT "not-bent"
        "Is the cosine inside taken for the one outside? Glass bends light: sinᵢ = n \
         sinₜ.";
    /// 1 − R.
    PASSED "passed"
        "That is what passes. Asked is what is reflected.";
    /// (1 − R) of one face.
    ONE_FACE "one-face"
        "A pane has two faces: that is what one of them passes.";
    /// (1 − R)².
    NO_REFLECTIONS "no-reflections"
        "What the second face reflects is not lost: the first sends a part of it back, \
         and so on. Sum the series: (1 − R)² (1 + R² + R⁴ + …).";
    /// The mean of s and p goes into the formula.
    MEAN_FIRST "mean-first"
        "Were s and p averaged first? Between the faces light stays polarised: each \
         goes through the pane by itself, and the mean comes last.";
    /// One of both only.
    ONE_POLARISATION "one-polarisation"
        "That is one of the two polarisations. Unpolarised light is half of each.";
    /// What is reflected.
    REFLECTED "reflected"
        "That is what the pane reflects. Asked is what it passes.";
    /// s + p.
    SUMMED "summed"
        "Twice too much: half of the light is s, and half is p.";
    /// Without the cosine.
    NO_COSINE "no-cosine"
        "Every direction counts the same. What comes aslant spreads over more of the \
         pane: weight by the cosine.";
    /// Without the sine.
    NO_SINE "no-sine"
        "All rings count the same. Those near the normal are smaller: 2π sinθ dθ.";
    /// T at 0°.
    STRAIGHT_ON "straight-on"
        "That is the transmittance straight on. Aslant a pane passes less: it is the \
         angle at the *pane* that counts.";
    /// ∫ T cosθ dω, or another multiple.
    NOT_A_MEAN "not-a-mean"
        "A mean of what is at most 1 is at most 1: divide by the integral of the \
         cosine, which is π.";
    /// The pane is not there.
    NO_GLASS "no-glass"
        "That is the factor without glass. A pane keeps 8 % and more.";
    /// The wall is not there.
    NO_WALL "no-wall"
        "Light came through the wall. Does the straight line to the lamp go through \
         the pane's outline?";
    /// T by the angle at the point or the lamp.
    OTHER_ANGLE "other-angle"
        "By which angle is the transmittance taken? The one between the ray and the \
         normal of the *pane*, not of the point or the lamp.";
    /// A pane seen from its back.
    ONE_WAY_PANE "one-way-pane"
        "Right from the pane's front, wrong from its back: the dot product with its \
         normal is negative there. A pane has no back: take |cosθ|.";
    /// The lamp's cosine is missing, or the point's.
    NO_LAMP_COSINE "no-lamp-cosine"
        "One of the two cosines of a form factor is missing: at the point and at the \
         lamp.";
    /// 1/π is missing.
    NO_PI "no-pi"
        "π times too much: a form factor is a share of π.";
    /// What turns its back counts.
    FROM_BEHIND "from-behind"
        "A lamp's back sends nothing, and a point receives nothing from below its \
         horizon: cut negative cosines off.";
    /// ρ and τ are exchanged.
    RHO_FOR_TAU "rho-for-tau"
        "ρ and τ are exchanged: ρ of what falls on the *same* face, τ of what falls on \
         the *other*.";
    /// One face passes, the other does not.
    ONE_WAY_SHEET "one-way-sheet"
        "Only one of the faces gets what passes. A sheet passes light both ways alike.";
    /// Only τ.
    NO_REFLECTANCE "no-reflectance"
        "What each face reflects is missing.";
    /// Only ρ.
    NOTHING_PASSES "nothing-passes"
        "What comes through from the other face is missing.";
    /// Both of the same face.
    SAME_FACE "same-face"
        "That is (ρ + τ) H of the same face. What passes comes from the other one.";
    /// H F.
    NO_TAU "no-tau"
        "All that falls on the sheet comes through. Is τ missing?";
    /// τ H.
    NO_FACTOR "no-factor"
        "That is the radiosity of the sheet. What arrives is that times the form \
         factor from `p` to it.";
    /// The other side of π.
    PI_AGAIN "pi-again"
        "Off by π. A form factor times a radiosity is an irradiance: no π is left.";
}
