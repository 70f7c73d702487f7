//! Failures of meshing and display: rows 35 to 46.

pub mod fields;
pub mod links;
pub mod shadows;

use super::{Row, Shown};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 35,
        name: "Light leaks under a wall",
        why: "An element that lies on both sides of a wall has one radiosity, the mean \
              of the lit and of the dark part.",
        size: "Behind the wall the floor is as bright as the share of the element that \
               is lit: from 20 % to 80 % for elements of 0.5 m to 0.03 m; only the \
               area falls with the element. Elements that are cut along contact lines \
               leak exactly 0.",
        remedy: "Cut elements where surfaces meet, before anything else.",
        tests: &[
            "mesh::row_35_light_leaks_under_walls",
            "display::row_35_a_leak_falls_in_area_and_not_in_height",
        ],
        shown: Shown::Curve(shadows::light_leak),
    },
    Row {
        number: 36,
        name: "Things float above the floor",
        why: "A shadow begins where an element begins whose middle is dark, not where \
              the thing stands.",
        size: "A gap of up to half an element, or a shadow on the wrong side, up to \
               half an element; 0 when elements are cut where things touch.",
        remedy: "Cut elements along contact lines.",
        tests: &["display::row_36_things_float_above_coarse_floors"],
        shown: Shown::Curve(shadows::floating),
    },
    Row {
        number: 37,
        name: "Edges of shadows are stairs",
        why: "One number for an element puts the edge of a shadow on the grid, however \
              exact the light is.",
        size: "For an edge of slope 0.6 it is 0.24 elements out of place on average: \
               half of it with elements of half the size.",
        remedy: "Refine along edges of shadows, cut along them, or look for lamps at \
                 each pixel.",
        tests: &["display::row_37_shadow_edges_are_stairs"],
        shown: Shown::Curve(shadows::stairs),
    },
    Row {
        number: 38,
        name: "A spot between the places is not there",
        why: "Whoever looks at one place in an element knows nothing of the rest of \
              it.",
        size: "A spot of light of 0.1 m is missed by elements of 1 m, 0.5 m and 0.125 \
               m: all of it; those of 0.25 m make it 6.25 times as much. It is right \
               on average over all grids, and seldom on one.",
        remedy: "Means over elements instead of places, and shafts that tell where \
                 something may hide.",
        tests: &["display::row_38_a_spot_between_the_places_is_not_there"],
        shown: Shown::Curve(shadows::missed_spot),
    },
    Row {
        number: 39,
        name: "T-vertices tear the field",
        why: "Where two small elements meet a large one, its edge is straight and \
              theirs has a vertex with a value of its own.",
        size: "A jump of h² B''/8; rounding leaves holes there, in the L-shaped room \
               one cell in about every tenth hemicube. With the T-vertex anchored to \
               the large edge the jump is 0.",
        remedy: "Show a T-vertex as the edge that it lies on has it; split neighbours \
                 so that no edge holds two.",
        tests: &[
            "mesh::row_39_t_vertices_leave_holes",
            "mesh::row_39_t_vertices_tear_the_field_unless_they_are_anchored",
        ],
        shown: Shown::Curve(fields::torn),
    },
    Row {
        number: 40,
        name: "Kinks get worse before they get better",
        why: "The eye sees where the slope changes, and a coarse mesh does not yet \
              know how steep the light is.",
        size: "Under a lamp 0.2 m above the floor: 0.93, 1.49, 1.36, 0.81, 0.42 W/m³ \
               as elements halve from 0.5 m; the last two are within 6 % of h max \
               |B''|.",
        remedy: "Elements below the distance of the lamp; or light at each pixel.",
        tests: &["display::row_40_kinks_get_worse_before_they_get_better"],
        shown: Shown::Curve(fields::kinks),
    },
    Row {
        number: 41,
        name: "Flat is of first order",
        why: "One number for an element is off by half of what the light changes \
              across it.",
        size: "Halving elements halves the error of flat ones, 0.186 to 0.016 W/m² \
               from 0.5 to 0.03 m, and quarters that of smooth ones in the end; means \
               of neighbours are twice as far off as exact vertices.",
        remedy: "Smooth fields where the light is smooth, from exact values at \
                 vertices.",
        tests: &["display::row_41_flat_is_of_first_order_and_smooth_of_second"],
        shown: Shown::Curve(fields::flat_and_smooth),
    },
    Row {
        number: 42,
        name: "A mean over a corner mixes walls",
        why: "Two walls that meet have a vertex in common and no light.",
        size: "At an edge each takes half of the difference; kept apart, exactly \
               nothing.",
        remedy: "Vertices belong to surfaces; share them only where normal and \
                 material are the same.",
        tests: &["mesh::row_42_no_mean_over_a_corner"],
        shown: Shown::Curve(fields::over_the_corner),
    },
    Row {
        number: 43,
        name: "Points are blind to what stands between them",
        why: "An oracle that decides by points refines nothing where all points agree.",
        size: "A card that hides 1.3 % of a lamp hides 26 % by nine points when one is \
               below it, else nothing; that something reaches into the shaft doubts \
               the link by 20 % in any case.",
        remedy: "Ask what may stand between, not only what the points see.",
        tests: &[
            "links::row_43_points_are_blind_but_shafts_are_not",
            "links::row_43_a_card_is_hidden_from_points_but_doubted",
            "display::row_43_an_oracle_of_points_marks_nothing",
        ],
        shown: Shown::Curve(links::blind_points),
    },
    Row {
        number: 44,
        name: "Contacts refine for ever",
        why: "Two squares that share an edge have the same factor, and the same error \
              of it, however small they are.",
        size: "The factor's error stays, to 0.1 %, over nine halvings; weighed with \
               the area it falls by four with each, and refinement ends: below 20 000 \
               elements in a cube, even without a smallest area.",
        remedy: "Weigh factors with the power that goes over them; have a smallest \
                 area.",
        tests: &["links::row_44_contacts_do_not_refine_for_ever"],
        shown: Shown::Curve(links::contacts),
    },
    Row {
        number: 45,
        name: "Light is lost on the way up",
        why: "A node's radiosity is the mean of its children's by area; by number only \
              when all are of one size.",
        size: "With a crooked quadrilateral in the room plain means are off by 2e-4 of \
               all light; means by area by rounding, below 1e-12.",
        remedy: "Weigh with areas, and check the sums of every level.",
        tests: &["links::row_45_push_and_pull_conserve_energy"],
        shown: Shown::Curve(links::push_and_pull),
    },
    Row {
        number: 46,
        name: "The mean of codes is no mean of light",
        why: "The numbers in an sRGB picture are not proportional to light.",
        size: "For tiles of 0.9 and 0.1 as one mean reflectance 8 % of the reflected \
               light is lost, for 0.9 and 0 it is 18 %; by the mean of the \
               reflectances nothing.",
        remedy: "Decode first, then take the mean.",
        tests: &["display::row_46_the_mean_of_a_texture_is_taken_in_linear_light"],
        shown: Shown::Curve(fields::mean_of_codes),
    },
];
