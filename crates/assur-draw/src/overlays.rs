//! What can be laid over the drawing: paths, centres of mass, analogues of
//! velocity and acceleration, the loop's vectors, the transmission angle.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur::catalog::mixer::Mixer;
use assur::{JetPoint, Link, Offset, Point, Pose, Vector};

use crate::list::{Label, List, Look, Role};
use crate::parts;

/// What is shown over the mechanism.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Overlays {
    /// The paths of B and C.
    pub traces: bool,
    /// The centres of mass C₁, C₂, C₃, each in the middle of its link.
    pub centres: bool,
    /// First and second derivatives of B and C by the crank angle.
    pub vectors: bool,
    /// l₁ … l₄ of the loop and its diagonal l₅.
    pub loop_vectors: bool,
    /// The arc of the transmission angle μ at C.
    pub transmission: bool,
}

/// How long the vectors of a motion are drawn: lengths of the drawing per
/// analogue of velocity and of acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales([f64; 2]);

impl Scales {
    /// Crank angles that are looked at.
    const SAMPLES: u32 = 180;
    /// The longest usual vector relative to the drawing's size.
    const LONGEST: f64 = 0.3;

    /// The room that is made for the longest, relative to the drawing's size.
    const ROOM: f64 = 0.5;

    /// The scales for a drawing of this size: constant over the cycle. Next to
    /// dead points C's vectors grow without bounds, so the longest tenth of them
    /// does not count. With them the tips for which there must be room.
    pub(crate) fn new(mixer: &Mixer, size: f64) -> (Self, Vec<Point>) {
        let (mut all, mut of_c) = (Vec::new(), Vec::new());
        for [from, to] in mixer.linkage.cycle().arcs() {
            for i in 0..Self::SAMPLES {
                let share = (f64::from(i) + 0.5) / f64::from(Self::SAMPLES);
                let crank = from + (to - from) * share;
                if let Ok(pose) = mixer.linkage.pose::<3>(mixer.assembly, crank) {
                    let [_, b, c, _] = mixer.linkage.joints(&pose);
                    of_c.push(c);
                    all.extend([b, c]);
                }
            }
        }
        let scales = Self::of(&of_c, mixer.linkage.length(Link::Crank), size);
        let tips = scales.tips(&all, size);
        (scales, tips)
    }

    /// The scales by which nine tenths of the vectors of these points, and one of
    /// the length `least`, have room.
    pub(crate) fn of(points: &[JetPoint<3>], least: f64, size: f64) -> Self {
        Self([1, 2].map(|order| {
            let norms = points.iter().map(|point| point.derivative(order).norm());
            let mut lengths: Vec<f64> = norms.collect();
            lengths.sort_unstable_by(f64::total_cmp);
            let usual = lengths.get(lengths.len() * 9 / 10).copied();
            Self::LONGEST * size / usual.unwrap_or(least).max(least)
        }))
    }

    /// The tips for which there must be room.
    pub(crate) fn tips(self, points: &[JetPoint<3>], size: f64) -> Vec<Point> {
        let tips = points.iter().flat_map(|joint| {
            [1, 2].map(|order| (joint.place(), joint.derivative(order) * self.0[order - 1]))
        });
        let near = tips.filter(|(_, vector)| vector.norm() <= Self::ROOM * size);
        near.map(|(place, vector)| place + vector).collect()
    }
}

/// The symbol of a centre of mass on a link, in the link's own coordinates.
pub(crate) fn centre_of_mass(list: &mut List, label: Label, length: f64, unit: f64) {
    let at = Point::origin() + Vector::x() * (Offset::MIDDLE.along * length);
    mass(list, at, unit);
    list.label(Role::Ink, label, at, [-1.0, 1.1]);
}

/// The symbol of a centre of mass.
pub(crate) fn mass(list: &mut List, at: Point, unit: f64) {
    list.circle(Role::Ink, Look::Hollow, at, 1.3 * unit);
    let quarter = |from: f64| -> Vec<Point> {
        let rim = (0..=8).map(|i| {
            let (sin, cos) = (from + FRAC_PI_2 * f64::from(i) / 8.0).sin_cos();
            at + Vector::new(cos, sin) * (1.3 * unit)
        });
        [at].into_iter().chain(rim).collect()
    };
    list.polygons(Role::Ink, Look::Solid, &[quarter(0.0), quarter(PI)]);
}

