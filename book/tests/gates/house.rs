//! The appendix *The house* says of each module where light meets it.

use book::house::{modules, page_of};
use book::source::summary;

const PAGE: &str = include_str!("../../src/the-house.md");

#[test]
fn light_meets_every_module() {
    let modules = modules();
    assert!(modules.len() > 20, "{} modules", modules.len());
    for module in &modules {
        let link = format!("](#house-{})", module.name);
        assert!(
            PAGE.contains(&link),
            "the-house.md does not say where `{}` is",
            module.name
        );
    }
    for name in
        PAGE.split("](#house-").skip(1).filter_map(|rest| rest.split(')').next())
    {
        let there = modules.iter().any(|module| module.name == name);
        assert!(there, "the-house.md speaks of `{name}`, which is no module");
    }
}

#[test]
fn arcs_lead_up_and_headers_name_chapters() {
    let entries = summary(include_str!("../../src/SUMMARY.md"));
    for (k, module) in modules().iter().enumerate() {
        assert!(
            module.uses.iter().all(|&used| used < k),
            "`{}` looks down",
            module.name
        );
        for chapter in &module.chapters {
            let page = page_of(&entries, chapter);
            assert!(page.is_some(), "`{}` names no chapter: {chapter}", module.name);
        }
    }
}
