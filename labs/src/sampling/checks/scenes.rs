//! Pairs with known form factors.

use crate::draw::uniform;
use crate::sampling::given::Pair;
use crate::shapes::{Place, rectangle};
use radiosity::form_factor::analytic::exchange;
use radiosity::prelude::{DVec3, Polygon, dvec3};
use radiosity::random::Stream;

/// A pair, and its form factor.
pub struct Known {
    /// What it is.
    pub name: &'static str,
    /// The pair.
    pub pair: Pair,
    /// The factor from `from` to `to`.
    pub factor: f64,
}

fn moved(polygon: &Polygon, place: &Place) -> Polygon {
    // Turned and enlarged, a polygon is one still.
    Polygon::new(place.all(polygon.vertices())).expect("a polygon")
}

/// The pair turned, enlarged and moved: its factor stays.
fn turned(name: &'static str, pair: Pair, factor: f64, stream: &mut Stream) -> Known {
    let place = Place::draw(stream);
    let pair = Pair {
        from: moved(&pair.from, &place),
        to: moved(&pair.to, &place),
        blockers: pair.blockers.iter().map(|b| moved(b, &place)).collect(),
    };
    Known { name, pair, factor }
}

/// Pairs with nothing between, their factors by the library's contour integral: two
/// rectangles of unlike size, two that are far apart, and two of which one stands partly
/// below the other's horizon.
pub fn open(stream: &mut Stream) -> Vec<Known> {
    let floor = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let lid = rectangle(
        dvec3(uniform(stream, -0.4, 0.2), uniform(stream, -0.4, 0.2), 1.0),
        DVec3::Y * uniform(stream, 1.4, 1.8),
        DVec3::X * uniform(stream, 1.4, 1.8),
    );
    let far = rectangle(
        dvec3(0.0, 0.0, uniform(stream, 2.5, 3.0)),
        DVec3::Y * uniform(stream, 1.0, 1.2),
        DVec3::X * uniform(stream, 1.2, 1.4),
    );
    let wall = rectangle(
        dvec3(uniform(stream, 1.4, 1.6), 0.0, -0.5),
        DVec3::Z * uniform(stream, 1.5, 2.0),
        DVec3::Y,
    );
    let mut known = |name, to: Polygon| {
        let factor = exchange(&floor, &to, 1e-12) / floor.area();
        let pair = Pair { from: floor.clone(), to, blockers: vec![] };
        turned(name, pair, factor, stream)
    };
    vec![
        known("unlike rectangles", lid),
        known("rectangles far apart", far),
        known("a wall cut by the horizon", wall),
    ]
}

/// Unit squares 1 apart.
fn opposed(blockers: Vec<Polygon>) -> Pair {
    Pair {
        from: rectangle(DVec3::ZERO, DVec3::X, DVec3::Y),
        to: rectangle(DVec3::Z, DVec3::Y, DVec3::X),
        blockers,
    }
}

/// Unit squares 1 apart with a blocker half-way. It hides the pairs of points whose middle it
/// holds. So by symmetry ¾ of the factor is left of a blocker over a quarter; those over
/// strips are integrals of one dimension.
pub fn hidden(stream: &mut Stream) -> Vec<Known> {
    let mut known = |name, x: f64, y: f64, factor| {
        let blocker = rectangle(DVec3::Z * 0.5, DVec3::X * x, DVec3::Y * y);
        turned(name, opposed(vec![blocker]), factor, stream)
    };
    vec![
        known("a quarter blocked", 0.5, 0.5, 0.149_868_671_773_790),
        known("a strip of 1/4 blocked", 0.25, 1.0, 0.170_661_472_747_482),
        known("a strip of 3/4 blocked", 0.75, 1.0, 0.029_163_422_950_906),
    ]
}
