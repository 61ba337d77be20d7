//! Extrema of a derivative over a motion, refined to rounding.

use std::f64::consts::PI;

use crate::{Assembly, Cycle, FourBar, Jet, Pose};

/// Maximum or minimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A local maximum.
    Max,
    /// A local minimum.
    Min,
}

/// A local extremum of an angle's derivative by the crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremum {
    /// Maximum or minimum.
    pub kind: Kind,
    /// φ₁.
    pub crank: f64,
    /// The extreme value.
    pub value: f64,
}

impl Extremum {
    /// The extremum of what turns `ratio` times as fast: a negative ratio makes a
    /// minimum of a maximum.
    pub fn scaled(self, ratio: f64) -> Self {
        let kind = match (self.kind, ratio < 0.0) {
            (kind, false) => kind,
            (Kind::Max, true) => Kind::Min,
            (Kind::Min, true) => Kind::Max,
        };
        Self {
            kind,
            crank: self.crank,
            value: self.value * ratio,
        }
    }
}

/// Samples a turn; between two of them an extremum is found by the signs of two
/// more derivatives.
const GRID: usize = 360;
/// Halvings of a cell of the grid towards φ₁ = 0 and π: near a change point or a
/// vanishing diagonal, and only there, a motion changes within any small angle.
const GRADES: i32 = 52;
/// A derivative that varies by less than this beside its size is constant.
const CONSTANT: f64 = 1e-9;

/// The local extrema of φ′ and of φ″ of an angle of the linkage over its cycle,
/// each in ascending crank angle; `angle` picks the link.
///
/// Each is a root of the next derivative, found by safeguarded Newton steps with
/// the exact one after that. None for a derivative that is constant.
pub fn extrema(
    linkage: &FourBar,
    assembly: Assembly,
    angle: impl Fn(&Pose<5>) -> Jet<5>,
) -> [Vec<Extremum>; 2] {
    let sample = |crank: f64| -> Option<Sample> {
        let jet = angle(&linkage.pose(assembly, crank).ok()?);
        let derivatives = std::array::from_fn(|order| jet.derivative(order));
        Some(Sample { crank, derivatives })
    };
    let cycle = linkage.cycle();
    let sweeps: Vec<Vec<Option<Sample>>> = stretches(&cycle)
        .into_iter()
        .map(|stretch| stretch.into_iter().map(sample).collect())
        .collect();
    [1, 2].map(|order| extrema_of(order, &cycle, &sweeps, &sample))
}

/// The extrema of one derivative, from samples of the whole motion.
fn extrema_of(
    order: usize,
    cycle: &Cycle,
    sweeps: &[Vec<Option<Sample>>],
    sample: &impl Fn(f64) -> Option<Sample>,
) -> Vec<Extremum> {
    let values = sweeps
        .iter()
        .flatten()
        .flatten()
        .map(|s| s.derivatives[order]);
    let [least, most] = values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    );
    if most - least <= CONSTANT * least.abs().max(most.abs()).max(1.0) {
        return Vec::new();
    }
    let mut found: Vec<Sample> = Vec::new();
    for samples in sweeps {
        // A full cycle closes: from its last sample to its first.
        if let (true, [Some(first), .., Some(last)]) = (cycle.is_full(), &samples[..])
            && last.derivatives[order + 1] * first.derivatives[order + 1] < 0.0
        {
            found.push(*first);
        }
        for pair in samples.windows(2) {
            if let [Some(a), Some(b)] = pair {
                found.extend(roots(sample, order + 1, *a, *b));
            }
        }
    }
    let in_cycle = |crank: f64| {
        let [start, end] = cycle.axis();
        let wrapped = cycle.wrap(crank);
        if cycle.is_full() && wrapped >= end {
            start
        } else {
            wrapped
        }
    };
    let extremum = |sample: &Sample| {
        let bend = sample.derivatives[order + 2];
        let kind = if bend < 0.0 { Kind::Max } else { Kind::Min };
        (bend != 0.0).then_some(Extremum {
            kind,
            crank: in_cycle(sample.crank),
            value: sample.derivatives[order],
        })
    };
    let mut extrema: Vec<Extremum> = found.iter().filter_map(extremum).collect();
    extrema.sort_by(|a, b| a.crank.total_cmp(&b.crank));
    extrema
}

