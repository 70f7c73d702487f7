//! How many rays a second meet their surface, on rays and triangles that come from elsewhere.
//! `cargo bench --bench rays -- scene.obj rays.bin 3` prints one JSON object.
//!
//! `rays.bin` holds seven 64-bit floats a ray, little endian: origin, direction of unit
//! length, reach. Each ray asks for the first surface that it meets, and once more whether
//! any stands within its reach; the crate has no cheaper answer to the second question than
//! to the first. Times are CPU seconds of one thread, of each of so many runs, without
//! reading the files.

use cpu_time::ThreadTime;
use radiosity::geometry::Ray;
use radiosity::glam::DVec3;
use radiosity::obj;
use radiosity::visibility::Visibility;
use serde_json::json;

fn main() {
    let mut arguments = std::env::args().skip(1).filter(|a| !a.starts_with("--"));
    let (Some(scene), Some(rays)) = (arguments.next(), arguments.next()) else {
        return println!("name an OBJ file and a file of rays");
    };
    let runs: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1);
    let (scene, _) = obj::load(scene).expect("an OBJ file");
    let rays = read(&std::fs::read(rays).expect("a file of rays"));

    let start = ThreadTime::now();
    let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let build = start.elapsed().as_secs_f64();
    let closest = |rays: &[(Ray, f64)]| {
        rays.iter().filter(|(ray, _)| surfaces.closest(ray, None).is_some()).count()
    };
    let within = |rays: &[(Ray, f64)]| {
        let met = |(ray, reach): &&(Ray, f64)| {
            surfaces.closest(ray, None).is_some_and(|hit| hit.distance < *reach)
        };
        rays.iter().filter(met).count()
    };
    let closest = timed(runs, &rays, closest);
    let within = timed(runs, &rays, within);
    println!(
        "{}",
        json!({ "rays": rays.len(), "build": build, "closest": closest, "any": within })
    );
}

/// The count, and the seconds that it takes, after a tenth of it unmeasured.
fn timed(
    runs: usize,
    rays: &[(Ray, f64)],
    count: impl Fn(&[(Ray, f64)]) -> usize,
) -> serde_json::Value {
    count(&rays[..rays.len() / 10]);
    let mut found = 0;
    let mut run = || {
        let start = ThreadTime::now();
        found = count(rays);
        start.elapsed().as_secs_f64()
    };
    let seconds: Vec<f64> = (0..runs.max(1)).map(|_| run()).collect();
    json!({ "hits": found, "seconds": seconds })
}

fn read(bytes: &[u8]) -> Vec<(Ray, f64)> {
    let number = |b: &[u8]| f64::from_le_bytes(b.try_into().expect("8 bytes"));
    let ray = |bytes: &[u8]| {
        let numbers: Vec<f64> = bytes.chunks_exact(8).map(number).collect();
        let (origin, direction) =
            (DVec3::from_slice(&numbers), DVec3::from_slice(&numbers[3..]));
        (Ray { origin, direction }, numbers[6])
    };
    bytes.chunks_exact(56).map(ray).collect()
}
