//! Gravity, loads, springs and dampers as a person gives them, valid or not. Links and points are named.

use super::Law;
use crate::Vector;

/// What acts on a linkage, besides its drivers and its own masses. [`super::Loading::new`] refuses what is invalid.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadingSpec {
    /// Acceleration of free fall, x and y; zero without gravity.
    pub gravity: Vector,
    /// Loads.
    pub loads: Vec<LoadSpec>,
    /// Springs.
    pub springs: Vec<SpringSpec>,
    /// Dampers.
    pub dampers: Vec<DamperSpec>,
    /// Friction in hinges and slides.
    pub friction: Vec<FrictionSpec>,
    /// Moment of inertia of a flywheel on the crank of the first driver; zero without one.
    pub flywheel: f64,
}

impl Default for LoadingSpec {
    /// Nothing but the inertia of the links.
    fn default() -> Self {
        Self {
            gravity: Vector::zeros(),
            loads: Vec::new(),
            springs: Vec::new(),
            dampers: Vec::new(),
            friction: Vec::new(),
            flywheel: 0.0,
        }
    }
}

/// A point of a link, or of the frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnchorSpec {
    /// Name of the link, or that of the frame.
    pub link: String,
    /// Name of a point or tracer of the link.
    pub point: String,
}

impl AnchorSpec {
    /// A named point of a named link.
    pub fn new(link: &str, point: &str) -> Self {
        let (link, point) = (link.to_owned(), point.to_owned());
        Self { link, point }
    }
}

/// A load: a given force or torque, or a resistance that depends on the velocity.
#[derive(Clone, Debug, PartialEq)]
pub enum LoadSpec {
    /// Force at a point of a link.
    Force {
        /// Point at which the force acts.
        at: AnchorSpec,
        /// Direction of the force, radians: from the x-axis, or from the link's direction if the force turns with it.
        direction: f64,
        /// True if the force turns with the link.
        turns: bool,
        /// Magnitude; a negative value reverses the force.
        law: Law,
    },
    /// Torque on a link, positive counter-clockwise.
    Torque {
        /// Name of the link.
        link: String,
        /// Torque.
        law: Law,
    },
    /// Resistance to the velocity v of a point of a link: the force −(k₁ + k₂|v|) v.
    Drag {
        /// Point at which the resistance acts.
        at: AnchorSpec,
        /// Coefficients k₁ and k₂. Negative ones drive the point instead.
        coefficients: [f64; 2],
    },
    /// Resistance to the angular velocity ω of a link: the torque −(k₁ + k₂|ω|) ω.
    AngularDrag {
        /// Name of the link.
        link: String,
        /// Coefficients k₁ and k₂. Negative ones drive the link instead.
        coefficients: [f64; 2],
    },
}

/// A spring.
#[derive(Clone, Debug, PartialEq)]
pub enum SpringSpec {
    /// Spring between two points. It pulls them together with the force k(l − l₀) at the length l.
    Straight {
        /// Points of the two ends.
        ends: [AnchorSpec; 2],
        /// Stiffness k; zero or more.
        stiffness: f64,
        /// Length l₀ without load; zero or more.
        free_length: f64,
    },
    /// Spring between two links. It exerts the torque −k(θ − θ₀) on the first at its angle θ relative to the second.
    Torsion {
        /// Names of the links.
        links: [String; 2],
        /// Stiffness k, per radian; zero or more.
        stiffness: f64,
        /// Relative angle θ₀ without load, radians.
        free_angle: f64,
    },
}

/// A damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperSpec {
    /// Damper between two points. It pulls them together with the force c l̇ at the rate l̇ of its length.
    Straight {
        /// Points of the two ends.
        ends: [AnchorSpec; 2],
        /// Damping coefficient c; zero or more.
        damping: f64,
    },
    /// Damper between two links. It exerts the torque −c ω on the first at its angular velocity ω relative to the
    /// second.
    Torsion {
        /// Names of the links.
        links: [String; 2],
        /// Damping coefficient c; zero or more.
        damping: f64,
    },
}

/// Dry friction in pairs.
#[derive(Clone, Debug, PartialEq)]
pub enum FrictionSpec {
    /// Friction in all hinges at a point.
    Hinge {
        /// Name of the point.
        point: String,
        /// Coefficient of friction.
        coefficient: f64,
        /// Radius of the pin.
        radius: f64,
    },
    /// Friction in all slides of a link.
    Slide {
        /// Name of the sliding link.
        link: String,
        /// Coefficient of friction.
        coefficient: f64,
        /// Length of the block along the line, if known: the block then bears on both ends where the line of the
        /// reaction passes it.
        length: Option<f64>,
    },
}
