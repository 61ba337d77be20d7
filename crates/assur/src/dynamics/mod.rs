//! Motion of a differential with magnetic couplings under load: load angles, slip and torque over time.
//!
//! # The model
//!
//! Four bodies turn through the angles φ₁ (sun), φ₂ (each of k satellites, all alike), φ₃ (carrier), φ₄ (ring). The
//! wheels do not touch: magnet plates couple the satellites to the sun and to the ring. Let p₁, p₂, p₄ be the numbers
//! of periods of the field per turn of sun, satellite and ring: the number of plates if like poles all face outward,
//! half of it if poles alternate. The potential of a mesh depends only on its *phase*,
//!
//! δₛ = p₁(φ₁ − φ₃) + p₂(φ₂ − φ₃),  δᵣ = p₂(φ₂ − φ₃) − p₄(φ₄ − φ₃),
//!
//! Both phases are constant if the wheels turn by Willis's equation. The Lagrangian is
//!
//! L = ½J₁φ̇₁² + ½kJ₂φ̇₂² + ½(J₃ + kma²)φ̇₃² + ½J₄φ̇₄² − kEₛ(1 − cos δₛ) − kEᵣ(1 − cos δᵣ),  Eₛ = Tₛ/p₁, Eᵣ = Tᵣ/p₄,
//!
//! with J the moments of inertia, m the mass of a satellite, a the radius of the circle of its centre, and Tₛ and Tᵣ
//! the maximum torques of one satellite on sun and ring. One satellite exerts on the sun a torque of magnitude
//! Tₛ sin(p₁Δ), with Δ the sun's angle from the unloaded position; for the ring read Tᵣ and p₄. The torques of a mesh
//! on both wheels and the carrier follow from one potential and sum to zero. Friction (bearings and eddy currents)
//! follows from Rayleigh's function ½c₁φ̇₁² + ½kc₂(φ̇₂ − φ̇₃)² + ½c₃φ̇₃² + ½c₄φ̇₄² + ½kdₛ(δ̇ₛ/p₁)² + ½kdᵣ(δ̇ᵣ/p₄)².
//! Loads and drives are torques on the bodies.
//!
//! A torque proportional to the sine of the relative angle, from the first harmonic of the field, is the usual model of
//! a synchronous coupling; for magnetic couplings see E. P. Furlani, *Permanent Magnet and Electromechanical Devices*,
//! 2001. The source paper on the differential (Mukhametzyanov and others) gives no model. Synchronous running,
//! pull-out, slip and recapture of a mesh follow from these equations, without thresholds. The mounting of the wheels
//! is treated in [`crate::gears`].
//!
//! Valid [`Parameters`] make a [`Differential`]. A [`Run`] of the differential is advanced tick by tick.

mod body;
mod defect;
mod differential;
mod equations;
mod parameters;
mod profile;
mod reading;
mod recording;
mod run;
mod stiffness;

pub use crate::gears::train::Shaft;
pub use body::{Body, Mesh};
pub use defect::{Defect, Quantity};
pub use differential::Differential;
pub use parameters::{Coupling, Drive, Driven, Load, Parameters, Plates, Poles, Satellites};
pub use profile::{Profile, ProfileFault};
pub use reading::{BodyReading, Energy, MeshReading, Reading};
pub use recording::Recording;
pub use run::{Halt, Run, Start, TICKS_PER_SECOND};
