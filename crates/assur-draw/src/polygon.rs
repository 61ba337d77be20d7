//! The drawing of a velocity or acceleration polygon, to scale, step by step.

mod sheet;

use assur::mechanism::Mechanism;
use assur::polygons::{Kind, Node, Order, Polygon, Stage};
use assur::{Point, Vector};

use crate::list::{List, Look, Role};
use crate::parts;
pub use sheet::PolygonSheet;

/// Length up to which vectors are not drawn, in symbol units.
const MIN_LENGTH: f64 = 0.3;
/// Half the length of the line that shows the direction of a vector of still unknown length, in symbol units.
const DIRECTION: f64 = 120.0;
/// Distance of the scale bar below the sheet, in symbol units.
const BELOW: f64 = 9.0;
/// Greatest length of the scale bar, as a share of the drawing's width.
const BAR: f64 = 0.4;
/// Lengths of the scale bar, to be multiplied by a power of ten.
const SCALES: [f64; 3] = [5.0, 2.0, 1.0];

/// One step of the drawing: a vector equation, or points found without one.
#[derive(Clone, Copy, Debug)]
pub struct PolygonStep<'a> {
    /// Stage to which the step belongs.
    pub stage: &'a Stage,
    /// Index of the vector equation in the stage; none for points found without one.
    pub route: Option<usize>,
}

impl PolygonStep<'_> {
    /// Whether the points of the stage are known after this step.
    pub fn finds(&self) -> bool {
        self.route
            .is_none_or(|route| route + 1 == self.stage.routes.len())
    }
}

/// Returns the steps in which a polygon is drawn.
pub fn polygon_steps(polygon: &Polygon) -> Vec<PolygonStep<'_>> {
    let stages = polygon.stages.iter();
    let steps = stages.flat_map(|stage| {
        let routes = (0..stage.routes.len()).map(Some);
        let follows = stage.routes.is_empty().then_some(None);
        let routes = routes.chain(follows);
        routes.map(move |route| PolygonStep { stage, route })
    });
    steps.collect()
}

/// A drawn polygon.
#[derive(Clone, Debug)]
pub struct PolygonPicture {
    /// The display list.
    pub list: List,
    /// Names, to which labels refer by index.
    pub names: Vec<String>,
    /// Rectangle of the picture: left, bottom, right, top.
    pub bounds: [f64; 4],
    /// Velocity or acceleration that the scale bar represents, a round number.
    pub bar: f64,
    /// Ratio of the scale usual for the motion to the scale of this polygon; 1 if the polygon fits the sheet.
    pub smaller: f64,
}

impl PolygonPicture {
    /// Draws the first `shown` steps of a polygon on the sheet of its motion, with the names of its points.
    pub fn new(
        mechanism: &Mechanism,
        polygon: &Polygon,
        sheet: &PolygonSheet,
        shown: usize,
        name: impl Fn(Node) -> String,
    ) -> Self {
        let ([left, bottom, right, top], smaller) = sheet.holding(polygon);
        let bar = round(BAR * (right - left));
        let unit = (right - left) / 100.0;
        let mut drawing = Drawing {
            list: List::default(),
            names: Vec::new(),
            order: polygon.order,
            unit,
        };
        let steps = polygon_steps(polygon);
        let shown = shown.min(steps.len());
        for (k, step) in steps[..shown].iter().enumerate() {
            drawing.step(step, k + 1 == shown);
        }
        drawing.images(mechanism, &steps[..shown]);
        let pole = match polygon.order {
            Order::Velocity => "p",
            Order::Acceleration => "π",
        };
        drawing.point(pole.to_owned(), Vector::zeros(), Vector::new(-1.0, -1.0));
        for step in steps[..shown].iter().filter(|step| step.finds()) {
            for (node, at) in &step.stage.nodes {
                // Points at rest coincide with the pole and have no name of their own.
                if at.norm() > MIN_LENGTH * unit {
                    drawing.point(name(*node), *at, *at);
                }
            }
        }
        let base = bottom - BELOW * unit;
        drawing.scale(Point::new(left, base), bar);
        Self {
            list: drawing.list,
            names: drawing.names,
            bounds: [left, base - 2.0 * unit, right, top],
            bar,
            smaller,
        }
    }
}

/// Returns the greatest round length, an entry of `SCALES` times a power of ten, that does not exceed this length.
fn round(length: f64) -> f64 {
    let power = 10.0_f64.powf(length.log10().floor());
    let mut whole = SCALES.iter().map(|digit| digit * power);
    whole.find(|round| *round <= length).unwrap_or(length)
}

struct Drawing {
    list: List,
    names: Vec<String>,
    order: Order,
    unit: f64,
}

impl Drawing {
    /// Returns the colour of absolute velocities or accelerations; relative vectors are black or grey.
    fn role(&self) -> Role {
        match self.order {
            Order::Velocity => Role::Velocity,
            Order::Acceleration => Role::Acceleration,
        }
    }

