//! What cannot be done is refused in one sentence, and nothing is written.

use super::{Answer, Folder};

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// A scene whose lamp `extra` statements follow.
fn lit(extra: &str) -> String {
    format!("mtllib a.mtl\n{SQUARE}usemtl lamp\nf 1 2 3 4\n{extra}")
}

const LAMP: &str = "newmtl lamp\nKe 1 1 1\n";

/// `arguments` must be refused with exit code 1 and one line that holds all of `words`;
/// an older output file stays as it is.
pub fn refused(folder: &Folder, arguments: &str, words: &[&str]) {
    let outputs = ["old.csv", "old.png", "old.npy"];
    outputs.iter().for_each(|name| folder.write(name, "as it was"));
    let before = folder.names();
    let Answer { code, out, err } = folder.run(arguments);
    let seen = format!("radiosity {arguments}: {code:?}\n{out}\n{err}");
    assert_eq!(code, Some(1), "{seen}");
    assert_eq!(out, "", "{seen}");
    assert_eq!(err.lines().count(), 1, "{seen}");
    assert!(err.starts_with("error: ") && !err.contains("panicked"), "{seen}");
    assert!(words.iter().all(|word| err.contains(word)), "{words:?} in {seen}");
    assert_eq!(folder.names(), before, "{seen}");
    outputs
        .iter()
        .for_each(|name| assert_eq!(folder.text(name), "as it was", "{seen}"));
}

/// A file that no verb takes.
fn bad_file(obj: impl AsRef<[u8]>, mtl: &str, words: &[&str]) {
    let folder = Folder::new();
    folder.write("a.obj", obj);
    folder.write("a.mtl", mtl);
    refused(&folder, "solve a.obj -o old.csv", words);
    refused(&folder, "render a.obj -o old.png --json", words);
    refused(&folder, "form-factors a.obj -o old.npy --quiet", words);
}

#[test]
fn a_missing_file() {
    let folder = Folder::new();
    refused(&folder, "solve gone.obj -o old.csv", &["gone.obj", "check the path"]);
    refused(&folder, "render no/room.obj -o old.png", &["no/room.obj"]);
    refused(&folder, "form-factors gone.obj -o old.npy", &["gone.obj"]);
}

#[test]
fn a_name_that_is_no_scene() {
    let folder = Folder::new();
    let words = ["`cornel`", "cornell-regular", ".obj"];
    refused(&folder, "solve cornel -o old.csv", &words);
    refused(&folder, "solve furnace:1 -o old.csv", &["furnace:1", "[0, 1)"]);
    refused(&folder, "explain cornel", &words);
    refused(&folder, "explain cornell --tolerance 0", &["--tolerance 0"]);
    refused(&folder, "explain cornell --tolerance=-1% --run", &["--tolerance -0.01"]);
}

#[test]
fn an_edge_that_makes_no_elements() {
    let folder = Folder::new();
    let no = |edge: &str, words: &[&str]| {
        refused(&folder, &format!("scenes --export new --edge {edge}"), words);
    };
    for edge in ["0", "-0.5", "nan", "inf"] {
        no(edge, &["--edge", "positive"]);
    }
    no("1e-6", &["--edge 0.000001", "elements", "1000000", "longer edge"]);
    no("1e-300", &["elements", "longer edge"]);
    let words = ["`cornel`", "radiosity scenes"];
    refused(&folder, "scenes furnace cornel --export new", &words);
}

#[test]
fn a_file_without_faces() {
    bad_file(
        format!("mtllib a.mtl\n{SQUARE}usemtl lamp\n"),
        LAMP,
        &["a.obj", "has no face"],
    );
}

#[test]
fn a_missing_mtl() {
    let obj = format!("{SQUARE}mtllib gone.mtl\nusemtl lamp\nf 1 2 3 4\n");
    bad_file(obj, LAMP, &["gone.mtl"]);
}

#[test]
fn a_material_that_is_nowhere() {
    bad_file(lit("usemtl oak\nf 4 3 2 1\n"), LAMP, &["a.obj, line 8", "`oak`"]);
}

#[test]
fn a_corner_that_is_out_of_range() {
    bad_file(lit("f 1 2 5\n"), LAMP, &["a.obj, line 8", "5"]);
    bad_file(lit("f 0 1 2\n"), LAMP, &["a.obj, line 8", "0"]);
}

#[test]
fn a_coordinate_that_is_no_number() {
    for value in ["NaN", "inf", "-inf", "1e999", "one"] {
        bad_file(lit(&format!("v 0 {value} 2\n")), LAMP, &["a.obj, line 8", value]);
    }
}

#[test]
fn a_face_without_area() {
    bad_file(lit("v 2 0 0\nf 1 2 5\n"), LAMP, &["a.obj, line 9", "f 1 2 5"]);
}

#[test]
fn a_face_that_crosses_itself() {
    bad_file(lit("f 1 3 2 4\n"), LAMP, &["a.obj, line 8", "f 1 3 2 4"]);
}

