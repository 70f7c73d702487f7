//! The same input gives the same bytes, whatever the number of threads.

use super::Folder;

fn same(arguments: &str, name: &str) {
    let folder = Folder::new();
    let made = |threads: usize| {
        folder.run(&format!("{arguments} -o {name} --threads {threads}")).done();
        folder.read(name)
    };
    assert!(made(1) == made(2), "radiosity {arguments} -o {name}");
}

/// By the command's own choice and by other methods, at errors that no first coarse mesh
/// reaches.
#[test]
fn solutions() {
    same("solve l-room --tolerance 2%", "x.csv");
    same("solve cornell-regular --tolerance 15% --method gather", "x.csv");
    let sampling = "--form-factors sampling --samples 500 --seed 3";
    same(&format!("solve facing-squares --tolerance 3% {sampling}"), "x.ply");
    same("solve facing-squares --tolerance 2%", "x.json");
}

#[test]
fn pictures() {
    for name in ["x.png", "x.hdr", "x.exr"] {
        same("render l-room --size 64x48 --tolerance 5%", name);
    }
    same(
        "render l-room --size 64x48 --tolerance 5% --view mesh --shading flat",
        "x.png",
    );
    same("render l-room --size 64x48 --tolerance 5% --view false-color", "x.png");
    same("render l-room --size 64x48 --tolerance 5% --view error", "x.png");
}

#[test]
fn matrices() {
    for method in ["analytic", "hemicube", "sampling"] {
        same(
            &format!("form-factors l-room --tolerance 1e-2 --method {method}"),
            "x.npy",
        );
    }
}

/// Another seed is another answer where rays are drawn.
#[test]
fn the_seed_counts() {
    let folder = Folder::new();
    let with = |seed: u64| {
        let arguments =
            "form-factors furnace -o x.npy --method sampling --samples 1000";
        folder.run(&format!("{arguments} --seed {seed}")).done();
        folder.read("x.npy")
    };
    assert!(with(1) != with(2) && with(1) == with(1));
}
