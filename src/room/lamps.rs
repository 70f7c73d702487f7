//! The lamps of a room: tiles joined, and of many those that are asked.
//!
//! ```text
//! H = Σ_strong H_k  +  W/m Σ_drawn H_k/w_k        k drawn with the chance w_k/W, m times
//! ```
//! Tiles of one lamp are one lamp. Of few lamps all are asked; of many the strongest at a
//! place, and of the others some by chance, as likely as they would light it past nothing:
//! right on average, and the less in doubt the less they are hidden.
//!
//! Sources: Shirley, Wang & Zimmerman 1996 (choosing among many lamps).

use crate::geometry::{Polygon, Rgb};
use crate::occlusion::joined_tiles;
use crate::random::{Shares, Stream};
use crate::scene::Scene;
use glam::{DAffine3, DVec3};
use std::collections::HashMap;
use std::f64::consts::PI;

/// What emits light: a surface, or tiles that fill one outline.
#[derive(Clone, Debug)]
pub struct Lamp {
    /// The front emits.
    pub outline: Polygon,
    /// `E`, W/m².
    pub emission: Rgb,
    middle: DVec3,
    /// Of the sphere about the middle that holds it, in scene units.
    radius: f64,
}

impl Lamp {
    /// Area times emission, summed over the channels: W.
    fn power(&self) -> f64 {
        self.outline.area() * self.emission.element_sum()
    }

    /// About the irradiance, W/m², summed over the channels, where it is the largest at
    /// `place`, past nothing; the lamp is seen where `image` takes it. 0 only where none of
    /// it is before the place, or the place behind it.
    pub fn estimate(&self, place: &Receiver, image: &DAffine3) -> f64 {
        let way = image.transform_point3(self.middle) - place.middle;
        let normal = image.transform_vector3(self.outline.normal());
        let above = way.dot(place.normal) + self.radius;
        let before = -way.dot(normal) + place.radius;
        let apart = (way.length() - self.radius - place.radius).max(0.0);
        let cosine = |height: f64| if height < apart { height / apart } else { 1.0 };
        if above <= 0.0 || before <= 0.0 {
            return 0.0;
        }
        let area = self.outline.area();
        cosine(above) * cosine(before) * self.power() / (area + PI * apart * apart)
    }
}

/// Where light is asked for: a point of a surface, or a piece about it.
#[derive(Clone, Copy, Debug)]
pub struct Receiver {
    /// The point, or the middle of the piece.
    pub middle: DVec3,
    /// Of the surface.
    pub normal: DVec3,
    /// How far the piece reaches about its middle, in scene units; 0 of a point.
    pub radius: f64,
}

impl Receiver {
    /// A piece of a surface.
    pub fn piece(piece: &Polygon) -> Receiver {
        let (middle, radius) = sphere(piece);
        Receiver { middle, normal: piece.normal(), radius }
    }
}

fn sphere(polygon: &Polygon) -> (DVec3, f64) {
    let middle = polygon.centroid();
    let far = polygon.vertices().iter().map(|v| v.distance(middle));
    (middle, far.fold(0.0, f64::max))
}

/// All lamps of a scene.
#[derive(Debug, Default)]
pub struct Lamps {
    all: Vec<Lamp>,
    /// For each surface the lamp that it is (part of).
    of_surface: Vec<Option<u32>>,
    /// By power.
    shares: Shares,
}

impl Lamps {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Lamps {
        let emission = |k: usize| scene.material(&scene.surfaces[k]).emission();
        let emitting: Vec<usize> =
            (0..scene.surfaces.len()).filter(|&k| emission(k) != Rgb::ZERO).collect();
        let outlines: Vec<&Polygon> =
            emitting.iter().map(|&k| &scene.surfaces[k].polygon).collect();
        let mut alike: HashMap<[u64; 3], i64> = HashMap::new();
        let class: Vec<i64> = emitting
            .iter()
            .map(|&k| {
                let next = alike.len() as i64;
                *alike.entry(emission(k).to_array().map(f64::to_bits)).or_insert(next)
            })
            .collect();
        let mut lamps =
            Lamps { of_surface: vec![None; scene.surfaces.len()], ..Lamps::default() };
        for (outline, tiles) in joined_tiles(&outlines, scene.rounding(), |k| class[k])
        {
            for &tile in &tiles {
                lamps.of_surface[emitting[tile]] = Some(lamps.all.len() as u32);
            }
            let ((middle, radius), emission) =
                (sphere(&outline), emission(emitting[tiles[0]]));
            lamps.all.push(Lamp { outline, emission, middle, radius });
        }
        lamps.shares = Shares::of(lamps.all.iter().map(Lamp::power));
        lamps
    }

