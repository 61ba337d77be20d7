//! An Assur group of any class, by Newton's method in natural coordinates.
//!
//! The unknowns are places of joints (and directions of links) as complex numbers; every other place is a linear
//! combination of them with constant complex coefficients, since links are rigid (class4 paper, (3)–(5)). What is left
//! are quadratic equations, and those of wheels in mesh, linear in angles. Derivatives follow order by order from the
//! same Jacobian at the solution: J x⁽ᵏ⁾ = −(what the lower orders leave).

mod certified;
mod elimination;
mod equation;
mod mesh;
mod newton;
mod work;

pub(crate) use elimination::power_of_two;
pub(crate) use equation::{Equation, Form};
pub(crate) use mesh::{AngleConstraint, Drive};
use std::f64::consts::TAU;
use std::ops::Range;
pub(super) use work::Work;

use crate::index::{BodyId, List, StepId};
use crate::position::complex::product;
use crate::position::step::finite;
use crate::position::{
    BodyPoint, Cause, Enclosure, Nearby, Orientation, Predictor, Solvable, State, StepContext,
};
use crate::{Jet, Vector};
use elimination::Elimination;
use equation::MOST_FORMS;

/// What a group takes from what is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum KnownTerm {
    /// Where a point of a solved body is.
    Place(BodyPoint),
    /// A direction of a solved body.
    Direction(BodyPoint),
}

/// A body of a group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyForms {
    pub(crate) body: BodyId,
    /// The forms of its origin and its turn.
    pub(crate) forms: [usize; 2],
    /// Where it is turned by two of its points that are close together, the place of the first: rounding leaves the
    /// turn too short or too long.
    pub(crate) close: Option<Vector>,
}

/// A group of bodies solved together.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Group {
    pub(crate) inputs: Vec<KnownTerm>,
    /// How many complex unknowns, and where theirs begin among those of all groups.
    pub(in crate::position) unknowns: usize,
    offset: usize,
    /// Of each form what does not change; so many of them, the first, stand in
    /// equations.
    pub(in crate::position) constants: Vec<Vector>,
    pub(in crate::position) equated: usize,
    /// The terms of all forms one after the other: inputs, then unknowns where the
    /// form stands in an equation, and where it does not.
    pub(in crate::position) taken: Vec<Term>,
    pub(in crate::position) sought: Vec<Term>,
    further: Vec<Term>,
    pub(in crate::position) equations: Vec<Equation>,
    pub(in crate::position) angle_constraints: Vec<AngleConstraint>,
    /// Of each unknown what it is measured by: the size of the group for a place, 1 for a direction; and by how much
    /// each form changes where all unknowns change by their units.
    pub(in crate::position) units: Vec<f64>,
    pub(in crate::position) by_unknowns: Vec<f64>,
    /// What an equation is left with becomes a length by this; none for angles.
    pub(in crate::position) lengths: Vec<f64>,
    /// The body that each equation constrains.
    pub(in crate::position) constrained: Vec<BodyId>,
    pub(crate) bodies: Vec<BodyForms>,
    /// Where the Jacobian can be other than zero, row by row, what of it comes from
    /// which unknown of which equation, and its elimination.
    pattern: Vec<bool>,
    entries: Vec<Entry>,
    /// Further ones of unknowns that stand in both forms of their equation.
    doubled: Vec<Entry>,
    elimination: Elimination,
}

/// A form's input or unknown with its coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::position) struct Term {
    pub(in crate::position) form: usize,
    pub(in crate::position) of: usize,
    pub(in crate::position) by: Vector,
}

/// Two neighbouring places of the Jacobian, by real and imaginary part of an
/// unknown, and the slope of the equation they come from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    at: usize,
    slope: usize,
    by: Vector,
}

