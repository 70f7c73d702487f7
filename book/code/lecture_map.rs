//! The lecture map: which page, figure, test and lab stands for which row of the lecture.
//!
//! [`ROWS`] is the data; [`page`] writes it as the book's appendix, and
//! [`Row::faults`] holds every claim in it against the files.

use crate::source;
use std::fs;
use std::path::{Path, PathBuf};

/// One row of the lecture.
pub struct Row {
    /// What the lecture treats there.
    pub topic: &'static str,
    /// The chapter's title in `SUMMARY.md`.
    pub title: &'static str,
    /// Does the lecture set a lab here?
    pub lab: bool,
    /// What there is of it.
    pub state: State,
}

/// How far a row has come.
pub enum State {
    /// The chapter is yet to be written.
    Planned,
    /// Written, drawn and tested.
    Done(Written),
}

/// Where the parts of a written row are, as paths from the repository's root, the pages
/// and pictures as paths from `book/src`.
pub struct Written {
    /// The chapter.
    pub page: &'static str,
    /// The module that does what the chapter says.
    pub module: &'static str,
    /// A figure of the chapter, made by the code.
    pub figure: &'static str,
    /// A test of the method: file and function.
    pub test: (&'static str, &'static str),
    /// The lab's brief, where there is one.
    pub lab: Option<&'static str>,
}

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
            module: "src/solution/classical.rs",
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

impl Row {
    /// What a row claims and the files do not hold; `root` is the repository's.
    pub fn faults(&self, root: &Path) -> Vec<String> {
        let State::Done(written) = &self.state else { return Vec::new() };
        let src = root.join("book/src");
        let read = |path: PathBuf| fs::read_to_string(path).unwrap_or_default();
        let text = read(src.join(written.page));
        let folder = src.join(written.page);
        let mut faults = source::chapter_faults(folder.parent().unwrap_or(&src), &text);
        if !src.join(written.figure).is_file() || !text.contains(written.figure) {
            faults.push(format!("the page does not show {}", written.figure));
        }
        if !root.join(written.module).exists() {
            faults.push(format!("no module {}", written.module));
        }
        let (file, name) = written.test;
        if !read(root.join(file)).contains(&format!("fn {name}(")) {
            faults.push(format!("no test `{name}` in {file}"));
        }
        if let Some(lab) = written.lab
            && !(self.lab && src.join(lab).is_file() && text.contains(lab))
        {
            faults.push(format!("no lab {lab}, or the page does not link it"));
        }
        faults.into_iter().map(|fault| format!("{}: {fault}", self.title)).collect()
    }
}

/// The appendix, as Markdown.
pub fn page() -> String {
    let done = ROWS.iter().filter(|row| matches!(row.state, State::Done(_))).count();
    let mut text = format!(
        "# Lecture map\n\n<!-- Written by `cargo run -p book --bin generate`. -->\n\n\
         The course follows one university lecture, row by row. **{done} of {} rows** \
         are written; the others say so.\n\n\
         | row | the lecture's topic, and the chapter | code, figure, test | lab |\n\
         |---|---|---|---|\n",
        ROWS.len()
    );
    for (index, row) in ROWS.iter().enumerate() {
        text.push_str(&line(index + 1, row));
    }
    text
}

fn line(number: usize, row: &Row) -> String {
    let lab = match (&row.state, row.lab) {
        (State::Done(Written { lab: Some(page), .. }), _) => format!("[brief]({page})"),
        (_, true) => "not written".into(),
        (_, false) => "—".into(),
    };
    let start = format!("| L{number:02} | {}:<br>", row.topic);
    match &row.state {
        State::Planned => {
            format!("{start} *{}*, not written | | {lab} |\n", row.title)
        }
        State::Done(Written { page, module, figure, test: (file, name), .. }) => {
            format!(
                "{start} [{}]({page}) | `{module}`,<br>[a figure]({figure}),<br>\
                 `{name}` in<br>`{file}` | {lab} |\n",
                row.title
            )
        }
    }
}
