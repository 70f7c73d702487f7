//! Small scenes for tests, and what is measured of them.

use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::exchange;
use radiosity::form_factor::{Accuracy, FormFactors, Lost, Matrix, Row};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solve::{Enclosure, GaussSeidel, Solver};

/// A rectangle from a corner and two edges; its front is where `a × b` points.
pub fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    Polygon::new(vec![corner, corner + a, corner + a + b, corner + b]).unwrap()
}

/// The walls of a box with one corner at the origin, fronts inwards: x = 0, x = w, y =
/// 0, y = d, z = 0, z = h.
pub fn box_walls([w, d, h]: [f64; 3]) -> [Polygon; 6] {
    let (x, y, z, o) = (DVec3::X * w, DVec3::Y * d, DVec3::Z * h, DVec3::ZERO);
    [
        rectangle(o, y, z),
        rectangle(x, z, y),
        rectangle(o, z, x),
        rectangle(y, x, z),
        rectangle(o, x, y),
        rectangle(z, y, x),
    ]
}

/// The same outline moved.
pub fn moved(polygon: &Polygon, to: impl Fn(DVec3) -> DVec3) -> Polygon {
    Polygon::new(polygon.vertices().iter().map(|&v| to(v)).collect()).unwrap()
}

/// A scene of faces, each with its emitted radiosity (W/m²) and its reflectance.
pub fn coloured_scene(faces: impl IntoIterator<Item = (Polygon, Rgb, Rgb)>) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, emission, diffuse)) in faces.into_iter().enumerate() {
        let coefficients = Coefficients { emission, diffuse, ..Default::default() };
        materials.push(Material::new(format!("m{k}"), coefficients).unwrap());
        let material = MaterialId(k as u32);
        outlines.push(Face { outline: polygon.vertices().to_vec(), material });
    }
    Scene::assemble("test", materials, outlines, None).unwrap().0
}

/// The same, grey.
pub fn scene(faces: impl IntoIterator<Item = (Polygon, f64, f64)>) -> Scene {
    let grey = |(polygon, e, rho): (Polygon, f64, f64)| {
        (polygon, Rgb::splat(e), Rgb::splat(rho))
    };
    coloured_scene(faces.into_iter().map(grey))
}

/// Black faces: for form factors alone.
pub fn black(faces: impl IntoIterator<Item = Polygon>) -> Scene {
    scene(faces.into_iter().map(|polygon| (polygon, 0.0, 0.0)))
}

/// The factors of a convex room, where nothing hides anything: reciprocal, and each row
/// sums to one, both to rounding.
pub fn exact_factors(mesh: &Mesh) -> Matrix {
    let n = mesh.elements.len();
    let polygons: Vec<&Polygon> = mesh.polygons().collect();
    let mut rows = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in i + 1..n {
            if mesh.elements[i].patch == mesh.elements[j].patch {
                continue;
            }
            let power = exchange(polygons[i], polygons[j], Accuracy::Best);
            rows[i][j] = power / polygons[i].area();
            rows[j][i] = power / polygons[j].area();
        }
    }
    Matrix::from_rows(rows.iter().map(|row| Row::of(row, Lost::default())).collect())
}

/// All rows of a method, and what each loses.
pub fn rows(method: &dyn FormFactors) -> Vec<(Vec<f64>, Lost)> {
    let n = method.len();
    let row = |id| {
        let mut row = vec![0.0; n];
        let lost = method.row(ElementId(id), &mut row);
        (row, lost)
    };
    (0..n as u32).map(row).collect()
}

/// Gathers until the solver's own error is below `accuracy`, or `most` sweeps are done.
pub fn gathered(
    enclosure: &Enclosure,
    matrix: &Matrix,
    accuracy: f64,
    most: usize,
) -> Vec<Rgb> {
    solved_by(enclosure, GaussSeidel::new(enclosure, matrix), accuracy, most)
}

/// Runs until the solver's own error is below `accuracy`, as long as factors are
/// reciprocal, or `most` steps are done.
pub fn solved_by(
    enclosure: &Enclosure,
    mut solver: impl Solver,
    accuracy: f64,
    most: usize,
) -> Vec<Rgb> {
    solver.run(enclosure.largest_reflectance().max_element(), accuracy, most);
    solver.radiosity().to_vec()
}

/// Area means over the faces of the OBJ file.
pub fn face_means(scene: &Scene, mesh: &Mesh, of_elements: &[Rgb]) -> Vec<Rgb> {
    let mut sums = vec![(Rgb::ZERO, 0.0); scene.faces.len()];
    for (element, &value) in mesh.elements.iter().zip(of_elements) {
        let (sum, area) = &mut sums[mesh.patch_of(element).face.0 as usize];
        *sum += element.polygon.area() * value;
        *area += element.polygon.area();
    }
    sums.into_iter().map(|(sum, area)| sum / area).collect()
}

/// The unit square `z = height`, looking up or down.
pub fn unit_square(height: f64, up: bool) -> Polygon {
    let square = rectangle(dvec3(0.0, 0.0, height), DVec3::X, DVec3::Y);
    if up { square } else { square.flipped() }
}
