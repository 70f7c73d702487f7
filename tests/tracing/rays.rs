//! The second pass and classical ray tracing: mirrors, panes, glass and gloss one by one.

use crate::common::cases;
use crate::common::paths::{dull, glass, glow, mirror, pane, shine, shiny};
use crate::common::rooms::{box_walls, moved, rectangle};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::optics::{fresnel, pane as pane_shares};
use radiosity::material::{Coefficients, Shine};
use radiosity::mesh::{Element, Mesh};
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::Scene;
use radiosity::sky::Sky;
use radiosity::solve::Enclosure;
use radiosity::trace::{Along, Look, TwoPass, Whitted};
use std::f64::consts::PI;

/// Nothing is cut but what is far beyond rounding.
const FAR: Look = Look::following(60, 1e-14);

/// `B` of every corner of what is diffuse, from where it is.
fn field(scene: &Scene, mesh: &Mesh, of: impl Fn(DVec3) -> Rgb) -> Vec<Rgb> {
    let mut values = vec![Rgb::ZERO; mesh.vertices.len()];
    let diffuse = |e: &&Element| {
        let surface = &scene.surfaces[mesh.surface_of(e) as usize];
        scene.material(surface).diffuse() != Rgb::ZERO
    };
    for element in mesh.elements.iter().filter(diffuse) {
        for (&v, corner) in element.polygon.vertices().iter().zip(&element.corners) {
            values[corner.0 as usize] = of(v);
        }
    }
    values
}

/// The second pass along a ray, of a scene that emits and reflects no diffuse light.
fn along(scene: &Scene, look: Look, ray: &Ray) -> Along {
    let mesh = Mesh::whole(scene);
    let b = mesh.vertex_values(&Enclosure::of(scene, &mesh).emission);
    TwoPass::showing(&Room::of(scene), &mesh, &b, look).along(ray)
}

fn towards(origin: DVec3, target: DVec3) -> Ray {
    Ray { origin, direction: (target - origin).normalize() }
}

/// Directions all around.
fn directions(count: usize) -> Vec<DVec3> {
    let mut random = Stream::named(19, &[]);
    let mut point =
        || 2.0 * dvec3(random.next(), random.next(), random.next()) - DVec3::ONE;
    (0..count).map(|_| point().normalize()).collect()
}

/// A room with one wall a perfect mirror shows what the doubled room shows.
#[test]
fn a_mirror_doubles_the_room() {
    let light = |p: DVec3| {
        let x = p.x.abs();
        Rgb::new(1.0 + x, (3.0 * x).sin() + 2.0 + p.y, 0.5 + p.z * x)
    };
    let walls = box_walls([1.0; 3]);
    let with_mirror =
        shiny(walls.iter().enumerate().map(|(k, p)| {
            (p.clone(), if k == 0 { mirror(1.0) } else { dull(0.0, 0.5) })
        }));
    // The same walls, and those behind the mirror.
    let flip = |p: &Polygon| moved(&p.flipped(), |v| dvec3(-v.x, v.y, v.z));
    let both = walls[1..].iter().cloned().chain(walls[1..].iter().map(flip));
    let doubled = shiny(both.map(|p| (p, dull(0.0, 0.5))));
    let meshes = [&with_mirror, &doubled].map(|scene| Mesh::uniform(scene, 0.2));
    let fields =
        [field(&with_mirror, &meshes[0], light), field(&doubled, &meshes[1], light)];
    let one = TwoPass::showing(&Room::of(&with_mirror), &meshes[0], &fields[0], FAR);
    let two = TwoPass::showing(&Room::of(&doubled), &meshes[1], &fields[1], FAR);
    let eye = dvec3(0.6, 0.35, 0.45);
    let mut through = 0;
    for direction in directions(2000) {
        let ray = Ray { origin: eye, direction };
        let (a, b) = (one.along(&ray), two.along(&ray));
        let off = (a.radiance - b.radiance).abs().max_element();
        assert!(off < 1e-12, "{direction}: {off:e}");
        assert_eq!((b.rays, a.cut), (1, Rgb::ZERO));
        through += usize::from(a.rays > 1);
    }
    assert!(through > 150, "{through}");
}

