//! Mirrors: images, their windows, and what stands in the way.

use crate::common::mirrored::{
    diffuse, factor, lamp, mirror, reflected, scene_of, spot,
};
use crate::common::rooms::rectangle;
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::Shine;
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use radiosity::scene::Scene;
use radiosity::virtual_world::VirtualWorld;
use radiosity::visibility::Visibility;

/// A mirror `x = ±½` as wide and high as matters, looking inwards.
fn wall(side: f64, share: f64) -> (Polygon, radiosity::material::Coefficients) {
    let (y, z) = (4000.0 * DVec3::Y, 4000.0 * DVec3::Z);
    let corner = dvec3(0.5 * side, 0.0, 0.0) - 0.5 * (y + z);
    let (a, b) = if side < 0.0 { (y, z) } else { (z, y) };
    (rectangle(corner, a, b), mirror(share))
}

/// What a small floor between two mirrors sees of a lamp above it: `F(levels)`.
fn corridor(share: f64, levels: u32) -> f64 {
    let lamp = lamp();
    let scene = scene_of([
        (spot(), diffuse(0.0, 0.5)),
        (lamp.clone(), diffuse(1.0, 0.0)),
        wall(-1.0, share),
        wall(1.0, share),
    ]);
    let world = VirtualWorld::of(&scene, levels);
    assert_eq!(world.levels(), levels);
    factor(&world, DVec3::ZERO, &spot(), &lamp).x
}

/// The images of a corridor of perfect mirrors make the lamp an endless strip, `1/√5`; what
/// each number of levels misses.
#[test]
fn a_mirror_corridor_misses_what_is_cut() {
    let table = [
        (1.0, 5f64.sqrt().recip(), [46.5, 8.7, 2.5, 0.49, 0.08]),
        (0.9, 0.4213645182, [43.2, 7.1, 1.8, 0.26, 0.02]),
        (0.5, 0.3317966348, [27.8, 2.4, 0.31, 0.012, 0.0]),
    ];
    for (share, limit, missing) in table {
        for (levels, missing) in [0, 1, 2, 4, 8].into_iter().zip(missing) {
            let missed = 100.0 * (1.0 - corridor(share, levels) / limit);
            let rounding = 0.5 * 10f64.powi(if missing >= 1.0 { -1 } else { -2 });
            assert!((missed - missing).abs() <= rounding, "{share} {levels}: {missed}");
        }
    }
}

/// The more levels, the nearer to the closed form: what is missing falls as `1/L³`.
#[test]
fn an_endless_corridor_is_one_over_the_root_of_five() {
    // The image k fills k − ½ < x < k + ½; from afar it is seen under cosines of 1/k
    // each, and small as 1/k² beside: its factor falls as 1/k⁴.
    let limit = 5f64.sqrt().recip();
    let errors = [100, 200].map(|levels| limit - corridor(1.0, levels));
    assert!(errors[0] < 2.2e-7 && errors[1] < 3e-8, "{errors:?}");
    let order = (errors[0] / errors[1]).log2();
    assert!((order - 3.0).abs() < 0.05, "{order}");
    for (share, limit) in [(0.9, 0.4213645182), (0.5, 0.3317966348)] {
        assert!((corridor(share, 120) - limit).abs() < 1e-10);
    }
}

/// The mirror `x = 1`, `|y| ≤ 50`, up to `z = top`.
fn screen(top: f64) -> Polygon {
    rectangle(dvec3(1.0, -50.0, -50.0), (50.0 + top) * DVec3::Z, 100.0 * DVec3::Y)
}

fn by_screen(top: f64, more: Option<Polygon>) -> (Scene, VirtualWorld) {
    let faces = [
        (spot(), diffuse(0.0, 0.5)),
        (lamp(), diffuse(1.0, 0.0)),
        (screen(top), mirror(1.0)),
    ];
    let more = more.into_iter().map(|p| (p, diffuse(0.0, 0.5)));
    let scene = scene_of(faces.into_iter().chain(more));
    let world = VirtualWorld::of(&scene, 1);
    (scene, world)
}

/// An image is seen through the mirror's outline only.
#[test]
fn a_low_mirror_shows_a_part_of_the_lamp() {
    let clipped = reflected(&by_screen(0.6, None).1);
    assert!((clipped - 0.009785756793).abs() < 1e-12, "{clipped}");
    let whole = reflected(&by_screen(50.0, None).1);
    assert!((whole - 0.013923717407).abs() < 1e-12, "{whole}");
}

