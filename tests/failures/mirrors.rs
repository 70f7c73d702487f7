//! Failures of mirrors, panes and their images: rows 60 to 63, 67 and 68.

use super::mirrored::{diffuse, factor, lamp, mirror, reflected, scene_of, spot};
use super::rooms::{box_walls, moved, rectangle};
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::optics::refract;
use radiosity::scene::Scene;
use radiosity::virtual_world::VirtualWorld;
use std::f64::consts::TAU;

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 60,
        name: "Mirrors that face each other",
        why: "Each image is mirrored again, without end; a program stops after L \
              levels and what is further is missing.",
        size: "Of a lamp between two perfect mirrors one level misses 8.7 % and L \
               levels 1/L³; between four it misses 42 % and 1/L². With mirrors of 0.8 \
               it falls as 0.8ᴸ besides.",
        remedy: "As many levels as the mirrors' share asks for, and the bound on what \
                 was cut stated with the solution.",
        tests: &["mirrors::row_60_mirrors_that_face_each_other"],
        shown: Shown::Curve(levels),
    },
    Row {
        number: 61,
        name: "The whole image is taken",
        why: "A mirror shows an image as a window does: only where the line of sight \
              crosses its outline.",
        size: "Of a mirror that ends at 0.6 the whole image is 42 % too bright, of one \
               that ends at 0.42 it is 18 times too bright; ours is cut by the outline \
               and exact to 1e-12.",
        remedy: "Clip the image to the pyramid from the point through the mirror's \
                 outline, before Lambert's formula.",
        tests: &["mirrors::row_61_an_image_is_seen_through_its_mirror"],
        shown: Shown::Curve(unclipped),
    },
    Row {
        number: 62,
        name: "A blocker on the second leg",
        why: "Light by a mirror goes two legs. Whoever asks for blockers between the floor \
              and the mirror only misses what stands between the mirror and the lamp.",
        size: "A card that hides all of it changes nothing for the wrong method, where \
               0 is due; ours follows the card exactly.",
        remedy: "Mirror the blockers with the lamp, those behind the mirror left out, \
                 and ask along the whole straight line.",
        tests: &["mirrors::row_62_a_card_on_the_second_leg_hides"],
        shown: Shown::Curve(card),
    },
    Row {
        number: 63,
        name: "Worlds multiply",
        why: "m mirrors make m images, each of which the other m − 1 mirror again: m(m \
              − 1)ᴸ⁻¹ at level L.",
        size: "Six mirrors would make 4686 images in five levels. Ours makes the 2958 \
               of them that some window shows, stops at 20 000, and bounds what is \
               cut.",
        remedy: "Drop images that no window shows, stop where the share is below what \
                 was asked for, and state the bound.",
        tests: &["mirrors::row_63_images_multiply_with_each_level"],
        shown: Shown::Curve(images),
    },
    Row {
        number: 67,
        name: "A curved mirror has no image",
        why: "A flat mirror shows a lamp at one place, wherever one looks from; behind \
              a ball the place differs with where the ray meets it.",
        size: "In a ball of radius 1 with the lamp 1 in front, the image lies ⅓ deep \
               where one looks straight on, 0.19 deep by 30° off, and before the ball \
               by 45°. Ours splits a twisted mirror into two flat ones, with a \
               warning.",
        remedy: "Tessellate and give each flat piece its own image, or follow rays in \
                 the second pass.",
        tests: &["mirrors::row_67_a_twisted_mirror_is_two_flat_ones"],
        shown: Shown::Curve(behind_the_ball),
    },
    Row {
        number: 68,
        name: "A thick pane taken for a thin one",
        why: "What is behind glass of thickness t seems nearer by t(1 − 1/n). A thin \
              pane dims and mirrors, but shifts nothing.",
        size: "A lamp 1 m away behind 10 cm of glass is shown 6.6 % too dim, behind a \
               window of 4 mm 0.27 %.",
        remedy: "Panes for windows; a solid with two faces, seen by rays in the second \
                 pass, for what is thick.",
        tests: &["mirrors::row_68_a_thick_pane_brings_the_world_nearer"],
        shown: Shown::Curve(thick_pane),
    },
];

