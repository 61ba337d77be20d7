//! What bounds the motion of a group of higher class over a step of the input.
//!
//! Its equations are quadratic in the unknowns X and in what it takes from solved bodies, but for wheels in mesh, whose
//! angles have bounded second derivatives as well. Along the tangent X₀ + t X₀′ the equations are left with t²/2 times
//! what is known (`defect`), and the Jacobian J differs from the one where the step begins by what the tangent and the
//! distance from it allow. With A = J₀⁻¹, where ‖A (J − J₀)‖ ≤ q ≤ ½ over a ball as wide as twice the first correction,
//! there is just one solution in it (Kantorovich), it depends continuously on the input, and J is regular: the
//! determinant keeps its sign, so that the step has no singular pose, no other assembly and no flight to infinity.

use super::equation::{Equation, MOST_FORMS};
use super::{Group, KnownTerm};
use crate::index::StepId;
use crate::position::enclosure::{AT_ONCE, Bounds, Enclosure, REGULAR};
use crate::position::{Predictor, Vector};

/// What is known of a form: value and derivative where the step begins, what its second derivative is at most by what
/// is solved, and how much it changes with the unknowns.
#[derive(Clone, Copy)]
struct Known {
    value: Vector,
    rate: Vector,
    acceleration: f64,
    by_unknowns: f64,
}

impl Known {
    /// How far it is at most from where it begins, on the tangent.
    fn travels(&self, step_len: f64) -> f64 {
        step_len * self.rate.norm() + 0.5 * step_len * step_len * self.acceleration
    }

    /// The same within a distance of the unknowns from it.
    fn deviations(&self, step_len: f64, radius: f64) -> f64 {
        self.travels(step_len) + self.by_unknowns * radius
    }
}

