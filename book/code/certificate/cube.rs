//! A cube whose ceiling shines: a room whose true light is known.

use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::{Analytic, lambert_polygon};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::glam::DVec3;
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::random::Stream;
use radiosity::scene::{MaterialId, Scene, built_in};
use radiosity::solve::{Enclosure, GaussSeidel, Solver};

/// The cube in elements, solved.
pub struct Cube {
    /// Six walls of one reflectance; the first emits 1 W/m².
    pub scene: Scene,
    /// Even elements.
    pub mesh: Mesh,
    /// What is known of them.
    pub enclosure: Enclosure,
    /// `B`, W/m², constant on each.
    pub radiosity: Vec<Rgb>,
}

impl Cube {
    /// With so many elements along each edge.
    pub fn of(reflectance: f64, cells: u32) -> Cube {
        let mut scene = built_in("furnace").expect("`furnace` is built in");
        let paint = |name, emission| {
            let diffuse = Rgb::splat(reflectance);
            let coefficients = Coefficients { emission, diffuse, ..Default::default() };
            Material::new(name, coefficients).expect("a reflectance below 1 is passive")
        };
        scene.materials = vec![paint("wall", Rgb::ZERO), paint("lamp", Rgb::ONE)];
        for surface in &mut scene.surfaces {
            surface.material = MaterialId(u32::from(surface.face.0 == 0));
        }
        let mesh = Mesh::uniform(&scene, 1.0 / f64::from(cells));
        let enclosure = Enclosure::of(&scene, &mesh);
        let matrix = Analytic::new(&scene, &mesh, 1e-7, 0).matrix(&|| ());
        let mut solver = GaussSeidel::new(&enclosure, &matrix);
        let settled = |last: f64| last < 1e-9;
        while solver.next().is_some_and(|step| !settled(step.residual)) {}
        let radiosity = solver.radiosity().to_vec();
        Cube { scene, mesh, enclosure, radiosity }
    }

    /// What is stored, as a field.
    pub fn stored(&self, id: ElementId) -> f64 {
        self.radiosity[id].x
    }

    /// Points spread evenly over all elements, so many in all or some more.
    pub fn points(&self, count: usize) -> Vec<(ElementId, DVec3)> {
        let each = count.div_ceil(self.mesh.elements.len());
        let on = |(k, polygon): (u32, &Polygon)| {
            let places = Stream::named(3, &[u64::from(k)]).points(each);
            let polygon = polygon.clone();
            places.map(move |u| (ElementId(k), polygon.point_at(u)))
        };
        (0u32..).zip(self.mesh.polygons()).flat_map(on).collect()
    }

    /// `H` at a point of an element of `of`, from the light of this cube, exactly.
    pub fn irradiance(&self, of: &Cube, id: ElementId, x: DVec3) -> f64 {
        let normal = of.mesh.element(id).polygon.normal();
        let senders = self.mesh.polygons().zip(&self.radiosity);
        let faces = senders.filter(|(p, _)| p.plane().height(x) > 1e-9);
        faces.map(|(p, b)| b.x * lambert_polygon(x, normal, p)).sum()
    }

    /// `‖B − B*‖/‖B* − E‖`, the truth being the light of a `fine` cube, gathered once more.
    pub fn true_error(&self, fine: &Cube) -> f64 {
        let (mut off, mut reflected) = (0.0, 0.0);
        for (id, x) in self.points(4000) {
            let (e, rho) =
                (self.enclosure.emission[id].x, self.enclosure.reflectance[id].x);
            let light = rho * fine.irradiance(self, id, x);
            off += (e + light - self.stored(id)).powi(2);
            reflected += light * light;
        }
        (off / reflected).sqrt()
    }
}
