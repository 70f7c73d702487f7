//! The rows themselves.

use super::{Row, State, Written};

const fn planned(topic: &'static str, title: &'static str, lab: bool) -> Row {
    Row { topic, title, lab, state: State::Planned }
}

/// The rows of the lecture in order; row `k` of the list is chapter `k + 1`.
pub const ROWS: [Row; 23] = [
    Row {
        topic: "what radiosity assumes: diffuse surfaces, a closed scene, no medium",
        title: "What radiosity assumes",
        lab: false,
        state: State::Done(Written {
            page: "assumptions.md",
            module: "src/solve/mod.rs",
            figure: "pictures/assumptions-eye-0.snap.png",
            test: ("book/tests/pictures/figures.rs", "one_solution_serves_two_eyes"),
            lab: None,
        }),
    },
    Row {
        topic: "solid angle",
        title: "Solid angle",
        lab: true,
        state: State::Done(Written {
            page: "solid-angle.md",
            module: "src/radiometry/solid_angle.rs",
            figure: "pictures/solid-angle-view.snap.png",
            test: ("tests/tables/solid_angle.rs", "triangles"),
            lab: Some("labs/solid-angle.md"),
        }),
    },
    Row {
        topic: "radiometry: flux, irradiance, radiosity, radiance, and how they convert",
        title: "Radiometry",
        lab: true,
        state: State::Done(Written {
            page: "radiometry.md",
            module: "src/radiometry",
            figure: "pictures/radiometry-height-1.snap.png",
            test: ("src/radiometry/mod.rs", "conversions_go_round"),
            lab: Some("labs/radiometry.md"),
        }),
    },
    Row {
        topic: "BRDF",
        title: "How surfaces scatter: the BRDF",
        lab: true,
        state: State::Done(Written {
            page: "brdf.md",
            module: "src/material/brdf.rs",
            figure: "pictures/brdf-ball-1.snap.png",
            test: ("tests/laws/brdf.rs", "samples_follow_their_density"),
            lab: Some("labs/brdf.md"),
        }),
    },
    Row {
        topic: "albedo (reflectance); energy conservation",
        title: "Albedo and the conservation of energy",
        lab: true,
        state: State::Done(Written {
            page: "albedo.md",
            module: "src/material/mod.rs",
            figure: "pictures/albedo-bare-0.snap.png",
            test: ("tests/tables/brdf.rs", "phong_albedos"),
            lab: Some("labs/brdf.md"),
        }),
    },
    Row {
        topic: "the radiosity equation",
        title: "The radiosity equation",
        lab: true,
        state: State::Done(Written {
            page: "radiosity-equation.md",
            module: "src/solve",
            figure: "pictures/equation-sum-2.snap.png",
            test: ("book/tests/pictures/equation.rs", "light_comes_bounce_by_bounce"),
            lab: Some("labs/gather.md"),
        }),
    },
    Row {
        topic: "the form factor: meaning, computation, reciprocity and closure",
        title: "Form factors",
        lab: true,
        state: State::Done(Written {
            page: "form-factors.md",
            module: "src/form_factor",
            figure: "pictures/form-factors-view.snap.png",
            test: ("tests/factors/methods.rs", "every_method_keeps_its_word"),
            lab: Some("labs/lambert.md"),
        }),
    },
    Row {
        topic: "the pipeline: elements, factors, system, picture; independent of the view",
        title: "The pipeline",
        lab: false,
        state: State::Done(Written {
            page: "pipeline.md",
            module: "src/field/classical.rs",
            figure: "pictures/pipeline-flat.snap.png",
            test: ("book/tests/pictures/equation.rs", "the_stages_hand_on_pictures"),
            lab: None,
        }),
    },
    Row {
        topic: "the final view by a z-buffer (a walk through the scene is not here yet)",
        title: "The picture",
        lab: false,
        state: State::Done(Written {
            page: "the-picture.md",
            module: "src/raster",
            figure: "pictures/picture-smooth.snap.png",
            test: ("tests/files/film.rs", "smooth_shading_is_correct_in_perspective"),
            lab: None,
        }),
    },
    Row {
        topic: "hemicube: render the scene onto half a cube, ids instead of colours",
        title: "The hemicube",
        lab: true,
        state: State::Done(Written {
            page: "hemicube.md",
            module: "src/form_factor/hemicube.rs",
            figure: "pictures/hemicube-items-64.snap.png",
            test: ("tests/factors/hemicube.rs", "the_opposite_square_is_found"),
            lab: Some("labs/hemicube.md"),
        }),
    },
    Row {
        topic: "substructuring: split near lights and at shadow boundaries",
        title: "Patches and elements",
        lab: true,
        state: State::Done(Written {
            page: "patches-and-elements.md",
            module: "src/mesh/split.rs",
            figure: "pictures/patches-round-2.snap.png",
            test: (
                "tests/solving/substructure.rs",
                "the_oracle_marks_shadow_edges_and_stops",
            ),
            lab: Some("labs/substructure.md"),
        }),
    },
    Row {
        topic: "substructuring: factors from elements to patches; cost O(mn)",
        title: "Patches and elements",
        lab: true,
        state: State::Done(Written {
            page: "patches-and-elements.md",
            module: "src/solve/substructure.rs",
            figure: "pictures/patches-round-0.snap.png",
            test: (
                "tests/solving/substructure.rs",
                "a_patch_is_the_mean_of_its_elements",
            ),
            lab: Some("labs/substructure.md"),
        }),
    },
    Row {
        topic: "progressive solution: shoot from the brightest element",
        title: "Progressive refinement",
        lab: true,
        state: State::Done(Written {
            page: "progressive-refinement.md",
            module: "src/solve/shoot.rs",
            figure: "pictures/progressive-after-10.snap.png",
            test: (
                "tests/tables/radiosity.rs",
                "shooting_goes_step_by_step_as_published",
            ),
            lab: Some("labs/shoot.md"),
        }),
    },
    Row {
        topic: "optimisation: iterate over emitting elements only",
        title: "Only what still shines",
        lab: false,
        state: State::Done(Written {
            page: "only-what-shines.md",
            module: "src/solve/overshoot.rs",
            figure: "pictures/shines-map.snap.png",
            test: ("book/tests/pictures/shooting.rs", "few_emit_at_first"),
            lab: None,
        }),
    },
    Row {
        topic: "kinds of light transport: diffuse and specular, in every order",
        title: "Who carries which light?",
        lab: false,
        state: State::Done(Written {
            page: "who-carries-which-light.md",
            module: "src/trace/classes.rs",
            figure: "pictures/transport-classes.snap.png",
            test: (
                "tests/tracing/classes.rs",
                "both_passes_find_class_by_class_what_paths_find",
            ),
            lab: None,
        }),
    },
    Row {
        topic: "specular radiosity: the full BRDF in place of the albedo",
        title: "Why not specular radiosity?",
        lab: false,
        state: State::Done(Written {
            page: "why-not-specular-radiosity.md",
            module: "src/directional",
            figure: "pictures/directional-floor.snap.png",
            test: ("tests/solving/directional.rs", "it_converges_to_path_tracing"),
            lab: None,
        }),
    },
    Row {
        topic: "two-pass, pass 1: translucent surfaces and the window form factor",
        title: "Mirrors and windows",
        lab: true,
        state: State::Done(Written {
            page: "mirrors-and-windows.md",
            module: "src/virtual_world/sight.rs",
            figure: "pictures/mirrors-hemicube.snap.png",
            test: ("tests/tables/mirror.rs", "a_pane_weakens_by_the_angle"),
            lab: Some("labs/window.md"),
        }),
    },
    Row {
        topic: "two-pass, pass 1: mirrors and the virtual mirror world",
        title: "Mirrors and windows",
        lab: true,
        state: State::Done(Written {
            page: "mirrors-and-windows.md",
            module: "src/virtual_world",
            figure: "pictures/mirrors-hemicube.snap.png",
            test: (
                "tests/factors/extended_factors.rs",
                "a_room_with_a_perfect_mirror_is_the_doubled_room",
            ),
            lab: Some("labs/mirror-world.md"),
        }),
    },
    Row {
        topic: "pass 2: ray tracing with reflection, refraction and diffuse light",
        title: "The second pass",
        lab: true,
        state: State::Done(Written {
            page: "the-second-pass.md",
            module: "src/trace/whitted.rs",
            figure: "pictures/second-pass-classical.snap.png",
            test: ("tests/tracing/rays.rs", "a_hall_of_mirrors_is_a_geometric_series"),
            lab: Some("labs/cone.md"),
        }),
    },
    Row {
        topic: "pass 2: diffuse light into specular surfaces, by a cone",
        title: "The second pass",
        lab: true,
        state: State::Done(Written {
            page: "the-second-pass.md",
            module: "src/trace/cone.rs",
            figure: "pictures/second-pass-gloss-1.snap.png",
            test: (
                "tests/stability/rays.rs",
                "row_70_a_lamp_half_in_the_cone_counts_half",
            ),
            lab: Some("labs/cone.md"),
        }),
    },
    Row {
        topic: "image-based light: rays that leave take the colour of a sky sphere",
        title: "Light from the sky",
        lab: true,
        state: State::Done(Written {
            page: "light-from-the-sky.md",
            module: "src/sky",
            figure: "pictures/sky-court-2.snap.png",
            test: ("tests/stability/sky.rs", "row_75_a_sun_in_one_texel"),
            lab: Some("labs/sky.md"),
        }),
    },
    Row {
        topic: "comparison pictures: radiosity, ray tracing, two-pass",
        title: "Side by side",
        lab: false,
        state: State::Done(Written {
            page: "side-by-side.md",
            module: "src/chart/side_by_side.rs",
            figure: "pictures/side-two-pass.snap.png",
            test: ("tests/chart/side_by_side.rs", "only_two_passes_show_all_light"),
            lab: None,
        }),
    },
    planned(
        "the students' virtual world: texture, Bézier or NURBS, picking",
        "A virtual world of your own",
        true,
    ),
];
