//! Polygons of velocities and accelerations of a linkage at an input, as drawings and as equations.

use std::collections::BTreeMap;

use assur::mechanism::{BodyId, FRAME, Mechanism, Pose};
use assur::polygons::{Kind, Leg, Node, Order, Polygon, Stage};
use assur_draw::{PolygonPicture, PolygonSheet, polygon_steps};
use assur_file::Problem;
use serde::Serialize;

use crate::moving::Moving;

const ORDERS: [Order; 2] = [Order::Velocity, Order::Acceleration];

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PolygonsHere {
    /// Steps of the construction, the same for both polygons.
    steps: Vec<PolygonStepHere>,
    /// Pictures of the velocity and acceleration polygons, drawn up to the requested step.
    pictures: [PolygonPictureHere; 2],
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PolygonPictureHere {
    /// Display list.
    list: Vec<f32>,
    /// Names to which the labels of the list refer.
    names: Vec<String>,
    /// Rectangle of the picture in the coordinates of `list`: left, bottom, right, top.
    bounds: [f64; 4],
    /// Velocity or acceleration that the scale bar represents.
    bar: f64,
    /// Usual scale of the motion divided by the scale of this picture; 1 if the polygon fits at the usual scale.
    smaller: f64,
}

/// A step: the pole, a vector equation, or points that are found without one.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
pub(crate) struct PolygonStepHere {
    /// Kind of step: the pole, a vector equation, points found by the image of their link, points of a group that is
    /// not a dyad.
    #[cfg_attr(test, ts(type = "\"pole\" | \"equation\" | \"image\" | \"group\""))]
    kind: &'static str,
    /// The unknown point of the equation.
    target: Option<String>,
    /// The reference point of the equation.
    from: Option<String>,
    /// Number of the link with both points or, for a slide, with the line; 0 for the frame.
    link: Option<String>,
    /// Terms of the sum in the equation for the velocity, and in the equation for the acceleration.
    legs: [Vec<LegHere>; 2],
    /// The points found by this step, each with the magnitudes of its velocity and acceleration.
    found: Vec<FoundHere>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LegHere {
    #[cfg_attr(
        test,
        ts(
            type = "\"turning\" | \"normal\" | \"tangential\" | \"sliding\" | \"coriolis\" | \"relative\""
        )
    )]
    kind: &'static str,
    length: f64,
    /// Whether the length of the vector is known before the point is found.
    known: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FoundHere {
    name: String,
    rates: [f64; 2],
}

impl Moving {
    /// The polygons at an input; their pictures show the first `shown` steps.
    ///
    /// # Errors
    /// The reason why there are no polygons.
    pub(crate) fn polygons(&self, input: f64, shown: usize) -> Result<PolygonsHere, Problem> {
        let mechanism = self.mechanism();
        let pose: Pose<3> = (self.motion().pose(input)).map_err(|why| self.problem(&why))?;
        let rate = self.input();
        let polygons = ORDERS.map(|order| mechanism.polygon(&pose, order, rate));
        let pictures = [0, 1].map(|k| {
            let strokes = ["", "′"][k];
            let name = |node: Node| self.node_name(node).to_lowercase() + strokes;
            let picture =
                PolygonPicture::new(mechanism, &polygons[k], &self.sheets()[k], shown, name);
            PolygonPictureHere {
                list: picture.list.numbers().to_vec(),
                names: picture.names,
                bounds: picture.bounds,
                bar: picture.bar,
                smaller: picture.smaller,
            }
        });
        Ok(PolygonsHere {
            steps: self.steps(&polygons),
            pictures,
        })
    }

    /// The sheets of both polygons, the same for the whole motion.
    fn sheets(&self) -> &[PolygonSheet; 2] {
        let over = |order| PolygonSheet::over(self.motion(), order, self.input());
        self.polygon_sheets().get_or_init(|| ORDERS.map(over))
    }

    /// The steps of both polygons, which have the same construction.
    fn steps(&self, polygons: &[Polygon; 2]) -> Vec<PolygonStepHere> {
        let [first, second] = polygons.each_ref().map(polygon_steps);
        let both = first.iter().zip(&second);
        let steps = both.map(|(velocity, acceleration)| {
            let both = [velocity, acceleration];
            let stages = both.map(|step| step.stage);
            let route = velocity.route.map(|route| &stages[0].routes[route]);
            PolygonStepHere {
                kind: kind(stages[0]),
                target: route.and(stages[0].target).map(|node| self.node_name(node)),
                from: route.map(|route| self.node_name(route.from)),
                link: route.map(|route| self.body_number(route.body)),
                legs: both.map(|step| {
                    let legs = step.route.map(|route| &step.stage.routes[route].legs);
                    legs.into_iter().flatten().map(leg).collect()
                }),
                found: if velocity.finds() {
                    self.found(stages)
                } else {
                    Vec::new()
                },
            }
        });
        steps.collect()
    }

    fn found(&self, [velocity, acceleration]: [&Stage; 2]) -> Vec<FoundHere> {
        let both = velocity.nodes.iter().zip(&acceleration.nodes);
        let found = both.map(|((node, v), (_, a))| FoundHere {
            name: self.node_name(*node),
            rates: [v.norm(), a.norm()],
        });
        found.collect()
    }

    /// Name of a node: that of its point and, if the node is the coincident point of a link, the link's number, as in
    /// `B3`.
    fn node_name(&self, node: Node) -> String {
        let point = self.mechanism().point_name(node.point);
        let number = node.on.map(|body| self.body_number(body));
        [point, &number.unwrap_or_default()].concat()
    }

    /// The number of a link in the drawing; the frame is 0.
    pub(crate) fn body_number(&self, body: BodyId) -> String {
        body_number(self.mechanism(), self.link_numbers(), body)
    }
}

/// The number of a body, from the numbers of links by name; the frame is 0.
pub(crate) fn body_number(
    mechanism: &Mechanism,
    numbers: &BTreeMap<String, String>,
    body: BodyId,
) -> String {
    let name = mechanism.body_name(body);
    if name == FRAME {
        return "0".to_owned();
    }
    let number = numbers.get(name).cloned();
    number.unwrap_or_else(|| body.index().to_string())
}

fn kind(stage: &Stage) -> &'static str {
    if stage.step.is_none() {
        "pole"
    } else if stage.of_group {
        "group"
    } else if stage.routes.is_empty() {
        "image"
    } else {
        "equation"
    }
}

fn leg(leg: &Leg) -> LegHere {
    LegHere {
        kind: match leg.kind {
            Kind::Turning => "turning",
            Kind::Normal => "normal",
            Kind::Tangential => "tangential",
            Kind::Sliding => "sliding",
            Kind::Coriolis => "coriolis",
            Kind::Relative => "relative",
        },
        length: (leg.ends[1] - leg.ends[0]).norm(),
        known: leg.known,
    }
}
