//! What the student is given: a pair whose kernel counts how often it is asked, and
//! Gauss's rules.

use crate::sampling::given::Pair as Surfaces;
use radiosity::chart::suites::form_factors;
use radiosity::prelude::{DVec3, Polygon};
use std::cell::Cell;
use std::f64::consts::PI;

/// Two parallelograms, and what stands between them.
pub struct Pair {
    surfaces: Surfaces,
    asked: Cell<u32>,
    outside: Cell<bool>,
}

impl Pair {
    /// Two polygons of four corners, opposite edges parallel.
    pub fn new(from: Polygon, to: Polygon, blockers: Vec<Polygon>) -> Pair {
        let surfaces = Surfaces { from, to, blockers };
        Pair { surfaces, asked: Cell::new(0), outside: Cell::new(false) }
    }

    /// A pair of the crate's contest, and the screen between, if there is one.
    pub fn of(pair: &form_factors::Pair) -> Pair {
        let others = pair.scene().fronts().skip(2);
        let blockers = others.map(|surface| surface.polygon.clone()).collect();
        Pair::new(pair.from(), pair.to(), blockers)
    }

    // ANCHOR: kernel
    /// V cosθ cosθ' A_to/(π r²) between the point at `u` of the one and the point at
    /// `v` of the other; all four numbers in [0, 1]. The form factor is its mean.
    pub fn kernel(&self, u: [f64; 2], v: [f64; 2]) -> f64 {
        self.count([u, v]);
        let Surfaces { from, to, .. } = &self.surfaces;
        let (x, y) = (at(from, u), at(to, v));
        let (way, r2) = (y - x, x.distance_squared(y));
        let here = from.normal().dot(way).max(0.0);
        let there = to.normal().dot(-way).max(0.0);
        let seen = if self.surfaces.sees(x, y) { 1.0 } else { 0.0 };
        seen * here * there * to.area() / (PI * r2 * r2)
    }
    // ANCHOR_END: kernel

    /// How often the kernel was evaluated.
    pub fn asked(&self) -> u32 {
        self.asked.get()
    }

    /// Was it ever asked for a place outside [0, 1]?
    pub fn was_left(&self) -> bool {
        self.outside.get()
    }

    /// The areas of both.
    pub fn areas(&self) -> [f64; 2] {
        [self.surfaces.from.area(), self.surfaces.to.area()]
    }

    fn count(&self, places: [[f64; 2]; 2]) {
        self.asked.set(self.asked.get().saturating_add(1));
        let inside = places.as_flattened().iter().all(|p| (0.0..=1.0).contains(p));
        self.outside.set(self.outside.get() || !inside);
    }
}

/// Along its first edge by `a`, along its last by `b`.
fn at(polygon: &Polygon, [a, b]: [f64; 2]) -> DVec3 {
    let corner = |k: usize| polygon.vertices()[k];
    corner(0) + a * (corner(1) - corner(0)) + b * (corner(3) - corner(0))
}

// ANCHOR: gauss
/// Places in [0, 1] and their weights, which sum to 1: `n` places integrate polynomials
/// up to degree 2n − 1 exactly (Gauss).
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    (0..n).map(|k| legendre(n, k)).collect()
}
// ANCHOR_END: gauss

/// The k-th zero of the n-th Legendre polynomial, by Newton's method, and its weight.
fn legendre(n: usize, k: usize) -> (f64, f64) {
    let n_ = n as f64;
    let mut x = (PI * (k as f64 + 0.75) / (n_ + 0.5)).cos();
    let mut slope = 1.0;
    // Each step doubles the digits; the first guess has two.
    for _ in 0..6 {
        let (mut p, mut before) = (1.0, 0.0);
        for m in 0..n {
            let m = m as f64;
            (p, before) = (((2.0 * m + 1.0) * x * p - m * before) / (m + 1.0), p);
        }
        slope = n_ * (x * p - before) / (x * x - 1.0);
        x -= p / slope;
    }
    (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
}
