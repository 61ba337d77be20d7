//! The reciprocating-rotational mixer: a crank-rocker whose rocker carries wheel
//! 4, which drives wheel 5 (Smelyagin and Prikhodko, fig. 1 and 4).

mod drag;
mod quantity;

use std::f64::consts::PI;

pub use drag::{Dragged, Joint};
pub use quantity::{Axis, Quantity, Tracked, Turning};

use crate::gears::{GearPair, Mesh};
use crate::{Assembly, FourBar, Invalid};

/// The three cases of fig. 4. Lengths are in metres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// l₃ = 0.55 m, u = 2.
    A,
    /// l₃ = 1.00 m, u = 2.
    B,
    /// l₃ = 0.55 m, u = 0.5.
    C,
}

impl Case {
    /// All, in the order of the figure.
    pub const ALL: [Self; 3] = [Self::A, Self::B, Self::C];

    /// The dimensions of the case. The paper prints lengths and u; the numbers
    /// of teeth, the module and the centre line are ours.
    pub fn dimensions(self) -> Dimensions {
        let [rocker, z4, z5] = match self {
            Self::A => [0.55, 36.0, 18.0],
            Self::B => [1.0, 36.0, 18.0],
            Self::C => [0.55, 18.0, 36.0],
        };
        Dimensions {
            lengths: [0.37, 0.85, rocker, 0.85],
            teeth: [z4, z5],
            mesh: Mesh::External,
            module: 0.0165,
            centre_line: -2.0 * PI / 9.0,
            assembly: Assembly::First,
        }
    }
}

/// The free dimensions of a mixer, sound or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensions {
    /// l₁ … l₄: crank, coupler, rocker, frame.
    pub lengths: [f64; 4],
    /// z₄ on the rocker's shaft and z₅.
    pub teeth: [f64; 2],
    /// How the wheels engage.
    pub mesh: Mesh,
    /// Module of the wheels, in the unit of the lengths.
    pub module: f64,
    /// Direction from the shaft of wheel 4 to that of wheel 5, radians.
    pub centre_line: f64,
    /// Which way the loop is closed.
    pub assembly: Assembly,
}

/// A mixer that can move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixer {
    /// The linkage.
    pub linkage: FourBar,
    /// Which way its loop is closed.
    pub assembly: Assembly,
    /// Wheel 4, which turns with the rocker, and wheel 5.
    pub gears: GearPair,
}

impl Mixer {
    /// The mixer with these dimensions.
    ///
    /// # Errors
    /// Every reason why they make none, at once.
    pub fn new(dimensions: &Dimensions) -> Result<Self, Vec<Invalid>> {
        let linkage = FourBar::new(dimensions.lengths);
        let gears = GearPair::new(
            dimensions.teeth,
            dimensions.mesh,
            dimensions.module,
            dimensions.centre_line,
        );
        match (linkage, gears) {
            (Ok(linkage), Ok(gears)) => Ok(Self {
                linkage,
                assembly: dimensions.assembly,
                gears,
            }),
            (linkage, gears) => {
                let reasons = [linkage.err(), gears.err()];
                Err(reasons.into_iter().flatten().flatten().collect())
            }
        }
    }
}
