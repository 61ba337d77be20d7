//! Any planar linkage: links joined by hinges, slides and gears, with drivers.
//!
//! A [`LinkageSpec`] need not be valid. A [`Mechanism`] can be assembled as drawn, because [`Mechanism::new`] refuses
//! other specifications. A mechanism is solved group by group, in the order found by [`crate::structure`].

mod assembled_by_dimensions;
mod assemblies;
mod closed;
mod configuration;
mod counts;
mod dimension;
mod drawn_assembly;
mod layout;
mod names;
mod numbered_by_signs;
mod perturbation;
mod plan;
mod pose;
mod rate;
mod readout;
mod redundant;
mod repeated;
mod solve;
mod tracer;

use std::f64::consts::TAU;
use std::sync::Arc;

pub(crate) use assemblies::Found;
pub use assemblies::{Assemblies, Following};
pub(crate) use closed::{DrivenFourBar, half_turns};
pub(crate) use configuration::{AssemblySigns, Configuration};
pub use counts::Counts;
pub use dimension::Dimension;
pub(crate) use layout::Layout;
pub use numbered_by_signs::SignedAssemblies;
pub(crate) use perturbation::{Assembled, LoopOpen, NoNeighbour, Setting};
pub use plan::doubled::DoubledLink;
pub use pose::{Pose, Unsolved};
pub(crate) use rate::MAX_PERIOD;
pub(crate) use rate::NEVER;
pub use readout::{
    Constraint, ConstraintKind, FourBarLoop, Joint, LinkOrFrame, Multiple, OuterJoint, Quantity,
    RrpDyad, RrrDyad, Sides,
};
pub(crate) use readout::{Contact, Guide, arms_of};
pub use redundant::Mobility;
pub(crate) use solve::solve_steps;

pub use crate::index::{BodyId, LinkId, PointId, SlideId, StepId};
pub use crate::position::{Cause, Method, Singularity};

pub use crate::linkage::{
    Defect, DriverSpec, FARTHEST, FRAME, GearSpec, LinkSpec, LinkageSpec, PointSpec, SlideSpec,
    TracerSpec,
};

use crate::index::{Id, List};
use crate::linkage::check;
use crate::position::{
    Arm, BodyPoint, Enclosure, Mounting, Nearby, Orientation, Predictor, Sign, State, Step,
    StepContext,
};
use crate::structure::Structure;
use crate::{Jet, Point, Vector};
use layout::{Part, PassiveLinks};
use plan::body::{Bodies, Placement};
use plan::resolved::Resolved;
use plan::{Drawn, structured};

/// A linkage that can be assembled as drawn: a layout in its drawn configuration.
///
/// A clone shares the layout and the specification; only the configuration is copied.
///
/// ```
/// # use assur::{linkage::LinkageSpec, mechanism::Mechanism};
/// # let slider_crank = LinkageSpec::default()
/// #     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
/// #     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
/// #     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
/// let mechanism = Mechanism::new(&slider_crank).unwrap();
/// assert_eq!(mechanism.counts().mobility, 1);
/// assert_eq!(mechanism.structure().class(), 2);
/// ```
#[derive(Clone, Debug)]
pub struct Mechanism {
    layout: Arc<Layout>,
    /// The specification as drawn in this configuration.
    spec: Arc<LinkageSpec>,
    drawn: Configuration,
    start: Start,
}

/// Input and pose from which the motion is followed: those of the drawing or, if the drawn pose is singular, an input
/// and pose nearby. If a closed form gives the motion, the pose is not used and may be invalid.
#[derive(Clone, Debug)]
struct Start {
    input: f64,
    pose: Arc<Predictor>,
}

impl Mechanism {
    /// The mechanism of a specification, in the drawn pose.
    ///
    /// # Errors
    /// Defects, with the names of the parts at fault. Geometry and structure are checked only if names and numbers have
    /// no defect.
    pub fn new(spec: &LinkageSpec) -> Result<Self, Vec<Defect>> {
        let defects = check::defects(spec);
        if !defects.is_empty() {
            return Err(defects);
        }
        let (resolved, rigid) = Resolved::new(spec).map_err(|defect| vec![defect])?;
        let (bodies, placements) = rigid.joined(&resolved).map_err(|defect| vec![defect])?;
        let (structure, redundancy) = structured::structured(&resolved, &bodies)?;
        let (mut layout, guess) =
            Layout::new(&resolved, bodies, &placements, structure, &[], None)?;
        let (drawn, start) = match redundancy {
            Some(redundancy) => {
                layout.settle_redundant(&resolved, &placements, guess, &redundancy)?
            }
            None => layout.settle(spec, guess).map_err(|defects| {
                let beyond = plan::driver::drawn_beyond_range(&resolved, &layout.bodies);
                if beyond.is_empty() { defects } else { beyond }
            })?,
        };
        layout.mounted.clone_from(&drawn.orientations);
        Ok(Self {
            layout: Arc::new(layout),
            spec: Arc::new(spec.clone()),
            drawn,
            start,
        })
    }
}
