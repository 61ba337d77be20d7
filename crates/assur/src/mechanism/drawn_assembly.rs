//! The drawn assembly of a mechanism: the signs of its groups.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::angle::whole_turns;
use crate::index::{BodyId, List, PointId, StepId};
use crate::mechanism::{
    AssemblySigns, Configuration, Defect, Layout, LinkageSpec, Mechanism, Pose, Start,
};
use crate::position::{
    BodyPoint, Cause, Orientation, Predictor, Sign, Solvable, State, Step, quotient,
};
use crate::{Point, tolerance};

/// Maximum distance of a point from its drawn position, relative to the size of the linkage.
const MISDRAWN: f64 = 0.3;
/// Number of inputs tried on each side of a rounded input, which may be just beyond a dead point. Their distances from
/// the rounded input are 0, 1, 3, 7, … times its rounding unit.
const TRIES: u32 = 24;
/// Maximum deviation of a wheel from its drawn angle that counts as rounding, radians. A whole turn of the driving body
/// shifts a wheel by a greater angle, unless the wheel has tens of thousands of teeth.
const MOUNTED: f64 = 1e-4;

impl Layout {
    /// Finds the drawn configuration from a guess, and the start of the motion. Each group adopts the order in which
    /// its equations are eliminated in the drawn pose.
    pub(super) fn settle(
        &mut self,
        spec: &LinkageSpec,
        guess: Configuration,
    ) -> Result<(Configuration, Start), Vec<Defect>> {
        let mut at = guess;
        let mut state: State<1> = self.blank_state();
        for step in self.steps.ids() {
            self.mount(step, &mut at, &mut state);
            let sign = self.drawn_sign(spec, step, &at, &mut state);
            let sign = sign.map_err(|cause| vec![self.open(spec, step, Some(cause))])?;
            at.signs[step] = sign;
            // The step is solved again with the chosen sign, so that `state` is the drawn pose.
            let solved = self.try_step(step, sign, &at, &mut state);
            solved.map_err(|cause| vec![self.open(spec, step, Some(cause))])?;
            if let Step::Group(group) = &mut self.steps[step] {
                group.plan_as(&state);
            }
            if let Some((point, by)) = self.misdrawn(spec, &state, step)
                && by > MISDRAWN * self.size
            {
                let point = spec.points[point.index()].name.clone();
                return Err(vec![Defect::Misdrawn { point, by }]);
            }
        }
        let drawn = at.posed(&state);
        let start = self.start(spec, &drawn)?;
        Ok((drawn, start))
    }

    /// The pose from which the motion of a configuration is followed.
    pub(super) fn start(
        &self,
        spec: &LinkageSpec,
        at: &Configuration,
    ) -> Result<Start, Vec<Defect>> {
        let mut pose = self.blank_state();
        let input = match self.entry(&at.signs, at, &mut pose) {
            Some(input) => input,
            // A closed form gives the motion without continuation.
            None if self.whole_closed_form(at) => at.input,
            None => {
                let last = self.steps.ids().next_back();
                let open = last.map(|last| self.open(spec, last, None));
                return Err(open.into_iter().collect());
            }
        };
        let pose = Arc::new(pose);
        Ok(Start { input, pose })
    }

    /// Mounts the wheels of a step as drawn. If the driving body's angle differs from its drawn angle by whole turns,
    /// each of these turns rotates a wheel through a fraction of a turn.
    fn mount(&self, step: StepId, at: &mut Configuration, state: &mut State<1>) {
        match &self.steps[step] {
            Step::Group(group) => {
                for body in group.turned_by() {
                    let angle = state.angle(body).value() - at.orientations[body].angle;
                    at.mounting.turns[body] = whole_turns(angle);
                }
            }
            Step::Epicyclic(train) => {
                for wheel in train.bodies() {
                    if train.solve(state, &at.context(step, Sign::Plus)).is_err() {
                        return;
                    }
                    let turn = state.bodies[wheel].turn.value();
                    let off = quotient(at.orientations[wheel].turn, turn);
                    let off = off.y.atan2(off.x);
                    if off.abs() > MOUNTED {
                        at.mounting.shifts[wheel] += off;
                    }
                }
            }
            _ => {}
        }
    }

