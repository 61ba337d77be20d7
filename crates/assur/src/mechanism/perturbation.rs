//! Neighbours of a linkage: linkages with one dimension slightly changed, in the same assembly at a nearby input. A
//! larger change is made from neighbour to neighbour.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::Point;
use crate::index::{LinkId, List, PointId, SlideId, StepId};
use crate::linkage::spec::{Defect, LinkageSpec};
use crate::mechanism::plan::Drawn;
use crate::mechanism::plan::body::RigidBodies;
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::{Configuration, Layout, Mechanism, Pose};
use crate::position::{Cause, Mounting, Sign, State, Step};
use crate::tolerance;

/// A change of a linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setting {
    /// Position of a point on a link; the point is given by its index on the link.
    Place(LinkId, usize, Point),
    /// Position of a hinge of the frame.
    Hinge(PointId, Point),
    /// Distance of the point of a slide from its line, positive to the left.
    Offset(SlideId, f64),
}

/// Linkage assembled at an input, and its specification drawn in the assembled pose.
#[derive(Clone, Debug)]
pub(crate) struct Assembled {
    layout: Arc<Layout>,
    spec: LinkageSpec,
    input: f64,
    state: State<1>,
    /// Side on which each step joins its links: ±1.
    sides: List<StepId, f64>,
}

/// Links that come apart before a neighbour is reached.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LoopOpen {
    pub(crate) step: StepId,
    pub(crate) links: Vec<LinkId>,
    pub(crate) cause: Cause,
}

/// The reason why there is no neighbour.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NoNeighbour {
    /// Links of the neighbour cannot be joined.
    LoopOpen(LoopOpen),
    /// The neighbour is not a mechanism in any assembly.
    Defects(Vec<Defect>),
}

/// Maximum turn of a body between neighbours, radians; also its maximum displacement, in sizes of the linkage.
const MAX_CHANGE: f64 = 0.2;
/// Maximum ratio of the second Newton correction to the first. Up to this ratio Newton's method converges to the
/// continuation of the last solution: P. Deuflhard, *Newton Methods for Nonlinear Problems*, 2004, section 5.1.
const CONTRACTION: f64 = 0.125;
/// Maximum first Newton correction, in units of the unknowns.
const CORRECTED: f64 = 0.03;
/// Maximum factor by which the Jacobian determinant of a group may change. The determinant tends to zero where two
/// solutions meet, so with this limit one solution is not taken for the other.
const CHANGED: f64 = 2.0;

impl Assembled {
    /// A mechanism in one of its poses, with a shape for every link.
    pub(crate) fn new(
        mechanism: &Mechanism,
        pose: &Pose<1>,
        input: f64,
    ) -> Result<Self, NoNeighbour> {
        let drawn = Drawn {
            input,
            orientations: &pose.state.orientations(),
        };
        let spec = mechanism.shaped_in(pose);
        Self::joined(&mechanism.layout, spec, None, drawn, input, None)
    }

    /// Assembles a specification at an input, with one setting that differs from the drawing. Each step joins its links
    /// on the given side or, if neither sign of the square root in its closed form gives this side, as drawn.
    fn joined(
        before: &Layout,
        mut spec: LinkageSpec,
        setting: Option<Setting>,
        drawn: Drawn<'_>,
        input: f64,
        sides: Option<&List<StepId, f64>>,
    ) -> Result<Self, NoNeighbour> {
        let planned = before.with_setting(&spec, setting, drawn);
        let (layout, guess) = planned.map_err(NoNeighbour::Defects)?;
        let mut at = Configuration { input, ..guess };
        let state = layout.join(&spec, &mut at, sides);
        let state = state.map_err(NoNeighbour::LoopOpen)?;
        let steps = layout.steps.ids();
        let sides = steps.map(|step| layout.side(step, at.signs[step], &at.mounting, &state));
        let sides = sides.collect();
        layout.draw(&mut spec, &state);
        Ok(Self {
            layout: Arc::new(layout),
            spec,
            input,
            state,
            sides,
        })
    }

    pub(crate) fn spec(&self) -> &LinkageSpec {
        &self.spec
    }

    pub(crate) fn input(&self) -> f64 {
        self.input
    }

    pub(crate) fn span(&self) -> f64 {
        self.layout.span()
    }

    /// Measure of the distance of a step from a pose with links in line or from another singular pose. Its values for a
    /// mechanism and for its neighbours can be compared.
    pub(crate) fn margin(&self, step: StepId) -> f64 {
        let [p, q] = self.state.margins[step].map(|margin| margin.value());
        match self.layout.steps[step] {
            // The binary logarithm of the magnitude of the Jacobian's determinant.
            Step::Group(_) => p.abs().log2() + q,
            _ => p.abs().min(q.abs()),
        }
    }

    /// Makes the neighbour of this linkage that has a given setting, in the same assembly at a nearby input.
    ///
    /// # Errors
    /// The links that come apart or would move too far; or the defects, if the changed linkage is not a mechanism.
    pub(crate) fn neighbour(&self, setting: Setting, input: f64) -> Result<Self, NoNeighbour> {
        let spec = match setting {
            Setting::Place(link, point, at) => self.layout.placed(&self.spec, link, point, at),
            Setting::Hinge(..) | Setting::Offset(..) => self.spec.clone(),
        };
        let drawn = Drawn {
            input: self.input,
            orientations: &self.state.orientations(),
        };
        let sides = Some(&self.sides);
        let next = Self::joined(&self.layout, spec, Some(setting), drawn, input, sides)?;
        match next.layout.lost(&self.state, &next.state) {
            Some(step) => {
                let open = next.layout.apart(step, Cause::DeadPoint);
                Err(NoNeighbour::LoopOpen(open))
            }
            None => Ok(next),
        }
    }
}

