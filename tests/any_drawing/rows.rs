//! Properties of the rows of one motion: the row at the drawn input is the drawing, every row fulfils the equations of
//! the linkage, neighbouring rows follow from each other, and the motion ends only in singular poses.

use std::f64::consts::TAU;
use std::iter::successors;

use assur::mechanism::Pose;
use assur::motion::{Column, DeadPointKind};

use super::equations::modulo_turn;
use super::found::Tally;
use super::shown::Shown;
use super::subject::{Known, Subject, determined, uncertainty};
use super::way::{condition, way};
use crate::properties::random::Random;

/// What links, slides and gears may leave of their equations, relative to the size, and of their
/// derivatives, relative to their scale.
const RESIDUAL: f64 = 1e-12;
/// A step along the motion in radii of convergence of its Taylor series.
const STEP: f64 = 0.1;
/// What is rounded of a row, relative to the size, where that does not grow.
const ROUNDED: f64 = 2e-13;
/// Steps along each motion, at most.
const STEPS: usize = 1_500;
/// So close to an end, or to a change point, relative to the range, nothing is followed.
const MARGIN: f64 = 1e-6;
/// The determinant is looked at after so many steps.
const LOOKS: usize = 16;
/// At a dead point errors grow at least so much: there, to half of the digits, it is singular.
const SINGULAR: f64 = 1e4;

pub(crate) fn hold(subject: &Subject, seed: u64, tally: &mut Tally) {
    let mut random = Random::new(82_000_000 + seed);
    let before = tally.failures.len();
    drawn(subject, tally);
    given_up(subject, tally);
    equations(subject, tally);
    ends(subject, tally);
    repeats(subject, tally);
    joined(subject, &mut random, tally);
    tally.held += u64::from(tally.failures.len() == before);
}

/// The row at the drawn input is the drawing.
fn drawn(subject: &Subject, tally: &mut Tally) {
    let (motion, equations) = (&subject.motion, &subject.equations);
    let drawn = equations.drawn_input();
    let home = motion.drawn_input();
    let off = match motion.mechanism().turns() {
        true => modulo_turn(home - drawn).abs(),
        false => (home - drawn).abs() / equations.size(),
    };
    // An input of many turns is a number with fewer digits behind the point.
    let error = uncertainty(1.0, equations.shortest(), 1.0) + f64::EPSILON * home.abs();
    // Of a drawing in a singular pose the engine may take another one.
    if !determined(equations.condition(&equations.drawn()), error) {
        return tally.open("drawn pose");
    }
    if off > 8.0 * error {
        let text = format!("home is {home}, drawn at {drawn}");
        return tally.fail("drawn input", text, None);
    }
    // As the motion counts it, and as it is drawn, where whole turns do not count; the end of a slide's range may be off
    // by rounding.
    let [from, to] = motion.cycle().arcs()[0];
    let period = motion.cycle().period();
    let is_counted = motion.mechanism().turns() && period.is_none_or(|period| to - from <= period);
    // An arc may end at the drawn pose, and the drawn input lie beyond its end by rounding.
    let near = |end: &f64| (drawn - end).abs() <= 8.0 * error;
    let within = [from, to].into_iter().find(near).unwrap_or(drawn);
    let as_drawn = is_counted.then_some(within);
    for input in [Some(home), as_drawn].into_iter().flatten() {
        let Ok(pose) = motion.pose::<1>(input) else {
            let text = format!("none at {input}, home is {home}");
            return tally.fail("drawn pose", text, None);
        };
        let shown = Shown::of(motion.mechanism(), &pose);
        let condition = equations.condition(&shown);
        let allowed = 8.0 * error * condition.pose.max(1.0) * equations.size();
        for (point, at) in subject.draft.points.iter().zip(&shown.points) {
            let off = (point.at.coords - at[0]).norm();
            if off.is_nan() || off > allowed {
                let text = format!("{} off by {off:e}, allowed {allowed:e}", point.name);
                return tally.fail("drawn row", text, None);
            }
        }
    }
}

