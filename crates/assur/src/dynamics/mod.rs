//! Motion of a differential with magnetic couplings under load: load angles, slip and torque over time.
//!
//! # The model
//!
//! Four bodies turn by the angles φ₁ (sun), φ₂ (each of k satellites, all alike), φ₃ (carrier), φ₄ (ring). Nothing
//! touches: sun and satellites, satellites and ring are coupled by magnet plates. With p₁, p₂, p₄ periods of the
//! field per turn of a wheel (its plates where like poles all face outward, half of them where poles alternate) a
//! mesh depends on its *phase* alone,
//!
//! δₛ = p₁(φ₁ − φ₃) + p₂(φ₂ − φ₃),  δᵣ = p₂(φ₂ − φ₃) − p₄(φ₄ − φ₃),
//!
//! which stays as it is where wheels turn as Willis' formula has them. The Lagrangian is
//!
//! L = ½J₁φ̇₁² + ½kJ₂φ̇₂² + ½(J₃ + kma²)φ̇₃² + ½J₄φ̇₄² − kEₛ(1 − cos δₛ) − kEᵣ(1 − cos δᵣ),  Eₛ = Tₛ/p₁, Eᵣ = Tᵣ/p₄,
//!
//! with m the mass of a satellite, a the radius of the circle of its centre, and T the greatest torque of one
//! satellite on the central wheel. So that wheel is turned by T sin(pΔ), Δ its angle from where it is without a
//! load, and the torques on both wheels and the carrier, of one potential, sum up to nothing. Friction comes from
//! Rayleigh's function ½c₁φ̇₁² + ½kc₂(φ̇₂ − φ̇₃)² + ½c₃φ̇₃² + ½c₄φ̇₄² + ½kdₛ(δ̇ₛ/p₁)² + ½kdᵣ(δ̇ᵣ/p₄)² (bearings and eddy
//! currents), loads and drives are torques on the bodies.
//!
//! A torque that goes with the sine of the relative angle is the usual model of a synchronous coupling (the first
//! harmonic of the field; E. P. Furlani, *Permanent Magnet and Electromechanical Devices*, 2001, has it for magnetic
//! couplings); the source paper on the differential (Mukhametzyanov and others) gives none. Whether a mesh runs
//! synchronously, is pulled out, slips or is caught again follows from these equations: there is no threshold in
//! them. How wheels of so many plates are to be placed is no matter of this module, but of [`crate::gears`].
//!
//! [`Parameters`] as they are given make a [`Differential`], which is sound; a [`Run`] of it is advanced tick by tick.

mod body;
mod defect;
mod differential;
mod equations;
mod gauss;
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
