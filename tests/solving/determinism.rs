//! The same bytes on one thread and on two: for every kind of factors, both solvers,
//! the certificate, and the picture.

use radiosity::room::Room;
use radiosity::solution::Goal;
use radiosity::work::Work;

use radiosity::field::Factors;
use radiosity::field::MatrixSolver;
use radiosity::field::{Classical, Links, Pass1, Smooth};
use radiosity::film::Shot;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::{Scene, built_in};
use radiosity::solution::{Solution, solve_from, solve_on};

/// Runs `work` in a pool of this many threads.
fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

fn bits(values: &[Rgb]) -> Vec<u64> {
    values.iter().flat_map(|v| v.to_array()).map(f64::to_bits).collect()
}

/// All numbers of a solution, and its picture.
fn everything(scene: &Scene, solution: &Solution) -> (Vec<u64>, Vec<u8>) {
    let ledger = solution.field.ledger;
    let sums = [ledger.absorbed, ledger.escaped, ledger.unshot, ledger.imbalance];
    let mut all = bits(&solution.radiosity);
    all.extend(bits(&solution.irradiance));
    all.extend(bits(&solution.vertex_radiosity));
    all.extend(bits(&sums));
    let certificate = solution.certificate;
    let numbers = [certificate.error, certificate.low, certificate.high];
    all.extend(numbers.map(f64::to_bits));
    all.push(solution.field.steps as u64);
    let shot = Shot { camera: scene.camera, width: 40, height: 40, samples: 2 };
    let picture = shot.smooth(&solution.field.mesh, &solution.vertex_radiosity);
    (all, picture.display(1.0).into_raw())
}

/// The certificate's rays make most of the work: two squares in the open need few.
#[test]
fn one_thread_and_two_give_the_same_bytes() {
    let (analytic, cast, cubes) =
        (Factors::Analytic, Factors::Sampling(64), Factors::Hemicube(32));
    for (name, edge, factors, solver) in [
        ("facing-squares", 0.3, analytic, MatrixSolver::Gather),
        ("facing-squares", 0.3, analytic, MatrixSolver::Shoot),
        ("facing-squares", 0.3, cast, MatrixSolver::Gather),
        ("facing-squares", 0.3, cast, MatrixSolver::Shoot),
        ("facing-squares", 0.3, cubes, MatrixSolver::Gather),
        ("facing-squares", 0.3, cubes, MatrixSolver::Shoot),
        ("cornell-regular", 2.0, analytic, MatrixSolver::Shoot),
        ("cornell-regular", 2.0, cubes, MatrixSolver::Gather),
    ] {
        let scene = built_in(name).unwrap();
        let method = Classical { solver, ..Classical::by(factors) };
        let run = || {
            let mesh = Mesh::uniform(&scene, edge);
            everything(
                &scene,
                &solve_on(
                    &Room::of(&scene),
                    &method,
                    mesh,
                    &Goal::default(),
                    &Work::quiet(),
                )
                .unwrap(),
            )
        };
        assert!(
            on_threads(1, run) == on_threads(2, run),
            "{name} {factors:?} {solver:?}"
        );
    }
}

/// Refinement asks the certificate, which is sampled: it must choose the same meshes, by
/// each method, the one that is the command's own choice among them.
#[test]
fn refinement_takes_the_same_way() {
    let scene = built_in("facing-squares").unwrap();
    let methods: [&dyn Pass1; 3] = [&Classical::default(), &Smooth, &Links];
    for method in methods {
        let run = || {
            let room = Room::of(&scene);
            let coarse = method.first(&room, 0.5);
            let to = |tolerance: f64| {
                let goal = Goal { most_elements: 2000, ..Goal::within(tolerance) };
                solve_from(&room, method, coarse, &goal, &Work::quiet()).unwrap()
            };
            // Half of what the coarse one is surely off by: it cannot be enough.
            let found = to(0.5 * to(0.5).certificate.low);
            assert!(found.attempts.len() > 1, "nothing was refined");
            everything(&scene, &found)
        };
        assert!(on_threads(1, run) == on_threads(2, run));
    }
}

/// A seed names the random numbers: another one gives others, the same one the same.
#[test]
fn a_seed_names_the_run() {
    let scene = built_in("facing-squares").unwrap();
    let run = |seed| {
        let factors = Factors::Sampling(64);
        let (method, goal) = (Classical::by(factors), Goal { seed, ..Goal::default() });
        let mesh = Mesh::uniform(&scene, 0.3);
        bits(
            &solve_on(&Room::of(&scene), &method, mesh, &goal, &Work::quiet())
                .unwrap()
                .radiosity,
        )
    };
    assert!(run(1) == run(1) && run(1) != run(2));
}
