//! The motion of a group by another method than the engine's. Distances and offsets of points are quadratic equations
//! in all coordinates; Newton's method follows them in small steps. Dead points come from an extended system.

use assur::Point;
use assur::mechanism::LinkageSpec;
use nalgebra::{DMatrix, DVector};

/// The equations of a draft whose crank turns the second point about the first.
pub(crate) struct Closure {
    /// Coordinates of all points as they are drawn.
    drawn: DVector<f64>,
    /// Which points move with the group, and the driven one.
    free: Vec<usize>,
    crank: [usize; 2],
    equations: Vec<Equation>,
}

/// Quadratic in the coordinates; what it is worth in the drawing it keeps.
enum Equation {
    /// |p − q|²/2.
    Distance([usize; 2]),
    /// (b − a) × (p − a).
    Offset([usize; 3]),
}

impl Closure {
    pub(crate) fn new(draft: &LinkageSpec) -> Self {
        let index = |name: &String| {
            let mut points = draft.points.iter();
            points.position(|point| point.name == *name).unwrap()
        };
        let crank = [0, 1].map(|k| index(&draft.links[0].points[k]));
        let mut equations = Vec::new();
        for link in &draft.links[1..] {
            let points: Vec<usize> = link.points.iter().map(index).collect();
            for (k, p) in points.iter().enumerate() {
                let pairs = points[k + 1..].iter();
                equations.extend(pairs.map(|q| Equation::Distance([*p, *q])));
            }
        }
        for slide in &draft.slides {
            let [a, b] = slide.line.each_ref().map(index);
            equations.push(Equation::Offset([a, b, index(&slide.point)]));
        }
        let moves =
            |point: &usize| !draft.frame.contains(&draft.points[*point].name) && *point != crank[1];
        let free: Vec<usize> = (0..draft.points.len()).filter(moves).collect();
        assert_eq!(equations.len(), 2 * free.len());
        let drawn = draft
            .points
            .iter()
            .flat_map(|point| [point.at.x, point.at.y]);
        Self {
            drawn: DVector::from_iterator(2 * draft.points.len(), drawn),
            free,
            crank,
            equations,
        }
    }

    /// The crank's angle in the drawing.
    fn home(&self) -> f64 {
        let [a, b] = self.crank.map(|point| at(&self.drawn, point));
        (b - a).y.atan2((b - a).x)
    }

    /// All coordinates with those of the group replaced and the crank turned.
    fn all(&self, own: &DVector<f64>, input: f64) -> DVector<f64> {
        let mut all = self.drawn.clone();
        for (k, point) in self.free.iter().enumerate() {
            all[2 * point] = own[2 * k];
            all[2 * point + 1] = own[2 * k + 1];
        }
        let [a, b] = self.crank;
        let from = at(&self.drawn, a);
        let length = (at(&self.drawn, b) - from).norm();
        all[2 * b] = from.x + length * input.cos();
        all[2 * b + 1] = from.y + length * input.sin();
        all
    }

    /// How all coordinates change with the input while the group's stand.
    fn driven(&self, input: f64) -> DVector<f64> {
        let mut rates = DVector::zeros(self.drawn.len());
        let [a, b] = self.crank.map(|point| at(&self.drawn, point));
        let length = (b - a).norm();
        rates[2 * self.crank[1]] = -length * input.sin();
        rates[2 * self.crank[1] + 1] = length * input.cos();
        rates
    }

    fn own(&self, all: &DVector<f64>) -> DVector<f64> {
        let own = self.free.iter().flat_map(|p| [all[2 * p], all[2 * p + 1]]);
        DVector::from_iterator(2 * self.free.len(), own)
    }

    fn left(&self, all: &DVector<f64>) -> DVector<f64> {
        let worth = |equation: &Equation, all: &DVector<f64>| match *equation {
            Equation::Distance([p, q]) => 0.5 * (at(all, p) - at(all, q)).norm_squared(),
            Equation::Offset([a, b, p]) => {
                (at(all, b) - at(all, a)).perp(&(at(all, p) - at(all, a)))
            }
        };
        let left = self.equations.iter();
        let left = left.map(|equation| worth(equation, all) - worth(equation, &self.drawn));
        DVector::from_iterator(self.equations.len(), left)
    }

