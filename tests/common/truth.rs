//! The light of a scene, known by other means than those under test.

use glam::DVec3;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::Rgb;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::occlusion::{Blockers, lambert_visible};
use radiosity::random::Stream;
use radiosity::room::Direct;
use radiosity::scene::Scene;
use radiosity::solve::Enclosure;

use super::rooms::gathered;

/// A field: the radiosity in W/m² at a point of an element.
pub type Field<'a> = &'a (dyn Fn(ElementId, DVec3) -> Rgb + Sync);

/// Radiosities of the elements of an even mesh, by factors that know what hides what.
pub fn solved(scene: &Scene, edge: f64) -> (Mesh, Vec<Rgb>) {
    let mesh = Mesh::uniform(scene, edge);
    let enclosure = Enclosure::of(scene, &mesh);
    let factors = Analytic::new(scene, &mesh, 1e-4, 0).matrix(&|| ());
    let radiosity = gathered(&enclosure, &factors, 1e-5, 1000);
    (mesh, radiosity)
}

/// The true `B` at points of a coarse mesh.
pub struct Truth {
    /// Element, point, share of the area, `B`, `B − E`; reflecting elements only.
    places: Vec<(ElementId, DVec3, f64, Rgb, Rgb)>,
}

impl Truth {
    /// Light of a `fine` mesh, constant on its elements, gathered once more at points of
    /// every element of `mesh`, by Lambert's formula with what hides cut away; light from
    /// emitters is exact.
    pub fn of(scene: &Scene, mesh: &Mesh, fine: &(Mesh, Vec<Rgb>)) -> Truth {
        let (enclosure, of_fine) =
            (Enclosure::of(scene, mesh), Enclosure::of(scene, &fine.0));
        let (blockers, direct) = (Blockers::of(scene), Direct::of(scene));
        let each = (4000 / mesh.elements.len()).clamp(16, 1024);
        assert!(direct.sums_all_lamps(), "too many lamps for an exact sum");
        let mut places = Vec::new();
        for (k, element) in mesh.elements.iter().enumerate() {
            let rho = enclosure.reflectance[k];
            if rho == Rgb::ZERO {
                continue;
            }
            let (polygon, normal) = (&element.polygon, element.polygon.normal());
            let points: Vec<DVec3> = Stream::named(7, &[k as u64])
                .points(each)
                .map(|place| polygon.point_at(place))
                .collect();
            let lit = direct.on(polygon);
            let mut h: Vec<Rgb> = points.iter().map(|&x| lit.irradiance(x)).collect();
            for (j, sender) in fine.0.polygons().enumerate() {
                let reflected = fine.1[j] - of_fine.emission[j];
                let faces = |v: &&DVec3| sender.plane().height(**v) > 1e-9;
                if reflected == Rgb::ZERO
                    || polygon.vertices().iter().all(|v| !faces(&v))
                {
                    continue;
                }
                let past = blockers.between(polygon, sender);
                for (h, &x) in h.iter_mut().zip(&points) {
                    *h += reflected * lambert_visible(x, normal, sender, &past);
                }
            }
            let share = enclosure.area[k] / each as f64;
            let id = ElementId(k as u32);
            let e = enclosure.emission[k];
            let place = |(x, h): (DVec3, Rgb)| (id, x, share, e + rho * h, rho * h);
            places.extend(points.into_iter().zip(h).map(place));
        }
        Truth { places }
    }

    /// `‖B − B*‖/‖B* − E‖` of `field`, worst channel.
    pub fn error(&self, field: Field) -> f64 {
        let (mut off, mut reflected) = (Rgb::ZERO, Rgb::ZERO);
        for &(id, x, share, truth, light) in &self.places {
            off += share * (field(id, x) - truth).powf(2.0);
            reflected += share * light * light;
        }
        (off / reflected).map(f64::sqrt).max_element()
    }
}
