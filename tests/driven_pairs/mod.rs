//! Drivers between two moving links: robot arms, hydraulic cylinders, platforms.

mod arms;
mod catalogue;
mod changes;
mod cylinders;
mod excavators;

use std::f64::consts::TAU;

use assur::Vector;
use assur::mechanism::{DriverSpec, LinkageSpec, Mechanism};
use assur::motion::Motion;

/// With a driver: a link that is turned against another one.
pub(crate) fn turned(mut draft: LinkageSpec, link: &str, base: &str, rate: f64) -> LinkageSpec {
    draft.drivers.push(DriverSpec::Crank {
        link: link.to_owned(),
        base: base.to_owned(),
        rate,
    });
    draft
}

/// With a driver: a slide over a range.
pub(crate) fn moved(
    mut draft: LinkageSpec,
    slide: usize,
    range: [f64; 2],
    rate: f64,
) -> LinkageSpec {
    draft.drivers.push(DriverSpec::Slide { slide, range, rate });
    draft
}

pub(crate) fn motion(draft: &LinkageSpec) -> Motion {
    Motion::new(Mechanism::new(draft).unwrap())
}

pub(crate) fn along(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// Less whole turns.
pub(crate) fn reduced(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// An angle and its derivatives by the input.
pub(crate) fn angle(motion: &Motion, link: &str, input: f64) -> [f64; 3] {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(input).unwrap();
    let angle = mechanism.angle(&pose, mechanism.link(link).unwrap());
    [0, 1, 2].map(|order| angle.derivative(order))
}

pub(crate) fn place(motion: &Motion, point: &str, input: f64) -> [Vector; 3] {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(input).unwrap();
    let place = mechanism.place(&pose, mechanism.point(point).unwrap());
    [
        place.place().coords,
        place.derivative(1),
        place.derivative(2),
    ]
}

pub(crate) fn assert_angle(found: [f64; 3], exact: [f64; 3], within: f64, what: &str) {
    let off = reduced(found[0] - exact[0]).abs();
    assert!(off < within, "{what}: {found:?} {exact:?}");
    for order in 1..3 {
        let off = (found[order] - exact[order]).abs();
        assert!(
            off < within * (1.0 + exact[order].abs()),
            "{what}: {found:?} {exact:?}"
        );
    }
}

/// The derivatives of every point are those that differences of its places show.
pub(crate) fn assert_smooth(motion: &Motion, input: f64, h: f64) {
    let mechanism = motion.mechanism();
    for point in mechanism.points() {
        let at = |k: f64| place(motion, point, input + k * h)[0];
        let [_, first, second] = place(motion, point, input);
        let one = (at(-2.0) - at(2.0) + (at(1.0) - at(-1.0)) * 8.0) / (12.0 * h);
        let two =
            ((at(1.0) + at(-1.0)) * 16.0 - at(2.0) - at(-2.0) - at(0.0) * 30.0) / (12.0 * h * h);
        let scale = mechanism.size() + first.norm() + second.norm();
        assert!(
            (one - first).norm() < 1e-8 * scale,
            "{point} {input}: {one} {first}"
        );
        assert!(
            (two - second).norm() < 1e-5 * scale,
            "{point} {input}: {two} {second}"
        );
    }
}

/// Where the point of a slide is from the start of its line: along the line and to the left of it.
pub(crate) fn on_line(motion: &Motion, [from, to, point]: [&str; 3], input: f64) -> [f64; 2] {
    let [from, to, point] = [from, to, point].map(|name| place(motion, name, input)[0]);
    let along = (to - from).normalize();
    [along.dot(&(point - from)), along.perp(&(point - from))]
}
