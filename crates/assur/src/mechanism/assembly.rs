//! The assembly of a mechanism that is drawn: which way its groups are joined.

use std::f64::consts::TAU;

use crate::index::{BodyId, List, PointId, StepId};
use crate::mechanism::{Defect, LinkageSpec, Mechanism, Pose};
use crate::position::{
    BodyPoint, Cause, Nearby, Orientation, Predictor, Sign, Solvable, State, Step, StepContext,
    quotient,
};
use crate::{Jet, Point};

/// Of each step which of two ways its links are joined; plus where there is one.
pub(crate) type AssemblySigns = List<StepId, Sign>;

/// A point may be drawn this far, relative to the size, from where the links put it.
const MISDRAWN: f64 = 0.3;
/// Where the drawn pose is singular the motion is followed from an input that is off
/// by this, radians of a crank; of a slide's range the same part as of a turn.
const ASIDE: f64 = 1e-3;
/// So often the way back from an input beyond a dead point is doubled, from the rounding of the input on.
const BACK: u32 = 24;
/// A wheel that is off by less, radians, is mounted as it is drawn: a whole turn of what turns it makes more, unless it
/// has tens of thousands of teeth.
const MOUNTED: f64 = 1e-4;

impl Mechanism {
    /// The drawn pose as the one nearby.
    pub(super) fn drawn(&self) -> Nearby<'_> {
        Nearby {
            orientations: &self.orientations,
            natural: &self.natural,
            smooth_roots: &[],
        }
    }

    /// Solves a step at the drawn input.
    pub(super) fn try_step(
        &self,
        step: StepId,
        sign: Sign,
        state: &mut State<1>,
    ) -> Result<(), Cause> {
        let given = self.given(step, self.drawn_input, sign);
        self.steps[step].put(state, &given)
    }

    fn given(&self, step: StepId, drawn_input: f64, sign: Sign) -> StepContext<'_, 1> {
        StepContext {
            step,
            input: Jet::constant(drawn_input),
            sign,
            near: self.drawn(),
        }
    }

    /// Finds the assembly that is drawn.
    pub(super) fn settle(&mut self) -> Result<(), Vec<Defect>> {
        let mut state: State<1> = self.blank_state();
        for step in self.steps.ids() {
            self.mount(step, self.drawn_input, &mut state);
            let sign = self.drawn_sign(step, &mut state);
            let sign = sign.map_err(|cause| vec![self.open(step, Some(cause))])?;
            self.signs[step] = sign;
            // The try that counts, last: the state is that of the drawn pose.
            let solved = self.try_step(step, sign, &mut state);
            solved.map_err(|cause| vec![self.open(step, Some(cause))])?;
            if let Step::Group(group) = &mut self.steps[step] {
                group.plan_as(&state);
            }
            if let Some((point, by)) = self.misdrawn(&state, step)
                && by > MISDRAWN * self.size
            {
                let point = self.point_name(point).to_owned();
                return Err(vec![Defect::Misdrawn { point, by }]);
            }
        }
        self.orientations = state.orientations();
        let places = state.natural.iter().map(|place| place.value());
        self.natural = places.flat_map(|place| [place.x, place.y]).collect();
        self.begin()
    }

    /// Finds the pose from which the motion is followed.
    pub(super) fn begin(&mut self) -> Result<(), Vec<Defect>> {
        let mut state = self.blank_state();
        match self.entry(&self.signs, &mut state) {
            Some(input) => self.start = (input, state),
            // A closed form gives the motion without following it.
            None if self.whole_closed_form() => {}
            None => {
                let last = self.steps.ids().next_back();
                return Err(last.map(|last| self.open(last, None)).into_iter().collect());
            }
        }
        Ok(())
    }

    /// Counts the drawn input by other whole turns, with the wheels mounted and four-bars joined as they are drawn. False,
    /// and nothing is changed, where the links do not close at an input given so.
    pub(crate) fn rebase_turns(&mut self, drawn_input: f64) -> bool {
        // Drawn at a dead point an input is rounded anew, and may then lie just beyond it.
        let unit = f64::EPSILON * drawn_input.abs().max(self.span());
        let aside = (0..BACK).flat_map(|doubled| {
            let off = unit * f64::from((1_u32 << doubled) - 1);
            [off, -off]
        });
        let mut inputs = aside.map(|off| drawn_input + off);
        inputs.any(|input| self.rebase_at(input))
    }

    fn rebase_at(&mut self, drawn_input: f64) -> bool {
        let before = self.steps.clone();
        let turned = TAU * ((self.drawn_input - drawn_input) / TAU).round();
        let mut state: State<1> = self.blank_state();
        for step in before.ids() {
            // Where φ₁ passes a change point, a whole turn of it is the other assembly.
            if let Step::FourBar(closed) = &mut self.steps[step]
                && closed.linkage.changes()
            {
                closed.angle_offset += turned;
            }
            self.mount(step, drawn_input, &mut state);
            let given = self.given(step, drawn_input, self.signs[step]);
            if self.steps[step].put(&mut state, &given).is_err() {
                self.steps = before;
                return false;
            }
        }
        self.drawn_input = drawn_input;
        self.start.0 -= turned;
        true
    }

    /// Mounts the wheels of a step as they are drawn. If the body that turns them is counted by other whole turns than in
    /// the drawing, a wheel makes a part of a turn for each of them.
    fn mount(&mut self, step: StepId, drawn_input: f64, state: &mut State<1>) {
        let drawn = &self.orientations;
        match &mut self.steps[step] {
            Step::Group(group) => group.count_turns(drawn, state),
            Step::Epicyclic(train) => {
                let near = Nearby {
                    orientations: drawn,
                    natural: &self.natural,
                    smooth_roots: &[],
                };
                let given = StepContext {
                    step,
                    input: Jet::constant(drawn_input),
                    sign: Sign::Plus,
                    near,
                };
                for k in 0..train.members.len() {
                    if train.solve(state, &given).is_err() {
                        return;
                    }
                    let member = &mut train.members[k];
                    let off = quotient(
                        drawn[member.body].turn,
                        state.bodies[member.body].turn.value(),
                    );
                    let off = off.y.atan2(off.x);
                    if off.abs() > MOUNTED {
                        member.shift += off;
                    }
                }
            }
            _ => {}
        }
    }

    /// The way to join a step's links that puts its points closest to where they are
    /// drawn.
    pub(super) fn drawn_sign(&self, step: StepId, state: &mut State<1>) -> Result<Sign, Cause> {
        let mut best: Option<(f64, Sign)> = None;
        let mut met = Cause::DeadPoint;
        for sign in self.joinings(step) {
            match self.try_step(step, *sign, state) {
                Ok(()) => {
                    let off = self.misdrawn(state, step).map_or(0.0, |(_, by)| by);
                    if best.is_none_or(|(least, _)| off < least) {
                        best = Some((off, *sign));
                    }
                }
                Err(cause) => met = cause,
            }
        }
        best.map(|(_, sign)| sign).ok_or(met)
    }

    /// The ways to join a step's links.
    pub(super) fn joinings(&self, step: StepId) -> &'static [Sign] {
        if self.steps[step].has_sign() {
            &Sign::BOTH
        } else {
            &[Sign::Plus]
        }
    }

    /// The point of a step's links that is farthest from where it is drawn.
    fn misdrawn(&self, state: &State<1>, step: StepId) -> Option<(PointId, f64)> {
        let mut farthest: Option<(PointId, f64)> = None;
        for body in self.steps[step].bodies() {
            for (point, local) in &self.bodies[body] {
                let local = *local;
                let at = state.place(BodyPoint { body, local }).value();
                let by = (at + self.origin - self.spec.points[point.index()].at.coords).norm();
                if farthest.is_none_or(|(_, most)| by > most) {
                    farthest = Some((*point, by));
                }
            }
        }
        farthest
    }

    fn open(&self, step: StepId, met: Option<Cause>) -> Defect {
        let links: Vec<String> = self.links_of(step).map(str::to_owned).collect();
        match met {
            Some(Cause::Parallel) => Defect::ParallelGuides { links },
            Some(Cause::Apart { by } | Cause::OutOfReach { by }) => Defect::Open { links, by },
            Some(Cause::Undetermined) => Defect::CoincidentHinges { links },
            _ => Defect::Singular {
                links,
                singularity: self.singularity(step),
            },
        }
    }

    /// The same linkage drawn in this pose.
    pub fn drawn_in(&self, pose: &Pose<1>) -> LinkageSpec {
        self.drawn_by(&pose.state)
    }

    /// The same linkage drawn in this pose, with one point drawn elsewhere: the
    /// links that list it are then as drawn, the others keep their dimensions. A
    /// tracer is moved on its link.
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
        let mut spec = self.spec.clone();
        for (drawn, anchor) in spec.points.iter_mut().zip(self.points.iter()) {
            drawn.at = Point::from(state.place(*anchor).value() + self.origin);
        }
        spec
    }

    /// Input, signs and pose from which the motion is followed.
    pub(crate) fn start(&self) -> (f64, &AssemblySigns, &Predictor) {
        let (input, state) = &self.start;
        (*input, &self.signs, state)
    }

    /// Which way the groups are joined as drawn, and how the bodies are turned.
    pub(crate) fn as_drawn(&self) -> (&AssemblySigns, &List<BodyId, Orientation>) {
        (&self.signs, &self.orientations)
    }

    /// The input at, or next to, the drawn one where the pose has derivatives.
    pub(super) fn entry(&self, signs: &AssemblySigns, state: &mut Predictor) -> Option<f64> {
        let mut inputs = self.entries().into_iter();
        inputs.find(|input| self.solve(*input, signs, self.drawn(), state).is_ok())
    }

    /// The drawn input and those next to it.
    pub(super) fn entries(&self) -> [f64; 3] {
        [0.0, ASIDE, -ASIDE].map(|aside| self.drawn_input + aside * self.span() / TAU)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gears::Mesh;
    use crate::mechanism::GearSpec;

    /// Where the links do not close at an input the wheels that were mounted for it before stay as they were.
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
        let (drawn_input, steps) = (mechanism.drawn_input, mechanism.steps.clone());
        // The crank goes from −90° to 90° of the frame.
        assert!(!mechanism.rebase_turns(drawn_input + 0.5 * TAU));
        assert!(mechanism.steps == steps);
        assert!(mechanism.rebase_turns(drawn_input + TAU));
    }
}
