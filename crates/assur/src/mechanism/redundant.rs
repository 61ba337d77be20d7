//! Redundant constraints: groups with more constraints than freedoms that still move.
//!
//! Every constraint of such a group is one of its equations. Pivoting selects, in each pose anew, as many independent
//! equations as there are unknowns; the residuals of the others are checked. Bodies that stay parallel, as rods on
//! equal cranks, add further equations: with all cranks in line the Jacobian of the constraints alone is singular,
//! although all constraints together allow only one motion.

use crate::tolerance;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

use nalgebra::DVector;

use crate::Vector;
use crate::index::{BodyId, StepId};
use crate::linkage::spec::Defect;
use crate::mechanism::plan::structured::Redundancy;
use crate::mechanism::{ConstraintKind, FRAME, LinkOrFrame, Mechanism};
use crate::position::{BodyPoint, Cause, Nearby, Predictor, Step};
use crate::structure::{Structure, with_passive_links};

/// Inputs on either side of the drawn one at which the constraints are checked, radians of a crank.
const BESIDE: [f64; 9] = [1e-3, 7e-3, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3];
/// Maximum number of poses beside the drawn one that may be in line; there angular velocities are lost to cancellation.
const IN_LINE: usize = 1;

/// Mobility by count and by rank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// W = 3n − 2P₁ − P₂ by Chebyshev and Grübler.
    pub count: isize,
    /// W = 3n − r with the rank r of the constraints of the pairs in a general pose.
    pub rank: isize,
    /// The pairs with a redundant constraint, once for each, in the order of points, slides and gears: a hinge or a
    /// slide by its point, wheels in mesh by both names. Of dependent constraints the last in this order is named.
    pub redundant: Vec<String>,
}

impl Mobility {
    /// q, the number of redundant constraints in the plane.
    pub fn q(&self) -> isize {
        self.rank - self.count
    }
}

/// The constraints of the pairs in a pose, each with the name of its pair.
type Rows = Vec<(String, DVector<f64>)>;

/// Independent rows, orthogonal to each other and of length 1.
#[derive(Default)]
struct Basis(Vec<DVector<f64>>);

impl Basis {
    /// Adds a row if it is independent of those before; true if added.
    fn takes(&mut self, row: &DVector<f64>) -> bool {
        let mut rest = row.clone();
        // Twice is enough (Kahan, in Parlett, The Symmetric Eigenvalue Problem, 6.9).
        for _ in 0..2 {
            for one in &self.0 {
                rest -= one * one.dot(&rest);
            }
        }
        let left = rest.norm();
        let is_independent = left > tolerance::DISTINCT * row.norm();
        if is_independent {
            self.0.push(rest / left);
        }
        is_independent
    }
}

impl Mechanism {
    /// Mobility by count and by rank, with the redundant constraints.
    pub fn mobility(&self) -> Mobility {
        let count = self.counts.mobility;
        let has_surplus = self.solved_by.groups().any(|group| group.surplus > 0);
        if !has_surplus && self.counts.passive == 0 {
            let redundant = self.hinges_of_doubled();
            return Mobility {
                count,
                rank: count + redundant.len() as isize,
                redundant,
            };
        }
        self.mobility_by(&self.rows_in(&self.beside()))
    }

    /// Mobility by count and by the rank of the constraints in the most general of some poses.
    fn mobility_by(&self, rows: &[Rows]) -> Mobility {
        let count = self.counts.mobility;
        let general = rows.iter().map(dependent);
        // In a singular pose more constraints depend on each other.
        let mut redundant = general.min_by_key(Vec::len).unwrap_or_default();
        redundant.extend(self.hinges_of_doubled());
        Mobility {
            count,
            rank: count + redundant.len() as isize,
            redundant,
        }
    }

    /// The hinges of doubled links, repeated by their number of redundant constraints: 0 for the first hinge, 1 for the
    /// second, 2 for each further one.
    fn hinges_of_doubled(&self) -> Vec<String> {
        let doubled = self.doubled.iter().flat_map(|one| {
            let further = one.shared.iter().enumerate().skip(1);
            further.flat_map(|(k, point)| std::iter::repeat_n(*point, k.min(2)))
        });
        let names = doubled.map(|point| self.point_name(point).to_owned());
        names.collect()
    }

    fn rows_in(&self, poses: &[Predictor]) -> Vec<Rows> {
        poses.iter().map(|pose| self.rows(pose)).collect()
    }

