//! The item buffer: exact cover, agreement with rays, order and sides.

use glam::{DVec2, DVec3, dvec2, dvec3};
use proptest::prelude::*;
use radiosity::geometry::Polygon;
use radiosity::random::Stream;
use radiosity::raster::{ItemBuffer, Seen, View};

const SIZE: u32 = 61;

fn polygon(vertices: &[DVec3]) -> Polygon {
    Polygon::new(vertices.to_vec()).unwrap()
}

/// Looks along −Z from `(0, 0, 1)`: the square of side 2 in `z = 0` fills the picture.
fn straight() -> View {
    View::new(DVec3::Z, DVec3::X, DVec3::Y, DVec3::NEG_Z)
}

/// Each pixel counts how many of `polygons`, drawn alone, cover it.
fn cover(view: &View, polygons: &[Polygon]) -> Vec<u32> {
    let mut count = vec![0; (SIZE * SIZE) as usize];
    for polygon in polygons {
        let mut buffer = ItemBuffer::new(SIZE, SIZE);
        buffer.draw(view, polygon, 0);
        for (pixel, seen) in count.iter_mut().zip(buffer.pixels()) {
            *pixel += u32::from(seen != Seen::Nothing);
        }
    }
    count
}

/// The square `[-side, side]²` cut `cuts` times by lines through random places, each
/// cut piece by piece: convex polygons that share edges, with corners in the middle of
/// edges.
fn cut_square(side: f64, cuts: usize, seed: u64) -> Vec<Polygon> {
    let mut random = Stream::named(seed, &[]);
    let s = side;
    let square = [dvec2(-s, -s), dvec2(s, -s), dvec2(s, s), dvec2(-s, s)];
    let mut pieces = vec![polygon(&square.map(|v| v.extend(0.0)))];
    for _ in 0..cuts {
        let angle = std::f64::consts::TAU * random.next();
        let normal = dvec3(angle.cos(), angle.sin(), 0.0);
        let through = dvec3(random.next() - 0.5, random.next() - 0.5, 0.0) * side;
        let plane = radiosity::geometry::Plane::through(through, normal);
        pieces = pieces
            .iter()
            .flat_map(|p| [p.clipped(plane), p.clipped(plane.flipped())])
            .flatten()
            .collect();
    }
    pieces
}

