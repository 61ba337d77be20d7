//! A whole motion: the branch of poses that is reached from the drawn one without
//! a jump, followed by continuity; and what is read off it.

mod change;
mod closed_form;
mod continuation;
mod cyclogram;
mod dead_point;
mod exact;
mod features;
mod gain;
mod grid;
mod input_rate;
mod joined;
mod limits;
mod pose_order;
mod profile;
pub(crate) mod root;
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

use crate::Cycle;
use crate::index::StepId;
use crate::mechanism::{AssemblySigns, Mechanism, Pose, Unsolved};
use crate::position::Step;
use continuation::{Continuation, End, Knots, longest_step};
use turn_count::range_between;

/// So often the way back from an end to a pose is doubled, from the rounding of the input on.
const BACK: u32 = 6;
/// Where there is none that near another group has come to its end before; it is doubled so often at most.
const FARTHER: u32 = 40;
/// So often the way between an input with a pose and one without is halved: down to rounding.
const HALVINGS: usize = 64;

/// The motion of a mechanism in one of its assemblies. A pose depends on the
/// input alone: which way each group is joined at every input has been found out
/// once, by going through the motion.
#[derive(Clone, Debug)]
pub struct Motion {
    mechanism: Mechanism,
    cycle: Cycle,
    /// Shared by all copies: of a motion that is followed far there are many.
    knots: Arc<Knots>,
    dead_points: Vec<DeadPoint>,
    change_points: Vec<f64>,
    drawn_input: f64,
}

impl Motion {
    /// The motion of a mechanism from its drawn pose; from another assembly, that of
    /// the mechanism drawn in it, [`Motion::in_assembly`].
    pub fn new(mechanism: Mechanism) -> Self {
        if mechanism.whole_closed_form() {
            Self::in_closed_form(mechanism)
        } else if let Some(turns) = mechanism.turns_of_wheels() {
            Self::of_wheels(mechanism, turns)
        } else {
            Self::followed(mechanism)
        }
    }

    fn followed(mut mechanism: Mechanism) -> Self {
        let mut forth = Continuation::new(&mechanism);
        let longest = longest_step(&mechanism);
        let mut knots = Knots::new(longest);
        let full = match forth.go(1.0, &mut knots) {
            End::FourBarStep(turns) => {
                knots.begin_at_zero(TAU * turns as f64);
                Ok(Cycle::turning(turns))
            }
            End::Dead(last) => {
                let mut back = Continuation::new(&mechanism);
                let mut before = Knots::new(longest);
                let first = match back.go(-1.0, &mut before) {
                    End::Dead(first) => first,
                    // It cannot turn fully one way only.
                    End::FourBarStep(_) => DeadPoint {
                        input: mechanism.drawn_input(),
                        ..last
                    },
                };
                forth.smooth_roots.extend(back.smooth_roots);
                knots.prepend(before);
                Err([first, last])
            }
        };
        let passed = forth.smooth_roots;
        let (cycle, turned, dead_points) = match full {
            Ok(cycle) => (cycle, 0.0, Vec::new()),
            Err(ends) => {
                let (cycle, turned) = range_between(&mut mechanism, ends);
                knots.shift(-turned);
                let counted = ends.map(|end| DeadPoint {
                    input: end.input - turned,
                    ..end
                });
                (cycle, turned, counted.to_vec())
            }
        };
        let drawn_input = cycle.wrap(mechanism.drawn_input());
        let mut motion = Self::of(mechanism, cycle, knots, dead_points, drawn_input);
        let passed = passed.iter();
        motion.smooth(passed.map(|one| (one.step, one.input - turned)).collect());
        motion
    }

    /// A motion that has been found out, with the change points of its closed forms.
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

    /// Takes back the ends of its arcs, by as little as can be told, to where there is a
    /// pose. Told by other turns an input is rounded anew, and may then lie beyond a dead
    /// point that it was just before.
    fn end_in_poses(&mut self) {
        if self.cycle.is_full() {
            return;
        }
        let arcs = self.cycle.arcs().to_vec();
        for (index, arc) in arcs.into_iter().enumerate() {
            let told = arc[0].abs().max(arc[1].abs());
            let unit = f64::EPSILON * told.max(self.mechanism.span());
            let ends = [[arc[0], arc[1]], [arc[1], arc[0]]].map(|[end, other]| {
                let back = (other - end).signum() * unit;
                let back = (0..BACK).map(|doubled| back * f64::from((1_u32 << doubled) - 1));
                let mut inside = back
                    .map(|back| end + back)
                    .take_while(|input| (other - input) * (other - end) > 0.0);
                let found = inside.find(|input| self.pose::<1>(*input).is_ok());
                match found {
                    Some(input) => (input, None),
                    None => self.end_before(end, other, unit).unwrap_or((end, None)),
                }
            });
            for dead in &mut self.dead_points {
                if let Some(side) = arc.iter().position(|end| *end == dead.input) {
                    let (input, step) = ends[side];
                    (dead.input, dead.step) = (input, step.unwrap_or(dead.step));
                }
            }
            self.cycle.set_arc(index, ends.map(|(input, _)| input));
        }
    }