/// The derivatives of B and C as arrows from where they are; none next to a dead
/// point, where they leave every sheet.
pub(crate) fn analogues(list: &mut List, mixer: &Mixer, pose: &Pose<3>, scales: Scales, unit: f64) {
    let [_, b, c, _] = mixer.linkage.joints(pose);
    for (point, labels) in [
        (b, [Label::BVelocity, Label::BAcceleration]),
        (c, [Label::CVelocity, Label::CAcceleration]),
    ] {
        let tips = arrows(list, &point, scales, unit);
        for ((role, tip), label) in tips.into_iter().zip(labels) {
            if let Some(tip) = tip {
                let off = (tip - point.place()).normalize() * 0.95;
                list.label(role, label, tip, [off.x, off.y]);
            }
        }
    }
}

/// The derivatives of a point as arrows; the tip of each that is drawn.
pub(crate) fn arrows(
    list: &mut List,
    point: &JetPoint<3>,
    scales: Scales,
    unit: f64,
) -> [(Role, Option<Point>); 2] {
    [(Role::Velocity, 1), (Role::Acceleration, 2)].map(|(role, order)| {
        let vector = point.derivative(order) * scales.0[order - 1];
        let length = vector.norm();
        if length > 1000.0 * unit || length < 0.2 * unit {
            return (role, None);
        }
        let tip = point.place() + vector;
        parts::arrow(list, role, point.place(), tip, unit);
        (role, Some(tip))
    })
}

/// l₁ + l₂ = l₄ + l₃, and l₅ from B to D.
pub(crate) fn loop_vectors(list: &mut List, [a, b, c, d]: [Point; 4], unit: f64) {
    for (from, to, label) in [
        (a, b, Label::L1),
        (b, c, Label::L2),
        (d, c, Label::L3),
        (a, d, Label::L4),
        (b, d, Label::L5),
    ] {
        let along = to - from;
        let length = along.norm();
        if length < 3.0 * unit {
            continue;
        }
        let along = along / length;
        // Hinges stay free.
        let [start, tip] = [from + along * (1.1 * unit), to - along * (1.1 * unit)];
        parts::arrow(list, Role::Ink, start, tip, unit);
        let left = [-1.1 * along.y, 1.1 * along.x];
        list.label(Role::Ink, label, from + along * (0.26 * length), left);
    }
}

