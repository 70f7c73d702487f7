//! What stands in the files.

use super::{Folder, numbers};
use serde_json::Value;

#[test]
fn a_csv_has_a_row_for_each_face_and_reads_back_bit_for_bit() {
    let folder = Folder::new();
    folder.run("scenes --export .").done();
    let obj = folder.text("cornell.obj");
    let faces = obj.lines().filter(|line| line.starts_with("f ")).count();
    for scene in ["cornell", "cornell.obj"] {
        folder.run(&format!("solve {scene} -o x.csv --tolerance 10")).done();
        let csv = folder.text("x.csv");
        let header = "face,area,B_r,B_g,B_b,H_r,H_g,H_b";
        assert_eq!(csv.lines().next(), Some(header));
        let rows = numbers(&csv);
        assert_eq!(rows.len(), faces, "{scene}");
        for (face, row) in rows.iter().enumerate() {
            assert_eq!((row.len(), row[0]), (8, face as f64), "{scene}");
            assert!(row.iter().all(|x| x.is_finite() && *x >= 0.0), "{row:?}");
        }
        let digits = |cell: &str| cell.bytes().filter(u8::is_ascii_digit).count();
        let longest = csv.lines().skip(1).flat_map(|r| r.split(',')).map(digits).max();
        assert!(longest >= Some(16), "full precision: {longest:?} digits");
    }
}

/// `B = Ke + Kd H` on each face; in the furnace that is 1 + ρ H, and near 1/(1 − ρ).
#[test]
fn the_furnace_glows_as_it_must() {
    let folder = Folder::new();
    for method in ["gather", "shoot"] {
        let arguments =
            format!("solve furnace:0.8 -o x.csv --tolerance 10% --method {method}");
        folder.run(&arguments).done();
        for row in numbers(&folder.text("x.csv")) {
            let (area, b, h) = (row[1], row[2], row[5]);
            assert_eq!(area, 1.0);
            assert!((b - (1.0 + 0.8 * h)).abs() < 1e-12, "{b} {h}");
            assert!((b - 5.0).abs() < 0.01 * 5.0, "{method}: {b}");
        }
    }
}

/// The two solvers, on the same scene: their face means differ by less than the sum of
/// what they say they may be off.
#[test]
fn gathering_and_shooting_agree_within_their_stated_errors() {
    let folder = Folder::new();
    let solve = |method: &str| {
        let arguments = format!(
            "solve cornell-regular -o {method}.csv --tolerance 10 --json --method {method}"
        );
        let json = folder.run(&arguments).done().json();
        let error = json["certificate"]["error"].as_f64().expect("an error");
        (numbers(&folder.text(&format!("{method}.csv"))), error)
    };
    let ((gathered, e), (shot, f)) = (solve("gather"), solve("shoot"));
    let norm = |value: &dyn Fn(usize) -> f64| -> f64 {
        (0..shot.len()).map(|k| shot[k][1] * value(k).powi(2)).sum::<f64>().sqrt()
    };
    let apart = norm(&|k| shot[k][2] - gathered[k][2]);
    let emitted = |k: usize| if shot[k][2] > 0.5 { 1.0 } else { 0.0 }; // the lamp's B is 1
    let reflected = norm(&|k| shot[k][2] - emitted(k));
    assert!(apart / reflected < e + f, "{} > {e} + {f}", apart / reflected);
}

#[test]
fn a_ply_holds_the_elements_with_doubles_at_their_corners() {
    let folder = Folder::new();
    let json = folder.run("solve l-room -o x.ply --tolerance 10 --json").done().json();
    let ply = folder.text("x.ply");
    let (head, body) = ply.split_once("end_header\n").expect("a header");
    assert!(head.starts_with("ply\nformat ascii 1.0\n"));
    let count = |what: &str| -> usize {
        let line = head.lines().find_map(|line| line.strip_prefix(what));
        line.expect(what).trim().parse().expect(what)
    };
    for name in ["x", "y", "z", "B_r", "B_g", "B_b"] {
        assert!(head.contains(&format!("property double {name}\n")), "{head}");
    }
    let (vertices, faces) = (count("element vertex"), count("element face"));
    assert_eq!(json["elements"], faces);
    let lines: Vec<&str> = body.lines().collect();
    assert_eq!(lines.len(), vertices + faces);
    for line in &lines[..vertices] {
        let values: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        assert!(values.len() == 6 && values[3..].iter().all(|b| *b >= 0.0), "{line}");
    }
    for line in &lines[vertices..] {
        let values: Vec<usize> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        assert_eq!(values[0], values.len() - 1, "{line}");
        assert!(values[1..].iter().all(|&v| v < vertices), "{line}");
    }
}

