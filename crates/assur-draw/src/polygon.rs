//! A polygon of velocities or accelerations as a drawing of its own: to one scale over the motion, step by step.

use assur::mechanism::Mechanism;
use assur::motion::{Input, Motion};
use assur::polygons::{Kind, Node, Order, Polygon, Stage};
use assur::sorting::sort_by;
use assur::{Point, Vector};

use crate::list::{List, Look, Role};
use crate::parts;

/// Inputs of an arc that are looked at for the size of the drawing.
const SAMPLES: u32 = 90;
/// Next to dead points vectors grow without bound: the outermost of so many places do not count.
const USUAL: usize = 12;
/// Vectors shorter than this, in units, are points.
const LEAST: f64 = 0.3;
/// How far a direction is drawn beyond its beginning before the point on it is found, in units.
const DIRECTION: f64 = 120.0;
/// How far below the polygon its scale is, in units, and how much of the width it takes at most.
const BELOW: f64 = 9.0;
const BAR: f64 = 0.4;

/// One step of the drawing: a vector equation, or points that follow.
#[derive(Clone, Copy, Debug)]
pub struct PolygonStep<'a> {
    /// The stage that it belongs to.
    pub stage: &'a Stage,
    /// Which of its equations; none where points follow.
    pub route: Option<usize>,
}

impl PolygonStep<'_> {
    /// Whether its points are known when it is done.
    pub fn finds(&self) -> bool {
        self.route
            .is_none_or(|route| route + 1 == self.stage.routes.len())
    }
}

/// The steps in which a polygon is drawn.
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

/// Within what the polygons of a motion are drawn.
#[derive(Clone, Debug)]
pub struct PolygonSheet {
    order: Order,
    bounds: [f64; 4],
    bar: f64,
}

/// A polygon that is drawn.
#[derive(Clone, Debug)]
pub struct PolygonPicture {
    /// The display list.
    pub list: List,
    /// What its labels stand for.
    pub names: Vec<String>,
    /// Its rectangle: left, bottom, right, top.
    pub bounds: [f64; 4],
    /// How long the line is that shows the scale: a round number.
    pub bar: f64,
}

impl PolygonSheet {
    /// Of a motion at the speed and acceleration of its input: as large as most of its polygons are.
    pub fn new(motion: &Motion, order: Order, input: Input) -> Self {
        let arcs = motion.cycle().arcs().iter();
        let inputs = arcs.flat_map(|[from, to]| {
            (0..SAMPLES)
                .map(move |i| from + (to - from) * (f64::from(i) + 0.5) / f64::from(SAMPLES))
        });
        let mut sides: [Vec<f64>; 4] = Default::default();
        for at in inputs {
            if let Ok(pose) = motion.pose::<3>(at) {
                let polygon = motion.mechanism().polygon(&pose, order, input);
                let around = around(&polygon);
                for (side, value) in sides.iter_mut().zip(around) {
                    side.push(value.abs());
                }
            }
        }
        let usual = sides.map(|mut side| {
            sort_by(&mut side, f64::total_cmp);
            let last = side.len().saturating_sub(1 + side.len() / USUAL);
            side.get(last).copied().unwrap_or(0.0)
        });
        let [left, bottom, right, top] = usual;
        let size = (left + right).max(bottom + top);
        let size = if size > 0.0 { size } else { 1.0 };
        let middle = [0.5 * (right - left), 0.5 * (top - bottom)];
        // A polygon along one line has room across it, too.
        let half = [left + right, bottom + top].map(|side| 0.5 * side.max(0.4 * size));
        Self {
            order,
            bounds: [
                middle[0] - half[0],
                middle[1] - half[1],
                middle[0] + half[0],
                middle[1] + half[1],
            ],
            bar: round(BAR * 2.0 * half[0]),
        }
    }

