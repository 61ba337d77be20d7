//! Neighbours of a linkage: a dimension is set a little differently, in the same assembly, at an input nearby. Larger
//! changes go from neighbour to neighbour.

use std::collections::BTreeSet;

use crate::Point;
use crate::index::{LinkId, List, PointId, SlideId, StepId};
use crate::linkage::spec::{Defect, LinkageSpec};
use crate::mechanism::plan::Drawn;
use crate::mechanism::plan::body::Bodies;
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::{Mechanism, Pose};
use crate::position::{Cause, Sign, State, Step};

/// A change of a linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setting {
    /// Place of a point on a link; the point is given by its index there.
    Place(LinkId, usize, Point),
    /// Place of a hinge of the frame.
    Hinge(PointId, Point),
    /// Distance of the point of a slide to the left of its line.
    Offset(SlideId, f64),
}

/// A linkage assembled at an input, with a specification drawn in that pose.
#[derive(Clone, Debug)]
pub(crate) struct Assembled {
    mechanism: Mechanism,
    state: State<1>,
    /// For each step, the side on which its links are joined: ±1.
    sides: List<StepId, f64>,
}

/// Links that come apart on the way to a neighbour.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LoopOpen {
    pub(crate) step: StepId,
    pub(crate) links: Vec<LinkId>,
    pub(crate) cause: Cause,
}

/// The reason why there is no neighbour.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NoNeighbour {
    /// Its links cannot be joined.
    LoopOpen(LoopOpen),
    /// With this setting it is no mechanism, in any assembly.
    Defects(Vec<Defect>),
}

/// Maximum turn, radians, and displacement, relative to the size, of the bodies of a neighbour.
const NEAR: f64 = 0.2;
/// Maximum ratio of the second to the first correction of Newton's method at which it converges to the continuation
/// of the last solution: P. Deuflhard, *Newton Methods for Nonlinear Problems*, 2004, section 5.1.
const CONTRACTION: f64 = 0.125;
/// Maximum length of the first correction, relative to the size.
const CORRECTED: f64 = 0.03;
/// Maximum factor by which the determinant of a group's Jacobian may change: two solutions that are about to meet
/// are not confused.
const CHANGED: f64 = 2.0;

impl Assembled {
    /// A mechanism in one of its poses, with a shape for every link.
    pub(crate) fn new(
        mechanism: &Mechanism,
        pose: &Pose<1>,
        input: f64,
    ) -> Result<Self, NoNeighbour> {
        let spec = mechanism.shaped_in(pose);
        let orientations = &pose.state.orientations();
        let drawn = Drawn {
            input,
            orientations,
        };
        let mut joined = mechanism.laid_out(&spec, None, drawn, input)?;
        let state = joined.join(None).map_err(NoNeighbour::LoopOpen)?;
        Ok(joined.joined(state))
    }

    /// The linkage drawn in its pose.
    pub(crate) fn spec(&self) -> &LinkageSpec {
        &self.mechanism.spec
    }

    pub(crate) fn input(&self) -> f64 {
        self.mechanism.drawn_input
    }

    /// Span of its input: a turn, or the range of a slide.
    pub(crate) fn span(&self) -> f64 {
        self.mechanism.span()
    }

    /// Margin of a step: distance of its links from being in line, or from a singular pose; to be compared with that of
    /// its neighbours.
    pub(crate) fn margin(&self, step: StepId) -> f64 {
        let [p, q] = self.state.margins[step].map(|margin| margin.value());
        match self.mechanism.steps[step] {
            // The logarithm of the determinant.
            Step::Group(_) => p.abs().log2() + q,
            _ => p.abs().min(q.abs()),
        }
    }

    /// The neighbour with this setting, at an input.
    ///
    /// # Errors
    /// The links that come apart, or would move farther than those of a neighbour; or the defects of the mechanism.
    pub(crate) fn neighbour(&self, setting: Setting, input: f64) -> Result<Self, NoNeighbour> {
        let spec = match setting {
            Setting::Place(link, point, at) => self.mechanism.placed(link, point, at),
            Setting::Hinge(..) | Setting::Offset(..) => self.mechanism.spec.clone(),
        };
        let drawn = Drawn {
            input: self.mechanism.drawn_input,
            orientations: &self.state.orientations(),
        };
        let mut next = self
            .mechanism
            .laid_out(&spec, Some(setting), drawn, input)?;
        let state = next.join(Some(&self.sides));
        let state = state.map_err(NoNeighbour::LoopOpen)?;
        if let Some(step) = next.lost(&self.state, &state) {
            return Err(NoNeighbour::LoopOpen(next.apart(step, Cause::DeadPoint)));
        }
        Ok(next.joined(state))
    }
}

