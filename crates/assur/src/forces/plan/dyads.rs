//! Steps of the plan for a driven link and for each kind of dyad.

use super::{Builder, Component, StepKind, Term, chain, moments, sum};
use crate::Vector;
use crate::forces::free_body::Cause;
use crate::forces::pair::{DriverId, PairId};
use crate::index::BodyId;
use crate::perpendicular;

use Component::{Across, Along, Normal, Tangential, Whole};

impl Builder<'_> {
    pub(super) fn driven(&mut self, pair: PairId, drive: usize) -> Option<()> {
        let body = self.block.bodies[0];
        let bodies = self.forces.components[drive].bodies;
        let from = bodies[usize::from(bodies[0] == body)];
        let driver = DriverId(drive - self.forces.held);
        let cause = Cause::Drive { driver, from };
        let mut terms = self.loads(body);
        let Some(normal) = self.normal(pair) else {
            // A crank: moments about its hinge, then its polygon.
            let torque = -moments(&mut terms, self.place(pair));
            let mut all = terms.clone();
            all.push(self.couple(body, cause, torque));
            self.push(StepKind::Moments, &[body], Some(pair), all);
            let rest = self.reaction(pair, body, Whole, -sum(&terms));
            forces_only(&mut terms);
            terms.push(rest);
            self.polygon(StepKind::Polygon, &[body], Vector::zeros(), terms);
            return Some(());
        };
        let along = self.found.placed[drive].force;
        let rest = -sum(&terms);
        let mut push = self.reaction(pair, body, Whole, along * along.dot(&rest));
        push.name.cause = cause;
        let held = self.reaction(pair, body, Whole, normal * normal.dot(&rest));
        let mut all = terms.clone();
        forces_only(&mut all);
        all.extend([held, push]);
        self.polygon(StepKind::Polygon, &[body], Vector::zeros(), all);
        terms.push(known(push));
        self.arm(pair, body, self.place(pair), pair, &terms, held);
        Some(())
    }

    pub(super) fn dyad(&mut self, outer: [PairId; 2], inner: PairId) -> Option<()> {
        match (self.normal(inner), outer.map(|pair| self.normal(pair))) {
            (None, normals) => self.about_a_hinge(outer, inner, normals),
            (Some(across), [None, None]) => self.along_a_slide(outer, inner, across),
            (Some(across), [None, Some(normal)]) => {
                self.two_slides(outer, inner, [0, 1], [across, normal])
            }
            (Some(across), [Some(normal), None]) => {
                self.two_slides(outer, inner, [1, 0], [across, normal])
            }
            // Links with slides alone do not turn: no dyad.
            (Some(_), [Some(_), Some(_)]) => None,
        }
    }

    /// Inner hinge: RRR, RRP, PRP.
    fn about_a_hinge(
        &mut self,
        outer: [PairId; 2],
        inner: PairId,
        normals: [Option<Vector>; 2],
    ) -> Option<()> {
        let bodies = [self.block.bodies[0], self.block.bodies[1]];
        let middle = self.place(inner);
        let loads = bodies.map(|body| self.loads(body));
        let (mut directions, mut tangents) = ([Vector::zeros(); 2], [None, None]);
        for k in 0..2 {
            if let Some(normal) = normals[k] {
                directions[k] = normal;
                continue;
            }
            let arm = self.place(outer[k]) - middle;
            let along = arm.try_normalize(0.0)?;
            directions[k] = along;
            let mut terms = loads[k].clone();
            let value = -moments(&mut terms, middle) / arm.norm();
            let force = perpendicular(along) * value;
            let mut tangent = self.reaction(outer[k], bodies[k], Tangential, force);
            tangent.value = value * arm.norm();
            terms.push(tangent);
            self.push(StepKind::Moments, &[bodies[k]], Some(inner), terms);
            tangents[k] = Some(known(tangent));
        }
        let [mut first, mut second] = loads.clone();
        first.splice(0..0, tangents[0]);
        second.extend(tangents[1]);
        let [x, y] = crossing(directions, -(sum(&first) + sum(&second)))?;
        let normal = |k: usize, value: f64| {
            let part = if normals[k].is_some() { Whole } else { Normal };
            self.reaction(outer[k], bodies[k], part, directions[k] * value)
        };
        let closing = [normal(0, x), normal(1, y)];
        self.whole_then_inner([first, second], closing, inner, Whole);
        for k in 0..2 {
            if normals[k].is_some() {
                self.arm(outer[k], bodies[k], middle, inner, &loads[k], closing[k]);
            }
        }
        Some(())
    }

    /// Polygon of a dyad, in which the forces on the first link follow each other, as do those on the second; then the
    /// reaction between them as its diagonal.
    fn whole_then_inner(
        &mut self,
        [mut first, mut second]: [Vec<Term>; 2],
        [own, other]: [Term; 2],
        inner: PairId,
        part: Component,
    ) {
        let bodies = [self.block.bodies[0], self.block.bodies[1]];
        forces_only(&mut first);
        forces_only(&mut second);
        let mut all = [first.clone(), second, vec![other, own]].concat();
        chain(Vector::zeros(), &mut all);
        let start = all[all.len() - 1].ends[0];
        self.push(StepKind::Polygon, &bodies, None, all);
        let mut link = vec![known(own)];
        link.append(&mut first);
        let rest = self.reaction(inner, bodies[0], part, -sum(&link));
        link.push(rest);
        self.polygon(StepKind::Polygon, &bodies[..1], start, link);
    }

    /// Outer hinges and an inner slide: RPR.
    fn along_a_slide(&mut self, outer: [PairId; 2], inner: PairId, across: Vector) -> Option<()> {
        let bodies = [self.block.bodies[0], self.block.bodies[1]];
        let along = -perpendicular(across);
        let loads = bodies.map(|body| self.loads(body));
        let mut parallel = Vec::new();
        for k in 0..2 {
            let mut terms = loads[k].clone();
            forces_only(&mut terms);
            for term in &mut terms {
                term.value = along.dot(&term.force);
            }
            let value = -terms.iter().map(|term| term.value).sum::<f64>();
            let mut own = self.reaction(outer[k], bodies[k], Along, along * value);
            own.value = value;
            terms.push(own);
            self.push(StepKind::Along, &[bodies[k]], Some(inner), terms);
            parallel.push(known(own));
        }
        let [first, last] = outer.map(|pair| self.place(pair));
        let mut terms = [vec![parallel[0]], loads[0].clone(), loads[1].clone()].concat();
        let value = -moments(&mut terms, last) / (first - last).perp(&across);
        let mut own = self.reaction(outer[0], bodies[0], Across, across * value);
        let moment = (first - last).perp(&own.force);
        own.value = moment;
        terms.push(own);
        self.push(StepKind::Moments, &bodies, Some(outer[1]), terms);
        let own = known(own);
        let first_link = [vec![own, parallel[0]], loads[0].clone()].concat();
        let second_link = [loads[1].clone(), vec![parallel[1]]].concat();
        let rest = -(sum(&first_link) + sum(&second_link));
        let other = self.reaction(outer[1], bodies[1], Across, across * across.dot(&rest));
        // The first link's forces begin with its own component across, which the polygon shows last.
        let first_link = first_link[1..].to_vec();
        self.whole_then_inner(
            [first_link.clone(), second_link],
            [own, other],
            inner,
            Whole,
        );
        let mut between = -(sum(&first_link) + own.force);
        between = across * across.dot(&between);
        let between = self.reaction(inner, bodies[0], Whole, between);
        self.arm(
            inner,
            bodies[0],
            self.place(outer[0]),
            outer[0],
            &loads[0],
            between,
        );
        Some(())
    }

    /// Inner slide and one outer slide: RPP. The link `hung` has the outer hinge, the link `sliding` the slides.
    fn two_slides(
        &mut self,
        outer: [PairId; 2],
        inner: PairId,
        [hung, sliding]: [usize; 2],
        directions: [Vector; 2],
    ) -> Option<()> {
        let bodies = [self.block.bodies[hung], self.block.bodies[sliding]];
        let [hinge, guide] = [outer[hung], outer[sliding]];
        let loads = bodies.map(|body| self.loads(body));
        let [mut held, mut slid] = loads.clone();
        forces_only(&mut held);
        forces_only(&mut slid);
        let [x, y] = crossing(directions, -sum(&slid))?;
        let between = self.reaction(inner, bodies[1], Whole, directions[0] * x);
        let outside = self.reaction(guide, bodies[1], Whole, directions[1] * y);
        slid.extend([outside, between]);
        self.polygon(StepKind::Polygon, &bodies[1..], Vector::zeros(), slid);
        let back = known(self.reaction(inner, bodies[0], Whole, -between.force));
        let from = -sum(&held);
        held.push(back);
        let rest = self.reaction(hinge, bodies[0], Whole, -sum(&held));
        held.push(rest);
        self.polygon(StepKind::Polygon, &bodies[..1], from, held);
        let about = self.place(hinge);
        let couple = self.arm(inner, bodies[0], about, hinge, &loads[0], back);
        let cause = |pair, from| Cause::Reaction { pair, from };
        let opposite = self.couple(bodies[1], cause(inner, bodies[0]), -couple);
        let mut terms = loads[1].clone();
        terms.extend([known(between), known(opposite)]);
        self.arm(guide, bodies[1], self.place(inner), inner, &terms, outside);
        Some(())
    }

    /// Moments of a body about a place, which give the moment of a slide's reaction about its sliding point. Returns this
    /// moment.
    fn arm(
        &mut self,
        slide: PairId,
        body: BodyId,
        place: Vector,
        about: PairId,
        others: &[Term],
        reaction: Term,
    ) -> f64 {
        let mut terms = others.to_vec();
        terms.push(known(reaction));
        let value = -moments(&mut terms, place);
        let from = self.from(slide, body);
        terms.push(self.couple(body, Cause::Reaction { pair: slide, from }, value));
        self.push(StepKind::Moments, &[body], Some(about), terms);
        value
    }
}

fn known(term: Term) -> Term {
    Term {
        known: true,
        ..term
    }
}

/// Leaves out couples, and forgets moments.
fn forces_only(terms: &mut Vec<Term>) {
    terms.retain(|term| !term.is_couple);
    for term in terms {
        term.value = 0.0;
    }
}

/// Lengths of two vectors of known directions with this sum; None if the directions are parallel.
fn crossing([a, b]: [Vector; 2], sum: Vector) -> Option<[f64; 2]> {
    let determinant = a.perp(&b);
    (determinant != 0.0).then(|| [sum.perp(&b) / determinant, a.perp(&sum) / determinant])
}
