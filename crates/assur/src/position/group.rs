//! An Assur group of any class, by Newton's method in natural coordinates.
//!
//! The unknowns are places of joints (and directions of links) as complex
//! numbers; every other place is a linear combination of them with constant
//! complex coefficients, since links are rigid (class4 paper, (3)–(5)). What is
//! left are quadratic equations. Derivatives follow order by order from the
//! same Jacobian at the solution: J x⁽ᵏ⁾ = −(what the lower orders leave).

use super::complex::Complex;
use super::{Anchor, Obstacle, State};
use crate::{Jet, Vector};

/// A complex-linear form of solved quantities and of the unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Form {
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
    /// form = 0: two real equations.
    Zero(usize),
    /// A point keeps its distance to the left of a line: direction × way = off.
    Line {
        direction: usize,
        way: usize,
        off: f64,
    },
}

/// A group of bodies solved together.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Group {
    pub(crate) inputs: Vec<Input>,
    /// How many complex unknowns, and where theirs begin among those of all groups.
    pub(crate) unknowns: usize,
    pub(crate) offset: usize,
    pub(crate) forms: Vec<Form>,
    pub(crate) equations: Vec<Equation>,
    /// Each body with the forms of its origin and its turn.
    pub(crate) bodies: Vec<(usize, [usize; 2])>,
}

/// Newton's method goes on until a step is this small beside the unknowns.
const CONVERGED: f64 = 1e-14;
/// No more steps are taken, from a guess that is near or from a drawing.
const MOST_STEPS: usize = 30;
/// The equations hold when they are left with this.
const CLOSED: f64 = 1e-12;

