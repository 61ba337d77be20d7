//! The vectors of a polygon.

use super::construction::{By, Equations, Way, equations};
use super::{Kind, Leg, Node, Order, Polygon, Route, Stage};
use crate::index::{BodyId, StepId};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::InputRate;
use crate::position::Step;
use crate::{JetPoint, Vector, perpendicular};

/// A pose, with the order of the derivative to be drawn and the rate of the input.
struct Sheet<'a, const N: usize> {
    mechanism: &'a Mechanism,
    pose: &'a Pose<N>,
    order: Order,
    input: InputRate,
}

pub(super) fn polygon<const N: usize>(
    mechanism: &Mechanism,
    pose: &Pose<N>,
    order: Order,
    input: InputRate,
) -> Polygon {
    let sheet = Sheet {
        mechanism,
        pose,
        order,
        input,
    };
    let mut stages = vec![sheet.frame()];
    for (step, _) in mechanism.steps().enumerate() {
        stages.extend(sheet.step(step));
    }
    let lengths = stages.iter().flat_map(|stage| {
        let legs = stage.routes.iter().flat_map(|route| &route.legs);
        let legs = legs.map(|leg| (leg.ends[1] - leg.ends[0]).norm());
        legs.chain(stage.nodes.iter().map(|(_, at)| at.norm()))
    });
    let largest = lengths.fold(0.0, f64::max);
    Polygon {
        order,
        stages,
        largest,
    }
}

/// Unit vector along a vector; the x-direction for a zero vector.
fn direction(v: Vector) -> Vector {
    let length = v.norm();
    if length > 0.0 {
        v / length
    } else {
        Vector::x()
    }
}

impl<const N: usize> Sheet<'_, N> {
    /// Velocity (order 1) or acceleration (order 2) of a moving point.
    fn rate(&self, point: &JetPoint<N>, order: usize) -> Vector {
        Vector::new(
            self.input.rate(&point.x, order),
            self.input.rate(&point.y, order),
        )
    }

    fn moving(&self, node: Node) -> JetPoint<N> {
        let here = self.mechanism.place(self.pose, node.point);
        match node.on {
            None => here,
            Some(body) => self.mechanism.fixed_to(self.pose, body, here.place()),
        }
    }

    /// Place of a point in the polygon: its velocity or acceleration.
    fn at(&self, node: Node) -> Vector {
        let order = match self.order {
            Order::Velocity => 1,
            Order::Acceleration => 2,
        };
        self.rate(&self.moving(node), order)
    }

    /// The points of a body except those already known, with their places in the polygon.
    fn others(&self, body: BodyId, known: &[(Node, Vector)]) -> Vec<(Node, Vector)> {
        let tracers = self.mechanism.tracers_on(body);
        let points = self.mechanism.points_on(body).chain(tracers);
        let nodes = points.map(|point| Node { point, on: None });
        let new = nodes.filter(|node| known.iter().all(|(other, _)| other != node));
        new.map(|node| (node, self.at(node))).collect()
    }

    fn frame(&self) -> Stage {
        Stage {
            step: None,
            target: None,
            routes: Vec::new(),
            nodes: self.others(BodyId::FRAME, &[]),
            of_group: false,
        }
    }

    /// Stages of the polygon for a step of the plan: one for each target point, then one for the images of the
    /// bodies. Points already known are left out of the images.
    fn step(&self, step: StepId) -> Vec<Stage> {
        let placing = &self.mechanism.steps()[step];
        let bodies = placing.bodies();
        let is_new = |node: &Node| {
            let mut before = self.mechanism.bodies();
            !before.any(|body| {
                let earlier = self.mechanism.placed_by(body) < Some(step);
                earlier
                    && self
                        .mechanism
                        .points_on(body)
                        .any(|point| point == node.point)
            })
        };
        let driven = matches!(
            placing,
            Step::Crank(_) | Step::Slider(_) | Step::Epicyclic(_)
        );
        let mut stages = Vec::new();
        let mut known: Vec<(Node, Vector)> = Vec::new();
        for equations in equations(self.mechanism, step) {
            let Equations { target, ways } = equations;
            let at = self.at(target);
            known.push((target, at));
            stages.push(Stage {
                step: Some(step),
                target: Some(target),
                routes: ways
                    .iter()
                    .map(|way| self.route(target, way, driven))
                    .collect(),
                nodes: vec![(target, at)],
                of_group: false,
            });
        }
        let mut images = Vec::new();
        for body in bodies {
            for (node, at) in self.others(body, &known) {
                if is_new(&node) {
                    known.push((node, at));
                    images.push((node, at));
                }
            }
        }
        if !images.is_empty() {
            stages.push(Stage {
                step: Some(step),
                target: None,
                routes: Vec::new(),
                nodes: images,
                of_group: matches!(placing, Step::Group(_)),
            });
        }
        stages
    }

    /// Route to a point along one way. If `driven`, all vectors of the route are known.
    fn route(&self, target: Node, way: &Way, driven: bool) -> Route {
        let mechanism = self.mechanism;
        let [from, to] = [way.from, target].map(|node| self.moving(node));
        let mut at = self.at(way.from);
        let mut legs = Vec::new();
        let mut add = |kind: Kind, vector: Vector, direction: Vector, known: bool| {
            let ends = [at, at + vector];
            at = ends[1];
            legs.push(Leg {
                kind,
                ends,
                known: known || driven,
                direction,
            });
        };
        let spins = |body: BodyId| {
            let angle = mechanism.body_angle(self.pose, body);
            [1, 2].map(|order| self.input.rate(&angle, order))
        };
        let body = match way.by {
            By::Turning(body) => {
                let arm = to.place() - from.place();
                let [speed, acceleration] = spins(body);
                let (along, across) = (direction(arm), direction(perpendicular(arm)));
                match self.order {
                    Order::Velocity => {
                        add(Kind::Turning, perpendicular(arm) * speed, across, false)
                    }
                    Order::Acceleration => {
                        add(Kind::Normal, -arm * speed * speed, along, true);
                        add(
                            Kind::Tangential,
                            perpendicular(arm) * acceleration,
                            across,
                            false,
                        );
                    }
                }
                body
            }
            By::Sliding(body, heading) => {
                let along = mechanism.turned(self.pose, body, heading);
                let apart = |order: usize| self.rate(&to, order) - self.rate(&from, order);
                let slides = along * apart(1).dot(&along);
                match self.order {
                    Order::Velocity => add(Kind::Sliding, slides, along, false),
                    Order::Acceleration => {
                        let [speed, _] = spins(body);
                        let coriolis = perpendicular(slides) * (2.0 * speed);
                        // Sliding on the frame has no Coriolis acceleration.
                        if body != BodyId::FRAME {
                            add(Kind::Coriolis, coriolis, perpendicular(along), true);
                        }
                        let rest = along * apart(2).dot(&along);
                        add(Kind::Relative, rest, along, false);
                    }
                }
                body
            }
        };
        Route {
            from: way.from,
            body,
            legs,
        }
    }
}