#[test]
fn a_material_that_makes_light_of_nothing() {
    let kd = format!("{LAMP}newmtl snow\nKd 0.5 1.2 0.5\n");
    bad_file(lit("usemtl snow\nf 4 3 2 1\n"), &kd, &["a.mtl", "`snow`", "lower Kd"]);
    let sum = format!("{LAMP}newmtl wax\nKd 0.7 0.7 0.7\nKs 0.1 0.4 0.1\n");
    bad_file(lit("usemtl wax\nf 4 3 2 1\n"), &sum, &["a.mtl", "`wax`", "Kd + Td + Ks"]);
}

#[test]
fn a_scene_without_emitter_has_form_factors_but_no_light() {
    let folder = Folder::new();
    folder.write("dark.obj", format!("{SQUARE}f 1 2 3 4\n"));
    let words = ["dark", "Ke", "--sky"];
    refused(&folder, "solve dark.obj -o old.csv --quiet", &words);
    refused(&folder, "render dark.obj -o old.png --quiet", &words);
    let black = "--quiet --sky uniform:0,0,0";
    refused(&folder, &format!("solve dark.obj -o old.csv {black}"), &words);
    refused(&folder, "explain dark.obj --run --quiet", &words);
    folder.run("explain dark.obj").done();
    folder.run("form-factors dark.obj -o F.csv").done();
    assert_eq!(folder.text("F.csv"), "i,j,F\n");
}

#[test]
fn an_empty_file() {
    bad_file("", LAMP, &["a.obj"]);
    bad_file("# nothing\n", LAMP, &["a.obj"]);
}

#[test]
fn binary_garbage() {
    let noise: Vec<u8> = (0..4000u32).map(|k| ((k * k * 31) >> 3) as u8).collect();
    bad_file(noise, LAMP, &["a.obj"]);
    bad_file(lit(""), "\0\u{1}\u{2}newmtl", &["a.mtl"]);
}

#[test]
fn an_absurd_size() {
    let folder = Folder::new();
    for size in
        ["0x0", "0x512", "512x0", "16385x2", "16384x16384", "99999999999999999999x1"]
    {
        let arguments = format!("render cornell -o old.png --size {size}");
        refused(&folder, &arguments, &["--size"]);
    }
}

#[test]
fn numbers_with_which_nothing_can_be_done() {
    let folder = Folder::new();
    for (verb, option, values) in [
        ("solve furnace -o old.csv", "--tolerance", "0 -1 -5% nan inf"),
        ("render furnace -o old.png", "--tolerance", "0 nan"),
        ("form-factors furnace -o old.npy", "--tolerance", "0 -1 nan"),
        ("render furnace -o old.png", "--exposure", "0 -2 nan inf"),
        ("render furnace -o old.png", "--fov", "0 -10 180 nan"),
        ("render furnace -o old.png", "--eye", "nan,0,0 0,inf,0 0.5,0.5,0.5"),
        ("render furnace -o old.png", "--up", "0,0,0 nan,1,0"),
        ("solve furnace -o old.csv", "--up", "0,0,0"),
        ("solve furnace -o old.csv", "--threads", "0 1000000"),
        ("solve furnace -o old.csv --form-factors sampling", "--samples", "0"),
        ("solve furnace -o old.csv", "--samples", "100"),
        ("form-factors furnace -o old.npy --method sampling", "--samples", "0"),
    ] {
        for value in values.split(' ') {
            refused(&folder, &format!("{verb} {option} {value}"), &[option]);
        }
    }
    let along = "render furnace -o old.png --eye 0.5,0.9,0.5 --target 0.5,0,0.5";
    refused(&folder, along, &["--up"]);
}

#[test]
fn factors_for_a_solver_that_has_its_own() {
    let folder = Folder::new();
    for factors in [
        "--form-factors hemicube",
        "--form-factors sampling --samples 100",
        "--samples 100",
    ] {
        let words = ["--method hierarchy", "leave", "gather or shoot"];
        let options = format!("--method hierarchy {factors}");
        refused(&folder, &format!("solve furnace -o old.csv {options}"), &words);
    }
    let own = "solve furnace -o new.csv --method hierarchy --form-factors auto";
    folder.run(own).done();
}

#[test]
fn a_file_that_cannot_be_written() {
    let folder = Folder::new();
    let gone = "gone/x.csv";
    refused(&folder, "solve furnace -o gone/x.csv", &[gone, "no folder gone"]);
    refused(&folder, "solve furnace -o x.txt", &["x.txt", ".csv, .ply or .json"]);
    refused(&folder, "solve furnace -o csv", &["csv"]);
    refused(&folder, "render furnace -o x.jpg", &["x.jpg", ".png, .hdr or .exr"]);
    refused(&folder, "form-factors furnace -o x.mat", &["x.mat", ".npy or .csv"]);
    refused(&folder, "render furnace -o x.exr --view mesh", &["x.exr", ".png"]);
    refused(&folder, "scenes --export old.csv", &["old.csv"]);
    std::fs::create_dir(folder.path().join("d.csv")).unwrap();
    refused(&folder, "solve furnace -o d.csv", &["d.csv", "folder"]);
}

