//! The hierarchy of rays against tests of every polygon, which know nothing of boxes: what
//! is surely met is found, what is found can be met, whatever the ray's direction.

use glam::{DVec3, dvec3};
use radiosity::film::Shot;
use radiosity::geometry::{Polygon, Ray};
use radiosity::obj;
use radiosity::random::Stream;
use radiosity::raster::View;
use radiosity::room::Room;
use radiosity::scene::Camera;
use radiosity::trace::{Look, Whitted};
use radiosity::visibility::{Hit, Visibility};

/// Scenes here have a size of about 20, so positions are rounded by some 1e-14.
const MARGIN: f64 = 1e-9;

/// How far along the ray the polygon's plane is met, and how deep in the polygon: the
/// distance to its nearest edge, negative outside. `None` for a ray along the plane.
fn crossing(polygon: &Polygon, ray: &Ray) -> Option<(f64, f64)> {
    let (v, normal) = (polygon.vertices(), polygon.normal());
    let along = normal.dot(ray.direction);
    if along.abs() < MARGIN {
        return None;
    }
    let distance = normal.dot(v[0] - ray.origin) / along;
    let foot = ray.origin + distance * ray.direction;
    let within = |k: usize| {
        let edge = (v[(k + 1) % v.len()] - v[k]).normalize();
        normal.cross(edge).dot(foot - v[k])
    };
    Some((distance, (0..v.len()).map(within).fold(f64::INFINITY, f64::min)))
}

/// Holds what was found against every polygon by itself.
fn check(polygons: &[Polygon], ray: &Ray, found: Option<Hit>) {
    let met = |item: usize| crossing(&polygons[item], ray);
    let end = match found {
        Some(hit) => {
            let (distance, depth) =
                met(hit.item as usize).expect("not along its plane");
            assert!(depth > -MARGIN, "{ray:?} misses {hit:?} by {}", -depth);
            assert!((distance - hit.distance).abs() < MARGIN, "{ray:?}: {hit:?}");
            let towards = polygons[hit.item as usize].normal().dot(ray.direction) < 0.0;
            assert_eq!(hit.front, towards, "{ray:?}: {hit:?}");
            hit.distance - MARGIN
        }
        None => f64::INFINITY,
    };
    for item in 0..polygons.len() {
        if let Some((distance, depth)) = met(item) {
            let sure = depth > MARGIN && distance > MARGIN && distance < end;
            assert!(!sure, "{ray:?} lost item {item} at {distance}, found {found:?}");
        }
    }
}

/// Numbers that are hardly there: both zeros, the smallest of all, one whose reciprocal
/// overflows, and the like, up to what rounding drops.
const NEARLY_ZERO: [f64; 10] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    1e-310,
    -1e-310,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    1e-200,
    -1e-30,
];

/// A wall of 16 × 16 unit squares at height 6 along `axis`, looking down it, and the map
/// from (across, across, along) to space.
fn tiles(axis: usize) -> (Vec<Polygon>, impl Fn(f64, f64, f64) -> DVec3) {
    let place = move |x: f64, y: f64, z: f64| match axis {
        0 => dvec3(z, x, y),
        1 => dvec3(y, z, x),
        _ => dvec3(x, y, z),
    };
    let tile = |k: usize| {
        let (x, y) = ((k % 16) as f64 - 8.0, (k / 16) as f64 - 8.0);
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let corners = corners.map(|(dx, dy)| place(x + dx, y + dy, 6.0));
        Polygon::new(corners.to_vec()).expect("a square")
    };
    ((0..256).map(tile).collect(), place)
}

#[test]
fn rays_along_an_axis_meet_corners_and_edges_of_tiles() {
    for axis in 0..3 {
        let (wall, place) = tiles(axis);
        let all = Visibility::new(&wall);
        let steps = || (-15..=15).map(|k| 0.5 * f64::from(k)); // corners, edges, middles
        for (x, y) in steps().flat_map(|x| steps().map(move |y| (x, y))) {
            for (dx, dy) in NEARLY_ZERO.into_iter().zip(NEARLY_ZERO.into_iter().rev()) {
                for (start, along) in [(0.0, 1.0), (9.0, -1.0)] {
                    let (origin, direction) =
                        (place(x, y, start), place(dx, dy, along));
                    let hit = all.closest(&Ray { origin, direction }, None);
                    let hit = hit.unwrap_or_else(|| panic!("{origin} {direction:?}"));
                    assert_eq!(hit.distance, (6.0 - start) * along);
                    assert_eq!(hit.front, along > 0.0);
                }
            }
        }
    }
}

