//! Extended form factors between areas: what two polygons exchange by all images.

use super::{Sight, VirtualWorld};
use crate::form_factor::analytic::exchange;
use crate::form_factor::points;
use crate::geometry::{Polygon, Rgb};

/// What two polygons exchange, in scene units squared, per channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exchange {
    /// By all images, the direct way among them: `A_i F_ij = A_j F_ji`.
    pub all: Rgb,
    /// By images of the last level only: what a further mirror would send on is cut.
    pub last: Rgb,
    /// About how far `all` may be off.
    pub error: f64,
}

/// A piece is quartered at most this often.
const DEEPEST: u32 = 12;

/// Points per direction on a piece.
const POINTS: usize = 4;

/// Where an image is seen whole, so much less of the tolerance costs little.
const SHARP: f64 = 1e-3;

/// Where Fresnel's law weighs what is seen, no more than this is asked for, relative.
const UNEVEN: f64 = 2e-4;

impl VirtualWorld {
    /// What the fronts of two polygons exchange by images of level `from` and above, to an
    /// absolute error of both factors near `tolerance`: sharp where an image is seen whole
    /// ([`exchange`]), else by points on the smaller polygon, more of them where what is
    /// seen changes.
    ///
    /// The same whichever is named first: chains of mirrors are taken in both directions.
    pub fn exchange(
        &self,
        i: &Polygon,
        j: &Polygon,
        from: u32,
        tolerance: f64,
    ) -> Exchange {
        let (a, b) = (i.diameter(), j.diameter());
        let place = |p: &Polygon| p.vertices()[0].to_array();
        let i_first = a < b || (a == b && place(i) < place(j));
        let (small, large) = if i_first { (i, j) } else { (j, i) };
        let allowed = tolerance * small.area().min(large.area());
        let mut sum = Exchange::default();
        for image in self.images().iter().filter(|image| image.level() >= from) {
            // Of the piece, what is behind a window sees nothing there.
            let seen = image.of_polygon(large);
            let mut planes =
                image.windows().iter().map(Polygon::plane).chain([seen.plane()]);
            let above = planes.try_fold(small.clone(), |p, plane| p.clipped(plane));
            let Some(piece) = above else { continue };
            let Some(sight) = self.sight(image, &piece, large) else { continue };
            let (found, error) = if sight.is_free() && sight.is_even() {
                let sharp = SHARP * tolerance;
                let found = exchange(&piece, sight.target(), sharp);
                (sight.reflectance * found, sharp * piece.area())
            } else {
                by_points(&sight, &piece, None, allowed, DEEPEST)
            };
            sum.all += found;
            sum.error += error;
            if image.level() == self.levels() {
                sum.last += found;
            }
        }
        sum
    }
}

/// `∫ F dA` over a piece, and about how far it may be off.
fn by_points(
    sight: &Sight,
    piece: &Polygon,
    coarse: Option<Rgb>,
    allowed: f64,
    depth: u32,
) -> (Rgb, f64) {
    let rule = |part: &Polygon| {
        let mut sum = Rgb::ZERO;
        points(part, POINTS, |x, area| sum += area * sight.factor(x, part.normal()));
        sum
    };
    let coarse = coarse.unwrap_or_else(|| rule(piece));
    let parts: Vec<Polygon> =
        piece.halves().flat_map(|half| half.halves().collect::<Vec<_>>()).collect();
    let fine: Vec<Rgb> = parts.iter().map(rule).collect();
    let sum: Rgb = fine.iter().sum();
    let apart = (sum - coarse).abs().max_element();
    let least = if sight.is_even() { 0.0 } else { UNEVEN * sum.max_element() };
    if depth == 0 || apart <= allowed.max(least) {
        return (sum, apart);
    }
    let found = parts.iter().zip(&fine).map(|(part, &found)| {
        by_points(sight, part, Some(found), 0.5 * allowed, depth - 1)
    });
    found.fold((Rgb::ZERO, 0.0), |(sum, off), (part, apart)| (sum + part, off + apart))
}
