//! Force plans as drawn on a blackboard, group by group in the order opposite to solving.
//!
//! For a dyad with the inner hinge B, the moments of each link about B give the tangential component of the reaction in
//! its outer hinge. Then the polygon of the whole dyad is closed by the two normal components, along the links; the
//! reaction of an outer slide is normal to its line. The polygon of one link gives the reaction in B, and moments about B
//! the arm of a slide's reaction. If the inner pair is a slide, the forces of each link along its line give one component of
//! the reaction in its outer hinge, and the moments of the whole dyad about the other outer hinge the second one. With
//! an outer and the inner pair slides, the polygon of the link with both comes first. After the dyads comes the driven
//! link with its balancing torque or force. (Artobolevsky, *Theory of mechanisms and machines*, force analysis of groups.)
//!
//! What the plan finds is computed by this construction from the known forces. The reactions of a group that is not a
//! dyad are those of its matrix.

mod dyads;

use super::block::{Block, Form, Held};
use super::free_body::{Acting, Cause};
use super::pair::{PairId, Wrench};
use super::{Kinetostatics, Reactions, Unbalanced};
use crate::index::BodyId;
use crate::mechanism::Mechanism;
use crate::{Point, Vector};

/// Name of a force or couple in a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ForceName {
    /// The body on which it acts.
    pub body: BodyId,
    /// What it comes from.
    pub cause: Cause,
    /// Which component.
    pub part: Component,
}

/// Component of a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// The whole force.
    Whole,
    /// Horizontal component.
    X,
    /// Vertical component.
    Y,
    /// Component normal to the line from the middle hinge; positive if its moment about the middle hinge is.
    Tangential,
    /// Component along the line from the middle hinge.
    Normal,
    /// Component along the line of the inner slide.
    Along,
    /// Component normal to the line of the inner slide.
    Across,
}

/// A force or couple in an equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Its name.
    pub name: ForceName,
    /// True for a couple.
    pub is_couple: bool,
    /// The force; zero for a couple.
    pub force: Vector,
    /// Place of the force, from the origin of the coordinates used while solving.
    at: Vector,
    /// The addend in a sum of moments or of components along a line. In a polygon, the couple or zero.
    pub value: f64,
    /// False if this step finds it.
    pub known: bool,
    /// Start and end of the vector in the plan.
    pub ends: [Vector; 2],
}

impl Term {
    /// Place of the force.
    pub fn place(&self, mechanism: &Mechanism) -> Point {
        mechanism.middle() + self.at
    }

    /// Arm of the force in a sum of moments, positive if the moment is; None for a couple.
    pub fn arm(&self) -> Option<f64> {
        let size = self.force.norm();
        (!self.is_couple && size > 0.0).then(|| self.value / size)
    }
}

/// Equation of a step of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// Sum of moments about a point.
    Moments,
    /// Sum of components along the line of the inner slide.
    Along,
    /// Sum of forces, as a polygon.
    Polygon,
    /// Polygon of a link of a group that is not a dyad: its reactions are found with those of the whole group at once.
    Group,
    /// A link with reactions that are statically indeterminate: nothing is drawn.
    Indeterminate,
}

/// A step of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanStep {
    /// The equation.
    pub kind: StepKind,
    /// Number of the plan in which the step is drawn: one for a driven link, a dyad, or a link of another group.
    pub plan: usize,
    /// Bodies in equilibrium.
    pub bodies: Vec<BodyId>,
    /// The pair about which moments are taken, or the slide along whose line components are taken.
    pub about: Option<PairId>,
    /// Place of this pair, from the origin of the coordinates used while solving.
    at: Vector,
    /// Forces and couples: the known ones, then what is found.
    pub terms: Vec<Term>,
    /// Names of what is statically indeterminate.
    pub open: Vec<ForceName>,
}

impl PlanStep {
    /// Place about which moments are taken.
    pub fn centre(&self, mechanism: &Mechanism) -> Point {
        mechanism.middle() + self.at
    }

    fn is_finite(&self) -> bool {
        let ends = self.terms.iter().map(|term| term.ends[1]);
        ends.into_iter()
            .all(|end| end.x.is_finite() && end.y.is_finite())
    }
}

/// Construction of the reactions in a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcePlan {
    /// The steps.
    pub steps: Vec<PlanStep>,
}

/// A plan under construction.
struct Builder<'a> {
    forces: &'a Kinetostatics,
    found: &'a Reactions,
    block: &'a Block,
    plan: usize,
    steps: Vec<PlanStep>,
}

impl Kinetostatics {
    /// Force plan of a pose with these reactions.
    ///
    /// # Errors
    /// The pose is singular.
    pub fn plan(&self, found: &Reactions) -> Result<ForcePlan, Unbalanced> {
        let (mut steps, mut plan) = (Vec::new(), 0);
        for block in &self.blocks {
            let begun = steps.len();
            let mut builder = Builder {
                forces: self,
                found,
                block,
                plan,
                steps,
            };
            let step = block.step;
            builder.block().ok_or(Unbalanced::Singular { step })?;
            (steps, plan) = (builder.steps, builder.plan + 1);
            if !steps[begun..].iter().all(PlanStep::is_finite) {
                return Err(Unbalanced::Singular { step });
            }
        }
        Ok(ForcePlan { steps })
    }
}

