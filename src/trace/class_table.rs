//! What each pass carries, class by class.
//!
//! ```text
//! DL      = H of the lamps alone, where nothing shines and all is nearly black
//! DL, DD⁺L        where nothing shines               DL, DS⁺L        where all is nearly black
//! D(D|S)*L        the scene as it is                 Mixed = the scene − DD⁺L − DS⁺L + DL
//! ```
//! Light is linear: solved with less of the scene at work, pass 1 finds fewer classes, and
//! the rest is a difference. What the eye sees of each straight, and what by mirrors, pass 2
//! tells in the same way.

use super::classes::{Class, Light, Table};
use super::look::Look;
use super::two_pass::TwoPass;
use crate::field::{Fineness, Pass1, Smooth};
use crate::film::{Picture, Shot};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material};
use crate::mesh::Mesh;
use crate::room::Room;
use crate::scene::Scene;
use crate::work::{Progress, Work};

/// Radiosities of a mesh.
struct Radiosities {
    mesh: Mesh,
    /// `B`, W/m², per vertex.
    radiosity: Vec<Rgb>,
}

/// Diffuse reflectances are taken so many times when light is to be reflected once: there
/// must be some for pass 1 to see where light matters.
const NEARLY_BLACK: f64 = 1e-4;

/// A picture in parts, one for each class.
#[derive(Clone, Debug)]
pub struct ByClass {
    /// By [`Class::index`]. As differences of what is nearly the same, pixels may be below
    /// 0, by as much as pass 1 is off.
    pub pictures: Vec<Picture>,
    /// The weight of what was cut, as in [`Table`].
    pub cut: Rgb,
}

impl ByClass {
    /// A picture by both passes, class by class, each class from the pass that owns it. Four
    /// times pass 1, as finely as `how` says, and five times pass 2.
    ///
    /// # Accuracy
    /// That of pass 1. What a pane or a solid scatters diffusely itself counts as caustic,
    /// not as mixed.
    pub fn of(
        scene: &Scene,
        shot: &Shot,
        how: &Fineness,
        options: &Look,
        progress: Progress,
    ) -> ByClass {
        // What the eye sees of a field: straight, and by way of what shines.
        let seen = |field: &Radiosities| {
            let all = TwoPass::showing(
                &Room::of(scene),
                &field.mesh,
                &field.radiosity,
                *options,
            );
            let all = all.picture(shot, progress);
            let straight = shot.smooth(&field.mesh, &field.radiosity);
            let mirrored = sum(&[(1.0, &all.picture), (-1.0, &straight)]);
            ([straight, mirrored], all.cut)
        };
        // Pass 1 of the scene, or of a part of it.
        let solved = |shines: bool, reflects: bool| {
            seen(&Radiosities::of(
                scene,
                &variant(scene, shines, reflects),
                how,
                progress,
            ))
            .0
        };
        // ANCHOR: by_difference
        let (lamps, cut) = seen(&emission(scene));
        let (direct, once) = (solved(false, false), solved(true, false));
        let (diffuse, all) = (solved(false, true), solved(true, true));
        let sky = sky_seen(scene, shot);
        let part = |class: Class| {
            let k = usize::from(class.mirrored);
            let side = [1.0, -1.0][k];
            match class.light {
                Light::Lamp => sum(&[(1.0, &lamps[k]), (side, &sky)]),
                Light::Direct => sum(&[(1.0, &direct[k]), (-1.0, &lamps[k])]),
                Light::Reflected => sum(&[(1.0, &diffuse[k]), (-1.0, &direct[k])]),
                Light::Caustic => sum(&[(1.0, &once[k]), (-1.0, &direct[k])]),
                Light::Mixed => sum(&[
                    (1.0, &all[k]),
                    (-1.0, &diffuse[k]),
                    (-1.0, &once[k]),
                    (1.0, &direct[k]),
                ]),
            }
        };
        // ANCHOR_END: by_difference
        ByClass { pictures: Class::all().map(part).collect(), cut }
    }

    /// The means of the pictures.
    pub fn table(&self) -> Table {
        let mut table = Table { cut: self.cut, ..Table::default() };
        for (mean, picture) in table.mean.iter_mut().zip(&self.pictures) {
            let count = picture.pixels.len().max(1) as f64;
            *mean = picture.pixels.iter().copied().sum::<Rgb>() / count;
        }
        table
    }
}

/// A sum of pictures, each so many times.
fn sum(parts: &[(f64, &Picture)]) -> Picture {
    let mut sum = Picture::new(parts[0].1.width, parts[0].1.height);
    for (times, picture) in parts {
        for (pixel, &more) in sum.pixels.iter_mut().zip(&picture.pixels) {
            *pixel += *times * more;
        }
    }
    sum
}

impl Radiosities {
    /// The light of a `part` of the scene, as the surfaces of the whole `scene` show it.
    fn of(
        scene: &Scene,
        part: &Scene,
        how: &Fineness,
        progress: Progress,
    ) -> Radiosities {
        let light = Smooth.field(&Room::of(part), how, &Work::told(progress));
        let radiosity = light.vertex_radiosity(scene);
        Radiosities { mesh: light.mesh, radiosity }
    }
}

/// The scene with all that shines black, or with nearly no light reflected diffusely, or
/// both.
fn variant(scene: &Scene, shines: bool, reflects: bool) -> Scene {
    let of = |material: &Material| {
        let shine = if shines { material.shine() } else { Default::default() };
        // Of panes and glass, what is not diffuse passes: to change one changes both.
        if shine.passes() {
            return material.clone();
        }
        let share = if reflects { 1.0 } else { NEARLY_BLACK };
        let coefficients = Coefficients {
            emission: material.emission(),
            diffuse: share * material.diffuse(),
            translucence: share * material.translucence(),
            shine,
        };
        // Less than a material that is passive.
        Material::new(material.name(), coefficients)
            .unwrap_or_else(|_| material.clone())
    };
    Scene { materials: scene.materials.iter().map(of).collect(), ..scene.clone() }
}

/// The lamps, and nothing that they light.
fn emission(scene: &Scene) -> Radiosities {
    let mesh = Mesh::whole(scene);
    let mut radiosity = vec![Rgb::ZERO; mesh.vertices.len()];
    for element in &mesh.elements {
        let material = &scene.materials[mesh.patch_of(element).material.0 as usize];
        for corner in &element.corners {
            radiosity[corner.0 as usize] = material.emission();
        }
    }
    Radiosities { mesh, radiosity }
}

/// The sky as the eye sees it straight: what of a scene that is black is not.
fn sky_seen(scene: &Scene, shot: &Shot) -> Picture {
    let materials = scene.materials.iter().map(|m| Material::black(m.name())).collect();
    let scene = Scene { materials, ..scene.clone() };
    let mesh = Mesh::whole(&scene);
    let dark = vec![Rgb::ZERO; mesh.vertices.len()];
    let eye = TwoPass::showing(&Room::of(&scene), &mesh, &dark, Look::default());
    eye.picture(shot, &|_, _, _| ()).picture
}