impl Group {
    /// See [`super::Solvable::enclose`].
    pub(in crate::position) fn certified(
        &self,
        step: StepId,
        from: &Predictor,
        cell: &mut Enclosure,
    ) -> bool {
        cell.work.fit(self);
        self.linearize(from, cell);
        if !self.invert(cell) {
            return false;
        }
        let step_len = cell.step_len;
        let half_square = 0.5 * step_len * step_len;
        // What the equations are left with on the tangent, by t²/2; how the Jacobian changes along it; and how with
        // the distance from it.
        let spins = |mesh: usize, cell: &Enclosure| -> f64 {
            let known = self.angle_constraints[mesh].known.iter();
            known
                .map(|(body, by)| cell.angular_acceleration(*body) * by.abs())
                .sum()
        };
        for (row, equation) in self.equations.iter().enumerate() {
            let known = |form: usize| self.known(cell, form);
            let travels = |form: &Known| form.travels(step_len);
            let far = |form: &Known| form.value.norm() + step_len * form.rate.norm();
            let sums = match *equation {
                Equation::Unit(form) => {
                    let f = known(form);
                    let defect = f.rate.norm_squared()
                        + (far(&f) + 0.5 * half_square * f.acceleration) * f.acceleration;
                    [defect, f.by_unknowns * travels(&f), f.by_unknowns.powi(2)]
                }
                Equation::Real(form) | Equation::Imaginary(form) => {
                    [known(form).acceleration, 0.0, 0.0]
                }
                Equation::Line { direction, way } | Equation::Along { direction, way, .. } => {
                    let [u, v] = [known(direction), known(way)];
                    let rates = match equation {
                        Equation::Along { .. } => u.rate.dot(&v.rate),
                        _ => u.rate.perp(&v.rate),
                    };
                    let defect = 2.0 * rates.abs()
                        + (far(&v) + half_square * v.acceleration) * u.acceleration
                        + far(&u) * v.acceleration;
                    let changes = u.by_unknowns * travels(&v) + v.by_unknowns * travels(&u);
                    [defect, changes, 2.0 * u.by_unknowns * v.by_unknowns]
                }
                Equation::Angle { turns, mesh } => {
                    // The angle of f has the gradient 1/|f|; |f| stays above ½.
                    let turns = turns.into_iter().flatten();
                    turns.fold(
                        [spins(mesh, cell), 0.0, 0.0],
                        |[defect, changes, off], (form, by)| {
                            let (f, by) = (known(form), by.abs());
                            let rate = f.rate.norm_squared();
                            [
                                defect + by * (rate + 2.0 * f.acceleration),
                                changes + 4.0 * by * f.by_unknowns * travels(&f),
                                off + 4.0 * by * f.by_unknowns.powi(2),
                            ]
                        },
                    )
                }
            };
            cell.bounds.sums[row] = sums;
        }
        let [defect, changes, off] = self.weighed(cell);
        // The ball has the radius of twice the first correction.
        let radius = 2.0 * half_square * defect;
        let change = changes + off * radius;
        if change.is_nan() || change > REGULAR || !self.turns_little(cell, radius) {
            return false;
        }
        cell.deviations[step] = radius;
        cell.jacobian_change = cell.jacobian_change.max(change);
        let inverse = (1.0 - change).recip();

        // By how much the rates of the unknowns differ from those where the step begins …
        for (row, equation) in self.equations.iter().enumerate() {
            let known = |form: usize| self.known(cell, form);
            let off = |form: &Known| form.deviations(step_len, radius);
            let defect = match *equation {
                Equation::Unit(form) => {
                    let f = known(form);
                    off(&f) * f.rate.norm() + step_len * f.acceleration
                }
                Equation::Real(form) | Equation::Imaginary(form) => {
                    step_len * known(form).acceleration
                }
                Equation::Line { direction, way } | Equation::Along { direction, way, .. } => {
                    let [u, v] = [known(direction), known(way)];
                    u.rate.norm() * off(&v)
                        + v.rate.norm() * off(&u)
                        + step_len * u.acceleration * (v.value.norm() + off(&v))
                        + step_len * v.acceleration * (u.value.norm() + off(&u))
                }
                Equation::Angle { turns, mesh } => {
                    let turns = turns.into_iter().flatten();
                    turns.fold(step_len * spins(mesh, cell), |sum, (form, by)| {
                        let f = known(form);
                        sum + by.abs() * (off(&f) * f.rate.norm() + step_len * f.acceleration)
                    })
                }
            };
            cell.bounds.sums[row] = [defect, 0.0, 0.0];
        }
        let [rate_off] = self.weighed(cell);
        let rate_off = inverse * rate_off;
        // … and with that what their second derivatives are at most.
        for (row, equation) in self.equations.iter().enumerate() {
            let known = |form: usize| self.known(cell, form);
            let off = |form: &Known| form.deviations(step_len, radius);
            let speed = |form: &Known| {
                form.rate.norm() + step_len * form.acceleration + form.by_unknowns * rate_off
            };
            let acceleration = match *equation {
                Equation::Unit(form) => {
                    let f = known(form);
                    speed(&f).powi(2) + f.acceleration
                }
                Equation::Real(form) | Equation::Imaginary(form) => known(form).acceleration,
                Equation::Line { direction, way } | Equation::Along { direction, way, .. } => {
                    let [u, v] = [known(direction), known(way)];
                    2.0 * speed(&u) * speed(&v)
                        + u.acceleration * (v.value.norm() + off(&v))
                        + v.acceleration * (u.value.norm() + off(&u))
                }
                Equation::Angle { turns, mesh } => {
                    let turns = turns.into_iter().flatten();
                    turns.fold(spins(mesh, cell), |sum, (form, by)| {
                        sum + by.abs() * known(form).acceleration
                    })
                }
            };
            cell.bounds.sums[row] = [acceleration, 0.0, 0.0];
        }
        let [acceleration] = self.weighed(cell);
        let acceleration = inverse * acceleration;
        for placed in &self.bodies {
            let [origin, turn] = placed.forms.map(|form| {
                let known = self.known(cell, form);
                known.acceleration + known.by_unknowns * acceleration
            });
            cell.set(placed.body, turn, [(Vector::zeros(), origin); 2]);
        }
        acceleration.is_finite()
    }