/// An angle and its first four derivatives at a crank angle.
#[derive(Clone, Copy)]
struct Sample {
    crank: f64,
    derivatives: [f64; 5],
}

/// The grid of each arc: even, and graded towards multiples of π. A full cycle is
/// taken around φ₁ = 0, beside which numbers lie closest.
fn stretches(cycle: &Cycle) -> Vec<Vec<f64>> {
    let cell = 2.0 * PI / GRID as f64;
    let graded = |[from, to]: &[f64; 2]| {
        let count = ((to - from) / cell).ceil();
        let mut cranks: Vec<f64> = (0..=count as usize)
            .map(|i| from + (to - from) * (i as f64 / count))
            .collect();
        for half_turn in [-2.0, -1.0, 0.0, 1.0, 2.0] {
            for grade in 0..GRADES {
                let step = cell * 0.5_f64.powi(grade);
                cranks.extend([half_turn * PI - step, half_turn * PI + step]);
            }
        }
        cranks.retain(|crank| (from..=to).contains(&crank));
        cranks.sort_by(f64::total_cmp);
        cranks
    };
    if cycle.is_full() {
        let [start, end] = cycle.axis();
        let half = 0.5 * (end - start);
        return vec![graded(&[start - half, start + half])];
    }
    cycle.arcs().iter().map(graded).collect()
}

/// Roots of the derivative `order` between two neighbouring samples: none, one
/// where it changes its sign, two where it turns within the cell and passes zero
/// there and back.
fn roots(
    sample: &impl Fn(f64) -> Option<Sample>,
    order: usize,
    a: Sample,
    b: Sample,
) -> Vec<Sample> {
    let [slope, bend] = [0, 1].map(|k| move |s: &Sample| s.derivatives[order + k]);
    if slope(&a) == 0.0 || slope(&a) * slope(&b) < 0.0 {
        return bracketed(sample, a, b, slope, bend).into_iter().collect();
    }
    let towards_zero = slope(&a) * bend(&a) < 0.0 && slope(&b) * bend(&b) > 0.0;
    if !towards_zero {
        return Vec::new();
    }
    match bracketed(sample, a, b, bend, |_| f64::NAN) {
        Some(turn) if slope(&turn) * slope(&a) < 0.0 => [(a, turn), (turn, b)]
            .into_iter()
            .filter_map(|(a, b)| bracketed(sample, a, b, slope, bend))
            .collect(),
        _ => Vec::new(),
    }
}

/// The sample where `f` vanishes between `a` and `b`, at which its signs differ:
/// Newton steps with `slope` while they stay inside, every third a halving.
fn bracketed(
    sample: &impl Fn(f64) -> Option<Sample>,
    a: Sample,
    b: Sample,
    f: impl Fn(&Sample) -> f64,
    slope: impl Fn(&Sample) -> f64,
) -> Option<Sample> {
    let (mut low, mut high) = (a, b);
    let mut best = if f(&a).abs() < f(&b).abs() { a } else { b };
    for step in 0..180 {
        let inside = |crank: &f64| *crank > low.crank && *crank < high.crank;
        let middle = 0.5 * (low.crank + high.crank);
        let newton = best.crank - f(&best) / slope(&best);
        let crank = [newton, middle]
            .into_iter()
            .skip(usize::from(step % 3 == 2))
            .find(inside);
        // Nothing lies between two neighbouring numbers: the root is found.
        let Some(next) = crank.map(sample) else { break };
        let next = next?;
        if f(&next) * f(&low) > 0.0 {
            low = next;
        } else {
            high = next;
        }
        let moved = (next.crank - best.crank).abs();
        if f(&next).abs() < f(&best).abs() {
            best = next;
        }
        if f(&best) == 0.0 || moved <= f64::EPSILON * next.crank.abs() {
            break;
        }
    }
    Some(best)
}
