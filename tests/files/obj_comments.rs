//! Comments in OBJ and MTL files.

use crate::common::texts::{SQUARE, sound};
use glam::DVec3;
use radiosity::obj;
use radiosity::scene::MaterialId;

/// A comment may stand behind every statement; a name that holds `#` still means itself.
#[test]
fn comments_behind_statements_are_not_read() {
    let key = |line: &str| {
        let mtl = format!("newmtl m\nKd .1 .1 .1\n{line}\n");
        let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
        sound(&text, &mtl).0.materials[0].clone()
    };
    for line in [
        "Kd .2",
        "Ke 1 2 3",
        "Ks .1",
        "Ks .1\nNs 7",
        "Td .1",
        "Ks .1\nillum 3",
        "illum 2",
        "illum 6\nNi 1.3",
        "illum 4\nTf .5",
        "illum 4\nd .5",
        "illum 4\nTr .5",
    ] {
        assert_eq!(key(&format!("{line} # mine")), key(line), "{line}");
        assert_eq!(key(&format!("{line}\t#")), key(line), "{line}");
    }
    assert_eq!(key("Ks .1\nillum 3.0"), key("Ks .1\nillum 3"));

    let faces = |library: &str, using: &str| {
        let text = format!("mtllib {library}\n{SQUARE}usemtl {using}\nf 1 2 3 4 # f\n");
        sound(&text, "newmtl a # red\nKd .1\nnewmtl b\nKd .2\nnewmtl a # blue\nKd .3\n")
            .0
    };
    let expected = |k: u32| faces("room.mtl", ["a # red", "b", "a # blue"][k as usize]);
    for (using, k) in
        [("a # red", 0), ("b # c", 1), ("a # blue", 2), ("a", 2), ("a # x", 2)]
    {
        let scene = faces("room.mtl # ours", using);
        assert_eq!(scene.faces[0].material, MaterialId(k), "{using}");
        assert_eq!(scene, expected(k), "{using}");
    }
    let camera = "# camera eye 1 2 3 target 0 0 0 up 0 0 1 fov 30";
    let with = |camera: &str| sound(&format!("{SQUARE}{camera}\nf 1 2 3 4\n"), "").0;
    assert_eq!(with(&format!("{camera} # mine")), with(camera));
}

/// A lamp in tiles under a material with a comment behind its illumination model.
#[test]
fn a_scene_with_comments_is_read() {
    let (scene, warnings) = obj::load("tests/data/house/ill.obj").unwrap();
    assert_eq!(warnings, []);
    assert_eq!(scene.materials[0].diffuse(), DVec3::splat(0.7));
}