#[test]
fn a_json_file_holds_all_of_it_and_no_clock() {
    let folder = Folder::new();
    let told = folder.run("solve l-room -o x.json --tolerance 10 --json").done().json();
    let kept: Value = serde_json::from_str(&folder.text("x.json")).expect("JSON");
    for key in told.keys().filter(|key| *key != "seconds") {
        assert_eq!(kept[key], told[key], "{key}");
    }
    assert_eq!(kept.get("seconds"), None);
    folder.run("solve l-room -o x.csv --tolerance 10").done();
    let rows = numbers(&folder.text("x.csv"));
    let faces = kept["faces"].as_array().expect("faces");
    assert_eq!(faces.len(), rows.len());
    for (face, row) in faces.iter().zip(rows) {
        // serde_json reads numbers to one unit in the last place.
        let same = |v: &Value, x: f64| (v.as_f64().unwrap() - x).abs() <= 1e-15 * x;
        assert!(same(&face["area"], row[1]) && same(&face["B"][0], row[2]), "{face}");
    }
    let elements = kept["mesh"]["elements"].as_array().expect("elements");
    assert_eq!(elements.len() as u64, told["elements"].as_u64().unwrap());
}

/// The matrix of an `.npy` file.
fn npy(bytes: &[u8]) -> Vec<Vec<f64>> {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = u16::from_le_bytes([bytes[8], bytes[9]]) as usize;
    assert_eq!((10 + length) % 64, 0, "the numbers must be aligned");
    let header = std::str::from_utf8(&bytes[10..10 + length]).expect("text");
    let shape = header.split("'shape': (").nth(1).expect("a shape");
    let n: usize = shape.split(',').next().unwrap().parse().expect("a number");
    let wanted =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({n}, {n}), }}");
    assert_eq!(header.trim_end_matches(' ').trim_end(), wanted);
    assert!(header.ends_with('\n'));
    let numbers: Vec<f64> = bytes[10 + length..]
        .chunks(8)
        .map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes")))
        .collect();
    assert_eq!(numbers.len(), n * n);
    numbers.chunks(n).map(<[f64]>::to_vec).collect()
}

/// Opposed faces of a cube: 0.199825; neighbours: 0.200044 (Siegel & Howell).
#[test]
fn the_matrix_of_a_cube_is_the_textbooks_by_every_method() {
    let folder = Folder::new();
    for method in ["analytic", "hemicube", "sampling"] {
        let arguments = format!(
            "form-factors furnace -o F.npy --json --tolerance 1e-3 --method {method}"
        );
        let json = folder.run(&arguments).done().json();
        assert_eq!((&json["n"], &json["open"]), (&6.into(), &false.into()));
        let error = json["error_estimate"].as_f64().expect("a number");
        assert!(error <= 1e-3, "{method}: {error}");
        let f = npy(&folder.read("F.npy"));
        for i in 0..6 {
            // Floor, ceiling, then the walls in turn.
            let opposite = [1, 0, 4, 5, 2, 3][i];
            for (j, &found) in f[i].iter().enumerate() {
                let exact = match j {
                    _ if j == i => 0.0,
                    _ if j == opposite => 0.199_824_895_698,
                    _ => 0.200_043_776_075,
                };
                assert!((found - exact).abs() <= error, "{method} {i} {j}: {found}");
            }
        }
    }
}

#[test]
fn analytic_factors_are_reciprocal_to_rounding_and_lists_equal_matrices() {
    let folder = Folder::new();
    let json = folder.run("form-factors l-room -o F.npy --json").done().json();
    let number = |key: &str| json[key].as_f64().expect("a number");
    assert!(number("reciprocity_max") < 1e-15, "{json:?}");
    assert!(number("closure_max") < 1e-4, "{json:?}");
    assert!(number("error_estimate") <= 1e-4, "{json:?}");
    let f = npy(&folder.read("F.npy"));
    folder.run("form-factors l-room -o F.csv").done();
    assert!(folder.text("F.csv").starts_with("i,j,F\n"));
    let mut listed = vec![vec![0.0; f.len()]; f.len()];
    for row in numbers(&folder.text("F.csv")) {
        assert!(row[2] != 0.0, "{row:?}");
        listed[row[0] as usize][row[1] as usize] = row[2];
    }
    assert_eq!(listed, f);
}

#[test]
fn an_open_scene_says_so() {
    let folder = Folder::new();
    let json = folder.run("form-factors facing-squares --json").done().json();
    assert_eq!((&json["n"], &json["open"]), (&2.into(), &true.into()));
    let closure = json["closure_max"].as_f64().unwrap();
    assert!((closure - (1.0 - 0.199_824_895_698)).abs() < 1e-6, "{closure}");
}

