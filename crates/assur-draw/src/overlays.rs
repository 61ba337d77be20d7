//! Overlays of a drawing: paths, centres of mass, analogues of velocity and acceleration, loop vectors, angles.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur::{JetPoint, Point, Vector, perpendicular};

use crate::list::{List, Look, Role};
use crate::parts;
use assur::sorting::sort_by;

/// Choice of overlays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Overlays {
    /// Whether to draw the paths of the points in [`crate::View::traced`].
    pub traces: bool,
    /// Whether to draw the centre of mass of each link: as given, else the middle of a bar or centroid of a plate.
    pub centres: bool,
    /// Whether to draw the first two derivatives of moving points with respect to the input.
    pub vectors: bool,
    /// Whether to draw loop vectors: along the links and the frame, and the diagonal of each RRR dyad.
    pub loop_vectors: bool,
    /// Whether to draw the arc of the transmission angle μ at the inner hinge of each RRR dyad.
    pub transmission: bool,
    /// Whether to draw links in the colours of their Assur groups.
    pub groups: bool,
    /// Whether to draw the number of each link; the frame is 0.
    pub numbers: bool,
}

/// Scales of the vectors of a motion: drawn length per unit of the analogues of velocity and of acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales([f64; 2]);

impl Scales {
    /// Drawn length of the longest vector that determines the scale, relative to the drawing's size.
    const DRAWN_LENGTH: f64 = 0.3;
    /// Greatest length of a vector whose tip must be within the drawing, relative to the drawing's size.
    const ROOM: f64 = 0.5;
    /// Least value assumed for the longest derivative when the scale is computed, relative to the drawing's size.
    const MIN_DERIVATIVE: f64 = 1e-9;

    /// Returns the scales for the paths of points over a motion. The longest tenth of each point's vectors is ignored,
    /// because vectors grow without bound near dead points.
    pub(crate) fn of(paths: &[Vec<JetPoint<3>>], size: f64) -> Self {
        Self([1, 2].map(|order| {
            let usual = |path: &Vec<JetPoint<3>>| {
                let norms = path.iter().map(|point| point.derivative(order).norm());
                let mut lengths: Vec<f64> = norms.collect();
                sort_by(&mut lengths, f64::total_cmp);
                lengths.get(lengths.len() * 9 / 10).copied()
            };
            let longest = paths.iter().filter_map(usual).fold(0.0, f64::max);
            Self::DRAWN_LENGTH * size / longest.max(Self::MIN_DERIVATIVE * size)
        }))
    }

    /// Returns the tips of vectors that must be within the drawing.
    pub(crate) fn tips(self, points: &[JetPoint<3>], size: f64) -> Vec<Point> {
        let tips = points.iter().flat_map(|joint| {
            [1, 2].map(|order| (joint.place(), joint.derivative(order) * self.0[order - 1]))
        });
        let near = tips.filter(|(_, vector)| vector.norm() <= Self::ROOM * size);
        near.map(|(place, vector)| place + vector).collect()
    }
}

/// Draws the symbol of a centre of mass.
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

/// Draws the first two derivatives of a point as arrows, with names at their tips. Very short arrows are left out, as
/// are very long ones, which occur near dead points.
pub(crate) fn vectors<const N: usize>(
    list: &mut List,
    point: &JetPoint<N>,
    names: Option<[usize; 2]>,
    scales: Scales,
    unit: f64,
) {
    for (role, order) in [(Role::Velocity, 1), (Role::Acceleration, 2)] {
        let vector = point.derivative(order) * scales.0[order - 1];
        let length = vector.norm();
        if !(0.2 * unit..=1000.0 * unit).contains(&length) {
            continue;
        }
        let tip = point.place() + vector;
        parts::arrow(list, role, point.place(), tip, unit);
        if let Some(names) = names {
            let off = vector / length * 0.95;
            list.name(role, names[order - 1], tip, [off.x, off.y]);
        }
    }
}

/// Draws a loop vector from hinge to hinge, with its name, unless the hinges nearly touch.
pub(crate) fn loop_vector(list: &mut List, [from, to]: [Point; 2], name: usize, unit: f64) {
    let along = to - from;
    let length = along.norm();
    if length < 3.0 * unit {
        return;
    }
    let along = along / length;
    // The arrow begins and ends at the circles of the hinges.
    let [start, tip] = [from + along * (1.1 * unit), to - along * (1.1 * unit)];
    parts::arrow(list, Role::Ink, start, tip, unit);
    let left = [-1.1 * along.y, 1.1 * along.x];
    list.name(Role::Ink, name, from + along * (0.26 * length), left);
}

