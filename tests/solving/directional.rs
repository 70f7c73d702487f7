//! Specular radiosity: laws that hold to rounding, and the light of a glossy room.

use crate::common::rooms::{box_walls, rectangle};
use glam::{DVec3, dvec2, dvec3};
use radiosity::directional::{Bins, Directional, Scatter, Transport};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::{Brdf, Coefficients, Lobe, Material, Shine};
use radiosity::mesh::{Element, ElementId, Mesh};
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solve::{Enclosure, GaussSeidel, Solver};
use radiosity::trace::PathTracer;
use std::f64::consts::PI;

/// Emission, W/m², diffuse and specular reflectance.
type Paint = (Rgb, Rgb, Rgb);

/// Which surface of [`room`] is the floor.
const FLOOR: u32 = 4;

/// The exponent of all gloss.
const EXPONENT: f64 = 20.0;

fn scene(faces: impl IntoIterator<Item = (Polygon, Paint)>) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, (emission, diffuse, reflectance))) in
        faces.into_iter().enumerate()
    {
        let shine = Shine::Gloss { reflectance, exponent: EXPONENT };
        let coefficients =
            Coefficients { emission, diffuse, shine, ..Coefficients::default() };
        materials.push(Material::new(format!("m{k}"), coefficients).unwrap());
        let material = MaterialId(k as u32);
        outlines.push(Face { outline: polygon.vertices().to_vec(), material });
    }
    Scene::assemble("test", materials, outlines, None).unwrap().0
}

/// The unit cube: coloured walls, a floor with this gloss, a lamp in the ceiling.
fn room(gloss: f64) -> Scene {
    let grey = (Rgb::ZERO, Rgb::splat(0.5), Rgb::ZERO);
    let red = (Rgb::ZERO, dvec3(0.6, 0.2, 0.1), Rgb::ZERO);
    let floor = (Rgb::ZERO, Rgb::splat(0.2), Rgb::splat(gloss));
    let paints = [red, grey, grey, grey, floor, grey];
    let lamp = rectangle(dvec3(0.25, 0.25, 1.0), 0.5 * DVec3::Y, 0.5 * DVec3::X);
    let lamp = (lamp, (dvec3(4.0, 4.0, 2.0), Rgb::splat(0.3), Rgb::ZERO));
    scene(box_walls([1.0; 3]).into_iter().zip(paints).chain([lamp]))
}

fn glossy(exponent: f64) -> Brdf {
    let shine = Shine::Gloss { reflectance: dvec3(0.6, 0.3, 0.0), exponent };
    let diffuse = Rgb::splat(0.3);
    let c = Coefficients { diffuse, shine, ..Coefficients::default() };
    Material::new("paint", c).unwrap().brdf()
}

/// Every direction is in one bin, and even points of the square are even over the bins.
#[test]
fn bins_share_the_hemisphere_evenly() {
    for side in [1, 2, 3, 8, 13] {
        let bins = Bins::new(side);
        let mut cosines = 0.0;
        for bin in 0..bins.len() as u32 {
            for k in 0..64 {
                let u = dvec2(f64::from(k % 8) + 0.5, f64::from(k / 8) + 0.5) / 8.0;
                let w = bins.direction(bin, u);
                assert_eq!(bins.bin_of(w), Some(bin), "{side}: {w}");
                cosines += w.z / (64 * bins.len()) as f64;
            }
        }
        // ∫ cos² dω / π = 2/3, by the midpoint rule; cosθ falls off as a root at the rim
        let step = 1.0 / f64::from(8 * side);
        assert!(
            (cosines - 2.0 / 3.0).abs() < 0.6 * step.powf(1.5),
            "{side}: {cosines}"
        );
        assert_eq!(bins.bin_of(-DVec3::Z), None);
    }
}

/// What arrives in a bin leaves as the closed form of the albedo says, to rounding; the
/// matrix is the same both ways; and the mean over all bins is the hemispherical albedo.
#[test]
fn scattering_honours_the_albedo() {
    for (side, exponent) in [(1, 5.0), (3, 0.0), (6, 20.0), (8, 200.0), (4, 1e4)] {
        let (brdf, bins) = (glossy(exponent), Bins::new(side));
        let (scatter, m) = (Scatter::of(&brdf, bins), bins.len());
        let mut mean = Rgb::ZERO;
        for a in 0..m {
            let sum: Rgb = (0..m).map(|b| scatter.share(a, b)).sum();
            let wanted = scatter.albedo(a);
            assert!((sum - wanted).abs().max_element() < 1e-12, "{side} {exponent}");
            assert!(sum.max_element() <= 1.0);
            mean += sum / m as f64;
            let skew = |b| (scatter.share(a, b) - scatter.share(b, a)).abs();
            assert!((0..m).all(|b| skew(b).max_element() < 1e-15));
        }
        let lobe = Lobe::Phong { exponent }.hemispherical_albedo();
        let exact = Rgb::splat(0.3) + lobe * dvec3(0.6, 0.3, 0.0);
        // The mean is taken by a midpoint rule; cosθ falls off as a root at the rim.
        assert!((mean - exact).abs().max_element() < 2e-3, "{side} {exponent}: {mean}");
    }
}

