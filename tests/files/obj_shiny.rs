//! OBJ and MTL files: what mirrors, lets light through, is textured; and the sky.

use crate::common::texts::{SQUARE, folder, read, sound};
use glam::{DVec3, dvec3};
use radiosity::material::Shine;
use radiosity::obj;
use radiosity::scene::{Scene, builtins};
use radiosity::sky::{Panorama, Sky};
use std::io;
use std::path::Path;

#[test]
fn what_shines_is_read_by_its_illumination_model() {
    let rgb = DVec3::new;
    let third = rgb(0.5, 0.25, 0.125);
    let half = DVec3::splat(0.5);
    for (mtl, expected) in [
        ("Kd .5", Shine::Dull),
        ("Kd .5\nillum 3", Shine::Dull),
        ("Ks .5 .25 .125\nillum 3", Shine::Mirror { reflectance: third }),
        ("Ks .5\nNs 7\nillum 5", Shine::Mirror { reflectance: half }),
        ("Ks .5\nillum 8", Shine::Mirror { reflectance: half }),
        ("Ks .5\nNs 30", Shine::Gloss { reflectance: half, exponent: 30.0 }),
        ("Ks .5\nNs 0\nillum 2", Shine::Gloss { reflectance: half, exponent: 0.0 }),
        ("Ks .5", Shine::Gloss { reflectance: half, exponent: 10.0 }),
        ("illum 4", Shine::Pane { index: 1.5, tint: DVec3::ONE }),
        ("illum 9\nNi 1.3\nKs 1", Shine::Pane { index: 1.3, tint: DVec3::ONE }),
        ("illum 4\nTf .5", Shine::Pane { index: 1.5, tint: half }),
        ("illum 6\nTf .5 .25 .125", Shine::Glass { index: 1.5, tint: third }),
        ("illum 7\nNi 1.33", Shine::Glass { index: 1.33, tint: DVec3::ONE }),
        ("illum 4\nd .5", Shine::Pane { index: 1.5, tint: half }),
        ("illum 4\nTr .75", Shine::Pane { index: 1.5, tint: DVec3::splat(0.25) }),
        ("illum 4\nTr .75\nd .5", Shine::Pane { index: 1.5, tint: half }),
        ("illum 4\nTf 1\nd .5", Shine::Pane { index: 1.5, tint: DVec3::ONE }),
    ] {
        let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
        let (scene, _) = sound(&text, &format!("newmtl m\n{mtl}\n"));
        assert_eq!(scene.materials[0].shine(), expected, "{mtl}");
    }
}

/// What lets light through diffusely acts on both sides; a mirror's back is black.
#[test]
fn a_translucent_face_is_two_surfaces() {
    let text = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
    let (scene, _) = sound(&text, "newmtl m\nKd .3\nTd .5 .25 .125\nKe 2\n");
    assert_eq!((scene.faces.len(), scene.surfaces.len()), (1, 2));
    let back = scene.material(&scene.surfaces[1]);
    assert_eq!(back.translucence(), dvec3(0.5, 0.25, 0.125));
    assert_eq!((back.diffuse(), back.emission()), (DVec3::ZERO, DVec3::ZERO));
    let bare = scene.bare_geometry();
    assert_eq!((bare.surfaces.len(), bare.face_areas()), (1, vec![1.0]));
    let (scene, _) = sound(&text, "newmtl m\nKs 1\nillum 3\n");
    assert_eq!(scene.surfaces.len(), 1);
    assert_eq!(scene.two_sided().surfaces.len(), 2);
}

