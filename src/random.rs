//! Random numbers that are the same on every run, machine and thread count.
//!
//! A [`Stream`] is named by what it samples - a seed and a few indices, such as
//! "element 17, gather 1" - and not by when it was asked. Two threads that sample two
//! elements never share a stream, so their number cannot change a result.
//!
//! ```text
//! state ← state + φ;   mix(state)        SplitMix64 (Steele, Lea & Flood 2014)
//! ```
//!
//! | method                | use it when                        | it fails when            |
//! |-----------------------|------------------------------------|--------------------------|
//! | [`Stream::next`]      | one number is needed               | many are: clumps         |
//! | [`Stream::points`]    | `n` points that fill a cube evenly | `n` is 1: as `next`      |
//! | [`Shares::pick`]      | one of several, by its weight      | there is none            |
//!
//! ```
//! use radiosity::random::Stream;
//! let draw = || Stream::named(7, &[3, 5]).next(); // the same name, the same numbers
//! assert_eq!(draw(), draw());
//! let points: Vec<[f64; 2]> = Stream::named(7, &[]).points(1000).collect();
//! let mean = points.iter().map(|p| p[0] * p[1]).sum::<f64>() / 1000.0;
//! assert!((mean - 0.25).abs() < 0.005); // by chance alone 0.007 would be usual
//! ```
//!
//! **Not here:** cryptography. Beyond the lecture; rays are first drawn in
//! the chapter *Form factors*.
//! Sources: Steele, Lea & Flood 2014;
//! Roberts 2018 (the sequence); Cranley & Patterson 1976 (random shifts).

/// A stream of uniform random numbers with a name.
#[derive(Clone, Debug)]
pub struct Stream {
    state: u64,
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

impl Stream {
    /// The stream of this `seed` and `name`; other names give unrelated streams.
    pub fn named(seed: u64, name: &[u64]) -> Stream {
        let state = name.iter().fold(mix(seed ^ GOLDEN), |s, &part| {
            mix(s.wrapping_add(GOLDEN) ^ mix(part))
        });
        Stream { state }
    }

    /// The next number, in `[0, 1)`.
    #[allow(clippy::should_implement_trait)] // it never ends; an Option would be noise
    pub fn next(&mut self) -> f64 {
        self.state = self.state.wrapping_add(GOLDEN);
        (mix(self.state) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// `n` points that fill the unit cube of `D` dimensions evenly: an additive
    /// recurrence with a random shift.
    ///
    /// Each point alone is uniform, so that a mean over them is unbiased.
    pub fn points<const D: usize>(
        &mut self,
        n: usize,
    ) -> impl Iterator<Item = [f64; D]> + use<D> {
        // The generalised golden ratio, x^(D+1) = x + 1; its powers are the steps.
        let ratio =
            (0..60).fold(2.0, |x: f64, _| (1.0 + x).powf(1.0 / (D as f64 + 1.0)));
        let steps: [f64; D] = std::array::from_fn(|k| ratio.powi(-(k as i32 + 1)));
        let shift: [f64; D] = std::array::from_fn(|_| self.next());
        let point = move |k: usize| {
            std::array::from_fn(|d| (shift[d] + steps[d] * k as f64).fract())
        };
        (0..n).map(point)
    }
}

/// Several things, to be drawn each as often as its weight says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shares {
    /// The share of all weights up to the end of each; the last has 1.
    so_far: Vec<f64>,
}

/// Rounding must not carry a draw over the edge of its share, where the density is another.
const INSIDE: f64 = 1e-9;

impl Shares {
    /// Of weights, none negative; even shares where all are 0.
    pub fn of(weights: impl IntoIterator<Item = f64>) -> Shares {
        let mut sum = 0.0;
        let sums = weights.into_iter().map(|weight| {
            sum += weight;
            sum
        });
        let mut so_far: Vec<f64> = sums.collect();
        let n = so_far.len() as f64;
        for (k, share) in so_far.iter_mut().enumerate() {
            *share = if sum > 0.0 { *share / sum } else { (k + 1) as f64 / n };
        }
        if let Some(last) = so_far.last_mut() {
            *last = 1.0;
        }
        Shares { so_far }
    }

    /// Is there nothing to draw?
    pub fn is_empty(&self) -> bool {
        self.so_far.is_empty()
    }

    /// The share of thing `k`, in `[0, 1]`.
    pub fn share(&self, k: usize) -> f64 {
        self.so_far[k] - if k > 0 { self.so_far[k - 1] } else { 0.0 }
    }

    /// The thing that `u` in `[0, 1)` draws, and how far into its share it falls, in
    /// `(0, 1)`: as good as a new number.
    ///
    /// # Panics
    /// When there is none.
    pub fn pick(&self, u: f64) -> (usize, f64) {
        let k = self.so_far.partition_point(|&share| share <= u);
        let k = k.min(self.so_far.len() - 1);
        let before = self.so_far[k] - self.share(k);
        (k, ((u - before) / self.share(k)).clamp(INSIDE, 1.0 - INSIDE))
    }
}
