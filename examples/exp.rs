#![allow(missing_docs)]
use radiosity::geometry::Rgb;
use radiosity::material::*;
use radiosity::mesh::Mesh;
use radiosity::scene::*;
use radiosity::solve::*;
fn main() {
    let which = std::env::args().nth(1).unwrap_or("mirror".into());
    let tol: f64 = std::env::args().nth(2).and_then(|s| s.parse().ok()).unwrap_or(0.01);
    let scene = match which.as_str() {
        "mirror" | "pane" | "glossy" | "trans" => {
            let mut s = built_in("cornell-regular").unwrap();
            let n = s.materials.len() as u32;
            let (lo, hi) = s.bounds();
            let size = (hi - lo).max_element();
            let shine = match which.as_str() {
                "mirror" => Shine::Mirror { reflectance: Rgb::splat(0.9) },
                "glossy" => {
                    Shine::Gloss { reflectance: Rgb::splat(0.5), exponent: 20.0 }
                }
                "pane" => Shine::Pane { index: 1.5, tint: Rgb::ONE },
                _ => Shine::Dull,
            };
            let diffuse = if which == "glossy" { Rgb::splat(0.3) } else { Rgb::ZERO };
            let translucence =
                if which == "trans" { Rgb::splat(0.6) } else { Rgb::ZERO };
            s.materials.push(
                Material::new(
                    "m",
                    Coefficients { shine, diffuse, translucence, ..Default::default() },
                )
                .unwrap(),
            );
            let mut faces = s.faces.clone();
            if which == "pane" || which == "trans" {
                use glam::dvec3;
                let z = size * 0.3;
                faces.push(Face {
                    outline: vec![
                        dvec3(lo.x + 0.2 * size, 0.2 * size, z),
                        dvec3(lo.x + 0.8 * size, 0.2 * size, z),
                        dvec3(lo.x + 0.8 * size, 0.7 * size, z),
                        dvec3(lo.x + 0.2 * size, 0.7 * size, z),
                    ],
                    material: MaterialId(n),
                });
            } else {
                let k = faces.len();
                for f in &mut faces[k - 5..] {
                    f.material = MaterialId(n);
                }
            }
            Scene::assemble("x", s.materials.clone(), faces, Some(s.camera)).unwrap().0
        }
        other => built_in(other).unwrap(),
    };
    use radiosity::glam;
    let ask = Ask {
        tolerance: tol,
        most_patches: 300,
        most_elements: 20000,
        ..Ask::default()
    };
    let t = cpu_time::ProcessTime::now();
    let (s, passes) =
        automatic(&scene, resolution_for(&scene, tol), &ask, &|_, _, _| {});
    let time = t.elapsed().as_secs_f64();
    for p in &passes {
        println!(
            "{} patches {} el {} hemis cert {:?}",
            p.patches, p.elements, p.hemicubes, p.certificate
        );
    }
    println!(
        "cpu {time:.2} emitted {:.4} imbalance {:.4}",
        s.ledger.emitted.y, s.ledger.imbalance.y
    );
    // patches of size: 8 per wall
    let size = scene.bounds().1.max_element();
    let m = Mesh::patched(&scene, size / 4.01);
    let t = cpu_time::ProcessTime::now();
    let walks: usize =
        std::env::args().nth(3).and_then(|s| s.parse().ok()).unwrap_or(500);
    let g = gather_unbiased(&scene, &m, walks, 1);
    println!("unbiased cpu {:.2}", t.elapsed().as_secs_f64());
    // auto's mean over those patches
    let (mut num, mut den, mut noise) = (0.0, 0.0, 0.0);
    let mut worst = (0.0, 0usize);
    for (k, e) in m.elements.iter().enumerate() {
        let mut sum = Rgb::ZERO;
        let mut area = 0.0;
        for (i, f) in s.mesh.elements.iter().enumerate() {
            if s.mesh.surface_of(f) == m.surface_of(e)
                && e.polygon.contains(f.polygon.centroid(), 0.0)
            {
                sum += f.polygon.area() * s.irradiance[i];
                area += f.polygon.area();
            }
        }
        if area < 0.99 * e.polygon.area() {
            continue;
        }
        let h = sum / area;
        let a = e.polygon.area();
        let d = h - g[k].irradiance;
        num += a * d.y * d.y;
        noise += a * g[k].error.y.powi(2);
        den += a * g[k].irradiance.y.powi(2);
        let z = (d.y / g[k].error.y).abs();
        if z > worst.0 {
            worst = (z, k);
        }
    }
    println!(
        "rms {:.4} noise {:.4} -> {:.4} worst z {:?}",
        (num / den as f64).sqrt(),
        (noise / den as f64).sqrt(),
        ((num - noise) / den as f64).max(0.0).sqrt(),
        worst
    );
}