/// The factor from the origin, looking up, to the rectangle `[x0, x1] × [−½, ½]` at
/// height 1: the sum of corners of Howell's catalogue, and no code of the crate.
pub fn from_origin(x0: f64, x1: f64) -> f64 {
    let corner = |a: f64, b: f64| {
        let [u, v] = [a, b].map(|w| (1.0 + w * w).sqrt());
        (a / u * (b / u).atan() + b / v * (a / v).atan()) / TAU
    };
    2.0 * (corner(x1, 0.5) - corner(x0, 0.5))
}

/// A mirror `x = ±½` as wide and high as matters, looking inwards.
fn endless(side: f64, share: f64) -> (Polygon, radiosity::material::Coefficients) {
    let (y, z) = (4000.0 * DVec3::Y, 4000.0 * DVec3::Z);
    let corner = dvec3(0.5 * side, 0.0, 0.0) - 0.5 * (y + z);
    let (a, b) = if side < 0.0 { (y, z) } else { (z, y) };
    (rectangle(corner, a, b), mirror(share))
}

/// The factor from the spot to the lamp by up to 0, 1, … reflections.
fn by_levels(
    mirrors: Vec<(Polygon, radiosity::material::Coefficients)>,
    most: u32,
) -> Vec<f64> {
    let faces = [(spot(), diffuse(0.0, 0.5)), (lamp(), diffuse(1.0, 0.0))];
    let scene = scene_of(faces.into_iter().chain(mirrors));
    let world = VirtualWorld::of(&scene, 1);
    let each = world.factors_by_level(DVec3::ZERO, DVec3::Z, &lamp(), most);
    each.iter()
        .scan(0.0, |sum, level| {
            *sum += level.x;
            Some(*sum)
        })
        .collect()
}

/// Four mirrors about a unit square, below the lamp.
pub fn four_mirrors(share: f64) -> Vec<(Polygon, radiosity::material::Coefficients)> {
    let by = -dvec3(0.5, 0.5, 0.0);
    let walls = box_walls([1.0; 3]);
    walls[..4].iter().map(|w| (moved(w, |v| v + by), mirror(share))).collect()
}

/// Row 60: what a corridor of mirrors and a square of mirrors miss when cut after so
/// many levels.
pub fn levels() -> Sweep {
    let knobs = [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0];
    let corridor =
        |share: f64| by_levels(vec![endless(-1.0, share), endless(1.0, share)], 16);
    let (clear, four) = (corridor(1.0), by_levels(four_mirrors(1.0), 16));
    let dim = by_levels(vec![endless(-1.0, 0.8), endless(1.0, 0.8)], 60);
    let missing = |sums: &[f64], all: f64| {
        curve(&knobs, |l| 100.0 * (1.0 - sums[l as usize] / all))
    };
    // Image k fills k − ½ < x < k + ½.
    let image = |k: i32| from_origin(f64::from(k) - 0.5, f64::from(k) + 0.5);
    let lacks = |l: f64| {
        let seen: f64 = (-(l as i32)..=l as i32).map(image).sum();
        100.0 * (1.0 - seen * 5f64.sqrt())
    };
    Sweep {
        knob: "levels of images",
        quantity: "light that is missing, %",
        logarithmic: [true, true],
        found: vec![
            Found {
                method: "two perfect mirrors",
                points: missing(&clear, 5f64.sqrt().recip()),
            },
            Found { method: "four", points: missing(&four, 1.0) },
            Found { method: "two of 0.8", points: missing(&dim, dim[60]) },
        ],
        theory: curve(&knobs, lacks),
        law: "1/√5 less the closed forms of the images",
    }
}

/// The mirror `x = 1` that ends at `z = top`, and perhaps a card.
pub fn screen(top: f64, card: Option<Polygon>) -> (Scene, VirtualWorld) {
    let wall =
        rectangle(dvec3(1.0, -50.0, -50.0), (50.0 + top) * DVec3::Z, 100.0 * DVec3::Y);
    let faces =
        [(spot(), diffuse(0.0, 0.5)), (lamp(), diffuse(1.0, 0.0)), (wall, mirror(1.0))];
    let card = card.map(|p| (p, diffuse(0.0, 0.5)));
    let scene = scene_of(faces.into_iter().chain(card));
    let world = VirtualWorld::of(&scene, 1);
    (scene, world)
}

