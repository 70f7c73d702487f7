//! Every path has one owner: both passes find, class by class, what the path tracer finds.

mod common;

use common::paths::{camera, dull, largest_z, mirror, pane, shine, shiny};
use common::rooms::{box_walls, rectangle};
use glam::{DVec3, dvec3};
use radiosity::film::Shot;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Shine};
use radiosity::scene::Scene;
use radiosity::solve::resolution_for;
use radiosity::trace::{
    CLASSES, Class, Letter, Light, Options, Owner, PathTracer, Table, Word,
    classes_of_two_passes,
};

/// All words of up to 7 letters: each has one class, the pattern of that class fits it and
/// no other, and its owner is told by where its D stand.
#[test]
fn every_word_has_one_class_and_one_owner() {
    let mut met = [0; CLASSES];
    for length in 0..=7 {
        for bits in 0..1_u32 << length {
            let letter =
                |k: u32| if bits >> k & 1 == 1 { Letter::D } else { Letter::S };
            let letters: Vec<Letter> = (0..length).map(letter).collect();
            let class = letters.iter().fold(Word::default(), |w, &l| w.then(l)).class();
            met[class.index()] += 1;
            let first = letters.iter().position(|&l| l == Letter::D);
            let tail = &letters[first.unwrap_or(letters.len())..];
            let (d, s) = (Letter::D, Letter::S);
            let fits = |light: Light| match light {
                Light::Lamp => tail.is_empty(),
                Light::Direct => tail == [d],
                Light::Reflected => tail.len() > 1 && tail.iter().all(|&l| l == d),
                Light::Caustic => tail.len() > 1 && tail[1..].iter().all(|&l| l == s),
                Light::Mixed => {
                    tail.len() > 1 && tail[1..].contains(&d) && tail.contains(&s)
                }
            };
            let fitting: Vec<Class> = Class::all()
                .filter(|c| {
                    fits(c.light) && c.mirrored == (letters.first() == Some(&s))
                })
                .collect();
            assert_eq!(fitting, [class], "{letters:?}");
            let owner = match (first, letters.first()) {
                (None, _) => Owner::Second,
                (_, Some(Letter::D)) => Owner::First,
                _ => Owner::Both,
            };
            assert_eq!(class.owner(), owner, "{letters:?}");
        }
    }
    assert!(met.iter().all(|&count| count > 0), "{met:?}");
    for (k, class) in Class::all().enumerate() {
        assert_eq!(class.index(), k);
    }
}

/// A room with a lamp in its ceiling, and what else is put there. The eye looks at the far
/// wall and a part of all others.
fn room(
    wall: impl Fn(usize) -> Coefficients,
    more: impl IntoIterator<Item = (Polygon, Coefficients)>,
) -> (Scene, Shot) {
    let walls = box_walls([1.0; 3]).into_iter().enumerate().map(|(k, w)| (w, wall(k)));
    let lamp = rectangle(dvec3(0.35, 0.55, 0.98), DVec3::Y * 0.3, DVec3::X * 0.3);
    let scene = shiny(walls.chain([(lamp, dull(10.0, 0.0))]).chain(more));
    let camera = camera(dvec3(0.5, 0.03, 0.5), dvec3(0.5, 1.0, 0.55), 80.0);
    (scene, Shot { camera, width: 32, height: 24, samples: 4 })
}

fn scenes() -> Vec<(&'static str, Scene, Shot)> {
    let grey = |k: usize| dull(0.0, [0.5, 0.6, 0.3, 0.7, 0.4, 0.6][k]);
    let with = |k: usize, other: Coefficients| {
        move |at: usize| if at == k { other } else { grey(at) }
    };
    let gloss = Coefficients {
        diffuse: Rgb::splat(0.2),
        ..shine(Shine::Gloss { reflectance: Rgb::splat(0.6), exponent: 60.0 })
    };
    let window = rectangle(dvec3(0.3, 0.0, 0.0), DVec3::Y, DVec3::Z);
    let all = [
        ("mirror", room(with(0, mirror(0.8)), [])),
        ("pane", room(grey, [(window, pane())])),
        ("gloss", room(with(4, gloss), [])),
    ];
    all.into_iter().map(|(name, (scene, shot))| (name, scene, shot)).collect()
}

/// By both passes, each class from its owner.
fn by_passes(scene: &Scene, shot: &Shot) -> Table {
    let how = resolution_for(scene, 0.01);
    classes_of_two_passes(scene, shot, &how, &Options::default(), &|_, _, _| ())
}

fn by_paths(scene: &Scene, shot: &Shot) -> Table {
    PathTracer::of(scene).picture(shot, 600, 1, &|_, _, _| ()).classes
}

/// A mirror, a pane, gloss: class by class, what both passes find is what paths find, but
/// for chance and 1 % of the light that the passes share.
#[test]
fn both_passes_find_class_by_class_what_paths_find() {
    let scenes = scenes();
    let most = largest_z(scenes.len() * CLASSES);
    let mut bad = false;
    for (name, scene, shot) in &scenes {
        let (ours, paths) = (by_passes(scene, shot), by_paths(scene, shot));
        let lit = paths.total().x - paths.mean[0].x;
        for (row, path) in ours.rows().zip(paths.rows()) {
            let word = row.class.word();
            println!(
                "{name:7} {word:24} {:.5} {:.5} z {:5.1} rel {:.4}",
                row.mean.x,
                path.mean.x,
                (row.mean.x - path.mean.x) / path.error.x,
                (row.mean.x - path.mean.x) / lit
            );
            let off = (row.mean - path.mean).abs().x;
            let allowed = most * path.error.x + 0.01 * lit;
            assert!(
                off <= allowed,
                "{name} {word}: {} not {}",
                row.mean.x,
                path.mean.x
            );
        }
    }
}