/// Draws the acute angle at a dyad's inner hinge c between the lines from c to the outer hinges b and d.
pub(crate) fn transmission(list: &mut List, [b, c, d]: [Point; 3], name: usize, unit: f64) {
    let direction = |to: Point| (to.y - c.y).atan2(to.x - c.x);
    let wrapped = |angle: f64| angle - TAU * (angle / TAU).round();
    let from = direction(b);
    let radius = 9.0 * unit;
    let at = |angle: f64, radius: f64| c + Vector::new(angle.cos(), angle.sin()) * radius;
    let mut turn = wrapped(direction(d) - from);
    if turn.abs() > FRAC_PI_2 {
        // The angle is obtuse, so the acute one is drawn: between cb and the extension of dc beyond c.
        turn = wrapped(turn + PI);
        list.polyline(
            Role::Secondary,
            Look::Dashed,
            &[c, at(from + turn, 1.35 * radius)],
        );
    }
    let look = (Role::Ink, Look::Line);
    arc(list, look, c, radius, [from, turn], (name, OFF[0]));
}

/// Horizontal distance of a name from its arc, in text heights: for a symbol with a value, and for a bare symbol.
const OFF: [f64; 2] = [2.6, 1.1];

/// Draws an arc that begins at an angle `from` and extends through `turn`, with a name beside its middle.
fn arc(
    list: &mut List,
    (role, look): (Role, Look),
    centre: Point,
    radius: f64,
    [from, turn]: [f64; 2],
    (name, off): (usize, f64),
) {
    let at = |angle: f64| centre + Vector::new(angle.cos(), angle.sin()) * radius;
    let points: Vec<Point> = (0..=24)
        .map(|i| at(from + turn * f64::from(i) / 24.0))
        .collect();
    list.polyline(role, look, &points);
    let middle = from + 0.5 * turn;
    let off = [off * middle.cos(), 1.0 * middle.sin()];
    list.name(role, name, at(middle), off);
}

/// Draws the distance between two points: a line with a stroke across each end, and its name beside its middle.
pub(crate) fn distance(list: &mut List, [a, b]: [Point; 2], name: usize, unit: f64) {
    let way = b - a;
    let length = way.norm();
    if length <= 0.0 {
        return;
    }
    let across = perpendicular(way) / length;
    list.polyline(Role::Accent3, Look::Thin, &[a, b]);
    for end in [a, b] {
        let stroke = across * (1.5 * unit);
        list.polyline(Role::Accent3, Look::Thin, &[end - stroke, end + stroke]);
    }
    let off = [2.6 * across.x, across.y];
    list.name(Role::Accent3, name, a + way * 0.5, off);
}

/// Draws the angle at the second of three points: its legs, an arc, and its name with its value.
pub(crate) fn corner(list: &mut List, points: [Point; 3], name: usize, unit: f64) {
    list.polyline(Role::Accent4, Look::Thin, &points);
    corner_arc(list, points, 11.0 * unit, (name, OFF[0]));
}

/// Draws the angle between two sides that are already drawn, with its symbol, even if the sides are short.
pub(crate) fn side_angle(list: &mut List, points: [Point; 3], name: usize, unit: f64) {
    let [a, b, c] = points;
    let shorter = (a - b).norm().min((c - b).norm());
    corner_arc(
        list,
        points,
        (8.0 * unit).min(0.4 * shorter),
        (name, OFF[1]),
    );
}

fn corner_arc(list: &mut List, [a, b, c]: [Point; 3], radius: f64, name: (usize, f64)) {
    let direction = |to: Point| (to.y - b.y).atan2(to.x - b.x);
    let from = direction(a);
    let turn = direction(c) - from;
    let turn = turn - TAU * (turn / TAU).round();
    let look = (Role::Accent4, Look::Thin);
    arc(list, look, b, radius, [from, turn], name);
}