    /// The constraints of the pairs on the twists of the bodies, with the names of the pairs. A twist is the velocity
    /// at the origin, divided by the size, and the angular velocity.
    fn rows(&self, pose: &Predictor) -> Rows {
        let place = |anchor: BodyPoint| pose.place(anchor).value() / self.size;
        let blank = || DVector::zeros(3 * self.bodies.len());
        // Component at a place of the velocity of a body relative to another.
        let along = |at: Vector, way: Vector, [body, base]: [BodyId; 2]| {
            let mut row = blank();
            for (of, sign) in [(body, 1.0), (base, -1.0)] {
                let part = [way.x, way.y, at.perp(&way)];
                for (k, part) in part.into_iter().enumerate() {
                    row[3 * of.index() + k] += sign * part;
                }
            }
            row
        };
        let body_of = |link: LinkOrFrame| link.map_or(BodyId::FRAME, |link| self.links[link].body);
        let mut rows = Vec::new();
        for point in self.points.ids().take(self.spec.points.len()) {
            let having = self.bodies.enumerate().filter_map(|(body, points)| {
                let (_, local) = points.iter().find(|(other, _)| *other == point)?;
                Some((body, *local))
            });
            let having: Vec<(BodyId, Vector)> = having.collect();
            for (body, local) in having.iter().skip(1) {
                let at = place(BodyPoint {
                    body: *body,
                    local: *local,
                });
                for way in [Vector::x(), Vector::y()] {
                    let row = along(at, way, [*body, having[0].0]);
                    rows.push((self.point_name(point).to_owned(), row));
                }
            }
        }
        let turns = |terms: &[(BodyId, f64)]| {
            let mut row = blank();
            for (body, by) in terms {
                row[3 * body.index() + 2] += by;
            }
            row
        };
        for slide in &self.spec.slides {
            let [body, on] = [&slide.link, &slide.on].map(|name| body_of(self.link(name)));
            let of = |name: &String| self.point(name).map(|point| place(self.points[point]));
            if let [Some(at), Some(from), Some(to)] =
                [&slide.point, &slide.line[0], &slide.line[1]].map(of)
            {
                let way = (to - from).normalize();
                let across = crate::perpendicular(way);
                rows.push((slide.point.clone(), along(at, across, [body, on])));
                rows.push((slide.point.clone(), turns(&[(body, 1.0), (on, -1.0)])));
            }
        }
        for constraint in &self.constraints {
            if let ConstraintKind::Mesh {
                links,
                carrier,
                teeth,
            } = constraint.kind
            {
                let most = teeth[0].abs().max(teeth[1].abs());
                let [one, other] = teeth.map(|teeth| teeth / most);
                let [a, b] = links.map(body_of);
                let row = turns(&[(a, one), (b, other), (body_of(carrier), -one - other)]);
                let name = |link: LinkOrFrame| link.map_or(FRAME, |link| self.link_name(link));
                rows.push((links.map(name).join(" "), row));
            }
        }
        for (_, row) in &mut rows {
            // The frame does not move.
            row.rows_mut(0, 3).fill(0.0);
        }
        rows
    }

    fn is_redundant(&self, step: StepId) -> bool {
        matches!(&self.steps[step], Step::Group(group) if group.is_redundant())
    }

    /// The structure with passive links as separate steps. None if a redundant constraint fails around the drawn pose,
    /// or if the mobility by rank differs from the number of drivers: drivers compatible only at their given rates are
    /// too many.
    pub(super) fn shown(&self, redundancy: &Redundancy) -> Option<Structure> {
        let rows = self.rows_in(&self.beside());
        let drivers = self.spec.drivers.len();
        if rows.is_empty() || self.mobility_by(&rows).rank != drivers as isize {
            return None;
        }
        // Counting alone would also remove a link that drives others.
        let moves = |passive: &BTreeSet<usize>| {
            let rank = |rows: &Rows| {
                let mut basis = Basis::default();
                let others = rows.iter().filter(|(_, row)| {
                    let mut parts = passive.iter().map(|body| row.rows(3 * body, 3));
                    parts.all(|part| part.norm() == 0.0)
                });
                others.filter(|(_, row)| basis.takes(row)).count()
            };
            let rank = rows.iter().map(rank).max().unwrap_or(0);
            3 * (self.bodies.len() - 1 - passive.len()) == rank + drivers
        };
        let Redundancy { graph, drivers, .. } = redundancy;
        let shown = with_passive_links(graph, drivers, moves);
        Some(shown.unwrap_or_else(|| self.solved_by.clone()))
    }