impl Group {
    /// None where the equations, each with its length and the body that it constrains, are fewer than the unknowns.
    /// Where they are more, some are redundant. Forms of equations come first.
    pub(crate) fn new(
        offset: usize,
        units: Vec<f64>,
        inputs: Vec<KnownTerm>,
        forms: &[Form],
        equations: Vec<(Equation, f64, BodyId)>,
        angle_constraints: Vec<AngleConstraint>,
        bodies: Vec<BodyForms>,
    ) -> Option<Self> {
        let unknowns = units.len();
        let size = 2 * unknowns;
        if equations.len() < size {
            return None;
        }
        let lengths = equations.iter().map(|(_, length, _)| *length).collect();
        let constrained = equations.iter().map(|(_, _, body)| *body).collect();
        let equations: Vec<Equation> = equations.into_iter().map(|(one, ..)| one).collect();
        let mut pattern = vec![false; equations.len() * size];
        let (mut entries, mut doubled) = (Vec::new(), Vec::new());
        for (row, equation) in equations.iter().enumerate() {
            for (side, form) in equation.forms().enumerate() {
                for (unknown, by) in &forms[form].unknowns {
                    let at = row * size + 2 * unknown;
                    let list = if pattern[at] {
                        &mut doubled
                    } else {
                        &mut entries
                    };
                    pattern[at..][..2].fill(true);
                    list.push(Entry {
                        at,
                        slope: MOST_FORMS * row + side,
                        by: *by,
                    });
                }
            }
        }
        let equated = equations.iter().flat_map(Equation::forms).max();
        let equated = equated.map_or(0, |last| last + 1);
        let terms = |of: fn(&Form) -> &[(usize, Vector)], range: Range<usize>| {
            let terms = range.flat_map(|form| {
                let terms = of(&forms[form]).iter();
                terms.map(move |(of, by)| Term {
                    form,
                    of: *of,
                    by: *by,
                })
            });
            terms.collect()
        };
        let by_unknowns = forms.iter().map(|form| {
            let terms = form.unknowns.iter();
            terms.map(|(unknown, by)| by.norm() * units[*unknown]).sum()
        });
        Some(Self {
            inputs,
            unknowns,
            offset,
            by_unknowns: by_unknowns.collect(),
            units,
            constants: forms.iter().map(|form| form.constant).collect(),
            equated,
            taken: terms(|form| &form.inputs, 0..forms.len()),
            sought: terms(|form| &form.unknowns, 0..equated),
            further: terms(|form| &form.unknowns, equated..forms.len()),
            equations,
            angle_constraints,
            lengths,
            constrained,
            bodies,
            pattern,
            entries,
            doubled,
            elimination: Elimination::default(),
        })
    }

    /// Whether wheels are in mesh within it.
    pub(crate) fn has_meshes(&self) -> bool {
        !self.angle_constraints.is_empty()
    }

    /// Whether anything is unknown of it. If not, its bodies follow from what is solved, and its equations are only checked.
    pub(crate) fn has_unknowns(&self) -> bool {
        self.unknowns > 0
    }

    /// Whether it has more equations than unknowns.
    pub(crate) fn is_redundant(&self) -> bool {
        self.equations.len() > 2 * self.unknowns
    }