#[test]
fn a_mirror_is_black_from_behind() {
    let lamp = rectangle(dvec3(-1.0, -1.0, 2.0), 2.0 * DVec3::Y, 2.0 * DVec3::X);
    let plate = rectangle(dvec3(-1.0, -1.0, 0.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let floor = rectangle(dvec3(-1.0, -1.0, -1.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let scene =
        shiny([(lamp, dull(PI, 0.0)), (plate, mirror(1.0)), (floor, dull(0.0, 0.5))]);
    let whitted = Whitted::of(&Room::of(&scene), FAR);
    let from = |z: f64, to: f64| towards(dvec3(0.1, 0.2, z), dvec3(0.3, 0.1, to));
    for (ray, right) in [(from(1.0, 0.0), 1.0), (from(-0.5, 0.0), 0.0)] {
        assert_eq!(whitted.along(&ray).radiance.x, right);
        assert_eq!(along(&scene, FAR, &ray).radiance.x, right);
    }
    // Nor does light of the lamp pass: the floor under the plate is in its shadow.
    let floor = from(-0.5, -1.0);
    assert_eq!(whitted.along(&floor).radiance.x, 0.0);
}

/// Classical ray tracing knows lamps and no other light: what a mirror throws on a floor
/// is missing (failure 65), by just that factor.
#[test]
fn light_by_way_of_mirrors_is_missing_from_classical_ray_tracing() {
    let case =
        cases("G_mirror_glass").into_iter().find(|c| c["id"] == "G8-doubling-h2-a1-b1");
    let case = case.unwrap();
    let lamp = rectangle(dvec3(0.0, -0.5, 2.0), DVec3::Y, DVec3::X);
    let wall = rectangle(dvec3(0.0, -9.0, -9.0), 18.0 * DVec3::Y, 18.0 * DVec3::Z);
    let floor = rectangle(dvec3(0.0, -1.0, 0.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let (e, rho) = (7.0, 0.4);
    let scene =
        shiny([(lamp, dull(e, 0.0)), (wall, mirror(1.0)), (floor, dull(0.0, rho))]);
    let ray = towards(dvec3(0.5, 0.1, 1.0), dvec3(1e-9, 0.0, 0.0));
    let got = Whitted::of(&Room::of(&scene), FAR).along(&ray).radiance.x;
    let factor = |key: &str| case["expected"][key].as_f64().unwrap();
    let direct = rho * e * factor("F_direct") / PI;
    assert!((got / direct - 1.0).abs() < 1e-8, "{got} {direct}");
    let right = rho * e * factor("F_with_perfect_mirror") / PI;
    assert!((got / right - 0.5).abs() < 1e-8, "half the light is lost");
}

/// Failure 73: what a cut at depth `d` leaves out of a hall of mirrors is `r^(d+1)/(1−r)`.
#[test]
fn a_hall_of_mirrors_is_a_geometric_series() {
    let halls = cases("G_mirror_glass").into_iter();
    let halls = halls.filter(|c| c["kind"] == "mirror_recursion");
    let mut count = 0;
    for case in halls {
        let r = case["params"]["r"].as_f64().unwrap();
        let depth = case["params"]["depth"].as_u64().unwrap() as u32;
        let shining = Coefficients { emission: Rgb::splat(PI), ..mirror(r) };
        let low = rectangle(dvec3(-9.0, -9.0, 0.0), 18.0 * DVec3::X, 18.0 * DVec3::Y);
        let high = moved(&low.flipped(), |v| v + DVec3::Z);
        let scene = shiny([(low, shining), (high, shining)]);
        let ray = towards(dvec3(0.0, 0.0, 0.5), dvec3(0.2, 0.1, 1.0));
        let look = Look::following(depth, 0.0);
        let found = [
            along(&scene, look, &ray),
            Whitted::of(&Room::of(&scene), look).along(&ray),
        ];
        for Along { radiance, rays, cut } in found {
            let right = case["expected"]["radiance_truncated"].as_f64().unwrap();
            assert!((radiance.x - right).abs() < 1e-12, "{radiance} {right}");
            assert_eq!(rays, u64::from(depth) + 1);
            // What was cut, times the radiance that it would have found, is what lacks.
            let full = case["expected"]["radiance_full"].as_f64().unwrap();
            assert!((radiance.x + cut.x * full - full).abs() < 1e-11, "{cut}");
        }
        count += 1;
    }
    assert_eq!(count, 2);
}

/// Failure 71: in a room that glows evenly, glass shows the same glow: `R + T = 1` at
/// every face, also where all is reflected inside; what is cut is accounted for.
#[test]
fn glass_neither_makes_light_nor_loses_it() {
    let block = |at: DVec3, size: f64, index: f64| {
        box_walls([size; 3]).into_iter().map(move |p| {
            (moved(&p.flipped(), |v| v + at - 0.5 * DVec3::splat(size)), glass(index))
        })
    };
    // A denser block inside of another, and a bubble: an index below that around it.
    let nested = block(DVec3::ZERO, 2.0, 1.5)
        .chain(block(dvec3(0.4, 0.1, 0.2), 0.8, 2.4))
        .chain(block(dvec3(-0.6, -0.5, 0.1), 0.3, 1.0 / 1.5));
    let scene = shiny(glow().chain(nested));
    let mut worst: f64 = 0.0;
    for direction in directions(300) {
        let ray = Ray {
            origin: -2.5 * DVec3::new(direction.z, direction.x, direction.y),
            direction,
        };
        let look = Look::following(30, 1e-4);
        let Along { radiance, cut, .. } = along(&scene, look, &ray);
        let sum = radiance.x + cut.x;
        assert!((sum - 1.0).abs() < 1e-9, "{direction}: {radiance} + {cut}");
        worst = worst.max(cut.x);
    }
    assert!((1e-3..1.0).contains(&worst), "some light goes round for long: {worst}");
}

/// Under total internal reflection no light is lost: a prism turns a ray by a right angle.
#[test]
fn a_prism_turns_all_light() {
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| dvec3(x, y, -1.0));
    let top = corners.map(|v| v + 2.0 * DVec3::Z);
    let side = |i: usize, j: usize| {
        Polygon::new(vec![corners[i], corners[j], top[j], top[i]]).unwrap()
    };
    let mut bottom = corners.to_vec();
    bottom.reverse();
    let faces = [
        Polygon::new(top.to_vec()).unwrap(),
        Polygon::new(bottom).unwrap(),
        side(0, 1),
        side(1, 2),
        side(2, 0),
    ];
    let lamp = rectangle(dvec3(0.05, -3.0, -1.0), 2.0 * DVec3::Z, 0.9 * DVec3::X);
    let lamp = if lamp.normal().y > 0.0 { lamp } else { lamp.flipped() };
    let prism = faces.into_iter().map(|p| (p, glass(1.5)));
    let scene = shiny(prism.chain([(lamp, dull(PI, 0.0))]));
    // In through one short side, off the long one at 45°, out through the other.
    let ray = towards(dvec3(-1.0, 0.4, 0.0), dvec3(0.0, 0.4, 0.0));
    let look = Look::following(3, 0.0);
    let pass = 1.0 - fresnel(1.0, 1.0 / 1.5).mean();
    let got = along(&scene, look, &ray).radiance.x;
    assert!((got - pass * pass).abs() < 1e-12, "{got} {}", pass * pass);
}

/// A slab shifts what is seen through it (table G6), and takes what its faces reflect.
#[test]
fn a_slab_shifts_a_ray() {
    let slabs = cases("G_mirror_glass").into_iter();
    let slabs = slabs.filter(|c| c["kind"] == "slab_lateral_shift");
    let mut count = 0;
    for case in slabs {
        let number = |key: &str| case["params"][key].as_f64().unwrap();
        let (d, n) = (number("thickness"), number("n"));
        let angle = number("angle_deg").to_radians();
        let front = rectangle(dvec3(-9.0, -9.0, 0.0), 18.0 * DVec3::X, 18.0 * DVec3::Y);
        let behind = moved(&front.flipped(), |v| v - d * DVec3::Z);
        let wall = moved(&front, |v| v - 2.0 * DVec3::Z);
        let with_slab = shiny([
            (front, glass(n)),
            (behind, glass(n)),
            (wall.clone(), dull(0.0, 0.5)),
        ]);
        let ramp = |p: DVec3| Rgb::splat(20.0 + p.x);
        let mesh = Mesh::whole(&with_slab);
        let b = field(&with_slab, &mesh, ramp);
        let look = Look::following(2, 0.0); // in and out, no more
        let two = TwoPass::showing(&Room::of(&with_slab), &mesh, &b, look);
        let direction = dvec3(angle.sin(), 0.0, -angle.cos());
        let ray = Ray { origin: dvec3(-1.0, 0.0, 1.0), direction };
        let passed = (1.0 - fresnel(angle.cos(), 1.0 / n).mean()).powi(2);
        let seen_at = two.along(&ray).radiance.x * PI / passed - 20.0;
        let straight = -1.0 + 3.0 * angle.tan();
        // Across the ray, from where it would have met the wall.
        let shift = (straight - seen_at) * angle.cos();
        let right = case["expected"]["lateral_shift"].as_f64().unwrap();
        assert!((shift - right).abs() < 1e-12, "{shift} {right}");
        count += 1;
    }
    assert_eq!(count, 2);
}

/// Panes behind each other: all that goes to and fro between them is summed.
#[test]
fn panes_add_up() {
    let sheet =
        |z: f64| rectangle(dvec3(-90.0, -90.0, z), 180.0 * DVec3::X, 180.0 * DVec3::Y);
    let lamp = moved(&sheet(9.0).flipped(), |v| v);
    let eye = dvec3(0.0, 0.0, -1.0);
    let mut stack = vec![(lamp, dull(PI, 0.0))];
    let cosine: f64 = 0.6;
    let (r1, t1) = pane_shares(cosine, 1.5);
    let (mut r, mut t) = (r1, t1);
    for k in 0..3 {
        // Fronts this way and that: a pane is the same from both sides.
        let p = sheet(f64::from(k));
        stack.push((if k == 1 { p.flipped() } else { p }, pane()));
        if k > 0 {
            let between = 1.0 - r * r1;
            (r, t) = (r + t * t * r1 / between, t * t1 / between);
        }
        let direction = dvec3((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
        let ray = Ray { origin: eye, direction };
        let got = along(&shiny(stack.clone()), FAR, &ray);
        assert!((got.radiance.x - t).abs() < 1e-9, "{k}: {} {t}", got.radiance.x);
        assert!((r + t - 1.0).abs() < 1e-12);
    }
    // In a room that glows, a stack of panes is not to be seen.
    let scene = shiny(glow().chain([0.0, 0.5, 1.0].map(|z| (sheet(z), pane()))));
    for direction in directions(50) {
        let found = along(&scene, Look::default(), &Ray { origin: eye, direction });
        assert!((found.radiance.x + found.cut.x - 1.0).abs() < 1e-12);
    }
}

#[test]
fn the_sky_is_seen_through_a_pane() {
    let sheet = rectangle(dvec3(-1.0, -1.0, 0.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let mut scene = shiny([(sheet, pane())]);
    let light = Rgb::new(1.0, 2.0, 3.0);
    scene.sky = Some(Sky::uniform(light, DVec3::Z));
    let ray = towards(dvec3(0.0, 0.0, -1.0), dvec3(0.3, 0.2, 0.0));
    let t = pane_shares(ray.direction.z, 1.5).1;
    for found in
        [along(&scene, FAR, &ray), Whitted::of(&Room::of(&scene), FAR).along(&ray)]
    {
        assert!((found.radiance - t * light).abs().max_element() < 1e-14);
    }
    let past = towards(dvec3(0.0, 0.0, -1.0), dvec3(5.0, 0.0, 0.0));
    assert_eq!(along(&scene, FAR, &past).radiance, light);
}

/// A lamp shines through a pane on a floor, also in classical ray tracing.
#[test]
fn panes_dim_lamps() {
    let floor = rectangle(dvec3(-1.0, -1.0, 0.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let lamp = rectangle(dvec3(-0.01, -0.01, 2.0), 0.02 * DVec3::Y, 0.02 * DVec3::X);
    let between = moved(&floor, |v| v + DVec3::Z);
    let ray = towards(dvec3(0.5, 0.0, 0.5), dvec3(0.01, 0.02, 0.0));
    let see = |faces: Vec<(Polygon, Coefficients)>| {
        Whitted::of(&Room::of(&shiny(faces)), FAR).along(&ray).radiance.x
    };
    let bare = vec![(floor, dull(0.0, 0.5)), (lamp, dull(PI, 0.0))];
    let mut paned = bare.clone();
    paned.push((between, pane()));
    let ratio = see(paned) / see(bare);
    assert!((ratio - pane_shares(1.0, 1.5).1).abs() < 1e-6, "{ratio}");
}

/// Gloss in a room that glows evenly shows its albedo.
#[test]
fn gloss_in_a_glow_shows_its_albedo() {
    for exponent in [2.0, 30.0, 900.0] {
        let gloss = Shine::Gloss { reflectance: Rgb::splat(0.7), exponent };
        let plate = rectangle(dvec3(-2.0, -2.0, 0.0), 4.0 * DVec3::X, 4.0 * DVec3::Y);
        let scene = shiny(glow().chain([(plate, shine(gloss))]));
        let mesh = Mesh::whole(&scene);
        let b = mesh.vertex_values(&Enclosure::of(&scene, &mesh).emission);
        let ray = towards(dvec3(1.0, 0.0, 1.0), DVec3::ZERO);
        let lobe = radiosity::material::Lobe::Phong { exponent };
        let right = 0.7 * lobe.albedo(0.5_f64.sqrt());
        let mean = (0..400).map(|seed| {
            let options = Look { seed, ..FAR };
            TwoPass::showing(&Room::of(&scene), &mesh, &b, options)
                .along(&ray)
                .radiance
                .x
        });
        // The walls are lamps here, and summed exactly: only the stack's levels vary.
        let got = mean.sum::<f64>() / 400.0;
        assert!((got / right - 1.0).abs() < 0.02, "{exponent}: {got} {right}");
    }
}
