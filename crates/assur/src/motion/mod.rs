//! Motion of a mechanism: the branch of poses that contains the drawn pose, followed by continuity. Quantities, dead
//! points, extrema, profiles and tables are found over the motion.

mod change;
mod closed_form;
mod continuation;
mod cyclogram;
mod dead_point;
mod exact;
mod features;
mod free_drivers;
mod gain;
mod grid;
mod input_rate;
mod joined;
mod limits;
mod pose_order;
mod profile;
mod sampling;
mod smooth;
mod table;
mod transmission;
mod turn_count;

pub use change::{Changed, Refusal};
pub use cyclogram::{Phase, PhaseKind};
pub use dead_point::{DeadPoint, DeadPointKind};
pub use exact::{MadeExact, NEARLY};
pub use features::{Extremum, Features, Kind, TooManyTurns, features};
pub(crate) use free_drivers::FreeDrivers;
pub use grid::{At, Grid};
pub use input_rate::InputRate;
pub use joined::Unjoinable;
pub use limits::LimitPosition;
pub use pose_order::PoseOrder;
pub use profile::{Dwell, OutputProfile};
pub use sampling::{Sampling, Shown, Spacing};
pub use table::{Column, Row};
pub use transmission::{DyadTransmission, WorstTransmission};

use std::cell::RefCell;
use std::f64::consts::TAU;
use std::sync::Arc;

use crate::index::StepId;
use crate::mechanism::{AssemblySigns, Mechanism, Pose, Unsolved};
use crate::numeric::roots::bisect;
use crate::position::Step;
use crate::{Cycle, tolerance};
use continuation::{Continuation, End, Knots, longest_step};
use turn_count::range_between;

/// Number of samples per turn in the search for extrema. Their spacing is also the unit of continuation steps.
const SAMPLES_PER_TURN: usize = 360;
/// Maximum number of turns searched for extrema; also the maximum number of inputs listed for one crank angle. A plot
/// could not resolve more turns, and a train whose wheels move no link may take a million turns to repeat.
pub(crate) const MAX_TURNS: usize = 256;

/// Motion of a mechanism in one of its assemblies. A pose depends on the input alone: the assembly signs at every input
/// are determined once, by following the motion. A clone shares the knots and the mechanism's layout with the original.
///
/// ```
/// # use assur::{linkage::LinkageSpec, mechanism::Mechanism, motion::Motion};
/// # let slider_crank = LinkageSpec::default()
/// #     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
/// #     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
/// #     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
/// let motion = Motion::new(Mechanism::new(&slider_crank).unwrap());
/// let pose = motion.pose::<2>(90f64.to_radians()).unwrap();
/// let slider = motion.mechanism().place(&pose, motion.mechanism().point("C").unwrap());
/// assert!((slider.place().x - 4.0).abs() < 1e-12);
/// assert!((slider.derivative(1).x + 3.0).abs() < 1e-12); // as fast as the crank pin
/// ```
#[derive(Clone, Debug)]
pub struct Motion {
    mechanism: Mechanism,
    cycle: Cycle,
    knots: Arc<Knots>,
    dead_points: Vec<DeadPoint>,
    change_points: Vec<f64>,
    drawn_input: f64,
}

impl Motion {
    /// Motion of a mechanism through its drawn pose. [`Motion::in_assembly`] draws the linkage in another assembly.
    pub fn new(mechanism: Mechanism) -> Self {
        if mechanism.whole_closed_form() {
            Self::in_closed_form(mechanism, 1)
        } else if let Some(turns) = mechanism.turns_of_wheels() {
            Self::in_closed_form(mechanism, turns)
        } else {
            Self::followed(mechanism)
        }
    }

