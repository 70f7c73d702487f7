//! The mistakes that the checks of the lab `shoot` can name.

use crate::check::bugs;

bugs! {
    /// argmax ΔB for A ΔB.
    BY_RADIOSITY "by-radiosity"
        "Was the brightest chosen by radiosity? By power, the area counts: A ΔB.";
    /// argmax A ΔB for ΔB.
    BY_POWER "by-power"
        "Was the brightest chosen by power? By radiosity, watts for each m² count, \
         and no area.";
    /// argmax A.
    LARGEST "largest"
        "That is the largest element, not the brightest.";
    /// argmin.
    DIMMEST "dimmest"
        "That is the dimmest element. Is a comparison the wrong way round?";
    /// Some where None is due.
    NEVER_ENDS "never-ends"
        "Nothing is left to send, and still somebody is chosen. Then a loop over shots \
         never ends. Who has no unshot light is no candidate.";
    /// None where there is light.
    STOPS_EARLY "stops-early"
        "There is light left, if little. Is something compared with a fixed number? \
         What is little depends on the room; when to stop is for the caller to say.";
    /// ρ F ΔB.
    NO_AREAS "no-areas"
        "Are the areas missing? F_ij is a share of *power*. Element i sends A_i ΔB_i \
         watts; what arrives is spread over A_j.";
    /// A_j/A_i.
    UPSIDE_DOWN "upside-down"
        "The ratio of the areas is upside down: a large sender lights a small receiver \
         well, A_i/A_j.";
    /// F_ji A_i/A_j.
    SLIDE "slide"
        "That is F_ji A_i/A_j, as on the lecture's slide, whose F has its indices the \
         other way round. Here F_ij is from i to j: F_ij A_i/A_j, which is F_ji \
         alone.";
    /// ρ_i.
    SENDERS_PAINT "senders-paint"
        "Whose reflectance is that? The receiver reflects what arrives; the sender's \
         light has been reflected already.";
    /// 1.
    NO_PAINT "no-paint"
        "Is the reflectance missing? Of what arrives, the receiver sends on the share \
         ρ_j.";
    /// B_i for ΔB_i.
    SENDS_ALL "sends-all"
        "The element sends its whole radiosity, and so what it has sent before, once \
         more. Emission then counts twice. Only ΔB is left to send.";
    /// ΔB_i stays.
    NOT_CLEARED "not-cleared"
        "The sender keeps its unshot light, and will send it again. Is it set to 0?";
    /// ΔB_i = 0 after the loop.
    CLEARED_LAST "cleared-last"
        "A hollow element sees itself: what comes back to it is new, and unshot. Is \
         the sender cleared after the loop? Clear it before.";
    /// ΔB_i = 0 too soon.
    NOTHING_SENT "nothing-sent"
        "Nothing was sent. Was the sender cleared before its power was taken?";
    /// ΔB_j stays.
    NOT_PASSED_ON "not-passed-on"
        "The receivers show the light but do not send it on: ΔB_j grows by as much as \
         B_j. Without that there is one bounce and no more.";
    /// B_j = .
    OVERWRITES "overwrites"
        "What was there before is lost. The light of each shot is *added*.";
    /// B_i = 0.
    GOES_OUT "goes-out"
        "The sender goes dark. What it has sent is no longer unshot, but still its \
         radiosity: a lamp that shines is bright.";
    /// H += ρ…
    REFLECTED_ARRIVES "reflected-arrives"
        "The irradiance is what arrives, *before* any of it is reflected: without ρ.";
    /// No 1/(1 − ρ̄).
    NO_BOUNCES "no-bounces"
        "That spreads the unshot light once. It is reflected on and on: \
         1 + ρ̄ + ρ̄² + … = 1/(1 − ρ̄).";
    /// Means without areas.
    PLAIN_MEAN "plain-mean"
        "Are the means taken over elements? Large ones count more: weigh by area.";
    /// a for ρ a.
    NOT_PAINTED "not-painted"
        "The ambient light *arrives*. An element shows the share ρ_i of it.";
    /// Σ A B for Σ A ΔB.
    OF_ALL_LIGHT "of-all-light"
        "Was the guess made from all radiosity? Only what is unshot is still missing.";
    /// ρ for 1 − ρ.
    REFLECTED "reflected"
        "That is what is reflected. Absorbed is the rest, 1 − ρ.";
    /// No area.
    NO_AREA "no-area"
        "Is the area missing? The ledger is in watts: A times W/m².";
    /// B for H.
    ABSORBS_RADIOSITY "absorbs-radiosity"
        "Radiosity leaves, and what leaves is not absorbed. Absorbed is a share of the \
         irradiance, of what arrives.";
    /// B = 0 at the start.
    NO_EMISSION "no-emission"
        "The lamps are dark. At the start B is not 0 but E: what is emitted is there \
         from the beginning.";
    /// B = E + what includes E.
    EMISSION_TWICE "emission-twice"
        "Emission counts twice. B starts as E; nothing adds E again.";
    /// B + ρ a kept.
    AMBIENT_IN_RESULT "ambient-in-result"
        "The ambient guess is in the result, so that light counts twice: once as a \
         guess, and again when it comes. It belongs to the picture alone.";
    /// Shots ± 1.
    OFF_BY_ONE "off-by-one"
        "That is one shot too many, or too few.";
}
