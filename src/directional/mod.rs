//! Specular radiosity: the radiosity equation with directions, and so with gloss.
//!
//! ```text
//! L_ib = E_i/π + Σ_a S_ba Σ_jc T_ia,jc L_jc            radiance, W/(m² sr)
//! T_ia,jc  of the beam (i, a), the share that meets patch j, in its bin c       0 … 1
//! S_ba     = π/m · mean of f over the bins a and b,    Σ_b S_ba = albedo of a  ≤ 1
//! A_i T_ia,jc = A_j T_jc,ia     (reciprocity)          Σ_jc T_ia,jc = 1  (closed)
//! ```
//!
//! The hemisphere above each patch is cut into `m` bins of equal projected solid angle
//! `π/m`; light of one radiance fills a **beam**: one patch, one bin. The equation is as
//! linear as before. What is lost is the one unknown for each patch: there are `n m`, and
//! each beam meets others of its own. With Lambert's BRDF everywhere, or one bin, it is
//! plain radiosity.
//!
//! | part          | use it when                           | it fails when             |
//! |---------------|---------------------------------------|---------------------------|
//! | [`Bins`]      | directions are to be counted          | a highlight is smaller    |
//! | [`Transport`] | all beams between few patches are due | memory ends: `n² m` pairs |
//! | [`Scatter`]   | a BRDF is met in bins                 | memory ends: `m²` a paint |
//! | [`Directional`] | a small glossy scene, for all eyes  | the same                  |
//!
//! ```
//! use radiosity::directional::Bins;
//! use radiosity::glam::{DVec3, dvec2};
//! let bins = Bins::new(4);
//! assert_eq!(bins.len(), 16);
//! let direction = bins.direction(5, dvec2(0.5, 0.5));
//! assert_eq!(bins.bin_of(direction), Some(5));
//! assert_eq!(bins.bin_of(-DVec3::Z), None); // nobody looks down into the wall
//! ```
//!
//! **Not here:** mirrors, panes and glass, which have no BRDF; translucence; cameras. This is a demonstration:
//! rays and a second pass carry gloss for less. Chapter *Why not specular radiosity?* (L16).
//! Sources: Immel, Cohen & Greenberg 1986 (directions as unknowns); Sillion, Arvo, Westin
//! & Greenberg 1991 (spherical harmonics in place of bins); Sinkhorn & Knopp 1967.

mod bins;
mod scatter;
mod transport;

pub use bins::Bins;
pub use scatter::Scatter;
pub use transport::Transport;

use crate::geometry::Rgb;
use crate::mesh::{ElementId, Mesh};
use crate::scene::Scene;
use crate::solve::{Ledger, LostPower};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::{FRAC_1_PI, PI};

/// Directional radiosity, bounce by bounce.
///
/// An iterator without end: each step is one more bounce of all the light (Jacobi) and
/// yields the [`Ledger`]. What is unshot falls at least as the largest albedo to the
/// number of bounces.
#[derive(Debug)]
pub struct Directional<'a> {
    transport: &'a Transport,
    /// One for each material.
    scatter: Vec<Scatter>,
    /// Which of them, per patch.
    paint: Vec<u32>,
    /// `E_i/π`, per patch.
    emission: Vec<Rgb>,
    /// Per beam: what leaves, what then arrives, and what will leave next.
    radiance: Vec<Rgb>,
    incoming: Vec<Rgb>,
    next: Vec<Rgb>,
}

