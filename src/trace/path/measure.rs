//! Pictures and irradiances by many paths, each with its standard error.

use super::super::classes::{CLASSES, Class, Table};
use super::PathTracer;
use crate::film::{Picture, Shot};
use crate::geometry::{Ray, Rgb};
use crate::random::Stream;
use crate::raster::View;
use crate::scene::{FaceId, Side};
use crate::work::Progress;
use glam::{DVec3, dvec2};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A picture by paths.
#[derive(Clone, Debug)]
pub struct Traced {
    /// The mean radiance over each pixel, W/(m² sr).
    pub picture: Picture,
    /// The standard error of each pixel, in the order of [`Picture::pixels`].
    pub error: Vec<Rgb>,
    /// The standard error of the mean of the picture.
    pub mean_error: Rgb,
    /// The mean of the picture, by class.
    pub classes: Table,
}

/// A mean over samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// W/m².
    pub mean: Rgb,
    /// The standard error of the mean.
    pub error: Rgb,
    /// The same by class: of the light as the eye would see it on a diffuse surface.
    pub classes: Table,
}

/// Samples of light by class: sums, and sums of squares.
#[derive(Clone, Copy)]
struct PathSums {
    all: (Rgb, Rgb),
    classes: [(Rgb, Rgb); CLASSES],
}

impl PathSums {
    const NONE: PathSums = PathSums {
        all: (Rgb::ZERO, Rgb::ZERO),
        classes: [(Rgb::ZERO, Rgb::ZERO); CLASSES],
    };

    /// The sums of `count` samples; each calls the tally for what it finds.
    fn of(
        count: usize,
        mut sample: impl FnMut(usize, &mut dyn FnMut(Class, Rgb)),
    ) -> PathSums {
        let mut sums = PathSums::NONE;
        for k in 0..count {
            let mut found = [Rgb::ZERO; CLASSES];
            sample(k, &mut |class, light| found[class.index()] += light);
            let add = |sum: &mut (Rgb, Rgb), light: Rgb| {
                sum.0 += light;
                sum.1 += light * light;
            };
            add(&mut sums.all, found.iter().copied().sum());
            for (sum, &light) in sums.classes.iter_mut().zip(&found) {
                add(sum, light);
            }
        }
        sums
    }

    /// Means, and the squares of their standard errors.
    fn means(&self, count: usize) -> PathSums {
        let n = count as f64;
        let mean = |(sum, squares): (Rgb, Rgb)| {
            let mean = sum / n;
            let spread = (squares / n - mean * mean).max(Rgb::ZERO);
            (mean, spread / (n - 1.0).max(1.0))
        };
        PathSums { all: mean(self.all), classes: self.classes.map(mean) }
    }

    /// The sum of two that are independent.
    fn plus(mut self, other: &PathSums) -> PathSums {
        let add = |a: &mut (Rgb, Rgb), b: (Rgb, Rgb)| *a = (a.0 + b.0, a.1 + b.1);
        add(&mut self.all, other.all);
        for (a, &b) in self.classes.iter_mut().zip(&other.classes) {
            add(a, b);
        }
        self
    }

    /// The means by class of so many that were added.
    fn table(&self, count: usize) -> Table {
        let n = count as f64;
        Table {
            mean: self.classes.map(|(sum, _)| sum / n),
            error: self.classes.map(|(_, squares)| squares.map(f64::sqrt) / n),
            cut: Rgb::ZERO, // paths end by chance, and others count for them
        }
    }
}