/// Row 61: the image of a lamp in a mirror that ends at some height: the lamp's image
/// fills `1.5 < x < 2.5` at height 1, and shows where `1/x` is below the mirror's end.
pub fn unclipped() -> Sweep {
    let tops: Vec<f64> = (42..=70).step_by(2).map(|k| f64::from(k) / 100.0).collect();
    let whole = |top: f64| {
        let image = screen(top, None).1.images()[1].of_polygon(&lamp());
        lambert_polygon(DVec3::ZERO, DVec3::Z, &image)
    };
    Sweep {
        knob: "height of the mirror",
        quantity: "factor to the mirrored lamp",
        logarithmic: [false, false],
        found: vec![
            Found::over("the whole image", &tops, whole),
            Found::over("ours: through the outline", &tops, |top| {
                reflected(&screen(top, None).1)
            }),
        ],
        theory: curve(&tops, |top| from_origin((1.0 / top).clamp(1.5, 2.5), 2.5)),
        law: "what shows, in closed form",
    }
}

/// The card `x = 0.52` that begins at this height.
pub fn card_from(low: f64) -> Polygon {
    rectangle(dvec3(0.52, -20.0, low), 0.8 * DVec3::Z, 40.0 * DVec3::Y)
}

/// The image in the mirror that ends at 0.6, with blockers asked for on the first leg
/// only.
pub fn first_leg_only(card: Polygon) -> f64 {
    let (_, world) = screen(0.6, Some(card));
    let image = &world.images()[1];
    let seen = image.clip(DVec3::ZERO, image.of_polygon(&lamp()).vertices()).unwrap();
    lambert_polygon(DVec3::ZERO, DVec3::Z, &Polygon::new(seen.to_vec()).unwrap())
}

/// Row 62: a card is let down between mirror and lamp. Unfolded it stands at `x =
/// 1.48`, and the line to `(x, 1)` crosses it at the height `1.48/x`.
pub fn card() -> Sweep {
    let lows: Vec<f64> = (0..=12).map(|k| 0.56 + 0.03 * f64::from(k)).collect();
    Sweep {
        knob: "lower edge of the card",
        quantity: "factor to the mirrored lamp",
        logarithmic: [false, false],
        found: vec![
            Found::over("blockers of the first leg", &lows, |low| {
                first_leg_only(card_from(low))
            }),
            Found::over("ours: of both", &lows, |low| {
                reflected(&screen(0.6, Some(card_from(low))).1)
            }),
        ],
        theory: curve(&lows, |low| {
            from_origin((1.48 / low).clamp(1.0 / 0.6, 2.5), 2.5)
        }),
        law: "what the card leaves, in closed form",
    }
}

/// A room of `m` mirrors, the other walls dull.
fn room_of(m: usize) -> Scene {
    let material = |k: usize| if k < m { mirror(0.9) } else { diffuse(1.0, 0.5) };
    scene_of(box_walls([1.0; 3]).into_iter().enumerate().map(|(k, w)| (w, material(k))))
}

/// Row 63: images that a room of mirrors makes.
pub fn images() -> Sweep {
    let levels = [1.0, 2.0, 3.0, 4.0, 5.0];
    let count = |m: usize| {
        let room = room_of(m);
        move |l: f64| (VirtualWorld::of(&room, l as u32).images().len() - 1) as f64
    };
    let all = |m: f64, l: f64| (1..=l as i32).map(|k| m * (m - 1.0).powi(k - 1)).sum();
    Sweep {
        knob: "levels",
        quantity: "images",
        logarithmic: [false, true],
        found: vec![
            Found::over("six mirrors", &levels, count(6)),
            Found::over("four", &levels, count(4)),
            Found::over("two that face each other", &levels, count(2)),
        ],
        theory: curve(&levels, |l| all(6.0, l)),
        law: "6 · 5ᴸ⁻¹ at level L, added up",
    }
}