#[test]
fn radiance_files_hold_radiance_and_pictures_sizes() {
    let folder = Folder::new();
    for (name, shading) in [("a.exr", "flat"), ("b.hdr", "smooth"), ("c.png", "smooth")]
    {
        let arguments = format!(
            "render furnace -o {name} --size 40x30 --shading {shading} --exposure 0.5"
        );
        folder.run(&arguments).done();
        let picture = image::open(folder.path().join(name)).expect(name);
        assert_eq!((picture.width(), picture.height()), (40, 30), "{name}");
        let mean =
            picture.to_rgb32f().pixels().map(|p| p[0] as f64).sum::<f64>() / 1200.0;
        // B = 2 everywhere, so L = 2/π; in the PNG the sRGB code of half of it.
        let wanted = if name == "c.png" { 0.6008 } else { 2.0 / std::f64::consts::PI };
        assert!((mean / wanted - 1.0).abs() < 0.02, "{name}: {mean}");
    }
}

#[test]
fn each_built_in_scene_is_exported_and_read_back() {
    let folder = Folder::new();
    let json = folder.run("scenes --export all --json").done().json();
    let scenes = json["scenes"].as_array().expect("a list");
    assert!(scenes.len() >= 16);
    for scene in scenes {
        let name = scene["name"].as_str().expect("a name");
        let of = |source: &str| {
            let few = "--method sampling --samples 64";
            folder.run(&format!("form-factors {source} -o F.npy --quiet {few}")).done();
            folder.read("F.npy")
        };
        assert!(of(name) == of(&format!("all/{name}.obj")), "{name}");
    }
}

/// The elements stand for the faces: what they add up to is the same scene.
#[test]
fn a_scene_is_exported_as_elements() {
    let folder = Folder::new();
    let scenes = "scenes cornell-regular furnace";
    folder.run(&format!("{scenes} --export whole")).done();
    folder.run(&format!("{scenes} --export tiles --edge 0.25")).done();
    // A cut along a line of contact may run across a cell.
    let longest = [("cornell-regular", 0.25 * 2f64.sqrt()), ("furnace", 0.25)];
    for (name, longest) in longest {
        let of = |kind: &str| {
            let path = folder.path().join(kind).join(name).with_extension("obj");
            let (scene, warnings) = radiosity::obj::load(&path).expect(name);
            (scene, warnings.len())
        };
        let ((whole, _), (tiles, warnings)) = (of("whole"), of("tiles"));
        assert_eq!(warnings, 0, "elements neither overlap nor bend");
        assert_eq!(tiles.camera, whole.camera);
        let edges = tiles.surfaces.iter().flat_map(|s| s.polygon.edges());
        let found = edges.map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
        assert!(found <= longest + 1e-9, "{name}: {found}");
        // Area and emitted power of each material, by its name.
        let sums = |scene: &radiosity::scene::Scene| {
            let mut sums = std::collections::BTreeMap::new();
            for surface in &scene.surfaces {
                let material = scene.material(surface);
                let sum = sums.entry(material.name().to_owned()).or_insert((0.0, 0.0));
                sum.0 += surface.polygon.area();
                sum.1 += surface.polygon.area() * material.emission().x;
            }
            sums
        };
        let (whole, tiles) = (sums(&whole), sums(&tiles));
        assert!(whole.keys().eq(tiles.keys()), "{name}");
        for ((area, power), (tiled_area, tiled_power)) in
            whole.values().zip(tiles.values())
        {
            assert!((area - tiled_area).abs() < 1e-9 * area, "{name}");
            assert!((power - tiled_power).abs() <= 1e-9 * power, "{name}");
        }
    }
    let furnace = folder.text("tiles/furnace.obj");
    let faces = furnace.lines().filter(|l| l.starts_with("f ")).count();
    assert_eq!(faces, 6 * 16, "an edge that fits needs no more");
    assert_eq!(folder.names(), ["tiles", "whole"]);
}

/// Faces that act on both sides are written once, and skies stay.
#[test]
fn every_built_in_scene_is_exported_as_elements_and_read_back() {
    let folder = Folder::new();
    folder.run("scenes --export tiles --edge 1.5").done();
    for built_in in radiosity::scene::builtins() {
        let path = folder.path().join(format!("tiles/{}.obj", built_in.name));
        let (tiles, _) = radiosity::obj::load(&path).expect(built_in.name);
        let whole = (built_in.make)();
        assert_eq!(tiles.sky, whole.sky, "{}", built_in.name);
        let backs =
            |scene: &radiosity::scene::Scene| scene.surfaces.len() > scene.faces.len();
        let two_sided = whole.surfaces.iter().any(|s| s.back.is_some());
        assert_eq!(backs(&tiles), two_sided, "{}", built_in.name);
        let area = |scene: &radiosity::scene::Scene| -> f64 {
            scene.surfaces.iter().map(|s| s.polygon.area()).sum()
        };
        let (found, expected) = (area(&tiles), area(&whole));
        assert!((found - expected).abs() < 1e-9 * expected, "{}", built_in.name);
    }
}
