//! What holds of every chain of dyads, however they are joined.

use assur::mechanism::{Draft, DraftPoint, Mechanism, Pose};
use assur::motion::Motion;
use assur::{JetPoint, Point, Vector};

use proptest::prelude::RngExt;
use proptest::test_runner::{RngAlgorithm, TestRng};

const CHAINS: usize = 4_000;

/// Chance with a fixed seed: a failure is a defect, and stays until it is mended.
struct Random(TestRng);

impl Random {
    fn new(seed: u64) -> Self {
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&seed.to_le_bytes());
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
    }

    fn within(&mut self, from: f64, to: f64) -> f64 {
        self.0.random_range(from..to)
    }

    fn below(&mut self, count: usize) -> usize {
        self.0.random_range(0..count)
    }
}

/// A chain under construction: on which links new dyads can be set.
struct Chain {
    draft: Draft,
    /// Links with at least two points; the frame first.
    bases: Vec<String>,
    random: Random,
    snapped: bool,
}

impl Chain {
    fn new(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let snapped = random.below(3) == 0;
        let mut chain = Self {
            draft: Draft::default(),
            bases: vec!["frame".to_owned(), "crank".to_owned()],
            random,
            snapped,
        };
        let a = chain.new_point();
        let b = chain.new_point();
        chain.draft.frame.push(a.clone());
        chain.draft = chain.draft.bar("crank", &[&a, &b]).crank("crank");
        let dyads = 1 + chain.random.below(4);
        for dyad in 0..dyads {
            chain.add(dyad);
        }
        chain
    }

    /// Anywhere; on a coarse grid where much should be in line and equal.
    fn coordinate(&mut self) -> f64 {
        let x = self.random.within(-3.0, 3.0);
        if self.snapped {
            (2.0 * x).round() / 2.0
        } else {
            x
        }
    }

    fn new_point(&mut self) -> String {
        let name = format!("P{}", self.draft.points.len());
        let at = Point::new(self.coordinate(), self.coordinate());
        let taken = self
            .draft
            .points
            .iter()
            .any(|point| (point.at - at).norm() < 0.1);
        let at = if taken {
            at + Vector::new(0.37, 0.21)
        } else {
            at
        };
        self.draft.points.push(DraftPoint {
            name: name.clone(),
            at,
        });
        name
    }

    /// A new point of a link that there is.
    fn base(&mut self) -> (String, String) {
        let link = self.bases[self.random.below(self.bases.len())].clone();
        let point = self.new_point();
        self.give(&link, &point);
        (link, point)
    }

    fn give(&mut self, link: &str, point: &str) {
        if link == "frame" {
            self.draft.frame.push(point.to_owned());
        } else if let Some(link) = self.draft.links.iter_mut().find(|other| other.name == link) {
            link.points.push(point.to_owned());
        }
    }

    /// Two bases, not both the frame's.
    fn two_bases(&mut self) -> [(String, String); 2] {
        loop {
            let two = [self.base(), self.base()];
            if two[0].0 != two[1].0 {
                return two;
            }
        }
    }

    fn bar(&mut self, name: &str, points: &[&String]) {
        let points: Vec<&str> = points.iter().map(|point| point.as_str()).collect();
        self.draft = std::mem::take(&mut self.draft).bar(name, &points);
        if points.len() > 1 {
            self.bases.push(name.to_owned());
        }
    }

    fn slide(&mut self, link: &str, point: &str, on: &str, line: [&String; 2]) {
        let line = line.map(String::as_str);
        self.draft = std::mem::take(&mut self.draft).slide(link, point, on, line);
    }

    /// A guide on a base: one new point and another.
    fn guide(&mut self, (link, first): &(String, String)) -> String {
        let _ = first;
        let second = self.new_point();
        self.give(link, &second);
        second
    }

    fn add(&mut self, dyad: usize) {
        let [i, j] = ["i", "j"].map(|side| format!("{side}{dyad}"));
        let [one, two] = self.two_bases();
        let c = self.new_point();
        match self.random.below(5) {
            0 => {
                self.bar(&i, &[&one.1, &c]);
                self.bar(&j, &[&two.1, &c]);
            }
            1 => {
                let end = self.guide(&two);
                self.bar(&i, &[&one.1, &c]);
                self.bar(&j, &[&c]);
                self.slide(&j, &c, &two.0, [&two.1, &end]);
            }
            2 => {
                let tip = self.new_point();
                self.bar(&i, &[&one.1, &c, &tip]);
                self.bar(&j, &[&two.1]);
                self.slide(&j, &two.1, &i, [&c, &tip]);
            }
            3 => {
                let [first, second] = [self.guide(&one), self.guide(&two)];
                self.bar(&i, &[&c]);
                self.bar(&j, &[&c]);
                self.slide(&i, &c, &one.0, [&one.1, &first]);
                self.slide(&j, &c, &two.0, [&two.1, &second]);
            }
            _ => {
                let end = self.guide(&two);
                let [slot, shoe] = [self.new_point(), self.new_point()];
                self.bar(&i, &[&one.1]);
                self.bar(&j, &[&c, &slot, &shoe]);
                self.slide(&i, &one.1, &j, [&c, &slot]);
                self.slide(&j, &shoe, &two.0, [&two.1, &end]);
            }
        }
    }
}