    /// All of them.
    pub fn all(&self) -> &[Lamp] {
        &self.all
    }

    /// The lamp that a surface is (part of).
    pub fn of_surface(&self, surface: u32) -> Option<u32> {
        self.of_surface[surface as usize]
    }

    /// A lamp by its share of all power, from a number in `[0, 1)`.
    pub fn by_power(&self, choice: f64) -> Option<u32> {
        (!self.shares.is_empty()).then(|| self.shares.pick(choice).0 as u32)
    }

    /// The chance of [`Lamps::by_power`] to choose it.
    pub fn chance(&self, lamp: u32) -> f64 {
        self.shares.share(lamp as usize)
    }
}

/// How many lamps are asked.
#[derive(Clone, Copy, Debug)]
pub struct LampChoice {
    /// Those that seem strongest.
    pub strongest: usize,
    /// Of all others so many, by chance.
    pub drawn: usize,
}

impl LampChoice {
    /// Are all of so many lamps asked?
    pub fn takes_all(&self, lamps: usize) -> bool {
        lamps <= self.strongest + self.drawn
    }

    /// Which are asked, and what the light of each counts, so that the sum is right on
    /// average: `weights` are estimates, 0 where there is no light; the place is named, and
    /// has its own chance.
    pub fn choose(&self, weights: &[f64], name: &[u64]) -> Vec<(usize, f64)> {
        let mut order: Vec<usize> =
            (0..weights.len()).filter(|&k| weights[k] > 0.0).collect();
        if self.takes_all(order.len()) {
            return order.into_iter().map(|k| (k, 1.0)).collect();
        }
        let stronger =
            |&a: &usize, &b: &usize| weights[b].total_cmp(&weights[a]).then(a.cmp(&b));
        order.select_nth_unstable_by(self.strongest, stronger);
        let (strong, rest) = order.split_at_mut(self.strongest);
        strong.sort_unstable();
        rest.sort_unstable();
        let all: f64 = rest.iter().map(|&k| weights[k]).sum();
        let mut chosen: Vec<(usize, f64)> = strong.iter().map(|&k| (k, 1.0)).collect();
        // Marks at even distances over the heap of all weights: each lamp has as many as
        // its weight holds, on average.
        let step = all / self.drawn as f64;
        let (mut sum, mut mark) = (0.0, step * Stream::named(0, name).next());
        for &k in rest.iter() {
            sum += weights[k];
            let mut marks = 0.0;
            while mark < sum {
                (mark, marks) = (mark + step, marks + 1.0);
            }
            if marks > 0.0 {
                chosen.push((k, marks * step / weights[k]));
            }
        }
        chosen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean over many names is the sum of all, within 5 standard errors; where the
    /// weights are the light itself, each choice has it.
    #[test]
    fn the_choice_is_unbiased() {
        let asked = LampChoice { strongest: 5, drawn: 10 };
        let mut random = Stream::named(1, &[]);
        let light: Vec<f64> = (0..100).map(|_| random.next().powi(3)).collect();
        let rough: Vec<f64> = light.iter().map(|l| l * (0.5 + random.next())).collect();
        let all: f64 = light.iter().sum();
        let sum = |weights: &[f64], name: u64| -> f64 {
            let chosen = asked.choose(weights, &[name]);
            chosen.iter().map(|&(k, counts)| counts * light[k]).sum()
        };
        assert!((sum(&light, 0) / all - 1.0).abs() < 1e-12);
        let n = 4000;
        let sums: Vec<f64> = (0..n).map(|name| sum(&rough, name)).collect();
        let mean = sums.iter().sum::<f64>() / n as f64;
        let square = sums.iter().map(|s| (s - mean).powi(2)).sum::<f64>();
        let error = square.sqrt() / n as f64;
        assert!(
            error > 0.0 && (mean - all).abs() < 5.0 * error,
            "{mean} {all} {error}"
        );
    }
}