impl<'a> Directional<'a> {
    /// Starts with the lamps alone. The patches are the elements of `mesh`, the same as
    /// `transport` is of.
    pub fn new(
        scene: &Scene,
        mesh: &Mesh,
        transport: &'a Transport,
    ) -> Directional<'a> {
        assert_eq!(transport.patches(), mesh.elements.len(), "one row of beams each");
        let bins = transport.bins();
        let paint: Vec<u32> =
            mesh.elements.iter().map(|e| mesh.patch_of(e).material.0).collect();
        let emission =
            |&paint: &u32| FRAC_1_PI * scene.materials[paint as usize].emission();
        let emission: Vec<Rgb> = paint.iter().map(emission).collect();
        let radiance: Vec<Rgb> =
            emission.iter().flat_map(|&e| vec![e; bins.len()]).collect();
        let incoming = transport.incoming(&radiance);
        let scatter =
            scene.materials.iter().map(|m| Scatter::of(&m.brdf(), bins)).collect();
        let next = Vec::new();
        let mut start = Directional {
            transport,
            scatter,
            paint,
            emission,
            radiance,
            incoming,
            next,
        };
        start.next = start.lit();
        start
    }

    /// `L_ib`, W/(m² sr), of each beam: those of the first patch, of the second, …
    pub fn radiance(&self) -> &[Rgb] {
        &self.radiance
    }

    /// The radiance, W/(m² sr), that `patch` sends along a direction of unit length; 0
    /// where that leads behind it.
    pub fn towards(&self, patch: ElementId, direction: DVec3) -> Rgb {
        match self.transport.beam(patch.0, direction) {
            Some(beam) => self.radiance[beam as usize],
            None => Rgb::ZERO,
        }
    }

    /// `B_i`, W/m², of each patch: `π` times the mean radiance of its beams.
    pub fn radiosity(&self) -> Vec<Rgb> {
        let m = self.transport.bins().len();
        let mean = |beams: &[Rgb]| PI / m as f64 * beams.iter().sum::<Rgb>();
        self.radiance.chunks(m).map(mean).collect()
    }

    /// Bounces until less than `share` of the emitted power is unshot, in every channel.
    pub fn settle(&mut self, share: f64) -> Ledger {
        loop {
            let ledger = self.bounce();
            if ledger.unshot.abs().cmple(share * ledger.emitted).all() {
                return ledger;
            }
        }
    }

    // ANCHOR: bounce
    /// One more bounce of all the light.
    fn bounce(&mut self) -> Ledger {
        self.radiance = std::mem::take(&mut self.next);
        self.incoming = self.transport.incoming(&self.radiance);
        self.next = self.lit();
        self.draw_up()
    }
    // ANCHOR_END: bounce

    // ANCHOR: lit
    /// What leaves when this arrives: `E/π + S L_in`.
    fn lit(&self) -> Vec<Rgb> {
        let m = self.transport.bins().len();
        let patch = |(i, incoming): (usize, &[Rgb])| {
            let scatter = &self.scatter[self.paint[i] as usize];
            scatter
                .scattered(incoming)
                .map(|l| self.emission[i] + l)
                .collect::<Vec<_>>()
        };
        self.incoming.par_chunks(m).enumerate().flat_map_iter(patch).collect()
    }
    // ANCHOR_END: lit

    /// Every beam carries `A_i π/m` times its radiance.
    fn draw_up(&self) -> Ledger {
        let m = self.transport.bins().len();
        let (mut emitted, mut absorbed, mut unshot) = (Rgb::ZERO, Rgb::ZERO, Rgb::ZERO);
        let mut lost = LostPower::default();
        for (beam, &next) in self.next.iter().enumerate() {
            let (i, bin) = (beam / m, beam % m);
            let etendue = self.transport.area(i) * PI / m as f64;
            let albedo = self.scatter[self.paint[i] as usize].albedo(bin);
            emitted += etendue * self.emission[i];
            absorbed += etendue * (Rgb::ONE - albedo) * self.incoming[beam];
            unshot += etendue * (next - self.radiance[beam]);
            lost.add(etendue * self.radiance[beam], self.transport.lost(beam));
        }
        absorbed += lost.absorbed;
        let imbalance = emitted - absorbed - lost.escaped - unshot;
        Ledger { emitted, absorbed, escaped: lost.escaped, unshot, imbalance }
    }
}

impl Iterator for Directional<'_> {
    type Item = Ledger;

    fn next(&mut self) -> Option<Ledger> {
        Some(self.bounce())
    }
}