/// Where a motion is given up there is no row beyond; but that the angle of a crank whose single turns do not count tells
/// its pose.
fn given_up(subject: &Subject, tally: &mut Tally) {
    let motion = &subject.motion;
    let [from, to] = motion.cycle().arcs()[0];
    let columns = Column::all(motion.mechanism());
    let turns = motion.cycle().period();
    for (end, sense) in [(from, -1.0), (to, 1.0)] {
        let mut ends = motion.dead_points().iter();
        if !ends.any(|dead| dead.input == end && dead.kind.is_given_up()) {
            continue;
        }
        for beyond in [1e-9 * (to - from), 0.3, 1.0, TAU, 12.0 * TAU, to - from] {
            let input = end + sense * beyond;
            let row = motion.row(&columns, input);
            let inside = |turns: f64| {
                let wrapped = from + (input - from).rem_euclid(turns);
                turns == TAU && to - from <= TAU && wrapped <= to + 1e-9
            };
            let is_told = row.values.iter().any(Option::is_some) || row.reason.is_none();
            if is_told && !turns.is_some_and(inside) {
                let text = format!("at {input}, followed from {from} to {to}");
                return tally.fail("row beyond what is followed", text, None);
            }
        }
    }
}

/// Rows fulfil the equations.
fn equations(subject: &Subject, tally: &mut Tally) {
    let motion = &subject.motion;
    let Ok(home) = motion.pose::<3>(motion.drawn_input()) else {
        return tally.open("derivatives at home");
    };
    let home = Shown::of(motion.mechanism(), &home);
    for Known { input, shown, .. } in &subject.poses {
        let found = subject.equations.residuals(*input, shown, &home);
        let rounded = 4.0 * f64::EPSILON * shown.largest_angle();
        for (of, orders) in ["links", "slides", "gears", "driver"].iter().zip(found) {
            for (order, off) in orders.into_iter().enumerate() {
                if off.is_nan() || off > RESIDUAL + rounded {
                    let kind = match *of {
                        "links" => "residual of links",
                        "slides" => "residual of slides",
                        "gears" => "residual of gears",
                        _ => "residual of the driver",
                    };
                    let text = format!("at {input}: order {order} leaves {off:e}");
                    return tally.fail(kind, text, None);
                }
            }
        }
    }
}

/// A motion ends where something is singular, and has a pose there.
fn ends(subject: &Subject, tally: &mut Tally) {
    let motion = &subject.motion;
    for dead in motion.dead_points() {
        let Ok(pose) = motion.pose::<1>(dead.input) else {
            return tally.fail("no pose at an end", format!("{dead:?}"), None);
        };
        if dead.kind == DeadPointKind::Range {
            continue;
        }
        if !dead.kind.is_dead_point() {
            tally.open(dead.kind.code());
            continue;
        }
        let shown = Shown::of(motion.mechanism(), &pose);
        let condition = subject.equations.condition(&shown);
        if condition.pose < SINGULAR {
            let text = format!("{dead:?}: errors grow by {} only", condition.pose);
            return tally.fail("false dead point", text, None);
        }
    }
}

/// A motion that repeats is after its period where it was at its beginning, all wheels included.
fn repeats(subject: &Subject, tally: &mut Tally) {
    let (motion, equations) = (&subject.motion, &subject.equations);
    let cycle = motion.cycle();
    if !cycle.is_full() {
        return;
    }
    let poses = cycle.arcs()[0].map(|end| motion.pose::<1>(end));
    let [Ok(start), Ok(end)] = poses else {
        return tally.open("where it repeats");
    };
    let [start, end] = [start, end].map(|pose| Shown::of(motion.mechanism(), &pose));
    let condition = equations.condition(&start);
    let turns = cycle.arcs()[0][1];
    let error = uncertainty(1.0, equations.shortest(), 1.0) * turns.max(1.0);
    if !determined(condition, error) {
        return tally.open("where it repeats");
    }
    let moved = start.points.iter().zip(&end.points);
    let moved = moved.map(|(a, b)| (a[0] - b[0]).norm() / equations.size());
    let turned = start.angles.iter().zip(&end.angles);
    let turned = turned.map(|(a, b)| modulo_turn(a[0] - b[0]).abs());
    let off = moved.chain(turned).fold(0.0, f64::max);
    if off > 8.0 * error * condition.pose.max(1.0) {
        let text = format!("after {turns} all is {off:e} elsewhere");
        tally.fail("does not repeat", text, None);
    }
}

