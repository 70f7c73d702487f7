//! The one loop: who may enter it, what it keeps, and that no number of it is none.

use radiosity::field::{
    Cannot, Classical, Field, Fineness, Links, MatrixSolver, Pass1, Smooth,
};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::obj;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solution::{Goal, Solution, solve};
use radiosity::work::Work;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

fn data(name: &str) -> Scene {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/light");
    obj::load(folder.join(name)).expect(name).0
}

fn solved(scene: &Scene, method: &dyn Pass1, goal: &Goal) -> Result<Solution, Cannot> {
    solve(&Room::of(scene), method, goal, &Work::quiet())
}

/// At once, in one sentence that names the method, the surface and a method that can.
#[test]
fn what_a_method_does_not_know_it_refuses() {
    let gather = Classical { solver: MatrixSolver::Gather, ..Classical::default() };
    let shoot = Classical::default();
    let refused: [(&str, &dyn Pass1, &[&str]); 7] = [
        ("sky-room", &gather, &["gather", "sky"]),
        ("sky-room", &shoot, &["shoot", "sky"]),
        ("sky-room", &Links, &["hierarchy", "sky"]),
        ("mirror-room", &Links, &["hierarchy", "mirror", "face", "material"]),
        ("cornell-pane", &Links, &["hierarchy", "pane", "face", "material"]),
        ("translucent-screen", &Links, &["hierarchy", "diffusely", "face"]),
        ("glass-ball", &shoot, &["shoot", "solid glass", "face", "material"]),
    ];
    for (scene, method, words) in refused {
        let room = built_in(scene).unwrap();
        let said = solved(&room, method, &Goal::default()).unwrap_err().to_string();
        assert!(words.iter().all(|word| said.contains(word)), "{scene}: {said}");
        assert!(said.contains("--method auto") && !said.contains('\n'), "{said}");
        assert!(said.len() < 200, "{said}");
        assert_eq!(Smooth.knows(&Room::of(&room)), Ok(()));
    }
    for scene in ["cornell-mirror", "cornell-pane", "translucent-screen"] {
        assert_eq!(
            shoot.knows(&Room::of(&built_in(scene).unwrap())),
            Ok(()),
            "{scene}"
        );
    }
}

/// Gloss alone is left out with a word, and counted.
#[test]
fn gloss_is_dropped_with_a_count() {
    let scene = built_in("glossy-floor").unwrap();
    let dropped = Classical::default().drops(&Room::of(&scene)).unwrap();
    assert!(dropped.count > 0 && dropped.to_string().contains("gloss"), "{dropped}");
    assert_eq!(Smooth.drops(&Room::of(&scene)), None);
    let dull = built_in("cornell").unwrap();
    assert_eq!(Classical::default().drops(&Room::of(&dull)), None);
}

/// Where rounding moves corners by more than light could tell there is no answer: a
/// sentence, and no account of NaN. A wall that is as far off from a room at home spoils
/// nothing there.
#[test]
fn far_off_rooms_are_refused_and_far_walls_are_not() {
    let said = solved(&data("s12.obj"), &Smooth, &Goal::default()).unwrap_err();
    assert!(matches!(said, Cannot::FarOff { .. }), "{said}");
    assert!(said.to_string().contains("face 0"), "{said}");
    let found = solved(&data("mix.obj"), &Smooth, &Goal::within(0.3)).unwrap();
    assert!(found.field.ledger.is_finite());
}

/// A method whose attempts are scripted: the irradiance of a furnace with `B = 2`.
struct Scripted {
    irradiance: Vec<f64>,
    calls: AtomicUsize,
}

impl Scripted {
    fn new(irradiance: &[f64]) -> Scripted {
        let irradiance = irradiance.to_vec();
        Scripted { irradiance, calls: AtomicUsize::new(0) }
    }
}

impl Pass1 for Scripted {
    fn knows(&self, _: &Room) -> Result<(), Cannot> {
        Ok(())
    }

    fn first(&self, room: &Room, tolerance: f64) -> Fineness {
        Smooth.first(room, tolerance)
    }

    fn finer(&self, _: &Room, last: &Fineness, _: f64) -> Option<Fineness> {
        Some(*last)
    }

    fn field(&self, room: &Room, _: &Fineness, _: &Work) -> Field {
        let call = self.calls.fetch_add(1, Ordering::Relaxed);
        let h = self.irradiance[call.min(self.irradiance.len() - 1)];
        let mesh = Mesh::whole(room.scene);
        let same = vec![Rgb::splat(h); mesh.elements.len()];
        Field::constant(room.scene, mesh, same)
    }
}

/// A finer attempt may be worse: noise, a limit. What was better is kept.
#[test]
fn the_best_attempt_is_kept() {
    let furnace = built_in("furnace").unwrap();
    let goal = Goal::within(1e-4);
    // H is 2: of (1 − ρ)/ρ |H − 2| the error is off by 30, 10 and 50 %.
    let found = solved(&furnace, &Scripted::new(&[1.4, 1.8, 1.0]), &goal).unwrap();
    let highs: Vec<f64> = found.attempts.iter().map(|a| a.certificate.high).collect();
    let least = highs.iter().copied().fold(f64::INFINITY, f64::min);
    assert_eq!(found.attempts.len(), 3, "a loss ends it: {highs:?}");
    assert_eq!(found.certificate.high, least, "{highs:?}");
    assert_eq!(found.radiosity[0], Rgb::splat(1.9));
    assert!(!found.converged);
}

/// What is not a number is not small.
#[test]
fn nan_is_never_certified() {
    let furnace = built_in("furnace").unwrap();
    let found = solved(&furnace, &Scripted::new(&[f64::NAN]), &Goal::within(1e9));
    let found = found.unwrap();
    assert!(!found.converged && found.certificate.high.is_infinite());
}
