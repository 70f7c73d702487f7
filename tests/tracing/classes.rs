//! Every path has one owner: both passes find, class by class, what the path tracer finds.

use crate::common::paths::largest_z;
use radiosity::field::Pass1;
use radiosity::field::Smooth;
use radiosity::film::Shot;
use radiosity::geometry::Rgb;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::trace::{
    ByClass, CLASSES, Class, Letter, Light, Look, Owner, PathTracer, Word,
};
use std::f64::consts::PI;

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

/// The built-in scenes that shine in one way each, small.
fn scenes() -> Vec<(&'static str, Scene, Shot)> {
    let names = ["mirror-room", "cornell-mirror", "cornell-pane", "glossy-floor"];
    let shot = |name| {
        let scene = built_in(name).unwrap();
        let shot = Shot { camera: scene.camera, width: 24, height: 18, samples: 4 };
        (name, scene, shot)
    };
    names.map(shot).into()
}

/// A mirror, a mirror block, a pane, gloss: class by class and channel by channel, what both
/// passes find is what paths find, but for chance, 1.5 % of the light that the passes share,
/// and of the lamps one row of samples across a tenth of the picture: where the edge of a lamp
/// runs along the rows, so much is won or lost at once.
#[test]
fn both_passes_find_class_by_class_what_paths_find() {
    let scenes = scenes();
    let most = largest_z(scenes.len() * CLASSES * 3);
    let mut faults = vec![];
    for (name, scene, shot) in &scenes {
        let how = Smooth.first(&Room::of(scene), 0.02);
        let options = Look::default();
        let ours = ByClass::of(scene, shot, &how, &options, &|_, _, _| ()).table();
        let paths = PathTracer::of(&Room::of(scene))
            .picture(shot, 256, 1, &|_, _, _| ())
            .classes;
        let lamps = |c: Class| c.light == Light::Lamp;
        let lit = paths.rows().filter(|row| !lamps(row.class)).map(|row| row.mean);
        let lit: Rgb = lit.sum();
        let emission = scene.materials.iter().map(|m| m.emission());
        let lamp = emission.fold(Rgb::ZERO, Rgb::max) / PI;
        let row_of_lamp = 0.1 * lamp / f64::from(shot.height * shot.samples);
        for (row, path) in ours.rows().zip(paths.rows()) {
            let shared = if lamps(row.class) { row_of_lamp } else { 0.015 * lit };
            let off = row.mean - path.mean;
            if off.abs().cmpgt(most * path.error + shared).any() {
                let (word, error) = (row.class.word(), path.error);
                let (got, right) = (row.mean, path.mean);
                faults.push(format!("{name}, {word}: {got}, not {right} ± {error}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
