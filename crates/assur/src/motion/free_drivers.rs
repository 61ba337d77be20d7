//! Poses of a linkage whose drivers move independently of one another.

use super::Motion;
use super::continuation::{MAX_TURN, Prediction};
use crate::angle::whole_turns;
use crate::index::{BodyId, List, StepId};
use crate::linkage::{DriverSpec, FRAME};
use crate::mechanism::{AssemblySigns, Cause, Mechanism, Pose, Unsolved, solve_steps};
use crate::position::{
    DriveLaw, Enclosure, Mounting, Nearby, Orientation, Predictor, Sign, State, Step, StepContext,
};
use crate::{Jet, tolerance};

/// Most pieces of a line that may fail to be certified. Near a singular pose many fail, and the line is given up.
const TRIES: usize = 100;

/// A linkage at any coordinates of its drivers, followed from pose to pose along straight lines in these coordinates.
/// Every line is certified in steps like those of [`Motion`], so the assembly stays the same.
#[derive(Clone, Debug)]
pub(crate) struct FreeDrivers {
    motion: Motion,
    /// Steps of the plan, with laws of the drivers along a line and without closed forms of the motion.
    steps: List<StepId, Step>,
    signs: AssemblySigns,
    mounting: Mounting,
    /// Bodies whose whole turns are tracked.
    tracked: Vec<BodyId>,
    /// Coordinates of the drivers in the last pose, with its orientations and the unknowns of its groups.
    coordinates: Vec<f64>,
    orientations: List<BodyId, Orientation>,
    natural: Vec<f64>,
    here: Predictor,
    trial: Predictor,
    enclosure: Enclosure,
}

impl FreeDrivers {
    /// The drivers at an input of a motion; from there each may go its own way.
    ///
    /// # Errors
    /// The input has no pose, or a singular one.
    pub(crate) fn new(motion: &Motion, input: f64) -> Result<Self, Unsolved> {
        let mechanism = motion.mechanism();
        let pose = motion.pose::<1>(input)?;
        let mut steps = mechanism.steps().clone();
        let mut coordinates = vec![0.0; mechanism.spec().drivers.len()];
        for step in steps.iter_mut() {
            for law in step.laws_mut() {
                let (driver, coordinate) = law.coordinate(input);
                coordinates[driver] = coordinate;
            }
            if let Step::Rrr(dyad) = step {
                dyad.four_bar = None;
            }
        }
        let tracked = steps.enumerate().filter(|(_, step)| step.tracks_turns());
        let mut free = Self {
            tracked: tracked.flat_map(|(_, step)| step.bodies()).collect(),
            signs: motion.signs_at(input),
            mounting: mechanism.mounting().clone(),
            orientations: pose.state().orientations(),
            natural: pose.state().natural_values().collect(),
            here: mechanism.blank_state(),
            trial: mechanism.blank_state(),
            enclosure: mechanism.enclosure(),
            motion: motion.clone(),
            coordinates,
            steps,
        };
        if free.tracked.is_empty() {
            free.drop_whole_turns();
        }
        free.take_signs(pose.state(), input)?;
        Ok(free)
    }

    /// Reduces the angles of cranks relative to moving links to at most half a turn. Wheels in mesh would turn with them.
    fn drop_whole_turns(&mut self) {
        let drivers = &self.motion.mechanism().spec().drivers;
        for (coordinate, driver) in self.coordinates.iter_mut().zip(drivers).skip(1) {
            if matches!(driver, DriverSpec::Crank { base, .. } if base != FRAME) {
                *coordinate -= whole_turns(*coordinate);
            }
        }
    }

    /// Gives each step the sign for which its bodies are nearest to those of a pose. Closed forms of the motion count
    /// signs otherwise.
    fn take_signs(&mut self, posed: &State<1>, input: f64) -> Result<(), Unsolved> {
        let at = self.coordinates.clone();
        self.follow(&at, &vec![0.0; at.len()]);
        let mut state: State<1> = self.mechanism().blank_state();
        for step in self.steps.ids() {
            let placing = &self.steps[step];
            let signs: &[Sign] = if placing.has_sign() {
                &Sign::BOTH
            } else {
                &[Sign::Plus]
            };
            let mut put = |sign: Sign| {
                let context = StepContext {
                    step,
                    input: Jet::constant(0.0),
                    sign,
                    near: self.near(),
                    mounting: &self.mounting,
                };
                placing.put(&mut state, &context)?;
                let off = placing.bodies().into_iter().map(|body| {
                    let [here, there] = [&state, posed].map(|state| &state.bodies[body]);
                    (here.origin.value() - there.origin.value()).norm()
                        + (here.turn.value() - there.turn.value()).norm()
                });
                Ok((off.sum::<f64>(), sign))
            };
            let found = signs.iter().filter_map(|sign| put(*sign).ok());
            let nearest = found.min_by(|a, b| a.0.total_cmp(&b.0));
            let unsolved = |cause| Unsolved { input, step, cause };
            let (_, sign) = nearest.ok_or(unsolved(Cause::DeadPoint))?;
            put(sign).map_err(unsolved)?;
            self.signs[step] = sign;
        }
        Ok(())
    }

