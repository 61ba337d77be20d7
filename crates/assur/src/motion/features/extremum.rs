//! A local extremum of a quantity over a motion.

/// Maximum or minimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A local maximum.
    Max,
    /// A local minimum.
    Min,
}

/// A local extremum of a quantity or of one of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremum {
    /// Maximum or minimum.
    pub kind: Kind,
    /// Input of the extremum.
    pub input: f64,
    /// The extreme value.
    pub value: f64,
}

impl Extremum {
    /// Extremum of the quantity multiplied by `ratio`: a negative ratio turns a maximum into a minimum.
    pub fn scaled(self, ratio: f64) -> Self {
        let kind = match (self.kind, ratio < 0.0) {
            (kind, false) => kind,
            (Kind::Max, true) => Kind::Min,
            (Kind::Min, true) => Kind::Max,
        };
        Self {
            kind,
            input: self.input,
            value: self.value * ratio,
        }
    }
}