/// Where all is Lambertian every beam of a patch has the same radiance, and that is `B/π`
/// of plain radiosity with the same factors.
#[test]
fn lambertian_rooms_are_plain_radiosity() {
    let scene = room(0.0);
    let mesh = Mesh::uniform(&scene, 0.5);
    for side in [1, 3] {
        let mut transport = Transport::sampled(&mesh, Bins::new(side), 300, 7);
        transport.close().unwrap();
        let mut light = Directional::new(&scene, &mesh, &transport);
        light.settle(1e-14);
        let (factors, enclosure) =
            (transport.form_factors(), Enclosure::of(&scene, &mesh));
        let mut plain = GaussSeidel::new(&enclosure, &factors);
        plain.run(0.6, 1e-14, 1000);
        let m = transport.bins().len();
        for (beams, &b) in light.radiance().chunks(m).zip(plain.radiosity()) {
            for &l in beams {
                assert!((PI * l - b).abs().max_element() < 1e-12, "{l} {b}");
            }
        }
    }
}

/// Transport with the full BRDF is linear: lamps apart and together.
#[test]
fn light_of_two_lamps_adds_up() {
    let with = |emission: [Rgb; 2]| {
        let mut faces: Vec<_> = box_walls([1.0, 2.0, 1.0])
            .map(|w| (w, (Rgb::ZERO, Rgb::splat(0.3), Rgb::splat(0.5))))
            .to_vec();
        faces[0].1.0 = emission[0];
        faces[5].1.0 = emission[1];
        let scene = scene(faces);
        let mesh = Mesh::uniform(&scene, 1.0);
        let transport = Transport::sampled(&mesh, Bins::new(4), 50, 0);
        let mut light = Directional::new(&scene, &mesh, &transport);
        light.nth(40);
        light.radiance().to_vec()
    };
    let (red, blue) = (dvec3(2.0, 0.5, 0.0), dvec3(0.0, 0.1, 3.0));
    let (one, other) = (with([red, Rgb::ZERO]), with([Rgb::ZERO, blue]));
    let both = with([red, blue]);
    for ((&a, &b), &sum) in one.iter().zip(&other).zip(&both) {
        assert!((a + b - sum).abs().max_element() < 1e-13, "{a} {b} {sum}");
    }
}

/// Every watt is accounted for, at each bounce, once the shares are closed; and before
/// that to their sampling error.
#[test]
fn the_ledger_closes() {
    let scene = room(0.6);
    let mesh = Mesh::uniform(&scene, 0.5);
    let mut transport = Transport::sampled(&mesh, Bins::new(4), 100, 1);
    let open = Directional::new(&scene, &mesh, &transport).settle(1e-10);
    let imbalance = open.worst_imbalance();
    assert!((1e-6..0.01).contains(&imbalance), "{imbalance}");
    assert!(transport.close().unwrap().after < 1e-12);
    let light = Directional::new(&scene, &mesh, &transport);
    for (bounce, ledger) in light.take(60).enumerate() {
        assert!(ledger.worst_imbalance() < 1e-12, "{bounce}: {ledger:?}");
        let left = (ledger.unshot / ledger.emitted).max_element();
        assert!(left <= 0.8_f64.powi(bounce as i32 + 2) + 1e-12, "{bounce}: {left}");
    }
}

/// Two squares in the open: what they do not send to each other escapes, and is counted.
#[test]
fn what_escapes_is_counted() {
    let lamp = (Rgb::ONE, Rgb::splat(0.2), Rgb::splat(0.5));
    let other = (Rgb::ZERO, Rgb::splat(0.2), Rgb::splat(0.5));
    let up = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let down = rectangle(DVec3::Z, DVec3::Y, DVec3::X);
    let scene = scene([(up, lamp), (down, other)]);
    let mesh = Mesh::whole(&scene);
    let mut transport = Transport::sampled(&mesh, Bins::new(4), 4000, 1);
    assert!(transport.close().is_none());
    let ledger = Directional::new(&scene, &mesh, &transport).settle(1e-12);
    // Opposed unit squares have F = 0.199825; little comes back and escapes later.
    let escaped = ledger.escaped.x / ledger.emitted.x;
    assert!((0.88..0.93).contains(&escaped), "{escaped}");
    assert!(ledger.worst_imbalance() < 2e-3, "{ledger:?}");
}

/// A place on the floor, a direction to an eye, and what is seen there.
type Look = (DVec3, DVec3, Rgb);

/// The ray of an eye that looks at the floor at `x`, from `wo`.
fn look_at(x: DVec3, wo: DVec3) -> Ray {
    Ray { origin: x + 1e-6 * wo, direction: -wo }
}

