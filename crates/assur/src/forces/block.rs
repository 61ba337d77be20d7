//! Equilibrium of the bodies of a block, solved for the components of the block's pairs and drives.

use nalgebra::{DMatrix, DVector};

use super::pair::{Component, Placed, Wrench, heading};
use crate::Vector;
use crate::index::{BodyId, List, StepId};
use crate::numeric::elimination::Elimination;
use crate::position::State;
use crate::tolerance;

/// Force on a body, and its moment about the body's origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Total {
    pub(super) force: Vector,
    pub(super) moment: f64,
}

/// Bodies that are in equilibrium together, with the components that act on them and on no body of a later block.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) step: StepId,
    pub(super) bodies: Vec<BodyId>,
    /// Indices of the components.
    pub(super) components: Vec<usize>,
    pub(super) form: Form,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    /// A driven body, with its outer pair and its drive.
    Driven { pair: Held, drive: usize },
    /// A dyad: two bodies, each with its outer pair, and the inner pair between them.
    Dyad { outer: [Held; 2], inner: [usize; 2] },
    /// As many components as equations: a matrix with a sparsity pattern.
    Group { pattern: Vec<bool> },
    /// The whole mechanism, with more components than equations.
    Redundant,
}

/// Lower pair that holds a body: its two components. It leaves one freedom, in which its reaction does no work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Held(pub(super) [usize; 2]);

/// Freedom that a pair leaves to a body.
#[derive(Clone, Copy, Debug)]
enum Freedom {
    /// Rotation about a hinge.
    About(Vector),
    /// Translation along a guide, with the sliding point.
    Along(Vector, Vector),
}

impl Freedom {
    fn of(component: &Component, placed: &Placed, state: &State<3>) -> Self {
        match component.wrench {
            Wrench::Normal(guide) => Self::Along(heading(state, &guide), placed.at),
            _ => Self::About(placed.at),
        }
    }

    /// Power of a force at a place, and of a couple, in a unit of the freedom.
    fn power(&self, force: Vector, at: Vector, couple: f64) -> f64 {
        match self {
            Self::About(hinge) => (at - hinge).perp(&force) + couple,
            Self::Along(direction, _) => direction.dot(&force),
        }
    }
}

/// Numbers of one pose, and buffers that are used for every pose.
pub(super) struct Work<'a> {
    pub(super) state: &'a State<3>,
    pub(super) components: &'a [Component],
    pub(super) placed: &'a [Placed],
    pub(super) totals: &'a mut List<BodyId, Total>,
    /// Values of the components found so far.
    pub(super) values: &'a mut [f64],
    /// Length by which couples are divided.
    pub(super) size: f64,
    pub(super) matrix: &'a mut Matrix,
}

/// Buffers of a group's linear system, with the plan of its elimination.
#[derive(Clone, Debug, Default)]
pub(super) struct Matrix {
    elimination: Elimination,
    entries: Vec<f64>,
    right: Vec<[f64; 1]>,
    solution: Vec<[f64; 1]>,
}

impl Block {
    /// Finds the components; None if the pose is singular.
    pub(super) fn solve(&self, work: &mut Work<'_>) -> Option<()> {
        match &self.form {
            Form::Driven { pair, drive } => self.driven(work, pair, *drive),
            Form::Dyad { outer, inner } => self.dyad(work, outer, *inner),
            Form::Group { pattern } => self.group(work, pattern),
            Form::Redundant => None,
        }
    }

    fn driven(&self, work: &mut Work<'_>, pair: &Held, drive: usize) -> Option<()> {
        let body = self.bodies[0];
        let freedom = work.freedom(pair);
        let own = work.power(body, drive, &freedom);
        work.take(drive, -work.total_power(body, &freedom) / own)?;
        work.hold(body, pair, &freedom)
    }

