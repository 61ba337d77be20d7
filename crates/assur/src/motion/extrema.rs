//! Extrema of the derivatives of an angle over the motion of a four-bar.

use super::{Input, features};
use crate::{Assembly, FourBar, Jet, Pose};

/// Maximum or minimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A local maximum.
    Max,
    /// A local minimum.
    Min,
}

/// A local extremum of a quantity or a derivative of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremum {
    /// Maximum or minimum.
    pub kind: Kind,
    /// φ₁.
    pub crank: f64,
    /// The extreme value.
    pub value: f64,
}

impl Extremum {
    /// The extremum of what turns `ratio` times as fast: a negative ratio makes a
    /// minimum of a maximum.
    pub fn scaled(self, ratio: f64) -> Self {
        let kind = match (self.kind, ratio < 0.0) {
            (kind, false) => kind,
            (Kind::Max, true) => Kind::Min,
            (Kind::Min, true) => Kind::Max,
        };
        Self {
            kind,
            crank: self.crank,
            value: self.value * ratio,
        }
    }
}

/// The local extrema of φ′ and of φ″ of an angle of the linkage over its cycle,
/// each in ascending crank angle; `angle` picks the link.
///
/// Each is a root of the next derivative, see [`features`].
pub fn extrema(
    linkage: &FourBar,
    assembly: Assembly,
    angle: impl Fn(&Pose<5>) -> Jet<5>,
) -> [Vec<Extremum>; 2] {
    let motion = |crank: f64| Some(vec![angle(&linkage.pose(assembly, crank).ok()?)]);
    let found = features(&linkage.cycle(), &motion, &[1.0], Input::ANALOGUES);
    let mut orders = found.into_iter().flatten().map(|features| features.extrema);
    let _value = orders.next();
    [(); 2].map(|()| orders.next().unwrap_or_default())
}
