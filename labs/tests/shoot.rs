//! The lab `shoot`: right answers that are not the answer, and the numbers that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::gather::given::Balance;
use labs::shoot::given::By;
use labs::shoot::report::{specks, unshot};
use labs::shoot::{Work, answer, checks};

#[test]
fn other_right_answers_pass() {
    let answer = answer::WORK;
    // By a loop, with the last of equal ones; the factor by reciprocity, F_ji.
    let by_columns = Work {
        brightest: |room, unshot, by| {
            let mut best = None;
            let mut most = 0.0;
            for (i, &u) in unshot.iter().enumerate() {
                let value = if by == By::Power { u * room.area[i] } else { u };
                if value > 0.0 && value >= most {
                    (best, most) = (Some(i), value);
                }
            }
            best
        },
        shoot: |room, light, i| {
            let sent = std::mem::take(&mut light.unshot[i]);
            for j in 0..room.area.len() {
                let arrives = room.factors[j][i] * sent;
                light.irradiance[j] += arrives;
                light.radiosity[j] += room.reflectance[j] * arrives;
                light.unshot[j] += room.reflectance[j] * arrives;
            }
        },
        ..answer::WORK
    };
    // The guess by its series, and what is absorbed by what is not reflected.
    let by_series = Work {
        shown: |room, light| {
            let area: f64 = room.area.iter().sum();
            let mean = |x: &[f64]| {
                x.iter().zip(&room.area).map(|(x, a)| x * a).sum::<f64>() / area
            };
            let (rho, mut bounce) = (mean(&room.reflectance), mean(&light.unshot));
            let mut ambient = 0.0;
            while bounce > 1e-18 {
                ambient += bounce;
                bounce *= rho;
            }
            let lit = light.radiosity.iter().zip(&room.reflectance);
            lit.map(|(b, rho)| b + rho * ambient).collect()
        },
        ledger: |room, light| {
            let power = |x: &dyn Fn(usize) -> f64| -> f64 {
                (0..room.area.len()).map(|i| room.area[i] * x(i)).sum()
            };
            let arrives = power(&|i| light.irradiance[i]);
            let reflected = power(&|i| room.reflectance[i] * light.irradiance[i]);
            Balance {
                emitted: power(&|i| room.emission[i]),
                absorbed: arrives - reflected,
                unshot: power(&|i| light.unshot[i]),
            }
        },
        ..answer::WORK
    };
    let works = [("answer", &answer), ("columns", &by_columns), ("series", &by_series)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work =
        Work { shown: |room, _| vec![f64::NAN; room.area.len()], ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    let names: Vec<&str> = failing.map(|(name, _)| name).collect();
    assert_eq!(names, ["shown"]);
}

/// The failure that the report asks for, pinned: by radiosity, fifty specks have the
/// first fifty shots, and a tenth of the light with them. Specks half as bright as the
/// lamp wait for it, but still come before any wall.
#[test]
fn bright_specks_go_first() {
    let after = |brighter: f64, by: By| {
        let left = unshot(&answer::WORK, &specks(50, brighter), by, 100);
        [left[0], left[49], left[99]]
    };
    let [first, fifty, hundred] = after(5.0, By::Power);
    assert!((0.54..0.55).contains(&first), "{first}: (1 + 0.1 − 0.5)/1.1");
    assert!(fifty < 0.1 && hundred < 0.04, "{fifty} {hundred}");
    let [first, fifty, hundred] = after(5.0, By::Radiosity);
    assert!(first > 0.99 && (0.94..0.97).contains(&fifty), "{first} {fifty}");
    assert!((0.2..0.3).contains(&hundred), "{hundred}");
    let [first, fifty, _] = after(0.5, By::Radiosity);
    assert!((0.54..0.55).contains(&first) && fifty > 0.45, "{first} {fifty}");
}
