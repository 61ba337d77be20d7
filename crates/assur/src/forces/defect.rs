//! Defects of a loading, with the thing at fault.

/// Part of a loading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(rename_all = "snake_case")
)]
pub enum Part {
    /// Gravity.
    Gravity,
    /// A load.
    Load,
    /// A spring.
    Spring,
    /// A damper.
    Damper,
    /// Friction of a pair.
    Friction,
    /// The motor.
    Motor,
    /// The flywheel.
    Flywheel,
}

/// A defect of a loading. A part is named by its kind and its index in its list, from 0.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "code", rename_all = "snake_case")
)]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum Defect {
    /// A part on a link that does not exist.
    OnNoLink {
        part: Part,
        index: usize,
        name: String,
    },
    /// A part at a point that its link does not have.
    OnNoPoint {
        part: Part,
        index: usize,
        link: String,
        point: String,
    },
    /// A part with a number that is not finite, is out of range, or is negative where it must not be; or with a table
    /// out of order.
    NoNumber { part: Part, index: usize },
    /// A spring or damper between two points of one body, or between a link and itself: it does nothing.
    Idle { part: Part, index: usize },
    /// Friction at a point without a hinge, or of a link that does not slide.
    NoPair { index: usize, name: String },
    /// Friction of a pair that has friction from an earlier entry.
    RubsTwice { index: usize, name: String },
    /// A flywheel on a linkage whose first driver is no crank.
    NoCrank,
}
