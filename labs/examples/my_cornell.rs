//! The reward of the lab `hemicube`: the Cornell box, lit by your hemicube.
//!
//! ```sh
//! cargo run -p labs --example my_cornell            # out/my_cornell.png
//! cargo run -p labs --example my_cornell -- no-pi   # lit by a played student's
//! ```
//! A mistake in the weights is a mistake in the light: play some wrong students, and
//! look at the picture and at what the ledger says.

use labs::hemicube::given::StudentHemicube;
use labs::hemicube::{Work, starter, wrong};
use radiosity::film::{Format, Shot, write_atomically};
use radiosity::mesh::Mesh;
use radiosity::prelude::Polygon;
use radiosity::scene::built_in;
use radiosity::solve::{Brightest, Enclosure, Shoot, Solver};
use std::error::Error;
use std::path::Path;

/// Enough for the walls to colour each other; some ten seconds.
const SHOTS: usize = 300;

fn main() -> Result<(), Box<dyn Error>> {
    let work = match std::env::args().nth(1) {
        Some(name) => played(&name).ok_or("see `cargo lab list hemicube` for names")?,
        None => &starter::WORK,
    };
    let scene = built_in("cornell")?;
    let mesh = Mesh::uniform(&scene, 0.09);
    let polygons: Vec<Polygon> = mesh.polygons().cloned().collect();
    let hemicube = StudentHemicube::new(work, &polygons, 32);

    let enclosure = Enclosure::of(&scene, &mesh);
    let mut shoot = Shoot::new(&enclosure, &hemicube, Brightest::ByPower);
    let last = shoot.by_ref().take(SHOTS).last();
    println!("{} elements, {SHOTS} shots", mesh.elements.len());
    if let Some(step) = last {
        let ledger = step.ledger;
        println!("in W:     red        green      blue");
        for (name, power) in [
            ("emitted", ledger.emitted),
            ("absorbed", ledger.absorbed),
            ("escaped", ledger.escaped),
            ("unshot", ledger.unshot),
            ("imbalance", ledger.imbalance),
        ] {
            println!("{name:<9} {:10.4} {:10.4} {:10.4}", power.x, power.y, power.z);
        }
    }

    let shot = Shot { camera: scene.camera, width: 512, height: 512, samples: 2 };
    let picture = shot.smooth(&mesh, &mesh.vertex_values(shoot.radiosity()));
    let file = Path::new("out/my_cornell.png");
    std::fs::create_dir_all("out")?;
    write_atomically(file, &picture.encode(Format::Png, picture.auto_exposure())?)?;
    println!("{}", file.display());
    Ok(())
}

fn played(name: &str) -> Option<&'static Work> {
    let mut all = wrong::ALL.iter().flat_map(|group| group.iter());
    match name {
        "answer" => Some(&labs::hemicube::answer::WORK),
        _ => all.find(|played| played.name == name).map(|played| &played.work),
    }
}