/// A row with five derivatives.
struct Row {
    input: f64,
    values: Vec<[f64; 6]>,
    /// The inverse of a radius of convergence, by the derivatives.
    rate: f64,
    shown: Shown,
}

impl Row {
    fn at(subject: &Subject, input: f64) -> Option<Self> {
        let motion = &subject.motion;
        let mechanism = motion.mechanism();
        let pose: Pose<6> = motion.pose(input).ok()?;
        let shown = Shown::of(mechanism, &pose);
        let [reach, ..] = shown.scales(subject.equations.size());
        let points = mechanism.point_ids().flat_map(|point| {
            let at = mechanism.place(&pose, point);
            [at.x, at.y]
        });
        let orders = [0, 1, 2, 3, 4, 5];
        let points = points.map(|jet| orders.map(|order| jet.derivative(order)));
        // Angles as arcs of the size.
        let angles = mechanism.link_ids().map(|link| {
            let angle = mechanism.angle(&pose, link);
            orders.map(|order| angle.derivative(order) * reach)
        });
        let values: Vec<[f64; 6]> = points.chain(angles).collect();
        let mut rate = 0.0_f64;
        for value in &values {
            let mut factorial = 1.0;
            for (order, derivative) in value.iter().enumerate().skip(1) {
                factorial *= order as f64;
                let radius = (derivative.abs() / factorial / reach).powf(1.0 / order as f64);
                rate = rate.max(radius);
            }
        }
        rate.is_finite().then_some(Self {
            input,
            values,
            rate,
            shown,
        })
    }
}

/// Whether a motion goes through a pose that is singular itself, as that of a deltoid where its crank
/// lies on the frame: there its determinant changes its sign, and nothing leaps.
fn is_crossed(subject: &Subject, inputs: [f64; 2]) -> bool {
    let at = |input: f64| condition(&subject.motion, &subject.equations, input);
    way(
        at,
        inputs,
        uncertainty(1.0, subject.equations.shortest(), 1.0),
    )
    .open
}

/// From one end to the other each row follows from the one before by the formula of Hermite of fifth
/// order, and no group passes a singular pose but at the change points that are told.
fn joined(subject: &Subject, random: &mut Random, tally: &mut Tally) {
    let motion = &subject.motion;
    let [from, to] = motion.cycle().arcs()[0];
    // Of a range that is next to nothing not so close: rounding leaves no derivatives there.
    let whole = if motion.mechanism().turns() {
        1.0
    } else {
        subject.equations.size()
    };
    let margin = MARGIN * (to - from).max(0.01 * whole);
    if 2.0 * margin >= to - from {
        return tally.open("range too short to follow");
    }
    let mut start = from + margin;
    // Of a motion of many turns a part.
    if to - from > 13.0 {
        start += random.within(0.0, to - from - 13.0);
    }
    let change = |a: f64, b: f64| {
        let mut change_points = motion.change_points().iter();
        change_points.find(|at| (a - 1e3 * margin..=b + 1e3 * margin).contains(*at))
    };
    let mut here = Row::at(subject, start);
    let mut sign = None;
    for step in 0..STEPS {
        let Some(row) = &here else {
            return tally.fail("no row", format!("after {start}"), None);
        };
        if step % LOOKS == 0 {
            let now = subject.equations.condition(&row.shown).sign;
            if let Some((before, at)) = sign
                && before != now
                && change(at, row.input).is_none()
                && !is_crossed(subject, [at, row.input])
            {
                let text = format!("between {at} and {}", row.input);
                return tally.fail("passed a singular pose", text, None);
            }
            sign = Some((now, row.input));
        }
        let mut width = (STEP / row.rate).min((to - from) / 36.0);
        let next = loop {
            if row.input + width > to - margin {
                return;
            }
            if let Some(at) = change(row.input, row.input + width) {
                // Beyond it.
                let beyond = at + 2e3 * margin;
                if beyond > to - margin {
                    return;
                }
                break Row::at(subject, beyond);
            }
            let next = Row::at(subject, row.input + width);
            let mut met = "no row that is smooth".to_owned();
            if let Some(next) = next
                && next.rate * width < 2.0 * STEP
            {
                match leap(subject, row, &next) {
                    None => break Some(next),
                    Some(off) => met = off,
                }
            }
            // Two branches that nearly meet look smooth until one is close: then shorter steps follow.
            width *= 0.5;
            if width < 1e-3 * margin {
                if !is_determined(subject, row) {
                    tally.open("row beside a fold");
                    let beyond = determined_after(subject, row.input, margin, to - margin);
                    let Some(beyond) = beyond else { return };
                    break Row::at(subject, beyond);
                }
                let text = format!("beyond {} of {from} to {to}: {met}", row.input);
                return tally.fail("rows do not follow", text, None);
            }
        };
        start = row.input;
        here = next;
    }
}

