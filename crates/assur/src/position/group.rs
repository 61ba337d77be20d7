//! An Assur group of any class, by Newton's method in natural coordinates.
//!
//! The unknowns are places of joints (and directions of links) as complex
//! numbers; every other place is a linear combination of them with constant
//! complex coefficients, since links are rigid (class4 paper, (3)–(5)). What is
//! left are quadratic equations. Derivatives follow order by order from the
//! same Jacobian at the solution: J x⁽ᵏ⁾ = −(what the lower orders leave).

use super::complex::{Complex, product};
use super::elimination::Elimination;
use super::{Anchor, Obstacle, State};
use crate::{Jet, Vector};

/// A complex-linear form of solved quantities and of the unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Form {
    /// What does not change.
    pub(crate) constant: Vector,
    /// Indices of inputs with their coefficients.
    pub(crate) inputs: Vec<(usize, Vector)>,
    /// Indices of unknowns with their coefficients.
    pub(crate) unknowns: Vec<(usize, Vector)>,
}

/// What a group takes from what is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Input {
    /// Where a point of a solved body is.
    Place(Anchor),
    /// A direction of a solved body.
    Direction(Anchor),
}

/// An equation between forms, by their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Equation {
    /// |form|² = 1.
    Unit(usize),
    /// The real part of a form is 0, or its imaginary part.
    Real(usize),
    Imaginary(usize),
    /// A point stays on a line: direction × way = 0.
    Line {
        direction: usize,
        way: usize,
    },
}

/// A group of bodies solved together.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Group {
    pub(crate) inputs: Vec<Input>,
    /// How many complex unknowns, and where theirs begin among those of all groups.
    pub(crate) unknowns: usize,
    pub(crate) offset: usize,
    /// Forms; so many of them, the first, stand in equations.
    pub(crate) forms: Vec<Form>,
    pub(crate) equated: usize,
    pub(crate) equations: Vec<Equation>,
    /// Each body with the forms of its origin and its turn.
    pub(crate) bodies: Vec<(usize, [usize; 2])>,
    /// Where the Jacobian can be other than zero, row by row, and its elimination.
    pub(crate) pattern: Vec<bool>,
    pub(crate) elimination: Elimination,
}

/// Newton's method goes on until a step is this small beside the unknowns.
const CONVERGED: f64 = 1e-14;
/// No more steps are taken, from a guess that is near or from a drawing.
const MOST_STEPS: usize = 30;
/// The equations hold when they are left with this.
const CLOSED: f64 = 1e-12;

impl Group {
    /// None where the equations are not as many as the unknowns. Forms of
    /// equations come first.
    pub(crate) fn new(
        offset: usize,
        unknowns: usize,
        inputs: Vec<Input>,
        forms: Vec<Form>,
        equations: Vec<Equation>,
        bodies: Vec<(usize, [usize; 2])>,
    ) -> Option<Self> {
        let size = 2 * unknowns;
        if equations.len() != size {
            return None;
        }
        let mut pattern = vec![false; size * size];
        for (row, equation) in pattern.chunks_exact_mut(size).zip(&equations) {
            for (unknown, _) in equation.forms().flat_map(|form| &forms[form].unknowns) {
                row[2 * unknown..][..2].fill(true);
            }
        }
        let equated = equations.iter().flat_map(Equation::forms).max();
        Some(Self {
            inputs,
            unknowns,
            offset,
            forms,
            equated: equated.map_or(0, |last| last + 1),
            equations,
            bodies,
            pattern,
            elimination: Elimination::default(),
        })
    }

