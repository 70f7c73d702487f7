//! Specular radiosity: laws that hold to rounding, and the light of a glossy room.

mod common;

use common::rooms::{box_walls, rectangle};
use glam::{DVec3, dvec2, dvec3};
use radiosity::directional::{Bins, Directional, Scatter, Transport, beam_by_walks};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Brdf, Coefficients, Lobe, Material};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solve::{Enclosure, GaussSeidel, Solver};
use std::f64::consts::PI;

/// Emission, W/m², diffuse and specular reflectance.
type Paint = (Rgb, Rgb, Rgb);

fn scene(faces: impl IntoIterator<Item = (Polygon, Paint)>) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, (emission, diffuse, specular))) in faces.into_iter().enumerate() {
        let coefficients = Coefficients { emission, diffuse, specular };
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

fn brdfs(scene: &Scene, exponent: f64) -> Vec<Brdf> {
    scene.materials.iter().map(|m| m.brdf(exponent)).collect()
}

fn glossy(exponent: f64) -> Brdf {
    let (diffuse, specular) = (Rgb::splat(0.3), dvec3(0.6, 0.3, 0.0));
    let c = Coefficients { diffuse, specular, ..Coefficients::default() };
    Material::new("paint", c).unwrap().brdf(exponent)
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
        // ∫ cos² dω / π = 2/3, by the midpoint rule
        assert!((cosines - 2.0 / 3.0).abs() < 0.01, "{side}: {cosines}");
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
        assert!((mean - exact).abs().max_element() < 1e-3, "{side} {exponent}: {mean}");
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
        let brdfs = brdfs(&scene, 10.0);
        let mut light = Directional::new(&scene, &mesh, &brdfs, &transport);
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
        let brdfs = brdfs(&scene, 30.0);
        let mut light = Directional::new(&scene, &mesh, &brdfs, &transport);
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
    let brdfs = brdfs(&scene, 20.0);
    let mut transport = Transport::sampled(&mesh, Bins::new(4), 100, 1);
    let open = Directional::new(&scene, &mesh, &brdfs, &transport).settle(1e-10);
    let imbalance = open.worst_imbalance();
    assert!((1e-6..0.01).contains(&imbalance), "{imbalance}");
    assert!(transport.close().unwrap().after < 1e-12);
    let light = Directional::new(&scene, &mesh, &brdfs, &transport);
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
    let brdfs = brdfs(&scene, 20.0);
    let ledger = Directional::new(&scene, &mesh, &brdfs, &transport).settle(1e-12);
    // Opposed unit squares have F = 0.199825; little comes back and escapes later.
    let escaped = ledger.escaped.x / ledger.emitted.x;
    assert!((0.88..0.93).contains(&escaped), "{escaped}");
    assert!(ledger.worst_imbalance() < 2e-3, "{ledger:?}");
}
