//! The drawn assembly of a mechanism: the signs of its groups.

use std::f64::consts::TAU;

use crate::index::{BodyId, List, PointId, StepId};
use crate::mechanism::{Defect, LinkageSpec, Mechanism, Pose};
use crate::position::{
    BodyPoint, Cause, Nearby, Orientation, Predictor, Sign, Solvable, State, Step, StepContext,
    quotient,
};
use crate::{Jet, Point};

/// Assembly sign of each step; plus if it has only one assembly.
pub(crate) type AssemblySigns = List<StepId, Sign>;

/// Maximum distance of a point from its drawn place, relative to the size.
const MISDRAWN: f64 = 0.3;
/// Distance of the starting input from a singular drawn pose: radians of a crank; for a slide, the same fraction of its
/// range as of a turn.
const ASIDE: f64 = 1e-3;
/// Maximum number of doublings, starting at the rounding, of the step back from an input just beyond a dead point.
const BACK: u32 = 24;
/// Maximum deviation, radians, of a wheel mounted as drawn. A whole turn of the body that drives it shifts it by more,
/// unless it has tens of thousands of teeth.
const MOUNTED: f64 = 1e-4;

impl Mechanism {
    /// The drawn pose as the nearby pose.
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

    /// Finds the drawn assembly.
    pub(super) fn settle(&mut self) -> Result<(), Vec<Defect>> {
        let mut state: State<1> = self.blank_state();
        for step in self.steps.ids() {
            self.mount(step, self.drawn_input, &mut state);
            let sign = self.drawn_sign(step, &mut state);
            let sign = sign.map_err(|cause| vec![self.open(step, Some(cause))])?;
            self.signs[step] = sign;
            // Solved last with the chosen sign, so that the state is the drawn pose.
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

    /// Shifts the drawn input by whole turns, with wheels and four-bars kept as drawn. Returns false, with nothing
    /// changed, if the links do not close at the new input.
    pub(crate) fn rebase_turns(&mut self, drawn_input: f64) -> bool {
        // The new input is rounded anew; drawn at a dead point, it may lie just beyond it.
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
        let turned = crate::angle::whole_turns(self.drawn_input - drawn_input);
        let mut state: State<1> = self.blank_state();
        for step in before.ids() {
            // If φ₁ passes a change point, a whole turn leads to the other assembly.
            if let Step::Rrr(dyad) = &mut self.steps[step]
                && let Some(four_bar) = &mut dyad.four_bar
                && four_bar.linkage.changes()
            {
                four_bar.angle_offset += turned;
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

    /// Mounts the wheels of a step as drawn. Each whole turn by which the body that drives them differs from the
    /// drawing turns a wheel by a fraction of a turn.
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

    /// The sign of a step that puts its points closest to their drawn places.
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

    /// The possible signs of a step.
    pub(super) fn joinings(&self, step: StepId) -> &'static [Sign] {
        if self.steps[step].has_sign() {
            &Sign::BOTH
        } else {
            &[Sign::Plus]
        }
    }

    /// The point of a step's links farthest from its drawn place, with the distance.
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

    /// The same linkage drawn in this pose, with one point moved: the links that list it take their dimensions from the
    /// drawing, the others keep theirs. A tracer is moved on its link.
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

    /// Assembly signs and orientations of the drawn pose.
    pub(crate) fn as_drawn(&self) -> (&AssemblySigns, &List<BodyId, Orientation>) {
        (&self.signs, &self.orientations)
    }

    /// The drawn input, or one next to it if the drawn pose has no derivatives.
    pub(super) fn entry(&self, signs: &AssemblySigns, state: &mut Predictor) -> Option<f64> {
        let mut inputs = self.entries().into_iter();
        inputs.find(|input| self.solve(*input, signs, self.drawn(), state).is_ok())
    }

    /// The drawn input and one on each side.
    pub(super) fn entries(&self) -> [f64; 3] {
        [0.0, ASIDE, -ASIDE].map(|aside| self.drawn_input + aside * self.span() / TAU)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gears::Mesh;
    use crate::mechanism::GearSpec;

    /// If the links do not close at an input, wheels already mounted for it are restored.
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