/// A card on either leg hides the image, and one behind the mirror hides nothing.
#[test]
fn a_card_hides_an_image_on_either_leg() {
    let card =
        |x: f64, z: f64| rectangle(dvec3(x, -20.0, z), 0.1 * DVec3::X, 40.0 * DVec3::Y);
    let first = by_screen(
        50.0,
        Some(rectangle(dvec3(0.4, -20.0, 0.0), 0.9 * DVec3::Z, 40.0 * DVec3::Y)),
    );
    assert_eq!(reflected(&first.1), 0.0);
    // from the lamp's edge at x = ½ to the mirror, above all first legs
    let second = by_screen(
        50.0,
        Some(rectangle(dvec3(0.52, -20.0, 0.55), 0.5 * DVec3::Z, 40.0 * DVec3::Y)),
    );
    assert_eq!(reflected(&second.1), 0.0);
    let behind = by_screen(50.0, Some(card(1.2, 0.3)));
    assert!((reflected(&behind.1) - 0.013923717407).abs() < 1e-12);
}

/// Light that rays find on their way through mirrors, as an independent count.
fn by_rays(
    scene: &Scene,
    levels: u32,
    x: DVec3,
    n: DVec3,
    target: u32,
    rays: usize,
) -> f64 {
    let visibility = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let frame = radiosity::geometry::Frame::about(n);
    let mut found = 0.0;
    for u in Stream::named(7, &[]).points(rays) {
        let [a, b] = u;
        let local = cosine_direction(glam::dvec2(a, b));
        let mut ray = Ray { origin: x, direction: frame.world_from_local(local) };
        let (mut leaving, mut weight) = (None, 1.0);
        for _ in 0..=levels {
            let Some(hit) = visibility.closest(&ray, leaving) else { break };
            if !hit.front {
                break;
            }
            if hit.item == target {
                found += weight;
                break;
            }
            let surface = &scene.surfaces[hit.item as usize];
            let Shine::Mirror { reflectance } = scene.material(surface).shine() else {
                break;
            };
            weight *= reflectance.x;
            let origin = ray.origin + hit.distance * ray.direction;
            let normal = surface.polygon.normal();
            let direction = radiosity::material::optics::reflect(ray.direction, normal);
            (ray, leaving) = (Ray { origin, direction }, Some(hit.item));
        }
    }
    found / rays as f64
}

/// Mirrors that stand anyhow, blockers that straddle their planes, up to three reflections:
/// the images see what rays see.
#[test]
fn images_see_what_rays_see() {
    let mut random = Stream::named(11, &[]);
    let mut worst = 0.0_f64;
    for _ in 0..12 {
        let mut at = |size: f64| {
            size * (2.0 * dvec3(random.next(), random.next(), random.next())
                - DVec3::ONE)
        };
        let mut card = |size: f64| loop {
            let (middle, a, b) = (at(1.0), at(size), at(size));
            let corners = vec![middle - a, middle - b, middle + a, middle + b];
            if let Ok(card) = Polygon::new(corners) {
                return card;
            }
        };
        let target = card(0.8);
        let mut faces = vec![(target.clone(), diffuse(1.0, 0.0))];
        faces.extend((0..4).map(|_| (card(1.2), mirror(0.9))));
        faces.extend((0..3).map(|_| (card(0.5), diffuse(0.0, 0.5))));
        let scene = scene_of(faces);
        let world = VirtualWorld::of(&scene, 3);
        let (x, n) = (at(0.7), at(1.0).normalize());
        let frame = radiosity::geometry::Frame::about(n);
        let piece = Polygon::new(vec![
            x - 1e-3 * frame.x,
            x - 1e-3 * frame.y,
            x + 1e-3 * frame.x,
            x + 1e-3 * frame.y,
        ]);
        let piece = piece.unwrap();
        let (got, rays) = (factor(&world, x, &piece, &target).x, 200_000);
        let want = by_rays(&scene, 3, x, n, 0, rays);
        let beams = world.factors_by_level(x, n, &target, 3).iter().sum::<Rgb>().x;
        assert!((got - beams).abs() < 1e-12, "{got} {beams}");
        let sigma = (want.max(1e-4) / rays as f64).sqrt();
        worst = worst.max((got - want).abs() / sigma);
        assert!((got - want).abs() < 4.0 * sigma, "{got} {want} ± {sigma:e}");
    }
    assert!(worst > 0.01, "nothing was seen at all");
}