#[test]
fn rays_within_the_planes_between_tiles_meet_them() {
    let mut random = Stream::named(5, &[]);
    for axis in 0..3 {
        let (wall, place) = tiles(axis);
        let all = Visibility::new(&wall);
        for k in 0..1500 {
            let x = f64::from(k % 15 - 7);
            let (from, to) = (14.0 * random.next() - 7.0, 14.0 * random.next() - 7.0);
            let origin = place(x, from, 0.0);
            for zero in NEARLY_ZERO {
                let direction = place(x, to, 6.0) - origin;
                let length = direction.length();
                let direction = (direction + place(zero, 0.0, 0.0)) / length;
                let hit = all.closest(&Ray { origin, direction }, None);
                let hit = hit.unwrap_or_else(|| panic!("{origin} {direction:?}"));
                assert!((hit.distance - length).abs() < 1e-14 * length, "{hit:?}");
            }
        }
    }
}

/// Rectangles and slanted triangles with corners on whole numbers, so that rays from whole
/// numbers along the axes start in planes, and run in planes and through edges.
fn blocks(random: &mut Stream) -> Vec<Polygon> {
    let mut whole = |size: f64| (random.next() * size).floor();
    let mut all = Vec::new();
    while all.len() < 300 {
        let at = dvec3(whole(9.0), whole(9.0), whole(9.0));
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|e| e * (1.0 + whole(3.0)));
        let outlines: [&[DVec3]; 5] = [
            &[at, at + x, at + x + y, at + y],
            &[at + z, at + x + z, at + x + y + z, at + y + z],
            &[at, at + x, at + x + z, at + z],
            &[at, at + y, at + y + z, at + z],
            &[at + x, at + y, at + z],
        ];
        all.extend(outlines.map(|o| Polygon::new(o.to_vec()).expect("convex")));
    }
    all
}

#[test]
fn special_directions_lose_nothing() {
    let mut random = Stream::named(6, &[]);
    let soup = blocks(&mut random);
    // Each is met through its four parts: edges and corners lie where a ray surely meets.
    let parts: Vec<_> = soup.iter().map(Polygon::quarters).collect();
    assert!(parts.iter().all(|parts| parts.len() == 4));
    let all = Visibility::new(parts.iter().flatten());
    for _ in 0..4000 {
        let mut from = || match (random.next() * 4.0) as usize {
            0 | 1 => (random.next() * 13.0).floor() - 1.0, // on planes
            2 => (random.next() * 26.0).floor() / 2.0,
            _ => random.next() * 12.0,
        };
        let origin = dvec3(from(), from(), from());
        let mut component = || match (random.next() * 5.0) as usize {
            0 | 1 => NEARLY_ZERO[(random.next() * NEARLY_ZERO.len() as f64) as usize],
            2 => 1.0,
            3 => -1.0,
            _ => 2.0 * random.next() - 1.0,
        };
        let towards = dvec3(component(), component(), component());
        if towards.length() > 1e-3 {
            let ray = Ray { origin, direction: towards.normalize() };
            let whole = |hit: Hit| Hit { item: hit.item / 4, ..hit };
            check(&soup, &ray, all.closest(&ray, None).map(whole));
        }
    }
}

#[test]
fn the_nearest_of_many_is_found() {
    let mut random = Stream::named(2, &[]);
    let mut triangle = |_| loop {
        let mut point = || dvec3(random.next(), random.next(), random.next());
        let (c, a, b) = (point(), 0.2 * point(), 0.2 * point());
        if let Ok(t) = Polygon::new(vec![c, c + a, c + b]) {
            return t;
        }
    };
    let soup: Vec<Polygon> = (0..500).map(&mut triangle).collect();
    let all = Visibility::new(&soup);
    let mut random = Stream::named(3, &[]);
    let mut met = 0;
    for _ in 0..2000 {
        let mut point = || dvec3(random.next(), random.next(), random.next());
        let (origin, towards) = (point(), point());
        let ray = Ray { origin, direction: (towards - origin).normalize() };
        let found = all.closest(&ray, None);
        met += usize::from(found.is_some());
        check(&soup, &ray, found);
    }
    assert!((500..2000).contains(&met), "{met} of 2000: the soup tells nothing");
}

/// A mirror that faces a wall of luminous tiles, seen by rays through its very middle.
#[test]
fn a_mirrored_wall_has_no_black_pixel() {
    let (scene, _) = obj::load("tests/data/house/bvh.obj").expect("a scene");
    let camera = Camera { eye: dvec3(0.0, 1.0, 3.0), target: DVec3::Y, ..scene.camera };
    let shot = Shot { camera, width: 33, height: 33, samples: 1 };
    let view = shot.view();
    let shown =
        Whitted::of(&Room::of(&scene), Look::default()).picture(&shot, &|_, _, _| ());
    let mirror = Visibility::new(scene.surfaces[..1].iter().map(|s| &s.polygon));
    let mut seen = 0;
    for (pixel, light) in shown.picture.pixels.iter().enumerate() {
        let (x, y) = (pixel as u32 % 33, pixel as u32 / 33);
        let direction = view.direction(View::pixel_centre(x, y, 33, 33));
        let ray = Ray { origin: view.eye(), direction };
        if mirror.closest(&ray, None).is_some() {
            seen += 1;
            assert!(light.min_element() > 0.0, "pixel {x}, {y} is black");
        }
    }
    assert!(seen > 400, "the mirror fills the middle: {seen} pixels");
}
