//! The mistakes that the checks of the lab `gather` can name.

use crate::check::bugs;

bugs! {
    /// F_ji.
    TRANSPOSED "transposed"
        "Are the indices of F swapped? What i gathers is weighted by its own view: \
         row i, `factors[i][j]`. F_ji goes with areas: F_ji A_j B_j, in watts.";
    /// j ≠ i.
    SKIPS_SELF "skips-self"
        "Is element i left out of its own sum? A flat element has F_ii = 0 anyway, \
         but a curved one, as a piece of a ball, does see itself.";
    /// Σ F_ji A_j B_j.
    IN_WATTS "in-watts"
        "Those are watts: Σ F_ji A_j B_j is all the power that arrives at i. Divide \
         by A_i, or use row i and no areas.";
    /// Σ F_ij A_j B_j.
    MIXED "mixed"
        "Two forms of the equation are mixed. Areas go with F_ji (power); with F_ij \
         there are none.";
    /// ρ H for H.
    PAINT_TOO_EARLY "paint-too-early"
        "What arrives knows nothing of the paint at i yet: the reflectance comes in \
         with the next task.";
    /// E + H for H.
    OWN_LIGHT "own-light"
        "Is E counted among what arrives? What i emits leaves i, and arrives \
         elsewhere. It is added once, outside of what ρ multiplies.";
    /// ρ_j.
    SENDERS_PAINT "senders-paint"
        "Whose reflectance is it? Light is reflected where it arrives: ρ_i, outside \
         of the sum. What j sends has met j's paint already.";
    /// 2E.
    EMISSION_TWICE "emission-twice"
        "E is there twice. B_j holds what j emits already: add E_i once, outside of \
         the sum.";
    /// B + ρH.
    ADDS_UP "adds-up"
        "Is ρH added to the old B? It holds the earlier bounces already, and they \
         would count again. The new B replaces the old one: E + ρH.";
    /// ρH.
    NO_EMISSION "no-emission"
        "Where is E? Without it the light dies out.";
    /// ρ(E + H).
    PAINTS_LAMPS "paints-lamps"
        "Is E multiplied by ρ too? A lamp's own light is not reflected by it.";
    /// Newest values in a bounce.
    IN_PLACE "in-place"
        "Elements late in the list got new values from early ones. A bounce takes old \
         values only: write the new ones to a list of their own. (What you have is \
         task 3.)";
    /// Old values in a sweep.
    OLD_VALUES "old-values"
        "That is a bounce: each element has gathered old values. In a sweep the new \
         B_0 is there already when B_1 is gathered.";
    /// From the last element on.
    BACKWARDS "backwards"
        "The sweep runs from the last element to the first. The order matters for \
         what one sweep gives, though not for where many lead.";
    /// B − E − ρH.
    SIGN "sign"
        "The sign is the wrong way round: the residual is positive where light is \
         still to come.";
    /// No areas.
    NO_AREAS "no-areas"
        "Are the areas forgotten? W/m² of a large wall and of a small lamp cannot be \
         added: each counts by its area.";
    /// ρ for 1 − ρ.
    KEEPS_THE_REST "keeps-the-rest"
        "ρ is the share that is sent back. What is kept is 1 − ρ.";
    /// B for H.
    OF_WHAT_LEAVES "of-what-leaves"
        "The share 1 − ρ is kept of what arrives, H, not of what leaves, B.";
    /// Stopped while changes are small.
    SMALL_CHANGE "small-change"
        "It stopped as the change, or the residual, had fallen to the accuracy. But \
         many small changes may be to come: what is missing can be 1/(1 − ρ_max) \
         times as much.";
    /// Stopped before.
    TOO_EARLY "too-early"
        "It stopped long before. Is the number of sweeps fixed? Bright rooms need \
         more.";
    /// More sweeps than it takes.
    TOO_LONG "too-long"
        "Right, but with more sweeps than it takes. Stop as soon as the largest \
         residual is below accuracy × (1 − ρ_max): then no element can be off by \
         more.";
}
