//! All assemblies of an Assur group with solved inputs: by Dixon's determinant for hinges alone, by homotopy otherwise.
//!
//! The list of solutions counts as complete if their number is that for general dimensions: 2 for one unknown, 6 for
//! two, and 14, 16, 18 or 20 for three. For more unknowns it counts as complete if two hidden directions agree. This is
//! a check, not a proof (`enumeration`). From one input to the next the solutions are tracked (`tracking`).

mod bilinear;
mod complex_newton;
mod dixon;
mod enumeration;
mod homotopy;
mod solutions;
mod tracker;
mod tracking;

use super::{Cause, DriveLaw, Equation, Group, State, StepContext};
use crate::Vector;
use crate::index::BodyId;
use bilinear::{Affine, Bilinear, C, System, Varying};
pub(crate) use tracker::Tracker;

/// Method of finding all assemblies of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Dixon's determinant if all pairs are hinges, otherwise homotopy paths.
    Usual,
    /// Homotopy paths from a system with known solutions: slower, and a check of the usual method.
    Paths,
}

#[derive(Clone, Debug)]
pub(crate) struct GroupAssembly {
    pub(crate) unknowns: Vec<Vector>,
    /// Rotations, as unit vectors, of bodies with a driven angle between them, which is known except for whole turns.
    pub(crate) turns: Vec<(BodyId, Vector)>,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct GroupAssemblies {
    pub(crate) real: Vec<GroupAssembly>,
    /// True if the assemblies need no Newton steps: they were tracked, and no derivatives are wanted.
    pub(crate) solved: bool,
    /// Number of all assemblies over the complex numbers, including the real ones.
    pub(crate) complex: usize,
    /// The assemblies that are not real; empty if no derivatives are wanted.
    pub(crate) complex_pairs: Vec<ComplexPair>,
}

/// One of a pair of complex conjugate assemblies: its squared distance from the other, with the derivative of the
/// square with respect to the input. The square falls to zero, nearly linearly, at the input at which both become real.
/// For a dyad out of reach, `square` is the negative of a margin; for two guides, the squared sine of the angle between
/// them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ComplexPair {
    pub(crate) square: f64,
    pub(crate) slope: f64,
}

impl Group {
    /// True if all assemblies of the group can be found: it has no gear meshes and no redundant equations.
    pub(crate) fn is_algebraic(&self) -> bool {
        !self.is_redundant()
            && self
                .angle_constraints
                .iter()
                .all(|constraint| constraint.drive.is_some())
    }