    /// The derivatives of the equations by all coordinates: linear in these.
    fn jacobian(&self, all: &DVector<f64>) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(self.equations.len(), all.len());
        for (row, equation) in self.equations.iter().enumerate() {
            let mut add = |point: usize, [x, y]: [f64; 2]| {
                jacobian[(row, 2 * point)] += x;
                jacobian[(row, 2 * point + 1)] += y;
            };
            match *equation {
                Equation::Distance([p, q]) => {
                    let d = at(all, p) - at(all, q);
                    add(p, [d.x, d.y]);
                    add(q, [-d.x, -d.y]);
                }
                Equation::Offset([a, b, p]) => {
                    let [u, v] = [b, p].map(|end| at(all, end) - at(all, a));
                    add(b, [v.y, -v.x]);
                    add(p, [-u.y, u.x]);
                    add(a, [u.y - v.y, v.x - u.x]);
                }
            }
        }
        jacobian
    }

    /// Of a matrix the columns of the group's coordinates.
    fn columns(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        let columns = self.free.iter().flat_map(|p| [2 * p, 2 * p + 1]);
        let columns: Vec<usize> = columns.collect();
        matrix.select_columns(&columns)
    }

    /// Newton's method at an input; the size of the first correction.
    fn correct(&self, own: &mut DVector<f64>, input: f64) -> Option<f64> {
        let mut first = None;
        for _ in 0..8 {
            let all = self.all(own, input);
            let step = self.columns(&self.jacobian(&all)).lu();
            let step = step.solve(&self.left(&all))?;
            *own -= &step;
            let by = step.amax();
            first = first.or(Some(by));
            if by < 1e-13 {
                return first;
            }
        }
        None
    }

    /// Goes from the drawing to a turn of the crank in equal steps, each in as many
    /// parts as keep the corrections small, and tells how far the crank has turned and
    /// the places of all points after each; ends early where it cannot go on.
    pub(crate) fn follow(
        &self,
        turn: f64,
        steps: usize,
        mut tell: impl FnMut(f64, &dyn Fn(usize) -> Point),
    ) {
        let home = self.home();
        let mut here = self.own(&self.drawn);
        let mut input = home;
        for step in 1..=steps {
            let target = home + turn * step as f64 / steps as f64;
            let mut part = target - input;
            while input != target {
                if part.abs() < 1e-7 {
                    return;
                }
                let next = if (target - input - part).abs() < 0.5 * part.abs() {
                    target
                } else {
                    input + part
                };
                // Along the tangent, and back to the closure.
                let all = self.all(&here, input);
                let jacobian = self.jacobian(&all);
                let rates = self.columns(&jacobian).lu();
                let Some(rates) = rates.solve(&(-&jacobian * self.driven(input))) else {
                    return;
                };
                let mut there = &here + rates * (next - input);
                match self.correct(&mut there, next) {
                    Some(by) if by < 1e-3 => {
                        (here, input) = (there, next);
                    }
                    _ => part *= 0.5,
                }
            }
            let all = self.all(&here, input);
            tell(input - home, &|point| Point::from(at(&all, point)));
        }
    }

    /// The dead point near a pose and an input: F = 0, J v = 0, |v| = 1 by Newton's
    /// method, which converges there though J is singular. None where it does not.
    pub(crate) fn dead_point(&self, near: &[Point], input: f64) -> Option<f64> {
        let places = near.iter().flat_map(|point| [point.x, point.y]);
        let mut own = self.own(&DVector::from_iterator(self.drawn.len(), places));
        let mut input = input;
        let size = own.len();
        let svd = self.columns(&self.jacobian(&self.all(&own, input)));
        let svd = svd.svd(false, true);
        let mut way: DVector<f64> = svd.v_t?.row(size - 1).transpose();
        let nothing = self.jacobian(&DVector::zeros(self.drawn.len()));
        for _ in 0..30 {
            let all = self.all(&own, input);
            let jacobian = self.jacobian(&all);
            let moving = self.columns(&jacobian);
            // The derivatives of J v: J is linear, so they are those at v itself.
            let mut still = DVector::zeros(self.drawn.len());
            for (k, point) in self.free.iter().enumerate() {
                still[2 * point] = way[2 * k];
                still[2 * point + 1] = way[2 * k + 1];
            }
            let bent = self.jacobian(&still) - &nothing;
            let driven = self.driven(input);
            let mut matrix = DMatrix::zeros(2 * size + 1, 2 * size + 1);
            matrix.view_mut((0, 0), (size, size)).copy_from(&moving);
            matrix
                .view_mut((0, 2 * size), (size, 1))
                .copy_from(&(&jacobian * &driven));
            matrix
                .view_mut((size, 0), (size, size))
                .copy_from(&self.columns(&bent));
            matrix
                .view_mut((size, size), (size, size))
                .copy_from(&moving);
            matrix
                .view_mut((size, 2 * size), (size, 1))
                .copy_from(&(&bent * &driven));
            for k in 0..size {
                matrix[(2 * size, size + k)] = way[k];
            }
            let mut left = DVector::zeros(2 * size + 1);
            left.rows_mut(0, size).copy_from(&self.left(&all));
            left.rows_mut(size, size).copy_from(&(&moving * &way));
            left[2 * size] = 0.5 * (way.norm_squared() - 1.0);
            let step = matrix.lu().solve(&left)?;
            own -= step.rows(0, size);
            way -= step.rows(size, size);
            input -= step[2 * size];
            if step.amax() < 1e-13 {
                return Some(input);
            }
        }
        None
    }
}

fn at(all: &DVector<f64>, point: usize) -> assur::Vector {
    assur::Vector::new(all[2 * point], all[2 * point + 1])
}
