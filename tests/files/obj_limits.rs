//! OBJ files that are not there, and faces that are too long.

use crate::common::texts::{SQUARE, folder, message, sound};
use radiosity::obj;

#[test]
fn missing_files_and_folders_are_named() {
    let folder = folder("missing");
    for path in [folder.join("no.obj"), folder.clone()] {
        let error = obj::load(&path).unwrap_err().to_string();
        assert!(error.starts_with(&path.display().to_string()), "{error}");
        assert!(error.contains("cannot be read"), "{error}");
    }
    std::fs::write(
        folder.join("room.obj"),
        format!("{SQUARE}f 1 2 3\nmtllib room.mtl\n"),
    )
    .unwrap();
    let error = obj::load(folder.join("room.obj")).unwrap_err().to_string();
    assert!(error.contains("room.mtl` cannot be read"), "{error}");
}

#[test]
fn absurdly_long_faces_are_refused_and_long_ones_are_not() {
    let ring = |n: usize| {
        let mut text = String::new();
        for k in 0..n {
            let (y, x) = (std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
            text += &format!("v {x} {y} 0\n");
        }
        text + "f" + &(1..=n).map(|k| format!(" {k}")).collect::<String>()
    };
    assert_eq!(sound(&ring(500), "").0.surfaces.len(), 1);
    let got = message(&ring(5000), "");
    assert!(got.contains("has 5000 corners; at most 4096"), "{got}");
    assert!(got.len() < 200, "{got}");
}
