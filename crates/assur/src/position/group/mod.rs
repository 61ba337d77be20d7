//! An Assur group of any class, by Newton's method in natural coordinates.
//!
//! The unknowns are positions of joints and directions of links as complex numbers. Links are rigid, so every other
//! position is a linear form of the unknowns with constant complex coefficients (Class IV paper in `docs/papers.md`,
//! (3)–(5)). The equations are quadratic, and for gear meshes linear in angles. Derivatives follow order by order from
//! the Jacobian at the solution: J x⁽ᵏ⁾ = −(residual of the lower orders).

mod angle_constraint;
mod certified;

mod equation;
mod evaluation;
mod newton;
mod work;

pub(crate) use angle_constraint::{AngleConstraint, Drive};
pub(crate) use equation::{Equation, Form};
use std::ops::Range;
pub(super) use work::Work;

use crate::Vector;
use crate::index::{BodyId, StepId};
use crate::numeric::elimination::Elimination;
use crate::position::step::finite;
use crate::position::{
    BodyPoint, Cause, DriveLaw, Enclosure, Nearby, Predictor, Solvable, State, StepContext,
};
use equation::MAX_FORMS;

/// An input of a group: a position or direction known from a solved body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum KnownTerm {
    /// Position of a point of the body.
    Place(BodyPoint),
    /// A direction on the body.
    Direction(BodyPoint),
}

/// Body of a group, whose pose is given by two forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyForms {
    pub(crate) body: BodyId,
    /// Indices of two forms: the position of the body's origin, and the body's rotation e^(iθ).
    pub(crate) forms: [usize; 2],
    /// The first of two close points from which e^(iθ) is computed, in local coordinates; None if no close points are
    /// used. Rounding makes |e^(iθ)| differ from 1; e^(iθ) is normalized with the point held in place.
    pub(crate) close: Option<Vector>,
}

/// A group of bodies solved together.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Group {
    pub(crate) inputs: Vec<KnownTerm>,
    /// Number of complex unknowns.
    pub(in crate::position) unknowns: usize,
    /// Index of the group's first unknown among the unknowns of all groups.
    first_unknown: usize,
    /// Constant terms of all forms.
    pub(in crate::position) constants: Vec<Vector>,
    /// Number of forms that occur in equations. These forms come first; the others, called outputs, follow.
    pub(in crate::position) equation_forms: usize,
    /// Terms of the inputs in all forms.
    pub(in crate::position) input_terms: Vec<Term>,
    /// Terms of the unknowns in the forms that occur in equations.
    pub(in crate::position) unknown_terms: Vec<Term>,
    /// Terms of the unknowns in the outputs.
    output_terms: Vec<Term>,
    pub(in crate::position) equations: Vec<Equation>,
    pub(in crate::position) angle_constraints: Vec<AngleConstraint>,
    /// Unit of each unknown: the size of the group for a position, 1 for a direction.
    pub(in crate::position) units: Vec<f64>,
    /// Bound on the change of each form when no unknown changes by more than its unit.
    pub(in crate::position) sensitivities: Vec<f64>,
    /// Factor that turns the residual of each equation into a length; 0 for an equation between angles or directions.
    pub(in crate::position) lengths: Vec<f64>,
    /// The body that each equation constrains.
    pub(in crate::position) constrained: Vec<BodyId>,
    pub(crate) bodies: Vec<BodyForms>,
    /// Sparsity pattern of the Jacobian, row by row.
    pattern: Vec<bool>,
    entries: Vec<Entry>,
    /// Further contributions to entries, for unknowns that occur in several forms of one equation.
    repeated_entries: Vec<Entry>,
    elimination: Elimination,
}

/// An input or unknown of a form, with its coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::position) struct Term {
    pub(in crate::position) form: usize,
    pub(in crate::position) index: usize,
    pub(in crate::position) factor: Vector,
}

/// Two neighbouring entries of the Jacobian: derivatives with respect to the real and imaginary parts of an unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    at: usize,
    /// Index into [`Work::gradients`].
    gradient: usize,
    factor: Vector,
}

impl Group {
    /// Makes a group from equations, each with its entry in `lengths` and the body that it constrains. The forms that
    /// occur in equations must come first. None if there are fewer equations than real unknowns; if there are more,
    /// some are redundant.
    pub(crate) fn new(
        first_unknown: usize,
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
        let (mut entries, mut repeated_entries) = (Vec::new(), Vec::new());
        for (row, equation) in equations.iter().enumerate() {
            for (k, form) in equation.forms().enumerate() {
                for (unknown, factor) in &forms[form].unknowns {
                    let at = row * size + 2 * unknown;
                    let list = if pattern[at] {
                        &mut repeated_entries
                    } else {
                        &mut entries
                    };
                    pattern[at..][..2].fill(true);
                    list.push(Entry {
                        at,
                        gradient: MAX_FORMS * row + k,
                        factor: *factor,
                    });
                }
            }
        }
        let last = equations.iter().flat_map(Equation::forms).max();
        let equation_forms = last.map_or(0, |last| last + 1);
        let terms = |of: fn(&Form) -> &[(usize, Vector)], range: Range<usize>| {
            let terms = range.flat_map(|form| {
                let terms = of(&forms[form]).iter();
                terms.map(move |(index, factor)| Term {
                    form,
                    index: *index,
                    factor: *factor,
                })
            });
            terms.collect()
        };
        let sensitivities = forms.iter().map(|form| {
            let terms = form.unknowns.iter();
            terms
                .map(|(unknown, factor)| factor.norm() * units[*unknown])
                .sum()
        });
        Some(Self {
            inputs,
            unknowns,
            first_unknown,
            sensitivities: sensitivities.collect(),
            units,
            constants: forms.iter().map(|form| form.constant).collect(),
            equation_forms,
            input_terms: terms(|form| &form.inputs, 0..forms.len()),
            unknown_terms: terms(|form| &form.unknowns, 0..equation_forms),
            output_terms: terms(|form| &form.unknowns, equation_forms..forms.len()),
            equations,
            angle_constraints,
            lengths,
            constrained,
            bodies,
            pattern,
            entries,
            repeated_entries,
            elimination: Elimination::default(),
        })
    }