    /// Solves from the guess nearby; sets the margins of the step to the Jacobian's
    /// determinant and its exponent, and `state.corrections`.
    #[inline(never)]
    fn solve_near<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let near = given.near;
        self.receive(state, given)?;
        self.guess(&mut state.work, near);
        self.newton(state, near, given.step)?;
        for order in 1..N {
            self.differentiate(&mut state.work, order);
        }
        self.settle(state, near)
    }

    /// Puts its bodies where its unknowns are nearby, which are a solution.
    pub(crate) fn put_solved<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.receive(state, given)?;
        self.guess(&mut state.work, given.near);
        self.evaluate(&mut state.work);
        self.settle(state, given.near)
    }

    /// Takes what is solved into its forms.
    pub(in crate::position) fn receive<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        state.work.fit(self);
        for (k, input) in self.inputs.iter().enumerate() {
            state.work.inputs[k] = state.taken(*input);
        }
        for (k, mesh) in self.angle_constraints.iter().enumerate() {
            state.work.given[k] = mesh.given(state, given.near, given.input)?;
        }
        let work = &mut state.work;
        self.take(work);
        for (known, value) in work.known.iter_mut().zip(&work.values) {
            *known = value.value();
        }
        Ok(())
    }

    /// Counts the turns of solved bodies that its angle_constraints take from where they are drawn.
    pub(crate) fn count_turns(&mut self, drawn: &List<BodyId, Orientation>, state: &State<1>) {
        for mesh in &mut self.angle_constraints {
            let known = mesh.known.iter().map(|(body, by)| {
                let off = state.angle(*body).value() - drawn[*body].angle;
                by * TAU * (off / TAU).round()
            });
            mesh.turned = known.sum();
        }
    }

    /// The solved bodies whose angles, with all their turns, its angle_constraints take.
    pub(crate) fn turned_by(&self) -> impl Iterator<Item = BodyId> {
        let known = self.angle_constraints.iter().flat_map(|mesh| &mesh.known);
        known.map(|(body, _)| *body)
    }

    /// Takes over the order of elimination that the Jacobian needed in the pose that
    /// `state` was solved for last.
    pub(crate) fn plan_as<const N: usize>(&mut self, state: &State<N>) {
        self.elimination.clone_from(&state.work.spare);
    }

    /// The unknowns as they are guessed.
    pub(in crate::position) fn guess<const N: usize>(&self, work: &mut Work<N>, near: Nearby<'_>) {
        let own = near.natural[2 * self.offset..].chunks_exact(2);
        for (place, guess) in work.unknowns.iter_mut().zip(own) {
            place[0] = Vector::new(guess[0], guess[1]);
        }
    }

    /// What all forms have of what is solved.
    pub(in crate::position) fn take<const N: usize>(&self, work: &mut Work<N>) {
        for (value, constant) in work.values.iter_mut().zip(&self.constants) {
            value.set_constant(*constant);
        }
        for term in &self.taken {
            work.values[term.form] = work.values[term.form] + work.inputs[term.of].by(term.by);
        }
    }

    /// Puts its own among the unknowns of all groups, real and imaginary parts.
    pub(crate) fn set(&self, natural: &mut [f64], own: &[Vector]) {
        let places = natural[2 * self.offset..].chunks_exact_mut(2);
        for (place, own) in places.zip(own) {
            place.copy_from_slice(&[own.x, own.y]);
        }
    }

    /// Its own of the unknowns of all groups.
    pub(in crate::position) fn own<'a, T>(&self, natural: &'a [T]) -> impl Iterator<Item = &'a T> {
        natural[self.offset..].iter().take(self.unknowns)
    }

    /// What the second derivatives of all forms are at most by those of what is solved.
    pub(in crate::position) fn accelerations(&self, inputs: &[f64], forms: &mut Vec<f64>) {
        forms.clear();
        forms.resize(self.constants.len(), 0.0);
        for term in &self.taken {
            forms[term.form] += inputs[term.of] * term.by.norm();
        }
    }

    /// The values of the forms that stand in equations.
    pub(in crate::position) fn evaluate<const N: usize>(&self, work: &mut Work<N>) {
        for (value, known) in work.values.iter_mut().zip(&work.known) {
            value[0] = *known;
        }
        self.add(work, 0);
    }

    /// Eliminates the Jacobian, as planned or, where that does not suit it, as it
    /// must be; its determinant as [`Self::told`] has it, none where it is singular.
    pub(in crate::position) fn factor<const N: usize>(&self, work: &mut Work<N>) -> Option<f64> {
        self.jacobian(work);
        let planned = self.elimination.factor(&mut work.jacobian);
        work.planned = planned.is_some();
        planned.or_else(|| {
            work.jacobian.fill(0.0);
            self.jacobian(work);
            work.spare.plan(&self.pattern, &mut work.jacobian)
        })
    }

    /// A determinant of the elimination that was done, and the exponent of the power of two of which it is a multiple: the
    /// same in all poses of a group that was planned.
    pub(in crate::position) fn told<const N: usize>(
        &self,
        work: &Work<N>,
        determinant: f64,
    ) -> [Jet<N>; 2] {
        let done = self.suited(work.planned, &work.spare).exponent();
        let own = if self.elimination.is_planned() {
            self.elimination.exponent()
        } else {
            done
        };
        let told = if done == own {
            determinant
        } else {
            determinant * power_of_two(done - own)
        };
        [Jet::constant(told), Jet::constant(f64::from(own))]
    }

    /// The exponent of the power of two of which its determinants are multiples.
    pub(crate) fn exponent(&self) -> i32 {
        self.elimination.exponent()
    }

    /// The elimination that was done: as planned for the group, or for this pose.
    pub(in crate::position) fn suited<'a>(
        &'a self,
        planned: bool,
        spare: &'a Elimination,
    ) -> &'a Elimination {
        if planned { &self.elimination } else { spare }
    }

    /// Adds to the forms that stand in equations what the unknowns contribute to a
    /// coefficient.
    #[inline(always)]
    pub(in crate::position) fn add<const N: usize>(&self, work: &mut Work<N>, order: usize) {
        for term in &self.sought {
            work.values[term.form][order] += product(work.unknowns[term.of][order], term.by);
        }
    }

    /// Adds to all other forms what the unknowns contribute.
    pub(in crate::position) fn add_further<const N: usize>(&self, work: &mut Work<N>) {
        for term in &self.further {
            work.values[term.form] = work.values[term.form] + work.unknowns[term.of].by(term.by);
        }
    }

    /// The derivatives of the equations by the unknowns, row by row.
    pub(in crate::position) fn jacobian<const N: usize>(&self, work: &mut Work<N>) {
        let slopes = work.slopes.chunks_exact_mut(MOST_FORMS);
        for (slopes, equation) in slopes.zip(&self.equations) {
            equation.slopes(&work.values, slopes);
        }
        for entry in &self.entries {
            let slope = work.slopes[entry.slope];
            work.jacobian[entry.at] = entry.by.dot(&slope);
            work.jacobian[entry.at + 1] = entry.by.perp(&slope);
        }
        for entry in &self.doubled {
            let slope = work.slopes[entry.slope];
            work.jacobian[entry.at] += entry.by.dot(&slope);
            work.jacobian[entry.at + 1] += entry.by.perp(&slope);
        }
    }

    /// The coefficients of an order from those below it: that of an equation holds the
    /// new ones linearly.
    fn differentiate<const N: usize>(&self, work: &mut Work<N>, order: usize) {
        // The first was solved for with the last correction.
        if order == 1 {
            for (place, step) in work.unknowns.iter_mut().zip(work.step.chunks_exact(2)) {
                place[order] = Vector::new(-step[0][1], -step[1][1]);
            }
        } else {
            for (rhs, equation) in work.rhs.iter_mut().zip(&self.equations) {
                *rhs = [equation.coefficient(&work.values, &work.given, order)];
            }
            self.suited(work.planned, &work.spare).solve(
                &work.jacobian,
                &mut work.rhs,
                &mut work.solution,
            );
            for (place, step) in work.unknowns.iter_mut().zip(work.solution.chunks_exact(2)) {
                place[order] = Vector::new(-step[0][0], -step[1][0]);
            }
        }
        self.add(work, order);
    }

    /// Puts what was found where it is looked for.
    fn settle<const N: usize>(&self, state: &mut State<N>, near: Nearby<'_>) -> Result<(), Cause> {
        let work = &mut state.work;
        self.add_further(work);
        let mut sum = Vector::zeros();
        let natural = &mut state.natural[self.offset..];
        for (place, found) in natural.iter_mut().zip(&work.unknowns) {
            *place = *found;
            sum += found.finite_probe();
        }
        for BodyForms {
            body,
            forms: [origin, turn],
            close,
        } in &self.bodies
        {
            let [mut origin, mut turn] = [origin, turn].map(|form| state.work.values[*form]);
            if let Some(at) = close {
                let unit = turn.unit();
                origin = origin + (turn - unit).by(*at);
                turn = unit;
            }
            let pose = &mut state.bodies[*body];
            (pose.origin, pose.turn) = (origin, turn);
            state.tracks_turns(*body, near);
        }
        finite(sum)
    }
}

impl Solvable for Group {
    #[inline(always)]
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.solve_near(state, given)
    }

    /// The angles are told, and what is not finite found, with the unknowns.
    #[inline(always)]
    fn put<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.solve(state, given)
    }

    fn enclose(&self, step: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        self.certified(step, from, cell)
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.bodies.iter().map(|placed| placed.body)
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.inputs.iter().any(|input| match input {
            KnownTerm::Place(anchor) | KnownTerm::Direction(anchor) => anchor.body == body,
        }) || self.turned_by().any(|other| other == body)
    }
}
