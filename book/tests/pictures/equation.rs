//! The pictures of *The radiosity equation* and *The pipeline*, as snapshots.

use crate::picture::assert_picture;
use book::equation::system::{ALL, cornell};
use book::equation::{bounces, cost, elements, matrix, wrong};
use book::pipeline::{spoilt, stages};

const PICTURES: &str = "src/pictures";

/// The terms of the Neumann series make the solution; each has less power than the
/// last.
#[test]
fn light_comes_bounce_by_bounce() {
    let room = cornell();
    let powers: Vec<f64> = (0..=ALL).map(|k| room.power(&room.alone(k))).collect();
    assert!(powers.windows(2).all(|pair| pair[1] < 0.8 * pair[0]), "{powers:?}");
    let all = room.power(&room.after(ALL));
    assert!((powers.iter().sum::<f64>() / all - 1.0).abs() < 1e-12);
    for k in bounces::SHOWN {
        let alone = bounces::alone_picture(k);
        if k > 0 {
            assert_picture(PICTURES, &format!("equation-alone-{k}"), &alone);
        }
    }
    for k in 0..=bounces::SUMS {
        let picture = bounces::sum_picture(k);
        assert_picture(PICTURES, &format!("equation-sum-{k}"), &picture);
    }
    assert_picture(PICTURES, "equation-sum-all", &bounces::sum_picture(ALL));
}

/// The page shows each picture that its caption counts, and no other.
#[test]
fn the_caption_counts_the_pictures() {
    let page = include_str!("../../src/radiosity-equation.md");
    let shown = page.matches("pictures/equation-sum-").count();
    assert_eq!(shown, bounces::SUMS as usize + 2, "0 to {}, and all", bounces::SUMS);
    assert!(
        bounces::caption().contains("at most 0, 1, 2, 3 and 4 bounces, and after 60")
    );
}

/// Who sees whom is mutual; and by all ways everybody lights everybody.
#[test]
fn the_matrix_shows_who_sees_whom() {
    let (direct, all) = (matrix::factors(), matrix::by_all_ways());
    let n = direct.len();
    for k in 0..n * n {
        let (i, j) = (k / n, k % n);
        assert_eq!(direct[i][j] > 0.0, direct[j][i] > 0.0, "{i} {j}");
        assert!(all[i][j] >= direct[i][j]);
    }
    // All but the floor under the blocks, which sees nothing and is seen by nothing.
    let sees = direct.iter().filter(|row| row.iter().any(|f| *f > 0.0)).count();
    assert!(n - sees < n / 10);
    assert_eq!(matrix::filled(&all), (sees * sees) as f64 / (n * n) as f64);
    assert_picture(PICTURES, "equation-matrix", &matrix::picture(&direct));
    assert_picture(PICTURES, "equation-matrix-all", &matrix::picture(&all));
}

/// With a slip in the indices there still is light; but watts do not add up.
/// (What escapes is counted by rays, 2048 an element: that is good to 0.5 %.)
#[test]
fn slips_in_the_indices_break_the_ledger() {
    for (slip, range) in [
        (wrong::Slip::None, 0.995..1.005),
        (wrong::Slip::Sender, 1.1..1.25),
        (wrong::Slip::Transposed, 1.05..1.2),
    ] {
        let sum: f64 = wrong::shares(slip).iter().sum();
        assert!(range.contains(&sum), "{slip:?}: {sum}");
        let name = format!("equation-wrong-{}", slip.file());
        assert_picture(PICTURES, &name, &wrong::picture(slip));
    }
}

/// Each bounce multiplies the error by ρ, nearly, once the light is spread.
#[test]
fn a_bounce_multiplies_the_error_by_the_reflectance() {
    for rho in cost::REFLECTANCES {
        let errors = cost::errors(rho);
        let [.., (before, larger), (bounces, smaller)] = errors[..] else {
            panic!("too few bounces: {errors:?}")
        };
        let rate = (smaller / larger).powf(1.0 / f64::from(bounces - before));
        assert!((0.98..1.000_001).contains(&(rate / rho)), "{rho}: {rate}");
    }
}

/// The means of the published meshes (`C9-cube-top-rho0.5`), and second order.
#[test]
fn coarse_elements_err_though_their_equation_is_exact() {
    let published =
        [(2, 0.173_639_114_749), (4, 0.171_829_422_310), (8, 0.171_373_223_5)];
    for (cuts, mean) in published {
        let got = elements::opposite(cuts);
        assert!((got - mean).abs() < 1e-8, "{cuts}: {got}");
    }
    let off = elements::opposite(1) / elements::TRUTH - 1.0;
    assert!((0.061..0.062).contains(&off), "{off}");
}

/// What each stage hands on, and one solution seen by three eyes.
#[test]
fn the_stages_hand_on_pictures() {
    assert_picture(PICTURES, "pipeline-elements", &stages::elements());
    assert_picture(PICTURES, "pipeline-factors", &stages::factors());
    assert_picture(PICTURES, "pipeline-flat", &stages::flat());
    for eye in 0..stages::eyes().len() {
        let name = format!("pipeline-smooth-{eye}");
        assert_picture(PICTURES, &name, &stages::smooth(eye));
    }
}

/// A stage that is spoilt shows in the picture, however good the others are.
#[test]
fn no_later_stage_repairs_an_earlier_one() {
    use spoilt::Stage;
    for (stage, range) in [
        (Stage::None, 0.0..1e-12),
        (Stage::Split, 0.05..0.3),
        (Stage::Factors, 0.05..0.5),
        (Stage::Solve, 0.1..0.3),
    ] {
        let error = spoilt::error(stage);
        assert!(range.contains(&error), "{stage:?}: {error}");
        let name = format!("pipeline-spoilt-{}", stage.file());
        assert_picture(PICTURES, &name, &spoilt::picture(stage));
    }
}
