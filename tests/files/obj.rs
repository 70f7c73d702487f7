//! OBJ and MTL files: what is read, what is repaired, and what is refused, in which words.

use crate::common::texts::{SQUARE, folder, message, sound};
use glam::{DVec3, dvec3};
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::obj::{self, Cause};
use radiosity::scene::{Face, FaceId, MaterialId, Scene, SceneError, builtins};

// --- What is read -------------------------------------------------------------------

#[test]
fn faces_keep_file_order_whatever_groups_and_materials_they_have() {
    let text = format!(
        "mtllib room.mtl\n{SQUARE}v 5 0 0\n\
         usemtl a\nf 1 2 3\ng one\nf 2 3 4 1\nusemtl b\nf 1 2 3 4\no two\nf 4 3 2\n\
         usemtl a\nf 1 5 3\nf 2 5 4\ng\nusemtl b\nf 1 5 4\n"
    );
    let (scene, _) = sound(&text, "newmtl a\nKd .1 .1 .1\nnewmtl b\nKd .2 .2 .2\n");
    let names: String = scene
        .faces
        .iter()
        .map(|f| scene.materials[f.material.0 as usize].name())
        .collect();
    assert_eq!(names, "aabbaab");
    let corners: Vec<usize> = scene.faces.iter().map(|f| f.outline.len()).collect();
    assert_eq!(corners, [3, 4, 4, 3, 3, 3, 3]);
    assert_eq!(scene.faces[4].outline[1], dvec3(5.0, 0.0, 0.0));
}

#[test]
fn the_forms_of_a_face_mean_the_same() {
    let expected = sound(&format!("{SQUARE}f 1 2 3 4\n"), "").0;
    for form in [
        "f 1/1 2/2 3/3 4/4",
        "f 1//1 2//1 3//1 4//1",
        "f 1/1/1 2/2/1 3/3/1 4/4/1",
        "f -4 -3 -2 -1",
        "f 1 2 \\\n 3 4",
        "  f\t1  2 3 4   # the floor",
        "f 1 2 3 4\r",
    ] {
        let text = format!("# a file\n\n{SQUARE}vt 0 0\nvn 0 0 1\ns off\n{form}\n");
        assert_eq!(sound(&text, "").0, expected, "{form}");
    }
    let windows = format!("{SQUARE}f 1 2 3 4\n").replace('\n', "\r\n");
    assert_eq!(sound(&windows, "").0, expected);
    let coloured = SQUARE.replace('\n', " 1 0.5 0.5\n");
    assert_eq!(sound(&format!("{coloured}f 1 2 3 4"), "").0, expected);
}

#[test]
fn a_material_is_read_with_all_its_digits() {
    let mtl = "# m\nnewmtl my paint # 7\nKd 0.1 0.2 0.30000000000000004\nKe 5\nNs 10\n\
               illum 2\nbump x.png\nmap_Ks y.png\n";
    let text = format!("mtllib room.mtl\n{SQUARE}usemtl my paint # 7\nf 1 2 3 4\n");
    let (scene, warnings) = sound(&text, mtl);
    let material = scene.material(&scene.surfaces[0]);
    assert_eq!(material.name(), "my paint # 7");
    assert_eq!(material.diffuse(), dvec3(0.1, 0.2, 0.1 + 0.2));
    assert_eq!(material.emission(), DVec3::splat(5.0));
    assert_eq!(warnings, [""; 0]);
}

/// Programs match on the cause and the place, people read the sentence.
#[test]
fn warnings_have_a_cause_and_a_place() {
    let file = folder("warned").join("room.obj");
    let text = format!("{SQUARE}f 1 2 3 4\nv 0.5 0.5 0\ncurv 0 1\nf 1 2 5\n");
    std::fs::write(&file, text).unwrap();
    let (_, warnings) = obj::load(&file).unwrap();
    let found: Vec<_> = warnings.iter().map(|w| (w.line, &w.cause)).collect();
    let [
        (Some(7), Cause::NotRead { key }),
        (None, Cause::NoMaterial { faces: 2 }),
        last,
    ] = &found[..]
    else {
        panic!("{found:?}");
    };
    assert_eq!(key, "curv");
    assert!(matches!(last, (Some(5), Cause::Face { by: Some(8), .. })), "{last:?}");
    assert!(warnings.iter().all(|w| w.file == file));
}

