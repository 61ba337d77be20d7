//! Natural coordinates of an Assur group: unknowns, positions that follow from them, and the remaining equations.

mod condition;

use std::collections::BTreeMap;

use crate::Vector;
use crate::index::{BodyId, List, PointId, SlideId};
use crate::position::{
    AngleConstraint, BodyPoint, CLOSE, Form, Group, KnownTerm, Orientation, conjugate, quotient,
};

use crate::linkage::spec::extent;
use crate::mechanism::plan::Placed;
use crate::mechanism::plan::body::Bodies;
use crate::mechanism::plan::driver::DrivenPair;
use condition::Condition;

/// Group to be solved by Newton's method, and the drawn values of its unknowns. None if the group has fewer equations
/// than unknowns.
pub(in crate::mechanism) fn group(
    placed: &Placed<'_>,
    members: &[BodyId],
    driven: &[DrivenPair],
    parallel: &[[BodyId; 2]],
    offset: usize,
    drawn: impl Fn(PointId) -> Vector,
) -> Option<(Group, Vec<Vector>)> {
    let Placed { bodies, solved, .. } = placed;
    let points = members.iter().flat_map(|body| bodies.of(*body));
    let drawn_points = points.map(|(point, _)| drawn(*point));
    let mut plan = Plan {
        bodies,
        solved,
        orientations: &placed.orientations,
        inputs: Vec::new(),
        points: BTreeMap::new(),
        placed: BTreeMap::new(),
        by_slide: Vec::new(),
        conditions: Vec::new(),
        angle_constraints: Vec::new(),
        drawn_input: Vec::new(),
        units: Vec::new(),
        close: BTreeMap::new(),
        // If all points of a group are drawn in one place, the unit of length is arbitrary.
        size: Some(extent(drawn_points))
            .filter(|size| size.is_finite() && *size > 0.0)
            .unwrap_or(1.0),
    };
    for body in members {
        for (point, _) in bodies.of(*body) {
            if let Some(anchor) = bodies.anchor_of(*point, |other| solved[other]) {
                let form = plan.input(KnownTerm::Place(anchor));
                plan.points.insert(*point, form);
            }
        }
    }
    while plan.placed.len() < members.len() {
        let waiting = || {
            members
                .iter()
                .filter(|body| !plan.placed.contains_key(body))
        };
        let ready = waiting().find_map(|body| Some((*body, plan.follows(*body)?)));
        match ready {
            Some((body, how)) => plan.place(body, how),
            None => {
                let next = waiting()
                    .max_by_key(|body| plan.readiness(**body))
                    .copied()?;
                plan.assume(next, members, &drawn);
            }
        }
    }
    plan.slides();
    for gear in placed.couplings(members) {
        plan.mesh(gear);
    }
    for pair in driven {
        plan.drive(pair)?;
    }
    for pair in parallel.iter().filter(|[_, body]| members.contains(body)) {
        plan.keep_parallel(*pair);
    }
    plan.finished(offset)
}

/// Known data that determine the position of a body.
enum Follows {
    /// Two known points, with their positions on the body.
    Points([(PointId, Vector); 2]),
    /// A known point, and the direction of a slide along another body.
    Slide {
        point: (PointId, Vector),
        slide: SlideId,
        other: BodyId,
    },
}

struct Plan<'a> {
    bodies: &'a Bodies,
    solved: &'a List<BodyId, bool>,
    orientations: &'a List<BodyId, Orientation>,
    inputs: Vec<KnownTerm>,
    /// Linear forms of the positions of the known points.
    points: BTreeMap<PointId, Form>,
    /// Linear forms of the origin and turn of the bodies placed so far.
    placed: BTreeMap<BodyId, [Form; 2]>,
    /// Slides that have given the direction of a body.
    by_slide: Vec<SlideId>,
    /// Conditions, each with the body that it constrains.
    conditions: Vec<(BodyId, Condition)>,
    angle_constraints: Vec<AngleConstraint>,
    /// Drawn values of the unknowns.
    drawn_input: Vec<Vector>,
    /// Unit of each unknown.
    units: Vec<f64>,
    /// Bodies whose turn follows from two points close together, each with the first point's position on the body.
    close: BTreeMap<BodyId, Vector>,
    size: f64,
}