impl Group {
    /// Solves from the guess in `near`, real and imaginary parts of the unknowns
    /// of all groups; sets the margin of the step to the Jacobian's determinant,
    /// and `state.doubt` to the size of the first correction.
    pub(crate) fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        near: &[f64],
        step: usize,
    ) -> Result<(), Obstacle> {
        let mut work = std::mem::take(&mut state.work);
        let solved = self.newton(state, near, step, &mut work);
        state.work = work;
        solved
    }

    fn newton<const N: usize>(
        &self,
        state: &mut State<N>,
        near: &[f64],
        step: usize,
        work: &mut Work,
    ) -> Result<(), Obstacle> {
        let size = 2 * self.unknowns;
        work.fit(self);
        let inputs = |state: &State<N>, work: &mut Work, order: usize| {
            for (value, input) in work.inputs.iter_mut().zip(&self.inputs) {
                *value = state.taken(*input, order);
            }
        };
        inputs(state, work, 0);
        let own = 2 * self.offset..2 * self.offset + size;
        work.x.copy_from_slice(&near[own]);
        let length = state.scale.sqrt();
        let mut last = f64::INFINITY;
        for turn in 0..MOST_STEPS {
            self.evaluate(work);
            let left = work
                .residual
                .iter()
                .fold(0.0, |most: f64, r| most.max(r.abs()));
            self.jacobian(work);
            let Some(determinant) = factor(&mut work.jacobian, &mut work.rows, size) else {
                return Err(Obstacle::DeadPoint);
            };
            state.margins[step] = [Jet::constant(determinant); 2];
            work.step.copy_from_slice(&work.residual);
            substitute(
                &work.jacobian,
                &work.rows,
                &mut work.step,
                size,
                &mut work.sorted,
            );
            let change = work.step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
            if !change.is_finite() {
                return Err(Obstacle::DeadPoint);
            }
            if turn == 0 {
                state.doubt = state.doubt.max(change / length);
            }
            // The last step is not taken where rounding is all it mends: the
            // Jacobian is then that of the solution.
            if change <= CONVERGED * length || (left <= CLOSED && change >= 0.5 * last) {
                break;
            }
            if turn + 1 == MOST_STEPS {
                return Err(Obstacle::Apart { by: left });
            }
            last = change;
            for (x, step) in work.x.iter_mut().zip(&work.step) {
                *x -= step;
            }
        }
        self.keep(work, 0);
        for order in 1..N {
            inputs(state, work, order);
            self.differentiate(work, order, size);
        }
        for unknown in 0..self.unknowns {
            let part = |k: usize| {
                let mut coefficients = [0.0; N];
                for (order, c) in coefficients.iter_mut().enumerate() {
                    *c = work.orders[order][2 * unknown + k];
                }
                Jet::from_coefficients(coefficients)
            };
            state.natural[self.offset + unknown] = Complex::new(part(0), part(1));
        }
        for (body, [origin, turn]) in &self.bodies {
            let form = |index: usize| {
                let part = |k: usize| {
                    let mut coefficients = [0.0; N];
                    for (order, c) in coefficients.iter_mut().enumerate() {
                        *c = work.forms[order][index][k];
                    }
                    Jet::from_coefficients(coefficients)
                };
                Complex::new(part(0), part(1))
            };
            state.origin[*body] = form(*origin);
            state.turn[*body] = form(*turn);
        }
        Ok(())
    }

    /// The values of forms and equations at `work.x`.
    fn evaluate(&self, work: &mut Work) {
        for (value, form) in work.values.iter_mut().zip(&self.forms) {
            *value = form.value(&work.inputs, &work.x);
        }
        let mut row = 0;
        for equation in &self.equations {
            match *equation {
                Equation::Unit(form) => {
                    work.residual[row] = 0.5 * (work.values[form].norm_squared() - 1.0);
                    row += 1;
                }
                Equation::Zero(form) => {
                    let value = work.values[form];
                    (work.residual[row], work.residual[row + 1]) = (value.x, value.y);
                    row += 2;
                }
                Equation::Line {
                    direction,
                    way,
                    off,
                } => {
                    work.residual[row] = work.values[direction].perp(&work.values[way]) - off;
                    row += 1;
                }
            }
        }
    }

    /// The derivatives of the equations by the unknowns, row by row.
    fn jacobian(&self, work: &mut Work) {
        let size = 2 * self.unknowns;
        work.jacobian.fill(0.0);
        let mut row = 0;
        for equation in &self.equations {
            match *equation {
                Equation::Unit(form) => {
                    let value = work.values[form];
                    let of = &mut work.jacobian[row * size..(row + 1) * size];
                    for (unknown, c) in &self.forms[form].unknowns {
                        of[2 * unknown] += value.dot(c);
                        of[2 * unknown + 1] += value.dot(&left(*c));
                    }
                    row += 1;
                }
                Equation::Zero(form) => {
                    for (unknown, c) in &self.forms[form].unknowns {
                        for (k, c) in [*c, left(*c)].into_iter().enumerate() {
                            work.jacobian[row * size + 2 * unknown + k] += c.x;
                            work.jacobian[(row + 1) * size + 2 * unknown + k] += c.y;
                        }
                    }
                    row += 2;
                }
                Equation::Line { direction, way, .. } => {
                    let [along, between] = [direction, way].map(|form| work.values[form]);
                    let of = &mut work.jacobian[row * size..(row + 1) * size];
                    for (unknown, c) in &self.forms[direction].unknowns {
                        of[2 * unknown] += c.perp(&between);
                        of[2 * unknown + 1] += left(*c).perp(&between);
                    }
                    for (unknown, c) in &self.forms[way].unknowns {
                        of[2 * unknown] += along.perp(c);
                        of[2 * unknown + 1] += along.perp(&left(*c));
                    }
                    row += 1;
                }
            }
        }
    }

    /// Keeps the unknowns and forms as the coefficients of an order.
    fn keep(&self, work: &mut Work, order: usize) {
        let Work {
            orders,
            forms,
            x,
            values,
            ..
        } = work;
        orders[order].copy_from_slice(x);
        forms[order].copy_from_slice(values);
    }

    /// The coefficients of an order from those below it: all equations are
    /// quadratic, so that of an order holds the new ones linearly.
    fn differentiate(&self, work: &mut Work, order: usize, size: usize) {
        work.x.fill(0.0);
        for (value, form) in work.values.iter_mut().zip(&self.forms) {
            *value = form.value(&work.inputs, &work.x);
        }
        let of = |work: &Work, k: usize, form: usize| {
            if k == order {
                work.values[form]
            } else {
                work.forms[k][form]
            }
        };
        let mut row = 0;
        for equation in &self.equations {
            match *equation {
                Equation::Unit(form) => {
                    let terms =
                        (0..=order).map(|k| of(work, k, form).dot(&of(work, order - k, form)));
                    work.step[row] = 0.5 * terms.sum::<f64>();
                    row += 1;
                }
                Equation::Zero(form) => {
                    let value = work.values[form];
                    (work.step[row], work.step[row + 1]) = (value.x, value.y);
                    row += 2;
                }
                Equation::Line { direction, way, .. } => {
                    let terms =
                        (0..=order).map(|k| of(work, k, direction).perp(&of(work, order - k, way)));
                    work.step[row] = terms.sum();
                    row += 1;
                }
            }
        }
        substitute(
            &work.jacobian,
            &work.rows,
            &mut work.step,
            size,
            &mut work.sorted,
        );
        for (x, step) in work.x.iter_mut().zip(&work.step) {
            *x = -step;
        }
        for (value, form) in work.values.iter_mut().zip(&self.forms) {
            *value = form.value(&work.inputs, &work.x);
        }
        self.keep(work, order);
    }
}