    /// The defects of a drawing whose constraints fail around it. If the rank in the drawn pose allows a motion, the
    /// links are mobile for an instant, else locked.
    pub(super) fn locked(&self, redundancy: &Redundancy) -> Vec<Defect> {
        let mut state: Predictor = self.blank_state();
        let solved = self.solve(self.drawn_input, &self.signs, self.drawn(), &mut state);
        let drivers = self.spec.drivers.len() as isize;
        let is_mobile = solved.is_ok() && self.mobility_by(&[self.rows(&state)]).rank == drivers;
        let told = |defect: Defect| match defect {
            Defect::Locked { links, .. } if is_mobile => Defect::Instant { links },
            other => other,
        };
        redundancy.defects.iter().cloned().map(told).collect()
    }

    /// Poses on both sides of the drawn one, as far as there are poses. Empty if a redundant constraint fails in one of
    /// them: the links are locked.
    fn beside(&self) -> Vec<Predictor> {
        let unit = self.span() / TAU;
        let mut found = Vec::new();
        for sense in [unit, -unit] {
            let mut orientations = self.orientations.clone();
            let mut natural = self.natural.clone();
            for (k, step) in BESIDE.into_iter().enumerate() {
                let mut state: Predictor = self.blank_state();
                let near = Nearby {
                    orientations: &orientations,
                    natural: &natural,
                    smooth_roots: &[],
                };
                let input = self.drawn_input + sense * step;
                match self.solve(input, &self.signs, near, &mut state) {
                    Ok(()) => {}
                    Err((_, Cause::Locked { .. })) => return Vec::new(),
                    Err(_) => break,
                }
                let ahead = BESIDE.get(k + 1).map_or(0.0, |next| next - step) * sense;
                let places = state.natural.iter();
                let places = places.map(|place| place[0] + (place[1] + place[2] * ahead) * ahead);
                natural = places.flat_map(|place| [place.x, place.y]).collect();
                state.orient(&mut orientations);
                found.push(state);
            }
        }
        found
    }

    /// Bodies of groups with redundant constraints that stay parallel to the frame or to another body, in pairs. None
    /// if the constraints fail beside the drawn pose.
    pub(super) fn parallel(&mut self) -> Option<Vec<[BodyId; 2]>> {
        let mut state = self.blank_state();
        for step in self.steps.ids() {
            let sign = self.drawn_sign(step, &mut state);
            match sign {
                Ok(sign) => self.signs[step] = sign,
                // All constraints together are singular in the drawn pose.
                Err(_) if self.is_redundant(step) => {}
                Err(_) => return None,
            }
            let solved = self.try_step(step, self.signs[step], &mut state);
            if solved.is_err() && !self.is_redundant(step) {
                return None;
            }
        }
        let poses = self.beside();
        if poses.is_empty() {
            return None;
        }
        let unit = self.span() / TAU;
        let turns_alike = |one: BodyId, other: BodyId| {
            let alike = poses.iter().filter(|pose| {
                let [a, b] = [one, other].map(|body| pose.angle(body).derivative(1) * unit);
                (a - b).abs() <= tolerance::DOUBLE_ROOT
            });
            let alike = alike.count();
            2 * alike > poses.len() && alike + IN_LINE >= poses.len()
        };
        let mut parallel = Vec::new();
        for step in self.steps.ids().filter(|step| self.is_redundant(*step)) {
            for body in self.steps[step].bodies() {
                // The first body with the same angular velocity; the frame comes before all others.
                let before = self.bodies.ids().filter(|other| *other != body);
                let before = before.filter(|other| {
                    let placed = self.placed_by[*other];
                    placed.is_none_or(|by| by < step || by == step && *other < body)
                });
                let mate = before.into_iter().find(|other| turns_alike(*other, body));
                parallel.extend(mate.map(|other| [other, body]));
            }
        }
        Some(parallel)
    }
}

/// The pairs with a constraint that depends on those before it.
fn dependent(rows: &Rows) -> Vec<String> {
    let mut basis = Basis::default();
    let dependent = rows.iter().filter(|(_, row)| !basis.takes(row));
    dependent.map(|(name, _)| name.clone()).collect()
}
