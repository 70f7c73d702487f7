//! What stands between: the visible part of a lamp, and why its share is no factor.

use super::nusselt::{LAMP, VOID, counted, disc, meets};
use crate::map;
use glam::{DVec2, DVec3, dvec2};
use radiosity::film::RgbImage;
use radiosity::form_factor::analytic::{Analytic, exchange, lambert_polygon};
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::occlusion::{Blocker, lambert_visible};

/// A rectangle across z, its front up or down.
fn rectangle(low: DVec2, high: DVec2, z: f64, up: bool) -> Polygon {
    let [a, b] = [low, dvec2(high.x, low.y)].map(|p| p.extend(z));
    let [c, d] = [high, dvec2(low.x, high.y)].map(|p| p.extend(z));
    let corners = if up { vec![a, b, c, d] } else { vec![d, c, b, a] };
    Polygon::new(corners).expect("a rectangle is a polygon")
}

/// The lamp of the cut picture: a square of side 1.2, 1 overhead.
fn lamp() -> Polygon {
    map::square(1.2, DVec3::Z)
}

/// Two boards that cross, half way up.
fn boards() -> [Polygon; 2] {
    let board = |low, high| rectangle(low, high, 0.5, false);
    [
        board(dvec2(-0.9, -0.05), dvec2(0.9, 0.15)),
        board(dvec2(-0.2, -0.9), dvec2(-0.05, 0.9)),
    ]
}

/// What of the lamp is seen past the boards: bright; what is hidden: dark yellow.
pub fn cut_picture() -> RgbImage {
    let (lamp, boards) = (lamp(), boards());
    disc(|direction| {
        let hidden = boards.iter().any(|board| meets(board, direction));
        match (meets(&lamp, direction), hidden) {
            (true, false) => LAMP,
            (true, true) => [120, 100, 40],
            (false, true) => [110, 110, 110],
            (false, false) => VOID,
        }
    })
}

/// The factor to the visible part: counted, and by cutting.
pub fn cut() -> (f64, f64) {
    let (lamp, boards) = (lamp(), boards());
    let seen = |w| meets(&lamp, w) && !boards.iter().any(|board| meets(board, w));
    let blockers = boards.each_ref().map(Blocker::sheet);
    let exact = lambert_visible(DVec3::ZERO, DVec3::Z, &lamp, &blockers.each_ref()[..]);
    (counted(seen), exact)
}

/// The caption of the cut picture.
pub fn cut_caption() -> String {
    let (counted, exact) = cut();
    let all = lambert_polygon(DVec3::ZERO, DVec3::Z, &lamp());
    format!(
        "A lamp of 1.2 × 1.2 overhead, at height 1, behind two boards at height ½. All of \
         the lamp would have F = {all:.4}. What is left of it, in four parts, has \
         {exact:.4} in all; the pixels say {counted:.4}."
    )
}

/// The unit floor and the lamp above it, and a board that hides what has x below ¾.
pub struct Strip {
    floor: Polygon,
    lamp: Polygon,
    board: Polygon,
}

impl Default for Strip {
    fn default() -> Strip {
        let (low, high) = (DVec2::ZERO, DVec2::ONE);
        Strip {
            floor: rectangle(low, high, 0.0, true),
            lamp: rectangle(low, high, 1.0, false),
            board: rectangle(low, dvec2(0.75, 1.0), 0.5, false),
        }
    }
}

/// What one of the three maps shows.
#[derive(Clone, Copy, PartialEq)]
pub enum Show {
    /// The factor to the lamp with nothing between.
    Kernel,
    /// Which share of the lamp's area is seen.
    Share,
    /// The factor to what is seen.
    Factor,
}

impl Strip {
    /// One of the three numbers, at a place on the floor.
    fn at(&self, place: DVec2, show: Show) -> f64 {
        let p = place.extend(0.0);
        match show {
            Show::Kernel => lambert_polygon(p, DVec3::Z, &self.lamp),
            // The board's edge, seen from here, falls on the lamp at 2 · ¾ − x.
            Show::Share => (1.0 - (1.5 - place.x)).clamp(0.0, 1.0),
            Show::Factor => {
                let board = Blocker::sheet(&self.board);
                lambert_visible(p, DVec3::Z, &self.lamp, &[&board])
            }
        }
    }

    /// A map over the floor.
    pub fn picture(&self, show: Show) -> RgbImage {
        let values = map::over(DVec2::ZERO, DVec2::ONE, |p| self.at(p, show));
        let (low, high) = if show == Show::Share { SHARES } else { FACTORS };
        map::draw(&values, low, high)
    }

    /// Factor between floor and lamp with nothing between, and past the board.
    pub fn factors(&self) -> (f64, f64) {
        let open = exchange(&self.floor, &self.lamp, 1e-12) / self.floor.area();
        let scene = map::black([&self.floor, &self.lamp, &self.board]);
        let mesh = Mesh::whole(&scene);
        let method = Analytic::new(&scene, &mesh, 1e-7, 0);
        let past = method.exchange(ElementId(0), ElementId(1)) / self.floor.area();
        (open, past)
    }
}

/// The ranges of the colours: of factors, and of shares.
const FACTORS: (f64, f64) = (0.01, 0.3);
const SHARES: (f64, f64) = (0.01, 1.0);

/// The mean, over all pairs of points, of what is seen: `P(x + x' > 3/2)` of two numbers.
pub const MEAN_VISIBILITY: f64 = 0.125;

/// The caption of the three maps.
pub fn caption() -> String {
    let (open, past) = Strip::default().factors();
    let product = MEAN_VISIBILITY * open;
    format!(
        "Means: factor with nothing between {open:.6}, visibility {MEAN_VISIBILITY}, their \
         product {product:.6}; but the mean of the factor past the board is {past:.6}. **The \
         product is {:.0} % too small.**",
        100.0 * (1.0 - product / past)
    )
}

/// The keys to the maps.
pub fn key() -> String {
    let number = |v: f64| format!("{v:.2}");
    let of_factors = map::key(FACTORS.0, FACTORS.1, 4, number);
    let of_shares = map::key(SHARES.0, SHARES.1, 3, number);
    format!("left and right: {} middle: {}", of_factors.trim(), of_shares)
}