    /// True if gears mesh or a pair is driven within the group.
    pub(crate) fn has_meshes(&self) -> bool {
        !self.angle_constraints.is_empty()
    }

    /// True if the group has unknowns. Otherwise its bodies follow from its inputs, and its equations are only checked.
    pub(crate) fn has_unknowns(&self) -> bool {
        self.unknowns > 0
    }

    /// True if the group has more equations than unknowns.
    pub(crate) fn is_redundant(&self) -> bool {
        self.equations.len() > 2 * self.unknowns
    }

    /// Solves the group from a nearby pose. Sets the two margins of the step: the Jacobian's determinant divided by
    /// a power of two, and the exponent of this power. Also sets `state.corrections`.
    #[inline(never)]
    fn solve_near<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let near = context.near;
        self.substitute_inputs(state, context)?;
        self.guess(&mut state.work, near);
        self.newton(state, near, context.step)?;
        for order in 1..N {
            self.differentiate(&mut state.work, order);
        }
        self.write_solution(state, near)
    }

    /// Places the bodies of the group from the nearby unknowns, which must be a solution.
    pub(crate) fn put_solved<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.substitute_inputs(state, context)?;
        self.guess(&mut state.work, context.near);
        self.evaluate_forms(&mut state.work);
        self.write_solution(state, context.near)
    }

    /// Solved bodies whose angles, including whole turns, occur in the group's angle constraints.
    pub(crate) fn turned_by(&self) -> impl Iterator<Item = BodyId> {
        let constraints = self.angle_constraints.iter();
        let known = constraints.flat_map(|constraint| &constraint.known);
        known.map(|(body, _)| *body)
    }

    /// Laws of the drivers within the group.
    pub(crate) fn laws_mut(&mut self) -> impl Iterator<Item = &mut DriveLaw> {
        let drives = self.angle_constraints.iter_mut();
        drives.filter_map(|constraint| Some(&mut constraint.drive.as_mut()?.law))
    }

    /// Adopts the elimination order of the last Jacobian in `state`.
    pub(crate) fn plan_as<const N: usize>(&mut self, state: &State<N>) {
        self.elimination.clone_from(&state.work.own_plan);
    }

    /// Sets the unknowns to their values in the nearby pose, as a first guess.
    pub(in crate::position) fn guess<const N: usize>(&self, work: &mut Work<N>, near: Nearby<'_>) {
        let own = near.natural[2 * self.first_unknown..].chunks_exact(2);
        for (unknown, guess) in work.unknowns.iter_mut().zip(own) {
            unknown[0] = Vector::new(guess[0], guess[1]);
        }
    }

    /// Writes the real and imaginary parts of the group's unknowns into the list of the unknowns of all groups.
    pub(crate) fn set(&self, natural: &mut [f64], own: &[Vector]) {
        let parts = natural[2 * self.first_unknown..].chunks_exact_mut(2);
        for (parts, own) in parts.zip(own) {
            parts.copy_from_slice(&[own.x, own.y]);
        }
    }

    /// Unknowns of the group among the unknowns of all groups.
    pub(in crate::position) fn own<'a, T>(&self, natural: &'a [T]) -> impl Iterator<Item = &'a T> {
        natural[self.first_unknown..].iter().take(self.unknowns)
    }

    /// Exponent of the power of two that scales the group's determinants.
    pub(crate) fn exponent(&self) -> i32 {
        self.elimination.exponent()
    }

    fn write_solution<const N: usize>(
        &self,
        state: &mut State<N>,
        near: Nearby<'_>,
    ) -> Result<(), Cause> {
        let work = &mut state.work;
        self.evaluate_outputs(work);
        let mut sum = Vector::zeros();
        let natural = &mut state.natural[self.first_unknown..];
        for (natural, unknown) in natural.iter_mut().zip(&work.unknowns) {
            *natural = *unknown;
            sum += unknown.finite_probe();
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
            state.track_turn(*body, near);
        }
        finite(sum)
    }
}

impl Solvable for Group {
    #[inline(always)]
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.solve_near(state, context)
    }

    /// Places the bodies by `solve`, which also sets the angles and rejects values that are not finite.
    #[inline(always)]
    fn put<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.solve(state, context)
    }

    fn enclose(&self, step: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        self.certified(step, from, cell)
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.bodies.iter().map(|forms| forms.body)
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.inputs.iter().any(|input| match input {
            KnownTerm::Place(anchor) | KnownTerm::Direction(anchor) => anchor.body == body,
        }) || self.turned_by().any(|other| other == body)
    }
}
