//! Properties of the polygons of every linkage: they close, their points are the derivatives, stated directions are
//! right, two directions cross at their point, and the image of a link is similar to the link.

use assur::mechanism::{BodyId, Mechanism, Pose};
use assur::motion::{InputRate, Motion};
use assur::polygons::{Kind, Node, Order, Polygon, Route};
use assur::{JetPoint, Vector};
use assur_tests::scaled;

use super::following::{Random, inputs, rate, size_at};
use super::{dyads, groups};

/// Closed to this, relative to the longest vector.
const CLOSED: f64 = 1e-12;

struct Checked<'a> {
    seed: u64,
    mechanism: &'a Mechanism,
    pose: &'a Pose<4>,
    input: InputRate,
    order: Order,
    polygon: Polygon,
}

impl Checked<'_> {
    fn moving(&self, node: Node) -> JetPoint<4> {
        let here = self.mechanism.place(self.pose, node.point);
        match node.on {
            None => here,
            Some(body) => self.mechanism.fixed_to(self.pose, body, here.place()),
        }
    }

    /// The derivative of a point by time, of its jet alone.
    fn derivative(&self, node: Node) -> Vector {
        let (
            point,
            InputRate {
                speed,
                acceleration,
            },
        ) = (self.moving(node), self.input);
        match self.order {
            Order::Velocity => point.derivative(1) * speed,
            Order::Acceleration => {
                point.derivative(2) * speed * speed + point.derivative(1) * acceleration
            }
        }
    }

    fn close(&self, what: &str, one: Vector, other: Vector, bound: f64) {
        let off = (one - other).norm() / self.polygon.largest;
        let (seed, order) = (self.seed, self.order);
        assert!(off <= bound, "{seed} {order:?}: {what} is off by {off:e}");
    }

    /// Everything that is said of the polygon; how many crossings were looked at.
    fn check(&self) -> usize {
        let mut known: Vec<Node> = Vec::new();
        let mut crossings = 0;
        for stage in &self.polygon.stages {
            for route in &stage.routes {
                let (from, target) = (route.from, stage.target.unwrap());
                let fixed = from.on.is_some();
                assert!(fixed || known.contains(&from), "{}: {from:?}", self.seed);
                let mut at = self.derivative(from);
                for leg in &route.legs {
                    self.close("the beginning", leg.ends[0], at, CLOSED);
                    at = leg.ends[1];
                    self.along(leg.ends[1] - leg.ends[0], leg.direction);
                }
                self.close("the end", at, self.derivative(target), CLOSED);
                self.directions(route, target);
            }
            if let [first, second] = &stage.routes[..] {
                crossings += self.crosses(first, second, stage.target.unwrap());
            }
            for (node, at) in &stage.nodes {
                self.close("a point", *at, self.derivative(*node), CLOSED);
                assert!(!known.contains(node), "{} has {node:?} twice", self.seed);
                known.push(*node);
            }
        }
        for point in self.mechanism.point_ids() {
            let node = Node { point, on: None };
            assert!(known.contains(&node), "{} lacks {node:?}", self.seed);
        }
        crossings
    }

    fn along(&self, leg: Vector, direction: Vector) {
        let off = leg.perp(&direction).abs() / self.polygon.largest;
        assert!(off <= CLOSED, "{}: {off:e} off its direction", self.seed);
    }

    /// Turning is across the line of two points, sliding along one that both bodies keep: in a drawing, not by angles.
    fn directions(&self, route: &Route, target: Node) {
        let [from, to] = [route.from, target].map(|node| self.moving(node).place());
        for leg in &route.legs {
            let arm = (to - from).norm();
            let off = match leg.kind {
                Kind::Turning | Kind::Tangential => leg.direction.dot(&(to - from)) / arm,
                Kind::Normal => leg.direction.perp(&(to - from)) / arm,
                Kind::Sliding | Kind::Coriolis | Kind::Relative => {
                    assert!((to - from).norm() < 1e-12 * self.mechanism.size());
                    continue;
                }
            };
            assert!(off.abs() < 1e-9, "{}: {leg:?} {off:e}", self.seed);
            if leg.kind == Kind::Normal {
                assert!((leg.ends[1] - leg.ends[0]).dot(&(to - from)) <= 0.0);
            }
        }
    }

    /// As a teacher finds it: from what is known of both, by the two directions alone.
    fn crosses(&self, first: &Route, second: &Route, target: Node) -> usize {
        let ends = [first, second].map(|route| {
            let (last, known) = route.legs.split_last().unwrap();
            assert!(!last.known && known.iter().all(|leg| leg.known));
            (last.ends[0], last.direction)
        });
        let [(a, u), (b, v)] = ends;
        let sine = u.perp(&v);
        if sine.abs() < 1e-3 {
            return 0;
        }
        let crossing = a + u * ((b - a).perp(&v) / sine);
        let bound = 10.0 * CLOSED / sine.abs();
        self.close("the crossing", crossing, self.derivative(target), bound);
        1
    }

    /// The image of a body is similar to it: turned by a right angle and as much larger as it turns fast.
    fn similar(&self) {
        let points: Vec<(Node, Vector)> = self
            .polygon
            .stages
            .iter()
            .flat_map(|stage| stage.nodes.clone())
            .collect();
        let image = |point| {
            let node = Node { point, on: None };
            let mut found = points.iter();
            found.find(|(other, _)| *other == node).unwrap().1
        };
        for body in self.mechanism.bodies().skip(1) {
            let nodes: Vec<_> = self.mechanism.points_on(body).collect();
            let place = |point| self.mechanism.place(self.pose, point).place();
            for three in nodes.windows(3) {
                let [a, b, c] = [three[0], three[1], three[2]];
                let [p, q] = [place(b) - place(a), place(c) - place(a)];
                let [v, w] = [image(b) - image(a), image(c) - image(a)];
                // p w = q v as complex numbers.
                let times = |a: Vector, b: Vector| {
                    Vector::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
                };
                let off = (times(p, w) - times(q, v)).norm();
                let scale = p.norm().max(q.norm()) * self.polygon.largest;
                assert!(off <= 1e-11 * scale, "{} {body:?}: {off:e}", self.seed);
            }
        }
    }
}