impl Mechanism {
    /// The linkage drawn in a pose, with a shape for every link.
    pub(crate) fn shaped_in(&self, pose: &Pose<1>) -> LinkageSpec {
        let mut spec = self.spec.shaped();
        spec.points = self.drawn_in(pose).points;
        spec
    }

    /// The mechanism of a specification drawn in a known pose, with a setting that differs from the drawing, before
    /// assembly at an input.
    fn laid_out(
        &self,
        spec: &LinkageSpec,
        setting: Option<Setting>,
        drawn: Drawn<'_>,
        input: f64,
    ) -> Result<Self, NoNeighbour> {
        let laid_out = || {
            let resolved = Resolved::new(spec).map_err(|defect| vec![defect])?;
            // Links cease to be one body if a dimension is changed on one of them and kept by another, or by the frame.
            let (before, after) = (&self.doubled, &resolved.doubled);
            if before != after {
                let parted = before.iter().filter(|one| !after.contains(one));
                let joined = after.iter().filter(|one| !before.contains(one));
                let links: BTreeSet<&str> = parted
                    .chain(joined)
                    .map(|one| self.link_name(one.link))
                    .collect();
                return Err(vec![Defect::Locked {
                    mobility: self.counts.mobility,
                    links: links.into_iter().map(str::to_owned).collect(),
                }]);
            }
            let hinge = match setting {
                Some(Setting::Hinge(point, at)) => Some((point, at.coords - resolved.origin)),
                _ => None,
            };
            let bodies = Bodies::new(&resolved, hinge);
            let (mut bodies, placements) = bodies.map_err(|defect| vec![defect])?;
            if let Some(Setting::Offset(slide, off)) = setting {
                bodies.slides[slide].set_offset(off);
            }
            let structure = self.solved_by.clone();
            let parallel = &self.parallel;
            Self::of(
                &resolved,
                &bodies,
                &placements,
                structure,
                parallel,
                Some(drawn),
            )
        };
        let mut mechanism = laid_out().map_err(NoNeighbour::Defects)?;
        mechanism.drawn_input = input;
        Ok(mechanism)
    }

    /// Joins the links on these sides, or else as drawn.
    fn join(&mut self, sides: Option<&List<StepId, f64>>) -> Result<State<1>, LoopOpen> {
        let mut state = self.blank_state();
        for step in self.steps.ids() {
            let side = sides.map(|sides| sides[step]);
            let kept = side.and_then(|side| {
                let mut both = Sign::BOTH.into_iter();
                both.find(|sign| self.side(step, *sign, &state) == side)
            });
            let sign = match kept {
                Some(sign) => Ok(sign),
                None => self.drawn_sign(step, &mut state),
            };
            let solved = sign.and_then(|sign| {
                self.signs[step] = sign;
                self.try_step(step, sign, &mut state)
            });
            solved.map_err(|cause| self.apart(step, cause))?;
        }
        Ok(state)
    }

    /// Side on which a sign joins the links of a step.
    fn side(&self, step: StepId, sign: Sign, state: &State<1>) -> f64 {
        let four_bar = self.steps[step].four_bar();
        four_bar.map_or(sign.factor(), |four_bar| four_bar.side(sign, state))
    }

    /// A step whose links moved farther than those of a neighbour.
    fn lost(&self, before: &State<1>, state: &State<1>) -> Option<StepId> {
        let moved = self.moved(before, state, NEAR);
        if let Some(body) = moved {
            debug_assert!(self.placed_by[body].is_some(), "the frame does not move");
            return self.placed_by[body];
        }
        let [first, second] = state.corrections;
        let far = first > CORRECTED || second > CONTRACTION * first.max(1e-9);
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
            // Pivoting may have left out other redundant equations.
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

    /// The linkage assembled in a state.
    fn joined(mut self, state: State<1>) -> Assembled {
        let sides = self.steps.ids();
        let sides = sides.map(|step| self.side(step, self.signs[step], &state));
        let sides = sides.collect();
        self.spec = self.drawn_by(&state);
        Assembled {
            mechanism: self,
            state,
            sides,
        }
    }
}
