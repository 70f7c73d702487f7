//! The order of the modules is the order of the lecture, but where a use forces another.

use crate::{code, files_of, head_of, modules, read};

/// The first lecture row that a module's header names; `None` where it is beyond the
/// lecture.
fn first_row(module: &str) -> Option<u32> {
    let source = read(&head_of(module));
    let header = source.lines().map_while(|line| line.strip_prefix("//!"));
    let header: String = header.collect();
    let row = header.split("(L").nth(1)?;
    row.chars().take_while(char::is_ascii_digit).collect::<String>().parse().ok()
}

/// Does a file of `module` use `other`?
fn uses(module: &str, other: &str) -> bool {
    let named = format!("crate::{other}");
    files_of(module).iter().any(|file| {
        let source = read(file);
        code(&source).any(|(_, line)| {
            line.match_indices(&named).any(|(at, _)| {
                let rest = &line[at + named.len()..];
                !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_')
            })
        })
    })
}

/// Modules that stand before their row's turn, and who needs them there. This list may only
/// shrink.
const EARLY: [(&str, &str); 8] = [
    ("texture", "obj"),        // a face may bear a picture
    ("sky", "scene"),          // a scene may have one
    ("scene", "form_factor"),  // blockers are its surfaces
    ("mesh", "form_factor"),   // rows are of elements
    ("raster", "form_factor"), // hemicubes are drawn
    ("visibility", "solve"),   // what leaves over links is counted by rays
    ("occlusion", "solve"),    // links ask what stands between
    ("form_factor", "solve"),  // the matrix of the equation
];

/// Whoever reads `lib.rs` from the top meets the lecture's topics in the lecture's order.
#[test]
fn chapters_ascend() {
    let order = modules();
    let place = |module: &str| order.iter().position(|m| m == module);
    for (early, user) in EARLY {
        let (at, needed) = (place(early), place(user));
        assert!(at.is_some() && at < needed, "{early} is not early for {user}");
        assert!(uses(user, early), "{user} does without {early}: take the pair out");
        assert!(first_row(early) > first_row(user), "{early} is in its turn");
    }
    let in_turn = order.iter().filter(|m| EARLY.iter().all(|(early, _)| early != m));
    let rows: Vec<(&String, u32)> =
        in_turn.filter_map(|m| Some((m, first_row(m)?))).collect();
    assert!(rows.len() >= 10, "{rows:?}");
    for pair in rows.windows(2) {
        assert!(pair[0].1 <= pair[1].1, "{:?} stands before {:?}", pair[0], pair[1]);
    }
    let [solving, mirrors] = ["solve", "virtual_world"].map(place);
    assert!(solving < mirrors, "the equation comes before mirrors");
}
