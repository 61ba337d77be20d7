//! What a linkage is worth as a solution: whether it goes through its positions, in which order,
//! and how well it moves.

use crate::tolerance;
use std::f64::consts::{PI, TAU};

use super::Proportions;
use super::closure::Direction;
use crate::{Assembly, Cycle, FourBar, Grashof, Invalid};

/// What is true of a linkage that is to take up positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// Whether it goes from each position to each other one.
    pub passage: Passage,
    /// The assembly in which it does; none where it does not.
    pub assembly: Option<Assembly>,
    /// Whether it meets them in the given order.
    pub order: Order,
    /// Grashof's class.
    pub grashof: Grashof,
    /// Whether the input turns fully.
    pub turns: bool,
    /// The least transmission angle over the whole motion, 0 … π/2.
    pub transmission: f64,
    /// The same from the first position to the last; none where it does not go through them.
    pub transmission_between: Option<f64>,
    /// The greatest of the four lengths relative to the least.
    pub size_ratio: f64,
}

/// Whether a linkage driven by its input goes through all positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passage {
    /// It does.
    Continuous,
    /// The motions to which the positions belong cross at a change point, where all links are in
    /// line: it may leave it either way.
    ThroughChangePoint,
    /// Between the positions the input comes to a dead point and would have to turn back there
    /// (a branch defect).
    AcrossDeadPoint,
    /// The linkage would have to be taken apart (a circuit defect).
    OtherCircuit,
    /// It cannot be closed at the input of this position, the first of those.
    Unreached(usize),
}

/// Whether positions are met in the given order while the input goes one way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As φ₃ grows.
    Growing,
    /// As φ₃ falls.
    Falling,
    /// Whichever way φ₃ goes: a single position, or two of an input that turns fully.
    Either,
    /// In another order, or not all of them.
    Mixed,
}

/// Sides smaller than this, relative to their terms, are none: coupler and output in line.
const IN_LINE: f64 = 1e-11;

/// The verdict, with the directions of output and input relative to the frame's.
///
/// # Errors
/// Why these lengths make no linkage.
pub(super) fn verdict(
    proportions: Proportions,
    directions: &[Direction],
) -> Result<Verdict, Vec<Invalid>> {
    let linkage = proportions.four_bar(1.0)?;
    let cycle = linkage.cycle();
    let way = Way::new(&linkage, &cycle, proportions, directions);
    Ok(Verdict {
        passage: way.passage,
        assembly: way.assembly.filter(|_| way.passage == Passage::Continuous),
        order: way.order,
        grashof: linkage.grashof(),
        turns: cycle.is_full(),
        transmission: linkage.worst_transmission().0,
        transmission_between: (way.span).map(|span| transmission_within(&linkage, &cycle, span)),
        size_ratio: proportions.size_ratio(),
    })
}

/// How the positions lie on the motions of a linkage.
struct Way {
    passage: Passage,
    /// The assembly of the positions; none if coupler and output are in line at all of them.
    assembly: Option<Assembly>,
    order: Order,
    /// The input from the first position to the last, if it goes through them.
    span: Option<[f64; 2]>,
}

impl Way {
    fn new(
        linkage: &FourBar,
        cycle: &Cycle,
        proportions: Proportions,
        directions: &[Direction],
    ) -> Self {
        let mut found = Self {
            passage: Passage::Continuous,
            assembly: None,
            order: Order::Mixed,
            span: None,
        };
        let mut first_arc = None;
        let mut met = Met::new(cycle);
        for (k, direction) in directions.iter().enumerate() {
            let Some((arc, mut input)) = arc_of(cycle, direction.input_angle) else {
                found.passage = Passage::Unreached(k);
                return found;
            };
            let here = assembly(linkage, cycle, direction, proportions.input, &mut input);
            let apart = matches!((here, found.assembly), (Some(a), Some(b)) if a != b);
            found.assembly = found.assembly.or(here);
            let other_arc = *first_arc.get_or_insert(arc) != arc;
            let passage = if other_arc {
                Passage::OtherCircuit
            } else if !apart {
                Passage::Continuous
            } else if linkage.changes() {
                Passage::ThroughChangePoint
            } else if cycle.is_full() {
                Passage::OtherCircuit
            } else {
                Passage::AcrossDeadPoint
            };
            if found.passage == Passage::Continuous || passage == Passage::OtherCircuit {
                found.passage = passage;
            }
            met.next(input);
        }
        if found.passage == Passage::Continuous {
            found.order = met.order();
            found.span = Some(met.span());
            // All positions in line with the coupler: either letter names the motion.
            found.assembly = found.assembly.or(Some(Assembly::First));
        }
        found
    }
}

