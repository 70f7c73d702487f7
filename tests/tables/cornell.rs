//! The regular Cornell box against an independent solution, made on a finer mesh, and
//! its direct light against exact values.

use crate::common::rooms::{face_means, gathered, solved_by};
use crate::common::{cases, within};
use radiosity::field::Smooth;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::Rgb;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solution::{Goal, solve};
use radiosity::solve::{Brightest, Enclosure, Shoot};
use radiosity::work::Work;

const FACES: [&str; 16] = [
    "floor", "back", "green", "red", "ceiling", "light", "short0", "short1", "short2",
    "short3", "short4", "tall0", "tall1", "tall2", "tall3", "tall4",
];

const LIGHT: usize = 5;

fn cornell() -> Scene {
    built_in("cornell-regular").unwrap()
}

/// `‖B − B*‖ / ‖B* − E‖` of the face means, for the channels R and G of the tables.
fn errors(scene: &Scene, means: &[Rgb]) -> [f64; 2] {
    let tables = cases("F_cornell_radiosity");
    let areas = scene.face_areas();
    [0, 1].map(|channel| {
        let expected = &tables[channel]["expected"]["B_face_mean"];
        let (mut error, mut reflected) = (0.0, 0.0);
        for (k, face) in FACES.iter().enumerate().filter(|(k, _)| *k != LIGHT) {
            let expected = expected[face].as_f64().unwrap();
            error += areas[k] * (means[k][channel] - expected).powi(2);
            reflected += areas[k] * expected.powi(2);
        }
        (error / reflected).sqrt()
    })
}

/// Gathering and shooting with all factors at hand: the errors of each.
fn solved(scene: &Scene, mesh: &Mesh, method: &dyn FormFactors) -> [[f64; 2]; 2] {
    let enclosure = Enclosure::of(scene, mesh);
    let matrix = method.matrix(&|| ());
    let gathering = gathered(&enclosure, &matrix, 1e-4, 100);
    let shooting = Shoot::new(&enclosure, &matrix, Brightest::ByPower);
    let shooting = solved_by(&enclosure, shooting, 1e-4, 100_000);
    [gathering, shooting].map(|b| errors(scene, &face_means(scene, mesh, &b)))
}

#[test]
fn face_means_by_analytic_factors_are_within_a_per_cent() {
    let scene = cornell();
    let mesh = Mesh::uniform(&scene, 1.1);
    let tolerance = 0.02 / mesh.elements.len() as f64;
    let method = Analytic::new(&scene, &mesh, tolerance, 0);
    let errors = solved(&scene, &mesh, &method);
    assert!(errors.as_flattened().iter().all(|&e| e < 0.01), "{errors:?}");
}

#[test]
fn face_means_by_hemicubes_are_within_a_per_cent() {
    let scene = cornell();
    let mesh = Mesh::uniform(&scene, 0.5);
    let errors = solved(&scene, &mesh, &Hemicube::new(&mesh, 256));
    assert!(errors.as_flattened().iter().all(|&e| e < 0.01), "{errors:?}");
}

/// Failures 18 and 19 in a whole scene: of a coarse hemicube only few cells show the
/// lamp. All that is gathered is off together; what the lamp's own hemicube shoots is
/// not.
#[test]
fn gathering_by_coarse_hemicubes_is_off_by_the_lamp() {
    let scene = cornell();
    let mesh = Mesh::uniform(&scene, 0.5);
    let [gathering, shooting] = solved(&scene, &mesh, &Hemicube::new(&mesh, 64));
    assert!((0.02..0.06).contains(&gathering[0]), "{gathering:?}");
    assert!(shooting[0] < 0.01, "{shooting:?}");
}

/// By this measure, reflected light cannot be left out: direct light alone is 42 % off.
#[test]
fn direct_light_alone_is_far_off() {
    let scene = cornell();
    let direct =
        &cases("F_cornell_radiosity")[2]["expected"]["direct_irradiance_face_mean"];
    let means: Vec<Rgb> = (0..16)
        .map(|k| {
            let rho = scene.materials[scene.faces[k].material.0 as usize].diffuse();
            rho * direct[FACES[k]].as_f64().unwrap()
        })
        .collect();
    let error = errors(&scene, &means)[0];
    assert!((error - 0.42).abs() < 0.01, "{error}");
}