#[test]
fn what_is_not_understood_ends_with_2() {
    let folder = Folder::new();
    for arguments in [
        "fly",
        "solve",
        "render furnace",
        "solve furnace -o x.csv --tolerance much",
        "solve furnace -o x.csv --method guess",
        "solve furnace -o x.csv --form-factors guess",
        "solve furnace -o x.csv --threads -1",
        "solve furnace -o x.csv --seed 0.5",
        "render furnace -o x.png --size big",
        "render furnace -o x.png --size 10",
        "render furnace -o x.png --size -5x5",
        "render furnace -o x.png --eye 1,2",
        "render furnace -o x.png --exposure bright",
        "render furnace -o x.png --method guess",
        "render furnace -o x.png --view mistake",
        "solve furnace -o x.csv --sky uniform:1,1",
        "solve furnace -o x.csv --sky overcast:bright",
        "explain furnace --sky sunny",
        "scenes --edge 0.5",
        "scenes --export new --edge short",
        "form-factors furnace -o x.csv --sky overcast:1",
    ] {
        let Answer { code, out, err } = folder.run(arguments);
        assert_eq!(code, Some(2), "{arguments}: {err}");
        assert!(out.is_empty() && !err.contains("panicked"), "{arguments}: {out}{err}");
    }
    assert!(folder.names().is_empty());
}

#[test]
fn faces_that_are_not_planar_or_not_convex_are_split_with_a_warning() {
    let folder = Folder::new();
    folder.write("a.mtl", LAMP);
    folder.write(
        "a.obj",
        lit("v 0 0 2\nv 1 0 2\nv 1 1 2.2\nv 0 1 2\nf 8 7 6 5\n\
             v 3 0 0\nv 5 0 0\nv 5 2 0\nv 4 0.5 0\nf 9 10 11 12\n"),
    );
    let answer = folder.run("solve a.obj -o a.csv --tolerance 10").done();
    let split = |line: usize| {
        let start = format!("warning: a.obj, line {line}: ");
        answer.err.lines().any(|l| l.starts_with(&start) && l.contains("split"))
    };
    assert!(split(12) && split(17), "{}", answer.err);
    assert_eq!(folder.text("a.csv").lines().count(), 4, "one row a face");
    let quiet = folder.run("solve a.obj -o a.csv --tolerance 10 --quiet").done();
    assert_eq!((quiet.out.as_str(), quiet.err.as_str()), ("", ""));
}

#[test]
fn a_sky_that_cannot_be() {
    let folder = Folder::new();
    let no = |sky: &str, words: &[&str]| {
        refused(&folder, &format!("solve cornell -o old.csv --sky {sky}"), words);
        refused(&folder, &format!("explain cornell --sky {sky}"), words);
    };
    no("uniform:1,-1,1", &["uniform", "1,-1,1", "0 or more"]);
    no("uniform:1,nan,1", &["uniform", "NaN", "finite"]);
    no("overcast:-2", &["overcast", "-2"]);
    no("overcast:inf", &["overcast", "inf", "finite"]);
    no("clear:1,0,90", &["clear", "0 degrees", "elevation above 0"]);
    no("clear:1,91,90", &["91 degrees"]);
    no("gone.hdr", &["gone.hdr", "cannot be read"]);
    folder.write("png.hdr", radiosity_png());
    no("png.hdr", &["png.hdr", "no radiance", ".exr"]);
    folder.write("broken.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\nab");
    no("broken.hdr", &["broken.hdr", "cannot be decoded"]);
    folder.write("huge.hdr", "#?RADIANCE\n\n-Y 70000 +X 70000\n");
    no("huge.hdr", &["huge.hdr", "70000x70000", "scale it down"]);
    folder.write("empty.hdr", "#?RADIANCE\n\n-Y 0 +X 4\n");
    no("empty.hdr", &["empty.hdr"]);
    folder.write("empty.exr", "");
    no("empty.exr", &["empty.exr"]);
}

/// The first bytes of a PNG: 8 bits to a channel, whatever it is called.
fn radiosity_png() -> Vec<u8> {
    vec![0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', 0, 0, 0, 13]
}

/// No answer leaves the command in which a lamp or the sky was left out.
#[test]
fn methods_refuse_light_that_they_do_not_know() {
    let folder = Folder::new();
    for (asked, words) in [
        ("sky-room --method shoot", ["shoot", "sky", "--method auto"]),
        ("sky-room --form-factors hemicube", ["shoot", "sky", "--method auto"]),
        ("mirror-room --method hierarchy", ["hierarchy", "mirrors", "--method auto"]),
    ] {
        refused(&folder, &format!("solve {asked} -o old.csv --quiet"), &words);
    }
}
