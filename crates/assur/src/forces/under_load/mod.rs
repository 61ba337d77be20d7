//! Motion of a linkage under its loads: of one freedom, or of several.
//!
//! | file | subject |
//! |---|---|
//! | `reduced` | moment of inertia and torque reduced to the input; energies |
//! | `motor` | the torque of a motor by its speed |
//! | `system`, `run` | the linkage as a system of one freedom; motion of the input in time |
//! | `lagrange`, `actuator`, `lagrange_run`, `lagrange_reading` | Lagrange's equations of several freedoms; their drives; their motion in time |
//! | `balance` | the work of the loads over a cycle, and the rate at which a drive does it |
//! | `cycle`, `along` | the steady cycle: motion that repeats with the linkage |
//! | `diagram`, `flywheel` | Wittenbauer's diagram; the flywheel for a wanted non-uniformity |

mod actuator;
mod along;
mod balance;
mod cycle;
mod diagram;
mod flywheel;
mod lagrange;
mod lagrange_reading;
mod lagrange_run;
mod motor;
mod reduced;
mod run;
mod system;

pub use actuator::Actuator;
pub use cycle::{CyclePoint, NoCycle, SteadyCycle};
pub use diagram::{Diagram, DiagramPoint};
pub use flywheel::{MAX_NON_UNIFORMITY, Mertsalov, Wittenbauer};
pub use lagrange_reading::{Blocked, LagrangeReading};
pub use lagrange_run::LagrangeRun;
pub use motor::Motor;
pub use reduced::Reduced;
pub use run::{Halt, NoRun, Reading, Run};
