//! The Cornell box and its error, element by element.

use crate::equation::system::System;
use crate::map;
use radiosity::certificate::{Audit, Certificate, Judged, Sampling, irradiance_of};
use radiosity::film::{FalseColour, RgbImage, Shot};
use radiosity::geometry::Rgb;
use radiosity::glam::DVec3;
use radiosity::mesh::ElementId;
use radiosity::solution::audited;
use std::f64::consts::PI;
use std::fmt::Write;
use std::sync::OnceLock;

/// The longest edges of the three meshes, in m.
pub const EDGES: [f64; 3] = [0.2, 0.1, 0.05];

/// With so many points the error of the mesh in the middle is mapped.
pub const POINTS: [usize; 3] = [100, 1000, 30_000];

/// Pixels along an edge of a picture.
const SIZE: u32 = 160;

/// A solved Cornell box.
struct Room {
    system: System,
    radiosity: Vec<Rgb>,
    vertices: Vec<Rgb>,
}

fn rooms() -> &'static [Room; 3] {
    static ROOMS: OnceLock<[Room; 3]> = OnceLock::new();
    ROOMS.get_or_init(|| {
        EDGES.map(|edge| {
            let system = System::of("cornell", edge);
            let radiosity = system.after(crate::equation::system::ALL);
            let vertices = system.mesh.vertex_values(&radiosity);
            Room { system, radiosity, vertices }
        })
    })
}

impl Room {
    fn audit(&self, points: usize) -> Audit {
        let System { scene, mesh, .. } = &self.system;
        let field = |id: ElementId, x: DVec3| {
            mesh.value_at(mesh.element(id), x, &self.vertices)
        };
        let irradiance = irradiance_of(scene, mesh, field);
        let judged = Judged { mesh, irradiance: &irradiance };
        let sampling = Sampling { points, ..Sampling::default() };
        audited(&radiosity::room::Room::of(scene), &judged, sampling)
    }

    fn map(&self, points: usize) -> RgbImage {
        let camera = self.system.scene.camera;
        let shot = Shot { camera, width: SIZE, height: SIZE, samples: 2 };
        let error = self.audit(points).error;
        let shown: Vec<Rgb> = error.iter().map(|e| Rgb::splat(e * PI)).collect();
        FalseColour::ERRORS.draw(&shot.flat(&self.system.mesh, &shown))
    }

    fn elements(&self) -> usize {
        self.system.mesh.elements.len()
    }
}

/// Points for a map of mesh `k`: some on each element.
fn enough(k: usize) -> usize {
    (8 * rooms()[k].elements()).max(Sampling::default().points)
}

/// The light of the finest mesh.
pub fn picture() -> RgbImage {
    let room = &rooms()[2];
    room.system.picture(&room.radiosity, 1.0)
}

/// Where mesh `k` is wrong.
pub fn error_map(k: usize) -> RgbImage {
    rooms()[k].map(enough(k))
}

/// Where the mesh in the middle is wrong, by so many points.
pub fn map_by(points: usize) -> RgbImage {
    rooms()[1].map(points)
}

/// The certificate of mesh `k`.
pub fn certificate(k: usize) -> Certificate {
    rooms()[k].audit(Sampling::default().points).certificate
}

fn say(c: Certificate) -> String {
    let [low, error, high] = [c.low, c.error, c.high].map(|e| 100.0 * e);
    format!("off by about {error:.1} %: between {low:.1} % and {high:.1} %")
}

/// The caption under the map of mesh `k`.
pub fn map_caption(k: usize) -> String {
    format!("{} elements, {}", rooms()[k].elements(), say(certificate(k)))
}

/// The caption under the map by `POINTS[k]` points.
pub fn points_caption(k: usize) -> String {
    let points = POINTS[k];
    format!("{points} points: {}", say(rooms()[1].audit(points).certificate))
}

/// The caption of the opening figure.
pub fn caption() -> String {
    format!(
        "Scene <code>cornell</code>, {} elements with edges up to 0.05 m, analytic form \
         factors, smooth shading. Right: the error of each element, relative to the \
         reflected light of the whole box; {}.",
        rooms()[2].elements(),
        say(certificate(2))
    )
}

/// What the colours mean.
pub fn key() -> String {
    let FalseColour { low, high } = FalseColour::ERRORS;
    map::key(low, high, 5, map::per_cent)
}

/// Where the light of the finest mesh went, and how sure that is.
pub fn ledger() -> String {
    let room = &rooms()[2];
    let b = &room.radiosity;
    let emitted = room.system.power(&room.system.enclosure.emission);
    let (mut escaped, mut backs) = (0.0, 0.0);
    for (i, row) in room.system.factors.rows().iter().enumerate() {
        let sent = room.system.enclosure.area[i] * b[i].element_sum();
        escaped += sent * row.lost().escaped;
        backs += sent * row.lost().absorbed;
    }
    let arriving = room.system.power(&room.system.arriving(b));
    let absorbed = backs + arriving - room.system.power(&room.system.bounced(b));
    let mut text = String::from("| power, all channels | W | share |\n|---|---|---|\n");
    let off = emitted - absorbed - escaped;
    let entries = [
        ("emitted", emitted),
        ("absorbed", absorbed),
        ("escaped", escaped),
        ("imbalance", off),
    ];
    for (name, watts) in entries {
        let _ = writeln!(
            text,
            "| {name} | {watts:.4} | {:.2} % |",
            100.0 * watts / emitted
        );
    }
    text
}
