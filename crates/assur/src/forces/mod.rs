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
//! | `friction`, `coulomb`, `bearing` | dry friction in hinges and slides, efficiency, self-locking; Coulomb's law for all pairs together; the sides on which a block bears |
//! | `moving_friction` | friction where the drive is given and the acceleration is not |
//! | `shaking` | shaking force and moment, counterweights of a four-bar |
//! | `reduced` | moment of inertia and torque reduced to the input; energies |
//! | `motor` | the torque of a motor by its speed |
//! | `system`, `run` | the linkage as a system of one freedom; motion of the input in time |
//! | `balance` | the work of the loads over a cycle, and the rate at which a drive does it |
//! | `cycle`, `along` | the steady cycle: motion that repeats with the linkage |
//! | `diagram`, `flywheel` | Wittenbauer's diagram; the flywheel for a wanted non-uniformity |
//!
//! A body stands for a link with the links that are fixed to it; its reactions are those of all of them together.

mod along;
mod applied;
mod balance;
mod bearing;
mod block;
mod coulomb;
mod cycle;
mod defect;
mod diagram;
mod equilibrium;
mod flywheel;
mod free_body;
mod friction;
mod kinetostatics;
mod law;
mod lever;
mod loading;
mod masses;
mod motor;
mod moving_friction;
mod names;
mod pair;
mod plan;
mod reactions;
mod reduced;
mod run;
#[cfg(test)]
mod samples;
mod shaking;
mod spec;
mod system;

pub use applied::{Applied, Source};
pub use cycle::{CyclePoint, NoCycle, SteadyCycle};
pub use defect::{Defect, Part};
pub use diagram::{Diagram, DiagramPoint};
pub use equilibrium::{Addend, Judged};
pub use flywheel::{MAX_NON_UNIFORMITY, Mertsalov, Wittenbauer};
pub use free_body::{Acting, Cause};
pub use friction::Rubbing;
pub use kinetostatics::{Kinetostatics, Unbalanced};
pub use law::{Harmonic, Law};
pub use lever::{Lever, LeverTerm};
pub use loading::Loading;
pub use masses::LinkMass;
pub use motor::Motor;
pub use pair::{DriverId, Pair, PairId};
pub use plan::{Component, ForceName, ForcePlan, PlanStep, StepKind, Term};
pub use reactions::{Reaction, Reactions};
pub use reduced::Reduced;
pub use run::{Halt, NoRun, Reading, Run};
pub use shaking::{Counterweight, counterweights};
pub use spec::{AnchorSpec, DamperSpec, FrictionSpec, LoadSpec, LoadingSpec, SpringSpec};