    /// Solves from the guess in `near`, real and imaginary parts of the unknowns
    /// of all groups; sets the margin of the step to the Jacobian's determinant,
    /// and `state.doubt` to the size of the first correction.
    pub(crate) fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        near: &[f64],
        step: usize,
    ) -> Result<(), Obstacle> {
        state.work.fit(self);
        for (k, input) in self.inputs.iter().enumerate() {
            state.work.inputs[k] = series(state.taken(*input));
        }
        let work = &mut state.work;
        for (value, form) in work.known.iter_mut().zip(&self.forms) {
            *value = form.known(&work.inputs);
        }
        let own = near[2 * self.offset..].chunks_exact(2);
        for (place, guess) in work.unknowns.iter_mut().zip(own) {
            place[0] = Vector::new(guess[0], guess[1]);
        }
        self.newton(state, step)?;
        for order in 1..N {
            self.differentiate(&mut state.work, order);
        }
        self.put(state);
        Ok(())
    }

    /// From now on the Jacobian is eliminated as it had to be where `state` was
    /// solved last.
    pub(crate) fn plan_as<const N: usize>(&mut self, state: &State<N>) {
        self.elimination.clone_from(&state.work.spare);
    }

    fn newton<const N: usize>(&self, state: &mut State<N>, step: usize) -> Result<(), Obstacle> {
        let work = &mut state.work;
        let length = state.scale.sqrt();
        let mut last = f64::INFINITY;
        for turn in 0..MOST_STEPS {
            self.evaluate(work, 0);
            for (left, equation) in work.left.iter_mut().zip(&self.equations) {
                *left = equation.left(&work.values);
            }
            let left = largest(&work.left);
            let determinant = self.factor(work).ok_or(Obstacle::DeadPoint)?;
            state.margins[step] = [Jet::constant(determinant); 2];
            self.substitute(work);
            let change = largest(&work.step);
            if !change.is_finite() {
                return Err(Obstacle::DeadPoint);
            }
            if turn == 0 {
                state.doubt = state.doubt.max(change / length);
            }
            // The last step is not taken where rounding is all it mends: the
            // Jacobian is then that of the solution.
            if change <= CONVERGED * length || (left <= CLOSED && change >= 0.5 * last) {
                return Ok(());
            }
            if turn + 1 == MOST_STEPS {
                return Err(Obstacle::Apart { by: left });
            }
            last = change;
            for (place, step) in work.unknowns.iter_mut().zip(work.step.chunks_exact(2)) {
                place[0] -= Vector::new(step[0], step[1]);
            }
        }
        Err(Obstacle::DeadPoint)
    }

    /// The coefficients of an order of the forms that stand in equations.
    fn evaluate<const N: usize>(&self, work: &mut Work<N>, order: usize) {
        let known = work.known.iter().zip(&self.forms);
        for (value, (known, form)) in work.values.iter_mut().zip(known) {
            value[order] = form.with(known[order], &work.unknowns, order);
        }
    }

    /// Eliminates the Jacobian, as planned or, where that does not suit it, as it
    /// must be; its determinant, none where it is singular.
    fn factor<const N: usize>(&self, work: &mut Work<N>) -> Option<f64> {
        self.jacobian(work);
        let planned = self.elimination.factor(&mut work.jacobian);
        work.planned = planned.is_some();
        planned.or_else(|| {
            self.jacobian(work);
            work.spare.plan(&self.pattern, &mut work.jacobian)
        })
    }

    /// The derivatives of the equations by the unknowns, row by row.
    fn jacobian<const N: usize>(&self, work: &mut Work<N>) {
        let size = 2 * self.unknowns;
        work.jacobian.fill(0.0);
        for (of, equation) in work.jacobian.chunks_exact_mut(size).zip(&self.equations) {
            equation.derivatives(
                |form| &self.forms[form],
                &work.values,
                |unknown, [x, y]| {
                    of[2 * unknown] += x;
                    of[2 * unknown + 1] += y;
                },
            );
        }
    }

    fn substitute<const N: usize>(&self, work: &mut Work<N>) {
        let Work {
            jacobian,
            left,
            step,
            spare,
            planned,
            ..
        } = work;
        let elimination = if *planned { &self.elimination } else { spare };
        elimination.solve(jacobian, left, step);
    }

    /// The coefficients of an order from those below it: all equations are
    /// quadratic, so that of an order holds the new ones linearly.
    fn differentiate<const N: usize>(&self, work: &mut Work<N>, order: usize) {
        for (value, known) in work.values.iter_mut().zip(&work.known) {
            value[order] = known[order];
        }
        for (left, equation) in work.left.iter_mut().zip(&self.equations) {
            *left = equation.coefficient(&work.values, order);
        }
        self.substitute(work);
        for (place, step) in work.unknowns.iter_mut().zip(work.step.chunks_exact(2)) {
            place[order] = Vector::new(-step[0], -step[1]);
        }
        self.evaluate(work, order);
    }

    /// Puts what was found where it is looked for.
    fn put<const N: usize>(&self, state: &mut State<N>) {
        let work = &state.work;
        let natural = &mut state.natural[self.offset..];
        for (place, found) in natural.iter_mut().zip(&work.unknowns) {
            *place = complex(found);
        }
        for (body, forms) in &self.bodies {
            let [origin, turn] = forms.map(|form| match work.values.get(form) {
                Some(value) => complex(value),
                None => complex(&self.forms[form].value(work)),
            });
            state.origin[*body] = origin;
            state.turn[*body] = turn;
        }
    }
}

impl Equation {
    /// The forms that stand in it.
    fn forms(&self) -> impl Iterator<Item = usize> + use<> {
        let forms = match *self {
            Self::Unit(form) | Self::Real(form) | Self::Imaginary(form) => [Some(form), None],
            Self::Line { direction, way } => [Some(direction), Some(way)],
        };
        forms.into_iter().flatten()
    }