/// A fan of triangles about a random point: all meet in one corner, all share edges.
fn fan(side: f64, corners: usize, seed: u64) -> Vec<Polygon> {
    let mut random = Stream::named(seed, &[]);
    let middle = dvec3(random.next() - 0.5, random.next() - 0.5, 0.0) * side;
    let rim = |k: usize| {
        // a point on the outline of the square, by its perimeter
        let t = 4.0 * (k % corners) as f64 / corners as f64;
        let along = 2.0 * t.fract() - 1.0;
        let (x, y) = match t as usize {
            0 => (along, -1.0),
            1 => (1.0, along),
            2 => (-along, 1.0),
            _ => (-1.0, -along),
        };
        side * dvec3(x, y, 0.0)
    };
    (0..corners).map(|k| polygon(&[middle, rim(k), rim(k + 1)])).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Pieces of a square that overfills the picture cover every pixel, and once.
    #[test]
    fn a_fan_covers_every_pixel_once(seed: u64, n in 1..9_usize, over in 1.0..3.0) {
        let pieces = fan(over, 4 * n, seed);
        prop_assert!(cover(&straight(), &pieces).iter().all(|&n| n == 1));
    }

    /// The same in perspective, from a slanted view: whatever the fan covers as a whole
    /// is covered once.
    #[test]
    fn a_slanted_fan_is_covered_once(seed: u64, x in -2.0..2.0, y in -2.0..2.0) {
        let eye = dvec3(x, y, 0.7);
        let forward = -eye.normalize();
        let (right, up) = forward.any_orthonormal_pair();
        let view = View::new(eye, right, up, forward);
        let count = cover(&view, &fan(1.3, 20, seed));
        let whole = cover(&view, &cut_square(1.3, 0, seed));
        // The fan's rim has corners that the square's edges lack; snapped, they bend it
        // by 1e-7 pixel. No pixel centre of these cases lies so near.
        prop_assert_eq!(count, whole);
    }

    /// Cuts leave corners in the middle of a neighbour's edge. Snapping moves them by
    /// up to 1e-7 pixel, so a pixel centre is hit with a probability of about 1e-6 a
    /// pixel.
    #[test]
    fn cut_pieces_cover_nearly_every_pixel_once(seed: u64, cuts in 1..8_usize) {
        let count = cover(&straight(), &cut_square(1.5, cuts, seed));
        prop_assert!(count.iter().filter(|&&n| n != 1).count() <= 1);
    }

    /// A pixel shows a polygon exactly when the ray through its centre hits it, except
    /// within a hair of the outline; and it shows the nearest.
    #[test]
    fn pixels_agree_with_rays(seed: u64) {
        let mut random = Stream::named(seed, &[]);
        let mut point =
            || 4.0 * dvec3(random.next(), random.next(), random.next()) - 2.0;
        let soup: Vec<Polygon> = (0..12)
            .filter_map(|_| Polygon::new(vec![point(), point(), point()]).ok())
            .collect();
        let view = View::new(point(), DVec3::X, DVec3::Y, DVec3::Z);
        let mut buffer = ItemBuffer::new(SIZE, SIZE);
        for (id, polygon) in soup.iter().enumerate() {
            buffer.draw(&view, polygon, id as u32);
        }
        for (k, seen) in buffer.pixels().enumerate() {
            let at = View::pixel_centre(k as u32 % SIZE, k as u32 / SIZE, SIZE, SIZE);
            if let Some(expected) = cast(&view, at, &soup) {
                prop_assert_eq!(seen, expected, "pixel {}", k);
            }
        }
    }

    /// No polygon, however large, small, near or far, writes beside the picture.
    #[test]
    fn extreme_polygons_do_no_harm(seed: u64, width in 1..40_u32, height in 1..40_u32) {
        let mut random = Stream::named(seed, &[]);
        let mut number =
            || (random.next() - 0.5) * 10_f64.powf(24.0 * random.next() - 12.0);
        let mut buffer = ItemBuffer::new(width, height);
        for id in 0..20 {
            let mut point = || dvec3(number(), number(), number());
            let view = View::new(point() * 1e-6, DVec3::X, DVec3::Y, DVec3::Z);
            if let Ok(polygon) = Polygon::new(vec![point(), point(), point()]) {
                buffer.draw(&view, &polygon, id);
            }
        }
        prop_assert_eq!(buffer.pixels().count() as u32, width * height);
    }

    /// The order of drawing does not matter, and ids survive.
    #[test]
    fn order_does_not_matter(seed: u64) {
        let mut random = Stream::named(seed, &[]);
        let mut point = || 2.0 * dvec3(random.next(), random.next(), random.next());
        let soup: Vec<_> = (0..20)
            .map(|k| (Polygon::new(vec![point(), point(), point()]), k))
            .filter_map(|(polygon, k)| Some((polygon.ok()?, k)))
            .collect();
        let draw = |items: &mut dyn Iterator<Item = &(Polygon, u32)>| {
            let mut buffer = ItemBuffer::new(SIZE, SIZE);
            let view = View::new(dvec3(1.0, 1.0, -1.0), DVec3::X, DVec3::Y, DVec3::Z);
            items.for_each(|(polygon, id)| buffer.draw(&view, polygon, *id));
            buffer.pixels().collect::<Vec<_>>()
        };
        prop_assert_eq!(draw(&mut soup.iter()), draw(&mut soup.iter().rev()));
    }
}

/// What the ray through `at` sees; `None` where it passes within 1e-4 of an outline, or
/// two hits are equally far to 1e-9.
fn cast(view: &View, at: DVec2, soup: &[Polygon]) -> Option<Seen> {
    let direction = view.direction(at);
    let mut nearest = (f64::INFINITY, Seen::Nothing);
    for (id, polygon) in soup.iter().enumerate() {
        let facing = polygon.normal().dot(direction);
        let t = -polygon.plane().height(view.eye()) / facing;
        let hit = view.eye() + direction * t;
        if facing.abs() < 1e-6 || (t > 0.0 && polygon.contains(hit, 1e-4 * (1.0 + t))) {
            let inner = -1e-4 * (1.0 + t);
            if facing.abs() < 1e-6 || !polygon.contains(hit, inner) {
                return None;
            }
            if (t - nearest.0).abs() < 1e-9 * t {
                return None;
            }
            if t < nearest.0 {
                let side = if facing < 0.0 { Seen::Front } else { Seen::Back };
                nearest = (t, side(id as u32));
            }
        }
    }
    Some(nearest.1)
}

/// A pixel centre that lies on a shared edge belongs to the polygon on its right, or
/// below.
#[test]
fn left_and_top_edges_own_their_pixels() {
    let mut buffer = ItemBuffer::new(3, 3); // the centre of pixel (1, 1) is at (0, 0)
    let left = polygon(&[-DVec3::X, DVec3::ZERO, DVec3::Y, dvec3(-1.0, 1.0, 0.0)]);
    let right = polygon(&[DVec3::ZERO, DVec3::X, dvec3(1.0, 1.0, 0.0), DVec3::Y]);
    let below =
        polygon(&[dvec3(-1.0, -1.0, 0.0), dvec3(1.0, -1.0, 0.0), DVec3::X, -DVec3::X]);
    for (id, polygon) in [&left, &right, &below].into_iter().enumerate() {
        buffer.draw(&straight(), polygon, id as u32);
    }
    let ids: Vec<u32> = buffer
        .pixels()
        .map(|seen| if let Seen::Front(id) = seen { id } else { u32::MAX })
        .collect();
    assert_eq!(ids, [0, 1, 1, 2, 2, 2, 2, 2, 2]);
}

