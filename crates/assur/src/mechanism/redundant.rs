//! Redundant constraints: groups that move although their constraints outnumber their freedoms.
//!
//! Every constraint of such a group gives an equation of the group. In each pose pivoting selects independent
//! equations, one for each unknown; the residuals of the other equations are checked. Bodies that stay parallel, such
//! as rods on equal cranks, give additional equations. Without these, the Jacobian is singular if all cranks are in
//! line, although the constraints together allow only one motion.

use crate::tolerance;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

use nalgebra::DVector;

use crate::Vector;
use crate::index::{BodyId, LinkId, List, PointId, StepId};
use crate::linkage::spec::{Defect, LinkageSpec};
use crate::mechanism::plan;
use crate::mechanism::plan::body::Placement;
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::plan::structured::Redundancy;
use crate::mechanism::{
    Configuration, Layout, LinkOrFrame, Mechanism, PassiveLinks, Start, arms_of,
};
use crate::position::{Arm, BodyPoint, Cause, Predictor};
use crate::structure::{self, Structure, with_passive_links};

/// Offsets, on both sides of the drawn input, at which the constraints are checked: radians for a crank, multiples of
/// range/2π for a slide.
const BESIDE: [f64; 9] = [1e-3, 7e-3, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3];

/// Mobility by count and by rank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// Mobility by count, W = 3n − 2P₁ − P₂, by Chebyshev and Grübler: n moving links, P₁ lower pairs, P₂ higher pairs.
    pub by_count: isize,
    /// Mobility by rank, W = 3n − r: r is the rank of the constraints of the pairs in a general pose.
    pub by_rank: isize,
    /// Names of the pairs with redundant constraints, one for each constraint, in the order of points, slides and
    /// gears; then the hinges of doubled links. A hinge or slide is named by its point, a mesh by both wheels. Of
    /// several dependent constraints the last in this order is redundant.
    pub redundant: Vec<String>,
}

impl Mobility {
    /// Number of redundant constraints in the plane, q.
    pub fn q(&self) -> isize {
        self.by_rank - self.by_count
    }
}

/// Constraints of the pairs in a pose: rows of a matrix, each with the name of its pair.
type Rows = Vec<(PairName, DVector<f64>)>;

/// Name of a pair: the point of a hinge or slide, or the two wheels of a mesh.
#[derive(Clone, Copy, Debug)]
enum PairName {
    At(PointId),
    Mesh([LinkOrFrame; 2]),
}

/// Independent rows, orthogonal to each other and of length 1.
#[derive(Default)]
struct Basis(Vec<DVector<f64>>);

impl Basis {
    /// Adds a row if it is independent of the rows added before; returns true if the row is added.
    fn takes(&mut self, row: &DVector<f64>) -> bool {
        let mut rest = row.clone();
        // Two orthogonalizations suffice (Kahan, in Parlett, The Symmetric Eigenvalue Problem, 6.9).
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
        let layout = &self.layout;
        let counts = layout.counts();
        let has_surplus = layout.structure.groups().any(|group| group.surplus > 0);
        let redundant = if has_surplus || counts.passive > 0 {
            layout.redundant(&layout.rows_beside(&self.drawn))
        } else {
            layout.hinges_of_doubled().collect()
        };
        let names = redundant.iter().map(|pair| match pair {
            PairName::At(point) => self.point_name(*point).to_owned(),
            PairName::Mesh(wheels) => wheels.map(|link| self.spec.name_of(link)).join(" "),
        });
        Mobility {
            by_count: counts.mobility,
            by_rank: counts.mobility + redundant.len() as isize,
            redundant: names.collect(),
        }
    }
}

impl Layout {
    /// Pairs with redundant constraints in the most general of several poses, and the hinges of doubled links.
    fn redundant(&self, rows: &[Rows]) -> Vec<PairName> {
        // In a singular pose more constraints are dependent.
        let general = rows.iter().map(dependent);
        let mut redundant = general.min_by_key(Vec::len).unwrap_or_default();
        redundant.extend(self.hinges_of_doubled());
        redundant
    }

    /// True if the rank of the constraints, in the most general of several poses, leaves one freedom for each driver.
    fn rank_allows(&self, rows: &[Rows], drivers: &[structure::Driver]) -> bool {
        let rank = self.counts().mobility + self.redundant(rows).len() as isize;
        rank == drivers.len() as isize
    }

