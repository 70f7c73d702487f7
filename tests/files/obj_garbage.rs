//! Whatever stands in an OBJ or MTL file, there is an answer and no panic.

use proptest::prelude::*;
use radiosity::obj;
use radiosity::scene::Scene;
use std::io;
use std::path::Path;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Reads `obj` as `room.obj`, beside which there is only `room.mtl`.
fn read_bytes(
    obj: &[u8],
    mtl: &[u8],
) -> Result<(Scene, Vec<obj::Warning>), obj::ObjError> {
    obj::read(Path::new("room.obj"), obj, |path| match path.to_str() {
        Some("room.mtl") => Ok(mtl.to_vec()),
        _ => Err(io::ErrorKind::NotFound.into()),
    })
}

proptest! {
    /// Whatever the bytes, there is an answer and no panic.
    #[test]
    fn binary_garbage_does_not_panic(
        obj in proptest::collection::vec(any::<u8>(), 0..400),
        mtl in proptest::collection::vec(any::<u8>(), 0..100),
    ) {
        if let Err(error) = read_bytes(&obj, &mtl) {
            prop_assert!(!error.to_string().contains('\n'));
        }
    }

    /// Neither does text that is nearly right.
    #[test]
    fn almost_obj_does_not_panic(
        obj in proptest::collection::vec(statement(), 0..30),
        mtl in proptest::collection::vec(material(), 0..12),
    ) {
        let text = format!("mtllib room.mtl\n{SQUARE}{}", obj.concat());
        if let Err(error) = read_bytes(text.as_bytes(), mtl.concat().as_bytes()) {
            prop_assert!(!error.to_string().contains('\n'));
        }
    }

    /// A sound file with a few bytes changed is read or refused.
    #[test]
    fn a_damaged_file_does_not_panic(
        damage in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut bytes = format!("mtllib room.mtl\n{SQUARE}usemtl m\nf 1 2 3 4\nf -1 -2 -3\n")
            .into_bytes();
        for (at, byte) in damage {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let _ = read_bytes(&bytes, b"newmtl m\nKd .5 .5 .5\n");
    }
}

fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        8 => (-3i32..9).prop_map(|k| k.to_string()),
        4 => any::<f64>().prop_map(|x| x.to_string()),
        2 => "[-+]?[0-9]{0,3}\\.?[0-9]{0,3}(e[-+]?[0-9]{1,3})?",
        1 => prop::sample::select(vec!["nan", "inf", "-", "/", "1/2/3", "1//", "#", "\\"])
            .prop_map(str::to_string),
    ]
}

fn statement() -> impl Strategy<Value = String> {
    let key = prop::sample::select(vec![
        "v",
        "v",
        "v",
        "f",
        "f",
        "f",
        "f",
        "vt",
        "vn",
        "usemtl",
        "usemtl m",
        "g",
        "o",
        "s",
        "l",
        "p",
        "mtllib",
        "# camera",
        "curv",
        "",
        "v\t",
        "f \\\n",
        "usemtl m\nf",
    ]);
    (key, proptest::collection::vec(number(), 0..7), "[ \t]?\\\\?(\n|\r\n|\r)")
        .prop_map(|(key, numbers, end)| format!("{key} {}{end}", numbers.join(" ")))
}

fn material() -> impl Strategy<Value = String> {
    let key = prop::sample::select(vec![
        "newmtl m", "newmtl", "Kd", "Ks", "Ke", "Ka", "Td", "Tf", "Tr", "d", "Ns",
        "Ni", "illum", "map_Kd", "map_Ke", "map_Ka", "bump", "",
    ]);
    (key, proptest::collection::vec(number(), 0..4))
        .prop_map(|(key, numbers)| format!("{key} {}\n", numbers.join(" ")))
}