/// The back of a mirror is black: it shows no image, and hides what is behind it.
#[test]
fn no_light_comes_through_the_back_of_a_mirror() {
    let turned = scene_of([
        (spot(), diffuse(0.0, 0.5)),
        (lamp(), diffuse(1.0, 0.0)),
        (screen(50.0).flipped(), mirror(1.0)),
    ]);
    assert_eq!(reflected(&VirtualWorld::of(&turned, 3)), 0.0);
    let between = rectangle(dvec3(-2.0, -2.0, 0.5), 4.0 * DVec3::X, 4.0 * DVec3::Y);
    for between in [between.clone(), between.flipped()] {
        let scene = scene_of([
            (spot(), diffuse(0.0, 0.5)),
            (lamp(), diffuse(1.0, 0.0)),
            (between, mirror(1.0)),
        ]);
        let world = VirtualWorld::of(&scene, 3);
        assert_eq!(factor(&world, DVec3::ZERO, &spot(), &lamp()), Rgb::ZERO);
    }
}

/// A square of four perfect mirrors below the lamp that is their lid.
fn kaleidoscope(share: f64) -> (Scene, Polygon) {
    let lamp = lamp();
    let walls = crate::common::rooms::box_walls([1.0; 3]);
    let by = -dvec3(0.5, 0.5, 0.0);
    let walls = walls[..4].iter().map(|w| crate::common::rooms::moved(w, |v| v + by));
    let faces = [(spot(), diffuse(0.0, 0.5)), (lamp.clone(), diffuse(1.0, 0.0))];
    let walls = walls.map(|w| (w, mirror(share)));
    (scene_of(faces.into_iter().chain(walls)), lamp)
}

fn kaleidoscope_by_level(share: f64, levels: u32) -> Vec<f64> {
    let (scene, lamp) = kaleidoscope(share);
    let world = VirtualWorld::of(&scene, 0);
    let found = world.factors_by_level(DVec3::ZERO, DVec3::Z, &lamp, levels);
    let sums = found.iter().scan(0.0, |sum, f| {
        *sum += f.x;
        Some(*sum)
    });
    sums.collect()
}

/// Four perfect mirrors: everything is lamp, `F → 1`, and `1.6/L²` of it is missing: 1e-5
/// after 410 levels, or after 200 when what is missing is extrapolated by that law.
#[test]
fn a_kaleidoscope_is_all_lamp_in_the_end() {
    let sums = kaleidoscope_by_level(1.0, 410);
    for (level, missing) in [(1, 0.423), (2, 0.209), (4, 0.075), (8, 0.022)] {
        let missed = 1.0 - sums[level];
        assert!((missed - missing).abs() < 6e-4, "{level}: {missed}");
    }
    assert!((sums[1] - 0.576871128).abs() < 1e-9);
    for level in [50, 100, 200, 400] {
        let law = (1.0 - sums[level]) * (level as f64).powi(2);
        assert!((law - 1.6).abs() < 0.1, "{level}: {law}");
    }
    assert!(1.0 - sums[410] < 1e-5, "{:e}", 1.0 - sums[410]);
    let law = sums[200] + (sums[200] - sums[100]) / 3.0;
    assert!((law - 1.0).abs() < 1e-5, "{law}");
}

#[test]
fn a_dim_kaleidoscope_converges_like_its_mirrors() {
    let sums = kaleidoscope_by_level(0.5, 60);
    let limit = 0.4767644247;
    for (level, missing) in [(1, 14.4), (2, 3.2), (4, 0.22)] {
        let missed = 100.0 * (1.0 - sums[level] / limit);
        assert!((missed - missing).abs() < 0.051, "{level}: {missed}");
    }
    assert!((sums[60] - limit).abs() < 1e-10);
}

/// Beams that are joined see what all chains see one by one.
#[test]
fn joined_beams_see_what_chains_see() {
    let (scene, lamp) = kaleidoscope(0.9);
    let world = VirtualWorld::of(&scene, 5);
    let all = 1 + 4 * (1 + 3 + 9 + 27 + 81);
    assert!((200..all).contains(&world.images().len())); // some chains cannot be
    let chains = factor(&world, DVec3::ZERO, &spot(), &lamp).x;
    let x = DVec3::ZERO;
    let beams = world.factors_by_level(x, DVec3::Z, &lamp, 5);
    let beams: Rgb = beams.iter().sum();
    assert!((chains - beams.x).abs() < 1e-12, "{chains} {beams}");
}