/// Checks the polygons of a motion; how many poses, and how many crossings in them.
fn checked(seed: u64, motion: &Motion, random: &mut Random) -> [usize; 2] {
    let mechanism = motion.mechanism();
    let mut counts = [0; 2];
    for at in inputs(motion, random) {
        let Ok(pose) = motion.pose::<4>(at) else {
            continue;
        };
        let position = motion.pose::<1>(at).unwrap();
        // Next to a singular pose derivatives have few digits left.
        if rate(mechanism, &pose) > 1e2 || size_at(mechanism, &position) > 1e2 * mechanism.size() {
            continue;
        }
        counts[0] += 1;
        let input = InputRate {
            speed: random.within(-20.0, 20.0),
            acceleration: random.within(-50.0, 50.0),
        };
        for order in [Order::Velocity, Order::Acceleration] {
            let one = Checked {
                seed,
                mechanism,
                pose: &pose,
                input,
                order,
                polygon: mechanism.polygon(&pose, order, input),
            };
            counts[1] += one.check();
            one.similar();
        }
    }
    counts
}

#[test]
fn polygons_of_chains_of_dyads_are_their_derivatives() {
    let mut random = Random::new(173);
    let mut counts = [0; 2];
    for seed in 0..scaled(150) {
        let Some((_, motion)) = dyads::moving(seed) else {
            continue;
        };
        let [poses, crossings] = checked(seed, &motion, &mut random);
        counts = [counts[0] + poses, counts[1] + crossings];
    }
    assert!(
        counts[0] > scaled(300) && counts[1] > scaled(1_000),
        "{counts:?}"
    );
}

#[test]
fn polygons_of_higher_groups_have_all_points() {
    let mut random = Random::new(174);
    for (kind, name) in groups::KINDS {
        let mut poses = 0;
        for seed in 0..scaled(6) {
            let (_, motion) = groups::moving(kind, seed);
            poses += checked(seed, &motion, &mut random)[0];
            let order = Order::Velocity;
            if let Ok(pose) = motion.pose::<3>(motion.drawn_input()) {
                let polygon = motion
                    .mechanism()
                    .polygon(&pose, order, InputRate::ANALOGUES);
                assert!(polygon.stages.iter().any(|stage| stage.of_group));
                assert_eq!(polygon.stages[0].nodes[0].1, Vector::zeros());
            }
        }
        assert!(poses > scaled(10), "{name}: {poses}");
    }
}

/// Whitworth's motion as books have it: of the lever's point at the pin, with Coriolis' acceleration.
#[test]
fn a_pin_in_a_slotted_lever() {
    let draft = assur::mechanism::LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("D", 0.0, -2.0)
        .point("E", 2.0, 2.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("block", &["B"])
        .bar("lever", &["D", "E"])
        .slide("block", "B", "lever", ["D", "E"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(0.0).unwrap();
    let input = InputRate {
        speed: 3.0,
        acceleration: 0.0,
    };
    let polygon = mechanism.polygon(&pose, Order::Acceleration, input);
    let stage = polygon.stages.iter().find(|stage| stage.routes.len() == 2);
    let stage = stage.unwrap();
    let lever = mechanism.body_of(mechanism.link("lever"));
    assert_eq!(stage.target.unwrap().on, Some(lever));
    let kinds: Vec<Vec<Kind>> = stage
        .routes
        .iter()
        .map(|route| route.legs.iter().map(|leg| leg.kind).collect())
        .collect();
    assert_eq!(
        kinds,
        [
            vec![Kind::Coriolis, Kind::Relative],
            vec![Kind::Normal, Kind::Tangential]
        ]
    );
    // With B at (1, 0) its velocity is 3 upwards; the lever is along (1, 2)/√5, as DB is √5 long. Across it the point of
    // the lever goes with 3/√5, so that it turns with 3/5, and B slides along it with 6/√5: 2 · 3/5 · 6/√5.
    let coriolis = stage.routes[0].legs[0];
    let length = (coriolis.ends[1] - coriolis.ends[0]).norm();
    assert!((length - 7.2 / 5.0_f64.sqrt()).abs() < 1e-12, "{length}");
    assert_ne!(lever, BodyId::FRAME);
}
