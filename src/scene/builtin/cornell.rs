//! The Cornell box: as measured, and with its angles made right.
//!
//! Geometry, spectra and camera: Cornell University Program of Computer Graphics, *Cornell
//! Box Data*; the box itself: Goral, Torrance, Greenberg & Battaile 1984. Reflectances are
//! the measured spectra under D65, as linear sRGB (CIE 1931 2°, 400 to 700 nm).

use super::SceneBuilder;
use crate::geometry::Rgb;
use crate::material::Shine;
use crate::scene::{Camera, MaterialId, Scene};
use glam::{DVec3, dvec3};

const WHITE_PAINT: Rgb = Rgb::new(0.736_259_906, 0.736_669_512, 0.737_817_773);
const GREEN_PAINT: Rgb = Rgb::new(0.067_940_297, 0.398_710_446, 0.086_289_561);
const RED_PAINT: Rgb = Rgb::new(0.492_232_731, 0.049_106_246, 0.051_059_738);

/// Colour of the lamp's spectrum (0, 8, 15.6, 18.4 at 400, 500, 600, 700 nm): linear sRGB
/// of luminance 1.
const LAMP_COLOUR: Rgb = Rgb::new(1.674_962_643, 0.877_593_078, 0.224_015_781);

/// Radiosity of the lamp, W/m², for luminance 1. The data give no absolute value; this one
/// puts the white walls near a radiance of 0.3, so that an exposure of 1 shows the box.
const LAMP_RADIOSITY: f64 = 100.0;

/// Reflectance of the lamp, the same at all wavelengths (*Cornell Box Data*).
const LAMP_REFLECTANCE: f64 = 0.78;

/// `2 atan(12.5 / 35)` in degrees: film 25 mm high behind a lens of 35 mm.
const FOV: f64 = 39.307_648_116_106_62;

const WHITE: MaterialId = MaterialId(0);
const GREEN: MaterialId = MaterialId(1);
const RED: MaterialId = MaterialId(2);
const LAMP: MaterialId = MaterialId(3);

/// Four corners in whole steps of some length: no digit is lost on the way.
type Quad = (MaterialId, [[u16; 3]; 4]);

/// Tenths of a millimetre in a metre.
const TENTHS: f64 = 10_000.0;

/// Where the tall block begins in [`MEASURED`].
const TALL_BLOCK: usize = 11;

/// The measured box, in tenths of a millimetre; fronts into the room, out of the blocks.
///
/// Floor, ceiling, back, green, red, lamp; short block (top, then sides); tall block.
#[rustfmt::skip]
const MEASURED: [Quad; 16] = [
    (WHITE, [[5528,0,0], [0,0,0], [0,0,5592], [5496,0,5592]]),
    (WHITE, [[5560,5488,0], [5560,5488,5592], [0,5488,5592], [0,5488,0]]),
    (WHITE, [[5496,0,5592], [0,0,5592], [0,5488,5592], [5560,5488,5592]]),
    (GREEN, [[0,0,5592], [0,0,0], [0,5488,0], [0,5488,5592]]),
    (RED, [[5528,0,0], [5496,0,5592], [5560,5488,5592], [5560,5488,0]]),
    (LAMP, [[3430,5488,2270], [3430,5488,3320], [2130,5488,3320], [2130,5488,2270]]),
    (WHITE, [[1300,1650,650], [820,1650,2250], [2400,1650,2720], [2900,1650,1140]]),
    (WHITE, [[2900,0,1140], [2900,1650,1140], [2400,1650,2720], [2400,0,2720]]),
    (WHITE, [[1300,0,650], [1300,1650,650], [2900,1650,1140], [2900,0,1140]]),
    (WHITE, [[820,0,2250], [820,1650,2250], [1300,1650,650], [1300,0,650]]),
    (WHITE, [[2400,0,2720], [2400,1650,2720], [820,1650,2250], [820,0,2250]]),
    (WHITE, [[4230,3300,2470], [2650,3300,2960], [3140,3300,4560], [4720,3300,4060]]),
    (WHITE, [[4230,0,2470], [4230,3300,2470], [4720,3300,4060], [4720,0,4060]]),
    (WHITE, [[4720,0,4060], [4720,3300,4060], [3140,3300,4560], [3140,0,4560]]),
    (WHITE, [[3140,0,4560], [3140,3300,4560], [2650,3300,2960], [2650,0,2960]]),
    (WHITE, [[2650,0,2960], [2650,3300,2960], [4230,3300,2470], [4230,0,2470]]),
];