    /// The values of all forms and of their first derivatives where the step begins, and what their second derivatives
    /// are at most by what is solved.
    fn linearize(&self, from: &Predictor, cell: &mut Enclosure) {
        for (k, input) in self.inputs.iter().enumerate() {
            let acceleration = match input {
                KnownTerm::Place(anchor) => cell.place(from, *anchor).acceleration,
                KnownTerm::Direction(anchor) => {
                    cell.direction_acceleration(from, anchor.body) * anchor.local.norm()
                }
            };
            cell.work.inputs[k] = from.taken(*input).truncated();
            cell.bounds.inputs.resize(self.inputs.len(), 0.0);
            cell.bounds.inputs[k] = acceleration;
        }
        self.take(&mut cell.work);
        for (unknown, found) in cell.work.unknowns.iter_mut().zip(self.own(&from.natural)) {
            *unknown = found.truncated();
        }
        self.add(&mut cell.work, 0);
        self.add(&mut cell.work, 1);
        self.add_further(&mut cell.work);
        self.accelerations(&cell.bounds.inputs, &mut cell.bounds.forms);
        cell.bounds.sums.resize(self.equations.len(), [0.0; 3]);
    }

    /// The inverse of the Jacobian, column by column; zero for a redundant equation that is left out.
    fn invert(&self, cell: &mut Enclosure) -> bool {
        let [rows, size] = [self.equations.len(), 2 * self.unknowns];
        let Enclosure { work, bounds, .. } = cell;
        if self.factor(work).is_none() {
            return false;
        }
        let Bounds {
            inverse,
            units,
            columns,
            ..
        } = bounds;
        inverse.clear();
        columns.resize(size, [0.0; AT_ONCE]);
        let elimination = self.suited(work.planned, &work.spare);
        for first in (0..rows).step_by(AT_ONCE) {
            units.clear();
            units.extend(
                (0..rows)
                    .map(|row| std::array::from_fn(|k| if row == first + k { 1.0 } else { 0.0 })),
            );
            elimination.solve(&work.jacobian, units, columns);
            for k in 0..AT_ONCE.min(rows - first) {
                inverse.extend(columns.iter().map(|column: &[f64; AT_ONCE]| column[k]));
            }
        }
        inverse.iter().all(|value| value.is_finite())
    }

    /// What the first sums of the equations, of either sign, come to in the unknowns, each in its unit.
    fn weighed<const L: usize>(&self, cell: &Enclosure) -> [f64; L] {
        let Bounds { inverse, sums, .. } = &cell.bounds;
        let size = 2 * self.unknowns;
        let mut most = [0.0_f64; L];
        for (unknown, unit) in self.units.iter().enumerate() {
            let mut parts = [[0.0_f64; 2]; L];
            for (column, sums) in inverse.chunks_exact(size).zip(sums) {
                let [x, y] = [0, 1].map(|axis| column[2 * unknown + axis].abs());
                for (part, sum) in parts.iter_mut().zip(sums) {
                    part[0] += x * sum;
                    part[1] += y * sum;
                }
            }
            for (most, [x, y]) in most.iter_mut().zip(parts) {
                *most = most.max(Vector::new(x, y).norm() / unit);
            }
        }
        most
    }

    fn known(&self, cell: &Enclosure, form: usize) -> Known {
        let value = &cell.work.values[form];
        Known {
            value: value[0],
            rate: value[1],
            acceleration: cell.bounds.forms[form],
            by_unknowns: self.by_unknowns[form],
        }
    }

    /// Whether the turns of wheels in mesh stay near enough to where they are for what is said of their angles.
    fn turns_little(&self, cell: &Enclosure, radius: f64) -> bool {
        let meshed = self.equations.iter().filter_map(|equation| match equation {
            Equation::Angle { turns, .. } => Some(turns),
            _ => None,
        });
        let mut turns =
            meshed.flat_map(|turns: &[Option<(usize, f64)>; MOST_FORMS]| turns.iter().flatten());
        turns.all(|(form, _)| self.known(cell, *form).deviations(cell.step_len, radius) <= 0.5)
    }

    /// Whether its unknowns at the end of a step are where they were shown to be.
    pub(crate) fn is_certified(
        &self,
        from: &Predictor,
        to: &Predictor,
        width: f64,
        radius: f64,
    ) -> bool {
        let ends = self.own(&from.natural).zip(self.own(&to.natural));
        ends.zip(&self.units).all(|((a, b), unit)| {
            let off = (b[0] - a[0] - a[1] * width).norm() / unit;
            off <= radius + ROUNDED
        })
    }
}

/// What rounding may leave of a place, relative to the group.
const ROUNDED: f64 = 1e-9;
