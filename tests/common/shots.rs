//! How many shots it takes.

use radiosity::form_factor::Matrix;
use radiosity::solve::{Brightest, Enclosure, Overshoot, Shoot, Solver};

/// Steps until the solver's bound is 1e-4, of shooting and of overshooting.
pub fn steps(enclosure: &Enclosure, matrix: &Matrix) -> [usize; 2] {
    fn steps(mut solver: impl Solver, rho: f64) -> usize {
        let outcome = solver.run(rho, 1e-4, 100_000);
        assert!(outcome.converged, "{outcome:?}");
        outcome.steps
    }
    let rho = enclosure.largest_reflectance().max_element();
    let shoot = Shoot::new(enclosure, matrix, Brightest::ByPower);
    [steps(shoot, rho), steps(Overshoot::new(enclosure, matrix), rho)]
}
