//! Paths of points over a motion.

use std::f64::consts::TAU;

use assur::mechanism::{LinkId, PointId, Pose};
use assur::motion::{Motion, Sampling, Shown, Spacing};
use assur::{Point, Vector};

use super::layout::Layout;
use crate::list::{List, Look, Role};

/// Number of poses per turn of a crank that turns fully; also number of points on an arc per turn of the link that
/// carries the point. A path deviates from its chords by less than 1/30 of a pixel if its second derivative with
/// respect to the angle is at most 1000 pixels.
const TURN: usize = 432;
/// Number of poses of an oscillating motion: per turn of the crank, or per arc that is shorter than a turn.
const SWING: usize = 360;
/// Minimum number of points on an arc.
const MIN_POINTS: f64 = 90.0;
/// Maximum number of computed body positions, over all poses. Paths over many turns cover each other: they are sampled
/// more coarsely and, if that is not enough, only the first turns are drawn.
const MAX_PLACED: usize = 150_000;
/// Fixed cost of computing a pose, expressed as the number of body positions that cost as much.
const OF_A_POSE: usize = 8;
/// Minimum number of poses per turn.
const COARSEST_TURN: usize = 60;
/// Rotation from which a link counts as turning fully. It is less than a turn, because the first and the last pose may
/// be missing.
const ALL_ROUND: f64 = TAU * (1.0 - 3.0 / TURN as f64);
/// Inset of samples from the ends of an arc, relative to the arc. At the ends, points may coincide, and angles may be
/// rounding errors.
pub(super) const OFF: f64 = 1e-9;
/// Number of Newton steps towards the input at which a link turns back; each step doubles the number of correct digits.
const STEPS: usize = 4;

/// Poses over an unbroken stretch of the motion, each with its input.
pub(super) type Run = Vec<(f64, Pose<1>)>;

/// A part of a path.
#[derive(Clone, Debug)]
pub(super) enum Path {
    /// A circle with centre and radius.
    Circle(Point, f64),
    Line(Vec<Point>),
}

impl Path {
    pub(super) fn draw(&self, list: &mut List, role: Role) {
        match self {
            Self::Circle(centre, radius) => list.circle(role, Look::Dashed, *centre, *radius),
            Self::Line(places) => list.polyline(role, Look::Dashed, places),
        }
    }

    /// Returns points with the same bounds as the path.
    pub(super) fn reach(&self) -> Vec<Point> {
        match self {
            Self::Circle(centre, radius) => {
                let corner = Vector::repeat(*radius);
                vec![centre - corner, centre + corner]
            }
            Self::Line(places) => places.clone(),
        }
    }
}

/// Returns the poses over the motion, one run for each arc, with closer samples near dead points.
pub(super) fn sampled(motion: &Motion) -> Vec<Run> {
    let cycle = motion.cycle();
    let sampling = Sampling {
        turn: if cycle.is_full() { TURN } else { SWING },
        coarsest: COARSEST_TURN,
        most: MAX_PLACED / (motion.mechanism().links().len() + OF_A_POSE),
        spacing: Spacing::Crowded,
        shown: Shown::First,
    };
    let pieces = motion.samples(sampling).into_iter();
    let runs = pieces.zip(cycle.arcs()).map(|(inputs, [from, to])| {
        let off = if cycle.is_full() { 0.0 } else { OFF };
        let [first, last] = [from + off * (to - from), to - off * (to - from)];
        let inputs = inputs.into_iter().map(|input| input.clamp(first, last));
        let pose = motion.telling(|pose: &Pose<1>| pose.bodies());
        let mut run = Run::with_capacity(inputs.len());
        run.extend(inputs.filter_map(|input| Some((input, pose(input).ok()?))));
        run
    });
    runs.filter(|run: &Run| !run.is_empty()).collect()
}

/// Returns the path of a point. If the point turns about a fixed point, the path is a circle, or an arc for each run.
pub(super) fn path(motion: &Motion, layout: &Layout, runs: &[Run], point: PointId) -> Vec<Path> {
    let mechanism = motion.mechanism();
    let Some((link, pivot)) = layout.pivot(point) else {
        let places = |run: &Run| {
            let places = run.iter();
            let places = places.map(|(_, pose)| mechanism.place(pose, point).place());
            Path::Line(places.collect())
        };
        return runs.iter().map(places).collect();
    };
    let mut paths = Vec::new();
    for run in runs {
        let Some((_, pose)) = run.first() else {
            continue;
        };
        let centre = mechanism.place(pose, pivot).place();
        let arm = mechanism.place(pose, point).place() - centre;
        let [low, high] = turned(motion, run, link);
        if high - low >= ALL_ROUND {
            paths.push(Path::Circle(centre, arm.norm()));
            break;
        }
        // Angle of the arm, the line from the pivot to the point, less the angle of the link.
        let lead = arm.y.atan2(arm.x) - mechanism.angle(pose, link).value();
        let count = (TURN as f64 * (high - low) / TAU).ceil().max(MIN_POINTS);
        let place = |i: usize| {
            let (sin, cos) = (lead + low + (high - low) * i as f64 / count).sin_cos();
            centre + Vector::new(cos, sin) * arm.norm()
        };
        paths.push(Path::Line((0..=count as usize).map(place).collect()));
    }
    paths
}

/// Returns the range of a link's angle in a run.
fn turned(motion: &Motion, run: &Run, link: LinkId) -> [f64; 2] {
    let mechanism = motion.mechanism();
    let angle = |pose: &Pose<1>| mechanism.angle(pose, link).value();
    let angles: Vec<f64> = run.iter().map(|(_, pose)| angle(pose)).collect();
    let extreme = |sign: f64| {
        let all = angles.iter().enumerate();
        let (most, found) = all.fold((0, f64::NEG_INFINITY), |best, (k, angle)| {
            if sign * angle > best.1 {
                (k, sign * angle)
            } else {
                best
            }
        });
        let near = |k: usize| run.get(k).map(|(input, _)| *input);
        let bracket = most.checked_sub(1).and_then(near).zip(near(most + 1));
        let exact = bracket.and_then(|bracket| turning(motion, link, run[most].0, bracket));
        exact.map_or(sign * found, |exact| sign * (sign * exact).max(found))
    };
    [extreme(-1.0), extreme(1.0)]
}

/// Finds the angle at which a link turns back near an input, by Newton's method.
fn turning(motion: &Motion, link: LinkId, near: f64, (from, to): (f64, f64)) -> Option<f64> {
    let angle = motion.telling(|pose: &Pose<3>| motion.mechanism().angle(pose, link));
    let mut input = near;
    for _ in 0..STEPS {
        let angle = angle(input).ok()?;
        let step = angle.derivative(1) / angle.derivative(2);
        if !step.is_finite() {
            break;
        }
        input = (input - step).clamp(from, to);
    }
    angle(input).ok().map(|angle| angle.value())
}
