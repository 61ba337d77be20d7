//! Any planar linkage: links with points, hinges, slides, gears, a driver.
//!
//! A [`LinkageSpec`] need not be valid; a [`Mechanism`] can always be assembled, because only [`Mechanism::new`] makes
//! one. It is solved group by group, in the order found by [`crate::structure`].

mod assembled;
mod assemblies;
mod assembly;
mod closed;
mod counts;
mod dimension;
mod names;
mod perturbation;
mod plan;
mod pose;
mod rate;
mod readout;
mod redundant;
mod repeated;
mod signed;
mod solve;
mod tracer;

use std::f64::consts::TAU;

pub(crate) use assemblies::Found;
pub use assemblies::{Assemblies, Following};
pub(crate) use assembly::AssemblySigns;
pub(crate) use closed::{DrivenFourBar, half_turns};
pub use counts::Counts;
pub use dimension::Dimension;
pub(crate) use perturbation::{Assembled, LoopOpen, NoNeighbour, Setting};
pub use plan::doubled::DoubledLink;
pub use pose::{Pose, Unsolved};
pub(crate) use rate::NEVER;
pub(crate) use readout::arms_of;
pub use readout::{
    Constraint, ConstraintKind, FourBarLoop, Joint, LinkOrFrame, Multiple, OuterJoint, Quantity,
    RrpDyad, RrrDyad, Sides,
};
pub use redundant::Mobility;
pub use signed::SignedAssemblies;

pub use crate::index::{BodyId, LinkId, PointId, SlideId, StepId};
pub use crate::position::{Cause, Method, Singularity};

pub use crate::linkage::{
    Defect, DriverSpec, FARTHEST, FRAME, GearSpec, LinkSpec, LinkageSpec, PointSpec, SlideSpec,
    TracerSpec,
};

use crate::index::{Id, List};
use crate::linkage::check;
use crate::position::{
    Arm, BodyPoint, Enclosure, Nearby, Orientation, Predictor, Sign, State, Step, StepContext,
};
use crate::structure::Structure;
use crate::{Jet, Vector};
use plan::body::{Bodies, Placement};
use plan::resolved::Resolved;
use plan::slide::Slide;
use plan::{Drawn, structured};
use readout::constraint;

/// A linkage that can be assembled as it is drawn.
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
    spec: LinkageSpec,
    /// Origin of the coordinates used while solving.
    origin: Vector,
    points: List<PointId, BodyPoint>,
    links: List<LinkId, Part>,
    /// The link of each body (None for the frame), and its points with their places on the body.
    made_for: List<BodyId, LinkOrFrame>,
    bodies: List<BodyId, Vec<(PointId, Vector)>>,
    /// The structure with passive links as separate steps; and the one used for solving, with them inside their groups.
    structure: Structure,
    solved_by: Structure,
    /// Bodies of groups with redundant constraints that stay parallel to another body.
    parallel: Vec<[BodyId; 2]>,
    steps: List<StepId, Step>,
    /// RRR dyads inside groups with redundant constraints, found by removing their passive links.
    within: Vec<[Arm; 2]>,
    /// The step that places each body; None for the frame.
    placed_by: List<BodyId, Option<StepId>>,
    constraints: Vec<Constraint>,
    counts: Counts,
    doubled: Vec<DoubledLink>,
    /// Offset of each slide: distance of its point to the left of its line.
    offsets: List<SlideId, f64>,
    /// For each gear coupling, true if it is passive.
    passive: Vec<bool>,
    size: f64,
    range: Option<[f64; 2]>,
    /// Turns of the crank until all drivers and visible wheels are back; None for a driven slide, or if a driver does
    /// not return.
    period_turns: Option<usize>,
    /// Turns until the assemblies repeat; wheels that carry nothing do not count.
    turns_of_assemblies: Option<usize>,
    /// The drawn pose: the input, the assembly signs, the orientations of the bodies, and the unknowns of groups solved
    /// by Newton's method.
    drawn_input: f64,
    signs: AssemblySigns,
    orientations: List<BodyId, Orientation>,
    natural: Vec<f64>,
    /// The input and pose from which the motion is followed: the drawn ones, or ones just beside them if the drawn pose
    /// is singular.
    start: (f64, Predictor),
}

/// A moving link, or a part fixed to one.
#[derive(Clone, Debug)]
struct Part {
    body: BodyId,
    /// Offset of its angle from its body's.
    angle_offset: f64,
    points: Vec<PointId>,
}