    fn arrow(&mut self, role: Role, [from, to]: [Vector; 2]) {
        if (to - from).norm() > MIN_LENGTH * self.unit {
            parts::arrow(&mut self.list, role, from.into(), to.into(), self.unit);
        }
    }

    fn step(&mut self, step: &PolygonStep<'_>, last: bool) {
        if let Some(route) = step.route {
            let legs = &step.stage.routes[route].legs;
            for leg in legs {
                let found = leg.known || step.finds() || !last;
                if found {
                    let role = match leg.kind {
                        Kind::Normal | Kind::Coriolis => Role::Secondary,
                        _ => Role::Ink,
                    };
                    self.arrow(role, leg.ends);
                } else {
                    let along = leg.direction * (DIRECTION * self.unit);
                    let [from, to] = [leg.ends[0] - along, leg.ends[0] + along];
                    let line = [from.into(), to.into()];
                    self.list.polyline(Role::Secondary, Look::Dashed, &line);
                }
            }
        }
        if step.finds() {
            for (_, at) in &step.stage.nodes {
                self.arrow(self.role(), [Vector::zeros(), *at]);
            }
        }
    }

    /// Draws the image of each moving link with three points or more: thin lines between the images of its points.
    fn images(&mut self, mechanism: &Mechanism, steps: &[PolygonStep<'_>]) {
        let found = steps.iter().filter(|step| step.finds());
        let nodes: Vec<(Node, Vector)> = found.flat_map(|step| step.stage.nodes.clone()).collect();
        for body in mechanism.bodies().skip(1) {
            let of_body: Vec<Point> = mechanism
                .points_on(body)
                .filter_map(|point| {
                    let node = Node { point, on: None };
                    let mut found = nodes.iter();
                    let found = found.find(|(other, _)| *other == node);
                    found.map(|(_, at)| Point::from(*at))
                })
                .collect();
            if let [first, _, .., _] = of_body[..] {
                let ring: Vec<Point> = of_body.into_iter().chain([first]).collect();
                self.list.polyline(Role::Secondary, Look::Thin, &ring);
            }
        }
    }

    /// Draws a point, with its name offset from the point in the direction `away`.
    fn point(&mut self, name: String, at: Vector, away: Vector) {
        self.list
            .circle(Role::Ink, Look::Solid, at.into(), 0.7 * self.unit);
        let off = away.normalize() * 1.1;
        self.names.push(name);
        let number = self.names.len() - 1;
        self.list.name(Role::Ink, number, at.into(), [off.x, off.y]);
    }

    fn scale(&mut self, from: Point, length: f64) {
        let to = from + Vector::new(length, 0.0);
        let tick = Vector::new(0.0, 1.2 * self.unit);
        for line in [
            [from, to],
            [from - tick, from + tick],
            [to - tick, to + tick],
        ] {
            self.list.polyline(Role::Ink, Look::Line, &line);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::mechanism::{LinkageSpec, Mechanism};
    use assur::motion::{InputRate, Motion};

    fn four_bar() -> Motion {
        let draft = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 1.0, 0.0)
            .point("C", 3.0, 2.0)
            .point("D", 4.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["C", "D"])
            .crank("crank");
        Motion::new(Mechanism::new(&draft).expect("a four-bar"))
    }

    #[test]
    fn scales_are_round() {
        for (length, expected) in [(1.0, 1.0), (4.9, 2.0), (0.7, 0.5), (230.0, 200.0)] {
            assert!((round(length) - expected).abs() < 1e-12 * expected);
        }
    }

    /// The steps are: pole, crank, two equations. The first equation gives a line of known direction, the second a
    /// point on this line. Each step adds to the drawing.
    #[test]
    fn steps_of_a_four_bar() {
        let motion = four_bar();
        let mechanism = motion.mechanism();
        let pose = motion.pose::<3>(1.0).expect("a pose");
        for order in [Order::Velocity, Order::Acceleration] {
            let polygon = mechanism.polygon(&pose, order, InputRate::ANALOGUES);
            let steps = polygon_steps(&polygon);
            let finds: Vec<bool> = steps.iter().map(PolygonStep::finds).collect();
            assert_eq!(finds, [true, true, false, true]);
            let name = |node: Node| mechanism.point_name(node.point).to_lowercase();
            let sheet = PolygonSheet::over(&motion, order, InputRate::ANALOGUES);
            let drawn = |shown| PolygonPicture::new(mechanism, &polygon, &sheet, shown, name);
            let names: Vec<usize> = (0..=5).map(|shown| drawn(shown).names.len()).collect();
            assert_eq!(names, [1, 1, 2, 2, 3, 3]);
            let all = drawn(usize::MAX);
            assert_eq!(all.names[1..], ["b", "c"]);
            assert!(all.bar > 0.0 && all.bounds.iter().all(|side| side.is_finite()));
            assert!(all.list.numbers().iter().all(|number| number.is_finite()));
        }
    }
}