    /// The sign for which the points of a step are closest to their drawn positions.
    pub(super) fn drawn_sign(
        &self,
        spec: &LinkageSpec,
        step: StepId,
        at: &Configuration,
        state: &mut State<1>,
    ) -> Result<Sign, Cause> {
        let mut best: Option<(f64, Sign)> = None;
        let mut met = Cause::DeadPoint;
        for sign in self.joinings(step) {
            match self.try_step(step, *sign, at, state) {
                Ok(()) => {
                    let off = self.misdrawn(spec, state, step).map_or(0.0, |(_, by)| by);
                    if best.is_none_or(|(least, _)| off < least) {
                        best = Some((off, *sign));
                    }
                }
                Err(cause) => met = cause,
            }
        }
        best.map(|(_, sign)| sign).ok_or(met)
    }

    /// The possible signs of a step.
    pub(super) fn joinings(&self, step: StepId) -> &'static [Sign] {
        if self.steps[step].has_sign() {
            &Sign::BOTH
        } else {
            &[Sign::Plus]
        }
    }

    /// Point of a step's links that is farthest from its drawn position, and this distance.
    fn misdrawn(
        &self,
        spec: &LinkageSpec,
        state: &State<1>,
        step: StepId,
    ) -> Option<(PointId, f64)> {
        let mut farthest: Option<(PointId, f64)> = None;
        for body in self.steps[step].bodies() {
            for (point, local) in self.bodies.of(body) {
                let local = *local;
                let at = state.place(BodyPoint { body, local }).value();
                let by = (at + self.origin - spec.points[point.index()].at.coords).norm();
                if farthest.is_none_or(|(_, most)| by > most) {
                    farthest = Some((*point, by));
                }
            }
        }
        farthest
    }

    fn open(&self, spec: &LinkageSpec, step: StepId, met: Option<Cause>) -> Defect {
        let bodies = self.steps[step].bodies().into_iter();
        let links = bodies.map(|body| spec.name_of(self.made_for[body]).to_owned());
        let links: Vec<String> = links.collect();
        match met {
            Some(Cause::Parallel) => Defect::ParallelGuides { links },
            Some(Cause::Apart { by } | Cause::OutOfReach { by }) => Defect::Open { links, by },
            Some(Cause::Undetermined) => Defect::CoincidentHinges { links },
            _ => Defect::Singular {
                links,
                singularity: self.steps[step].singularity(),
            },
        }
    }

    /// The input of a configuration or, if the pose there has no derivatives, an input next to it. None if no such pose
    /// exists.
    pub(super) fn entry(
        &self,
        signs: &AssemblySigns,
        at: &Configuration,
        state: &mut Predictor,
    ) -> Option<f64> {
        let mut inputs = self.entries(at).into_iter();
        inputs.find(|input| self.solve(*input, signs, at, state).is_ok())
    }

    /// The input of a configuration and one input on each side, in case the drawn pose is singular. They are 0.001 rad
    /// apart for a crank, and 0.001/2π of the range for a slide.
    pub(super) fn entries(&self, at: &Configuration) -> [f64; 3] {
        [0.0, tolerance::NEAR, -tolerance::NEAR].map(|aside| at.input + aside * self.span() / TAU)
    }
}

impl Mechanism {
    /// Shifts the drawn input by whole turns. Wheels and four-bars keep their drawn positions. Returns false, and
    /// changes nothing, if the links do not close at the new input.
    pub(crate) fn rebase_turns(&mut self, drawn_input: f64) -> bool {
        // The new input is rounded again. At a dead point, rounding may move the input just beyond this point.
        let unit = f64::EPSILON * drawn_input.abs().max(self.span());
        let aside = (0..TRIES).flat_map(|doubled| {
            let off = unit * f64::from((1_u32 << doubled) - 1);
            [off, -off]
        });
        let mut inputs = aside.map(|off| drawn_input + off);
        let turned = whole_turns(self.drawn.input - drawn_input);
        let rebased = inputs.find_map(|input| self.rebased(input, turned));
        let Some(rebased) = rebased else { return false };
        self.drawn = rebased;
        self.start.input -= turned;
        true
    }

