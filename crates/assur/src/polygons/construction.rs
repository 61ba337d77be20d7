//! Vector equations drawn for each step of the plan.

use super::Node;
use crate::Vector;
use crate::index::{BodyId, PointId, StepId};
use crate::mechanism::{Joint, Mechanism, arms_of};
use crate::position::{Step, Track};

/// The construction of a point from a known one.
pub(super) struct Way {
    pub(super) from: Node,
    pub(super) by: By,
}

pub(super) enum By {
    /// Both are points of this body.
    Turning(BodyId),
    /// It slides along a line of this body in this direction. The known point is on the line's body, or on one that
    /// keeps its angle to it.
    Sliding(BodyId, Vector),
}

/// A point with the routes to it: one if it is driven, or two.
pub(super) struct Equations {
    pub(super) target: Node,
    pub(super) ways: Vec<Way>,
}

/// A point of one body, or common to several.
fn node(point: PointId) -> Node {
    Node { point, on: None }
}

/// The place of a body that coincides with a point.
fn on_body(body: BodyId, point: PointId) -> Node {
    Node {
        point,
        on: Some(body),
    }
}

/// The turning of a body about a point.
fn turning(about: PointId, body: BodyId) -> Way {
    Way {
        from: node(about),
        by: By::Turning(body),
    }
}

/// The sliding of a point along a track, on the body with the line.
fn sliding(point: PointId, track: &Track) -> Way {
    Way {
        from: on_body(track.line.body, point),
        by: By::Sliding(track.line.body, track.heading),
    }
}

/// The one of two bodies with the line along which they slide.
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

/// The equations of a step; none for a group that is not a dyad, and for a body without further points.
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

/// The equation of a body that turns about a hinge in a known way, for its first other point.
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
            // The hinge of the sliding body, as a place of the body with the line.
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
