//! `radiosity chart`: a suite writes its table, dated, and its charts; twice the same but
//! for time and memory.

use super::Folder;
use radiosity::chart::{Trial, read, suite};

fn trials(folder: &Folder) -> Vec<Trial> {
    let told = read(&folder.text("out/light.csv"));
    told.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_suite_writes_its_table_and_its_charts() {
    let folder = Folder::new();
    let object = folder.run("chart light -o out --json").done().json();
    let suite = suite("light").expect("the suite is there");
    for view in suite.views {
        let svg = folder.text(&format!("out/{}.svg", view.file));
        assert!(svg.starts_with("<svg") && svg.contains("<desc>"), "{}", view.file);
    }
    let first = trials(&folder);
    assert_eq!(object["suites"][0]["suite"], "light");
    let told = object["suites"][0]["trials"].as_array().map_or(0, Vec::len);
    assert_eq!(told, first.len());
    assert!(first.iter().all(|t| t.seconds > 0.0 && t.runs > 0), "{first:?}");
    let table = folder.text("out/light.csv");
    assert!(table.contains("radiosity chart light") && table.contains(" on 20"));
    // Errors and work are results, and the same again; times are not.
    folder.run("chart light -o out --quiet");
    let untimed = |t: &Trial| Trial { seconds: 0.0, runs: 0, memory: 0, ..t.clone() };
    let [first, second] =
        [first, trials(&folder)].map(|all| all.iter().map(untimed).collect::<Vec<_>>());
    assert_eq!(first, second);
}

/// Pictures for slides, where the build has what draws them; else it says how to get it,
/// before anything is measured.
#[test]
fn pictures_for_slides_are_a_feature() {
    let folder = Folder::new();
    let answer = folder.run("chart light -o out --png");
    if cfg!(feature = "png") {
        for view in suite("light").expect("the suite is there").views {
            let png = folder.read(&format!("out/{}.png", view.file));
            assert_eq!(image_size(&png), (1400, 800), "{}", view.file);
        }
    } else {
        assert_eq!(answer.code, Some(1));
        assert!(answer.err.contains("--features png"), "{}", answer.err);
        assert!(folder.names().is_empty());
    }
}

fn image_size(png: &[u8]) -> (u32, u32) {
    let image = image::load_from_memory(png).expect("a PNG");
    (image.width(), image.height())
}

/// What cannot be is told in a sentence, and nothing is written.
#[test]
fn no_suite_and_no_folder() {
    let folder = Folder::new();
    let unknown = folder.run("chart everything");
    assert_eq!(unknown.code, Some(2));
    assert!(unknown.err.contains("form-factors"), "{}", unknown.err);
    folder.write("taken", "a file");
    let taken = folder.run("chart light -o taken");
    assert_eq!(taken.code, Some(1));
    assert!(taken.err.contains("taken") && taken.err.contains("-o"), "{}", taken.err);
    assert_eq!(folder.names(), ["taken"]);
}
