//! The reciprocating-rotational mixer: a crank-rocker whose rocker carries wheel
//! 4, which drives wheel 5, or several wheels around it (Smelyagin and Prikhodko,
//! fig. 1 and 4).

mod contours;
mod drag;
mod motion;
mod spec;
mod tracer;

use std::f64::consts::PI;

pub use drag::{Dragged, Joint};
pub use motion::Unmoved;
pub use tracer::{Carrier, Tracer};

use crate::gears::{GearSet, Mate, Mesh};
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
            z4,
            wheels: vec![Mate {
                teeth: z5,
                centre_line: -2.0 * PI / 9.0,
            }],
            mesh: Mesh::External,
            module: 0.0165,
            assembly: Assembly::First,
            tracers: Vec::new(),
        }
    }
}

/// The free dimensions of a mixer, valid or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimensions {
    /// l₁ … l₄: crank, coupler, rocker, frame.
    pub lengths: [f64; 4],
    /// z₄, of the wheel on the rocker's shaft.
    pub z4: f64,
    /// The peripheral wheels around it: wheel 5, 6, …, each with its direction
    /// from the shaft of wheel 4.
    pub wheels: Vec<Mate>,
    /// How the wheels engage.
    pub mesh: Mesh,
    /// Module of the wheels, in the unit of the lengths.
    pub module: f64,
    /// The assembly of the loop.
    pub assembly: Assembly,
    /// The traced points P₁, P₂, …
    pub tracers: Vec<Tracer>,
}

/// A mixer that can move.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixer {
    /// The linkage.
    pub linkage: FourBar,
    /// The assembly of its loop.
    pub assembly: Assembly,
    /// Wheel 4, which turns with the rocker, and wheels 5, 6, … around it.
    pub gears: GearSet,
    /// The traced points; their wheels exist.
    tracers: Vec<Tracer>,
}

impl Mixer {
    /// The mixer with these dimensions.
    ///
    /// # Errors
    /// All invalid dimensions at once.
    pub fn new(dimensions: &Dimensions) -> Result<Self, Vec<Invalid>> {
        let linkage = FourBar::new(dimensions.lengths);
        let gears = GearSet::new(
            dimensions.z4,
            &dimensions.wheels,
            dimensions.mesh,
            dimensions.module,
        );
        let tracers = tracer::check(&dimensions.tracers, dimensions.wheels.len());
        match (linkage, gears, tracers) {
            (Ok(linkage), Ok(gears), Ok(())) => Ok(Self {
                linkage,
                assembly: dimensions.assembly,
                gears,
                tracers: dimensions.tracers.clone(),
            }),
            (linkage, gears, tracers) => {
                let reasons = [linkage.err(), gears.err(), tracers.err()];
                Err(reasons.into_iter().flatten().flatten().collect())
            }
        }
    }
}