/// What eyes see of the floor by so many paths each; the root mean square of the radiance,
/// and that of its standard error.
fn looks(scene: &Scene, paths: usize) -> (Vec<Look>, f64, f64) {
    let tracer = PathTracer::of(&Room::of(scene));
    let places = Stream::named(5, &[]).points(60).collect::<Vec<[f64; 4]>>();
    let (mut norm, mut noise) = (0.0, 0.0);
    let look = |(k, &[a, b, c, d]): (usize, &[f64; 4])| {
        let (x, wo) = (dvec3(a, b, 0.0), cosine_direction(dvec2(c, d)));
        let mut random = Stream::named(6, &[k as u64]);
        let (mut sum, mut squares) = (Rgb::ZERO, 0.0);
        for _ in 0..paths {
            let l = tracer.radiance(look_at(x, wo), &mut random);
            sum += l;
            squares += l.length_squared();
        }
        let n = paths as f64;
        let mean = sum / n;
        norm += mean.length_squared();
        noise += (squares / n - mean.length_squared()) / n;
        (x, wo, mean)
    };
    (places.iter().enumerate().map(look).collect(), norm.sqrt(), noise.sqrt())
}

/// The power that the floor sends, by paths from everywhere to everywhere; to 0.5 %.
fn sent_by_the_floor(scene: &Scene) -> Rgb {
    let tracer = PathTracer::of(&Room::of(scene));
    let mut random = Stream::named(8, &[]);
    const PATHS: usize = 40_000;
    let places = Stream::named(7, &[]).points(PATHS);
    let one = |[a, b, c, d]: [f64; 4]| {
        let (x, wo) = (dvec3(a, b, 0.0), cosine_direction(dvec2(c, d)));
        tracer.radiance(look_at(x, wo), &mut random)
    };
    PI * places.map(one).sum::<Rgb>() / PATHS as f64
}

/// Patches and bins, ever finer: what an eye sees of the glossy floor comes nearer to what
/// unbiased paths find, slowly; what the floor sends in all comes near at once.
#[test]
fn it_converges_to_path_tracing() {
    let scene = room(0.6);
    let (looks, norm, noise) = looks(&scene, 1000);
    assert!(noise < 0.05 * norm, "{}", noise / norm);
    let sent = sent_by_the_floor(&scene);
    let cases = [
        (1.0, 1, 0.72, 0.2),
        (0.5, 4, 0.57, 0.05),
        (0.25, 6, 0.32, 0.03),
        (0.15, 8, 0.28, 0.02),
    ];
    for (edge, side, expected, power) in cases {
        let mesh = Mesh::uniform(&scene, edge);
        let mut transport = Transport::sampled(&mesh, Bins::new(side), 200, 3);
        transport.close();
        let mut light = Directional::new(&scene, &mesh, &transport);
        light.settle(1e-3);
        let on =
            |e: &Element, x| mesh.surface_of(e) == FLOOR && e.polygon.contains(x, 1e-9);
        let seen = looks.iter().map(|&(x, wo, _)| {
            let patch = mesh.elements.iter().position(|e| on(e, x)).unwrap();
            light.towards(ElementId(patch as u32), wo)
        });
        let off = seen.zip(&looks).map(|(seen, look)| (seen - look.2).length_squared());
        let error = off.sum::<f64>().sqrt() / norm;
        assert!((error - expected).abs() < 0.03, "{edge} {side}: {error}");
        let floor = mesh.elements.iter().zip(light.radiosity());
        let floor = floor.filter(|(e, _)| mesh.surface_of(e) == FLOOR);
        let power_found: Rgb = floor.map(|(e, b)| e.polygon.area() * b).sum();
        let off = (power_found / sent - Rgb::ONE).abs().max_element();
        assert!(off < power, "{edge} {side}: {off}");
    }
}

/// A lobe that is narrower than a bin is smeared over it. The peak that is left: of exponent
/// 20, 200 and 1000, in 16, 64, 256 and 1024 bins.
#[test]
fn bins_smear_a_highlight() {
    for (exponent, expected) in [
        (20.0, [0.392, 0.809, 0.952, 0.987]),
        (200.0, [0.067, 0.292, 0.648, 0.878]),
        (1000.0, [0.015, 0.084, 0.285, 0.586]),
    ] {
        for (side, expected) in [4, 8, 16, 32].into_iter().zip(expected) {
            let shine = Shine::Gloss { reflectance: Rgb::ONE, exponent };
            let c = Coefficients { shine, ..Coefficients::default() };
            let brdf = Material::new("gloss", c).unwrap().brdf();
            let bins = Bins::new(side);
            let scatter = Scatter::of(&brdf, bins);
            // Light from 45°; a bin has the radiance S m/π for each irradiance.
            let wi = dvec3(0.5, 0.5, 0.5_f64.sqrt());
            let wo = dvec3(-0.5, -0.5, 0.5_f64.sqrt());
            let [a, b] = [wi, wo].map(|w| bins.bin_of(w).unwrap() as usize);
            let left = scatter.share(a, b).x * bins.len() as f64 / PI;
            let left = left / brdf.value(wi, wo).x;
            assert!((left - expected).abs() < 6e-4, "{exponent} {side}: {left}");
        }
    }
}
