//! Linkages of two dyads: their order, lengths and specification.

use super::dyad::Dyad;
use super::task::{Place, Task};
use super::verdict::{LinkageError, Verdict, verdict};
use crate::linkage::{DriverSpec, FRAME, LinkageSpec, PointSpec};
use crate::sorting::extremes;
use crate::synthesis::four_bar::{Order, Passage};
use crate::tolerance::COINCIDENT;
use crate::{Point, Vector};

/// A body on two dyads, driven by the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Linkage {
    /// The dyads, the driving one first: a crank if there is one, otherwise a slider on the frame, otherwise a block.
    pub dyads: [Dyad; 2],
    /// The verdict, or the reason why the dyads form no linkage.
    pub verdict: Result<Verdict, LinkageError>,
}

impl Linkage {
    /// The linkage of two dyads. If both dyads are of the same kind, the one that drives better is taken as the driving
    /// one: by the passage through the poses, then by order, by full turn, and by the transmission angle.
    pub fn new(task: &Task, dyads: [Dyad; 2]) -> Self {
        let rank = |dyad: &Dyad| match dyad {
            Dyad::Hinges { .. } => 0,
            Dyad::Slider { .. } => 1,
            Dyad::Block { .. } => 2,
        };
        let [a, b] = dyads;
        let ordered = |dyads: [Dyad; 2]| Self {
            dyads,
            verdict: verdict(task, dyads),
        };
        match rank(&a).cmp(&rank(&b)) {
            std::cmp::Ordering::Less => ordered([a, b]),
            std::cmp::Ordering::Greater => ordered([b, a]),
            std::cmp::Ordering::Equal => {
                let [one, other] = [ordered([a, b]), ordered([b, a])];
                if other.merit() > one.merit() {
                    other
                } else {
                    one
                }
            }
        }
    }

    /// Passage, order, full turn and transmission, by which driving dyads are compared.
    fn merit(&self) -> [f64; 4] {
        let Ok(verdict) = &self.verdict else {
            return [-1.0; 4];
        };
        let passage = match verdict.passage {
            Passage::Continuous => 3.0,
            Passage::ThroughChangePoint => 2.0,
            Passage::AcrossDeadPoint => 1.0,
            Passage::OtherCircuit | Passage::Unreached(_) => 0.0,
        };
        let is = |property: bool| f64::from(u8::from(property));
        [
            passage,
            is(verdict.order != Order::Mixed),
            is(verdict.turns),
            verdict.transmission.unwrap_or(0.0),
        ]
    }

    /// The least and the greatest length of the links, frame and coupler included; None if the least is zero, and if no
    /// link has a length, as of a slider and a block.
    pub(super) fn lengths_of(dyads: &[Dyad; 2]) -> Option<[f64; 2]> {
        let mut lengths = Vec::new();
        for dyad in dyads {
            if let Dyad::Hinges { pivot, point } = dyad {
                lengths.push((point - pivot).norm());
            }
        }
        for ends in [
            dyads.each_ref().map(Dyad::point),
            dyads.each_ref().map(Dyad::centre),
        ] {
            if let [Place::Finite(a), Place::Finite(b)] = ends {
                lengths.push((b - a).norm());
            }
        }
        let [least, most] = extremes(lengths.into_iter());
        (least > 0.0 && least.is_finite()).then_some([least, most])
    }

