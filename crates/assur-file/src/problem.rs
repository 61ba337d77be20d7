//! Everything that can be wrong with what a person, a file or an address gives,
//! as a code with parameters. The words are in `lang/`.

use assur::{Dimension, Fault, Invalid, Link, Unsolved};
use serde::Serialize;

/// A problem; serialised as `{"code": "…", parameters}`. Angles in radians.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum Problem {
    /// A field holds NaN or an infinity.
    NotANumber { field: &'static str },
    /// A field must be greater than zero.
    NotPositive { field: &'static str, value: f64 },
    /// A field is outside its range.
    OutOfRange {
        field: &'static str,
        value: f64,
        min: f64,
        max: f64,
    },
    /// A field must be a whole number.
    NotWhole { field: &'static str, value: f64 },
    /// A field holds none of the values it may have.
    UnknownChoice { field: &'static str },
    /// In true time a crank that stands still shows nothing.
    AtRest { field: &'static str },
    /// A link is at least as long as the others together.
    TooLong { field: &'static str, by: f64 },
    /// Internal mesh of equal wheels.
    ConcentricWheels,
    /// Coupler and rocker together do not reach at this crank angle.
    Apart { phi: f64, by: f64 },
    /// One of coupler and rocker is too long at this crank angle.
    Inside {
        phi: f64,
        by: f64,
        field: &'static str,
    },
    /// The pose at this crank angle is undetermined.
    Undetermined { phi: f64 },
    /// The derivatives at this crank angle are unbounded.
    DeadPoint { phi: f64 },
    /// The text or object has not the form of a state.
    BadState { path: String, detail: String },
}

impl From<Invalid> for Problem {
    fn from(invalid: Invalid) -> Self {
        let field = field(invalid.dimension);
        match invalid.fault {
            Fault::NotFinite => Self::NotANumber { field },
            Fault::NotPositive { value } => Self::NotPositive { field, value },
            Fault::OutOfRange { value, min, max } => Self::OutOfRange {
                field,
                value,
                min,
                max,
            },
            Fault::NotWhole { value } => Self::NotWhole { field, value },
            Fault::TooLong { by } => Self::TooLong { field, by },
            Fault::Concentric => Self::ConcentricWheels,
        }
    }
}

impl From<Unsolved> for Problem {
    fn from(unsolved: Unsolved) -> Self {
        match unsolved {
            Unsolved::NotAnAngle => Self::NotANumber { field: "phi_deg" },
            Unsolved::Apart { crank, by } => Self::Apart { phi: crank, by },
            Unsolved::Inside { crank, by, longer } => Self::Inside {
                phi: crank,
                by,
                field: link_field(longer),
            },
            Unsolved::Undetermined { crank } => Self::Undetermined { phi: crank },
            Unsolved::DeadPoint { crank } => Self::DeadPoint { phi: crank },
        }
    }
}

/// The saved name of a dimension.
fn field(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Crank => "l1",
        Dimension::Coupler => "l2",
        Dimension::Rocker => "l3",
        Dimension::Frame => "l4",
        Dimension::DriverTeeth => "z4",
        Dimension::DrivenTeeth => "z5",
        Dimension::Module => "module",
        Dimension::CentreLine => "centre_line_deg",
    }
}

/// The saved name of a link's length.
fn link_field(link: Link) -> &'static str {
    match link {
        Link::Crank => "l1",
        Link::Coupler => "l2",
        Link::Rocker => "l3",
        Link::Frame => "l4",
    }
}
