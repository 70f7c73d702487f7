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
use super::two_pass::{Options, TwoPass};
use crate::film::{Picture, Shot};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material, Shine};
use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::solve::{Progress, Resolution, smooth};

/// Radiosities of a mesh.
struct Field {
    mesh: Mesh,
    /// `B`, W/m², per vertex.
    radiosity: Vec<Rgb>,
}

/// Diffuse reflectances are taken so many times when light is to be reflected once: there
/// must be some for pass 1 to see where light matters.
const NEARLY_BLACK: f64 = 1e-4;

/// The mean of a picture by both passes, class by class, each class from the pass that owns
/// it. Four times pass 1, as finely as `how` says, and pass 2.
///
/// # Accuracy
/// That of pass 1. Where a pane or a solid also scatters diffusely, its light counts as
/// caustic, not as mixed, if it was scattered last there.
pub fn classes_of_two_passes(
    scene: &Scene,
    shot: &Shot,
    how: &Resolution,
    options: &Options,
    progress: Progress,
) -> Table {
    let solve = |shines: bool, reflects: bool| {
        let light = smooth(&variant(scene, shines, reflects), how, progress);
        let mut radiosity = vec![Rgb::ZERO; light.mesh.vertices.len()];
        for element in &light.mesh.elements {
            for corner in element.corners.iter().map(|c| c.0 as usize) {
                let h = [light.irradiance[corner], light.behind[corner]];
                radiosity[corner] = light.radiosity(scene, element, h);
            }
        }
        Field { mesh: light.mesh, radiosity }
    };
    // What the eye sees of a field: straight, and by way of what shines.
    let seen = |field: &Field| {
        let all = TwoPass::of(scene, &field.mesh, &field.radiosity, *options);
        let all = all.picture(shot, progress);
        let straight = mean(&shot.smooth(&field.mesh, &field.radiosity));
        [straight, mean(&all.picture) - straight, all.cut]
    };
    let [lamps, mirrored, cut] = seen(&emission(scene));
    let sky = sky_seen(scene, shot);
    let less_lamps = |[a, b, _]: [Rgb; 3]| [a - lamps, b - mirrored];
    // ANCHOR: by_difference
    let direct = less_lamps(seen(&solve(false, false)));
    let diffuse = less_lamps(seen(&solve(false, true)));
    let once = less_lamps(seen(&solve(true, false)));
    let all = less_lamps(seen(&solve(true, true)));
    let mut table = Table { cut, ..Table::default() };
    for class in Class::all() {
        let k = usize::from(class.mirrored);
        table.mean[class.index()] = match class.light {
            Light::Lamp => [lamps + sky, mirrored - sky][k],
            Light::Direct => direct[k],
            Light::Reflected => diffuse[k] - direct[k],
            Light::Caustic => once[k] - direct[k],
            Light::Mixed => all[k] - diffuse[k] - once[k] + direct[k],
        };
    }
    // ANCHOR_END: by_difference
    table
}

/// The scene with all that shines black, or with nearly no light reflected diffusely, or
/// both.
fn variant(scene: &Scene, shines: bool, reflects: bool) -> Scene {
    let of = |material: &Material| {
        let shine = if shines { material.shine() } else { Shine::Dull };
        // Of panes and glass, what is not diffuse passes: to change one changes both.
        let kept = reflects || shine.passes();
        let share = if kept { 1.0 } else { NEARLY_BLACK };
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
fn emission(scene: &Scene) -> Field {
    let mesh = Mesh::whole(scene);
    let mut radiosity = vec![Rgb::ZERO; mesh.vertices.len()];
    for element in &mesh.elements {
        let material = &scene.materials[mesh.patch_of(element).material.0 as usize];
        for corner in &element.corners {
            radiosity[corner.0 as usize] = material.emission();
        }
    }
    Field { mesh, radiosity }
}

/// The sky as the eye sees it straight: what of a scene that is black is not.
fn sky_seen(scene: &Scene, shot: &Shot) -> Rgb {
    let black = |material: &Material| {
        let black = Material::new(material.name(), Coefficients::default());
        black.unwrap_or_else(|_| material.clone())
    };
    let materials = scene.materials.iter().map(black).collect();
    let scene = Scene { materials, ..scene.clone() };
    let mesh = Mesh::whole(&scene);
    let dark = vec![Rgb::ZERO; mesh.vertices.len()];
    let eye = TwoPass::of(&scene, &mesh, &dark, Options::default());
    mean(&eye.picture(shot, &|_, _, _| ()).picture)
}

fn mean(picture: &Picture) -> Rgb {
    picture.pixels.iter().copied().sum::<Rgb>() / picture.pixels.len().max(1) as f64
}