impl Form {
    fn value(&self, inputs: &[Vector], x: &[f64]) -> Vector {
        let mut value = Vector::zeros();
        for (input, c) in &self.inputs {
            let v = inputs[*input];
            value.x += c.x * v.x - c.y * v.y;
            value.y += c.x * v.y + c.y * v.x;
        }
        for (unknown, c) in &self.unknowns {
            let [u, v] = [x[2 * unknown], x[2 * unknown + 1]];
            value.x += c.x * u - c.y * v;
            value.y += c.x * v + c.y * u;
        }
        value
    }
}

/// Room for the sums of a group, made once and used for every sample.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work {
    inputs: Vec<Vector>,
    values: Vec<Vector>,
    x: Vec<f64>,
    residual: Vec<f64>,
    step: Vec<f64>,
    sorted: Vec<f64>,
    jacobian: Vec<f64>,
    rows: Vec<usize>,
    /// Coefficients of unknowns and forms, order by order.
    orders: Vec<Vec<f64>>,
    forms: Vec<Vec<Vector>>,
}

/// Orders a group is ever asked for: a value and seven derivatives.
const ORDERS: usize = 8;

impl Work {
    fn fit(&mut self, group: &Group) {
        let size = 2 * group.unknowns;
        if self.x.len() == size
            && self.values.len() == group.forms.len()
            && self.inputs.len() == group.inputs.len()
        {
            return;
        }
        self.inputs.resize(group.inputs.len(), Vector::zeros());
        self.values.resize(group.forms.len(), Vector::zeros());
        for list in [
            &mut self.x,
            &mut self.residual,
            &mut self.step,
            &mut self.sorted,
        ] {
            list.resize(size, 0.0);
        }
        self.jacobian.resize(size * size, 0.0);
        self.rows.resize(size, 0);
        self.orders.resize(ORDERS, Vec::new());
        self.forms.resize(ORDERS, Vec::new());
        for order in 0..ORDERS {
            self.orders[order].resize(size, 0.0);
            self.forms[order].resize(group.forms.len(), Vector::zeros());
        }
    }
}

fn left(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

/// Factors a square matrix in place, rows interchanged; its determinant, none
/// where it is singular.
fn factor(matrix: &mut [f64], rows: &mut [usize], size: usize) -> Option<f64> {
    let mut determinant = 1.0;
    for (k, row) in rows.iter_mut().enumerate() {
        *row = k;
    }
    for k in 0..size {
        let mut pivot = k;
        for i in k + 1..size {
            if matrix[rows[i] * size + k].abs() > matrix[rows[pivot] * size + k].abs() {
                pivot = i;
            }
        }
        if pivot != k {
            rows.swap(pivot, k);
            determinant = -determinant;
        }
        let at = rows[k] * size;
        let divisor = matrix[at + k];
        if divisor == 0.0 || !divisor.is_finite() {
            return None;
        }
        determinant *= divisor;
        for row in &rows[k + 1..] {
            let below = row * size;
            let factor = matrix[below + k] / divisor;
            matrix[below + k] = factor;
            if factor != 0.0 {
                for j in k + 1..size {
                    matrix[below + j] -= factor * matrix[at + j];
                }
            }
        }
    }
    Some(determinant)
}

/// Solves with a factored matrix; `values` becomes the solution.
fn substitute(matrix: &[f64], rows: &[usize], values: &mut [f64], size: usize, sorted: &mut [f64]) {
    for i in 0..size {
        let at = rows[i] * size;
        let mut value = values[rows[i]];
        for j in 0..i {
            value -= matrix[at + j] * sorted[j];
        }
        sorted[i] = value;
    }
    for i in (0..size).rev() {
        let at = rows[i] * size;
        let mut value = sorted[i];
        for j in i + 1..size {
            value -= matrix[at + j] * values[j];
        }
        values[i] = value / matrix[at + i];
    }
}
