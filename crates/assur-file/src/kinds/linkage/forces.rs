//! Saved gravity, loads, springs, dampers and motor of a linkage.

mod convert;
mod names;

pub use convert::ForceUnits;
use serde::{Deserialize, Serialize};

/// A load: a force, a torque or a resistance.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct LoadDocument {
    /// The link on which the load acts.
    pub link: String,
    /// The point at which a force or resistance acts; without a point it is a torque.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<String>,
    /// Force, N, or torque, N·m, the same at every input.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Force or torque linear between knots: inputs (degrees of a crank, or the unit of lengths) and values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<[f64; 2]>>,
    /// Force or torque as a sum of harmonics of the input.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub terms: Option<Vec<HarmonicDocument>>,
    /// Direction of the force, degrees from the x-axis, or from the link's direction if it turns with the link.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction_deg: Option<f64>,
    /// True if the force turns with the link.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub turns: bool,
    /// Resistance (k₁ + k₂|v|)v to the velocity of the point, or to the angular velocity: k₁ and k₂ in SI units.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resistance: Option<[f64; 2]>,
}

/// Harmonic A cos(kφ − α) of the input φ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct HarmonicDocument {
    /// Amplitude A, in the unit of the value.
    pub amplitude: f64,
    /// Order k: of the angle of a crank, or of the travel of a slide in the unit of lengths.
    pub order: f64,
    /// Phase α, degrees; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase_deg: Option<f64>,
}

/// A point of a link.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct AnchorDocument {
    /// The link, or `frame`.
    pub link: String,
    /// One of its points.
    pub point: String,
}

/// A spring between two points or two links.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct SpringDocument {
    /// The points of its two ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ends: Option<[AnchorDocument; 2]>,
    /// The links between which it acts on their relative angle, if it has no ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub links: Option<[String; 2]>,
    /// Stiffness: N/m, or N·m per radian.
    pub stiffness: f64,
    /// Length without load, in the unit of lengths; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_length: Option<f64>,
    /// Angle of the first link relative to the second without load, degrees; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_angle_deg: Option<f64>,
}

/// A damper between two points or two links.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct DamperDocument {
    /// The points of its two ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ends: Option<[AnchorDocument; 2]>,
    /// The links between which it acts on their relative angular velocity, if it has no ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub links: Option<[String; 2]>,
    /// Damping coefficient: N·s/m, or N·m·s.
    pub damping: f64,
}

/// Dry friction in the hinges at a point, or in the slides of a link.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct FrictionDocument {
    /// The point of the hinges.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hinge: Option<String>,
    /// The link that slides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slide: Option<String>,
    /// Coefficient of friction.
    pub coefficient: f64,
    /// Radius of the pin of a hinge, in the unit of lengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// Length of the block of a slide along the line, in the unit of lengths, if known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
}

/// The motor of a driver: its torque in N·m by the speed of the crank in rad/s. If a slide is driven, its force
/// in N by the speed in units of length per second.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct MotorDocument {
    /// Torque of a motor with the same torque at every speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torque: Option<f64>,
    /// Torque at rest of a motor whose torque is linear in the speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stall: Option<f64>,
    /// Speed without load of such a motor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_load: Option<f64>,
    /// Pull-out torque of an induction motor, by Kloss's formula.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pull_out: Option<f64>,
    /// Slip of such a motor at the pull-out torque.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slip: Option<f64>,
    /// Synchronous speed of such a motor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub synchronous: Option<f64>,
    /// Torque linear between knots: speeds and torques.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<[f64; 2]>>,
}