/// Draws the angle between two links about a given centre: a line in the direction of each link, and an arrow along an
/// arc from the first direction to the second, with the name at its middle.
pub(crate) fn between(list: &mut List, centre: Point, [a, b]: [f64; 2], name: usize, unit: f64) {
    let role = Role::Accent4;
    let radius = 11.0 * unit;
    let at = |angle: f64, radius: f64| centre + Vector::new(angle.cos(), angle.sin()) * radius;
    let legs = [at(a, 1.3 * radius), centre, at(b, 1.3 * radius)];
    list.polyline(role, Look::Thin, &legs);
    // Whole turns of the angle are not drawn.
    let turn = (b - a) % TAU;
    let look = (role, Look::Thin);
    arc(list, look, centre, radius, [a, turn], (name, OFF[0]));
    let head = parts::HEAD * unit / radius;
    if turn.abs() > head {
        let neck = at(a + turn - head.copysign(turn), radius);
        parts::head(list, role, neck, at(a + turn, radius));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::Jet;

    #[test]
    fn distances_are_drawn_across() {
        let mut list = List::default();
        let (a, b) = (Point::new(1.0, 1.0), Point::new(5.0, 1.0));
        distance(&mut list, [a, a], 7, 0.1);
        assert!(list.numbers().is_empty());
        distance(&mut list, [a, b], 7, 0.1);
        let (role, thin) = (f32::from(Role::Accent3 as u8), f32::from(Look::Thin as u8));
        let line = |points: [f32; 4]| [[2.0, role, thin, 2.0].as_slice(), &points].concat();
        let expected = [
            line([1.0, 1.0, 5.0, 1.0]),
            line([1.0, 0.85, 1.0, 1.15]),
            line([5.0, 0.85, 5.0, 1.15]),
            vec![4.0, role, 7.0, 3.0, 1.0, 0.0, 1.0],
        ];
        assert_eq!(list.numbers(), expected.concat());
    }

    #[test]
    fn corners_are_within_half_a_turn() {
        let [a, b, c] = [[0.0, -1.0], [0.0, 0.0], [-1.0, 1.0]].map(Point::from);
        for legs in [[a, b, c], [c, b, a]] {
            let mut list = List::default();
            corner(&mut list, legs, 7, 0.01);
            // After the record of the legs come the head of the arc's record, its 25 points, and the name.
            let arc = &list.numbers()[4 + 6 + 4..][..50];
            for at in arc.chunks(2) {
                let (x, y) = (f64::from(at[0]), f64::from(at[1]));
                assert!((x.hypot(y) - 0.11).abs() < 1e-6, "{x} {y}");
                assert!(x < 1e-6, "{x} {y}");
            }
        }
    }

    /// The name of a vector is on its left. The name of an angle is between the sides of the angle, nearer to the
    /// vertex than the end of the shorter side is.
    #[test]
    fn names_of_vectors_and_of_their_angles() {
        let mut list = List::default();
        let [a, b, c] = [[4.0, 0.0], [0.0, 0.0], [3.0, 4.0]].map(Point::from);
        loop_vector(&mut list, [b, c], 7, 0.1);
        let name = &list.numbers()[list.numbers().len() - 7..];
        let [x, y, dx, dy] = [name[3], name[4], name[5], name[6]].map(f64::from);
        assert!((4.0 * x - 3.0 * y).abs() < 1e-5 && 3.0 * dy - 4.0 * dx > 0.0);
        assert!((x.hypot(y) - 0.26 * 5.0).abs() < 1e-5);
        for (unit, radius) in [(0.1, 0.8), (1.0, 1.6)] {
            let mut list = List::default();
            side_angle(&mut list, [a, b, c], 7, unit);
            let name = &list.numbers()[list.numbers().len() - 7..];
            let [x, y] = [name[3], name[4]].map(f64::from);
            assert!((x.hypot(y) - radius).abs() < 1e-5);
            let middle = 0.5 * 4.0_f64.atan2(3.0);
            assert!((y.atan2(x) - middle).abs() < 1e-5);
        }
    }

    /// The arrow of an angle between links goes from the first direction to the second in the sense of the angle, even
    /// if that is the longer way round. Whole turns are not drawn.
    #[test]
    fn angles_of_links_keep_their_sense() {
        for (angles, tip) in [
            ([0.5, 4.5], 4.5),
            ([4.5, 0.5], 0.5),
            ([0.5, 0.7 + 4.0 * TAU], 0.7),
        ] {
            let mut list = List::default();
            between(&mut list, Point::origin(), angles, 7, 0.01);
            // After the record of the legs come the head of the arc's record and its 25 points.
            let arc = &list.numbers()[4 + 6 + 4..][..50];
            let at = |k: usize| {
                let [x, y] = [arc[2 * k], arc[2 * k + 1]].map(f64::from);
                assert!((x.hypot(y) - 0.11).abs() < 1e-6, "{x} {y}");
                y.atan2(x)
            };
            let off = |a: f64, b: f64| (a - b - TAU * ((a - b) / TAU).round()).abs();
            assert!(off(at(0), angles[0]) < 1e-5 && off(at(24), tip) < 1e-5);
            let step = (at(1) - at(0) + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
            assert_eq!(step > 0.0, angles[1] > angles[0], "{angles:?}");
        }
    }

    #[test]
    fn scales_are_finite_and_positive() {
        let moving = |speed: f64| JetPoint {
            x: Jet::linear(0.0, speed),
            y: Jet::constant(0.0),
        };
        let slow: Vec<JetPoint<3>> = (0..100).map(|_| moving(0.5)).collect();
        let wild = (0..100).map(|k| moving(if k < 91 { 2.0 } else { 1e300 }));
        let paths = [slow, wild.collect()];
        let Scales([first, second]) = Scales::of(&paths, 10.0);
        assert!(
            (first * 2.0 - Scales::DRAWN_LENGTH * 10.0).abs() < 1e-12,
            "{first}"
        );
        assert!(second.is_finite() && second > 0.0);
        for paths in [Vec::new(), vec![Vec::new()], vec![vec![moving(0.0)]]] {
            let Scales(scales) = Scales::of(&paths, 10.0);
            assert!(scales.iter().all(|scale| scale.is_finite() && *scale > 0.0));
        }
    }
}
