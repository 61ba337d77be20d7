//! Vector equations drawn for each step of the plan.

use super::Node;
use crate::Vector;
use crate::index::{BodyId, PointId, StepId};
use crate::mechanism::{Joint, Mechanism, arms_of};
use crate::position::{Step, Track};

/// Construction of a point from a known point.
pub(super) struct Way {
    pub(super) from: Node,
    pub(super) by: By,
}

pub(super) enum By {
    /// Both points are on this body.
    Turning(BodyId),
    /// The point slides along a line of this body, in this direction. The known point is on the body with the line, or
    /// on a body at a constant angle to that body.
    Sliding(BodyId, Vector),
}

/// A point with the ways to construct it: one for a driven point, otherwise two.
pub(super) struct Equations {
    pub(super) target: Node,
    pub(super) ways: Vec<Way>,
}

fn node(point: PointId) -> Node {
    Node { point, on: None }
}

/// Node of that point of a body which coincides with a given point.
fn on_body(body: BodyId, point: PointId) -> Node {
    Node {
        point,
        on: Some(body),
    }
}

fn turning(about: PointId, body: BodyId) -> Way {
    Way {
        from: node(about),
        by: By::Turning(body),
    }
}

/// Construction by sliding of a point along a track, from the coincident point of the body with the line.
fn sliding(point: PointId, track: &Track) -> Way {
    Way {
        from: on_body(track.line.body, point),
        by: By::Sliding(track.line.body, track.heading),
    }
}

/// The one of two bodies that carries the line along which they slide on each other; None if no slide joins them.
fn line_of(mechanism: &Mechanism, both: [BodyId; 2]) -> Option<BodyId> {
    let mut joints = mechanism.joints().into_iter();
    joints.find_map(|joint| match joint {
        Joint::Slide {
            bodies: [on, slides],
            ..
        } if both.contains(&on) && both.contains(&slides) => Some(on),
        _ => None,
    })
}

/// Equations of a step. There are none for a group that is neither a dyad nor an epicyclic train, for a body whose only
/// point is its hinge, and for a slider or a PRP dyad whose track has no joint.
pub(super) fn equations(mechanism: &Mechanism, step: StepId) -> Vec<Equations> {
    match &mechanism.steps()[step] {
        Step::Epicyclic(geared) => {
            let wheels = geared.members.iter();
            let found = wheels.filter_map(|wheel| driven(mechanism, wheel.body, wheel.joint));
            found.collect()
        }
        Step::Crank(crank) => {
            let found = driven(mechanism, crank.body, crank.joint);
            found.into_iter().collect()
        }
        other => of_dyad(mechanism, other).into_iter().collect(),
    }
}

/// Equation for the first point, other than the hinge, of a body whose rotation about the hinge is known; None if the
/// body has no other point.
fn driven(mechanism: &Mechanism, body: BodyId, hinge: PointId) -> Option<Equations> {
    let mut points = mechanism
        .points_on(body)
        .chain(mechanism.tracers_on(body))
        .filter(|point| *point != hinge);
    Some(Equations {
        target: node(points.next()?),
        ways: vec![turning(hinge, body)],
    })
}

fn of_dyad(mechanism: &Mechanism, step: &Step) -> Option<Equations> {
    let found = match step {
        Step::Slider(slider) => {
            let point = slider.track.joint?;
            Equations {
                target: node(point),
                ways: vec![sliding(point, &slider.track)],
            }
        }
        Step::Rrp(dyad) => {
            let (arm, track) = (&dyad.arm, &dyad.track);
            let [outer, inner] = arm.joints;
            Equations {
                target: node(inner),
                ways: vec![turning(outer, arm.body), sliding(inner, track)],
            }
        }
        Step::Rpr(dyad) => {
            // The target coincides with the hinge of the sliding body, but is fixed to the body with the line.
            let [i, j] = &dyad.sides;
            let on = line_of(mechanism, [i.body, j.body])?;
            let [block, guide] = if on == j.body { [i, j] } else { [j, i] };
            let pin = block.joint;
            Equations {
                target: on_body(guide.body, pin),
                ways: vec![
                    Way {
                        from: node(pin),
                        by: By::Sliding(guide.body, guide.direction),
                    },
                    turning(guide.joint, guide.body),
                ],
            }
        }
        Step::Prp(dyad) => {
            let [first, second] = &dyad.tracks;
            let inner = first.joint?;
            Equations {
                target: node(inner),
                ways: vec![sliding(inner, first), sliding(inner, second)],
            }
        }
        Step::Rpp(dyad) => {
            let (side, track) = (&dyad.side, &dyad.track);
            let pin = side.joint;
            let line = if line_of(mechanism, [side.body, track.body])? == side.body {
                By::Sliding(side.body, side.direction)
            } else {
                By::Sliding(track.body, dyad.direction)
            };
            Equations {
                target: on_body(track.body, pin),
                ways: vec![
                    Way {
                        from: node(pin),
                        by: line,
                    },
                    sliding(pin, track),
                ],
            }
        }
        other => {
            let arms = arms_of(other)?;
            let ways = arms.each_ref().map(|arm| turning(arm.joints[0], arm.body));
            Equations {
                target: node(arms[0].joints[1]),
                ways: ways.into(),
            }
        }
    };
    Some(found)
}
