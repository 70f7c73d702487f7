//! Which light is whose: the words that paths spell, and the pass that owns each.
//!
//! ```text
//! E S* L                 what shines is seen, straight or by mirrors        pass 2
//! E S* D (D|S)* L        from the first D on: pass 1; the S before it: pass 2
//! ```
//! A path is read from the eye E to its light L, a lamp or the sky. At each surface on the
//! way it is scattered diffusely (D: reflected or let through by a translucent sheet) or
//! passed on (S: by a mirror, a pane, glass, gloss). Every path spells one word; every word
//! is in one [`Class`]; so no light is counted twice, and none is forgotten.
//!
//! Sources: Heckbert 1990 (the words, read the other way round); Wallace, Cohen & Greenberg
//! 1987 (who carries which).

use crate::geometry::Rgb;
pub use crate::ways::Letter;

/// How light came to the surface where the eye, or the mirrors before it, found it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Light {
    /// `L`: it is a lamp, or the sky.
    Lamp,
    /// `DL`: straight from a lamp.
    Direct,
    /// `DD⁺L`: by way of other diffuse surfaces only.
    Reflected,
    /// `DS⁺L`: from a lamp by mirrors, panes, glass, gloss.
    Caustic,
    /// `D(D|S)*L`, the rest: diffuse light that was passed on in between.
    Mixed,
}

/// A family of words: whether the eye looks into a mirror, and how light came there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Class {
    /// Does the eye see it by mirrors, panes, glass, gloss: `ES⁺…`?
    pub mirrored: bool,
    /// How light came there.
    pub light: Light,
}

/// Who carries the light of a class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// Pass 1: it is in the radiosity, and does not depend on the eye.
    First,
    /// Pass 2: it depends on the eye.
    Second,
    /// Pass 1 brings it to the first D, pass 2 from there to the eye.
    Both,
}

impl Owner {
    /// In a few words.
    pub fn name(self) -> &'static str {
        match self {
            Owner::First => "pass 1",
            Owner::Second => "pass 2",
            Owner::Both => "pass 1, seen by pass 2",
        }
    }
}

impl Class {
    /// All of them, in the order of [`Class::index`].
    pub fn all() -> impl Iterator<Item = Class> {
        use Light::{Caustic, Direct, Lamp, Mixed, Reflected};
        [false, true].into_iter().flat_map(|mirrored| {
            [Lamp, Direct, Reflected, Caustic, Mixed]
                .map(|light| Class { mirrored, light })
        })
    }

    /// Its place in [`Class::all`], below [`CLASSES`].
    pub fn index(self) -> usize {
        self.light as usize + if self.mirrored { CLASSES / 2 } else { 0 }
    }

    /// The pattern of its words.
    pub fn word(self) -> &'static str {
        const WORDS: [&str; CLASSES] = [
            "EL",
            "EDL",
            "EDD⁺L",
            "EDS⁺L",
            "ED(D|S)*L, the rest",
            "ES⁺L",
            "ES⁺DL",
            "ES⁺DD⁺L",
            "ES⁺DS⁺L",
            "ES⁺D(D|S)*L, the rest",
        ];
        WORDS[self.index()]
    }

    /// What it is, in plain words.
    pub fn name(self) -> &'static str {
        const NAMES: [&str; CLASSES] = [
            "lamps and sky",
            "diffuse, straight from the lamps",
            "diffuse, reflected diffusely",
            "diffuse, from the lamps by mirrors and glass",
            "diffuse, reflected with mirrors and glass between",
            "lamps and sky, mirrored",
            "mirrored diffuse, straight from the lamps",
            "mirrored diffuse, reflected diffusely",
            "mirrored diffuse, from the lamps by mirrors and glass",
            "mirrored diffuse, reflected with mirrors and glass between",
        ];
        NAMES[self.index()]
    }

    // ANCHOR: owner
    /// The pass that carries it; each class has one, the border being the first D.
    pub fn owner(self) -> Owner {
        match (self.mirrored, self.light) {
            (_, Light::Lamp) => Owner::Second,
            (false, _) => Owner::First,
            (true, _) => Owner::Both,
        }
    }
    // ANCHOR_END: owner
}

/// How many classes there are.
pub const CLASSES: usize = 10;

/// The word of a path so far, read from the eye: as much of it as tells its class.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Word {
    /// An S before the first D?
    mirrored: bool,
    /// How many D: none, one, or more.
    diffuse: u8,
    /// An S after the first D?
    passed_on: bool,
}

impl Word {
    /// The word with one more letter.
    // ANCHOR: then
    pub fn then(self, letter: Letter) -> Word {
        let mut word = self;
        match letter {
            Letter::D => word.diffuse = (self.diffuse + 1).min(2),
            Letter::S if self.diffuse == 0 => word.mirrored = true,
            Letter::S => word.passed_on = true,
        }
        word
    }
    // ANCHOR_END: then

    /// The class of the word if it ends here, in a lamp or in the sky.
    // ANCHOR: class
    pub fn class(self) -> Class {
        let light = match (self.diffuse, self.passed_on) {
            (0, _) => Light::Lamp,
            (1, false) => Light::Direct,
            (1, true) => Light::Caustic,
            (_, false) => Light::Reflected,
            (_, true) => Light::Mixed,
        };
        Class { mirrored: self.mirrored, light }
    }
    // ANCHOR_END: class
}

/// Light by class.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Mean radiance of a picture, in W/(m² sr), by [`Class::index`].
    pub mean: [Rgb; CLASSES],
    /// Its standard error; 0 where it was not drawn by chance.
    pub error: [Rgb; CLASSES],
    /// The weight of what was cut where rays went on too long, in the mean over the picture:
    /// times the largest radiance of the scene it bounds what the table lacks.
    pub cut: Rgb,
}

/// A line of a [`Table`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassRow {
    /// Whose light.
    pub class: Class,
    /// Its mean over the picture.
    pub mean: Rgb,
    /// The standard error of the mean.
    pub error: Rgb,
}

impl Table {
    /// The lines, one for each class.
    pub fn rows(&self) -> impl Iterator<Item = ClassRow> + '_ {
        let row = |class: Class| {
            let k = class.index();
            ClassRow { class, mean: self.mean[k], error: self.error[k] }
        };
        Class::all().map(row)
    }

    /// All classes together: the mean of the picture.
    pub fn total(&self) -> Rgb {
        self.mean.iter().copied().sum()
    }
}
