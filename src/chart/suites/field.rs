//! The light of a scene as well as it can be found, for others to be held against.
//!
//! ```text
//! error = ‖B − B*‖/‖B* − E‖         at some thousand points, worst channel
//! ```
//! The truth is smooth light that errs by far less than what is told. How far it may be off
//! itself, its certificate says: that is by rays, and trusts no mesh.

use crate::certificate::{Certificate, Judged, Sampling, certify, irradiance_of};
use crate::chart::Verdict;
use crate::field::{Field, Smooth};
use crate::geometry::Rgb;
use crate::mesh::{ElementId, Mesh};
use crate::random::Stream;
use crate::room::Room;
use crate::scene::Scene;
use crate::solve::Ledger;
use glam::DVec3;

/// LinearLight as it is shown: linear between the vertices of a mesh.
#[derive(Debug)]
pub struct LinearLight {
    /// The elements.
    pub mesh: Mesh,
    /// `B`, W/m², at its vertices.
    pub radiosity: Vec<Rgb>,
    /// Where the light went.
    pub ledger: Ledger,
}

impl LinearLight {
    /// Smooth light of a scene.
    pub fn smooth(scene: &Scene, found: Field) -> LinearLight {
        let radiosity = found.vertex_radiosity(scene);
        LinearLight { mesh: found.mesh, radiosity, ledger: found.ledger }
    }

    /// How wrong it is.
    pub fn certified(&self, room: &Room, sampling: Sampling) -> Certificate {
        let radiosity = |id: ElementId, x: DVec3| self.at(id, x);
        let irradiance = irradiance_of(room.scene, &self.mesh, radiosity);
        let field = Judged { mesh: &self.mesh, irradiance: &irradiance };
        certify(room.scene, room.visibility(), &field, sampling)
    }

    /// `B`, W/m², at a point of an element.
    pub fn at(&self, id: ElementId, x: DVec3) -> Rgb {
        self.mesh.value_at(self.mesh.element(id), x, &self.radiosity)
    }
}

/// A point of a surface, the area it stands for, and what is reflected there.
#[derive(Debug)]
struct JudgedPlace {
    surface: usize,
    at: DVec3,
    share: f64,
    emission: Rgb,
    reflected: Rgb,
}

/// The light of a scene at many points.
#[derive(Debug)]
pub struct Truth {
    places: Vec<JudgedPlace>,
    /// `‖B* − E‖²`.
    scale: Rgb,
    /// How far it may be off, as errors are.
    pub uncertainty: f64,
}

/// Points in all, about.
const PLACES: f64 = 2000.0;

/// Names the points, and the rays of the certificate.
const SEED: u64 = 7;

impl Truth {
    /// Smooth light that is asked for this `error`.
    pub fn of(scene: &Scene, error: f64) -> Truth {
        let room = Room::of(scene);
        let light = LinearLight::smooth(scene, Smooth::once(&room, error));
        let sampling =
            Sampling { points: 1600, rays: 1024, seed: SEED, ..Default::default() };
        let uncertainty = light.certified(&room, sampling).high;
        let mut places = places(scene);
        let values = values(&places, &light);
        let mut scale = Rgb::ZERO;
        for (place, b) in places.iter_mut().zip(values) {
            place.reflected = b - place.emission;
            scale += place.share * place.reflected * place.reflected;
        }
        Truth { places, scale, uncertainty }
    }

    /// How far `light` is off, and what its ledger lacks.
    pub fn judge(&self, light: &LinearLight) -> Verdict {
        let mut sum = Rgb::ZERO;
        for (place, b) in self.places.iter().zip(values(&self.places, light)) {
            let off = b - place.emission - place.reflected;
            sum += place.share * off * off;
        }
        Verdict {
            error: (sum / self.scale).max_element().sqrt(),
            energy: Some(light.ledger.worst_imbalance()),
        }
    }
}

/// Points spread evenly over all surfaces that reflect or let light through.
fn places(scene: &Scene) -> Vec<JudgedPlace> {
    let all: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    let of_surface = |(surface, s): (usize, &crate::scene::Surface)| {
        let area = s.polygon.area();
        let material = scene.material(s);
        let lit = material.scattered() != Rgb::ZERO;
        let count = if lit { (PLACES * area / all).ceil() as usize } else { 0 };
        let place = |u| JudgedPlace {
            surface,
            at: s.polygon.point_at(u),
            share: area / count as f64,
            emission: material.emission(),
            reflected: Rgb::ZERO,
        };
        let points = Stream::named(SEED, &[surface as u64]).points(count);
        points.map(place).collect::<Vec<_>>()
    };
    scene.surfaces.iter().enumerate().flat_map(of_surface).collect()
}

/// What `light` is at these places.
fn values(places: &[JudgedPlace], light: &LinearLight) -> Vec<Rgb> {
    let surfaces = places.iter().map(|p| p.surface + 1).max().unwrap_or(0);
    let mut of_surface = vec![Vec::new(); surfaces];
    for (id, element) in (0u32..).map(ElementId).zip(&light.mesh.elements) {
        if let Some(own) = of_surface.get_mut(light.mesh.surface_of(element) as usize) {
            own.push(id);
        }
    }
    let outside =
        |id: &ElementId, x| light.mesh.element(*id).polygon.distance_outside(x);
    let value = |place: &JudgedPlace| {
        let own = of_surface[place.surface].iter();
        let holds = |id: &&ElementId| outside(id, place.at) == 0.0;
        // Between two of them by rounding: the nearest.
        let id = own.clone().find(holds).or_else(|| {
            own.min_by(|a, b| outside(a, place.at).total_cmp(&outside(b, place.at)))
        });
        light.at(*id.expect("elements cover their surface"), place.at)
    };
    places.iter().map(value).collect()
}
