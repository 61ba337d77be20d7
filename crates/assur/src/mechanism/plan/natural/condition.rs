//! The conditions between the bodies of a group, and their equations.

use super::Plan;
use crate::Vector;
use crate::index::{BodyId, SlideId};
use crate::mechanism::plan::body::Gear;
use crate::mechanism::plan::driver::{DrivenPair, PairKind};
use crate::mechanism::plan::slide::Slide;
use crate::mechanism::plan::willis;
use crate::position::{AngleConstraint, BodyForms, Drive, Equation, Form, Group, conjugate};

/// Condition between linear forms. It gives one equation or two.
pub(in crate::mechanism) enum Condition {
    /// Unit length of a direction. The number is the distance of the two points that define the direction; it turns the
    /// residual into a length. It is 0 if no two points define the direction.
    Unit(Form, f64),
    Zero(Form),
    /// Component of the vector `way` along a unit direction, prescribed by a drive; `mesh` is the index of the angle
    /// constraint that holds the drive.
    Along {
        direction: Form,
        way: Form,
        mesh: usize,
    },
    /// Weighted sum of angles: the turn of each body with the weight of its angle, and the index of the angle
    /// constraint.
    AngleConstraint(Vec<(Form, f64)>, usize),
    /// Vector `way` parallel to a direction. `length` is 1 if `way` joins two points, so that the residual is a length,
    /// and 0 if `way` is itself a direction.
    Line {
        direction: Form,
        way: Form,
        length: f64,
    },
}

impl Plan<'_> {
    /// Adds the conditions of the prismatic pairs.
    pub(in crate::mechanism) fn slides(&mut self) {
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
                self.conditions.push((moving, parallel));
            }
            let way = self
                .place_on(moving, point)
                .minus(&self.place_on(on, start));
            let line = Condition::Line {
                direction,
                way,
                length: 1.0,
            };
            self.conditions.push((moving, line));
        }
    }

    /// Adds the condition that a body keeps its drawn angle to another body.
    pub(in crate::mechanism) fn keep_parallel(&mut self, [base, body]: [BodyId; 2]) {
        let turns = [base, body].map(|body| conjugate(self.orientations[body].turn));
        let condition = Condition::Line {
            direction: self.direction(base, turns[0]),
            way: self.direction(body, turns[1]),
            length: 0.0,
        };
        self.conditions.push((body, condition));
    }

    /// Adds the condition of wheels in mesh.
    pub(in crate::mechanism) fn mesh(&mut self, gear: &Gear) {
        let equation = willis::Equation::of(gear);
        // The equation is scaled so that the coefficient of the larger wheel is ±1.
        let scale = gear.by_link.teeth[0].max(gear.by_link.teeth[1]).recip();
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
        let condition = Condition::AngleConstraint(forms.collect(), self.angle_constraints.len());
        self.conditions.push((gear.bodies[1], condition));
        self.angle_constraints.push(AngleConstraint {
            turning: turns.into_iter().map(|(body, _)| body).collect(),
            known,
            constant,
            drive: None,
        });
    }

    /// Adds the condition of a driven pair. None if the pair is a hinge and one of its bodies is not placed.
    pub(in crate::mechanism) fn drive(&mut self, pair: &DrivenPair) -> Option<()> {
        let mesh = self.angle_constraints.len();
        let course = pair.course;
        let mut given = AngleConstraint {
            turning: Vec::new(),
            known: Vec::new(),
            constant: 0.0,
            drive: Some(Drive {
                law: course,
                range: None,
            }),
        };
        let (driven, condition) = match pair.kind {
            PairKind::Hinge {
                bodies,
                angle_offset,
            } => {
                let [link, base] = bodies.map(|body| self.placed.get(&body));
                let turns = vec![(link?[1].clone(), 1.0), (base?[1].clone(), -1.0)];
                given.turning = bodies.to_vec();
                given.constant = -angle_offset;
                (bodies[0], Condition::AngleConstraint(turns, mesh))
            }
            PairKind::Slide { slide, range } => {
                let slide = &self.bodies.slides[slide];
                given.drive = Some(Drive {
                    law: course,
                    range: Some(range),
                });
                let [on, moving] = slide.bodies;
                let (start, heading) = slide.line_on(on);
                let point = self.place_on(moving, slide.point());
                let along = Condition::Along {
                    direction: self.direction(on, heading),
                    way: point.minus(&self.place_on(on, start)),
                    mesh,
                };
                (moving, along)
            }
        };
        self.conditions.push((driven, condition));
        self.angle_constraints.push(given);
        Some(())
    }

    pub(in crate::mechanism) fn finished(self, offset: usize) -> Option<(Group, Vec<Vector>)> {
        let mut forms: Vec<Form> = Vec::new();
        let mut index = |form: Form| {
            let known = forms.iter().position(|other| *other == form);
            known.unwrap_or_else(|| {
                forms.push(form);
                forms.len() - 1
            })
        };
        let mut equations = Vec::new();
        for (body, condition) in self.conditions {
            match condition {
                Condition::Unit(form, length) => {
                    equations.push((Equation::Unit(index(form)), length, body));
                }
                Condition::Zero(form) => {
                    let form = index(form);
                    let both = [Equation::Real(form), Equation::Imaginary(form)];
                    equations.extend(both.map(|equation| (equation, 1.0, body)));
                }
                Condition::AngleConstraint(turns, constraint) => {
                    let mut turns = turns.into_iter();
                    let turns = [(); 3].map(|()| turns.next().map(|(form, by)| (index(form), by)));
                    equations.push((Equation::Angle { turns, constraint }, 0.0, body));
                }
                Condition::Along {
                    direction,
                    way,
                    mesh,
                } => {
                    let [axis, vector] = [direction, way].map(&mut index);
                    let along = Equation::Along {
                        axis,
                        vector,
                        constraint: mesh,
                    };
                    equations.push((along, 1.0, body));
                }
                Condition::Line {
                    direction,
                    way,
                    length,
                } => {
                    let [axis, vector] = [direction, way].map(&mut index);
                    equations.push((Equation::Line { axis, vector }, length, body));
                }
            }
        }
        let close = self.close;
        let bodies = self.placed.into_iter().map(|(body, forms)| BodyForms {
            body,
            forms: forms.map(&mut index),
            close: close.get(&body).copied(),
        });
        let bodies: Vec<BodyForms> = bodies.collect();
        let group = Group::new(
            offset,
            self.units,
            self.inputs,
            &forms,
            equations,
            self.angle_constraints,
            bodies,
        );
        group.map(|group| (group, self.drawn_input))
    }
}