    /// Hinges of doubled links, each listed once for each of its redundant constraints. The first hinge of a link has
    /// no redundant constraint, the second has one, and each further hinge has two.
    fn hinges_of_doubled(&self) -> impl Iterator<Item = PairName> {
        self.doubled.iter().flat_map(|one| {
            let further = one.shared.iter().enumerate().skip(1);
            further.flat_map(|(k, point)| std::iter::repeat_n(PairName::At(*point), k.min(2)))
        })
    }

    /// The constraints of the pairs in poses beside the pose of a configuration.
    fn rows_beside(&self, at: &Configuration) -> Vec<Rows> {
        let poses = self.beside(at);
        poses.iter().map(|pose| self.rows(pose)).collect()
    }

    /// The constraints of the pairs in a pose, as rows that multiply the twists of the bodies. A twist is the velocity
    /// of the body at the origin, divided by the size of the linkage, and the angular velocity.
    fn rows(&self, pose: &Predictor) -> Rows {
        let place = |anchor: BodyPoint| pose.place(anchor).value() / self.size;
        let blank = || DVector::zeros(3 * self.placed_by.len());
        // Row for the component along `way` of the velocity of `body` relative to `base` at a position.
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
        let mut rows = Vec::new();
        for point in self.points.ids().take(self.listed) {
            let having = self.bodies.ids().filter_map(|body| {
                let local = self.bodies.local(body, point)?;
                Some(BodyPoint { body, local })
            });
            let having: Vec<BodyPoint> = having.collect();
            for on_body in having.iter().skip(1) {
                for way in [Vector::x(), Vector::y()] {
                    let row = along(place(*on_body), way, [on_body.body, having[0].body]);
                    rows.push((PairName::At(point), row));
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
        for slide in self.bodies.slides.iter() {
            let ([on, body], point) = (slide.bodies, slide.by_link.point);
            let [from, to] = slide.by_link.line;
            let [at, from, to] = [point, from, to].map(|point| place(self.points[point]));
            let way = (to - from).normalize();
            let across = crate::perpendicular(way);
            rows.push((PairName::At(point), along(at, across, [body, on])));
            rows.push((PairName::At(point), turns(&[(body, 1.0), (on, -1.0)])));
        }
        for gear in &self.bodies.gears {
            let teeth = gear.signed_teeth();
            let most = teeth[0].abs().max(teeth[1].abs());
            let [one, other] = teeth.map(|teeth| teeth / most);
            let [a, b] = gear.bodies;
            let row = turns(&[(a, one), (b, other), (gear.carrier, -one - other)]);
            rows.push((PairName::Mesh(gear.by_link.links), row));
        }
        for (_, row) in &mut rows {
            // The frame does not move.
            row.rows_mut(0, 3).fill(0.0);
        }
        rows
    }

    fn is_redundant(&self, step: StepId) -> bool {
        self.steps[step].is_redundant()
    }

    /// Completes the layout of a linkage with redundant constraints. Returns its drawn configuration and the start of
    /// its motion.
    ///
    /// # Errors
    /// The defects of the constraints if they are not redundant.
    pub(super) fn settle_redundant(
        &mut self,
        resolved: &Resolved<'_>,
        placements: &List<LinkId, Placement>,
        guess: Configuration,
        redundancy: &Redundancy,
    ) -> Result<(Configuration, Start), Vec<Defect>> {
        let spec = resolved.spec;
        let Some(signed) = self.signed(spec, guess) else {
            return Err(redundancy.defects.clone());
        };
        let parallel = self.parallel(&signed);
        let plan = parallel.and_then(|parallel| {
            let (bodies, structure) = (self.bodies.clone(), self.structure.clone());
            Self::new(resolved, bodies, placements, structure, &parallel, None).ok()
        });
        let Some((layout, guess)) = plan else {
            return Err(self.locked(redundancy, &signed));
        };
        *self = layout;
        let settled = self.settle(spec, guess);
        let settled = settled.map_err(|_| self.locked(redundancy, &signed))?;
        let Some(structure) = self.shown(redundancy, &settled.0) else {
            return Err(self.locked(redundancy, &settled.0));
        };
        let without = structure.without_passive_links();
        let plan = plan::plan(resolved, &self.bodies, placements, &without, &[], None);
        let steps = plan.map(|plan| plan.steps).unwrap_or_default();
        let known = |arms: &&[Arm; 2]| {
            self.steps
                .iter()
                .filter_map(arms_of)
                .any(|own| own == *arms)
        };
        let arms = steps.iter().filter_map(arms_of);
        let dyads = arms.filter(|arms| !known(arms)).cloned().collect();
        self.passive = Some(PassiveLinks { structure, dyads });
        Ok(settled)
    }

    /// Structure with passive links as separate steps. None if a redundant constraint fails near the drawn pose. Also
    /// None if the mobility by rank differs from the number of drivers: for example, two drivers may be compatible only
    /// at their given rates.
    fn shown(&self, redundancy: &Redundancy, at: &Configuration) -> Option<Structure> {
        let rows = self.rows_beside(at);
        let Redundancy { graph, drivers, .. } = redundancy;
        if rows.is_empty() || !self.rank_allows(&rows, drivers) {
            return None;
        }
        // Counting alone would also treat a link that drives others as passive.
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
            3 * (self.placed_by.len() - 1 - passive.len()) == rank + drivers.len()
        };
        let shown = with_passive_links(graph, drivers, moves);
        Some(shown.unwrap_or_else(|| self.structure.clone()))
    }

    /// Defects of a drawing whose constraints fail near the drawn pose. If the rank in the drawn pose allows a motion,
    /// they are reported as mobile for an instant, otherwise as locked.
    fn locked(&self, redundancy: &Redundancy, at: &Configuration) -> Vec<Defect> {
        let mut state: Predictor = self.blank_state();
        let solved = self.solve(at.input, &at.signs, at, &mut state);
        let drivers = &redundancy.drivers;
        let is_mobile = solved.is_ok() && self.rank_allows(&[self.rows(&state)], drivers);
        let told = |defect: Defect| match defect {
            Defect::Locked { links, .. } if is_mobile => Defect::Instant { links },
            other => other,
        };
        redundancy.defects.iter().cloned().map(told).collect()
    }

    /// Poses on both sides of the drawn pose, as far as they exist. Empty if a redundant constraint fails in one of
    /// these poses, because the links are then locked.
    fn beside(&self, drawn: &Configuration) -> Vec<Predictor> {
        let unit = self.span() / TAU;
        let mut found = Vec::new();
        for sense in [unit, -unit] {
            let mut near = drawn.clone();
            for (k, step) in BESIDE.into_iter().enumerate() {
                let mut state: Predictor = self.blank_state();
                let input = drawn.input + sense * step;
                match self.solve(input, &near.signs, &near, &mut state) {
                    Ok(()) => {}
                    Err((_, Cause::Locked { .. })) => return Vec::new(),
                    Err(_) => break,
                }
                let ahead = BESIDE.get(k + 1).map_or(0.0, |next| next - step) * sense;
                let places = state.natural.iter();
                let places = places.map(|place| place[0] + (place[1] + place[2] * ahead) * ahead);
                near.natural = places.flat_map(|place| [place.x, place.y]).collect();
                state.orient(&mut near.orientations);
                found.push(state);
            }
        }
        found
    }

    /// Drawn configuration with the drawn signs; None if a step without redundant constraints does not close.
    fn signed(&self, spec: &LinkageSpec, drawn: Configuration) -> Option<Configuration> {
        let mut at = drawn;
        let mut state = self.blank_state();
        for step in self.steps.ids() {
            let sign = self.drawn_sign(spec, step, &at, &mut state);
            match sign {
                Ok(sign) => at.signs[step] = sign,
                // A step with redundant constraints may be singular in the drawn pose.
                Err(_) if self.is_redundant(step) => {}
                Err(_) => return None,
            }
            let solved = self.try_step(step, at.signs[step], &at, &mut state);
            if solved.is_err() && !self.is_redundant(step) {
                return None;
            }
        }
        Some(at)
    }

    /// Pairs of bodies that stay parallel to each other, for groups with redundant constraints. The first body of a
    /// pair may be the frame. None if a redundant constraint fails near the drawn pose, or if no pose is found there.
    fn parallel(&self, drawn: &Configuration) -> Option<Vec<[BodyId; 2]>> {
        let poses = self.beside(drawn);
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
            // One pose may deviate: links may be in line there, and cancellation then makes angular velocities inexact.
            2 * alike > poses.len() && alike + 1 >= poses.len()
        };
        let mut parallel = Vec::new();
        for step in self.steps.ids().filter(|step| self.is_redundant(*step)) {
            for body in self.steps[step].bodies() {
                // The first body with the same angular velocity is taken; the frame precedes all others.
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

/// Pairs with a constraint that depends on the constraints before it.
fn dependent(rows: &Rows) -> Vec<PairName> {
    let mut basis = Basis::default();
    let dependent = rows.iter().filter(|(_, row)| !basis.takes(row));
    dependent.map(|(pair, _)| *pair).collect()
}