    fn followed(mut mechanism: Mechanism) -> Self {
        let mut forward = Continuation::new(&mechanism);
        let longest = longest_step(&mechanism);
        let mut knots = Knots::new(longest);
        let full = match forward.follow(1.0, &mut knots) {
            End::Cycle(turns) => {
                knots.begin_at_zero(TAU * turns as f64);
                Ok(Cycle::turning(turns))
            }
            End::Dead(last) => {
                let mut backward = Continuation::new(&mechanism);
                let mut before = Knots::new(longest);
                let first = match backward.follow(-1.0, &mut before) {
                    End::Dead(first) => first,
                    // Inconsistent: a driver cannot turn fully in one sense only.
                    End::Cycle(_) => DeadPoint {
                        input: mechanism.drawn_input(),
                        ..last
                    },
                };
                forward.smooth_roots.extend(backward.smooth_roots);
                knots.prepend(before);
                Err([first, last])
            }
        };
        let change_points = forward.smooth_roots;
        let (cycle, turned, dead_points) = match full {
            Ok(cycle) => (cycle, 0.0, Vec::new()),
            Err(ends) => {
                let (cycle, turned) = range_between(&mut mechanism, ends);
                knots.shift(-turned);
                let ends = ends.map(|end| DeadPoint {
                    input: end.input - turned,
                    ..end
                });
                (cycle, turned, ends.to_vec())
            }
        };
        let drawn_input = cycle.wrap(mechanism.drawn_input());
        let mut motion = Self::of(mechanism, cycle, knots, dead_points, drawn_input);
        let change_points = change_points.iter();
        let change_points = change_points.map(|root| (root.step, root.input - turned));
        motion.smooth(change_points.collect());
        motion
    }

    /// The motion over a known range, including the change points of its four-bars in closed form.
    fn of(
        mechanism: Mechanism,
        cycle: Cycle,
        mut knots: Knots,
        dead_points: Vec<DeadPoint>,
        drawn_input: f64,
    ) -> Self {
        knots.index();
        let arcs = cycle.arcs().iter();
        let change_points = arcs.flat_map(|arc| {
            let closed = mechanism.closed_steps();
            closed.flat_map(|closed| closed.change_points(*arc))
        });
        let mut motion = Self {
            change_points: change_points.collect(),
            mechanism,
            cycle,
            knots: Arc::new(knots),
            dead_points,
            drawn_input,
        };
        motion.end_in_poses();
        if motion.pose::<1>(drawn_input).is_err() {
            motion.drawn_input = motion.cycle.drawn_input();
        }
        motion
    }

    /// Pulls the ends of the arcs inward until each end has a pose. An end may have none: when an input is shifted by
    /// whole turns, rounding may move it beyond the dead point.
    fn end_in_poses(&mut self) {
        if self.cycle.is_full() {
            return;
        }
        let arcs = self.cycle.arcs().to_vec();
        for (index, arc) in arcs.into_iter().enumerate() {
            let ends = [[arc[0], arc[1]], [arc[1], arc[0]]];
            let ends = ends.map(|ends| self.last_pose(ends).unwrap_or((ends[0], None)));
            for dead in &mut self.dead_points {
                if let Some(side) = arc.iter().position(|end| *end == dead.input) {
                    let (input, step) = ends[side];
                    (dead.input, dead.step) = (input, step.unwrap_or(dead.step));
                }
            }
            self.cycle.set_arc(index, ends.map(|(input, _)| input));
        }
    }

    /// Last input with a pose before `end`, found by doubled offsets from `end` towards `other`, the other end of the
    /// arc. If this input differs from `end` by more than rounding, another dead point may lie just before the one at
    /// `end`. The step that fails beyond this input is then also returned.
    fn last_pose(&self, [end, other]: [f64; 2]) -> Option<(f64, Option<StepId>)> {
        let scale = end.abs().max(other.abs()).max(self.mechanism.span());
        let sense = (other - end).signum();
        let ulps = (0..f64::MANTISSA_DIGITS).map(|doubled| ((1_u64 << doubled) - 1) as f64);
        let inputs = ulps.map(|ulps| end + sense * f64::EPSILON * scale * ulps);
        let mut inputs = inputs.take_while(|input| (other - input) * sense > 0.0);
        let inside = inputs.find(|input| self.pose::<1>(*input).is_ok())?;
        if (inside - end).abs() <= tolerance::CONVERGED * scale {
            return Some((inside, None));
        }
        let mut step = self.pose::<1>(end).err()?.step;
        let last = bisect([inside, end], |input| {
            let unsolved = self.pose::<1>(input).err();
            step = unsolved.as_ref().map_or(step, |unsolved| unsolved.step);
            unsolved.is_none()
        });
        Some((last, Some(step)))
    }