impl Mechanism {
    /// The linkage drawn in a pose, with a shape for every link.
    pub(crate) fn shaped_in(&self, pose: &Pose<1>) -> LinkageSpec {
        let mut spec = self.spec.shaped();
        spec.points = self.drawn_in(pose).points;
        spec
    }
}

impl Layout {
    /// Layout of a linkage drawn in a known pose, with one setting that differs from the drawing, and the configuration
    /// before assembly.
    fn with_setting(
        &self,
        spec: &LinkageSpec,
        setting: Option<Setting>,
        drawn: Drawn<'_>,
    ) -> Result<(Self, Configuration), Vec<Defect>> {
        let (resolved, mut rigid) = Resolved::new(spec).map_err(|defect| vec![defect])?;
        // Two links cease to be one body if a dimension changes on only one of them. One of the two may be the frame.
        let (before, after) = (&self.doubled, &resolved.doubled);
        if before != after {
            let parted = before.iter().filter(|one| !after.contains(one));
            let joined = after.iter().filter(|one| !before.contains(one));
            let links: BTreeSet<&str> = parted
                .chain(joined)
                .map(|one| spec.name_of(Some(one.link)))
                .collect();
            return Err(vec![Defect::Locked {
                mobility: self.counts().mobility,
                links: links.into_iter().map(str::to_owned).collect(),
            }]);
        }
        if let Some(Setting::Hinge(point, at)) = setting {
            let hinge = Some((point, at.coords - resolved.origin));
            rigid = RigidBodies::new(&resolved, hinge).map_err(|defect| vec![defect])?;
        }
        let bodies = rigid.joined(&resolved);
        let (mut bodies, placements) = bodies.map_err(|defect| vec![defect])?;
        if let Some(Setting::Offset(slide, off)) = setting {
            bodies.slides[slide].set_offset(off);
        }
        let (structure, parallel) = (self.structure.clone(), &self.parallel);
        Self::new(
            &resolved,
            bodies,
            &placements,
            structure,
            parallel,
            Some(drawn),
        )
    }

    /// Joins the links of each step on its given side or, if neither sign of the square root gives this side, as drawn.
    fn join(
        &self,
        spec: &LinkageSpec,
        at: &mut Configuration,
        sides: Option<&List<StepId, f64>>,
    ) -> Result<State<1>, LoopOpen> {
        let mut state = self.blank_state();
        for step in self.steps.ids() {
            let side = sides.map(|sides| sides[step]);
            let kept = side.and_then(|side| {
                let mut both = Sign::BOTH.into_iter();
                both.find(|sign| self.side(step, *sign, &at.mounting, &state) == side)
            });
            let sign = match kept {
                Some(sign) => Ok(sign),
                None => self.drawn_sign(spec, step, at, &mut state),
            };
            let solved = sign.and_then(|sign| {
                at.signs[step] = sign;
                self.try_step(step, sign, at, &mut state)
            });
            solved.map_err(|cause| self.apart(step, cause))?;
        }
        Ok(state)
    }

    /// Side on which a sign of the root joins the links of a step.
    fn side(&self, step: StepId, sign: Sign, mounting: &Mounting, state: &State<1>) -> f64 {
        let four_bar = self.steps[step].four_bar();
        four_bar.map_or(sign.factor(), |four_bar| {
            four_bar.side(sign, mounting, state)
        })
    }

    /// A step whose links moved too far for a neighbour, or whose links may be in another assembly; None if there is no
    /// such step.
    fn lost(&self, before: &State<1>, state: &State<1>) -> Option<StepId> {
        let moved = self.moved(before, state, MAX_CHANGE);
        if let Some(body) = moved {
            debug_assert!(self.placed_by[body].is_some(), "the frame does not move");
            return self.placed_by[body];
        }
        let [first, second] = state.corrections;
        let far = first > CORRECTED || second > CONTRACTION * first.max(tolerance::COINCIDENT);
        let mut groups = self
            .steps
            .enumerate()
            .filter_map(|(step, placing)| match placing {
                Step::Group(group) => Some((step, group)),
                _ => None,
            });
        let lost = groups.find(|(step, group)| {
            let margins = [before, state].map(|state| state.margins[*step]);
            let [[a, of_a], [b, of_b]] = margins.map(|both| both.map(|margin| margin.value()));
            // Pivoting may drop different equations of a redundant group; its determinants are then not comparable.
            let ratio = b / a * (of_b - of_a).exp2();
            let changed = !group.is_redundant() && !(1.0 / CHANGED..=CHANGED).contains(&ratio);
            far || changed
        });
        lost.map(|(step, _)| step)
    }

    fn apart(&self, step: StepId, cause: Cause) -> LoopOpen {
        let bodies = self.steps[step].bodies().into_iter();
        let links = bodies.filter_map(|body| self.made_for[body]).collect();
        LoopOpen { step, links, cause }
    }
}
