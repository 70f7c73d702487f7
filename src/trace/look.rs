//! How the second pass looks at a room.

/// How far rays are followed, how gloss is integrated, and what is gathered anew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// So often a ray may be mirrored, refracted, passed on or scattered by gloss.
    pub depth: u32,
    /// Branches that count less than this in the picture are cut.
    pub weight: f64,
    /// How the directions about the reflection ray of gloss count.
    pub lobe: LobeAs,
    /// So many rays look for what gloss shows beside lamps, from each sample of a pixel;
    /// fewer where the gloss is seen in another surface.
    pub gloss: usize,
    /// So many rays gather the light on each diffuse point that the eye sees, from each
    /// sample of a pixel; with 0 the light stored there is shown.
    pub gather: usize,
    /// Names the random streams.
    pub seed: u64,
}

/// What stands for a Phong lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LobeAs {
    /// One cone that holds this share of it, in `(0, 1)`; all directions in it count the
    /// same.
    OneCone(f64),
    /// So many cones, stacked: the lobe itself, on average over the samples of a pixel.
    Stack(usize),
}

impl Look {
    /// As by default, but rays are followed `depth` times and down to this `weight`.
    pub const fn following(depth: u32, weight: f64) -> Look {
        Look { depth, weight, lobe: LobeAs::Stack(8), gloss: 8, gather: 0, seed: 0 }
    }
}

impl Default for Look {
    /// Twenty-four times, and a five-hundredth; a stack of 8 cones, and 8 rays.
    fn default() -> Look {
        Look::following(24, 0.002)
    }
}
