//! The ways of making a picture, and their comparison.

use super::Folder;
use super::refused::refused;
use serde_json::Value;

/// A scene in which nothing shines needs no second pass; any other gets one.
#[test]
fn the_method_is_chosen_by_what_the_scene_has() {
    let folder = Folder::new();
    let method = |arguments: &str| {
        let arguments =
            format!("render {arguments} -o x.png --size 16x16 --tolerance 30% --json");
        let mut json = folder.run(&arguments).done().json();
        json["method"].take()
    };
    assert_eq!(method("furnace"), "radiosity");
    assert_eq!(method("facing-squares"), "radiosity");
    assert_eq!(method("facing-squares --sky uniform:1,1,1"), "two-pass");
    assert_eq!(method("mirror-room"), "two-pass");
    assert_eq!(method("mirror-room --shading flat"), "radiosity");
    assert_eq!(method("mirror-room --method ray-trace"), "ray-trace");
}

/// All four, in the furnace: `L = 2/π` for those that follow all light, and 1.5/π for
/// classical ray tracing, which sees only the first bounce.
#[test]
fn every_method_shows_the_light_that_it_follows() {
    let folder = Folder::new();
    for (method, b) in
        [("radiosity", 2.0), ("two-pass", 2.0), ("path-trace", 2.0), ("ray-trace", 1.5)]
    {
        let arguments = format!(
            "render furnace -o {method}.exr --size 12x12 --method {method} --samples 100 \
             --json"
        );
        let json = folder.run(&arguments).done().json();
        assert_eq!((&json["method"], &json["samples"]), (&method.into(), &100.into()));
        assert_eq!(
            json.contains_key("ledger"),
            !["path-trace", "ray-trace"].contains(&method)
        );
        assert_eq!(json["noise"].is_number(), method == "path-trace");
        let picture = image::open(folder.path().join(format!("{method}.exr"))).unwrap();
        let pixels = picture.to_rgb32f();
        let mean = pixels.pixels().map(|p| f64::from(p[0])).sum::<f64>() / 144.0;
        let expected = b / std::f64::consts::PI;
        assert!((mean / expected - 1.0).abs() < 0.02, "{method}: {mean} {expected}");
    }
}

/// The table of `--classes`: each class has an owner, the mirror shows what pass 2 follows.
/// It costs rays of its own, so nothing is traced for it unless it is asked for.
#[test]
fn a_picture_tells_whose_light_it_shows_when_asked() {
    let folder = Folder::new();
    let arguments = "render mirror-room -o x.png --size 16x16 --tolerance 30%";
    let plain = folder.run(&format!("{arguments} --json")).done().json();
    assert!(!plain.contains_key("paths"));
    let text = folder.run(&format!("{arguments} --classes")).done().out;
    assert!(text.contains("whose light it shows") && text.contains("EDS⁺L"), "{text}");
    let json = folder.run(&format!("{arguments} --classes --json")).done().json();
    let paths = json["paths"].as_array().expect("a table");
    assert_eq!(paths.len(), 10);
    let mean = |word: &str| {
        let row = paths.iter().find(|row| row["paths"] == word).expect(word);
        assert!(row["owner"].as_str().is_some_and(|owner| owner.contains("pass")));
        row["mean"][1].as_f64().expect("a number")
    };
    assert!(mean("EDL") > 0.0 && mean("ES⁺DL") > 0.0 && mean("EDS⁺L") > 0.0);
}

#[test]
fn what_a_method_cannot_show_is_refused() {
    let folder = Folder::new();
    let no = |options: &str, words: &[&str]| {
        let arguments = format!("render mirror-room -o old.png {options}");
        refused(&folder, &arguments, words);
    };
    no("--method two-pass --shading flat", &["--shading flat", "radiosity"]);
    no("--method ray-trace --view error", &["--view error", "radiosity"]);
    no("--method path-trace --view mesh", &["--view mesh", "two-pass"]);
    no("--samples 0", &["--samples 0"]);
    no("--samples 99999999", &["--samples 99999999"]);
    refused(&folder, "compare furnace --samples 1", &["--samples 1"]);
    refused(&folder, "compare nowhere", &["`nowhere`"]);
}

