//! What a surface does with light; passive by construction.
//!
//! ```text
//! B = E + ρ H                       a diffuse surface: emitted plus reflected radiosity, W/m²
//! L(ωₒ) = ∫ f(ωᵢ, ωₒ) L(ωᵢ) cosθᵢ dωᵢ        any surface, by its BRDF f, 1/sr
//! f = ρ/π                           of a diffuse one: the same in all directions
//! ∫ f cosθₒ dωₒ ≤ 1  in every channel        or the light in a room would never die out
//! ```
//!
//! A [`Material`] keeps its fields private: once built it reflects less than it gets.
//!
//! | made by            | use it when                         | it fails when               |
//! |--------------------|-------------------------------------|-----------------------------|
//! | [`Material::new`]  | numbers come from file or person    | they would create light     |
//! | [`Lobe::Lambert`]  | it looks alike from everywhere      | it shines                   |
//! | [`Lobe::Phong`]    | a highlight is wanted               | at a slant: loses up to all |
//! | [`Material::brdf`] | both at once                        | as its lobes do             |
//!
//! **Not here:** transmittance, Fresnel's law and mirrors. Chapters *How surfaces scatter*
//! (L04) and *Albedo* (L05). Sources: Nicodemus et al. 1977; Phong 1975; Lewis 1993;
//! Lafortune & Willems 1994; Arvo 1995.

mod brdf;

pub use brdf::{Brdf, Lobe};

use crate::geometry::Rgb;
use std::fmt;

/// The numbers of a material, not checked yet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// `Ke`: emitted radiosity `E` in W/m², front side; radiance is `E/π`.
    pub emission: Rgb,
    /// `Kd`: diffuse reflectance `ρ`, in `[0, 1)`.
    pub diffuse: Rgb,
    /// `Ks`: specular reflectance, in `[0, 1]`; `Kd + Ks ≤ 1`.
    pub specular: Rgb,
}

/// A passive material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    name: String,
    coefficients: Coefficients,
}

/// Why some [`Coefficients`] make no material.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialError {
    /// A coefficient is negative, NaN or infinite.
    NotANumber {
        /// The material's name.
        material: String,
        /// Which coefficient.
        key: &'static str,
        /// Its value.
        value: Rgb,
    },
    /// Diffuse reflectance of 1 or more in a channel.
    Diffuse {
        /// The material's name.
        material: String,
        /// Its `Kd`.
        value: Rgb,
    },
    /// More light leaves than arrives.
    NotPassive {
        /// The material's name.
        material: String,
        /// `Kd + Ks`.
        sum: Rgb,
    },
}

impl fmt::Display for MaterialError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let rgb = |c: &Rgb| format!("({}, {}, {})", c.x, c.y, c.z);
        match self {
            MaterialError::NotANumber { material, key, value } => write!(
                f,
                "material `{material}` has {key} {}; every channel must be a finite number \
                 ≥ 0",
                rgb(value)
            ),
            MaterialError::Diffuse { material, value } => write!(
                f,
                "material `{material}` reflects {} of the light it gets; every channel of Kd \
                 must be < 1; lower Kd",
                rgb(value)
            ),
            MaterialError::NotPassive { material, sum } => write!(
                f,
                "material `{material}` reflects {} of the light it gets; every channel of \
                 Kd + Ks must be ≤ 1; lower Kd or Ks",
                rgb(sum)
            ),
        }
    }
}

impl std::error::Error for MaterialError {}

impl Material {
    /// Checks that the material is passive.
    ///
    /// # Errors
    /// When a coefficient is negative or not finite, when `Kd ≥ 1`, or when
    /// `Kd + Ks > 1 + 1e-9` in some channel.
    pub fn new(
        name: impl Into<String>,
        coefficients: Coefficients,
    ) -> Result<Material, MaterialError> {
        let name = name.into();
        let Coefficients { emission, diffuse, specular } = coefficients;
        for (key, value) in [("Ke", emission), ("Kd", diffuse), ("Ks", specular)] {
            if !(value.is_finite() && value.min_element() >= 0.0) {
                return Err(MaterialError::NotANumber { material: name, key, value });
            }
        }
        // ANCHOR: passive
        if diffuse.max_element() >= 1.0 {
            return Err(MaterialError::Diffuse { material: name, value: diffuse });
        }
        let sum = diffuse + specular;
        if sum.max_element() > 1.0 + 1e-9 {
            return Err(MaterialError::NotPassive { material: name, sum });
        }
        // ANCHOR_END: passive
        Ok(Material { name, coefficients })
    }

    /// Its name, as in the MTL file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Emitted radiosity `E` of the front, W/m², ≥ 0.
    pub fn emission(&self) -> Rgb {
        self.coefficients.emission
    }

    /// Diffuse reflectance `ρ` of the front, in `[0, 1)`.
    pub fn diffuse(&self) -> Rgb {
        self.coefficients.diffuse
    }

    /// Specular reflectance of the front, in `[0, 1]`.
    pub fn specular(&self) -> Rgb {
        self.coefficients.specular
    }

    /// Does it send light of its own?
    pub fn emits(&self) -> bool {
        self.coefficients.emission != Rgb::ZERO
    }
}