    /// Specification of the linkage as a mechanism that moves, drawn in a pose of the task (the first if there is no
    /// such pose).
    ///
    /// The links are `coupler`, the guided body, and for the first dyad `crank`, `slider` or `block`, for the second
    /// `rocker`, `slider` or `block`, with a 2 if both have the same name. A and D are the hinges on the frame, B and C
    /// those on the body. A slider moves on the line through two points E and F of the frame (of the second dyad G and
    /// H); a block slides along the line through two points with these names of the body. P is the body's origin; it is
    /// left out if the origin is at another of these points.
    pub fn spec(&self, task: &Task, pose: usize) -> LinkageSpec {
        let pose = if pose < task.poses().len() { pose } else { 0 };
        let size = self.size(task);
        let mut spec = LinkageSpec::default();
        let mut coupler: Vec<String> = Vec::new();
        let mut frame: Vec<String> = Vec::new();
        let mut slides = Vec::new();
        let same = self.dyads[0].code() == self.dyads[1].code();
        let mut links = Vec::new();
        for (index, dyad) in self.dyads.iter().enumerate() {
            let [base, joint] = [["A", "B"], ["D", "C"]][index];
            let ends = [["E", "F"], ["G", "H"]][index];
            let number = if index == 1 && same { "2" } else { "" };
            let mut add = |name: &str, at: Point| {
                let name = name.to_owned();
                spec.points.push(PointSpec { name, at });
            };
            // The line is drawn with the size of the linkage on either side of the point.
            let line =
                |through: Point, along: Vector| [through - along * size, through + along * size];
            match *dyad {
                Dyad::Hinges { pivot, point } => {
                    add(base, pivot);
                    add(joint, task.carried(point, pose));
                    frame.push(base.to_owned());
                    coupler.push(joint.to_owned());
                    let name = if index == 0 { "crank" } else { "rocker" };
                    links.push((name.to_owned(), vec![base, joint]));
                }
                Dyad::Slider { point, along } => {
                    add(joint, task.carried(point, pose));
                    coupler.push(joint.to_owned());
                    for (name, at) in ends.iter().zip(line(point, along)) {
                        add(name, at);
                        frame.push((*name).to_owned());
                    }
                    let name = format!("slider{number}");
                    links.push((name.clone(), vec![joint]));
                    slides.push((name, joint, FRAME, ends));
                }
                Dyad::Block { pivot, along } => {
                    add(base, pivot);
                    frame.push(base.to_owned());
                    for (name, at) in ends.iter().zip(line(pivot, along)) {
                        add(name, task.carried(at, pose));
                        coupler.push((*name).to_owned());
                    }
                    let name = format!("block{number}");
                    links.push((name.clone(), vec![base]));
                    slides.push((name, base, "coupler", ends));
                }
            }
        }
        let origin = task.poses()[pose].place();
        let apart = |name: &String| {
            let at = spec.place(name);
            at.is_none_or(|at| (at - origin).norm() > COINCIDENT * size)
        };
        if coupler.iter().all(apart) {
            let name = "P".to_owned();
            spec.points.push(PointSpec {
                name: name.clone(),
                at: origin,
            });
            coupler.push(name);
        }
        spec.frame = frame;
        links.insert(1, ("coupler".to_owned(), Vec::new()));
        for (name, points) in &links {
            spec = spec.bar(name, points);
        }
        spec.links[1].points = coupler;
        for (link, point, on, line) in slides {
            spec = spec.slide(&link, point, on, line);
        }
        match self.dyads[0] {
            Dyad::Slider { .. } => {
                // The coordinate is measured from E, which is `size` before the first pose.
                let [from, to] = self.range(task, size);
                spec.drivers.push(DriverSpec::Slide {
                    slide: 0,
                    range: [from + size, to + size],
                    rate: 1.0,
                });
                spec
            }
            Dyad::Hinges { .. } | Dyad::Block { .. } => {
                let first = links[0].0.clone();
                spec.crank(&first)
            }
        }
    }

    /// Range of the slider over all poses, measured from its place in the first pose. It is extended on either side by
    /// a tenth of the size, as far as the linkage closes.
    fn range(&self, task: &Task, size: f64) -> [f64; 2] {
        let Ok(driven) = super::driven::Driven::new(self.dyads, task.unit()) else {
            return [-size, size];
        };
        let all = (0..task.poses().len()).map(|k| driven.input(task, k));
        let [from, to] = extremes(all);
        let arc = driven
            .arcs
            .iter()
            .find(|[low, high]| *low <= 0.0 && *high >= 0.0);
        let [low, high] = arc.copied().unwrap_or([from, to]);
        // A driven slide ends before its dead points.
        let inner = COINCIDENT * size;
        let [from, to] = [from - 0.1 * size, to + 0.1 * size];
        [from.max(low + inner), to.min(high - inner)]
    }

    /// Diagonal of the bounding box of the points of the linkage and of the poses.
    fn size(&self, task: &Task) -> f64 {
        let poses = task.poses().iter().map(|pose| pose.place());
        let points = self
            .dyads
            .iter()
            .flat_map(|dyad| [dyad.point(), dyad.centre()]);
        let points = points.filter_map(|place| match place {
            Place::Finite(point) => Some(point),
            Place::Infinite(_) => None,
        });
        let all: Vec<Vector> = poses.chain(points).map(|point| point.coords).collect();
        crate::linkage::spec::extent(all.into_iter()).max(f64::MIN_POSITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_of_a_slider_crank_and_of_a_slider_with_a_block() {
        let slider = Dyad::Slider {
            point: Point::new(4.0, 0.0),
            along: Vector::x(),
        };
        let hinges = Dyad::Hinges {
            pivot: Point::new(0.0, 0.0),
            point: Point::new(0.0, 3.0),
        };
        let block = Dyad::Block {
            pivot: Point::new(0.0, 0.0),
            along: Vector::y(),
        };
        assert_eq!(Linkage::lengths_of(&[hinges, slider]), Some([3.0, 5.0]));
        assert_eq!(Linkage::lengths_of(&[slider, block]), None);
    }
}
