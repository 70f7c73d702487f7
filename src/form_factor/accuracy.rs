//! How far a number may be off.

/// How far a form factor may be off. A plain number is [`Accuracy::Absolute`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// By rounding, as far as the method goes.
    Best,
    /// By so much, positive; no unit, as the factor has none.
    Absolute(f64),
}

impl Accuracy {
    /// The error that is allowed: positive, and hardly so for [`Accuracy::Best`].
    pub(super) fn allowed(self) -> f64 {
        match self {
            Accuracy::Best => f64::MIN_POSITIVE,
            Accuracy::Absolute(error) => {
                debug_assert!(error > 0.0, "the error must be positive: {error}");
                error
            }
        }
    }
}

impl From<f64> for Accuracy {
    fn from(error: f64) -> Accuracy {
        Accuracy::Absolute(error)
    }
}