/// The arc of the cycle that holds an input, and the input within the cycle's axis.
fn arc_of(cycle: &Cycle, input: f64) -> Option<(usize, f64)> {
    let input = cycle.wrap(input);
    if cycle.is_full() {
        return Some((0, input));
    }
    let arcs = cycle.arcs();
    for turn in [0.0, TAU, -TAU] {
        let input = input + turn;
        let holds = |[from, to]: &[f64; 2]| {
            (from - tolerance::DISTINCT..=to + tolerance::DISTINCT).contains(&input)
        };
        if let Some(arc) = arcs.iter().position(holds) {
            return Some((arc, input.clamp(arcs[arc][0], arcs[arc][1])));
        }
    }
    None
}

/// The assembly of a position; none where coupler and output are in line. Where a motion takes
/// two turns, the assembly is that of one of the turns, and `input` is brought into that turn.
fn assembly(
    linkage: &FourBar,
    cycle: &Cycle,
    direction: &Direction,
    z3: f64,
    input: &mut f64,
) -> Option<Assembly> {
    let side = direction.side(z3);
    if side.abs() <= IN_LINE * (1.0 + z3) {
        return None;
    }
    let assembly_at = |input: f64| {
        let same = linkage.side(Assembly::First, input) == side.signum();
        if same {
            Assembly::First
        } else {
            Assembly::Second
        }
    };
    let two_turns = cycle.is_full() && cycle.period().is_some_and(|period| period > 1.5 * TAU);
    if two_turns {
        if assembly_at(*input) == Assembly::Second {
            *input = cycle.wrap(*input + TAU);
        }
        return Some(Assembly::First);
    }
    Some(assembly_at(*input))
}

/// The inputs of the positions, as they are met one after the other.
struct Met {
    /// Of a driver that turns fully: after so much the motion repeats.
    period: Option<f64>,
    count: usize,
    last: f64,
    first: f64,
    /// How far the input has gone up and down, from each position to the next.
    up: f64,
    down: f64,
    /// Whether each step of a driver that swings went up, or down.
    monotone: [bool; 2],
    extremes: [f64; 2],
}

impl Met {
    fn new(cycle: &Cycle) -> Self {
        Self {
            period: cycle.period().filter(|_| cycle.is_full()),
            count: 0,
            last: 0.0,
            first: 0.0,
            up: 0.0,
            down: 0.0,
            monotone: [true; 2],
            extremes: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    fn next(&mut self, input: f64) {
        if self.count == 0 {
            self.first = input;
        } else {
            let step = input - self.last;
            let period = self.period.unwrap_or(TAU);
            self.up += step.rem_euclid(period);
            self.down += (-step).rem_euclid(period);
            self.monotone = [
                self.monotone[0] && step > 0.0,
                self.monotone[1] && step < 0.0,
            ];
        }
        self.count += 1;
        self.last = input;
        self.extremes = [self.extremes[0].min(input), self.extremes[1].max(input)];
    }

    fn order(&self) -> Order {
        let [grows, falls] = match self.period {
            Some(period) => [self.up < period, self.down < period],
            None => self.monotone,
        };
        match (grows, falls) {
            (true, true) => Order::Either,
            (true, false) => Order::Growing,
            (false, true) => Order::Falling,
            (false, false) => Order::Mixed,
        }
    }

    /// The input from the first position to the last: the shorter way where it may go either.
    fn span(&self) -> [f64; 2] {
        match (self.period, self.order()) {
            (None, _) => self.extremes,
            (Some(_), Order::Growing) => [self.first, self.first + self.up],
            (Some(_), Order::Falling) => [self.first - self.down, self.first],
            (Some(_), Order::Either) if self.up <= self.down => [self.first, self.first + self.up],
            (Some(_), Order::Either) => [self.first - self.down, self.first],
            (Some(period), Order::Mixed) => [self.first, self.first + period],
        }
    }
}

/// The least transmission angle over a stretch of the input: it falls away on either side of
/// 90°, and the diagonal is monotone from 0 to π, so at an end or at a half turn.
fn transmission_within(linkage: &FourBar, cycle: &Cycle, [from, to]: [f64; 2]) -> f64 {
    let half_turns = (0..8).map(|k| ((from / PI).ceil() + f64::from(k)) * PI);
    let within = half_turns.take_while(|input| *input < to);
    let of = |input: f64| linkage.transmission_angle(input).ok();
    let inner = within
        .filter(|input| cycle.contains(*input))
        .filter_map(of)
        .reduce(f64::min);
    let ends = of(from).unwrap_or(0.0).min(of(to).unwrap_or(0.0));
    inner.map_or(ends, |inner| inner.min(ends))
}
