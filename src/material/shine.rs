//! What a surface does besides scattering diffusely.

use crate::geometry::Rgb;

/// What a surface does with light besides scattering it diffusely.
// ANCHOR: shine
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Shine {
    /// Nothing.
    #[default]
    Dull,
    /// Mirrors this share, whatever the angle.
    Mirror {
        /// `Ks`, in `[0, 1]`.
        reflectance: Rgb,
    },
    /// Scatters this share about the mirror direction: a Phong lobe.
    Gloss {
        /// `Ks`, in `[0, 1]`: the albedo at normal incidence.
        reflectance: Rgb,
        /// `Ns`, finite, ≥ 0: the larger, the narrower.
        exponent: f64,
    },
    /// A thin clear pane: passes light straight on and mirrors the rest, by Fresnel's law.
    Pane {
        /// Of refraction, finite, > 0.
        index: f64,
        /// `Tf`, in `[0, 1]`: times what passes.
        tint: Rgb,
    },
    /// The boundary of a solid that refracts; its normal leads out of it.
    Glass {
        /// Of refraction, inside, finite, > 0.
        index: f64,
        /// `Tf`, in `[0, 1]`: times what passes, at each crossing.
        tint: Rgb,
    },
}
// ANCHOR_END: shine

impl Shine {
    /// `Ks`; 0 of panes and glass, where Fresnel's law reflects.
    pub fn reflectance(&self) -> Rgb {
        match *self {
            Shine::Mirror { reflectance } | Shine::Gloss { reflectance, .. } => {
                reflectance
            }
            _ => Rgb::ZERO,
        }
    }

    /// Does light go through, and meet either side?
    pub fn passes(&self) -> bool {
        self.clear().is_some()
    }

    /// The index of refraction of the solid whose boundary it is, if it is one.
    pub fn index_of_solid(&self) -> Option<f64> {
        match *self {
            Shine::Glass { index, .. } => Some(index),
            _ => None,
        }
    }

    /// `Ks` and `Ns` of gloss.
    pub fn gloss(&self) -> Option<(Rgb, f64)> {
        match *self {
            Shine::Gloss { reflectance, exponent } => Some((reflectance, exponent)),
            _ => None,
        }
    }

    /// `Ks` of a mirror that mirrors anything.
    pub fn mirror(&self) -> Option<Rgb> {
        match *self {
            Shine::Mirror { reflectance } => Some(reflectance),
            _ => None,
        }
        .filter(|&reflectance| reflectance != Rgb::ZERO)
    }

    /// Index and tint of a thin pane, which light goes straight through.
    pub fn pane(&self) -> Option<(f64, Rgb)> {
        self.clear().filter(|_| !self.bends())
    }

    /// Index and tint of what is clear: panes, glass.
    pub fn clear(&self) -> Option<(f64, Rgb)> {
        match *self {
            Shine::Pane { index, tint } | Shine::Glass { index, tint } => {
                Some((index, tint))
            }
            _ => None,
        }
    }

    /// Does light leave it in directions that show no image in a plane?
    pub fn bends(&self) -> bool {
        self.gloss().is_some() || self.index_of_solid().is_some()
    }

    /// Does nothing shine?
    pub fn is_dull(&self) -> bool {
        match *self {
            Shine::Dull => true,
            Shine::Mirror { reflectance } | Shine::Gloss { reflectance, .. } => {
                reflectance == Rgb::ZERO
            }
            _ => false,
        }
    }

    /// What cannot be: the key, and its value with the remedy.
    pub(super) fn fault(&self) -> Option<(&'static str, String)> {
        match *self {
            Shine::Gloss { exponent, .. }
                if !(exponent >= 0.0 && exponent.is_finite()) =>
            {
                Some(("Ns", format!("{exponent}; write a finite number ≥ 0")))
            }
            Shine::Pane { index, .. } | Shine::Glass { index, .. }
                if !(index > 0.0 && index.is_finite()) =>
            {
                Some((
                    "Ni",
                    format!("{index}; write a finite number > 0, glass has 1.5"),
                ))
            }
            Shine::Pane { tint, .. } | Shine::Glass { tint, .. }
                if !(tint.min_element() >= 0.0 && tint.max_element() <= 1.0) =>
            {
                let Rgb { x, y, z } = tint;
                Some(("Tf", format!("({x}, {y}, {z}); write numbers from 0 to 1")))
            }
            _ => None,
        }
    }
}
