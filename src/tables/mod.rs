//! Results as files for other programs: tables of faces, meshes, matrices.
//!
//! ```text
//! B̄ = 1/A ∫ B dA,  H̄ = 1/A ∫ H dA        W/m², over the front of a face of the file
//! ```
//!
//! | table          | holds                                    | it fails when                 |
//! |----------------|------------------------------------------|-------------------------------|
//! | [`faces`]      | the means of each face, as numbers       | never                         |
//! | [`csv`]        | the same, one row for each face          | never                         |
//! | [`ply`]        | elements, radiosity at their corners     | never                         |
//! | [`json`]       | all of it, and what the solution says    | never                         |
//! | [`matrix_csv`] | form factors that are not zero           | it cannot be written          |
//! | [`matrix_npy`] | all form factors, NumPy's format         | it cannot be written          |
//!
//! Numbers in text have the digits that it takes to read them back bit for bit.
//!
//! ```
//! use radiosity::{field::Smooth, room::Room, scene::built_in, tables, work::Work};
//! use radiosity::solution::{Goal, solve};
//! let scene = built_in("furnace").unwrap();
//! let light = solve(&Room::of(&scene), &Smooth, &Goal::within(0.05), &Work::quiet());
//! let light = light.unwrap();
//! let face = tables::faces(&scene, &light)[0];
//! assert!((face.radiosity.x - 2.0).abs() < 0.1 && (face.irradiance.x - 2.0).abs() < 0.2);
//! assert_eq!(tables::csv(&scene, &light).lines().count(), 1 + scene.faces.len());
//! ```
//!
//! **Not here:** pictures ([`crate::film`]); scenes ([`crate::obj::export`]).
//! Beyond the lecture. Sources: the PLY polygon file format (Turk 1994); NumPy's
//! `.npy` format, version 1.0.

mod json;

pub use json::{json, summary};

use crate::form_factor::FaceMatrix;
use crate::geometry::Rgb;
use crate::scene::{Face, Scene, Side};
use crate::solution::Solution;
use std::fmt::Write as _;
use std::io::{self, Write};

/// What falls on a face and leaves it, in the mean over its front.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// All form factors, row by row, `<f8`: NumPy's format, a header that fills up 64 bytes and
/// then the numbers.
///
/// # Errors
/// Those of `file`.
pub fn matrix_npy(matrix: &FaceMatrix, file: &mut dyn Write) -> io::Result<()> {
    let n = matrix.rows.len();
    let header =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({n}, {n}), }}");
    let before = 10; // magic, version, length
    let length = (before + header.len() + 1).next_multiple_of(64) - before;
    file.write_all(b"\x93NUMPY\x01\x00")?;
    file.write_all(&(length as u16).to_le_bytes())?;
    writeln!(file, "{header:<width$}", width = length - 1)?;
    let mut dense = vec![0.0; n];
    for row in &matrix.rows {
        row.iter().for_each(|&(j, factor)| dense[j as usize] = factor);
        dense.iter().try_for_each(|f: &f64| file.write_all(&f.to_le_bytes()))?;
        row.iter().for_each(|&(j, _)| dense[j as usize] = 0.0);
    }
    Ok(())
}

/// `i,j,F`, one line for each factor that is not zero.
///
/// # Errors
/// Those of `file`.
pub fn matrix_csv(matrix: &FaceMatrix, file: &mut dyn Write) -> io::Result<()> {
    writeln!(file, "i,j,F")?;
    for (i, row) in matrix.rows.iter().enumerate() {
        row.iter().try_for_each(|(j, factor)| writeln!(file, "{i},{j},{factor}"))?;
    }
    Ok(())
}