/// The acute angle at C between the lines of coupler and rocker.
pub(crate) fn transmission(list: &mut List, [_, b, c, d]: [Point; 4], unit: f64) {
    let direction = |to: Point| (to.y - c.y).atan2(to.x - c.x);
    let wrapped = |angle: f64| angle - TAU * (angle / TAU).round();
    let from = direction(b);
    let radius = 9.0 * unit;
    let at = |angle: f64, radius: f64| c + Vector::new(angle.cos(), angle.sin()) * radius;
    let mut turn = wrapped(direction(d) - from);
    if turn.abs() > FRAC_PI_2 {
        // The rocker's line beyond C.
        turn = wrapped(turn + PI);
        list.polyline(
            Role::Secondary,
            Look::Dashed,
            &[c, at(from + turn, 1.35 * radius)],
        );
    }
    let arc: Vec<Point> = (0..=24)
        .map(|i| at(from + turn * f64::from(i) / 24.0, radius))
        .collect();
    list.polyline(Role::Ink, Look::Line, &arc);
    let middle = from + 0.5 * turn;
    let off = [2.6 * middle.cos(), 1.0 * middle.sin()];
    list.label(Role::Ink, Label::Mu, at(middle, radius), off);
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::catalog::mixer::Case;

    fn pose(crank: f64) -> (Mixer, Pose<3>) {
        let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
        let pose = mixer.linkage.pose(mixer.assembly, crank).unwrap();
        (mixer, pose)
    }

    /// The points of the polylines and the labels `(label, x, y)` of a list of
    /// both and of polygons with one loop.
    fn parts_of(list: &List) -> (Vec<Vec<f32>>, Vec<[f32; 3]>) {
        let (mut lines, mut labels, mut rest) = (Vec::new(), Vec::new(), list.numbers());
        while let Some(kind) = rest.first() {
            let length = match *kind as u8 {
                1 => 5 + 2 * rest[4] as usize,
                2 => 4 + 2 * rest[3] as usize,
                4 => 7,
                other => panic!("record {other}"),
            };
            match *kind as u8 {
                2 => lines.push(rest[4..length].to_vec()),
                4 => labels.push([rest[2], rest[3], rest[4]]),
                _ => {}
            }
            rest = &rest[length..];
        }
        (lines, labels)
    }

    /// B's derivatives are as long as the crank and square to each other; all
    /// keep one scale.
    #[test]
    fn analogues_are_derivatives_to_scale() {
        for crank in [0.3, 2.0, 5.1] {
            let (mixer, pose) = pose(crank);
            let (scales, _) = Scales::new(&mixer, 2.0);
            let mut list = List::default();
            analogues(&mut list, &mixer, &pose, scales, 0.02);
            let (_, labels) = parts_of(&list);
            let [_, b, c, _] = mixer.linkage.joints(&pose);
            let of = |label: Label, from: Point| {
                let found = labels.iter().find(|found| found[0] == label as u8 as f32);
                let [_, x, y] = found.unwrap();
                Point::new(f64::from(*x), f64::from(*y)) - from
            };
            let (first, second) = (
                of(Label::BVelocity, b.place()),
                of(Label::BAcceleration, b.place()),
            );
            assert!((first.norm() - scales.0[0] * 0.37).abs() < 1e-6);
            assert!((second.norm() - scales.0[1] * 0.37).abs() < 1e-6);
            assert!(first.dot(&second).abs() < 1e-6);
            let off = of(Label::CVelocity, c.place()) - c.derivative(1) * scales.0[0];
            assert!(off.norm() < 1e-6, "{off}");
            let off = of(Label::CAcceleration, c.place()) - c.derivative(2) * scales.0[1];
            assert!(off.norm() < 1e-6, "{off}");
        }
    }

    /// Also where there are dead points the scales are sensible.
    #[test]
    fn scales_are_finite_and_positive() {
        for lengths in [
            [0.37, 0.85, 0.55, 0.85],
            [0.6, 0.85, 0.3, 0.85],
            [1.0; 4],
            [1e-9, 1.0, 1.0, 1.0],
        ] {
            let dimensions = assur::catalog::mixer::Dimensions {
                lengths,
                ..Case::A.dimensions()
            };
            let mixer = Mixer::new(&dimensions).unwrap();
            for scale in Scales::new(&mixer, 2.0).0.0 {
                assert!(scale.is_finite() && scale > 0.0, "{lengths:?}: {scale}");
            }
        }
    }

    /// The arc spans μ, from the coupler's line.
    #[test]
    fn transmission_arc_spans_the_angle() {
        for step in 0..60 {
            let crank = 0.1 * f64::from(step);
            let (mixer, pose) = pose(crank);
            let joints = mixer.linkage.joints(&pose).map(|joint| joint.place());
            let mut list = List::default();
            transmission(&mut list, joints, 0.02);
            let (lines, _) = parts_of(&list);
            let arc = lines.last().unwrap();
            let angle = |i: usize| {
                let [x, y] = [f64::from(arc[i]), f64::from(arc[i + 1])];
                (y - joints[2].y).atan2(x - joints[2].x)
            };
            let spanned = angle(arc.len() - 2) - angle(0);
            let spanned = (spanned - TAU * (spanned / TAU).round()).abs();
            let expected = mixer.linkage.transmission_angle(crank).unwrap();
            assert!((spanned - expected).abs() < 1e-5, "{crank}: {spanned}");
        }
    }

    /// The loop closes as drawn: every vector begins and ends by its hinges.
    #[test]
    fn loop_vectors_lie_on_the_loop() {
        let (mixer, pose) = pose(1.0);
        let joints = mixer.linkage.joints(&pose).map(|joint| joint.place());
        let mut list = List::default();
        loop_vectors(&mut list, joints, 0.02);
        let (lines, labels) = parts_of(&list);
        assert_eq!((lines.len(), labels.len()), (5, 5));
        let first = joints[0] + (joints[1] - joints[0]) * (0.022 / 0.37);
        let start = Point::new(f64::from(lines[0][0]), f64::from(lines[0][1]));
        assert!((start - first).norm() < 1e-6);
    }
}
