//! Solid angle, and the quantities of light that are measured with it.
//!
//! ```text
//! Ω = ∫ dω   solid angle, sr, 0 … 4π        Ω⊥ = ∫ cosθ dω   projected, sr, 0 … π
//! Φ flux, W      H = dΦ/dA irradiance, W/m²     B = dΦ/dA radiosity (exitance), W/m²
//! L = d²Φ/(dA cosθ dω) radiance, W/(m² sr)      B = π L for a diffuse surface
//! H = ∫ L cosθ dω = L Ω⊥   where `L` is the same from everywhere
//! ```
//!
//! | function                        | use it when                      | it fails when     |
//! |---------------------------------|----------------------------------|-------------------|
//! | [`solid_angle`]                 | how large does a polygon look?   | `p` lies on it    |
//! | [`solid_angle_of_box`]          | how large does a box look?       | never             |
//! | [`solid_angle_of_cap`]          | how wide is a cone, a sphere?    | never             |
//! | [`projected_solid_angle`]       | how much light does it send `p`? | `p` is on an edge |
//! | [`projected_solid_angle_of_cap`]| the same of a sphere             | never             |
//! | [`cosine_direction`]            | rays are to carry equal light    | never             |
//!
//! ```
//! use radiosity::prelude::*;
//! use radiosity::radiometry::{flux, projected_solid_angle, solid_angle};
//! use std::f64::consts::PI;
//! let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
//! let lid = Polygon::new(corners.map(|(x, y)| dvec3(x, y, 1.0)).to_vec()).unwrap();
//! // From the middle of a cube each side takes a sixth of all directions.
//! assert!((solid_angle(DVec3::ZERO, &lid) - 4.0 * PI / 6.0).abs() < 1e-14);
//! assert!(projected_solid_angle(DVec3::ZERO, DVec3::Z, lid.vertices()) < 4.0 * PI / 6.0);
//! assert_eq!(flux(Rgb::splat(2.0), 3.0), Rgb::splat(6.0)); // 2 W/m² from 3 m²
//! ```
//!
//! **Not here:** visibility; the form factor is [`crate::form_factor`]'s.
//! Chapters *Solid angle* (L02) and *Radiometry* (L03). Sources: Lambert 1760; Nusselt 1928;
//! Van Oosterom & Strackee 1983; Baum, Rushmeier & Winget 1989.

mod projected;
mod solid_angle;

pub use projected::{
    cosine_direction, cosine_power_integral, projected_solid_angle,
    projected_solid_angle_of_cap,
};
pub use solid_angle::{
    solid_angle, solid_angle_of_box, solid_angle_of_cap, solid_angle_of_corner,
    solid_angle_of_rectangle, solid_angle_of_sphere, solid_angle_triangle,
};

use crate::geometry::Rgb;
use std::f64::consts::PI;

// ANCHOR: conversions
/// Flux, W, of a surface of `area`, m², that sends `radiosity`, W/m²: `Φ = A B`.
///
/// Just so, the flux that falls on it is its area times its irradiance.
// ANCHOR: flux
pub fn flux(radiosity: Rgb, area: f64) -> Rgb {
    radiosity * area
}
// ANCHOR_END: flux

/// Radiosity, W/m², from the `flux`, W, that leaves `area`, m² (positive): `B = Φ/A`.
///
/// Just so, irradiance is the flux that arrives, divided by the area.
// ANCHOR: radiosity_from_flux
pub fn radiosity_from_flux(flux: Rgb, area: f64) -> Rgb {
    debug_assert!(area > 0.0, "area must be positive: {area}");
    flux / area
}
// ANCHOR_END: radiosity_from_flux

/// Radiance of a diffuse surface, W/(m² sr), from its radiosity, W/m²: `L = B/π`.
// ANCHOR: radiance_from_radiosity
pub fn radiance_from_radiosity(radiosity: Rgb) -> Rgb {
    radiosity / PI
}
// ANCHOR_END: radiance_from_radiosity

/// Radiosity of a diffuse surface, W/m², from its radiance, W/(m² sr): `B = π L`.
pub fn radiosity_from_radiance(radiance: Rgb) -> Rgb {
    radiance * PI
}

/// Irradiance, W/m², from what has one `radiance`, W/(m² sr), all over its `projected`
/// solid angle, sr, `[0, π]`: `H = L Ω⊥`.
// ANCHOR: irradiance
pub fn irradiance(radiance: Rgb, projected: f64) -> Rgb {
    radiance * projected
}
// ANCHOR_END: irradiance

/// Radiosity, W/m², that a surface of this diffuse `reflectance`, in `[0, 1]`, makes of
/// `irradiance`, W/m²: `B = ρ H`, channel by channel.
// ANCHOR: reflected
pub fn reflected(irradiance: Rgb, reflectance: Rgb) -> Rgb {
    irradiance * reflectance
}
// ANCHOR_END: reflected
// ANCHOR_END: conversions

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// A lamp's flux, spread over a diffuse sheet, is found again as irradiance under a
    /// sky of its radiance: π leaves on one way what it enters on the other.
    #[test]
    fn conversions_go_round() {
        let sent = Rgb::new(60.0, 40.0, 20.0);
        let radiosity = radiosity_from_flux(sent, 0.5);
        assert_eq!(radiosity, Rgb::new(120.0, 80.0, 40.0));
        assert_eq!(flux(radiosity, 0.5), sent);
        let radiance = radiance_from_radiosity(radiosity);
        assert!((radiance.x - 38.197_186_342_054_88).abs() < 1e-13);
        assert!((radiosity_from_radiance(radiance) - radiosity).length() < 1e-13);
        // Under a whole sky of that radiance the irradiance is the radiosity again,
        let under_sky = irradiance(radiance, PI);
        assert!((under_sky - radiosity).length() < 1e-13);
        // and a white sheet sends it back.
        assert_eq!(reflected(under_sky, DVec3::ONE), under_sky);
        assert_eq!(reflected(under_sky, DVec3::X), under_sky * DVec3::X);
    }
}
