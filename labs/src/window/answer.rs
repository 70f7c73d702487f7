//! One right answer: Fresnel's law, polarisations apart until the end.
#![deny(warnings)]

use super::Work;
use super::given::{Lamp, crossing, lambert, plane};
use radiosity::prelude::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};

/// Task 1: Snell's law gives the cosine inside.
pub fn fresnel(cosine: f64, index: f64) -> [f64; 2] {
    let sine_inside = (1.0 - cosine * cosine).sqrt() / index;
    let inside = (1.0 - sine_inside * sine_inside).sqrt();
    let share = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
    [share(cosine, index * inside), share(index * cosine, inside)]
}

/// Task 2: (1 − R)² (1 + R² + R⁴ + …) = (1 − R)/(1 + R).
pub fn pane(cosine: f64, index: f64) -> f64 {
    let [s, p] = fresnel(cosine, index).map(|r| (1.0 - r) / (1.0 + r));
    (s + p) / 2.0
}

/// Task 3: T cosθ over a ring of the width dθ, 2π sinθ dθ; of all cosines together, π.
pub fn mean(index: f64, rings: usize) -> f64 {
    let width = FRAC_PI_2 / rings as f64;
    let ring = |k: usize| {
        let (sine, cosine) = ((k as f64 + 0.5) * width).sin_cos();
        2.0 * pane(cosine, index) * cosine * sine * width
    };
    (0..rings).map(ring).sum()
}

/// Task 4: three cosines: at the point, at the lamp, and at the pane.
pub fn clear(p: DVec3, n: DVec3, window: &[DVec3], index: f64, lamp: Lamp) -> f64 {
    if crossing(p, lamp.at, window).is_none() {
        return 0.0;
    }
    let r = lamp.at - p;
    let d = r.normalize();
    let (at_point, at_lamp) = (n.dot(d).max(0.0), (-lamp.normal.dot(d)).max(0.0));
    let passed = pane(plane(window).normal.dot(d).abs(), index);
    passed * at_point * at_lamp * lamp.area / (PI * r.length_squared())
}

/// Task 5: both faces do both.
pub fn sheet([front, back]: [f64; 2], rho: f64, tau: f64) -> [f64; 2] {
    [rho * front + tau * back, rho * back + tau * front]
}

/// Task 6: the sheet is a lamp of the radiosity τ H.
pub fn frosted(p: DVec3, n: DVec3, window: &[DVec3], outside: f64, tau: f64) -> f64 {
    let [inside, _] = sheet([0.0, outside], 0.0, tau);
    inside * lambert(p, n, window)
}

/// What is handed in.
pub const WORK: Work = Work { fresnel, pane, mean, clear, sheet, frosted };
