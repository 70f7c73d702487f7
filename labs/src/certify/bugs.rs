//! The mistakes that the checks of the lab `certify` can name.

use crate::check::bugs;

bugs! {
    /// B − E − ρH.
    SIGN "sign"
        "The sign is the wrong way round: the residual is positive where light is \
         missing, so that it can be added.";
    /// ρH − B.
    NO_EMISSION "no-emission"
        "Where is E? A lamp would seem to have far too much light.";
    /// E + H − B.
    NO_PAINT "no-paint"
        "Where is the reflectance? Of what arrives only the share ρ leaves.";
    /// ρ(E + H) − B.
    PAINTS_LAMPS "paints-lamps"
        "Is E multiplied by ρ too? A lamp's own light is not reflected by it.";
    /// Gather 0 whatever is asked.
    ONE_GATHER "one-gather"
        "The same gather is taken twice. `gather` says which of the two is asked for.";
    /// The mean of both gathers.
    BOTH_GATHERS "both-gathers"
        "Are the two gathers averaged? They are better together, but then nothing is \
         left that is independent: the next task needs them one by one.";
    /// r₁².
    SQUARE "square"
        "One gather is squared. The mean of a square is r² *and the variance of the \
         gather*: the noise is taken for error. Multiply two that know nothing of each \
         other.";
    /// ((r₁ + r₂)/2)².
    SQUARE_OF_MEAN "square-of-mean"
        "The mean of both is squared. Half of the variance is still in it; a product \
         of the two has none.";
    /// |r₁ r₂|.
    ABSOLUTE "absolute"
        "Is the sign of a product dropped? Negative ones are as right as positive \
         ones: they are what makes the noise cancel.";
    /// Σ r₁ r₂/n.
    NO_AREAS "no-areas"
        "Are the areas forgotten? Each point counts by the area that it stands for.";
    /// Root of it.
    ROOTED "rooted"
        "That is the norm; the task asks for its square.";
    /// 1 + ρ and 1 − ρ exchanged.
    SWAPPED "swapped"
        "The two bounds are exchanged: the least error is less than the residual, \
         the largest is more.";
    /// The residual is the error.
    NOT_PROPAGATED "not-propagated"
        "That is the residual itself. What is missing at other places is missing in \
         what arrives, too.";
    /// ρ/(1 − ρ).
    WITHOUT_ITSELF "without-itself"
        "ρ + ρ² + … leaves out the residual itself: 1 + ρ + ρ² + … = 1/(1 − ρ).";
    /// Over ‖B‖.
    LAMP_HIDES "lamp-hides"
        "Relative to all light? The lamp outshines the rest, and it is known. A black \
         room with a lamp would pass. Take the light that was reflected, B − E.";
    /// Σ A |B − E|.
    NOT_A_NORM "not-a-norm"
        "Is it a sum, and not the root of a sum of squares? The error is a norm, so \
         is what it is compared with.";
    /// ‖B‖ − ‖E‖.
    OF_NORMS "of-norms"
        "Norms are subtracted. First the difference B − E, at each point; then its \
         norm.";
    /// r + Kr.
    ONE_BOUNCE "one-bounce"
        "One bounce of the residual is added, and no more. What has bounced once \
         bounces again.";
    /// K e without r.
    NO_RESIDUAL "no-residual"
        "What arrives from others is all there is in it. A piece's own residual is \
         part of its error.";
    /// ρ_j.
    SENDERS_PAINT "senders-paint"
        "Whose reflectance is it? The error is reflected where it arrives: ρ_i, \
         outside of the sum.";
    /// F_ji.
    TRANSPOSED "transposed"
        "Are the indices of F swapped? What i gathers is weighted by its own view: \
         row i, `factors[i][j]`.";
    /// E again.
    LAMP_AGAIN "lamp-again"
        "Is E in it? The emission is known and has no error: the lamp of this \
         equation is the residual.";
    /// r/(1 − ρ_i).
    WORST_EVERYWHERE "worst-everywhere"
        "That is the worst case, at each piece by itself. Who lights whom? The \
         factors say.";
}