impl PathTracer<'_> {
    /// The picture of a shot with so many samples (two at least) in each pixel, spread
    /// evenly over it; those of the shot itself count nothing.
    ///
    /// Deterministic: pixel by pixel the same at any number of threads, and whatever the
    /// rest of the picture.
    ///
    /// # Accuracy
    /// Unbiased. The standard errors are those of independent samples; at the edges of
    /// bright things the evenly spread ones do better.
    pub fn picture(
        &self,
        shot: &Shot,
        samples: usize,
        seed: u64,
        progress: Progress,
    ) -> Traced {
        let (width, height, samples) = (shot.width, shot.height, samples.max(2));
        let view = shot.view();
        // ANCHOR: pixel
        let pixel = |x: u32, y: u32| {
            let mut random = Stream::named(seed, &[x.into(), y.into()]);
            let centre = View::pixel_centre(x, y, width, height);
            let places: Vec<[f64; 2]> = random.points(samples).collect();
            let sample = |k: usize, tally: &mut dyn FnMut(Class, Rgb)| {
                let [u, v] = places[k].map(|u| 2.0 * u - 1.0);
                let at = centre + dvec2(u / width as f64, v / height as f64);
                let direction = view.direction(at).normalize();
                let ray = Ray { origin: view.eye(), direction };
                self.radiance_by_class(ray, &mut random, tally);
            };
            PathSums::of(samples, sample).means(samples)
        };
        // ANCHOR_END: pixel
        let done = AtomicUsize::new(0);
        let row = |y: u32| -> Vec<PathSums> {
            let row = (0..width).map(|x| pixel(x, y)).collect();
            let rows = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress("tracing paths", rows, height as usize);
            row
        };
        let rows: Vec<Vec<PathSums>> = (0..height).into_par_iter().map(row).collect();
        let pixels = || rows.iter().flatten();
        let sums = pixels().fold(PathSums::NONE, PathSums::plus);
        let count = width as usize * height as usize;
        Traced {
            picture: Picture {
                width,
                height,
                pixels: pixels().map(|p| p.all.0).collect(),
            },
            error: pixels().map(|p| p.all.1.map(f64::sqrt)).collect(),
            mean_error: sums.all.1.map(f64::sqrt) / count as f64,
            classes: sums.table(count),
        }
    }

    /// The irradiance, in W/m², at `x` on the front of a surface.
    ///
    /// # Accuracy
    /// Unbiased; the standard error is told, and falls as one over the root of the
    /// samples (two at least).
    pub fn irradiance(
        &self,
        surface: u32,
        x: DVec3,
        samples: usize,
        seed: u64,
    ) -> Estimate {
        self.estimate(&[(surface, 1.0)], samples, seed, |_, _| x)
    }

    /// The mean irradiance, in W/m², over the front of a face; 0 where others cover it.
    /// As [`PathTracer::irradiance`].
    pub fn face_irradiance(&self, face: FaceId, samples: usize, seed: u64) -> Estimate {
        let on_face = |&(_, s): &(u32, &crate::scene::Surface)| {
            s.face == face && s.side == Side::Front
        };
        let surfaces = (0u32..).zip(&self.scene.surfaces).filter(on_face);
        let areas: Vec<(u32, f64)> =
            surfaces.map(|(k, s)| (k, s.polygon.area())).collect();
        let point = |k: u32, random: &mut Stream| {
            let polygon = &self.scene.surfaces[k as usize].polygon;
            polygon.point_at([random.next(), random.next()])
        };
        self.estimate(&areas, samples, seed, point)
    }

    /// The mean over surfaces, each as likely as its weight, at points of them.
    fn estimate(
        &self,
        surfaces: &[(u32, f64)],
        samples: usize,
        seed: u64,
        point: impl Fn(u32, &mut Stream) -> DVec3 + Sync,
    ) -> Estimate {
        /// Samples of one stream.
        const LOT: usize = 256;
        let lots = if surfaces.is_empty() { 0 } else { samples.max(2).div_ceil(LOT) };
        let all: f64 = surfaces.iter().map(|s| s.1).sum();
        let pick = |random: &mut Stream| {
            let mut rest = all * random.next();
            let inside = |&&(_, weight): &&(u32, f64)| {
                rest -= weight;
                rest < 0.0
            };
            surfaces.iter().find(inside).or(surfaces.last()).map_or(0, |s| s.0)
        };
        let lot = |lot: usize| {
            let name = [surfaces[0].0.into(), lot as u64];
            let mut random = Stream::named(seed, &name);
            PathSums::of(LOT, |_, tally| {
                let surface = pick(&mut random);
                let x = point(surface, &mut random);
                self.irradiance_by_class((surface, x), &mut random, tally);
            })
        };
        let lots: Vec<PathSums> = (0..lots).into_par_iter().map(lot).collect();
        let count = (lots.len() * LOT).max(2);
        let means = lots.iter().fold(PathSums::NONE, PathSums::plus).means(count);
        let (mean, squared) = means.all;
        let classes = means.table(1);
        Estimate { mean, error: squared.map(f64::sqrt), classes }
    }
}
