//! Properties of every chain of dyads, however the dyads are joined.

use assur::mechanism::{LinkageSpec, Mechanism, PointSpec};
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::scaled;

use super::following::{Random, closes, does_not_jump, inputs, leads_to_itself};

const CHAINS: usize = 400;

/// A chain under construction: on which links new dyads can be set.
struct Chain {
    draft: LinkageSpec,
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
            draft: LinkageSpec::default(),
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
        self.draft.points.push(PointSpec {
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

pub(crate) fn moving(seed: u64) -> Option<(LinkageSpec, Motion)> {
    let draft = Chain::new(seed).draft;
    let mechanism = Mechanism::new(&draft).ok()?;
    let motion = Motion::new(mechanism);
    Some((draft, motion))
}

#[test]
fn chains_close_with_all_derivatives() {
    let mut random = Random::new(7);
    let (mut closed, mut checked) = (0, 0);
    for seed in 0..scaled(CHAINS) as u64 {
        let Some((draft, motion)) = moving(seed) else {
            continue;
        };
        closed += 1;
        let inputs = inputs(&motion, &mut random);
        checked += closes(seed, &draft, &motion, &inputs);
    }
    assert!(closed > scaled(CHAINS) / 2, "{closed}");
    assert!(checked > 3 * scaled(CHAINS), "{checked}");
}

#[test]
fn any_pose_leads_to_the_same_motion() {
    let mut random = Random::new(11);
    let mut checked = 0;
    for seed in 0..scaled(CHAINS) as u64 / 4 {
        let Some((draft, motion)) = moving(seed) else {
            continue;
        };
        let inputs = inputs(&motion, &mut random);
        checked += leads_to_itself(seed, &draft, &motion, &inputs);
    }
    assert!(checked > scaled(CHAINS) / 2, "{checked}");
}

#[test]
fn nothing_jumps() {
    for seed in 0..scaled(CHAINS) as u64 / 8 {
        if let Some((_, motion)) = moving(seed) {
            does_not_jump(seed, &motion);
        }
    }
}