/// A sheet that a lamp shines on from behind: dark, but for those who read it two-sided.
#[test]
fn two_sided_faces_reflect_behind() {
    let folder = Folder::new();
    folder.write("a.mtl", "newmtl lamp\nKe 1 1 1\nnewmtl grey\nKd .5 .5 .5\n");
    // The lamp at z = 1 looks down on the back of the sheet at z = 0.
    let squares =
        "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nv 0 0 1\nv 0 1 1\nv 1 1 1\nv 1 0 1\n";
    let faces = "usemtl grey\nf 1 2 3 4\nusemtl lamp\nf 5 6 7 8\n";
    folder.write("a.obj", format!("mtllib a.mtl\n{squares}{faces}"));
    let brightest = |options: &str| {
        let view = "--eye 0.5,0.1,0.9 --target 0.5,0.5,0 --size 8x8 --exposure 1";
        folder.run(&format!("render a.obj -o x.png {view} {options}")).done();
        let picture = image::open(folder.path().join("x.png")).unwrap().to_rgb8();
        picture.pixels().map(|p| p[0]).max().unwrap()
    };
    assert_eq!(brightest(""), 0);
    assert!(brightest("--two-sided") > 20);
}

#[test]
fn compare_writes_a_page_with_all_that_it_shows() {
    let folder = Folder::new();
    let arguments =
        "compare mirror-room --size 24x24 --samples 16 --tolerance 20% --json";
    let json = folder.run(arguments).done().json();
    let methods = json["methods"].as_array().expect("methods");
    let names =
        ["classical-radiosity", "ray-tracing", "radiosity", "two-pass", "reference"];
    assert_eq!(methods.iter().map(|m| &m["method"]).collect::<Vec<_>>(), names);
    let number = |name: &str, key: &str| {
        let method = methods.iter().find(|m| m["method"] == name).expect(name);
        method[key].as_f64().unwrap_or_else(|| panic!("{name} {key}"))
    };
    // Only the two-pass picture is right, but for the noise of few paths.
    let right = number("two-pass", "rms");
    for name in ["classical-radiosity", "ray-tracing", "radiosity"] {
        assert!(number(name, "rms") > 1.2 * right, "{name}: {methods:?}");
        assert!(number(name, "cpu_seconds") > 0.0);
    }
    assert!((number("two-pass", "brightness") - 1.0).abs() < 0.1);
    assert!(number("radiosity", "brightness") < 0.8);
    let page = folder.text("out/compare/index.html");
    let files = json["files"].as_array().expect("files");
    for file in files.iter().filter_map(Value::as_str).filter(|f| f.ends_with(".png")) {
        let name = file.rsplit('/').next().expect("a name");
        assert!(page.contains(&format!("src=\"{name}\"")), "{name}");
        let picture = image::open(folder.path().join(file)).expect(file);
        assert_eq!((picture.width(), picture.height()), (24, 24));
    }
    assert_eq!(page.matches("<img").count(), page.matches("alt=\"").count());
    let table = folder.text("out/compare/compare.csv");
    assert_eq!(table.lines().filter(|line| !line.starts_with('#')).count(), 6);
}

/// Where no chain of reflections is longer, `--levels` asks for no more work.
#[test]
fn levels_beyond_the_longest_chain_cost_nothing() {
    let folder = Folder::new();
    let solve = |name: &str, levels: u32| {
        let how = "--method gather --tolerance 50% --quiet";
        let levels = format!("--levels {levels}");
        folder.run(&format!("solve mirror-room -o {name} {how} {levels}")).done();
        folder.read(name)
    };
    assert!(solve("a.csv", 4) == solve("b.csv", u32::MAX));
}