/// Whether a row is determined to first order. Beside a fold that is just avoided it is not: two branches nearly meet, and
/// rounding errors move the pose as far as its Taylor series converges.
fn is_determined(subject: &Subject, row: &Row) -> bool {
    let error = uncertainty(1.0, subject.equations.shortest(), 1.0);
    determined(subject.equations.condition(&row.shown), error)
}

/// The first input before `end` at which a row is determined again or missing, at distances that double.
fn determined_after(subject: &Subject, input: f64, first: f64, end: f64) -> Option<f64> {
    let widths = successors(Some(first), |width| Some(2.0 * width));
    let mut inputs = widths.map(|width| input + width);
    let found = inputs.find(|input| {
        *input >= end || Row::at(subject, *input).is_none_or(|row| is_determined(subject, &row))
    });
    found.filter(|input| *input < end)
}

/// What does not follow, and by how much.
fn leap(subject: &Subject, a: &Row, b: &Row) -> Option<String> {
    let width = b.input - a.input;
    let [reach, ..] = b.shown.scales(subject.equations.size());
    let mut fifth = 0.0_f64;
    for value in a.values.iter().chain(&b.values) {
        fifth = fifth.max(value[5].abs());
    }
    // The remainder of the formula, with room for the change of the fifth derivative in a step of
    // a fifth of the radius of convergence; and rounding, which grows close to a singular pose.
    let remainder = 16.0 * fifth * width.powi(5).abs() / 720.0;
    let rounded = |grown: f64| ROUNDED * reach * (grown + STEP * grown * grown);
    let mut worst = (0.0, 0);
    for (k, (p, q)) in a.values.iter().zip(&b.values).enumerate() {
        let promised = p[0] + 0.5 * width * (p[1] + q[1]) + width * width / 12.0 * (p[2] - q[2]);
        // Angles of reaches that differ are told in other arcs.
        let is_angle = k >= 2 * a.shown.points.len();
        let off = if is_angle {
            let link = k - 2 * a.shown.points.len();
            let [p, q] = [&a.shown.angles[link], &b.shown.angles[link]];
            let promised =
                p[0] + 0.5 * width * (p[1] + q[1]) + width * width / 12.0 * (p[2] - q[2]);
            (q[0] - promised).abs() * reach
        } else {
            (q[0] - promised).abs()
        };
        if off.is_nan() || off > worst.0 {
            worst = (if off.is_nan() { f64::INFINITY } else { off }, k);
        }
    }
    if worst.0 <= remainder + rounded(1.0) {
        return None;
    }
    let grown = [a, b].map(|row| subject.equations.condition(&row.shown).pose);
    let allowed = remainder + rounded(grown[0].max(grown[1]).max(1.0));
    let (off, value) = worst;
    (off > allowed).then(|| format!("value {value} off by {off:e}, allowed {allowed:e}"))
}