impl Builder<'_> {
    fn block(&mut self) -> Option<()> {
        match &self.block.form {
            Form::Driven { pair, drive } => self.driven(self.pair(pair)?, *drive),
            Form::Dyad { outer, inner } => {
                let outer = [self.pair(&outer[0])?, self.pair(&outer[1])?];
                self.dyad(outer, self.forces.pair_of(inner[0])?)
            }
            Form::Group { .. } | Form::Redundant => {
                for body in &self.block.bodies {
                    self.solved(*body);
                    self.plan += 1;
                }
                Some(())
            }
        }
    }

    fn pair(&self, held: &Held) -> Option<PairId> {
        self.forces.pair_of(held.0[0])
    }

    fn place(&self, pair: PairId) -> Vector {
        self.found.placed[self.forces.starts[pair.0]].at
    }

    /// Normal to the line of a slide; None for a hinge.
    fn normal(&self, pair: PairId) -> Option<Vector> {
        let start = self.forces.starts[pair.0];
        let is_slide = matches!(self.forces.components[start].wrench, Wrench::Normal(_));
        is_slide.then(|| self.found.placed[start].force)
    }

    fn from(&self, pair: PairId, body: BodyId) -> BodyId {
        let [a, b] = self.forces.pairs[pair.0].bodies;
        if a == body { b } else { a }
    }

    /// Reaction of a pair on a body.
    fn reaction(&self, pair: PairId, body: BodyId, part: Component, force: Vector) -> Term {
        let from = self.from(pair, body);
        Term {
            name: ForceName {
                body,
                cause: Cause::Reaction { pair, from },
                part,
            },
            is_couple: false,
            force,
            at: self.place(pair),
            value: 0.0,
            known: false,
            ends: [Vector::zeros(); 2],
        }
    }

    fn couple(&self, body: BodyId, cause: Cause, value: f64) -> Term {
        Term {
            name: ForceName {
                body,
                cause,
                part: Component::Whole,
            },
            is_couple: true,
            force: Vector::zeros(),
            at: Vector::zeros(),
            value,
            known: false,
            ends: [Vector::zeros(); 2],
        }
    }

    /// Forces and couples on a body that are known before its group is solved.
    fn loads(&self, body: BodyId) -> Vec<Term> {
        let all = self.forces.free_body(self.found, body);
        let known = all.into_iter().filter(|one| !self.finds(one.cause));
        let mut terms = Vec::new();
        for one in known {
            terms.extend(self.terms(body, &one, true));
        }
        terms
    }

    /// Whether the block finds a reaction or a balancing torque.
    fn finds(&self, cause: Cause) -> bool {
        let component = match cause {
            Cause::Applied(_) => return false,
            Cause::Reaction { pair, .. } => self.forces.starts[pair.0],
            Cause::Drive { driver, .. } => self.forces.held + driver.0,
        };
        self.block.components.contains(&component)
    }

    /// The force and the couple of an action, as far as they are determined and not zero.
    fn terms(&self, body: BodyId, one: &Acting, known: bool) -> impl Iterator<Item = Term> + use<> {
        let blank = self.couple(body, one.cause, 0.0);
        let (at, none) = (one.at, Vector::zeros());
        let force = one.force.filter(|force| *force != none);
        let force = force.map(|force| Term {
            is_couple: false,
            force,
            at,
            known,
            ..blank
        });
        let couple = one.couple.filter(|couple| *couple != 0.0);
        let couple = couple.map(|value| Term {
            value,
            known,
            ..blank
        });
        force.into_iter().chain(couple)
    }

    fn push(&mut self, kind: StepKind, bodies: &[BodyId], about: Option<PairId>, terms: Vec<Term>) {
        self.steps.push(PlanStep {
            kind,
            plan: self.plan,
            bodies: bodies.to_vec(),
            about,
            at: about.map_or(Vector::zeros(), |pair| self.place(pair)),
            terms,
            open: Vec::new(),
        });
    }

    /// Adds a polygon whose vectors follow each other from a place in the plan.
    fn polygon(&mut self, kind: StepKind, bodies: &[BodyId], from: Vector, mut terms: Vec<Term>) {
        chain(from, &mut terms);
        self.push(kind, bodies, None, terms);
    }

    /// Polygon of a body whose reactions have been found with all others at once.
    fn solved(&mut self, body: BodyId) {
        let (mut terms, mut found, mut open) = (Vec::new(), Vec::new(), Vec::new());
        let mut is_closed = true;
        for one in self.forces.free_body(self.found, body) {
            let own = self.finds(one.cause);
            if one.force.is_none() || one.couple.is_none() {
                is_closed &= one.force.is_some();
                open.push(self.couple(body, one.cause, 0.0).name);
            }
            let list = if own { &mut found } else { &mut terms };
            list.extend(self.terms(body, &one, !own));
        }
        terms.extend(found);
        let kind = if is_closed {
            StepKind::Group
        } else {
            StepKind::Indeterminate
        };
        self.polygon(kind, &[body], Vector::zeros(), terms);
        if let Some(step) = self.steps.last_mut() {
            step.open = open;
        }
    }
}

/// Joins the vectors end to end. Couples take no room.
fn chain(from: Vector, terms: &mut [Term]) {
    let mut end = from;
    for term in terms {
        term.ends = [end, end + term.force];
        end += term.force;
    }
}

fn sum(terms: &[Term]) -> Vector {
    terms.iter().map(|term| term.force).sum()
}

/// Sets the addends of the terms to their moments about a place, and returns the sum.
fn moments(terms: &mut [Term], about: Vector) -> f64 {
    for term in terms.iter_mut().filter(|term| !term.is_couple) {
        term.value = (term.at - about).perp(&term.force);
    }
    terms.iter().map(|term| term.value).sum()
}

#[cfg(test)]
mod tests;
