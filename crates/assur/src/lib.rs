//! The engine of Assur: positions of planar mechanisms with exact derivatives.
//!
//! Conventions, everywhere in this crate: x to the right, y up, angles
//! counter-clockwise in radians, lengths in any one unit. The input is the
//! crank angle φ₁; a derivative is by φ₁ (an *analogue*: φ′ of the velocity,
//! φ″ of the acceleration), never by time. Angles are continuous along a
//! motion, never folded into (−π, π]. Only [`dynamics`] has a time, and derivatives by it.
//!
//! The crate is pure: no serialisation, screen, clock, I/O or randomness. Bad
//! input is an [`Invalid`] that names the dimension at fault; an angle at which
//! there is no pose is an [`Unsolved`] that says why. Nothing panics and no NaN
//! leaves. Numbers of links and points come from a [`mechanism::Mechanism`] and are
//! of use with that one: only one of another mechanism could be out of range.
//!
//! | module | subject |
//! |---|---|
//! | [`linkage`], [`structure`], [`mechanism`], [`motion`] | any linkage: its specification, Assur groups, poses, the motion of one branch |
//! | `position` | dyads in closed form, groups by Newton's method, certified steps, all assemblies of a group |
//! | [`circuits`], [`polygons`], [`centres`], [`curvature`] | branches over a turn; velocity and acceleration polygons; instant centres; circles of curvature |
//! | `four_bar` ([`FourBar`]), [`gears`], [`mixer`] | four-bars in closed form; gear pairs and epicyclic trains; the mixer |
//! | [`mobility`], [`synthesis`], [`dynamics`] | mobility and redundant constraints; four-bars from positions, dwell; a differential with magnetic couplings under load |
//! | `combined_method`, `relation` | the equations of the source papers in numbers, as printed and as they hold |
//! | `jet`, `geometry`, `index`, `numeric` | derivatives; points and vectors; typed ids; roots, linear equations, whole turns, levels of tolerance |
//!
//! ```
//! use assur::{Assembly, FourBar};
//!
//! let linkage = FourBar::new([0.37, 0.85, 0.55, 0.85]).unwrap(); // l₁ … l₄, fig. 4a
//! let pose = linkage.pose::<3>(Assembly::First, 1.0).unwrap();
//! assert!((pose.rocker.value() - 1.2500).abs() < 1e-4); // φ₃
//! assert!((pose.rocker.derivative(1) - 0.5448).abs() < 1e-4); // φ₃′
//! ```

pub mod centres;
pub mod circuits;
mod combined_method;
pub mod curvature;
pub mod dynamics;
mod four_bar;
pub mod gears;
mod geometry;
mod index;
mod invalid;
mod jet;
pub mod linkage;
pub mod mechanism;
pub mod mixer;
pub mod mobility;
pub mod motion;
mod numeric;
pub mod polygons;
mod position;
mod relation;
pub mod sorting;
pub mod structure;
pub mod synthesis;

use numeric::{angle, tolerance};

pub use angle::Angle;
pub use combined_method::CombinedMethod;
pub use four_bar::{
    Assembly, ChangePoint, Cycle, FourBar, Grashof, Limit, Link, Offset, Pose, Swing, Unsolved,
};
pub use geometry::{JetPoint, Point, Vector, nearest, perpendicular};
pub use invalid::{Dimension, Fault, Invalid};
pub use jet::Jet;
pub use relation::Relation;