#[test]
fn illumination_models_are_whole_numbers() {
    for model in ["-1", "11", "2.5", "2 3", "two", "", "# 2", "nan"] {
        let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
        let message = message(&text, &format!("newmtl m\nillum {model}\n"));
        assert!(message.contains("write 0 to 10"), "{message}");
    }
}

#[test]
fn a_scene_without_emitter_is_no_error_here() {
    let (scene, warnings) = sound(&format!("{SQUARE}f 1 2 3 4\n"), "");
    assert!(!scene.has_emitter());
    assert_eq!(scene.material(&scene.surfaces[0]).diffuse(), DVec3::splat(0.5));
    assert_eq!(warnings, ["room.obj: faces without `usemtl`: 1; they reflect 0.5"]);
}

#[test]
fn no_faces_are_no_scene() {
    let error = Scene::assemble("nothing", vec![], vec![], None).unwrap_err();
    assert_eq!(error, SceneError::NoFaces);
    assert!(error.to_string().contains("needs at least one"), "{error}");
}

// --- Round trip ---------------------------------------------------------------------

#[test]
fn every_built_in_scene_comes_back_bit_for_bit() {
    let folder = folder("round-trip");
    for b in builtins() {
        let scene = (b.make)();
        let paths = obj::export(&scene, &folder).unwrap();
        assert_eq!(paths[0], folder.join(format!("{}.obj", b.name)));
        let (back, _) = obj::load(&paths[0]).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(back, scene, "{}", b.name);
    }
    // Nothing but the scenes is left behind.
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 2 * builtins().len());
}

/// Names that one line cannot hold, or that two materials share, are made to fit.
#[test]
fn materials_of_any_name_come_back() {
    let folder = folder("names");
    let material = |name: &str, ks: f64| {
        let shine = Shine::Mirror { reflectance: DVec3::splat(ks) };
        Material::new(name, Coefficients { shine, ..Default::default() }).unwrap()
    };
    let materials =
        vec![material("a\nb", 0.25), material("a b", 0.5), material("", 0.75)];
    let face = |k| Face {
        outline: vec![DVec3::ZERO, DVec3::X, DVec3::Y + f64::from(k) * DVec3::Z],
        material: MaterialId(k),
    };
    let faces = (0..3).map(face).collect();
    let (scene, _) = Scene::assemble("x:/../y", materials, faces, None).unwrap();
    let paths = obj::export(&scene, &folder).unwrap();
    assert_eq!(paths[0], folder.join("x--..-y.obj"));
    let (back, warnings) = obj::load(&paths[0]).unwrap();
    let names: Vec<&str> = back.materials.iter().map(Material::name).collect();
    assert_eq!(names, ["a b", "a b-2", "material"]);
    assert_eq!(back.materials[1].shine().reflectance(), DVec3::splat(0.5));
    assert_eq!(back.surfaces, scene.surfaces);
    assert_eq!(warnings, []);
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let file = folder("unwritable").join("file");
    std::fs::write(&file, "in the way").unwrap();
    let error = obj::export(&(builtins()[0].make)(), &file).unwrap_err().to_string();
    assert!(error.contains(&file.display().to_string()), "{error}");
    assert_eq!(std::fs::read(&file).unwrap(), b"in the way");
}

#[test]
fn a_camera_is_read_from_its_comment_and_a_broken_one_is_warned_of() {
    let with = |camera: &str| {
        let (scene, warnings) =
            sound(&format!("{SQUARE}# camera {camera}\nf 1 2 3 4\n"), "");
        (scene.camera, warnings.len() - 1) // the material is missing, too
    };
    let (camera, warnings) = with("eye 0 0 5 target 0 0 0 up 0 1 0 fov 30");
    assert_eq!((camera.eye, camera.fov, warnings), (5.0 * DVec3::Z, 30.0, 0));
    for broken in [
        "eye 0 0 5",
        "eye 0 0 5 target 0 0 0 up 0 1 0 fov 180",
        "eye 0 0 5 target 0 0 5 up 0 1 0 fov 30",
        "eye 0 5 0 target 0 0 0 up 0 1 0 fov 30",
        "eye 0 0 nan target 0 0 0 up 0 1 0 fov 30",
    ] {
        let (camera, warnings) = with(broken);
        assert!(camera.eye.is_finite() && warnings == 1, "{broken}");
    }
    assert_eq!(with("Camera.001 of some other program").1, 0);
}

// --- What is repaired ---------------------------------------------------------------

