//! Links with the forces on them: free bodies, and sums of moments with the arms of the forces.

use assur::forces::{
    Acting, Addend, Cause, Component, ForceName, PairId, PlanStep, Source, StepKind,
};
use assur::mechanism::{BodyId, Joint, Mechanism, Pose};
use assur::{Point, Vector, perpendicular};

use super::{Drawing, ForcePicture, Numbers, around, couple, force_symbol, role, size, square};
use crate::list::{Look, Role};
use crate::{force_arrows, parts};

/// Length of the longest arrow, as a share of the size of the links.
const LONGEST: f64 = 0.45;
/// Length of the shortest arrow, as a share of the longest.
const SHORTEST: f64 = 0.15;
/// Least size of the links, as a share of the size of the mechanism.
const LEAST: f64 = 0.15;

/// Friction in a hinge of a free body.
#[derive(Clone, Copy, Debug)]
pub struct FrictionCircle {
    /// The hinge.
    pub pair: PairId,
    /// Radius of the circle: the coefficient times the radius of the pin.
    pub radius: f64,
    /// Friction couple on the body; zero if the hinge does not turn.
    pub couple: f64,
}

/// A force or couple to be drawn.
pub(super) struct Shown {
    pub(super) name: String,
    pub(super) role: Role,
    pub(super) at: Point,
    pub(super) force: Vector,
    pub(super) couple: f64,
    /// Radius and couple of a friction circle that the force touches.
    pub(super) circle: Option<FrictionCircle>,
}

/// Draws a body with all forces and couples on it that are determined. The reaction of a slide is drawn at the sliding point,
/// with its couple. That of a hinge with friction touches the friction circle; its couple is then not drawn.
pub fn free_body_picture(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    body: BodyId,
    acting: &[Acting],
    circles: &[FrictionCircle],
    numbers: Numbers<'_>,
) -> ForcePicture {
    let mut shown = Vec::new();
    for one in acting {
        let part = Component::Whole;
        let name = ForceName {
            body,
            cause: one.cause,
            part,
        };
        let is_reaction = !matches!(one.cause, Cause::Applied(_));
        let role = role(!is_reaction, is_reaction);
        let force = one.force.unwrap_or_default();
        let couple = one.couple.unwrap_or_default();
        let at = place(
            mechanism,
            pose,
            body,
            (one.cause, couple != 0.0),
            one.place(mechanism),
        );
        let circle = match one.cause {
            Cause::Reaction { pair, .. } => circles.iter().find(|circle| circle.pair == pair),
            _ => None,
        };
        if force != Vector::zeros() {
            shown.push(Shown {
                name: force_symbol(&name, false, numbers),
                role,
                at,
                force,
                couple: 0.0,
                circle: circle.copied(),
            });
        }
        let is_in_circle = matches!(one.cause, Cause::Applied(Source::Friction(_)));
        if couple != 0.0 && !is_in_circle {
            shown.push(Shown {
                name: force_symbol(&name, true, numbers),
                role,
                at,
                force: Vector::zeros(),
                couple,
                circle: None,
            });
        }
    }
    bodies(mechanism, pose, &[body], &shown, None)
}

/// Draws a body with the addends of its equations of equilibrium and the place about which moments are taken. All
/// unknown forces are equally long, in the senses in which they are assumed.
pub fn equilibrium_picture(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    body: BodyId,
    (addends, about): (&[Addend], Point),
    numbers: Numbers<'_>,
) -> ForcePicture {
    let given = |one: &Addend| one.size.filter(|_| one.unknown.is_none());
    let greatest = addends.iter().filter(|one| !one.is_couple);
    let greatest = greatest.filter_map(given).fold(0.0, f64::max);
    let usual = if greatest > 0.0 { greatest } else { 1.0 };
    let shown = addends.iter().map(|one| Shown {
        name: force_symbol(&one.name, one.is_couple, numbers),
        role: role(one.unknown.is_none(), one.unknown.is_some()),
        at: place(
            mechanism,
            pose,
            body,
            (one.name.cause, one.is_couple),
            one.place(mechanism),
        ),
        force: one.direction * given(one).unwrap_or(usual),
        couple: if one.is_couple { one.factors[2] } else { 0.0 },
        circle: None,
    });
    let shown: Vec<Shown> = shown.collect();
    bodies(mechanism, pose, &[body], &shown, Some(about))
}

/// Place of a force or couple on a body. A balancing torque has none: it is drawn in the middle of the body.
fn place(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    body: BodyId,
    (cause, is_couple): (Cause, bool),
    own: Point,
) -> Point {
    match cause {
        Cause::Drive { .. } if is_couple => middle(mechanism, pose, body),
        _ => own,
    }
}

/// Draws the links of a step with the forces in its sum of moments and their arms.
pub(super) fn moments_picture(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    step: &PlanStep,
    numbers: Numbers<'_>,
) -> ForcePicture {
    let shown = step.terms.iter().map(|term| Shown {
        name: force_symbol(&term.name, term.is_couple, numbers),
        role: role(term.known, !matches!(term.name.cause, Cause::Applied(_))),
        at: if term.is_couple {
            middle(mechanism, pose, term.name.body)
        } else {
            term.place(mechanism)
        },
        force: term.force,
        couple: if term.is_couple { term.value } else { 0.0 },
        circle: None,
    });
    let shown: Vec<Shown> = shown.collect();
    let about = (step.kind == StepKind::Moments).then(|| step.centre(mechanism));
    bodies(mechanism, pose, &step.bodies, &shown, about)
}

