//! What the student is given: two surfaces, and what stands between.

use radiosity::prelude::{DVec3, Polygon};

// ANCHOR: pair
/// Two surfaces and what stands between. They send and receive on their front.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Where light leaves.
    pub from: Polygon,
    /// Where it may arrive.
    pub to: Polygon,
    /// What blocks light, from either side.
    pub blockers: Vec<Polygon>,
}
// ANCHOR_END: pair

// ANCHOR: seen
/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// The front of the surface `to`.
    Target,
    /// A blocker, or a back.
    Other,
    /// Nothing.
    Nothing,
}
// ANCHOR_END: seen

// ANCHOR: estimate
/// A number that was found by sampling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The mean of the samples.
    pub mean: f64,
    /// Its standard error: two of three lie within it, 19 of 20 within twice it.
    pub error: f64,
}
// ANCHOR_END: estimate

impl Pair {
    // ANCHOR: sees
    /// Is there nothing between these two points?
    pub fn sees(&self, x: DVec3, y: DVec3) -> bool {
        let blocks =
            |b: &Polygon| meets(b, x, y - x).is_some_and(|t| t > 0.0 && t < 1.0);
        !self.blockers.iter().any(blocks)
    }
    // ANCHOR_END: sees

    // ANCHOR: first
    /// What the ray from `origin` along `direction` meets first.
    pub fn first(&self, origin: DVec3, direction: DVec3) -> Seen {
        let ahead = |p: &Polygon| meets(p, origin, direction).filter(|&t| t > 0.0);
        let nearest = self.blockers.iter().filter_map(ahead).reduce(f64::min);
        match (ahead(&self.to), nearest) {
            (None, None) => Seen::Nothing,
            (Some(target), other) if other.is_none_or(|other| target < other) => {
                let front = self.to.normal().dot(direction) < 0.0;
                if front { Seen::Target } else { Seen::Other }
            }
            _ => Seen::Other,
        }
    }
    // ANCHOR_END: first
}

/// Where the line `origin + t direction` meets a polygon.
fn meets(polygon: &Polygon, origin: DVec3, direction: DVec3) -> Option<f64> {
    let plane = polygon.plane();
    let t = -plane.height(origin) / plane.normal.dot(direction);
    (t.is_finite() && polygon.contains(origin + t * direction, 0.0)).then_some(t)
}