/// The lamp's light on each face past the blocks, within what the table itself claims:
/// 1e-7 of the lamp's radiosity for most faces.
#[test]
fn direct_irradiance() {
    let scene = cornell();
    let mesh = Mesh::whole(&scene);
    let method = Analytic::new(&scene, &mesh, 1e-6, 0);
    let id = |k: usize| ElementId(k as u32);
    let face_of = |k: usize| mesh.patch_of(&mesh.elements[k]).face.0 as usize;
    let elements = 0..mesh.elements.len();
    let lamp = elements.clone().find(|&k| face_of(k) == LIGHT).unwrap();
    let mut power = [0.0; 16];
    elements.for_each(|k| power[face_of(k)] += method.exchange(id(lamp), id(k)));
    let case = &cases("F_cornell_radiosity")[2];
    for (k, area) in scene.face_areas().into_iter().enumerate() {
        let number = |key: &str| case[key][FACES[k]].as_f64().unwrap();
        let expected =
            case["expected"]["direct_irradiance_face_mean"][FACES[k]].as_f64();
        let (got, expected) = (power[k] / area, expected.unwrap());
        let own = number("uncertainty_per_face");
        assert!((got - expected).abs() <= own, "{}: {got}, not {expected}", FACES[k]);
    }
}

/// `ρ H` of the faces by two million unbiased walks each (`gather_unbiased` over
/// `Mesh::whole`, seed 11): mW/m² for the channels R and G, and the standard errors in
/// per cent. The lamp emits 1 W/m².
const WALKED: [([f64; 2], [f64; 2]); 16] = [
    ([6.2205, 6.3420], [0.08, 0.08]),   // floor
    ([9.4397, 9.5199], [0.07, 0.07]),   // back
    ([0.9606, 5.6394], [0.06, 0.06]),   // green
    ([6.1840, 0.5949], [0.07, 0.07]),   // red
    ([5.4254, 5.2186], [0.08, 0.08]),   // ceiling
    ([1000.0; 2], [0.0; 2]),            // light
    ([18.2553, 18.8925], [0.03, 0.03]), // short0
    ([5.9044, 4.7544], [0.09, 0.10]),   // short1
    ([0.7234, 0.5204], [0.28, 0.30]),   // short2
    ([0.6609, 2.4732], [0.22, 0.15]),   // short3
    ([5.4126, 7.1704], [0.10, 0.09]),   // short4
    ([42.2188, 41.0665], [0.03, 0.02]), // tall0
    ([3.7641, 0.6082], [0.14, 0.25]),   // tall1
    ([5.3113, 4.2382], [0.11, 0.12]),   // tall2
    ([4.9877, 7.0131], [0.10, 0.09]),   // tall3
    ([4.4280, 4.2680], [0.10, 0.11]),   // tall4
];

/// `--method auto` at 1 %, face by face: within a per cent of what walks find.
///
/// The table itself is not that good: the sequence of its meshes had not come to rest on
/// the blocks' sides that little light falls on. There walks and `auto` agree, and both
/// are off from the table by more than it says of itself: by 4 and 5 % on `short1`.
#[test]
fn what_is_found_automatically_face_by_face() {
    const NOT_AT_REST: [&str; 5] = ["short1", "short2", "short4", "tall3", "tall4"];
    let scene = cornell();
    let ask = Goal::default();
    let found = solve(&Room::of(&scene), &Smooth, &ask, &Work::quiet()).unwrap();
    assert!(ask.tolerance == 0.01 && found.converged);
    let means = face_means(&scene, &found.field.mesh, &found.radiosity);
    let tables = cases("F_cornell_radiosity");
    for (k, channel) in (0..16).flat_map(|k| [(k, 0), (k, 1)]) {
        let (face, got, table) = (FACES[k], means[k][channel], &tables[channel]);
        let number = |key: &str| table[key][face].as_f64().unwrap();
        let expected = table["expected"]["B_face_mean"][face].as_f64().unwrap();
        let walked = 1e-3 * WALKED[k].0[channel];
        let noise = 0.01 * WALKED[k].1[channel] * walked;
        let off = (got - walked).abs();
        assert!(off <= 0.01 * walked + 3.0 * noise, "{face}: {got}, walks {walked}");
        if NOT_AT_REST.contains(&face) {
            let own = number("uncertainty_rel_per_face") * expected;
            let off = (walked - expected).abs();
            assert!(off > own + 3.0 * noise, "{face}: the table is right now?");
        } else {
            let own = table["uncertainty_abs"].as_f64().unwrap();
            let near = within(got, expected, 0.01, own);
            assert!(near, "{face}: {got}, not {expected}");
        }
    }
}