fn places(mechanism: &Mechanism, pose: &Pose<3>, body: BodyId) -> Vec<Point> {
    let points = mechanism.points_on(body);
    let places = points.map(|point| mechanism.place(pose, point).place());
    places.collect()
}

fn middle(mechanism: &Mechanism, pose: &Pose<3>, body: BodyId) -> Point {
    let [left, bottom, right, top] = around(places(mechanism, pose, body).into_iter());
    Point::new(0.5 * (left + right), 0.5 * (bottom + top))
}

/// Length of the arrow of a force, if the greatest force has the length `longest`.
pub(super) fn length(force: f64, greatest: f64, longest: f64) -> f64 {
    if force == 0.0 || greatest == 0.0 {
        0.0
    } else {
        longest * (force / greatest).max(SHORTEST)
    }
}

fn bodies(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    bodies: &[BodyId],
    shown: &[Shown],
    about: Option<Point>,
) -> ForcePicture {
    let own: Vec<Point> = bodies
        .iter()
        .flat_map(|body| places(mechanism, pose, *body))
        .chain(shown.iter().map(|one| one.at))
        .chain(about)
        .collect();
    let extent = size(around(own.iter().copied())).max(LEAST * mechanism.size());
    let greatest = shown.iter().map(|one| one.force.norm());
    let greatest = greatest.fold(0.0, f64::max);
    let arrow = |one: &Shown| {
        let size = one.force.norm();
        let along = one.force.try_normalize(0.0).unwrap_or_default();
        one.at + along * length(size, greatest, LONGEST * extent)
    };
    let edge = 0.08 * extent;
    let tips = shown.iter().map(arrow);
    let all = own.iter().copied().chain(tips);
    let [left, bottom, right, top] = around(all);
    let bounds = square([left - edge, bottom - edge, right + edge, top + edge]);
    let mut drawing = Drawing::new(bounds);
    for body in bodies {
        link(&mut drawing, mechanism, pose, *body);
    }
    if let Some(about) = about {
        for one in shown.iter().filter(|one| one.force != Vector::zeros()) {
            arm(&mut drawing, one, about, arrow(one));
        }
    }
    for one in shown {
        if one.couple != 0.0 {
            let at = couple(&mut drawing, one.role, one.at, one.couple);
            drawing.name(one.role, one.name.clone(), at, at - one.at);
        } else {
            let mut from = one.at;
            if let Some(FrictionCircle { radius, couple, .. }) = one.circle {
                let unit = drawing.unit;
                force_arrows::circle(&mut drawing.list, one.role, one.at, radius, unit);
                let drawn = force_arrows::drawn_radius(radius, unit);
                from += force_arrows::touching(one.force, couple, drawn);
            }
            let tip = arrow(one) + (from - one.at);
            if drawing.arrow(one.role, from, tip) {
                drawing.name(one.role, one.name.clone(), tip, tip - from);
            }
        }
    }
    if let Some(about) = about {
        let unit = drawing.unit;
        drawing.list.circle(Role::Accent1, Look::Solid, about, unit);
    }
    drawing.picture(bounds, false)
}

/// Draws the arm of a force: the perpendicular from a place to its line, which is prolonged if need be.
fn arm(drawing: &mut Drawing, one: &Shown, about: Point, tip: Point) {
    let along = one.force.normalize();
    let ahead = (about - one.at).dot(&along);
    let foot = one.at + along * ahead;
    if (foot - about).norm() < 0.5 * drawing.unit {
        return;
    }
    drawing
        .list
        .polyline(Role::Secondary, Look::Thin, &[about, foot]);
    let length = (tip - one.at).norm();
    let from = if ahead < 0.0 {
        one.at
    } else if ahead > length {
        tip
    } else {
        return;
    };
    let line = [from, foot];
    drawing.list.polyline(Role::Secondary, Look::Dashed, &line);
}

/// Draws a link as a bar or plate with its hinges, and its blocks.
fn link(drawing: &mut Drawing, mechanism: &Mechanism, pose: &Pose<3>, body: BodyId) {
    let unit = drawing.unit;
    let corners = parts::hull(places(mechanism, pose, body));
    match corners[..] {
        [] | [_] => {}
        [from, to] => parts::bar(
            &mut drawing.list,
            Role::Coupler,
            from,
            to,
            parts::BAR * unit,
        ),
        _ => parts::plate(
            &mut drawing.list,
            Role::Coupler,
            &corners,
            parts::BAR * unit,
        ),
    }
    let place = |point| mechanism.place(pose, point).place();
    for joint in mechanism.joints() {
        match joint {
            Joint::Hinge { point, bodies } if bodies.contains(&body) => {
                parts::hinge(&mut drawing.list, place(point), 1.2 * unit);
                let at = place(point);
                let name = mechanism.point_name(point).to_owned();
                drawing.name(Role::Ink, name, at, Vector::new(-1.0, 1.0));
            }
            Joint::Slide {
                bodies: [on, moving],
                point,
                line,
            } if on == body || moving == body => {
                let [from, to] = line.map(place);
                let along = (to - from).try_normalize(0.0).unwrap_or(Vector::x());
                let at = place(point);
                if moving == body {
                    let foot = from + along * (at - from).dot(&along);
                    parts::block(&mut drawing.list, Role::Coupler, [at, foot], along, unit);
                } else {
                    let across = perpendicular(along) * unit;
                    let sides = [at - along * (4.0 * unit), at + along * (4.0 * unit)];
                    for side in [across, -across] {
                        let line = sides.map(|end| end + side * parts::BLOCK[1]);
                        drawing.list.polyline(Role::Coupler, Look::Line, &line);
                    }
                }
            }
            _ => {}
        }
    }
}
