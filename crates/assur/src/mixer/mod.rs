//! The reciprocating-rotational mixer: a crank-rocker whose rocker carries wheel 4. This wheel drives wheel 5, or
//! several wheels around wheel 4 (Smelyagin and Prikhodko, fig. 1 and 4). The mixer moves as the linkage made in
//! `spec`.

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

/// The three cases of fig. 4, with the length l₃ of the rocker and the gear ratio u.
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
    /// All cases, in the order of the figure.
    pub const ALL: [Self; 3] = [Self::A, Self::B, Self::C];

    /// Dimensions of the case, lengths in metres. The paper gives the lengths and u; the numbers of teeth, the module
    /// and the centre line are chosen here.
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

/// The independent dimensions of a mixer, valid or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimensions {
    /// Lengths l₁ … l₄ of crank, coupler, rocker and frame.
    pub lengths: [f64; 4],
    /// Number of teeth z₄ of wheel 4, which is on the rocker's shaft.
    pub z4: f64,
    /// Wheels 5, 6, … around wheel 4, each with the direction of its centre from the shaft of wheel 4.
    pub wheels: Vec<Mate>,
    /// Mesh of wheel 4 with each of the other wheels.
    pub mesh: Mesh,
    /// Module of the wheels, in the unit of `lengths`.
    pub module: f64,
    /// Assembly of the four-bar.
    pub assembly: Assembly,
    /// The traced points P₁, P₂, …
    pub tracers: Vec<Tracer>,
}

/// A mixer that can move.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixer {
    /// The four-bar.
    pub linkage: FourBar,
    /// Assembly of the four-bar.
    pub assembly: Assembly,
    /// Wheel 4, which turns with the rocker, and wheels 5, 6, … around wheel 4.
    pub gears: GearSet,
    /// The traced points; every wheel that carries a point exists.
    tracers: Vec<Tracer>,
}

impl Mixer {
    /// Makes a mixer with these dimensions.
    ///
    /// # Errors
    /// Every invalid dimension.
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