    /// No power is done on a link in the freedom that its outer pair leaves: two equations for the inner pair. Then each
    /// outer pair balances the rest.
    fn dyad(&self, work: &mut Work<'_>, outer: &[Held; 2], inner: [usize; 2]) -> Option<()> {
        let freedoms = outer.each_ref().map(|pair| work.freedom(pair));
        let rows: [[f64; 3]; 2] = std::array::from_fn(|k| {
            let body = self.bodies[k];
            let [a, b] = inner.map(|component| work.power(body, component, &freedoms[k]));
            [a, b, -work.total_power(body, &freedoms[k])]
        });
        let [mut first, mut second] = rows;
        if second[0].abs() * first[1].abs() > first[0].abs() * second[1].abs() {
            std::mem::swap(&mut first, &mut second);
        }
        // |a d| is the greater of the two products of the determinant ad − bc.
        let (a, d) = (first[0], second[1]);
        let determinant = a * d - first[1] * second[0];
        if determinant == 0.0 {
            return None;
        }
        let x = (first[2] * d - first[1] * second[2]) / determinant;
        let y = (a * second[2] - second[0] * first[2]) / determinant;
        work.take_both(inner, [x, y])?;
        for k in 0..2 {
            work.hold(self.bodies[k], &outer[k], &freedoms[k])?;
        }
        Some(())
    }

    /// Index of the first row of a body; None for a body of another block.
    fn row(&self, body: BodyId) -> Option<usize> {
        let index = self.bodies.iter().position(|own| *own == body);
        index.map(|index| 3 * index)
    }

    fn group(&self, work: &mut Work<'_>, pattern: &[bool]) -> Option<()> {
        let size = self.components.len();
        let mut matrix = std::mem::take(work.matrix);
        matrix.entries.clear();
        matrix.entries.resize(size * size, 0.0);
        self.fill(work, |row, column, value| {
            matrix.entries[row * size + column] += value;
        });
        let planned = matrix.elimination.factor(&mut matrix.entries);
        if planned.is_none() {
            matrix.entries.fill(0.0);
            self.fill(work, |row, column, value| {
                matrix.entries[row * size + column] += value;
            });
            matrix.elimination.fit([size; 2]);
            matrix.elimination.plan(pattern, &mut matrix.entries)?;
        }
        matrix.right.clear();
        matrix.right.extend(self.right(work).map(|value| [value]));
        matrix.solution.clear();
        matrix.solution.resize(size, [0.0]);
        let Matrix {
            elimination,
            entries,
            right,
            solution,
        } = &mut matrix;
        elimination.solve(entries, right, solution);
        for (component, [value]) in self.components.iter().zip(&matrix.solution) {
            work.take(*component, *value)?;
        }
        *work.matrix = matrix;
        Some(())
    }

    /// Sparsity pattern of the matrix of a group.
    pub(super) fn pattern(&self, components: &[Component]) -> Vec<bool> {
        let size = self.components.len();
        let mut pattern = vec![false; 3 * self.bodies.len() * size];
        for (column, component) in self.components.iter().enumerate() {
            let component = &components[*component];
            let rows: &[usize] = match component.wrench {
                Wrench::X(_) => &[0, 2],
                Wrench::Y(_) => &[1, 2],
                Wrench::Normal(_) | Wrench::Along(_) | Wrench::Tangent(..) => &[0, 1, 2],
                Wrench::Couple | Wrench::Couples(_) => &[2],
            };
            for row in component.on().filter_map(|body| self.row(body)) {
                for k in rows {
                    pattern[(row + k) * size + column] = true;
                }
            }
        }
        pattern
    }

    /// Gives every entry of the matrix: the force and the moment of each component on each body.
    fn fill(&self, work: &Work<'_>, mut add: impl FnMut(usize, usize, f64)) {
        for (column, index) in self.components.iter().enumerate() {
            let (component, placed) = (&work.components[*index], &work.placed[*index]);
            for (k, body) in component.on().enumerate() {
                let Some(row) = self.row(body) else { continue };
                let total = wrench_on(work.state, placed, k, body, work.size);
                if total.force.x != 0.0 {
                    add(row, column, total.force.x);
                }
                if total.force.y != 0.0 {
                    add(row + 1, column, total.force.y);
                }
                add(row + 2, column, total.moment / work.size);
            }
        }
    }

    fn right(&self, work: &Work<'_>) -> impl Iterator<Item = f64> {
        let size = work.size;
        let totals = self.bodies.iter().map(|body| work.totals[*body]);
        totals.flat_map(move |total| [-total.force.x, -total.force.y, -total.moment / size])
    }

