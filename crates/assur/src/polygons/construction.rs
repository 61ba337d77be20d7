//! Which vector equations are drawn for each step of the plan.

use super::Node;
use crate::Vector;
use crate::index::{BodyId, PointId, StepId};
use crate::mechanism::{Joint, Mechanism, arms_of};
use crate::position::{Arm, Side, Step, Track};

/// How a point is told from a known one.
pub(super) struct Way {
    pub(super) from: Node,
    pub(super) by: By,
}

pub(super) enum By {
    /// Both are points of this body.
    Turning(BodyId),
    /// It slides along a line in this direction of this body, of which the known one is a point, or against which it
    /// keeps its angle.
    Sliding(BodyId, Vector),
}

/// A point with the ways that lead to it: one of what is driven, or two.
pub(super) struct Equations {
    pub(super) target: Node,
    pub(super) ways: Vec<Way>,
}

/// A point that bodies have in common, or one of them has.
fn node(point: PointId) -> Node {
    Node { point, on: None }
}

/// The place of a body at which a point is.
fn on(body: BodyId, point: PointId) -> Node {
    Node {
        point,
        on: Some(body),
    }
}

/// A point of the body of an arm, which it turns about.
fn turning(mechanism: &Mechanism, arm: &Arm) -> Option<Way> {
    let outer = mechanism.shared_by([arm.body, arm.outer.body], Some(arm.from))?;
    Some(Way {
        from: node(outer),
        by: By::Turning(arm.body),
    })
}

/// Along a track a point slides on the body that has it.
fn sliding(point: PointId, track: &Track) -> Way {
    Way {
        from: on(track.line.body, point),
        by: By::Sliding(track.line.body, track.heading),
    }
}

/// The hinge of a side of a dyad.
fn hinge(mechanism: &Mechanism, side: &Side) -> Option<PointId> {
    mechanism.shared_by([side.body, side.outer.body], Some(side.hinge))
}

/// The equations of a step; none of a group that is no dyad, and of a body that shows no further point.
pub(super) fn equations(mechanism: &Mechanism, step: StepId) -> Vec<Equations> {
    match &mechanism.steps()[step] {
        Step::Geared(geared) => {
            let wheels = geared.members.iter();
            let found = wheels
                .filter_map(|wheel| driven(mechanism, [wheel.at.body, wheel.body], wheel.hinge));
            found.collect()
        }
        Step::Crank(crank) => {
            let found = driven(mechanism, [crank.at.body, crank.body], crank.hinge);
            found.into_iter().collect()
        }
        other => of_dyad(mechanism, other).into_iter().collect(),
    }
}

/// Of a body that turns about a hinge as something else tells: its first other point.
fn driven(mechanism: &Mechanism, [base, body]: [BodyId; 2], at: Vector) -> Option<Equations> {
    let hinge = mechanism.shared_by([body, base], Some(at))?;
    let mut points = mechanism
        .points_on(body)
        .chain(mechanism.tracers_on(body))
        .filter(|point| *point != hinge);
    Some(Equations {
        target: node(points.next()?),
        ways: vec![Way {
            from: node(hinge),
            by: By::Turning(body),
        }],
    })
}

fn of_dyad(mechanism: &Mechanism, step: &Step) -> Option<Equations> {
    let found = match step {
        Step::Slider(slider) => {
            let point = mechanism.point_at(slider.track.body, slider.track.point)?;
            Equations {
                target: node(point),
                ways: vec![sliding(point, &slider.track)],
            }
        }
        Step::Rrp(dyad) => {
            let (arm, track) = (&dyad.arm, &dyad.track);
            let inner = mechanism.shared_by([arm.body, track.body], Some(arm.to))?;
            Equations {
                target: node(inner),
                ways: vec![turning(mechanism, arm)?, sliding(inner, track)],
            }
        }
        Step::Rpr(dyad) => {
            // The hinge of what slides, as it lies on the body with the line.
            let [i, j] = &dyad.sides;
            let slides = |side: &Side| {
                let mut joints = mechanism.joints().into_iter();
                joints.any(|joint| {
                    let both = [i.body, j.body];
                    matches!(joint, Joint::Slide { bodies: [on, slides], .. }
                        if slides == side.body && both.contains(&on) && on != slides)
                })
            };
            let [block, guide] = if slides(i) { [i, j] } else { [j, i] };
            let pin = hinge(mechanism, block)?;
            Equations {
                target: on(guide.body, pin),
                ways: vec![
                    Way {
                        from: node(pin),
                        by: By::Sliding(block.body, block.direction),
                    },
                    Way {
                        from: node(hinge(mechanism, guide)?),
                        by: By::Turning(guide.body),
                    },
                ],
            }
        }
        Step::Prp(dyad) => {
            let [first, second] = &dyad.tracks;
            let inner = mechanism.shared_by([first.body, second.body], Some(first.point))?;
            Equations {
                target: node(inner),
                ways: vec![sliding(inner, first), sliding(inner, second)],
            }
        }
        Step::Rpp(dyad) => {
            let (side, track) = (&dyad.side, &dyad.track);
            let pin = hinge(mechanism, side)?;
            Equations {
                target: on(track.body, pin),
                ways: vec![
                    Way {
                        from: node(pin),
                        by: By::Sliding(side.body, side.direction),
                    },
                    sliding(pin, track),
                ],
            }
        }
        other => {
            let arms = arms_of(other)?;
            let inner = mechanism.shared_by([arms[0].body, arms[1].body], Some(arms[0].to))?;
            Equations {
                target: node(inner),
                ways: vec![turning(mechanism, &arms[0])?, turning(mechanism, &arms[1])?],
            }
        }
    };
    Some(found)
}