impl Mechanism {
    /// The mechanism of a specification, in the drawn pose.
    ///
    /// # Errors
    /// All defects, with the names of the parts at fault.
    pub fn new(spec: &LinkageSpec) -> Result<Self, Vec<Defect>> {
        let defects = check::defects(spec);
        if !defects.is_empty() {
            return Err(defects);
        }
        let resolved = Resolved::new(spec).map_err(|defect| vec![defect])?;
        let (bodies, placements) = Bodies::new(&resolved, None).map_err(|defect| vec![defect])?;
        let (structure, redundancy) = structured::structured(&resolved, &bodies)?;
        let of = |parallel: &[[BodyId; 2]]| {
            let structure = structure.clone();
            Self::of(&resolved, &bodies, &placements, structure, parallel, None)
        };
        let mut mechanism = of(&[])?;
        if let Some(redundancy) = &redundancy {
            let parallel = mechanism.parallel();
            let settled = parallel.and_then(|parallel| {
                mechanism = of(&parallel).ok()?;
                mechanism.settle().ok()
            });
            settled.ok_or_else(|| mechanism.locked(redundancy))?;
        } else {
            mechanism.settle().map_err(|defects| {
                let beyond = plan::driver::drawn_beyond_range(&resolved, &bodies);
                if beyond.is_empty() { defects } else { beyond }
            })?;
        }
        let parts = constraint::Parts {
            spec: &resolved,
            bodies: &bodies,
            placements: &placements,
            orientations: &mechanism.orientations,
        };
        mechanism.constraints = parts.constraints();
        if let Some(redundancy) = redundancy {
            mechanism.structure = mechanism
                .shown(&redundancy)
                .ok_or_else(|| mechanism.locked(&redundancy))?;
            let without = mechanism.structure.without_passive_links();
            let plan = plan::plan(&resolved, &bodies, &placements, &without, &[], None);
            let plan = plan.map(|plan| plan.steps).unwrap_or_default();
            let known = |arms: &&[Arm; 2]| mechanism.arms().any(|own| own == *arms);
            let arms = plan.iter().filter_map(arms_of);
            mechanism.within = arms.filter(|arms| !known(arms)).cloned().collect();
        }
        Ok(mechanism)
    }

    /// The mechanism of a specification without surplus constraints, before assembly, with its bodies and the
    /// placements of its links.
    fn planned(
        resolved: &Resolved<'_>,
    ) -> Result<(Self, Bodies, List<LinkId, Placement>), Vec<Defect>> {
        let (bodies, placements) = Bodies::new(resolved, None).map_err(|defect| vec![defect])?;
        let (structure, redundancy) = structured::structured(resolved, &bodies)?;
        if let Some(redundancy) = redundancy {
            return Err(redundancy.defects);
        }
        let mechanism = Self::of(resolved, &bodies, &placements, structure, &[], None)?;
        Ok((mechanism, bodies, placements))
    }

    /// The mechanism before its assembly is found. If the drawn pose is known, angles have its whole turns.
    fn of(
        resolved: &Resolved<'_>,
        bodies: &Bodies,
        placements: &List<LinkId, Placement>,
        structure: Structure,
        parallel: &[[BodyId; 2]],
        drawn: Option<Drawn<'_>>,
    ) -> Result<Self, Vec<Defect>> {
        let period_turns = rate::period_turns(resolved)?;
        let plan = plan::plan(resolved, bodies, placements, &structure, parallel, drawn);
        let plan = plan.map_err(|defect| vec![defect])?;
        let points = resolved.places.enumerate().map(|(point, at)| {
            // A point of no link stays where it is drawn.
            let still = || BodyPoint {
                body: BodyId::FRAME,
                local: *at,
            };
            bodies.anchor_of(point, |_| true).unwrap_or_else(still)
        });
        let points = points.chain(tracer::anchored(resolved, bodies, placements));
        let links = placements.iter().zip(resolved.links.iter());
        let links = links.map(|(placement, link)| Part {
            body: placement.body,
            angle_offset: placement.angle_offset,
            points: link.points.clone(),
        });
        let mut placed_by = resolved.bodies.same_len(None);
        for (step, placing) in plan.steps.enumerate() {
            for body in placing.bodies() {
                placed_by[body] = Some(step);
            }
        }
        let unknowns = plan.natural.len() / 2;
        let size = resolved.spec.size();
        let blank = State::new(placed_by.len(), plan.steps.len(), unknowns, size);
        let mut mechanism = Self {
            spec: resolved.spec.clone(),
            origin: resolved.origin,
            points: points.collect(),
            links: links.collect(),
            made_for: resolved.bodies.clone(),
            bodies: bodies.ids().map(|body| bodies.of(body).to_vec()).collect(),
            solved_by: structure.clone(),
            structure,
            parallel: parallel.to_vec(),
            signs: plan.steps.same_len(Sign::Plus),
            steps: plan.steps,
            within: Vec::new(),
            placed_by,
            constraints: Vec::new(),
            counts: counts::counts(resolved, bodies),
            offsets: bodies.slides.iter().map(Slide::offset).collect(),
            doubled: resolved.doubled.clone(),
            passive: bodies.passive.clone(),
            size,
            range: plan.range,
            period_turns,
            turns_of_assemblies: period_turns,
            drawn_input: plan.drawn_input,
            start: (plan.drawn_input, blank),
            orientations: plan.orientations,
            natural: plan.natural,
        };
        mechanism.count_turns_of_wheels();
        Ok(mechanism)
    }
}