impl Plan<'_> {
    fn input(&mut self, input: KnownTerm) -> Form {
        // A term of the frame is constant, because the frame does not move.
        let (KnownTerm::Place(anchor) | KnownTerm::Direction(anchor)) = input;
        if anchor.body == BodyId::FRAME {
            return Form {
                constant: anchor.local,
                ..Form::default()
            };
        }
        let known = self.inputs.iter().position(|other| *other == input);
        let index = known.unwrap_or(self.inputs.len());
        if known.is_none() {
            self.inputs.push(input);
        }
        Form {
            inputs: vec![(index, Vector::x())],
            ..Form::default()
        }
    }

    fn unknown(&mut self, drawn_input: Vector, unit: f64) -> Form {
        self.drawn_input.push(drawn_input);
        self.units.push(unit);
        Form {
            unknowns: vec![(self.drawn_input.len() - 1, Vector::x())],
            ..Form::default()
        }
    }

    fn is_placed(&self, body: BodyId) -> bool {
        self.solved[body] || self.placed.contains_key(&body)
    }

    /// Slide that joins a body to a placed body, and this placed body; None if there is no such slide.
    fn guided(&self, body: BodyId) -> Option<(SlideId, BodyId)> {
        let mut slides = self.bodies.slides.enumerate();
        slides.find_map(|(slide, joint)| {
            let other = joint.joins(body).filter(|other| self.is_placed(*other))?;
            Some((slide, other))
        })
    }

    fn follows(&self, body: BodyId) -> Option<Follows> {
        let points = self.bodies.of(body).iter().copied();
        let known = points.filter(|(point, _)| self.points.contains_key(point));
        let known: Vec<(PointId, Vector)> = known.collect();
        let first = *known.first()?;
        match self.guided(body) {
            Some((slide, other)) => Some(Follows::Slide {
                point: first,
                slide,
                other,
            }),
            // The two points farthest apart are taken; of equally distant pairs, the first.
            None => {
                let pairs = known.iter().enumerate();
                let pairs = pairs.flat_map(|(k, a)| known[k + 1..].iter().map(move |b| [*a, *b]));
                let length = |[a, b]: &[(PointId, Vector); 2]| (b.1 - a.1).norm();
                let longest = pairs.reduce(|best, pair| {
                    if length(&pair) > length(&best) {
                        pair
                    } else {
                        best
                    }
                });
                // Two points close together do not determine a distant point accurately: the distant point must become
                // known first.
                let longest =
                    longest.filter(|pair| length(pair) >= CLOSE * self.reach(body, first.1));
                longest.map(Follows::Points)
            }
        }
    }

    /// Maximum distance on a body from a position to the hinges and guides by which other bodies are placed.
    fn reach(&self, body: BodyId, from: Vector) -> f64 {
        let bodies = self.bodies;
        let others = move |point| {
            bodies
                .ids()
                .filter(move |id| bodies.local(*id, point).is_some())
        };
        let hinges = bodies
            .of(body)
            .iter()
            .filter(|(point, _)| others(*point).count() > 1);
        let guides = bodies
            .slides
            .iter()
            .filter(|slide| slide.joins(body).is_some());
        let guides = guides.map(|slide| slide.line_on(body).0);
        let places = hinges.map(|(_, at)| *at).chain(guides);
        places.fold(0.0, |most, at| most.max((at - from).norm()))
    }

    /// True if a position on a body, together with any known point of the body, determines the whole body accurately.
    fn is_far(&self, body: BodyId, at: Vector) -> bool {
        let mut known = self.bodies.of(body).iter();
        known.all(|(point, other)| {
            !self.points.contains_key(point)
                || (at - other).norm() >= CLOSE * self.reach(body, *other)
        })
    }

    /// Readiness of a body to be placed: the number of its known points, plus 1 if a slide joins it to a placed body;
    /// then the number of all its points.
    fn readiness(&self, body: BodyId) -> (usize, usize) {
        let known = self
            .bodies
            .of(body)
            .iter()
            .filter(|(point, _)| self.points.contains_key(point));
        let guided = usize::from(self.guided(body).is_some());
        (known.count() + guided, self.bodies.of(body).len())
    }

    /// Makes the next missing point or direction of a body an unknown.
    fn assume(&mut self, body: BodyId, members: &[BodyId], drawn: &impl Fn(PointId) -> Vector) {
        let joints = |point: PointId| {
            members
                .iter()
                .filter(|other| self.bodies.local(**other, point).is_some())
                .count()
        };
        let free = self.bodies.of(body).iter();
        let free = free.filter(|(point, _)| !self.points.contains_key(point));
        // Of points that rank equally, `rev` makes `max_by_key` take the first instead of the last.
        let best = free
            .rev()
            .max_by_key(|(point, at)| (self.is_far(body, *at), joints(*point)));
        if let Some((point, _)) = best.copied() {
            let form = self.unknown(drawn(point), self.size);
            self.points.insert(point, form);
            return;
        }
        // If the body has one point, or its known points are too close together, its direction is the unknown.
        let turn = self.unknown(self.orientations[body].turn, 1.0);
        self.conditions
            .push((body, Condition::Unit(turn.clone(), 0.0)));
        let Some((point, local)) = self.bodies.of(body).first().copied() else {
            return;
        };
        let origin = self.points[&point].minus(&turn.by(local));
        self.settle(body, [origin, turn], &[point]);
    }

    fn place(&mut self, body: BodyId, how: Follows) {
        match how {
            Follows::Points([(first, a), (second, b)]) => {
                let [p, q] = [first, second].map(|point| self.points[&point].clone());
                let turn = q.minus(&p).by(quotient(Vector::x(), b - a));
                if (b - a).norm() < CLOSE * self.size {
                    self.close.insert(body, a);
                }
                // If both points are on solved bodies or on the frame, this condition is a redundant constraint.
                let unit = Condition::Unit(turn.clone(), (b - a).norm());
                self.conditions.push((body, unit));
                let origin = p.minus(&turn.by(a));
                self.settle(body, [origin, turn], &[first, second]);
            }
            Follows::Slide {
                point: (point, local),
                slide,
                other,
            } => {
                let guide = &self.bodies.slides[slide];
                let (_, heading) = guide.line_on(other);
                let (_, direction) = guide.line_on(body);
                let turn = self.direction(other, heading).by(conjugate(direction));
                let origin = self.points[&point].minus(&turn.by(local));
                self.by_slide.push(slide);
                self.settle(body, [origin, turn], &[point]);
            }
        }
    }

    /// Sets the linear forms of a body and of its points, except those in `used`. If a point already has a form, a
    /// condition makes both forms equal.
    fn settle(&mut self, body: BodyId, [origin, turn]: [Form; 2], used: &[PointId]) {
        for (point, local) in self.bodies.of(body) {
            let at = origin.plus(&turn.by(*local));
            if used.contains(point) {
                continue;
            }
            match self.points.get(point) {
                Some(known) => {
                    let gap = at.minus(known);
                    self.conditions.push((body, Condition::Zero(gap)));
                }
                None => {
                    self.points.insert(*point, at);
                }
            }
        }
        self.placed.insert(body, [origin, turn]);
    }

    /// Linear form of a direction on a placed body.
    fn direction(&mut self, body: BodyId, heading: Vector) -> Form {
        match self.placed.get(&body) {
            Some([_, turn]) => turn.by(heading),
            None => self.input(KnownTerm::Direction(BodyPoint {
                body,
                local: heading,
            })),
        }
    }

    /// Linear form of a position on a placed body.
    fn place_on(&mut self, body: BodyId, local: Vector) -> Form {
        match self.placed.get(&body) {
            Some([origin, turn]) => origin.plus(&turn.by(local)),
            None => self.input(KnownTerm::Place(BodyPoint { body, local })),
        }
    }
}
