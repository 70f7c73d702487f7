//! The mistakes that the checks of the lab `race` can name.

use crate::check::bugs;

bugs! {
    /// |a − e|.
    ABSOLUTE "absolute"
        "Is the error divided by the exact value? 0.01 off is little for 1, and \
         everything for 0.01.";
    /// Divided by the answer.
    BY_THE_ANSWER "by-the-answer"
        "The error is taken as a share of the answer. The answer is what is in \
         question: divide by the exact value.";
    /// |mean a − e|.
    OF_THE_MEAN "of-the-mean"
        "That is the error of the mean of all answers. Too much in one run makes up \
         for too little in another, but nobody runs them all: take each answer's \
         error first.";
    /// mean |a − e|.
    NO_SQUARES "no-squares"
        "That is the mean of the errors' sizes. Was the square left out?";
    /// mean (a − e)².
    NO_ROOT "no-root"
        "Is the root missing? 10 % off gives 0.01 when squared.";
    /// √Σ.
    NOT_A_MEAN "not-a-mean"
        "More seeds would make this larger: divide the sum of squares by their \
         number.";
    /// √Σ/n.
    OVER_N "over-n"
        "Was it divided by n after the root? Then it falls with the number of seeds, \
         like the error of a mean. This is the error of one run.";
    /// About the mean.
    SCATTER "scatter"
        "That is how far answers scatter about their own mean. A method that is \
         always wrong in the same way would look perfect: take the exact value, not \
         the mean.";
    /// The largest.
    WORST "worst"
        "That is the largest error of all. One unlucky seed decides it; take the root \
         mean square.";
    /// Σ(p ≤ p).
    ITSELF "itself"
        "Nothing is left, or no equals are: does a trial beat itself, or its equal? \
         To beat is to be no worse in both *and better in one*.";
    /// < or <.
    EITHER "either"
        "Was a trial thrown out because another is better in one of the two? To beat \
         it, the other must be no worse in both.";
    /// < and <.
    STRICT "strict"
        "At the same time a smaller error beats, and at the same error a shorter time \
         does: it need not be better in both.";
    /// One of equals.
    ONE_OF_EQUALS "one-of-equals"
        "Two trials that are equal do not beat each other: both stay.";
    /// In the order of the list.
    UNSORTED "unsorted"
        "Were trials compared with earlier ones of the list only? They come in any \
         order: compare each with all, or sort by time first.";
    /// Larger is better.
    LARGER "larger"
        "That is the other end: of time and of error, less is better.";
    /// The ends.
    ENDS "ends"
        "Only the fastest and the most accurate are left. Whoever wants an error \
         between the two needs what is between them.";
    /// The hull.
    HULL "hull"
        "Was a convex hull taken? A trial above the line between two others is not \
         beaten: a line is no method.";
    /// What is beaten.
    BEATEN "beaten"
        "Those are the ones that are beaten. The others are asked for.";
    /// No logarithm.
    LINEAR "linear"
        "Is that the slope of the numbers themselves? The axes are logarithmic: take \
         the logarithm of both.";
    /// One logarithm.
    ONE_LOG "one-log"
        "A logarithm is taken of one of the two only.";
    /// x over y.
    SWAPPED "swapped"
        "That is the time's slope over the error. Divide by the squares of the \
         *time's* deviations.";
    /// −p.
    SIGN "sign"
        "The sign is wrong: an error that falls with the time has a slope below 0.";
    /// First and last.
    TWO_POINTS "two-points"
        "Only the first and the last trial count here. Least squares listen to all of \
         them.";
    /// Through the origin.
    NO_MEANS "no-means"
        "Is the line forced through the point (1, 1)? Subtract the means of the \
         logarithms first.";
    /// ln 0.
    NO_LOGARITHM "no-logarithm"
        "Not a number: the logarithm of 0 is −∞. A trial without error, or without \
         time, does not count.";
    /// Something for ln 0.
    MADE_UP "made-up"
        "Was a 0 replaced by something that has a logarithm? The slope depends on \
         what you made up: leave such a trial out.";
    /// n of all.
    COUNTED "counted"
        "The sums leave a trial out, but n counts it.";
    /// More than allowed.
    TOO_MANY "too-many"
        "The kernel was asked more often than allowed. k places in each of four \
         variables are k⁴ evaluations: is k rounded up, or does a second run count, \
         too?";
    /// The same effort.
    STUCK "stuck"
        "As many evaluations at any effort? A method that cannot be turned up is a \
         point on the chart, not a line.";
    /// Places beyond [0, 1].
    OUTSIDE "outside"
        "The kernel was asked outside [0, 1]. Tables of Gauss's rule often hold \
         places in [−1, 1]: (x + 1)/2.";
    /// Weights of [−1, 1].
    INTERVAL "interval"
        "Sixteen times too large: weights of [−1, 1] sum to 2, and there are four of \
         them. Halve each.";
    /// No weights.
    NO_WEIGHTS "no-weights"
        "Gauss's places crowd at the ends, and their weights make up for it. Here all \
         places count the same.";
    /// Σ.
    NOT_DIVIDED "not-divided"
        "That is the sum of the kernel. Its mean is asked for.";
    /// π again.
    PI_TWICE "pi-twice"
        "π times too small: the kernel is divided by π already.";
    /// A again.
    AREA_TWICE "area-twice"
        "An area too many, or too few: the kernel holds it already. Its plain mean is \
         the form factor.";
    /// u = v.
    SAME_PLACES "same-places"
        "Both points are at the same two numbers. There are four: every place of the \
         one sees every place of the other.";
    /// From the middle.
    FROM_THE_MIDDLE "from-the-middle"
        "Is one of the two taken at its middle alone? The mean runs over the places \
         of both.";
    /// At a common edge.
    AT_THE_EDGE "at-the-edge"
        "Not a number: the kernel is 0/0 where two surfaces touch. Does your rule ask \
         at 0 or 1? Rules that keep off the ends need no special case.";
    /// The midpoint rule.
    MIDPOINT "midpoint"
        "Right, but it is the midpoint rule, point to point: it is on the chart \
         already. Its error is c h², so two step widths tell c; or place points \
         better than evenly.";
    /// Slow.
    SLOW "slow"
        "It goes the right way, but no faster than points at the middles. Is it \
         random, or does it take places at one end of each piece? A rule of higher \
         order, or two rules of which the errors cancel, do much better.";
}
