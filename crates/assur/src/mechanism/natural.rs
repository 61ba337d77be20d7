//! Natural coordinates of an Assur group: which few places are unknowns, how all
//! others follow from them, and which equations are left.

use std::collections::BTreeMap;

use crate::Vector;
use crate::index::{BodyId, List, PointId, SlideId};
use crate::position::{
    Anchor, Drive, Equation, Form, Group, Input, Mesh, Orientation, conjugate, quotient,
};

use super::body::{Bodies, Gear, Slide};
use super::driver::{DrivenPair, PairKind};
use super::plan::Placed;
use super::willis;

/// The plan of a group and the drawn values of its unknowns; none where the equations
/// are not as many as the unknowns.
pub(super) fn group(
    placed: &Placed<'_>,
    members: &[BodyId],
    driven: &[DrivenPair],
    offset: usize,
    drawn: impl Fn(PointId) -> Vector,
) -> Option<(Group, Vec<Vector>)> {
    let Placed { bodies, solved, .. } = placed;
    let mut plan = Plan {
        bodies,
        solved,
        orientations: &placed.orientations,
        inputs: Vec::new(),
        points: BTreeMap::new(),
        placed: BTreeMap::new(),
        by_slide: Vec::new(),
        conditions: Vec::new(),
        meshes: Vec::new(),
        home: Vec::new(),
    };
    for body in members {
        for (point, _) in bodies.of(*body) {
            if let Some(anchor) = bodies.anchor_of(*point, |other| solved[other]) {
                let form = plan.input(Input::Place(anchor));
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
    plan.finished(offset)
}

/// How a body follows from what is known.
enum Follows {
    /// Two of its points are known, where they are on it.
    Points([(PointId, Vector); 2]),
    /// A point, and the direction by a slide along another body.
    Slide {
        point: (PointId, Vector),
        slide: SlideId,
        other: BodyId,
    },
}

/// One equation, or two, in forms of its own.
enum Condition {
    /// A direction of length 1, and the length of the link along it.
    Unit(Form, f64),
    Zero(Form),
    /// The way along a direction of length 1; and which of the meshes says how far.
    Along {
        direction: Form,
        way: Form,
        mesh: usize,
    },
    /// The turns of bodies, with what their angles are multiplied by; and which of the
    /// meshes says what they add up to.
    Mesh(Vec<(Form, f64)>, usize),
    /// The length of the direction, if the way has one too; none where both are
    /// directions.
    Line {
        direction: Form,
        way: Form,
        length: f64,
    },
}

struct Plan<'a> {
    bodies: &'a Bodies,
    solved: &'a List<BodyId, bool>,
    orientations: &'a List<BodyId, Orientation>,
    inputs: Vec<Input>,
    /// Where points are.
    points: BTreeMap<PointId, Form>,
    /// Origin and turn of the bodies placed so far.
    placed: BTreeMap<BodyId, [Form; 2]>,
    /// Slides that have given a direction.
    by_slide: Vec<SlideId>,
    conditions: Vec<Condition>,
    meshes: Vec<Mesh>,
    /// The drawn values of the unknowns.
    home: Vec<Vector>,
}

impl Plan<'_> {
    fn input(&mut self, input: Input) -> Form {
        // The frame does not move.
        let (Input::Place(anchor) | Input::Direction(anchor)) = input;
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

    fn unknown(&mut self, home: Vector) -> Form {
        self.home.push(home);
        Form {
            unknowns: vec![(self.home.len() - 1, Vector::x())],
            ..Form::default()
        }
    }

    fn is_placed(&self, body: BodyId) -> bool {
        self.solved[body] || self.placed.contains_key(&body)
    }

    /// A slide whose other body is placed.
    fn guided(&self, body: BodyId) -> Option<(SlideId, BodyId)> {
        let mut slides = self.bodies.slides.enumerate();
        slides.find_map(|(slide, joint)| {
            let other = joint.joins(body).filter(|other| self.is_placed(*other))?;
            Some((slide, other))
        })
    }

    fn follows(&self, body: BodyId) -> Option<Follows> {
        let mut known = self.bodies.of(body).iter().copied();
        let mut known = || known.find(|(point, _)| self.points.contains_key(point));
        let first = known()?;
        match self.guided(body) {
            Some((slide, other)) => Some(Follows::Slide {
                point: first,
                slide,
                other,
            }),
            None => Some(Follows::Points([first, known()?])),
        }
    }

    /// How little is lacking to place a body: a guide or a point known, then the
    /// more points it has, the more will follow from it.
    fn readiness(&self, body: BodyId) -> (usize, usize) {
        let known = self
            .bodies
            .of(body)
            .iter()
            .filter(|(point, _)| self.points.contains_key(point));
        let guided = usize::from(self.guided(body).is_some());
        (known.count() + guided, self.bodies.of(body).len())
    }

    /// Makes an unknown of what a body lacks next.
    fn assume(&mut self, body: BodyId, members: &[BodyId], drawn: &impl Fn(PointId) -> Vector) {
        let joints = |point: PointId| {
            members
                .iter()
                .filter(|other| self.bodies.local(**other, point).is_some())
                .count()
        };
        let free = self.bodies.of(body).iter().map(|(point, _)| *point);
        let free = free.filter(|point| !self.points.contains_key(point));
        // Of equals the first: `max_by_key` takes the last.
        let best = free.rev().max_by_key(|point| joints(*point));
        if let Some(point) = best {
            let form = self.unknown(drawn(point));
            self.points.insert(point, form);
            return;
        }
        // A block with one point: its direction is the unknown.
        let turn = self.unknown(self.orientations[body].turn);
        self.conditions.push(Condition::Unit(turn.clone(), 0.0));
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
                if !turn.unknowns.is_empty() {
                    let length = (b - a).norm();
                    self.conditions.push(Condition::Unit(turn.clone(), length));
                }
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

    /// Sets the forms of a body; a point that had one already must agree.
    fn settle(&mut self, body: BodyId, [origin, turn]: [Form; 2], used: &[PointId]) {
        for (point, local) in self.bodies.of(body) {
            let at = origin.plus(&turn.by(*local));
            if used.contains(point) {
                continue;
            }
            match self.points.get(point) {
                Some(known) => {
                    let gap = at.minus(known);
                    self.conditions.push(Condition::Zero(gap));
                }
                None => {
                    self.points.insert(*point, at);
                }
            }
        }
        self.placed.insert(body, [origin, turn]);
    }

    /// A direction of a body that is placed.
    fn direction(&mut self, body: BodyId, heading: Vector) -> Form {
        match self.placed.get(&body) {
            Some([_, turn]) => turn.by(heading),
            None => self.input(Input::Direction(Anchor {
                body,
                local: heading,
            })),
        }
    }

    /// A place on a body that is placed.
    fn place_on(&mut self, body: BodyId, local: Vector) -> Form {
        match self.placed.get(&body) {
            Some([origin, turn]) => origin.plus(&turn.by(local)),
            None => self.input(Input::Place(Anchor { body, local })),
        }
    }

    /// The conditions of the prismatic pairs.
    fn slides(&mut self) {
        let bodies = self.bodies;
        let own = |slide: &Slide| {
            slide
                .bodies
                .iter()
                .any(|body| self.placed.contains_key(body))
        };
        let slides = bodies.slides.enumerate();
        let slides = slides.filter(|(_, slide)| own(slide));
        let slides: Vec<(SlideId, &Slide)> = slides.collect();
        for (index, slide) in slides {
            let [on, moving] = slide.bodies;
            if !self.is_placed(on) || !self.is_placed(moving) {
                continue;
            }
            let [(start, heading), (point, along)] = [on, moving].map(|body| slide.line_on(body));
            let direction = self.direction(on, heading);
            if !self.by_slide.contains(&index) {
                let other = self.direction(moving, along);
                let parallel = Condition::Line {
                    direction: direction.clone(),
                    way: other,
                    length: 0.0,
                };
                self.conditions.push(parallel);
            }
            let way = self
                .place_on(moving, point)
                .minus(&self.place_on(on, start));
            self.conditions.push(Condition::Line {
                direction,
                way,
                length: 1.0,
            });
        }
    }

    /// The condition of wheels in mesh.
    fn mesh(&mut self, gear: &Gear) {
        let equation = willis::Equation::of(gear);
        // In parts of a turn of the larger wheel.
        let scale = gear.teeth[0].max(gear.teeth[1]).recip();
        let terms = equation.terms();
        let terms: Vec<_> = terms.map(|(body, by)| (body, by as f64 * scale)).collect();
        let drawn = terms.iter();
        let drawn = drawn.map(|(body, by)| self.orientations[*body].angle * by);
        let constant = drawn.sum();
        let (turns, known): (Vec<_>, Vec<_>) = terms
            .into_iter()
            .partition(|(body, _)| self.placed.contains_key(body));
        let forms = turns
            .iter()
            .map(|(body, by)| (self.placed[body][1].clone(), *by));
        let condition = Condition::Mesh(forms.collect(), self.meshes.len());
        self.conditions.push(condition);
        self.meshes.push(Mesh {
            turning: turns.into_iter().map(|(body, _)| body).collect(),
            known,
            constant,
            drive: None,
        });
    }

    /// The condition of a driven pair.
    fn drive(&mut self, pair: &DrivenPair) -> Option<()> {
        let mesh = self.meshes.len();
        let course = pair.course;
        let mut given = Mesh {
            turning: Vec::new(),
            known: Vec::new(),
            constant: 0.0,
            drive: Some(Drive {
                course,
                range: None,
            }),
        };
        let condition = match pair.kind {
            PairKind::Hinge { bodies, lead } => {
                let [link, base] = bodies.map(|body| self.placed.get(&body));
                let turns = vec![(link?[1].clone(), 1.0), (base?[1].clone(), -1.0)];
                given.turning = bodies.to_vec();
                given.constant = -lead;
                Condition::Mesh(turns, mesh)
            }
            PairKind::Slide { slide, range } => {
                let slide = &self.bodies.slides[slide];
                given.drive = Some(Drive {
                    course,
                    range: Some(range),
                });
                let [on, moving] = slide.bodies;
                let (start, heading) = slide.line_on(on);
                let point = self.place_on(moving, slide.point());
                Condition::Along {
                    direction: self.direction(on, heading),
                    way: point.minus(&self.place_on(on, start)),
                    mesh,
                }
            }
        };
        self.conditions.push(condition);
        self.meshes.push(given);
        Some(())
    }

    /// The group; none where the equations are not as many as the unknowns.
    fn finished(self, offset: usize) -> Option<(Group, Vec<Vector>)> {
        let mut forms: Vec<Form> = Vec::new();
        let mut index = |form: Form| {
            let known = forms.iter().position(|other| *other == form);
            known.unwrap_or_else(|| {
                forms.push(form);
                forms.len() - 1
            })
        };
        let mut equations = Vec::new();
        for condition in self.conditions {
            match condition {
                Condition::Unit(form, length) => {
                    equations.push((Equation::Unit(index(form)), length));
                }
                Condition::Zero(form) => {
                    let form = index(form);
                    let both = [Equation::Real(form), Equation::Imaginary(form)];
                    equations.extend(both.map(|equation| (equation, 1.0)));
                }
                Condition::Mesh(turns, mesh) => {
                    let mut turns = turns.into_iter();
                    let turns = [(); 3].map(|()| turns.next().map(|(form, by)| (index(form), by)));
                    equations.push((Equation::Mesh { turns, mesh }, 0.0));
                }
                Condition::Along {
                    direction,
                    way,
                    mesh,
                } => {
                    let [direction, way] = [direction, way].map(&mut index);
                    let along = Equation::Along {
                        direction,
                        way,
                        mesh,
                    };
                    equations.push((along, 1.0));
                }
                Condition::Line {
                    direction,
                    way,
                    length,
                } => {
                    let [direction, way] = [direction, way].map(&mut index);
                    equations.push((Equation::Line { direction, way }, length));
                }
            }
        }
        let bodies = self.placed.into_iter();
        let bodies: Vec<_> = bodies
            .map(|(body, forms)| (body, forms.map(&mut index)))
            .collect();
        let unknowns = self.home.len();
        let group = Group::new(
            offset,
            unknowns,
            self.inputs,
            &forms,
            equations,
            self.meshes,
            bodies,
        );
        group.map(|group| (group, self.home))
    }
}
