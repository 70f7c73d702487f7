//! One of each: names, readers of materials, and what a room makes ready.

use crate::{code, name, read, root, rust_files};
use radiosity::plan::Plan;
use radiosity::room::{Built, Room};
use radiosity::scene::built_in;
use radiosity::solution::Goal;
use radiosity::trace::{Look, TwoPass};
use radiosity::work::Work;
use std::collections::HashMap;

/// The files of the library: the command is another crate.
fn library() -> Vec<std::path::PathBuf> {
    let of_command = root().join("src/command");
    let files = rust_files("src").into_iter();
    let files: Vec<_> = files
        .filter(|f| !f.starts_with(&of_command) && !f.ends_with("src/main.rs"))
        .collect();
    assert!(files.len() > 100, "{}", files.len());
    files
}

/// Whoever greps for a type finds one.
#[test]
fn type_names_are_unique() {
    let mut known: HashMap<String, String> = HashMap::new();
    let mut twice = Vec::new();
    for file in library() {
        let source = read(&file);
        for (line, text) in code(&source) {
            // Associated types are indented.
            let text = text.strip_prefix("pub(crate) ").unwrap_or(text);
            let text = text.strip_prefix("pub(super) ").unwrap_or(text);
            let text = text.strip_prefix("pub ").unwrap_or(text);
            let kinds = ["struct ", "enum ", "trait ", "type "];
            let Some(rest) = kinds.iter().find_map(|k| text.strip_prefix(k)) else {
                continue;
            };
            let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
            let place = format!("{}:{line}", name(&file));
            if let Some(other) = known.insert(rest[..end].into(), place.clone()) {
                twice.push(format!("{}: {other} and {place}", &rest[..end]));
            }
        }
    }
    assert!(known.len() > 200, "{}", known.len());
    assert!(twice.is_empty(), "{} names twice:\n{}", twice.len(), twice.join("\n"));
}

/// What a surface does to a ray is read in one place, beside where materials are made and
/// files are read and written.
#[test]
fn what_shines_is_read_in_one_place() {
    let readers = [
        "src/material/",
        "src/ways/",
        "src/obj/",
        "src/scene/",
        "src/chart/suites/directional.rs", // which makes a gloss
    ];
    for file in library() {
        let place = name(&file);
        if readers.iter().any(|reader| place.starts_with(reader)) {
            continue;
        }
        let source = read(&file);
        for (line, text) in code(&source) {
            assert!(!text.contains("Shine::"), "{place}:{line}: {}", text.trim());
        }
    }
}

/// The loop that refines until it is certified stands once.
#[test]
fn one_loop_refines_until_certified() {
    let certifies = |file: &std::path::PathBuf| {
        let source = read(file);
        let found = code(&source).any(|(_, line)| line.contains(".finer("));
        found.then(|| name(file))
    };
    let loops: Vec<String> = library().iter().filter_map(certifies).collect();
    assert_eq!(loops, ["src/solution/mod.rs"]);
}

/// A room is made ready once, however many attempts a solution takes and whoever looks at
/// it then.
#[test]
fn a_room_is_made_ready_once() {
    for scene in ["cornell-mirror", "sky-room"] {
        let scene = built_in(scene).unwrap();
        let room = Room::of(&scene);
        let goal = Goal::within(0.05);
        let done = Plan::of(&room, goal.tolerance).run(&room, &goal, &Work::quiet());
        let solution = done.unwrap().solution;
        let eye = TwoPass::of(&room, &solution.field, Look::default());
        let camera = scene.camera;
        let shot = radiosity::film::Shot { camera, width: 8, height: 8, samples: 1 };
        let _ = eye.picture(&shot, &|_, _, _| {});
        let Built { visibility, solids, lamps } = room.built();
        assert_eq!((visibility, solids, lamps), (1, 1, 1));
    }
    // Nobody makes for himself what the room has. Form factors that are asked for alone,
    // without a room, make their own.
    let makers =
        ["Visibility::new(", "Blockers::of(", "Direct::of(", "VirtualWorld::of("];
    let own = [
        "src/room/",
        "src/visibility.rs",
        "src/occlusion/",
        "src/form_factor/",
        "src/virtual_world/",
        "src/directional/",
        "src/ways/",
        "src/solve/hierarchy/",
        "src/field/classical.rs",
        "src/chart/",
    ];
    for file in library() {
        let place = name(&file);
        if own.iter().any(|start| place.starts_with(start)) {
            continue;
        }
        let source = read(&file);
        for (line, text) in code(&source) {
            let made = makers.iter().find(|maker| text.contains(**maker));
            assert!(made.is_none(), "{place}:{line}: {}", text.trim());
        }
    }
}

/// The judge uses nothing of what it judges: the scene, its rays, the rules where they meet
/// something, and a mesh to name places.
#[test]
fn the_certificate_is_independent() {
    let may = [
        "geometry",
        "material",
        "mesh",
        "radiometry",
        "random",
        "scene",
        "sky",
        "visibility",
        "ways",
    ];
    let files = rust_files("src/certificate");
    assert!(files.len() >= 8, "{}", files.len());
    for file in files {
        for (line, text) in code(&read(&file)) {
            for (at, _) in text.match_indices("crate::") {
                let rest = &text[at + "crate::".len()..];
                let used =
                    rest.split(|c: char| !c.is_alphanumeric() && c != '_').next();
                let used = used.unwrap_or_default();
                assert!(may.contains(&used), "{}:{line} uses {used}", name(&file));
            }
        }
    }
}
