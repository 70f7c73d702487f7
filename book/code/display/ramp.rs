//! Codes are not light: half the light, half the code, and ramps.

use radiosity::film::{RgbImage, byte, linear_from_srgb};

/// Every other pixel white, in the middle a square of half the light, and one of half the
/// code: from afar the one disappears, the other does not.
pub fn board() -> RgbImage {
    let inside = |x: u32, from: u32| (from..from + 64).contains(&x);
    RgbImage::from_fn(256, 128, |x, y| {
        let grey = match (inside(x, 32), inside(x, 160), inside(y, 32)) {
            (true, _, true) => byte(0.5),
            (_, true, true) => 128,
            _ => 255 * u8::from((x + y).is_multiple_of(2)),
        };
        [grey; 3].into()
    })
}

/// The ends of the ramps, in light.
pub const ENDS: [f64; 2] = [0.02, 1.0];

/// The code of a place on the ramp: interpolated as light, then coded; and the other way
/// round.
pub fn codes(t: f64) -> [u8; 2] {
    let [a, b] = ENDS;
    let [low, high] = ENDS.map(|v| f64::from(byte(v)));
    [byte(a + t * (b - a)), (low + t * (high - low) + 0.5) as u8]
}

/// Both ramps, one above the other.
pub fn ramps() -> RgbImage {
    RgbImage::from_fn(256, 64, |x, y| {
        let [light, code] = codes((f64::from(x) + 0.5) / 256.0);
        [if y < 32 { light } else { code }; 3].into()
    })
}

/// What they say half-way.
pub fn text() -> String {
    let [light, code] = codes(0.5);
    let shown = |code: u8| linear_from_srgb(f64::from(code) / 255.0);
    format!(
        "Half-way between {} and {} lies {:.2}, code {light}. Between their codes, {} and {}, \
         lies {code}, which is the light {:.2}: little more than half of what it should be.\n",
        ENDS[0],
        ENDS[1],
        0.5 * (ENDS[0] + ENDS[1]),
        byte(ENDS[0]),
        byte(ENDS[1]),
        shown(code),
    )
}