/// Where the image of a lamp at `(0, 0, 2)` in a flat mirror seems to lie on the axis,
/// as seen along the ray that meets the unit ball so many degrees off the axis: how
/// deep behind the ball's top. The mirror touches the ball there.
fn depth_in_facet(degrees: f64) -> f64 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let touch = dvec3(sin, 0.0, cos);
    let along = dvec3(cos, 0.0, -sin);
    let corner = touch - 0.01 * (along + DVec3::Y);
    let facet = rectangle(corner, 0.02 * along, 0.02 * DVec3::Y);
    let facet = if facet.normal().dot(touch) > 0.0 { facet } else { facet.flipped() };
    let scene = scene_of([(spot(), diffuse(1.0, 0.5)), (facet, mirror(1.0))]);
    let image = VirtualWorld::of(&scene, 1).images()[1].of_point(2.0 * DVec3::Z);
    // The line through the image and the place where it is seen crosses the axis.
    1.0 - (touch.z - touch.x * (image.z - touch.z) / (image.x - touch.x))
}

/// Row 67: the image of a lamp in a ball of mirrors, a ray at a time.
pub fn behind_the_ball() -> Sweep {
    let angles: Vec<f64> = (1..=9).map(|k| 5.0 * f64::from(k)).collect();
    Sweep {
        knob: "where the ray meets the ball, degrees off the axis",
        quantity: "depth of the lamp's image",
        logarithmic: [false, false],
        found: vec![
            Found::over("ball of radius 1", &angles, depth_in_facet),
            Found::over("flat mirror", &angles, |_| 1.0),
        ],
        theory: curve(&angles, |degrees| {
            let phi = degrees.to_radians();
            let incidence = phi + phi.sin().atan2(2.0 - phi.cos());
            1.0 - incidence.sin() / (phi + incidence).sin()
        }),
        law: "1 − sin i/sin(φ + i); 1/d′ = 1/d + 2/r on the axis",
    }
}

/// How far a thing 1 m away seems behind glass of this thickness and index 1.5, seen
/// nearly straight on.
pub fn seems_away(thickness: f64) -> f64 {
    let angle = 1e-4_f64;
    let down = dvec3(angle.sin(), 0.0, -angle.cos());
    let inside = refract(down, DVec3::Z, 1.0 / 1.5).unwrap();
    let across = (1.0 - thickness) * angle.tan() - thickness * inside.x / inside.z;
    across / angle.tan()
}

/// Row 68: how much too dim a thin pane shows a small lamp behind thick glass, whose
/// light falls as the square of how far it seems.
pub fn thick_pane() -> Sweep {
    let thicknesses = [0.001, 0.002, 0.004, 0.01, 0.02, 0.05, 0.1, 0.2];
    let law = |t: f64| 100.0 * (1.0 - (1.0 - t * (1.0 - 1.0 / 1.5)).powi(2));
    Sweep {
        knob: "thickness of the glass, m; the lamp is 1 m away",
        quantity: "light that a thin pane lacks, %",
        logarithmic: [true, true],
        found: vec![Found::over("thin pane, against Snell's law", &thicknesses, |t| {
            100.0 * (1.0 - seems_away(t).powi(2))
        })],
        theory: curve(&thicknesses, law),
        law: "1 − (1 − t(1 − 1/n))²",
    }
}

/// What a mirror world says is cut after `levels`, of light of 1 at the most.
pub fn bound_of_six(levels: u32) -> (u32, f64) {
    let world = VirtualWorld::of(&room_of(6), levels);
    (world.levels(), world.cut_bound(Rgb::ONE).x)
}

/// What the spot sees of the lamp by two mirrors of this share, `levels` deep, by the
/// sights that pass 1 takes.
pub fn corridor(share: f64, levels: u32) -> f64 {
    let faces = [(spot(), diffuse(0.0, 0.5)), (lamp(), diffuse(1.0, 0.0))];
    let mirrors = [endless(-1.0, share), endless(1.0, share)];
    let world = VirtualWorld::of(&scene_of(faces.into_iter().chain(mirrors)), levels);
    factor(&world, DVec3::ZERO, &spot(), &lamp()).x
}