#[test]
fn a_twisted_face_is_split_with_a_warning_and_stays_one_face() {
    let (scene, warnings) =
        sound("v 0 0 0\nv 1 0 0\nv 1 1 .1\nv 0 1 0\nf 1 2 3 4\n", "");
    assert_eq!((scene.faces.len(), scene.surfaces.len()), (1, 2));
    assert!(scene.surfaces.iter().all(|s| s.face == FaceId(0)));
    assert!(
        warnings
            .iter()
            .any(|w| w.starts_with("room.obj, line 5: face 0 is not planar")),
        "{warnings:?}"
    );
}

#[test]
fn an_l_shaped_face_is_split_with_a_warning() {
    let text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n";
    let (scene, warnings) = sound(text, "");
    assert_eq!(scene.surfaces.len(), 2);
    assert!((scene.face_areas()[0] - 3.0).abs() < 1e-15);
    assert!(warnings[1].contains("line 7: face 0 is not convex"), "{warnings:?}");
}

#[test]
fn what_is_ignored_is_said_with_file_line_and_material() {
    let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\ncurv 0 1 1 2\n");
    for (mtl, words) in [
        ("d .5", "room.mtl, line 3: material `m` is partly transparent"),
        ("Tr .5", "room.mtl, line 3: material `m` is partly transparent"),
        ("Tf .5", "room.mtl, line 3: material `m` is partly transparent"),
        (
            "illum 4\nKs .1 .2 .3",
            "line 4: material `m` has Ks (0.1, 0.2, 0.3), which is",
        ),
        ("newmtl m", "room.mtl, line 2: material `m` is defined again"),
        ("", "room.obj, line 8: `curv` statements are not read"),
    ] {
        let (_, warnings) = sound(&text, &format!("# library\nnewmtl m\n{mtl}\n"));
        assert!(warnings.iter().any(|w| w.contains(words)), "{mtl}: {warnings:?}");
    }
    // Nobody minds a material that no face has, or what means nothing.
    for mtl in ["newmtl n\nd .5\nmap_Kd gone.png", "Tf 1 1 1\nTr 0\nd 1", "Tf 0 0 0"] {
        let (_, warnings) = sound(&text, &format!("newmtl m\n{mtl}\n"));
        assert_eq!(warnings.len(), 1, "{mtl}: {warnings:?}");
    }
}

#[test]
fn warnings_are_not_endless() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 .1\nv 0 1 0\n".to_string()
        + &"f 1 2 3 4\n".repeat(100);
    let (_, warnings) = sound(&text, "");
    assert!(warnings.len() <= 21);
    assert!(warnings.last().unwrap().contains("more warnings"), "{warnings:?}");
}

// --- What is refused ----------------------------------------------------------------