    /// Solution of least norm of a redundant mechanism. A component that other solutions give another value becomes
    /// None.
    pub(super) fn redundant(&self, work: &mut Work<'_>, found: &mut [Option<f64>]) -> Option<()> {
        let (rows, columns) = (3 * self.bodies.len(), self.components.len());
        let mut matrix = DMatrix::zeros(rows, columns);
        self.fill(work, |row, column, value| matrix[(row, column)] += value);
        let right = DVector::from_iterator(rows, self.right(work));
        let svd = matrix.clone().svd(true, true);
        let zero = tolerance::COINCIDENT * svd.singular_values.max();
        let solution = svd.solve(&right, zero).ok()?;
        let residual = &matrix * &solution - &right;
        if residual.amax() > tolerance::COINCIDENT * right.amax().max(solution.amax()) {
            return None;
        }
        let space = svd.v_t.as_ref()?;
        let spanning = svd.singular_values.iter().enumerate();
        let spanning: Vec<usize> = spanning
            .filter(|(_, value)| **value > zero)
            .map(|(row, _)| row)
            .collect();
        for (column, component) in self.components.iter().enumerate() {
            let inside = spanning.iter().map(|row| space[(*row, column)].powi(2));
            let is_free = 1.0 - inside.sum::<f64>() > tolerance::COINCIDENT;
            work.values[*component] = solution[column];
            found[*component] = (!is_free).then_some(solution[column]);
        }
        Some(())
    }
}

/// Wrench of a unit of a component on one of its bodies: the first, the second or the carrier.
fn wrench_on(state: &State<3>, placed: &Placed, which: usize, body: BodyId, size: f64) -> Total {
    let sign = [1.0, -1.0, 0.0][which];
    let force = placed.force * sign;
    let arm = placed.at - state.bodies[body].origin[0];
    Total {
        force,
        moment: arm.perp(&force) + placed.couples[which] * size,
    }
}

impl Work<'_> {
    fn freedom(&self, Held([first, _]): &Held) -> Freedom {
        Freedom::of(&self.components[*first], &self.placed[*first], self.state)
    }

    /// Power of a unit of a component on a body of its two bodies.
    fn power(&self, body: BodyId, component: usize, freedom: &Freedom) -> f64 {
        let placed = &self.placed[component];
        let sign = self.sign(body, component);
        let couple = placed.couples[0] * self.size;
        sign * freedom.power(placed.force, placed.at, couple)
    }

    fn sign(&self, body: BodyId, component: usize) -> f64 {
        if self.components[component].bodies[0] == body {
            1.0
        } else {
            -1.0
        }
    }

    /// Power of all that is known to act on a body.
    fn total_power(&self, body: BodyId, freedom: &Freedom) -> f64 {
        let total = &self.totals[body];
        freedom.power(total.force, self.state.bodies[body].origin[0], total.moment)
    }

    /// Sets the components of a pair so that all on a body is balanced.
    fn hold(&mut self, body: BodyId, pair: &Held, freedom: &Freedom) -> Option<()> {
        let total = self.totals[body];
        let first = pair.0[0];
        let sign = -self.sign(body, first);
        let values = match freedom {
            Freedom::About(_) => [sign * total.force.x, sign * total.force.y],
            Freedom::Along(_, at) => {
                let normal = self.placed[first].force;
                let arm = self.state.bodies[body].origin[0] - at;
                let moment = arm.perp(&total.force) + total.moment;
                [sign * normal.dot(&total.force), sign * moment / self.size]
            }
        };
        self.take_both(pair.0, values)
    }

    /// Sets both components of a lower pair and lets its reaction act on the two bodies; None if a value is not finite.
    fn take_both(&mut self, pair: [usize; 2], values: [f64; 2]) -> Option<()> {
        let [one, other] = pair.map(|component| &self.placed[component]);
        let [x, y] = values;
        (self.values[pair[0]], self.values[pair[1]]) = (x, y);
        let force = one.force * x + other.force * y;
        let couple = (one.couples[0] * x + other.couples[0] * y) * self.size;
        let [acted, base] = self.components[pair[0]].bodies;
        for (body, sign) in [(acted, 1.0), (base, -1.0)] {
            let arm = one.at - self.state.bodies[body].origin[0];
            let total = &mut self.totals[body];
            total.force += force * sign;
            total.moment += (arm.perp(&force) + couple) * sign;
        }
        (x.is_finite() && y.is_finite()).then_some(())
    }

    /// Sets the value of a component and lets it act on its bodies; None if the value is not finite.
    fn take(&mut self, component: usize, value: f64) -> Option<()> {
        self.values[component] = value;
        let placed = &self.placed[component];
        for (k, body) in self.components[component].on().enumerate() {
            let unit = wrench_on(self.state, placed, k, body, self.size);
            let total = &mut self.totals[body];
            total.force += unit.force * value;
            total.moment += unit.moment * value;
        }
        value.is_finite().then_some(())
    }
}