    /// Drawn configuration at an input that differs from the drawn input by whole turns; `turned` is this difference as
    /// an angle. None if the links do not close at the input.
    fn rebased(&self, input: f64, turned: f64) -> Option<Configuration> {
        let mut at = Configuration {
            input,
            ..self.drawn.clone()
        };
        let mut state: State<1> = self.blank_state();
        for (step, placing) in self.steps().enumerate() {
            // If the crank angle φ₁ passes a change point, a whole turn leads to the other assembly.
            if let Some(four_bar) = placing.four_bar()
                && four_bar.linkage.changes()
            {
                at.mounting.shifts[four_bar.coupler] += turned;
            }
            self.layout.mount(step, &mut at, &mut state);
            let solved = self.layout.try_step(step, at.signs[step], &at, &mut state);
            solved.ok()?;
        }
        Some(at)
    }

    /// Specification of the linkage drawn in a given pose.
    pub fn drawn_in(&self, pose: &Pose<1>) -> LinkageSpec {
        self.drawn_by(&pose.state)
    }

    /// Specification of the linkage drawn in a given pose, with one point moved. Links that list the point take their
    /// dimensions from the drawing; other links keep theirs. A traced point is moved on its link.
    pub fn redrawn(&self, pose: &Pose<1>, point: PointId, to: Point) -> LinkageSpec {
        let mut spec = self.drawn_in(pose);
        let joints = spec.points.len();
        let Some(moved) = spec.points.get_mut(point.index()) else {
            let tracer = &mut spec.tracers[point.index() - joints];
            tracer.at = self.on_link_of(tracer, pose, to);
            return spec;
        };
        moved.at = to;
        for link in &mut spec.links {
            if link.points.contains(&moved.name) {
                link.shape = None;
            }
        }
        spec
    }

    pub(super) fn drawn_by<const N: usize>(&self, state: &State<N>) -> LinkageSpec {
        let mut spec = LinkageSpec::clone(&self.spec);
        self.layout.draw(&mut spec, state);
        spec
    }

    /// Input, signs and pose from which the motion is followed.
    pub(crate) fn start(&self) -> (f64, &AssemblySigns, &Predictor) {
        (self.start.input, &self.drawn.signs, &self.start.pose)
    }

    /// Assembly signs and orientations of the drawn pose.
    pub(crate) fn as_drawn(&self) -> (&AssemblySigns, &List<BodyId, Orientation>) {
        (&self.drawn.signs, &self.drawn.orientations)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gears::Mesh;
    use crate::mechanism::GearSpec;

    /// If the links do not close at an input, wheels already mounted for this input are restored.
    #[test]
    fn turns_that_do_not_close_change_nothing() {
        let mut spec = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("D", 4.0, 0.0)
            .point("B", 1.5, 2.598)
            .point("C", 3.468, 2.953)
            .point("S", 0.0, 1.0)
            .point("P", 2.5, 2.598)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("sun", &["A", "S"])
            .bar("planet", &["B", "P"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank");
        spec.links[1].fixed_to = Some("frame".to_owned());
        spec.gears.push(GearSpec {
            links: ["sun", "planet"].map(str::to_owned),
            carrier: "crank".to_owned(),
            teeth: [20.0, 11.0],
            mesh: Mesh::External,
        });
        let mut mechanism = Mechanism::new(&spec).unwrap();
        let drawn = mechanism.drawn.clone();
        // The crank can reach only angles between −90° and 90° from the frame.
        assert!(!mechanism.rebase_turns(drawn.input + 0.5 * TAU));
        assert!(mechanism.drawn == drawn);
        assert!(mechanism.rebase_turns(drawn.input + TAU));
    }
}