/// A wall that touches the floor a billionth of a metre beside the eye is not cut by a
/// near plane, for there is none (`1/W` is as exact there as anywhere).
#[test]
fn what_touches_the_eye_is_not_cut() {
    for gap in [1e-3, 1e-6, 1e-9, 1e-12] {
        let view = View::new(DVec3::ZERO, DVec3::Y, DVec3::Z, DVec3::X);
        let wall = polygon(&[
            dvec3(gap, -gap, -gap),
            dvec3(gap, -gap, gap),
            dvec3(gap, gap, gap),
            dvec3(gap, gap, -gap),
        ]);
        let mut buffer = ItemBuffer::new(8, 8);
        buffer.draw(&view, &wall, 5);
        assert!(buffer.pixels().all(|seen| seen == Seen::Front(5)), "gap {gap}");
    }
}

/// Polygons through the eye are seen edge-on: they cover nothing.
#[test]
fn what_passes_through_the_eye_covers_nothing() {
    let floor = polygon(&[
        dvec3(-1.0, -1.0, 0.0),
        dvec3(1.0, -1.0, 0.0),
        dvec3(1.0, 1.0, 0.0),
        dvec3(-1.0, 1.0, 0.0),
    ]);
    for eye in [DVec3::ZERO, dvec3(0.1, 0.2, 0.3e-16), dvec3(5.0, 0.0, 0.0)] {
        for forward in [DVec3::Z, DVec3::X, DVec3::NEG_X] {
            let (right, up) = forward.any_orthonormal_pair();
            let mut buffer = ItemBuffer::new(16, 16);
            buffer.draw(&View::new(eye, right, up, forward), &floor, 0);
            assert!(buffer.pixels().all(|seen| seen == Seen::Nothing), "eye {eye}");
        }
    }
}

/// Two faces back to back in one place, as exporters write a sheet: the front is seen
/// from either side, whichever is drawn first.
#[test]
fn of_a_sheet_the_front_is_seen() {
    let sheet = fan(1.5, 7, 3);
    let turn = glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.3, 0.4, 0.5);
    for (first, second) in [(0, 1), (1, 0)] {
        for eye in [dvec3(0.3, 0.2, 1.0), dvec3(-0.2, 0.4, -1.0)] {
            let forward = turn * -eye.normalize();
            let (right, up) = forward.any_orthonormal_pair();
            let view = View::new(turn * eye, right, up, forward);
            let mut buffer = ItemBuffer::new(SIZE, SIZE);
            for side in [first, second] {
                for piece in &sheet {
                    let turned: Vec<_> =
                        piece.vertices().iter().map(|&v| turn * v).collect();
                    let piece = polygon(&turned);
                    let piece = if side == 0 { piece } else { piece.flipped() };
                    buffer.draw(&view, &piece, side);
                }
            }
            let expected = Seen::Front(if eye.z > 0.0 { 0 } else { 1 });
            let wrong = buffer
                .pixels()
                .filter(|&seen| seen != expected && seen != Seen::Nothing)
                .count();
            assert_eq!(wrong, 0, "eye {eye}, {first} drawn first");
        }
    }
}

/// Failure 25: a poster in the plane of its wall flickers; 1e-6 before it, it does not.
#[test]
fn a_poster_in_its_wall_fights_with_it() {
    let turn = glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.3, 0.4, 0.5);
    let square = |side: f64, z: f64| {
        polygon(
            &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
                .map(|(x, y)| turn * dvec3(side * x, side * y, z)),
        )
    };
    let poster_pixels = |gap: f64| {
        let mut buffer = ItemBuffer::new(100, 100);
        let view = View::new(
            turn * dvec3(0.1, 0.2, 1.0),
            turn * DVec3::X,
            turn * DVec3::Y,
            turn * DVec3::NEG_Z,
        );
        buffer.draw(&view, &square(3.0, 0.0), 0);
        buffer.draw(&view, &square(0.5, gap), 1);
        buffer.pixels().filter(|&seen| seen == Seen::Front(1)).count()
    };
    assert_eq!(poster_pixels(1e-6), 50 * 50);
    assert_eq!(poster_pixels(1e-13), 50 * 50);
    assert!(poster_pixels(0.0) < 50 * 50, "no longer lost? then say so in the book");
}

#[test]
fn a_picture_without_pixels_is_refused() {
    for size in [0, radiosity::raster::MAX_SIZE + 1] {
        assert!(std::panic::catch_unwind(|| ItemBuffer::new(size, 1)).is_err());
    }
}