    /// The last input with a pose before an end at which there is none, and the step that fails there: two groups may come
    /// to their dead points so close to each other that the one looked for is not the first.
    fn end_before(&self, end: f64, other: f64, unit: f64) -> Option<(f64, Option<StepId>)> {
        let mut step = self.pose::<1>(end).err()?.step;
        let sense = (other - end).signum();
        let farther =
            (BACK..FARTHER).map(|doubled| end + sense * unit * 2_f64.powi(doubled as i32));
        let mut within = farther.take_while(|input| (other - input) * sense > 0.0);
        let mut inside = within.find(|input| self.pose::<1>(*input).is_ok())?;
        let mut outside = end;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            match self.pose::<1>(middle) {
                Ok(_) => inside = middle,
                Err(unsolved) => (outside, step) = (middle, unsolved.step),
            }
        }
        Some((inside, Some(step)))
    }

    /// The mechanism that moves.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The inputs over which it moves.
    pub fn cycle(&self) -> &Cycle {
        &self.cycle
    }

    /// Which way the groups are joined at an input.
    pub(crate) fn signs_at(&self, input: f64) -> AssemblySigns {
        let mut guess = Vec::new();
        let (signs, _) = self.knots.near(self.cycle.wrap(input), &mut guess);
        signs.clone()
    }

    /// How many knots it is kept in.
    pub(crate) fn knot_count(&self) -> usize {
        self.knots.count()
    }

    /// The input of the drawn pose, told by as many whole turns as the cycle is; where
    /// there is no pose at it, one far from the ends.
    pub fn drawn_input(&self) -> f64 {
        self.drawn_input
    }

    /// Where the driver must turn back; none where it turns fully.
    pub fn dead_points(&self) -> &[DeadPoint] {
        &self.dead_points
    }

    /// The links that are in line at a dead point, by name.
    pub fn links_at(&self, dead: &DeadPoint) -> impl Iterator<Item = &str> {
        self.mechanism.links_of(dead.step)
    }

    /// The inputs at which links come into line and pass through: there another
    /// motion crosses this one.
    pub fn change_points(&self) -> &[f64] {
        &self.change_points
    }

    /// How far the groups that Newton's method solves stay from singular poses: the
    /// least determinant of a Jacobian over the motion relative to its greatest, with
    /// the sign that it keeps; 1 where there is no such group.
    pub fn singularity_margin(&self) -> f64 {
        let steps = self.mechanism.steps().enumerate();
        let groups = steps.filter(|(_, placing)| matches!(placing, Step::Group(_)));
        let ranges = groups.map(|(step, _)| self.knots.margin_range(step));
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

    /// The pose at an input, with `N − 1` derivatives by it.
    ///
    /// # Errors
    /// Which links find no place, and why.
    pub fn pose<const N: usize>(&self, input: f64) -> Result<Pose<N>, Unsolved>
    where
        Pose<N>: PoseOrder,
    {
        let mut pose = self.mechanism.blank();
        self.place(input, &mut pose)?;
        Ok(pose)
    }

    /// What of a pose is asked for, at one input after another: only the first allocates.
    ///
    /// # Errors
    /// Which links find no place, and why.
    pub fn telling<const N: usize, T>(
        &self,
        of: impl Fn(&Pose<N>) -> T,
    ) -> impl Fn(f64) -> Result<T, Unsolved>
    where
        Pose<N>: PoseOrder,
    {
        let room = RefCell::new(self.mechanism.blank());
        move |input| {
            let pose = &mut *room.borrow_mut();
            self.place(input, pose)?;
            Ok(of(pose))
        }
    }

    /// The same into a pose that was made before: nothing is allocated.
    ///
    /// # Errors
    /// Which links find no place, and why; `pose` is then of no use.
    pub fn place(&self, input: f64, pose: &mut impl PoseOrder) -> Result<(), Unsolved> {
        pose.put(self, input)
    }
}