    /// What is left of it.
    fn left<const N: usize>(&self, values: &[Series<N>]) -> f64 {
        let constant = match self {
            Self::Unit(_) => 0.5,
            Self::Real(_) | Self::Imaginary(_) | Self::Line { .. } => 0.0,
        };
        self.coefficient(values, 0) - constant
    }

    /// Its coefficient of an order.
    fn coefficient<const N: usize>(&self, values: &[Series<N>], order: usize) -> f64 {
        match *self {
            Self::Unit(form) => {
                let v = &values[form];
                let terms = (0..=order).map(|k| v[k].dot(&v[order - k]));
                0.5 * terms.sum::<f64>()
            }
            Self::Real(form) => values[form][order].x,
            Self::Imaginary(form) => values[form][order].y,
            Self::Line { direction, way } => {
                let [u, v] = [direction, way].map(|form| &values[form]);
                (0..=order).map(|k| u[k].perp(&v[order - k])).sum()
            }
        }
    }

    /// Tells its derivatives by real and imaginary part of each unknown; one
    /// unknown may come twice.
    fn derivatives<'a, const N: usize>(
        &self,
        form: impl Fn(usize) -> &'a Form,
        values: &[Series<N>],
        mut tell: impl FnMut(usize, [f64; 2]),
    ) {
        let mut along = |index: usize, by: Vector| {
            for (unknown, c) in &form(index).unknowns {
                tell(*unknown, [c.dot(&by), c.perp(&by)]);
            }
        };
        match *self {
            Self::Unit(form) => along(form, values[form][0]),
            Self::Real(form) => along(form, Vector::x()),
            Self::Imaginary(form) => along(form, Vector::y()),
            Self::Line { direction, way } => {
                let [u, v] = [direction, way].map(|form| values[form][0]);
                // u × v = u · (v turned to the right) = v · (u turned to the left).
                along(direction, Vector::new(v.y, -v.x));
                along(way, Vector::new(-u.y, u.x));
            }
        }
    }
}

impl Form {
    /// What of it is known before the group is solved.
    fn known<const N: usize>(&self, inputs: &[Series<N>]) -> Series<N> {
        let mut value = [Vector::zeros(); N];
        value[0] = self.constant;
        for (input, c) in &self.inputs {
            for (value, v) in value.iter_mut().zip(&inputs[*input]) {
                *value += product(*c, *v);
            }
        }
        value
    }

    /// A coefficient of it, with the same of what is known of it.
    fn with<const N: usize>(&self, known: Vector, unknowns: &[Series<N>], order: usize) -> Vector {
        let terms = self.unknowns.iter();
        terms.fold(known, |sum, (k, c)| sum + product(*c, unknowns[*k][order]))
    }

    fn value<const N: usize>(&self, work: &Work<N>) -> Series<N> {
        let known = self.known(&work.inputs);
        std::array::from_fn(|order| self.with(known[order], &work.unknowns, order))
    }
}

/// The coefficients of a place, order by order.
type Series<const N: usize> = [Vector; N];

fn series<const N: usize>(place: Complex<N>) -> Series<N> {
    std::array::from_fn(|k| Vector::new(place.x.coefficient(k), place.y.coefficient(k)))
}

fn complex<const N: usize>(series: &Series<N>) -> Complex<N> {
    let [x, y] = [0, 1].map(|k| Jet::from_coefficients(series.map(|c| c[k])));
    Complex::new(x, y)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Room for the sums of a group, made once and used for every sample.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work<const N: usize> {
    inputs: Vec<Series<N>>,
    /// Of the forms that stand in equations what is known, and the whole.
    known: Vec<Series<N>>,
    values: Vec<Series<N>>,
    unknowns: Vec<Series<N>>,
    /// What is left of the equations, and the step that this asks for.
    left: Vec<f64>,
    step: Vec<f64>,
    jacobian: Vec<f64>,
    /// Whether it was eliminated as planned for the group; else as planned here.
    planned: bool,
    spare: Elimination,
}

impl<const N: usize> Work<N> {
    fn fit(&mut self, group: &Group) {
        let size = 2 * group.unknowns;
        let nothing = [Vector::zeros(); N];
        self.inputs.resize(group.inputs.len(), nothing);
        self.known.resize(group.equated, nothing);
        self.values.resize(group.equated, nothing);
        self.unknowns.resize(group.unknowns, nothing);
        self.left.resize(size, 0.0);
        self.step.resize(size, 0.0);
        self.jacobian.resize(size * size, 0.0);
        self.spare.fit(size);
    }
}