fn moving(seed: u64) -> Option<(Draft, Motion)> {
    let draft = Chain::new(seed).draft;
    let mechanism = Mechanism::new(&draft).ok()?;
    let motion = Motion::new(&mechanism, mechanism.drawn_assembly());
    Some((draft, motion))
}

/// Inputs over the whole motion, the ends not quite included.
fn inputs(motion: &Motion, random: &mut Random) -> Vec<f64> {
    let arcs = motion.cycle().arcs().to_vec();
    let inside = |random: &mut Random| {
        let [from, to] = arcs[random.below(arcs.len())];
        from + (to - from) * random.within(0.0, 1.0)
    };
    (0..8).map(|_| inside(random)).collect()
}

/// By how much a moving point differs from another, each derivative beside the
/// size that derivatives of this order have.
fn worst<const N: usize>(a: &JetPoint<N>, b: &JetPoint<N>, size: f64, rate: f64) -> f64 {
    (0..N)
        .map(|order| {
            let scale = size * rate.powi(order as i32);
            (a.derivative(order) - b.derivative(order)).norm() / scale
        })
        .fold(0.0, f64::max)
}

/// The size of the mechanism in a pose: between guides nearly parallel links go far.
fn size_at(mechanism: &Mechanism, pose: &Pose<1>) -> f64 {
    let places = (0..mechanism.points().len()).map(|point| mechanism.place(pose, point).place());
    places.fold(mechanism.size(), |size, at| size.max(at.coords.norm()))
}

/// How fast the pose changes: the scale of its derivatives. Near a dead point
/// they grow without bound, and their errors with them.
fn rate(mechanism: &Mechanism, pose: &Pose<4>) -> f64 {
    let points = (0..mechanism.points().len()).map(|point| mechanism.place(pose, point));
    let rates = points.flat_map(|point| {
        (1..4).map(move |order| {
            (point.derivative(order).norm() / mechanism.size()).powf(1.0 / order as f64)
        })
    });
    rates.fold(1.0, f64::max)
}

/// Every point is where each of its links carries it, with all derivatives; a
/// link's angle is that of the line between its points; a sliding point keeps
/// its distance from the line.
#[test]
fn chains_close_with_all_derivatives() {
    let mut random = Random::new(7);
    let (mut closed, mut checked) = (0, 0);
    for seed in 0..CHAINS as u64 {
        let Some((draft, motion)) = moving(seed) else {
            continue;
        };
        closed += 1;
        let mechanism = motion.mechanism();
        let size = mechanism.size();
        for input in inputs(&motion, &mut random) {
            let position = motion.pose::<1>(input);
            let position =
                position.unwrap_or_else(|e| panic!("{seed} at {input}: {e} {:?}", motion.cycle()));
            let Ok(pose) = motion.pose::<4>(input) else {
                continue;
            };
            checked += 1;
            let rate = rate(mechanism, &pose);
            for (link, named) in draft.links.iter().enumerate() {
                for point in mechanism.points_of(link) {
                    let here = mechanism.carried(&pose, link, *point).unwrap();
                    let off = worst(&here, &mechanism.place(&pose, *point), size, rate);
                    assert!(
                        off < 1e-9,
                        "{seed} at {input}: {} of {} is off by {off:e}",
                        draft.points[*point].name,
                        named.name
                    );
                    let [here, there] = [
                        mechanism.carried(&position, link, *point).unwrap(),
                        mechanism.place(&position, *point),
                    ];
                    let off = (here.place() - there.place()).norm() / size_at(mechanism, &position);
                    assert!(off < 1e-12, "{seed} at {input}: closure {off:e}");
                }
                if let [first, second, ..] = mechanism.points_of(link)[..] {
                    let length = (draft.points[second].at - draft.points[first].at).norm();
                    let end = mechanism.place(&pose, first).offset(
                        mechanism.angle(&pose, link),
                        length,
                        0.0,
                    );
                    let off = worst(&end, &mechanism.place(&pose, second), size, rate);
                    assert!(
                        off < 1e-9,
                        "{seed} at {input}: {} is turned off by {off:e}",
                        named.name
                    );
                }
            }
            for slide in &draft.slides {
                let index = |name: &String| {
                    draft
                        .points
                        .iter()
                        .position(|point| point.name == *name)
                        .unwrap()
                };
                let [a, b] = slide
                    .line
                    .each_ref()
                    .map(|name| mechanism.place(&position, index(name)).place());
                let at = mechanism.place(&position, index(&slide.point)).place();
                let heading = (b - a).normalize();
                let [da, db, dp] = [&slide.line[0], &slide.line[1], &slide.point]
                    .map(|name| draft.points[index(name)].at);
                let drawn = (db - da).normalize();
                let [now, then] = [heading.perp(&(at - a)), drawn.perp(&(dp - da))];
                assert!(
                    (now - then).abs() < 1e-12 * size_at(mechanism, &position),
                    "{seed} at {input}: off the guide {:e}",
                    now - then
                );
            }
        }
    }
    assert!(closed > CHAINS / 2, "{closed} of {CHAINS}");
    assert!(checked > 3 * CHAINS, "{checked}");
}

