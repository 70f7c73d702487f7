//! `--method auto` where light goes on: mirrors, panes, paper, gloss, glass and skies, held
//! against random walks that know of no mesh, no image and no hemicube.

use radiosity::field::{Gathered, Smooth, gather_unbiased};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::sky::{Panorama, Sky};
use radiosity::solution::{Goal, Solution, solve};
use radiosity::work::Work;

fn solved(scene: &Scene, tolerance: f64) -> Solution {
    let goal = Goal::within(tolerance);
    solve(&Room::of(scene), &Smooth, &goal, &Work::quiet()).unwrap()
}

/// Mean irradiance of each surface.
fn surface_means(scene: &Scene, solution: &Solution) -> Vec<Rgb> {
    let mut sums = vec![Rgb::ZERO; scene.surfaces.len()];
    for (element, &h) in solution.field.mesh.elements.iter().zip(&solution.irradiance) {
        let surface = solution.field.mesh.surface_of(element) as usize;
        sums[surface] += element.polygon.area() * h;
    }
    let areas = scene.surfaces.iter().map(|s| s.polygon.area());
    sums.iter().zip(areas).map(|(&sum, area)| sum / area).collect()
}

/// Of the means over the surfaces: the root of the area mean of the squared difference to the
/// walks, less the walks' own variance, over the root mean square of the walks; and the
/// largest that this is by chance at 4 σ, should there be no difference.
fn off(scene: &Scene, means: &[Rgb], walks: &[Gathered]) -> (f64, f64) {
    let (mut square, mut noise, mut all) = (0.0, 0.0, 0.0);
    let mut spread = 0.0;
    for ((s, h), walk) in scene.surfaces.iter().zip(means).zip(walks) {
        let area = s.polygon.area();
        let variance = walk.error.y * walk.error.y;
        square += area * (h.y - walk.irradiance.y).powi(2);
        noise += area * variance;
        spread += 2.0 * (area * variance).powi(2);
        all += area * walk.irradiance.y.powi(2);
    }
    let chance = (4.0 * f64::sqrt(spread) / all).sqrt();
    (((square - noise).max(0.0) / all).sqrt(), chance)
}

/// The error asked for holds of the field; means over surfaces are better. Walks see the
/// same scene by other means: the two may differ by the tolerance and by chance.
#[track_caller]
fn agrees_with_walks(name: &str, tolerance: f64, walks: usize) {
    let scene = built_in(name).unwrap();
    let solution = solved(&scene, tolerance);
    let certificate = solution.certificate;
    assert!(solution.converged, "{name}: {certificate:?}");
    let means = surface_means(&scene, &solution);
    let found = gather_unbiased(&Room::of(&scene), &Mesh::whole(&scene), walks, 7);
    let (off, chance) = off(&scene, &means, &found);
    assert!(off <= tolerance + chance, "{name}: {off} {chance} {certificate:?}");
    assert!(chance < 2.0 * tolerance, "{name}: too few walks: {chance}");
    let imbalance = solution.field.ledger.worst_imbalance();
    assert!(imbalance < 0.02, "{name}: {:?}", solution.field.ledger);
}

#[test]
fn a_block_that_mirrors() {
    agrees_with_walks("cornell-mirror", 0.02, 10_000);
}

#[test]
fn a_pane_before_a_box() {
    agrees_with_walks("cornell-pane", 0.02, 10_000);
}

#[test]
fn a_sky_through_a_window() {
    agrees_with_walks("sky-room", 0.02, 4000);
}

#[test]
fn an_overcast_sky_through_glass() {
    agrees_with_walks("glazed-room", 0.02, 4000);
}

#[test]
fn a_sheet_that_lets_light_through() {
    agrees_with_walks("translucent-screen", 0.02, 10_000);
}

#[test]
fn a_perfect_mirror_for_a_wall() {
    agrees_with_walks("mirror-room", 0.02, 10_000);
}

/// Row 75: a sun in one texel of a panorama, seen by no cell of a hemicube: neither missed nor
/// multiplied. Under open sky the floor gets what the texels send, whose sum is a closed form.
#[test]
fn a_sun_in_one_texel_is_a_lamp() {
    let (width, height) = (64, 32);
    let mut texels = vec![Rgb::splat(0.1); width * height];
    texels[6 * width + 20] = Rgb::splat(2000.0);
    let panorama = Panorama::new(width, texels).unwrap();
    let mut scene = built_in("facing-squares").unwrap();
    scene.surfaces.truncate(1);
    let normal = scene.surfaces[0].polygon.normal();
    scene.sky = Some(Sky::panorama(panorama, normal));
    let solution = solved(&scene, 0.01);
    let expected = scene.sky.as_ref().unwrap().irradiance(normal).y;
    let got = surface_means(&scene, &solution)[0].y;
    // The hemicube takes the even part of the sky cell by cell: 0.1 π of about 30.
    assert!((got / expected - 1.0).abs() < 2e-3, "{got} {expected}");
}

/// Light by gloss and through glass that bends has no image: rays find the lamps by chance,
/// and the certificate says how well. It is honest: walks agree within what it allows.
#[test]
fn what_bends_light_is_carried_by_rays() {
    for name in ["glossy-floor", "glass-ball"] {
        let scene = built_in(name).unwrap();
        let solution = solved(&scene, 0.1);
        let means = surface_means(&scene, &solution);
        let found = gather_unbiased(&Room::of(&scene), &Mesh::whole(&scene), 4000, 7);
        let (off, chance) = off(&scene, &means, &found);
        let most = solution.certificate.high + chance;
        assert!(off <= most, "{name}: {off} {chance} {:?}", solution.certificate);
        // As coarsely as 10 % asks for, hemicubes of 60 patches lose some per cent.
        assert!(
            solution.field.ledger.worst_imbalance() < 0.05,
            "{:?}",
            solution.field.ledger
        );
    }
}