    /// The mechanism of this motion.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Range of the input.
    pub fn cycle(&self) -> &Cycle {
        &self.cycle
    }

    pub(crate) fn signs_at(&self, input: f64) -> AssemblySigns {
        let mut guess = Vec::new();
        let (signs, _) = self.knots.near(self.cycle.wrap(input), &mut guess);
        signs.clone()
    }

    pub(crate) fn knot_count(&self) -> usize {
        self.knots.count()
    }

    /// Input of the drawn pose, reduced by whole turns to the cycle; if it has no pose, the middle of the first arc.
    pub fn drawn_input(&self) -> f64 {
        self.drawn_input
    }

    /// The ends of the motion: dead points, ends of ranges, and poses at which the motion is given up; empty for a full
    /// cycle.
    pub fn dead_points(&self) -> &[DeadPoint] {
        &self.dead_points
    }

    /// Names of the links placed by the step of the plan that stops at a dead point.
    pub fn links_at(&self, dead: &DeadPoint) -> impl Iterator<Item = &str> {
        self.mechanism.links_of(dead.step)
    }

    /// Change points: inputs at which links come into line without stopping the motion, and another motion crosses this
    /// one.
    pub fn change_points(&self) -> &[f64] {
        &self.change_points
    }

    /// True if the motion passes a pose in which the outer hinges of a dyad coincide: the two links of the dyad could
    /// swing about these hinges with the driver at rest. The dyad of a driven four-bar does not count.
    pub(crate) fn passes_free_swing(&self) -> bool {
        self.knots.has_coincident_hinges()
    }

    /// Margin from singular poses, for groups solved by Newton's method. For each group, the minimum absolute value of
    /// its Jacobian's determinant over the motion is divided by the maximum. The magnitude of the margin is the
    /// smallest of these ratios, its sign the product of the signs of the determinants. 0 if a determinant vanishes or
    /// changes sign, 1 if there is no such group.
    pub fn singularity_margin(&self) -> f64 {
        let steps = self.mechanism.steps().enumerate();
        let groups = steps.filter(|(_, step)| matches!(step, Step::Group(_)));
        let ranges = groups.map(|(id, _)| self.knots.margin_range(id));
        let ratios = ranges.map(|[low, high]| {
            if low > 0.0 {
                low / high
            } else if high < 0.0 {
                -high / low
            } else {
                0.0
            }
        });
        ratios.fold(1.0, |least: f64, ratio| {
            least.abs().min(ratio.abs()).copysign(least * ratio)
        })
    }

    /// Pose at an input, with `N − 1` derivatives with respect to the input.
    ///
    /// # Errors
    /// The step that has no solution, and the cause.
    pub fn pose<const N: usize>(&self, input: f64) -> Result<Pose<N>, Unsolved>
    where
        Pose<N>: PoseOrder,
    {
        let mut pose = self.mechanism.blank();
        self.place(input, &mut pose)?;
        Ok(pose)
    }

    /// Returns a function that evaluates `of` in the poses at successive inputs, without allocation after the first.
    ///
    /// # Errors
    /// The returned function fails with the step that has no solution, and the cause.
    pub fn telling<const N: usize, T>(
        &self,
        of: impl Fn(&Pose<N>) -> T,
    ) -> impl Fn(f64) -> Result<T, Unsolved>
    where
        Pose<N>: PoseOrder,
    {
        let buffer = RefCell::new(self.mechanism.blank());
        move |input| {
            let pose = &mut *buffer.borrow_mut();
            self.place(input, pose)?;
            Ok(of(pose))
        }
    }

    /// Writes the pose at an input into `pose`, without allocation.
    ///
    /// # Errors
    /// The step that has no solution, and the cause; `pose` is then invalid.
    pub fn place(&self, input: f64, pose: &mut impl PoseOrder) -> Result<(), Unsolved> {
        pose.put(self, input)
    }
}