    /// A polygon after so many of its steps, with the names that points have in it.
    pub fn draw(
        &self,
        mechanism: &Mechanism,
        polygon: &Polygon,
        shown: usize,
        name: impl Fn(Node) -> String,
    ) -> PolygonPicture {
        let here = around(polygon);
        let [left, bottom, right, top] = [
            self.bounds[0].min(here[0]),
            self.bounds[1].min(here[1]),
            self.bounds[2].max(here[2]),
            self.bounds[3].max(here[3]),
        ];
        let unit = (right - left).max(top - bottom) / 100.0;
        let mut drawing = Drawing {
            list: List::default(),
            names: Vec::new(),
            order: self.order,
            unit,
        };
        let steps = polygon_steps(polygon);
        let shown = shown.min(steps.len());
        for (k, step) in steps[..shown].iter().enumerate() {
            drawing.step(step, k + 1 == shown);
        }
        drawing.images(mechanism, &steps[..shown]);
        let pole = if self.order == Order::Velocity {
            "p"
        } else {
            "π"
        };
        drawing.point(pole.to_owned(), Vector::zeros(), Vector::new(-1.0, -1.0));
        for step in steps[..shown].iter().filter(|step| step.finds()) {
            for (node, at) in &step.stage.nodes {
                // What stands still is at the pole, and goes by its name.
                if at.norm() > LEAST * unit {
                    drawing.point(name(*node), *at, *at);
                }
            }
        }
        let base = bottom - BELOW * unit;
        drawing.scale(Point::new(left, base), self.bar);
        PolygonPicture {
            list: drawing.list,
            names: drawing.names,
            bounds: [left, base - 2.0 * unit, right.max(left + self.bar), top],
            bar: self.bar,
        }
    }
}

/// The rectangle around a polygon and its pole.
fn around(polygon: &Polygon) -> [f64; 4] {
    let stages = polygon.stages.iter();
    let places = stages.flat_map(|stage| {
        let legs = stage.routes.iter().flat_map(|route| &route.legs);
        let ends = legs.flat_map(|leg| leg.ends);
        ends.chain(stage.nodes.iter().map(|(_, at)| *at))
    });
    places.fold([0.0; 4], |[left, bottom, right, top], at| {
        [
            left.min(at.x),
            bottom.min(at.y),
            right.max(at.x),
            top.max(at.y),
        ]
    })
}

/// The greatest of 1, 2 and 5 times a power of ten that is no greater.
fn round(length: f64) -> f64 {
    let power = 10.0_f64.powf(length.log10().floor());
    let whole = [5.0, 2.0, 1.0].map(|digit| digit * power);
    let found = whole.into_iter().find(|round| *round <= length);
    found.unwrap_or(length)
}

struct Drawing {
    list: List,
    names: Vec<String>,
    order: Order,
    unit: f64,
}

impl Drawing {
    /// What points have of velocity or acceleration has its colour, what they have more than others is ink.
    fn role(&self) -> Role {
        match self.order {
            Order::Velocity => Role::Velocity,
            Order::Acceleration => Role::Acceleration,
        }
    }

    fn arrow(&mut self, role: Role, [from, to]: [Vector; 2]) {
        if (to - from).norm() > LEAST * self.unit {
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

    /// Thin lines between the points of one link: its image.
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

    /// A point with its name, which stands off it in a direction.
    fn point(&mut self, name: String, at: Vector, away: Vector) {
        self.list
            .circle(Role::Ink, Look::Solid, at.into(), 0.7 * self.unit);
        let off = away.normalize() * 1.1;
        self.names.push(name);
        let number = self.names.len() - 1;
        self.list.name(Role::Ink, number, at.into(), [off.x, off.y]);
    }

    /// The line that shows the scale.
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
    use assur::mechanism::{Draft, Mechanism};

    fn four_bar() -> Motion {
        let draft = Draft::default()
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

    /// Pole, crank, two equations: the first leaves a direction, the second a point; after each there is more to see.
    #[test]
    fn steps_of_a_four_bar() {
        let motion = four_bar();
        let mechanism = motion.mechanism();
        let pose = motion.pose::<3>(1.0).expect("a pose");
        for order in [Order::Velocity, Order::Acceleration] {
            let sheet = PolygonSheet::new(&motion, order, Input::ANALOGUES);
            let polygon = mechanism.polygon(&pose, order, Input::ANALOGUES);
            let steps = polygon_steps(&polygon);
            let finds: Vec<bool> = steps.iter().map(PolygonStep::finds).collect();
            assert_eq!(finds, [true, true, false, true]);
            let name = |node: Node| mechanism.point_name(node.point).to_lowercase();
            let drawn = |shown| sheet.draw(mechanism, &polygon, shown, name);
            let names: Vec<usize> = (0..=5).map(|shown| drawn(shown).names.len()).collect();
            assert_eq!(names, [1, 1, 2, 2, 3, 3]);
            let all = drawn(usize::MAX);
            assert_eq!(all.names[1..], ["b", "c"]);
            assert!(all.bar > 0.0 && all.bounds.iter().all(|side| side.is_finite()));
            assert!(all.list.numbers().iter().all(|number| number.is_finite()));
        }
    }
}