#[test]
fn bad_obj_files_are_refused_in_one_sentence() {
    for (text, words) in [
        ("", "room.obj: is empty"),
        (" \n\n", "room.obj: is empty"),
        ("v 0 0 0\n", "room.obj: has no face"),
        ("hello world\n", "room.obj: has no face"),
        ("{S}f 1 2 9\n", "room.obj, line 5: corner 9 does not exist: 4 stand above"),
        ("{S}f 0 1 2\n", "line 5: corner 0 does not exist"),
        ("{S}f -5 1 2\n", "line 5: corner -5 does not exist"),
        ("f 1 2 3\n{S}", "line 1: corner 1 does not exist: 0 stand above"),
        ("{S}f 1 2 99999999999999999999999\n", "corner 99999999999999999999999 does"),
        ("{S}f 1 2 4294967297\n", "corner 4294967297 does not exist"),
        ("{S}f 1 2\n", "line 5: a face needs at least 3 corners, not 2"),
        ("{S}f\n", "line 5: a face needs at least 3 corners, not 0"),
        ("{S}f 1 2 x\n", "line 5: `x` is not a corner of a face"),
        ("{S}f 1 2 3/a\n", "line 5: `3/a` is not a corner of a face"),
        ("{S}f 1 2 3/1/1/1\n", "line 5: `3/1/1/1` is not a corner of a face"),
        ("v nan 0 0\n{S}f 2 3 4\n", "line 1: `nan` is not a finite number"),
        ("v 0 -inf 0\n", "line 1: `-inf` is not a finite number"),
        ("v 0 1e999 0\n", "line 1: `1e999` is not a finite number"),
        ("v 0 1e300 0\n", "line 1: `1e300` is not a finite number"),
        ("v 0 one 0\n", "line 1: `one` is not a number"),
        ("v 0 1\n", "line 1: corner `v 0 1` needs three coordinates"),
        ("{S}f 1 2 1 2\n", "line 5: face `f 1 2 1 2` "),
        ("{S}f 1 1 1\n", "line 5: face `f 1 1 1` has 1 distinct vertices"),
        ("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "face `f 1 2 3` has no area"),
        ("{S}f 1 3 2 4\n", "line 5: face `f 1 3 2 4` crosses or touches itself"),
        ("{S}usemtl\nf 1 2 3\n", "line 5: `usemtl` names nothing"),
        ("{S}mtllib \nf 1 2 3\n", "line 5: `mtllib` names nothing"),
        ("{S}usemtl gold\nf 1 2 3\n", "line 5: there is no material `gold`"),
        ("mtllib no.mtl\n{S}f 1 2 3\n", "room.obj, line 1: its material file `no.mtl`"),
        ("mtllib a.mtl b.mtl\n{S}f 1 2 3\n", "line 1: its material file `a.mtl`"),
        ("{S}f 1 2 3\nv 0 0 \0\n", "line 6: this is not text"),
    ] {
        let got = message(&text.replace("{S}", SQUARE), "");
        assert!(got.contains(words), "{text:?}: {got}");
        assert!(!got.contains('\n'), "{got}");
    }
}

#[test]
fn bad_materials_are_refused_in_one_sentence() {
    for (mtl, words) in [
        (
            "newmtl m\nKd 1 .5 .5\n",
            "room.mtl, line 2: material `m` reflects and transmits (1, 0.5, 0.5)",
        ),
        (
            "newmtl m\nKd .8 .8 .8\nKs .3 .1 .1\n",
            "room.mtl, line 3: material `m` reflects",
        ),
        (
            "newmtl m\nKd .6\nTd .4\n",
            "line 3: material `m` reflects and transmits (1, 1, 1)",
        ),
        (
            "newmtl m\nKd .4\nTd .4\nKs .3\n",
            "line 4: material `m` reflects and transmits (1.1",
        ),
        ("newmtl m\nTd -1\n", "line 2: material `m` has Td (-1, -1, -1)"),
        ("newmtl m\nKs .5\nNs -1\n", "line 3: material `m` has Ns -1; write a finite"),
        ("newmtl m\nillum 4\nNi 0\n", "line 3: material `m` has Ni 0; write a finite"),
        ("newmtl m\nillum 6\nTf 2\n", "line 3: material `m` has Tf (2, 2, 2); write"),
        ("newmtl m\nTr -1\nillum 4\n", "line 2: material `m` has Tf (2, 2, 2); write"),
        ("newmtl m\nTf 1 1\n", "line 2: `Tf 1 1` needs one or three numbers"),
        ("newmtl m\nKd -.1 0 0\n", "line 2: material `m` has Kd (-0.1, 0, 0)"),
        ("newmtl m\nKe 1 nan 1\n", "line 2: `nan` is not a finite number"),
        ("newmtl m\nKd .5 .5\n", "line 2: `Kd .5 .5` needs one or three numbers"),
        ("newmtl m\nKd\n", "line 2: `Kd` needs one or three numbers"),
        ("newmtl m\nKd spectral x.rfl\n", "line 2: `spectral` is not a number"),
        ("newmtl m\nillum 99\n", "line 2: `illum 99` is not an illumination model"),
        ("newmtl m\nNs\n", "line 2: `Ns` needs one number"),
        ("newmtl\n", "line 1: `newmtl` names nothing"),
        ("Kd .5 .5 .5\n", "line 1: `Kd` stands before any `newmtl`"),
        ("", "room.obj, line 6: there is no material `m`"),
    ] {
        let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
        let got = message(&text, mtl);
        assert!(got.contains(words), "{mtl:?}: {got}");
        assert!(!got.contains('\n'), "{got}");
    }
    // A perfect mirror is passive, and so is rounding.
    let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
    sound(&text, "newmtl m\nKs 1 1 1\nillum 3\n");
    sound(&text, "newmtl m\nKd .9\nKs .1000000001\n");
    // Ks means nothing to glass: Fresnel's law reflects.
    for model in [4, 6, 7, 9] {
        sound(&text, &format!("newmtl m\nKd .5\nKs 1\nillum {model}\n"));
    }
}
