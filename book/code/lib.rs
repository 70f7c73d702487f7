//! Figures, examples and gates of the book *Light, Patch by Patch*.
//!
//! | module          | holds                                                        |
//! |-----------------|--------------------------------------------------------------|
//! | [`source`]      | gates over the Markdown: includes, fences, sections          |
//! | [`html`]        | gates over the built pages: links, ids, nothing from outside |
//! | [`lecture_map`] | which page, figure, test and lab stands for which row        |
//! | [`generated`]   | the files of `book/src` that a program writes                |
//! | [`chart`]       | speed against accuracy, as SVG                               |
//! | [`display`]     | figures and numbers of *The picture*                         |
//! | [`directional`] | figures and numbers of *Why not specular radiosity?*        |
//! | [`cornell`]     | the picture on the first page                                |
//! | [`map`]         | a number for each pixel, in false colour                     |
//! | [`house`]       | the modules of the crate, and who uses whom                  |
//! | [`ledger`]      | where the light went, as a table                             |
//! | [`light`]       | figures and numbers of the chapters L01 to L03               |
//! | [`links`]       | figures and numbers of the page on hierarchical links        |
//! | [`equation`]    | figures and numbers of *The radiosity equation*              |
//! | [`pipeline`]    | figures and numbers of *The pipeline*                        |
//! | [`factors`]     | figures and numbers of the chapter on form factors           |
//! | [`failures`]    | the gallery of *Where methods fail*                          |
//! | [`surface`]     | figures and numbers of the chapters L04 and L05              |
//! | [`shooting`]    | figures and numbers of the chapters on shooting, L13 and L14 |
//! | [`certificate`] | figures and numbers of *How wrong is it?*                     |
//! | [`sky`]         | figures and numbers of *Light from the sky*                  |
//! | [`solving`]     | figures and numbers of the chapter *Solving it*              |
//! | [`plan`]        | figures and numbers of *What does this scene need?*          |
//! | [`mirrors`]     | figures and numbers of *Mirrors and windows*                 |
//! | [`side_by_side`] | figures and numbers of *Side by side*                       |
//! | [`versus`]      | figures and numbers of *Speed against accuracy*              |
//! | [`timing`]      | time and error of a call, for the charts                     |
//! | [`hemicube`]    | figures and numbers of the chapter                           |
//! | [`patches`]     | figures and numbers of the chapter on substructuring         |
//! | [`transport`]   | figures and numbers of *Who carries which light?*            |
//!
//! `cargo test -p book` runs the gates over the sources and every example of every page;
//! `cargo run -p book --bin check -- book/book` runs those over the built book.
#![forbid(unsafe_code)]

pub mod certificate;
pub mod chart;
pub mod cornell;
pub mod directional;
pub mod display;
pub mod equation;
pub mod factors;
pub mod failures;
pub mod generated;
pub mod hemicube;
pub mod house;
pub mod html;
pub mod ledger;
pub mod lecture_map;
pub mod light;
pub mod links;
pub mod map;
pub mod mirrors;
pub mod patches;
pub mod pipeline;
pub mod plan;
pub mod shooting;
pub mod second_pass;
pub mod sky;
pub mod side_by_side;
pub mod solving;
pub mod source;
pub mod surface;
pub mod timing;
pub mod transport;
pub mod versus;

/// Every page of the book, so that `cargo test` runs its examples.
#[cfg(doctest)]
mod pages {
    macro_rules! pages {
        ($($name:ident: $page:literal,)*) => {
            $(#[doc = include_str!(concat!("../src/", $page))] mod $name {})*
        };
    }
    pages! {
        index: "index.md",
        speed_against_accuracy: "speed-against-accuracy.md",
        assumptions: "assumptions.md",
        solid_angle: "solid-angle.md",
        radiometry: "radiometry.md",
        brdf: "brdf.md",
        albedo: "albedo.md",
        radiosity_equation: "radiosity-equation.md",
        how_wrong: "how-wrong.md",
        form_factors: "form-factors.md",
        pipeline: "pipeline.md",
        the_picture: "the-picture.md",
        hemicube: "hemicube.md",
        patches_and_elements: "patches-and-elements.md",
        hierarchy: "hierarchy.md",
        progressive_refinement: "progressive-refinement.md",
        only_what_shines: "only-what-shines.md",
        what_it_needs: "what-it-needs.md",
        who_carries_which_light: "who-carries-which-light.md",
        light_from_the_sky: "light-from-the-sky.md",
        side_by_side: "side-by-side.md",
        labs_solid_angle: "labs/solid-angle.md",
        labs_radiometry: "labs/radiometry.md",
        labs_brdf: "labs/brdf.md",
        labs_gather: "labs/gather.md",
        labs_lambert: "labs/lambert.md",
        labs_sampling: "labs/sampling.md",
        labs_hemicube: "labs/hemicube.md",
        labs_substructure: "labs/substructure.md",
        labs_shoot: "labs/shoot.md",
        labs_certify: "labs/certify.md",
        labs_sky: "labs/sky.md",
        labs_mirror_world: "labs/mirror-world.md",
        labs_window: "labs/window.md",
        labs_cone: "labs/cone.md",
        labs_race: "labs/race.md",
        labs_break_it: "labs/break-it.md",
        mirrors_and_windows: "mirrors-and-windows.md",
        solving: "solving.md",
        the_second_pass: "the-second-pass.md",
        why_not_specular_radiosity: "why-not-specular-radiosity.md",
        where_methods_fail: "where-methods-fail.md",
        failures_form_factors: "failures-form-factors.md",
        failures_hemicube: "failures-hemicube.md",
        failures_visibility: "failures-visibility.md",
        failures_meshing: "failures-meshing.md",
        failures_solvers: "failures-solvers.md",
        failures_second_pass: "failures-second-pass.md",
        failures_display: "failures-display.md",
        notation: "notation.md",
        bibliography: "bibliography.md",
        lecture_map: "lecture-map.md",
        the_house: "the-house.md",
    }
}
