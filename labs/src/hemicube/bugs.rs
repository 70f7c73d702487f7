//! The mistakes that the checks of the lab `hemicube` can name.

use crate::check::bugs;

bugs! {
    /// 1/r² where 1/r⁴ belongs.
    NO_COSINES "no-cosines"
        "Are two factors 1/r missing: both cosines, or else the 1/r²?";
    /// 1/r³ where 1/r⁴ belongs.
    ONE_COSINE "one-cosine"
        "There are two cosines, the element's and the cell's. Is one of them \
         missing?";
    /// 1/r⁶ where 1/r⁴ belongs.
    COSINES_SQUARED "cosines-squared"
        "Is the product of the cosines taken twice?";
    /// The area of the cell is missing.
    NO_AREA "no-area"
        "Is the area ΔA of the cell missing?";
    /// The edge in place of the area.
    EDGE_FOR_AREA "edge-for-area"
        "ΔA is the area of the cell, edge². Was the edge taken instead?";
    /// π is missing.
    NO_PI "no-pi"
        "Everything is π times too large: is the division by π missing?";
    /// The top's formula on a side.
    SIDE_AS_TOP "side-as-top"
        "On a side face the element's cosine is z/r, not 1/r. Is the z missing?";
    /// y where z belongs.
    SIDE_TURNED "side-turned"
        "On a side face z is the height above the base. Were y and z exchanged?";
    /// A cell of edge 1/n.
    QUARTER_AREA "quarter-area"
        "Every weight is a quarter of the right one: the face is 2 wide, so that \
         the edge of a cell is 2/n, not 1/n.";
    /// Corners of cells in place of centres.
    CELL_CORNERS "cell-corners"
        "Are the weights taken at a corner of each cell instead of at its centre (k \
         + ½)?";
    /// Rows and columns of a side exchanged.
    SIDE_ORDER "side-order"
        "The right weights in the wrong places: the index is row · n + column, and \
         the rows of a side go up from the base.";
    /// Side faces as high as they are wide.
    FULL_SIDES "full-sides"
        "A side face is only half as high as wide: n × n/2 cells. Below the base \
         the element sees nothing.";
    /// A wrong sum repaired by division.
    NORMALISED_AWAY "normalised-away"
        "The sum is 1, and yet the weights are wrong: was a wrong sum divided away? \
         Then rows sum right, but every factor is off. Is a cosine missing from the \
         weights?";
    /// The farthest in place of the nearest.
    FARTHEST "farthest"
        "The farthest surface wins: is the comparison of depths the wrong way \
         round?";
    /// The last in place of the nearest.
    LAST_WINS "last-wins"
        "The last fragment wins whatever its depth. Is the new depth stored, and \
         compared?";
    /// The first in place of the nearest.
    FIRST_WINS "first-wins"
        "The first fragment wins whatever its depth: may a nearer one replace it?";
    /// The depths start at 1.
    FAR_PLANE "far-plane"
        "Surfaces farther than 1 are lost: what does the depth buffer hold at the \
         start?";
    /// Backs let light through.
    BACKS_IGNORED "backs-ignored"
        "One can look through the backs of surfaces. A back is black, and it \
         blocks.";
    /// Backs count as fronts.
    BACKS_AS_FRONTS "backs-as-fronts"
        "A back is taken for a front: an element receives nothing on its back.";
    /// A nearest back leaves the cell empty.
    BACKS_AS_NOTHING "backs-as-nothing"
        "A back stores `Nothing`, as if light left the scene there. It is `Back`: \
         absorbed.";
    /// The element sees itself.
    SELF_SEEN "self-seen"
        "The element sees itself, at a depth of about 0. A flat element never does.";
    /// Cells counted, not weighed.
    COUNTED "counted"
        "Cells are counted instead of weighed: each counts as much as its weight.";
    /// One side of four.
    ONE_SIDE "one-side"
        "Are the top and only one side summed? There are four sides, faces 1 to 4.";
    /// The top alone.
    TOP_ONLY "top-only"
        "Is only the top summed? There are four sides, faces 1 to 4.";
    /// Assigned in place of added.
    OVERWRITTEN "overwritten"
        "Each element holds the weight of one cell: `=` where `+=` belongs?";
    /// The row held old values.
    NOT_CLEARED "not-cleared"
        "The row still holds what it held before: it must be set to 0 first.";
    /// Escaped by subtraction.
    ONE_MINUS "one-minus"
        "Was `escaped` taken as one minus the rest? Count the weights of the empty \
         cells: else an error of the weights looks like light that leaves.";
    /// Rows divided by their sum.
    ROW_NORMALISED "row-normalised"
        "Was the row divided by its sum? In an open scene, light that leaves is \
         then given to the elements.";
    /// Absorbed and escaped exchanged.
    LOST_EXCHANGED "lost-exchanged"
        "Were `escaped` (cells that see nothing) and `absorbed` (backs) exchanged?";
    /// The row in place of the column.
    TRANSPOSED "transposed"
        "F_ij was returned where F_ji is due. They differ by the ratio of the \
         areas.";
    /// The ratio the wrong way round.
    RATIO_INVERTED "ratio-inverted"
        "The ratio of the areas is upside down: A_i F_ij = A_j F_ji. Solve for \
         F_ji.";
    /// One area only.
    ONE_AREA "one-area"
        "Is one of the two areas missing from the ratio?";
}
