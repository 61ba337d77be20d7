//! Forces in a linkage: reactions and balancing torques, reduced quantities, motion under load.
//!
//! Units are consistent: lengths in that of the drawing, masses in any one unit, time in any one; so with metres,
//! kilograms and seconds forces are in newtons. Torques are positive counter-clockwise. The reaction *on* a link *from*
//! another is the force that the other exerts on it. Inertia forces are −m a at the centre of mass and −J α.
//!
//! | file | subject |
//! |---|---|
//! | `spec`, `law` | gravity, loads, springs and dampers as a person gives them, valid or not |
//! | `defect` | the reasons why they are refused |
//! | `masses` | masses of links and of bodies |
//! | `loading` | the same for a mechanism: masses of bodies, forces at places of bodies |
//! | `names` | the links, points and pairs that a loading names |
//! | `applied` | the forces and couples in a pose that are not reactions |
//! | `pair` | the wrenches that a pair can transmit |
//! | `block` | equilibrium of a driver, a dyad or any group, solved for the components of its pairs |
//! | `kinetostatics`, `reactions` | reactions of all pairs and balancing torques of all drivers in a pose |
//! | `free_body` | all forces and couples on a body |
//! | `equilibrium` | the equations of a body in senses of a student's choice, and the judgement of answers |
//! | `plan` | force plans, group by group, as constructed by hand |
//! | `lever` | Zhukovsky's lever: the turned plan of velocities with the forces on it |
//! | `friction` | dry friction in hinges and slides, efficiency, self-locking |
//! | `shaking` | shaking force and moment, counterweights of a four-bar |
//! | `under_load` | motion under load, the steady cycle and its flywheels |
//!
//! A body stands for a link with the links that are fixed to it; its reactions are those of all of them together.

mod applied;
mod block;
mod defect;
mod equilibrium;
mod free_body;
mod friction;
mod kinetostatics;
mod law;
mod lever;
mod loading;
mod masses;
mod names;
mod pair;
mod plan;
mod reactions;
#[cfg(test)]
mod samples;
mod shaking;
mod spec;
mod under_load;

pub use applied::{Applied, Source};
pub use defect::{Defect, Part};
pub use equilibrium::{Addend, Judged};
pub use free_body::{Acting, Cause};
pub use friction::Rubbing;
pub use kinetostatics::{Kinetostatics, Unbalanced};
pub use law::{Harmonic, Law};
pub use lever::{Lever, LeverTerm};
pub use loading::Loading;
pub use masses::LinkMass;
pub use pair::{DriverId, Pair, PairId};
pub use plan::{Component, ForceName, ForcePlan, PlanStep, StepKind, Term};
pub use reactions::{Reaction, Reactions};
pub use shaking::{Counterweight, counterweights};
pub use spec::{AnchorSpec, DamperSpec, FrictionSpec, LoadSpec, LoadingSpec, SpringSpec};
pub use under_load::{
    Actuator, Blocked, CyclePoint, Diagram, DiagramPoint, Halt, LagrangeReading, LagrangeRun,
    MAX_NON_UNIFORMITY, Mertsalov, Motor, NoCycle, NoRun, Reading, Reduced, Run, SteadyCycle,
    Wittenbauer,
};
