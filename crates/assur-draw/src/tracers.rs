//! Traced points: their paths over the cycle and their marks.

use std::f64::consts::{PI, TAU};

use assur::catalog::mixer::{Carrier, Mixer, Tracer};
use assur::{Point, Swing, Vector};

use crate::list::{Label, List, Look, Role};

/// The names of the points.
pub(crate) const LABELS: [Label; Tracer::MOST] = [
    Label::P1,
    Label::P2,
    Label::P3,
    Label::P4,
    Label::P5,
    Label::P6,
];

/// Places on a path for a turn of what carries it.
const SAMPLES: f64 = 720.0;

/// The path of a point, each part drawn once. On what turns about a fixed place
/// it is a circle, or as much of it as the body turns through; a coupler curve is
/// made of exact poses.
pub(crate) fn path(mixer: &Mixer, tracer: &Tracer) -> Vec<Vec<Point>> {
    let [.., l4] = mixer.linkage.lengths();
    let d = Point::new(l4, 0.0);
    match tracer.carrier {
        Carrier::Coupler => coupler_curve(mixer, tracer),
        Carrier::Crank => circle(Point::origin(), tracer, mixer.linkage.cycle().arcs()),
        Carrier::Rocker => circle(d, tracer, &turned(mixer, 1.0, 0.0)),
        Carrier::Wheel(index) => match mixer.gears.pairs().get(index) {
            Some(pair) => {
                let wheel = pair.driven_wheel();
                let arcs = turned(mixer, wheel.ratio, wheel.mounting);
                circle(d + wheel.centre, tracer, &arcs)
            }
            None => Vec::new(),
        },
    }
}

/// A coupler curve over the cycle, crowded towards dead points.
fn coupler_curve(mixer: &Mixer, tracer: &Tracer) -> Vec<Vec<Point>> {
    let cycle = mixer.linkage.cycle();
    let mut runs = Vec::new();
    for [from, to] in cycle.arcs() {
        let count = steps(to - from);
        let mut run = Vec::new();
        for i in 0..=count {
            let t = i as f64 / count as f64;
            let t = if cycle.is_full() {
                t
            } else {
                0.5 - 0.5 * (PI * t).cos()
            };
            let pose = mixer.linkage.pose(mixer.assembly, from + (to - from) * t);
            match pose {
                Ok(pose) => run.push(mixer.traced::<1>(&pose, tracer).place()),
                // At an angle without a pose the curve is interrupted.
                Err(_) => runs.push(std::mem::take(&mut run)),
            }
        }
        runs.push(run);
    }
    runs.retain(|run| run.len() > 1);
    runs
}

/// Marks a point in the coordinates of its body.
pub(crate) fn mark(list: &mut List, role: Role, label: Label, at: Point, unit: f64) {
    list.circle(role, Look::Hollow, at, 1.1 * unit);
    list.circle(role, Look::Solid, at, 0.5 * unit);
    list.label(Role::Ink, label, at, [1.2, 0.9]);
}

/// The angles of what turns `ratio` times as far as the rocker, on each arc of
/// the cycle.
fn turned(mixer: &Mixer, ratio: f64, mounting: f64) -> Vec<[f64; 2]> {
    let swings = mixer.linkage.swings(mixer.assembly).into_iter();
    swings
        .map(|swing| match swing.scaled(ratio) {
            Swing::Turns => [0.0, TAU],
            Swing::Between { min, max } => [min + mounting, max + mounting],
        })
        .collect()
}

fn steps(turned: f64) -> usize {
    (SAMPLES * turned / TAU).ceil().max(90.0) as usize
}

/// Arcs about a place, of a point on a body that turns through them: no more than
/// a circle of each.
fn circle(centre: Point, tracer: &Tracer, arcs: &[[f64; 2]]) -> Vec<Vec<Point>> {
    let arc = |[from, to]: &[f64; 2]| {
        let turned = (to - from).min(TAU);
        let count = steps(turned);
        let place = |i: usize| {
            let (sin, cos) = (from + turned * i as f64 / count as f64).sin_cos();
            let along = Vector::new(cos, sin) * tracer.x;
            centre + along + Vector::new(-sin, cos) * tracer.y
        };
        (0..=count).map(place).collect()
    };
    arcs.iter().map(arc).collect()
}