/// Drawn at any other of its poses it is the same mechanism: no way along the
/// motion leads onto another branch.
#[test]
fn any_pose_leads_to_the_same_motion() {
    let mut random = Random::new(11);
    let mut checked = 0;
    for seed in 0..CHAINS as u64 / 4 {
        let Some((draft, motion)) = moving(seed) else {
            continue;
        };
        let mechanism = motion.mechanism();
        let inputs = inputs(&motion, &mut random);
        let Ok(there) = motion.pose::<4>(inputs[0]) else {
            continue;
        };
        // Next to a singular pose the drawing itself is not told apart.
        if rate(mechanism, &there) > 1e3 {
            continue;
        }
        let mut redrawn = draft.clone();
        for (point, place) in redrawn.points.iter_mut().enumerate() {
            place.at = mechanism.place(&there, point).place();
        }
        let other = Mechanism::new(&redrawn).unwrap_or_else(|e| panic!("{seed}: {e:?}"));
        let again = Motion::new(&other, other.drawn_assembly());
        for input in &inputs[1..] {
            let Ok(pose) = motion.pose::<4>(*input) else {
                continue;
            };
            if rate(mechanism, &pose) > 1e3 {
                continue;
            }
            let same = again.pose::<1>(*input);
            let same = same.unwrap_or_else(|e| {
                panic!(
                    "{seed}: drawn at {}, not at {input}: {e} {:?} {:?}",
                    inputs[0],
                    motion.cycle(),
                    again.cycle()
                )
            });
            for point in 0..mechanism.points().len() {
                let off = (mechanism.place(&pose, point).place()
                    - other.place(&same, point).place())
                .norm();
                assert!(
                    off < 1e-8 * mechanism.size(),
                    "{seed}: drawn at {}, at {input} {point} is off by {off:e}",
                    inputs[0]
                );
            }
            checked += 1;
        }
    }
    assert!(checked > CHAINS / 2, "{checked}");
}

/// From sample to sample nothing jumps: a pose is where its neighbour's
/// derivatives say.
#[test]
fn nothing_jumps() {
    for seed in 0..CHAINS as u64 / 8 {
        let Some((_, motion)) = moving(seed) else {
            continue;
        };
        let mechanism = motion.mechanism();
        for [from, to] in motion.cycle().arcs() {
            let count = 1_000;
            let width = (to - from) / f64::from(count);
            let mut before: Option<Pose<4>> = None;
            for k in 0..=count {
                let here = motion
                    .pose::<4>((from + width * f64::from(k)).min(*to))
                    .ok();
                if let (Some(a), Some(b)) = (&before, &here)
                    && rate(mechanism, a).max(rate(mechanism, b)) * width < 0.1
                {
                    for link in 0..mechanism.links().len() {
                        let [p, q] = [a, b].map(|pose| mechanism.angle(pose, link));
                        let promised =
                            p.value() + width * (p.derivative(1) + 0.5 * width * p.derivative(2));
                        assert!(
                            (q.value() - promised).abs() < 0.05,
                            "{seed}: link {link} jumps at {k}: {} {}",
                            q.value(),
                            promised
                        );
                    }
                }
                before = here;
            }
        }
    }
}
