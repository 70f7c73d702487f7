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
//! | [`Shine`]          | it mirrors, glosses or is glass     | light is polarised          |
//! | [`optics`]         | light meets a smooth face           | films are thin: interference|
//!
//! What is diffuse and what shines stands side by side, and shares:
//!
//! ```text
//! Kd + Td < 1      Kd + Td + Ks ≤ 1      panes, glass: (1 − Kd − Td) of Fresnel's R and T
//! ```
//!
//! ```
//! use radiosity::geometry::Rgb;
//! use radiosity::material::{Coefficients, Material, optics};
//! let paint = |share: f64| {
//!     let diffuse = Rgb::splat(share);
//!     Material::new("paint", Coefficients { diffuse, ..Coefficients::default() })
//! };
//! assert_eq!(paint(0.5).unwrap().diffuse(), Rgb::splat(0.5));
//! assert!(paint(1.2).is_err()); // it would make light
//! assert!((optics::fresnel(1.0, 1.5).mean() - 0.04).abs() < 1e-15); // glass, face on
//! ```
//!
//! **Not here:** textures. Chapters *How surfaces scatter* (L04), *Albedo* (L05) and
//! *Mirrors and windows* (L17, L18). Sources: Fresnel 1823; Nicodemus et al. 1977; Phong
//! 1975; Lewis 1993; Lafortune & Willems 1994; Arvo 1995.

mod brdf;
pub mod optics;
mod shine;

pub use brdf::{Brdf, Lobe};
pub use shine::Shine;

use crate::geometry::Rgb;
use std::fmt;

/// The numbers of a material, not checked yet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// `Ke`: emitted radiosity `E` in W/m², front side; radiance is `E/π`.
    pub emission: Rgb,
    /// `Kd`: diffuse reflectance `ρ`, in `[0, 1)`.
    pub diffuse: Rgb,
    /// `Td`: diffuse transmittance `τ`, in `[0, 1)`, of either side; `Kd + Td < 1`.
    pub translucence: Rgb,
    /// What it does besides scattering diffusely.
    pub shine: Shine,
}

/// A passive material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    name: String,
    coefficients: Coefficients,
    smooth_share: Rgb,
}

/// Why some [`Coefficients`] make no material.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
    /// Diffuse reflectance and transmittance of 1 or more in a channel.
    Diffuse {
        /// The material's name.
        material: String,
        /// Its `Kd + Td`.
        value: Rgb,
    },
    /// More light leaves than arrives.
    NotPassive {
        /// The material's name.
        material: String,
        /// `Kd + Td + Ks`.
        sum: Rgb,
    },
    /// A refractive index, gloss exponent or tint that none can be.
    Shine {
        /// The material's name.
        material: String,
        /// Which key.
        key: &'static str,
        /// What is wrong with its value.
        fault: String,
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
                "material `{material}` reflects and transmits {} of the light it gets; every \
                 channel of Kd + Td must be < 1; lower Kd or Td",
                rgb(value)
            ),
            MaterialError::NotPassive { material, sum } => write!(
                f,
                "material `{material}` reflects and transmits {} of the light it gets; every \
                 channel of Kd + Td + Ks must be ≤ 1; lower Kd, Td or Ks",
                rgb(sum)
            ),
            MaterialError::Shine { material, key, fault } => {
                write!(f, "material `{material}` has {key} {fault}")
            }
        }
    }
}

impl std::error::Error for MaterialError {}

impl Material {
    /// Checks that the material is passive.
    ///
    /// # Errors
    /// When a coefficient is negative or not finite, when `Kd + Td ≥ 1`, when
    /// `Kd + Td + Ks > 1 + 1e-9` in some channel, or when the index of refraction, the
    /// gloss exponent or the tint is out of range ([`Shine`]).
    pub fn new(
        name: impl Into<String>,
        coefficients: Coefficients,
    ) -> Result<Material, MaterialError> {
        let name = name.into();
        let Coefficients { emission, diffuse, translucence, shine } = coefficients;
        let specular = shine.reflectance();
        for (key, value) in
            [("Ke", emission), ("Kd", diffuse), ("Td", translucence), ("Ks", specular)]
        {
            if !(value.is_finite() && value.min_element() >= 0.0) {
                return Err(MaterialError::NotANumber { material: name, key, value });
            }
        }
        if let Some((key, fault)) = shine.fault() {
            return Err(MaterialError::Shine { material: name, key, fault });
        }
        // ANCHOR: passive
        let diffused = diffuse + translucence;
        if diffused.max_element() >= 1.0 {
            return Err(MaterialError::Diffuse { material: name, value: diffused });
        }
        let sum = diffused + specular;
        if sum.max_element() > 1.0 + 1e-9 {
            return Err(MaterialError::NotPassive { material: name, sum });
        }
        // ANCHOR_END: passive
        Ok(Material { name, coefficients, smooth_share: Rgb::ONE - diffused })
    }

    /// A material that absorbs all light.
    pub fn black(name: impl Into<String>) -> Material {
        let (name, coefficients) = (name.into(), Coefficients::default());
        Material { name, coefficients, smooth_share: Rgb::ONE }
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

    /// Diffuse transmittance `τ`, in `[0, 1)`, the same from either side.
    pub fn translucence(&self) -> Rgb {
        self.coefficients.translucence
    }

    /// What it does besides scattering diffusely.
    pub fn shine(&self) -> Shine {
        self.coefficients.shine
    }

    /// `B = E + ρ H + τ H_behind`, W/m²: what leaves its front when this much arrives on the
    /// front and on the other side.
    pub fn radiosity(&self, front: Rgb, behind: Rgb) -> Rgb {
        self.emission() + self.diffuse() * front + self.translucence() * behind
    }

    /// What it scatters diffusely to either side, `ρ + τ`, in `[0, 1)`.
    pub fn scattered(&self) -> Rgb {
        self.diffuse() + self.translucence()
    }

    /// Of the light that meets it, the share that Fresnel's law has for reflection and
    /// refraction: what neither `Kd` nor `Td` takes. In `(0, 1]`. It is the same of a face's
    /// [back](Material::back), or a pane would let more through one way than the other.
    pub fn smooth_share(&self) -> Rgb {
        self.smooth_share
    }

    /// The material of the other side of a face: the same but for light of its own and,
    /// unless it is `two_sided`, for what an opaque face does on its front only.
    pub fn back(&self, two_sided: bool) -> Material {
        let mut back = self.clone();
        let all = &mut back.coefficients;
        all.emission = Rgb::ZERO;
        if !two_sided {
            all.diffuse = Rgb::ZERO;
            if !all.shine.passes() {
                all.shine = Shine::Dull;
            }
        }
        back
    }

    /// Does it send light of its own?
    pub fn emits(&self) -> bool {
        self.coefficients.emission != Rgb::ZERO
    }
}
