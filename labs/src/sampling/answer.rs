//! One right answer.
#![deny(warnings)]

use super::Work;
use super::given::{Estimate, Pair, Seen};
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// Task 1: the values scatter by s, their mean by s/√n.
pub fn estimate(values: &[f64]) -> Estimate {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    Estimate { mean, error: (squares / (n - 1.0) / n).sqrt() }
}

/// Task 2: a point of the disc, even in area, raised to the hemisphere (Malley 1988).
pub fn direction(u: f64, v: f64) -> DVec3 {
    let (radius, turn) = (u.sqrt(), TAU * v);
    dvec3(radius * turn.cos(), radius * turn.sin(), (1.0 - u).sqrt())
}

/// Task 3: each ray carries the same share of the light.
pub fn by_rays(pair: &Pair, samples: usize, stream: &mut Stream) -> Estimate {
    let frame = Frame::about(pair.from.normal());
    let mut ray = || {
        let origin = pair.from.point_at([stream.next(), stream.next()]);
        let way = frame.world_from_local(direction(stream.next(), stream.next()));
        if pair.first(origin, way) == Seen::Target { 1.0 } else { 0.0 }
    };
    estimate(&(0..samples).map(|_| ray()).collect::<Vec<_>>())
}

/// Task 4: the integrand at random points, times the area that y stands for.
pub fn by_points(pair: &Pair, samples: usize, stream: &mut Stream) -> Estimate {
    let (from, to) = (&pair.from, &pair.to);
    let mut sample = || {
        let x = from.point_at([stream.next(), stream.next()]);
        let y = to.point_at([stream.next(), stream.next()]);
        let (way, r2) = ((y - x).normalize(), x.distance_squared(y));
        let (here, there) = (from.normal().dot(way), -to.normal().dot(way));
        let seen = here > 0.0 && there > 0.0 && pair.sees(x, y);
        if seen { here * there * to.area() / (PI * r2) } else { 0.0 }
    };
    estimate(&(0..samples).map(|_| sample()).collect::<Vec<_>>())
}

/// What is handed in.
pub const WORK: Work = Work { estimate, direction, by_rays, by_points };