    pub(crate) fn mechanism(&self) -> &Mechanism {
        self.motion.mechanism()
    }

    /// Coordinates of the drivers in the last pose.
    pub(crate) fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }

    /// Writes the pose at coordinates near those of the last pose. Its derivatives are those along a line in the
    /// coordinates.
    ///
    /// # Errors
    /// The step that has no solution.
    pub(crate) fn place(
        &mut self,
        [at, along]: [&[f64]; 2],
        pose: &mut Pose<3>,
    ) -> Result<(), Unsolved> {
        self.follow(at, along);
        let (state, _) = pose.parts();
        let solved = solve_steps(
            (&self.steps, self.steps.len()),
            0.0,
            &self.signs,
            self.near(),
            &self.mounting,
            state,
        );
        solved.map_err(|(step, cause)| unsolved(at, step, cause))
    }

    fn near(&self) -> Nearby<'_> {
        Nearby {
            orientations: &self.orientations,
            natural: &self.natural,
            smooth_roots: &[],
        }
    }

    fn follow(&mut self, from: &[f64], along: &[f64]) {
        let laws = self.steps.iter_mut().flat_map(Step::laws_mut);
        laws.for_each(|law: &mut DriveLaw| law.follow(from, along));
    }

    /// Moves to coordinates along a straight line.
    ///
    /// # Errors
    /// The step of the plan that has no solution, or is not certified even in short pieces of the line; the pose is as
    /// before.
    pub(crate) fn move_to(&mut self, to: &[f64]) -> Result<(), Unsolved> {
        let before = (
            self.coordinates.clone(),
            self.orientations.clone(),
            self.natural.clone(),
        );
        let moved = self.moved(to);
        if moved.is_err() {
            (self.coordinates, self.orientations, self.natural) = before;
        }
        moved
    }

    fn moved(&mut self, to: &[f64]) -> Result<(), Unsolved> {
        let (mut part, mut tries) = (1.0, 0);
        // Parts of the line that are still to do are halves of halves, so their sum is exact.
        let mut left = 1.0;
        while left > 0.0 {
            let (from, share) = (self.coordinates.clone(), part / left);
            let ends = from.iter().zip(to);
            let next: Vec<f64> = if share == 1.0 {
                to.to_vec()
            } else {
                ends.map(|(from, to)| from + share * (to - from)).collect()
            };
            match self.step_to(&next) {
                Ok(()) => {
                    left -= part;
                    part = (2.0 * part).min(left);
                }
                Err((step, cause)) => {
                    part *= 0.5;
                    // A piece within rounding of the coordinates would not move them.
                    let ends = from.iter().zip(to);
                    let moves =
                        ends.map(|(from, to)| part * (to - from).abs() / from.abs().max(to.abs()));
                    tries += 1;
                    if tries > TRIES || moves.fold(0.0, f64::max) < tolerance::EXACT {
                        return Err(unsolved(&next, step, cause));
                    }
                }
            }
        }
        Ok(())
    }

    /// Certifies a straight line in one piece, and takes the pose at its end.
    fn step_to(&mut self, to: &[f64]) -> Result<(), (StepId, Cause)> {
        let from = self.coordinates.clone();
        let along: Vec<f64> = from.iter().zip(to).map(|(from, to)| to - from).collect();
        self.follow(&from, &along);
        let near = Nearby {
            orientations: &self.orientations,
            natural: &self.natural,
            smooth_roots: &[],
        };
        let (signs, mounting) = (&self.signs, &self.mounting);
        let steps = (&self.steps, self.steps.len());
        solve_steps(steps, 0.0, signs, near, mounting, &mut self.here)?;
        let predicted = Prediction::of(&self.here, &self.orientations, 1.0);
        let near = predicted.near(&[]);
        solve_steps(steps, 1.0, signs, near, mounting, &mut self.trial)?;
        let uncertified = |step| (step, Cause::DeadPoint);
        let enclosure = &mut self.enclosure;
        enclosure
            .certify(&self.steps, &self.here, 1.0)
            .map_err(uncertified)?;
        let turns_far = |body: &&BodyId| enclosure.turned(&self.here, **body) > MAX_TURN;
        if let Some(body) = self.tracked.iter().find(turns_far) {
            let step = self.motion.mechanism().placed_by(*body);
            return Err(uncertified(step.unwrap_or(StepId::FIRST)));
        }
        let holds = |(step, placing)| enclosure.holds(step, placing, &self.here, &self.trial);
        if let Some((step, _)) = self.steps.enumerate().find(|one| !holds(*one)) {
            return Err(uncertified(step));
        }
        self.coordinates.copy_from_slice(to);
        self.trial.orient(&mut self.orientations);
        self.natural.clear();
        self.natural.extend(self.trial.natural_values());
        Ok(())
    }
}

fn unsolved(at: &[f64], step: StepId, cause: Cause) -> Unsolved {
    let input = at.first().copied().unwrap_or(0.0);
    Unsolved { input, step, cause }
}
