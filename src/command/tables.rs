//! A solution as a file: a table of faces, a mesh, or all of it.

use super::report::{self, rgb};
use radiosity::geometry::Rgb;
use radiosity::scene::{Face, Scene, Side};
use radiosity::solution::Solution;
use serde_json::json;
use std::fmt::Write;

/// What falls on a face and leaves it, in the mean over its front.
pub struct FaceLight {
    /// Area of one side, scene units squared; 0 for a face that others cover wholly.
    pub area: f64,
    /// `B = Ke + Kd H + Td H_back`, W/m².
    pub radiosity: Rgb,
    /// `H`, W/m²; 0 for a face that others cover wholly.
    pub irradiance: Rgb,
}

/// The area means of each face of the OBJ file, in file order.
pub fn faces(scene: &Scene, solution: &Solution) -> Vec<FaceLight> {
    // On the front and on the back of each, W.
    let mut arriving = vec![[Rgb::ZERO; 2]; scene.faces.len()];
    for (element, &irradiance) in
        solution.field.mesh.elements.iter().zip(&solution.irradiance)
    {
        let surface = &scene.surfaces[solution.field.mesh.surface_of(element) as usize];
        let side = usize::from(surface.side == Side::Back);
        arriving[surface.face.0 as usize][side] += element.polygon.area() * irradiance;
    }
    let light = |((face, area), arriving): ((&Face, f64), [Rgb; 2])| {
        let material = &scene.materials[face.material.0 as usize];
        let mean = |arriving| if area > 0.0 { arriving / area } else { Rgb::ZERO };
        let [irradiance, behind] = arriving.map(mean);
        let radiosity = material.emission()
            + material.diffuse() * irradiance
            + material.translucence() * behind;
        FaceLight { area, radiosity, irradiance }
    };
    scene.faces.iter().zip(scene.face_areas()).zip(arriving).map(light).collect()
}

/// `face,area,B_r,B_g,B_b,H_r,H_g,H_b`, one row for each face. Numbers have the digits
/// that it takes to read them back bit for bit.
pub fn csv(scene: &Scene, solution: &Solution) -> String {
    let mut text = String::from("face,area,B_r,B_g,B_b,H_r,H_g,H_b\n");
    for (id, face) in faces(scene, solution).iter().enumerate() {
        let [b, h] = [face.radiosity, face.irradiance].map(|c| {
            let Rgb { x, y, z } = c;
            format!("{x},{y},{z}")
        });
        let _ = writeln!(text, "{id},{},{b},{h}", face.area);
    }
    text
}

/// The elements with the radiosity at their corners, as ASCII PLY.
pub fn ply(solution: &Solution) -> String {
    let mesh = &solution.field.mesh;
    let mut text =
        format!("ply\nformat ascii 1.0\nelement vertex {}\n", mesh.vertices.len());
    for name in ["x", "y", "z", "B_r", "B_g", "B_b"] {
        let _ = writeln!(text, "property double {name}");
    }
    let _ = writeln!(text, "element face {}", mesh.elements.len());
    text += "property list uchar uint vertex_indices\nend_header\n";
    for (p, b) in mesh.vertices.iter().zip(&solution.vertex_radiosity) {
        let _ = writeln!(text, "{} {} {} {} {} {}", p.x, p.y, p.z, b.x, b.y, b.z);
    }
    for element in &mesh.elements {
        let _ = write!(text, "{}", element.corners.len());
        for corner in &element.corners {
            let _ = write!(text, " {}", corner.0);
        }
        text += "\n";
    }
    text
}

/// What `--json` prints (but for the seconds), the faces, and the whole mesh.
pub fn json(
    scene: &Scene,
    solution: &Solution,
    plan: &[String],
    tolerance: f64,
) -> String {
    let mut all = report::json(solution, plan, tolerance);
    all["scene"] = json!(scene.name);
    let face = |(id, face): (usize, &FaceLight)| {
        json!({
            "face": id, "area": face.area,
            "B": rgb(face.radiosity), "H": rgb(face.irradiance),
        })
    };
    all["faces"] = faces(scene, solution).iter().enumerate().map(face).collect();
    let side = |element| {
        let surface = &scene.surfaces[solution.field.mesh.surface_of(element) as usize];
        if surface.side == Side::Front { "front" } else { "back" }
    };
    let vertices = solution.field.mesh.vertices.iter().zip(&solution.vertex_radiosity);
    let elements =
        solution.field.mesh.elements.iter().enumerate().map(|(k, element)| {
            let corners: Vec<u32> =
                element.corners.iter().map(|corner| corner.0).collect();
            json!({
                "face": solution.field.mesh.patch_of(element).face.0,
                "side": side(element),
                "corners": corners,
                "area": element.polygon.area(),
                "B": rgb(solution.radiosity[k]),
                "H": rgb(solution.irradiance[k]),
            })
        });
    all["mesh"] = json!({
        "vertices": vertices
            .map(|(p, &b)| json!({ "position": p.to_array(), "B": rgb(b) }))
            .collect::<Vec<_>>(),
        "elements": elements.collect::<Vec<_>>(),
    });
    format!("{all}\n")
}