/// A PNG of the `codes` given, each a pixel of a single row.
fn png(codes: &[u8]) -> Vec<u8> {
    let picture = image::RgbImage::from_fn(codes.len() as u32, 1, |x, _| {
        image::Rgb([codes[x as usize]; 3])
    });
    let mut bytes = io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// As [`read`], with textures in a folder beside.
fn textured(mtl: &str) -> Result<(Scene, Vec<obj::Warning>), obj::ObjError> {
    let text = format!("mtllib m/room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\n");
    obj::read(Path::new("room.obj"), text.as_bytes(), |path| match path.to_str() {
        Some("m/room.mtl") => Ok(format!("newmtl m\n{mtl}\n").into_bytes()),
        Some("m/tex/a b.png") => Ok(png(&[0, 255])),
        Some("m/grey.png") => Ok(png(&[188])),
        Some("m/broken.png") => Ok(png(&[188])[..40].to_vec()),
        Some("m/photo.jpg") => Ok(b"\xff\xd8\xff\xe0".to_vec()),
        _ => Err(io::ErrorKind::NotFound.into()),
    })
}

/// Half black, half white is half of the light; the mean of the codes, decoded, would be
/// 0.2140 (57 % too little), and code 188 taken as it stands 0.737 (47 % too much).
#[test]
fn a_texture_counts_with_its_mean_in_linear_light() {
    let coefficients = |mtl: &str| {
        let (scene, warnings) = textured(mtl).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        (scene.materials[0].diffuse(), scene.materials[0].emission(), warnings)
    };
    for (mtl, kd) in [
        ("map_Kd tex/a b.png", 0.5),
        ("Kd .4\nmap_Kd -s 2 2 1 -clamp on tex\\a b.png", 0.2),
        ("map_Kd -o .5 grey.png\nKd 1", 0.502_886),
    ] {
        let (found, emission, warnings) = coefficients(mtl);
        assert!(
            (found - DVec3::splat(kd)).abs().max_element() < 1e-6,
            "{mtl}: {found}"
        );
        assert_eq!(emission, DVec3::ZERO);
        assert!(
            matches!(warnings[0].cause, obj::Cause::Texture { .. }),
            "{warnings:?}"
        );
    }
    let (_, emission, _) = coefficients("Ke 10 20 30\nmap_Ke tex/a b.png");
    assert!((emission - dvec3(5.0, 10.0, 15.0)).abs().max_element() < 1e-6);

    let of_codes = (0.0 + 1.0) / 2.0;
    let wrong = radiosity::texture::linear_from_srgb(of_codes);
    assert!((wrong / 0.5 - 1.0 + 0.572).abs() < 1e-3, "{wrong}");
    let wrong = 188.0 / 255.0 / radiosity::texture::linear_from_srgb(188.0 / 255.0);
    assert!((wrong - 1.466).abs() < 1e-3, "{wrong}");
}

#[test]
fn a_texture_that_cannot_be_read_is_named_with_its_line() {
    for (mtl, words) in [
        (
            "map_Kd gone.png",
            "line 2: the texture `m/gone.png` cannot be read (entity not",
        ),
        ("Ke 1\nmap_Ke gone.png", "line 3: the texture `m/gone.png` cannot be read"),
        ("map_Kd photo.jpg", "`m/photo.jpg` is no picture of a known kind; convert it"),
        ("map_Kd broken.png", "`m/broken.png` cannot be decoded"),
        ("map_Kd", "line 2: `` names no file; add the name"),
        ("map_Kd -s 1 1 1", "line 2: `-s 1 1 1` names no file; add the name"),
        ("map_Kd -mm 0 2 grey.png", "line 2: `-mm` is not read"),
        ("Kd 2\nmap_Kd grey.png", "line 2: material `m` reflects and transmits (1.0"),
    ] {
        let error = textured(mtl).map(|_| ()).expect_err(mtl).to_string();
        assert!(error.starts_with("m/room.mtl, ") && error.contains(words), "{error}");
    }
}

/// A tetrahedron with its faces outwards, or `inwards`, the last left out.
fn tetrahedron(inwards: bool, count: usize) -> String {
    let mut text =
        "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl m\n".to_string();
    for [a, b, c] in &[[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]][..count] {
        let (b, c) = if inwards { (c, b) } else { (b, c) };
        text += &format!("f {a} {b} {c}\n");
    }
    text
}

#[test]
fn solids_of_glass_that_are_open_or_inside_out_are_warned_of() {
    let glass = "newmtl m\nillum 7\n";
    let none: [&str; 0] = [];
    assert_eq!(sound(&tetrahedron(false, 4), glass).1, none);
    let open = sound(&tetrahedron(false, 3), glass).1;
    assert_eq!(open.len(), 1, "{open:?}");
    assert!(
        open[0].starts_with("room.obj, line 7: the solid of `m` (illum 6 or 7) does")
    );
    let turned = sound(&tetrahedron(true, 4), glass).1;
    assert_eq!(turned.len(), 1, "{turned:?}");
    assert!(
        turned[0].starts_with("room.obj, line 10: the solid of `m` (illum 6 or 7) is")
    );
    // A pane bounds nothing.
    assert_eq!(sound(&tetrahedron(false, 1), "newmtl m\nillum 4\n").1, none);
}

// --- The sky ------------------------------------------------------------------------

#[test]
fn skies_come_back_from_the_comment_that_describes_them() {
    let folder = folder("skies");
    let up = dvec3(0.6, 0.0, 0.8);
    let texels = (0..8).map(|k| DVec3::splat(f64::from(k))).collect();
    let panorama = Panorama::new(4, texels).unwrap();
    let cie = radiosity::sky::cie_coefficients(12).unwrap();
    for sky in [
        Sky::uniform(dvec3(0.1, 0.2, 0.3), DVec3::Y),
        Sky::overcast(dvec3(0.1, 0.2, 0.1 + 0.2), DVec3::Y),
        Sky::uniform(dvec3(0.1, 0.2, 0.3), up),
        Sky::cie(cie, dvec3(0.6, 0.8, 0.0), DVec3::ONE, DVec3::Y),
        Sky::panorama(panorama, DVec3::Y),
    ] {
        let scene = Scene { sky: Some(sky), ..(builtins()[0].make)() };
        let paths = obj::export(&scene, &folder).unwrap();
        let (back, _) = obj::load(&paths[0]).unwrap_or_else(|error| panic!("{error}"));
        let (sky, back) = (scene.sky.unwrap(), back.sky.expect("a sky"));
        assert!(sky.up().distance(back.up()) < 1e-15);
        for k in 0..40 {
            let direction = sky.sample(glam::dvec2(f64::from(k) / 40.0, 0.3)).0;
            let (a, b) = (sky.radiance(direction), back.radiance(direction));
            assert!((a - b).abs().max_element() <= 1e-12 * a.max_element(), "{a} {b}");
        }
    }
}

#[test]
fn a_sky_that_is_not_understood_is_warned_of_and_a_missing_one_refused() {
    let with = |sky: &str| read(&format!("{SQUARE}# sky {sky}\nf 1 2 3 4\n"), "");
    for broken in [
        "uniform 1 1 1",
        "uniform 1 -1 1 up 0 1 0",
        "uniform 1 1 up 0 1 0",
        "overcast 1 1 1 up 0 0 0",
        "cie 1 1 1 1 1 sun 0 1 0 zenith 1 1 1 up 0 1 0",
        "panorama gone.hdr",
    ] {
        let (scene, warnings) = with(broken).unwrap();
        assert!(scene.sky.is_none() && warnings.len() == 2, "{broken}: {warnings:?}");
        assert!(warnings[1].contains("line 5: this sky is not understood"));
    }
    assert_eq!(with("blue, with clouds").unwrap().1.len(), 1);
    let (scene, _) = with("uniform 1 2 3 up 0 0 2").unwrap();
    assert_eq!(scene.sky, Some(Sky::uniform(dvec3(1.0, 2.0, 3.0), DVec3::Z)));
    for (file, words) in [("gone.hdr", "cannot be read"), ("room.mtl", "holds no")] {
        let error = with(&format!("panorama up 0 1 0 file {file}")).unwrap_err();
        let error = error.to_string();
        assert!(error.starts_with("room.obj, line 5: the sky `"), "{error}");
        assert!(error.contains(words), "{error}");
    }
}
