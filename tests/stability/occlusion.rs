//! Pinned failures of visibility, row by row of the table of failures. The curves:
//! `failures/visibility.rs`. (Rows 23 and 28, of pictures of ids: `tests/stability/hemicube.rs`.)

use crate::failures::exact::FACING;
use crate::failures::rooms::{black, gathered, moved, scene};
use crate::failures::shapes::squares_with_screen;
use crate::failures::visibility::{
    self, hard_rays, middles_see, missed, ours, sphere, wire,
};
use glam::{DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::Ray;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::random::Stream;
use radiosity::scene::built_in;
use radiosity::solve::Enclosure;
use radiosity::visibility::Visibility;

/// One ray from middle to middle says all or nothing. It passes the corner of a screen over
/// a quarter of the squares; a hair decides between 0 and 33 % too much.
#[test]
fn row_29_one_ray_decides_all_or_nothing() {
    for (hair, sees) in [(-1e-6, true), (1e-6, false)] {
        let pair = squares_with_screen(0.0..0.5 + hair, 0.0..0.5 + hair);
        assert_eq!(middles_see(&pair), sees);
        let exact = ours(&pair, 1e-6);
        assert!((exact - 0.149_868_671_8).abs() < 2e-6, "{exact}");
    }
    let sweep = visibility::one_ray();
    for &[side, law] in &sweep.theory {
        assert_eq!(sweep.at(side), if side < 0.5 { FACING } else { 0.0 });
        let ours = sweep.by(1, side);
        assert!((ours - law).abs() < 2e-6, "{side}: {ours}, not {law}");
    }
}

/// In millimetres, metres and kilometres the same light, by every method: nothing hides a
/// length of its own.
#[test]
fn row_30_scale_does_not_matter() {
    let solved = |scale: f64| {
        let cornell = built_in("cornell-regular").unwrap();
        let faces = cornell.surfaces.iter().map(|s| {
            let material = cornell.material(s);
            let outline = moved(&s.polygon, |v| scale * v);
            (outline, material.emission().x, material.diffuse().x)
        });
        let scene = self::scene(faces);
        let mesh = Mesh::uniform(&scene, 2.0 * scale);
        let enclosure = Enclosure::of(&scene, &mesh);
        let done = || ();
        [
            Analytic::new(&scene, &mesh, 1e-4, 0).matrix(&done),
            Cast::new(&mesh, 100, 0).matrix(&done),
            Hemicube::new(&mesh, 32).matrix(&done),
        ]
        .map(|matrix| gathered(&enclosure, &matrix, 1e-6, 100))
    };
    let metres = solved(1.0);
    for scale in [1e-3, 1e3] {
        for (method, (here, there)) in metres.iter().zip(solved(scale)).enumerate() {
            assert_eq!(here.len(), there.len());
            let apart = here.iter().zip(&there).map(|(a, b)| (a - b).x.powi(2));
            let all = here.iter().map(|a| a.x.powi(2)).sum::<f64>();
            let apart = (apart.sum::<f64>() / all).sqrt();
            // A pair about to settle may be halved once more; a ray or a cell that grazes
            // an edge may fall on its other side.
            let allowed = [1e-6, 1e-3, 1e-3][method];
            assert!(apart < allowed, "{scale} {method}: {apart}");
        }
    }
}

/// Rays that begin a millimetre on their way pass through what is nearer: four edges times
/// 2/(3π) times the millimetre's share of the room. Without an offset none leaves.
#[test]
fn row_30_an_offset_is_a_length() {
    let sweep = visibility::offsets();
    for &[side, ours] in &sweep.found[1].points {
        assert_eq!(ours, 0.0, "{side}");
    }
    for &[side, law] in sweep.theory.iter().filter(|p| p[0] < 1e3) {
        let got = sweep.at(side);
        // Four standard errors of 20 000 rays, and the corners, of second order.
        let allowed = 4.0 * (law * 100.0 / 2e4).sqrt() + 100.0 * (1e-3 / side).powi(2);
        assert!((got - law).abs() < allowed, "{side}: {got}, not {law}");
    }
    assert!((60.0..75.0).contains(&sweep.at(1e-3)), "{}", sweep.at(1e-3));
}

/// A sphere of triangles that share their corners: rays from inside must all hit, random
/// ones and those aimed at corners and edges. Where each triangle rounds for itself, some
/// slip through.
#[test]
fn row_31_no_ray_leaves_a_closed_sphere() {
    let faces = sphere(24);
    let visibility = Visibility::new(&faces);
    let mut random = Stream::named(1, &[]);
    for _ in 0..1_000_000 {
        let mut point =
            || 2.0 * dvec3(random.next(), random.next(), random.next()) - DVec3::ONE;
        let (origin, direction) = (0.5 * point(), point().normalize());
        let hit = visibility.closest(&Ray { origin, direction }, None);
        assert!(hit.is_some(), "escaped from {origin} along {direction}");
    }
    assert!(hard_rays(&faces).all(|ray| visibility.closest(&ray, None).is_some()));
    let sweep = visibility::cracks();
    for &[rings, ours] in &sweep.found[1].points {
        assert_eq!(ours, 0.0, "{rings}");
        assert!((1.0..12.0).contains(&sweep.at(rings)), "{}", sweep.at(rings));
    }
}

/// A wire is missed by every one of n pairs of points with (1 − p)ⁿ, p its share of the
/// pairs, twice its width at mid-height. Cutting by the wire's cone misses nothing.
#[test]
fn row_32_samples_miss_a_wire() {
    let sweep = visibility::wire_missed();
    for &[pairs, chance] in &sweep.theory {
        let got = sweep.at(pairs);
        // 2000 tries: four standard errors.
        let allowed = 4.0 * (chance * (100.0 - chance) / 2000.0).sqrt();
        assert!((got - chance).abs() < allowed, "{pairs}: {got}, not {chance}");
        assert_eq!(sweep.by(1, pairs), 0.0);
    }
    let width = 0.001;
    for pairs in [100, 500] {
        let got = missed(width, pairs, 2000) / 100.0;
        let chance = (1.0 - 2.0 * width).powi(pairs as i32);
        assert!((got - chance).abs() < 0.04, "{pairs}: {got}, not {chance}");
    }
    let hidden = |width: f64| {
        let scene = black(wire(width));
        let mesh = Mesh::whole(&scene);
        let method = Analytic::new(&scene, &mesh, 1e-7, 1);
        FACING - method.exchange(ElementId(0), ElementId(1))
    };
    // It hides a third of its width, however thin it is.
    let (thin, wide) = (hidden(1e-4), hidden(1e-3));
    assert!((thin / 1e-4 - 0.3312).abs() < 1e-4, "{thin}");
    assert!((wide / thin - 10.0).abs() < 0.05, "{thin} {wide}");
}

/// Visibility averaged over pairs and multiplied with the open factor. A screen over three
/// quarters leaves an eighth of the pairs, and F/8 is 14 % too little: the pairs that still
/// see each other are nearer than the mean. The share of the open area, ¼, is 71 % too much.
#[test]
fn row_33_mean_visibility_is_not_a_factor() {
    let mean = visibility::visible_pairs(0.75);
    assert!((mean - 0.125).abs() < 0.002, "{mean}");
    let sweep = visibility::mean_visibility();
    assert!((sweep.expected(0.75) + 14.35).abs() < 0.1, "{sweep:?}");
    assert!((sweep.by(1, 0.75) - 71.3).abs() < 0.1, "{sweep:?}");
    for &[screen, law] in &sweep.theory {
        let (product, ours) = (sweep.at(screen), sweep.by(2, screen));
        // Means of visibility are known to .002.
        let allowed = 0.2 * (100.0 + law) / visibility::visible_pairs(screen) / 100.0;
        assert!((product - law).abs() < allowed.max(0.3), "{screen}: {product} {law}");
        assert!(ours.abs() < 0.01, "{screen}: {ours} %");
    }
}

/// Of the twelve triangles of a box a tree makes more tests than there are triangles; of a
/// thousand, thirty times fewer. Counted, for time depends on the machine.
#[test]
fn row_34_a_tree_does_not_pay_for_few() {
    let sweep = visibility::tree();
    assert!(sweep.at(12.0) > 12.0, "{sweep:?}");
    assert!(sweep.at(48.0) < 48.0, "{sweep:?}");
    assert!(sweep.at(972.0) < 972.0 / 30.0, "{sweep:?}");
    // 256 times the triangles cost twice the tests: logarithmic.
    let growth = sweep.at(3072.0) / sweep.at(12.0);
    assert!((1.5..3.0).contains(&growth), "{growth}");
}