/// The box with right angles, in hundredths: 5.5 × 5.5 × 5.6, the front open.
///
/// Floor, back, green, red, ceiling, lamp; short block (top, then sides); tall block.
#[rustfmt::skip]
const REGULAR: [Quad; 16] = [
    (WHITE, [[0,0,0], [0,0,560], [550,0,560], [550,0,0]]),
    (WHITE, [[0,0,560], [0,550,560], [550,550,560], [550,0,560]]),
    (GREEN, [[0,0,0], [0,550,0], [0,550,560], [0,0,560]]),
    (RED, [[550,0,0], [550,0,560], [550,550,560], [550,550,0]]),
    (WHITE, [[0,550,0], [550,550,0], [550,550,560], [0,550,560]]),
    (LAMP, [[213,550,227], [343,550,227], [343,550,332], [213,550,332]]),
    (WHITE, [[130,165,65], [82,165,225], [240,165,272], [290,165,114]]),
    (WHITE, [[290,0,114], [290,165,114], [240,165,272], [240,0,272]]),
    (WHITE, [[130,0,65], [130,165,65], [290,165,114], [290,0,114]]),
    (WHITE, [[82,0,225], [82,165,225], [130,165,65], [130,0,65]]),
    (WHITE, [[240,0,272], [240,165,272], [82,165,225], [82,0,225]]),
    (WHITE, [[423,330,247], [265,330,296], [314,330,456], [472,330,406]]),
    (WHITE, [[423,0,247], [423,330,247], [472,330,406], [472,0,406]]),
    (WHITE, [[472,0,406], [472,330,406], [314,330,456], [314,0,456]]),
    (WHITE, [[314,0,456], [314,330,456], [265,330,296], [265,0,296]]),
    (WHITE, [[265,0,296], [265,330,296], [423,330,247], [423,0,247]]),
];

/// The box as measured, in metres.
///
/// Its red wall is 1.6 mm off plane and becomes two triangles; its lamp lies in the plane
/// of the ceiling, which is cut around it.
pub(super) fn measured() -> Scene {
    in_metres("cornell", MEASURED.len(), |_| {})
}

/// What the mirror of the tall block keeps: it is silvered glass.
const SILVER: Rgb = Rgb::new(0.95, 0.95, 0.93);

/// The measured box, its tall block a mirror on all sides.
pub(super) fn with_mirror() -> Scene {
    in_metres("cornell-mirror", TALL_BLOCK, |builder| {
        let shine = Shine::Mirror { reflectance: SILVER };
        let mirror = builder.shiny("mirror", Rgb::ZERO, Rgb::ZERO, shine);
        for (_, corners) in &MEASURED[TALL_BLOCK..] {
            builder.face(mirror, &outline(corners, TENTHS));
        }
    })
}

/// The measured box with a pane of glass, a little green, that stands before its blocks.
pub(super) fn with_pane() -> Scene {
    in_metres("cornell-pane", MEASURED.len(), |builder| {
        let shine = Shine::Pane { index: 1.5, tint: Rgb::new(0.88, 0.96, 0.92) };
        let pane = builder.shiny("pane", Rgb::ZERO, Rgb::ZERO, shine);
        let (near, far) = (dvec3(0.10, 0.0, 0.02), dvec3(0.40, 0.0, 0.05));
        let up = 0.27 * DVec3::Y;
        builder.face(pane, &[near, near + up, far + up, far]);
    })
}

/// The first `count` faces of the measured box, and what else there is.
fn in_metres(name: &str, count: usize, more: impl FnOnce(&mut SceneBuilder)) -> Scene {
    let camera = Camera {
        eye: dvec3(0.278, 0.273, -0.8),
        target: dvec3(0.278, 0.273, 0.2796),
        up: DVec3::Y,
        fov: FOV,
    };
    let lamp = (LAMP_RADIOSITY * LAMP_COLOUR, Rgb::splat(LAMP_REFLECTANCE));
    let paints = [WHITE_PAINT, GREEN_PAINT, RED_PAINT];
    let mut builder = cornell(paints, lamp, &MEASURED[..count], TENTHS);
    more(&mut builder);
    builder.scene(name, camera)
}

/// The box of the reference solution: right angles, a lamp of radiosity 1 that reflects
/// nothing, reflectances to five digits.
pub(super) fn regular() -> Scene {
    let camera = Camera {
        eye: dvec3(2.75, 2.75, -8.0),
        target: dvec3(2.75, 2.75, 2.8),
        up: DVec3::Y,
        fov: FOV,
    };
    let five_digits = |c: Rgb| (c * 1e5).round() / 1e5;
    let paints = [WHITE_PAINT, GREEN_PAINT, RED_PAINT].map(five_digits);
    let lamp = (Rgb::ONE, Rgb::ZERO);
    cornell(paints, lamp, &REGULAR, 100.0).scene("cornell-regular", camera)
}

fn cornell(
    [white, green, red]: [Rgb; 3],
    (emission, reflectance): (Rgb, Rgb),
    quads: &[Quad],
    steps: f64,
) -> SceneBuilder {
    let mut builder = SceneBuilder::default();
    builder.material("white", Rgb::ZERO, white);
    builder.material("green", Rgb::ZERO, green);
    builder.material("red", Rgb::ZERO, red);
    builder.material("lamp", emission, reflectance);
    for (material, corners) in quads {
        builder.face(*material, &outline(corners, steps));
    }
    builder
}

fn outline(corners: &[[u16; 3]; 4], steps: f64) -> [DVec3; 4] {
    corners.map(|c| DVec3::from_array(c.map(f64::from)) / steps)
}
