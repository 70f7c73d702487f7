//! The mistakes that the checks of the lab `substructure` can name.

use crate::check::bugs;

bugs! {
    /// F_ep for e in p.
    OWN_PATCH "own-patch"
        "An element looks at its own patch. Elements of one patch do not interact: what \
         is flat does not see itself. The factor is 0, and nobody has to ask.";
    /// n² factors.
    ALL_PAIRS "all-pairs"
        "More factors were asked for than there are pairs of an element and another \
         patch. That cost is what substructuring avoids: ask for each pair once.";
    /// Rows of patches, columns of elements.
    TRANSPOSED "transposed"
        "Rows and columns are exchanged: the row is that of the element that looks.";
    /// Σ F/n.
    NO_AREAS "no-areas"
        "That is the mean of the rows without their areas. A large element is more of \
         the patch than a small one: weigh each with A_e.";
    /// Σ A F.
    NOT_DIVIDED "not-divided"
        "That is the sum of A_e F_eq. Is the area of the patch missing below the line?";
    /// Divided by the receiving patch's area.
    WRONG_AREA "wrong-area"
        "Divided by the area of the patch that is looked at. The mean is over the patch \
         that looks: A_p.";
    /// Σ F.
    SUMMED "summed"
        "The elements' factors were added. A factor is a share: of a patch in three parts \
         each sends its own share, and the whole sends their mean.";
    /// 2E + ρ Σ F B.
    EMITTED_TWICE "emitted-twice"
        "The emission counts twice. Patches that emit hold it in B_q, for others to see; \
         the element adds its own E once.";
    /// ρ Σ F B.
    NO_EMISSION "no-emission"
        "Elements of the lamp are dark: is the emission E missing?";
    /// Σ ρ_q F B_q.
    SENDERS_RHO "senders-rho"
        "The reflectance is that of the sender. B_q has been reflected there already; \
         what arrives is reflected by the element's own patch.";
    /// ρ missing.
    NO_RHO "no-rho"
        "All that arrives leaves again: is the reflectance missing?";
    /// All elements of a patch alike.
    ALL_ALIKE "all-alike"
        "All elements of a patch have the patch's mean. Each looks around from its own \
         place: use its own row, not that of the patch.";
    /// A_min forgotten.
    NO_MINIMUM "no-minimum"
        "An element that is small enough was split. At a shadow's edge the light never \
         gets even: without a smallest area the splitting never ends.";
    /// Δ²/12 without area.
    NO_AREA "no-area"
        "The rise was judged without the area. A tiny element adds little to the error, \
         however much the light changes on it.";
    /// A Δ/12.
    NOT_SQUARED "not-squared"
        "The rise is not squared: the share is one of the *squared* error.";
    /// A Δ².
    NO_TWELFTH "no-twelfth"
        "A twelfth is missing: light that rises evenly by Δ is off its mean by Δ/√12.";
    /// First and last only.
    TWO_PLACES "two-places"
        "Only two of the places were compared. Largest less least, of all of them.";
    /// Marks reversed.
    REVERSED "reversed"
        "What should be split is kept, and the reverse.";
    /// Left as it was.
    NOT_ANCHORED "not-anchored"
        "The T-vertex keeps a value of its own: the picture tears there, by h²B''/8.";
    /// 1 − t.
    BACKWARDS "backwards"
        "The ends are exchanged: at 0 the value is that of the first end.";
    /// (a + b)/2.
    ALWAYS_HALF "always-half"
        "The mean of the ends is right in the middle of an edge only. Where on the edge is \
         the vertex?";
    /// Mean of own and edge.
    HALF_ANCHORED "half-anchored"
        "The vertex keeps half of its own value. It must lie *on* the edge.";
    /// Ends not anchored.
    OLD_ENDS "old-ends"
        "Right, but for edges that end in a T-vertex: these take the value that it had \
         before it was anchored. Go through the list in order, and read the new values.";
}
