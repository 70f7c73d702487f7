//! The figures and numbers of the chapter *Why not specular radiosity?*
//!
//! [`Tiny`] is a cube with a glossy floor, solved in patches and bins; [`views`] looks at
//! it; [`smear`] asks what bins make of a lobe; [`growth`] reads what was measured.

pub mod growth;
pub mod smear;
pub mod views;

pub use radiosity::chart::suites::directional::{
    EXPONENT, Tiny, floor_pixels, scene, shot,
};
use radiosity::geometry::Polygon;
use radiosity::glam::DVec3;

/// The outline of the cube's floor, for those who look at it alone.
pub fn is_floor(polygon: &Polygon) -> bool {
    polygon.normal() == DVec3::Z
}

/// Path and text of the generated files of this chapter.
pub fn files() -> Vec<(String, String)> {
    vec![
        ("generated/directional-growth.md".to_string(), growth::table()),
        ("generated/directional-cost.md".into(), growth::text()),
        ("generated/directional-steps.md".into(), growth::steps()),
        ("generated/directional-cornell.md".into(), growth::cornell()),
        ("generated/directional-smear.md".into(), smear::table()),
        ("generated/directional-views.md".into(), views::caption()),
        ("generated/directional-floor.md".into(), views::floor_caption()),
        ("generated/directional-ledger.md".into(), views::ledger()),
    ]
}
