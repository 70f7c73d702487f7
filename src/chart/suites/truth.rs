//! A reference that is itself noisy, twice: so that its noise drops out.
//!
//! ```text
//! error² = mean (L − a)(L − b) / (mean L*)²     a, b: two independent unbiased answers
//! ```
//! For each of them alone the mean of `(L − a)²` is too large by the variance of `a`. What
//! is left is luck, of the size of `√(Σ σ⁴)/n`: below its root no error can be told.

use crate::chart::Verdict;
use crate::film::Picture;
use crate::geometry::Rgb;

/// What some pixels of a picture should show.
#[derive(Debug)]
pub struct PictureTruth {
    /// Which pixels.
    pixels: Vec<usize>,
    /// What they should show, W/(m² sr), twice.
    found: [Vec<Rgb>; 2],
}

impl PictureTruth {
    /// Of these pixels: `found` tells the radiance of each, once for each seed.
    pub fn new(pixels: Vec<usize>, found: impl Fn(u64) -> Vec<Rgb>) -> PictureTruth {
        PictureTruth { pixels, found: [1, 2].map(found) }
    }

    /// Two pictures by an unbiased method, looked at in some pixels.
    pub fn of(pixels: Vec<usize>, picture: impl Fn(u64) -> Picture) -> PictureTruth {
        let found = |seed| {
            let picture = picture(seed);
            pixels.iter().map(|&k| picture.pixels[k]).collect()
        };
        let found = [1, 2].map(found);
        PictureTruth { pixels, found }
    }

    /// Root mean square error over the pixels and channels, relative to the mean of the
    /// truth; and how much brighter the pixels are, together, than they should be.
    pub fn judge(&self, seen: &Picture) -> Verdict {
        let (mut square, mut sum) = (0.0, 0.0);
        for (k, [a, b]) in self.pairs() {
            let l = seen.pixels[k];
            square += ((l - a) * (l - b)).element_sum();
            sum += l.element_sum();
        }
        let mean = self.mean();
        let brighter = sum / self.numbers() / mean - 1.0;
        let error = (square / self.numbers()).max(0.0).sqrt() / mean;
        Verdict { error, energy: Some(brighter) }
    }

    /// Smaller errors cannot be told from none.
    pub fn uncertainty(&self) -> f64 {
        // Of normal noise (a − b)²/2 has the mean σ², and its square that of 3 σ⁴.
        let fourth =
            |[a, b]: [Rgb; 2]| (0.5 * (a - b) * (a - b)).length_squared() / 3.0;
        let sum: f64 = self.pairs().map(|(_, found)| fourth(found)).sum();
        (sum.sqrt() / self.numbers()).sqrt() / self.mean()
    }

    fn pairs(&self) -> impl Iterator<Item = (usize, [Rgb; 2])> + '_ {
        self.pixels
            .iter()
            .enumerate()
            .map(|(n, &k)| (k, [0, 1].map(|s| self.found[s][n])))
    }

    /// Of pixels and channels.
    fn numbers(&self) -> f64 {
        3.0 * self.pixels.len() as f64
    }

    fn mean(&self) -> f64 {
        let of = |(_, [a, b]): (usize, [Rgb; 2])| 0.5 * (a + b).element_sum();
        self.pairs().map(of).sum::<f64>() / self.numbers()
    }
}
