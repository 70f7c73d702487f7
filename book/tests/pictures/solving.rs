//! Pictures and claims of the chapter *Solving it*.

use crate::picture::assert_picture;
use book::solving::{stages, stall};

const PICTURES: &str = "src/pictures";

/// After the same work each is nearer than the one before.
#[test]
fn each_solver_is_ahead_of_the_last() {
    let errors = stages::SHOWN.map(|(name, _)| stages::error(name));
    assert!(errors[0] > 1.2 * errors[1] && errors[1] > 10.0 * errors[2], "{errors:?}");
    for (name, short) in stages::SHOWN {
        assert_picture(PICTURES, &format!("solving-{short}"), &stages::picture(name));
    }
    assert_picture(PICTURES, "solving-solved", &stages::solved());
}

/// Failure 55: without reciprocity conjugate gradients stall; repaired, they do not.
#[test]
fn gradients_stall_where_the_chapter_says() {
    let [rays, centres, repaired] = stall::residuals()
        .map(|(_, residuals)| residuals.into_iter().fold(f64::INFINITY, f64::min));
    assert!(rays > 1e-6 && centres < 1e-9 && repaired < 1e-12, "{rays} {centres}");
}
