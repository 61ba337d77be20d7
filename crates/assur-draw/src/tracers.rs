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
/// made of exact poses, crowded towards dead points.
pub(crate) fn path(mixer: &Mixer, tracer: &Tracer) -> Vec<Vec<Point>> {
    let cycle = mixer.linkage.cycle();
    let swings = |ratio: f64| -> Vec<[f64; 2]> {
        let swings = mixer.linkage.swings(mixer.assembly).into_iter();
        swings.map(|swing| reach(swing.scaled(ratio))).collect()
    };
    match tracer.carrier {
        Carrier::Crank => {
            let arcs = cycle.arcs().iter();
            circle(
                Point::origin(),
                tracer,
                arcs.map(|[from, to]| [*from, to.min(from + TAU)]),
            )
        }
        Carrier::Rocker => circle(d(mixer), tracer, swings(1.0).into_iter()),
        Carrier::Wheel(index) => {
            let Some(pair) = mixer.gears.pairs().get(index) else {
                return Vec::new();
            };
            let wheel = pair.driven_wheel();
            let turned = |[from, to]: [f64; 2]| [from + wheel.mounting, to + wheel.mounting];
            let arcs = swings(wheel.ratio).into_iter().map(turned);
            circle(d(mixer) + wheel.centre, tracer, arcs)
        }
        Carrier::Coupler => {
            let mut runs = vec![Vec::new()];
            for [from, to] in cycle.arcs() {
                let count = steps(to - from);
                for i in 0..=count {
                    let t = i as f64 / count as f64;
                    let t = if cycle.is_full() {
                        t
                    } else {
                        0.5 - 0.5 * (PI * t).cos()
                    };
                    // At an angle without a pose the curve is interrupted.
                    let crank = from + (to - from) * t;
                    match (
                        mixer.linkage.pose::<1>(mixer.assembly, crank),
                        runs.last_mut(),
                    ) {
                        (Ok(pose), Some(run)) => run.push(mixer.traced(&pose, tracer).place()),
                        _ => runs.push(Vec::new()),
                    }
                }
                runs.push(Vec::new());
            }
            runs.retain(|run| run.len() > 1);
            runs
        }
    }
}

/// Marks a point in the coordinates of its body.
pub(crate) fn mark(list: &mut List, role: Role, label: Label, at: Point, unit: f64) {
    list.circle(role, Look::Hollow, at, 1.1 * unit);
    list.circle(role, Look::Solid, at, 0.5 * unit);
    list.label(Role::Ink, label, at, [1.2, 0.9]);
}

fn d(mixer: &Mixer) -> Point {
    let [.., l4] = mixer.linkage.lengths();
    Point::new(l4, 0.0)
}

/// What is passed of a circle: no more than all of it.
fn reach(swing: Swing) -> [f64; 2] {
    match swing {
        Swing::Turns => [0.0, TAU],
        Swing::Between { min, max } => [min, max.min(min + TAU)],
    }
}

fn steps(turned: f64) -> usize {
    (SAMPLES * turned / TAU).ceil().max(90.0) as usize
}

/// Arcs about a place, of a point on a body that turns through them.
fn circle(centre: Point, tracer: &Tracer, arcs: impl Iterator<Item = [f64; 2]>) -> Vec<Vec<Point>> {
    let arc = |[from, to]: [f64; 2]| {
        let count = steps(to - from);
        let place = |i: usize| {
            let (sin, cos) = (from + (to - from) * i as f64 / count as f64).sin_cos();
            let along = Vector::new(cos, sin) * tracer.x;
            centre + along + Vector::new(-sin, cos) * tracer.y
        };
        (0..=count).map(place).collect()
    };
    arcs.map(arc).collect()
}
