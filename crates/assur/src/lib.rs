//! The engine of Assur: positions of planar mechanisms with exact derivatives.
//!
//! Conventions throughout this crate: x to the right, y up, angles counter-clockwise in radians, lengths in any one
//! unit. The input is the coordinate of the first driver, usually the crank angle φ₁. Derivatives are with respect to
//! the input, not to time: φ′ is the *analogue* of the velocity, φ″ of the acceleration. Angles are continuous along a
//! motion and are not reduced to (−π, π]. Only [`dynamics`], [`forces`] and [`gears::train`] follow a motion over time.
//!
//! The crate is pure: no screen, clock, I/O or randomness. An error names the invalid dimension ([`Invalid`]), or gives
//! the reason why there is no pose at an input ([`Unsolved`] for a four-bar). Nothing panics or returns NaN, provided
//! that ids of links and points are used only with the [`mechanism::Mechanism`] that gave them: the id of another
//! mechanism may be out of range.
//!
//! | module | subject |
//! |---|---|
//! | [`linkage`], [`structure`], [`mechanism`], [`motion`] | any linkage: its specification, Assur groups, poses, the motion of one branch |
//! | `position` | dyads in closed form, groups by Newton's method, certified steps, all assemblies of a group |
//! | [`circuits`], [`polygons`], [`centres`], [`curvature`] | branches over a turn; velocity and acceleration polygons; instant centres; circles of curvature |
//! | `four_bar` ([`FourBar`]), [`gears`], [`mixer`] | four-bars in closed form; gear pairs and epicyclic trains; the mixer |
//! | [`mobility`], [`synthesis`] | mobility and redundant constraints; four-bars from given positions, cognates, linkages for given poses of a body or a given path, linkages with a dwell |
//! | [`forces`], [`dynamics`] | reactions and motion under load; a differential with magnetic couplings under load |
//! | `combined_method`, `relation` | equations of the source papers, evaluated as printed and as corrected |
//! | `jet`, `geometry`, `index`, `sorting`, `numeric` | derivatives; points and vectors; typed ids; sorting; roots, linear equations, whole turns, levels of tolerance |
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
pub mod forces;
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