    /// Drive laws and ranges of the slides driven within the group.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = (DriveLaw, [f64; 2])> {
        let drives = self
            .angle_constraints
            .iter()
            .filter_map(|constraint| constraint.drive.as_ref());
        drives.filter_map(|drive| Some((drive.law, drive.range?)))
    }

    /// All assemblies of the group with solved inputs, tracked from the last assemblies if possible. None if the
    /// equations are not algebraic, or if the work of a new search exceeds `budget`. The work of a new search is
    /// subtracted from `budget`.
    ///
    /// # Errors
    /// A driven coordinate is out of its range.
    pub(crate) fn assemblies<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
        (method, budget): (Method, &mut usize),
        mut tracker: Option<&mut Tracker>,
    ) -> Result<Option<GroupAssemblies>, Cause> {
        self.substitute_inputs(state, context)?;
        let last = tracker
            .as_deref_mut()
            .and_then(|tracker| tracker.system.take());
        let last = last.and_then(|system| self.refreshed(system, state));
        let last = last.map(|system| (system, Turning::new()));
        let Some((system, turning)) = last.or_else(|| self.system(state)) else {
            return Ok(None);
        };
        let tracked = tracker.as_deref_mut();
        let tracked = tracked.and_then(|tracker| self.tracked(tracker, &system, state, context));
        let solved = N == 1 && tracked.is_some();
        let solutions = match tracked {
            Some(solutions) => solutions,
            None => {
                let Some(rest) = budget.checked_sub(system.work(method)) else {
                    return Ok(None);
                };
                *budget = rest;
                let solutions = system.solutions(method);
                if let Some(tracker) = &mut tracker {
                    tracker.add(self.parameters(state), &solutions);
                }
                solutions
            }
        };
        // A complex pair has a derivative, which needs derivatives of the inputs.
        let pairs = solutions.complex_pairs().filter(|_| N > 1);
        let pairs = pairs.filter_map(|at| system.complex_pair(&system.reduced(at)));
        let real = solutions.real().map(|own| GroupAssembly {
            unknowns: own
                .iter()
                .zip(&self.units)
                .map(|(value, unit)| vector(value * unit))
                .collect(),
            turns: turning
                .iter()
                .map(|(body, turn)| (*body, vector(turn.at(own))))
                .collect(),
        });
        let assemblies = GroupAssemblies {
            solved,
            complex: solutions.count(),
            // Each of the two conjugates has an entry.
            complex_pairs: pairs.flat_map(|one| [one; 2]).collect(),
            real: real.collect(),
        };
        if let Some(tracker) = tracker {
            tracker.system = Some(system);
        }
        Ok(Some(assemblies))
    }

    /// The last system with its constants replaced by those for the present inputs. None if derivatives are wanted, or
    /// if the present system may differ in more than constants.
    fn refreshed<const N: usize>(&self, mut system: System, state: &State<N>) -> Option<System> {
        let sources = system.sources.as_ref().filter(|_| N == 1)?;
        let value = |form: usize| number(state.work.values[form][0]);
        for (equation, k) in system.equations.iter_mut().zip(sources) {
            match (equation, self.equations[*k]) {
                (Bilinear::Unit(one), Equation::Unit(form)) => one.constant = value(form),
                (Bilinear::Parallel(one, other), Equation::Line { axis, vector }) => {
                    one.constant = value(axis);
                    other.constant = value(vector);
                }
                _ => return None,
            }
        }
        Some(system)
    }

    /// The group's equations over the complex numbers, with the inputs substituted and the unknowns in their units. All
    /// coefficients have their derivatives with respect to the input. Also returns the rotations of driven bodies. None
    /// if the group has redundant equations or gear meshes.
    fn system<const N: usize>(&self, state: &State<N>) -> Option<(System, Turning)> {
        if self.is_redundant() {
            return None;
        }
        let angles = state.work.known_angles.iter().map(|known| {
            [0, 1].map(|order| {
                if order < N {
                    -known.angle.coefficient(order)
                } else {
                    0.0
                }
            })
        });
        let angles: Vec<[f64; 2]> = angles.collect();
        let values = &state.work.values[..self.equation_forms];
        let forms = values.iter().map(|value| {
            [0, 1].map(|order| {
                let constant = (order < N).then(|| number(value[order]));
                Affine::constant(constant.unwrap_or_default(), self.units.len())
            })
        });
        let mut forms: Vec<Varying> = forms.collect();
        for term in &self.unknown_terms {
            let factor = number(term.factor) * self.units[term.index];
            forms[term.form][0].by[term.index] += factor;
        }
        let form = |k: usize| forms[k].clone();
        let (mut equations, mut zeros, mut turning) = (Vec::new(), Vec::new(), Vec::new());
        for equation in &self.equations {
            match *equation {
                Equation::Unit(one) => equations.push(Bilinear::Unit(form(one))),
                // One complex form stands for both the real and the imaginary equation.
                Equation::Real(one) => zeros.push(form(one)),
                Equation::Imaginary(_) => {}
                Equation::Line { axis, vector } => {
                    equations.push(Bilinear::Parallel(form(axis), form(vector)));
                }
                Equation::Along {
                    axis,
                    vector,
                    constraint,
                } => {
                    let component = angles[constraint];
                    equations.push(Bilinear::Along(form(axis), form(vector), component));
                }
                Equation::Angle {
                    turns: [Some((link, 1.0)), Some((base, -1.0)), None],
                    constraint,
                } if self.angle_constraints[constraint].drive.is_some() => {
                    let [angle, rate] = angles[constraint];
                    let turn = C::from_polar(1.0, angle);
                    let turn_rate = turn * C::new(0.0, rate);
                    let turns = [form(link), form(base)].map(|[turn, _]| turn);
                    let bodies = self.angle_constraints[constraint].turning.iter();
                    turning.extend(bodies.copied().zip(turns));
                    let ([mut zero, mut rates], [base, base_rates]) = (form(link), form(base));
                    zero.add(-turn, &base);
                    rates.add(-turn, &base_rates);
                    rates.add(-turn_rate, &base);
                    zeros.push([zero, rates]);
                }
                Equation::Angle { .. } => return None,
            }
        }
        let system = System::new(self.units.len(), equations, zeros)?;
        Some((system, turning))
    }
}

/// Bodies with the forms of their rotations.
type Turning = Vec<(BodyId, Affine)>;

fn number(v: Vector) -> C {
    C::new(v.x, v.y)
}

fn vector(c: C) -> Vector {
    Vector::new(c.re, c.im)
}

#[cfg(test)]
mod tests;
