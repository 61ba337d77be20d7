//! Assessment of a linkage as a solution: continuity of the motion through the positions, order, transmission.

use crate::tolerance;
use std::f64::consts::{PI, TAU};

use super::Proportions;
use super::closure::Direction;
use crate::{Assembly, Cycle, FourBar, Grashof, Invalid};

/// Properties of a linkage that is to pass through positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// Passage of the linkage through all positions.
    pub passage: Passage,
    /// Assembly in which the linkage moves through all positions; None if it does not.
    pub assembly: Option<Assembly>,
    /// Order in which the positions are met.
    pub order: Order,
    /// Grashof type.
    pub grashof: Grashof,
    /// True if the input turns fully.
    pub turns: bool,
    /// Minimum transmission angle over the whole motion, 0 … π/2.
    pub transmission: f64,
    /// Minimum transmission angle from first to last position; none if the linkage does not pass through all of them.
    pub transmission_between: Option<f64>,
    /// Ratio of the longest to the shortest of the four lengths.
    pub size_ratio: f64,
}

/// Passage of a linkage, driven by its input, through all positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passage {
    /// The linkage moves through all positions.
    Continuous,
    /// The positions are on two motions that cross at a change point, where all links are in line; either may follow.
    ThroughChangePoint,
    /// Between positions the input reaches a dead point and would have to turn back (a branch defect).
    AcrossDeadPoint,
    /// Between positions the linkage would have to be taken apart (a circuit defect).
    OtherCircuit,
    /// Index, from 0, of the first position at whose input the linkage cannot be assembled.
    Unreached(usize),
}

impl Passage {
    /// True if all positions are on one circuit: the linkage reaches them without being taken apart.
    pub fn is_on_one_circuit(self) -> bool {
        matches!(
            self,
            Self::Continuous | Self::ThroughChangePoint | Self::AcrossDeadPoint
        )
    }

    /// True if all positions are on one branch: the driver reaches them without a dead point between.
    pub fn is_on_one_branch(self) -> bool {
        self == Self::Continuous
    }
}

/// Order of the positions while the input moves in one direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The given order while φ₃ increases.
    Growing,
    /// The given order while φ₃ decreases.
    Falling,
    /// The given order in both directions of φ₃: for a single position, or for two if the input turns fully.
    Either,
    /// Another order, or not all positions are met.
    Mixed,
}

/// The verdict on a linkage, from the directions of output and input relative to the direction of the frame.
///
/// # Errors
/// Every reason why these lengths form no linkage.
pub(in crate::synthesis) fn verdict(
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

/// Passage of a linkage through the positions, and the order in which it meets them.
struct Way {
    passage: Passage,
    /// The assembly of the positions; none if coupler and output are in line at all of them.
    assembly: Option<Assembly>,
    order: Order,
    /// Range of the input from the first position to the last; none unless the linkage moves through them all.
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
        let mut met = Met::new(cycle.period().filter(|_| cycle.is_full()));
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
            // If coupler and output are in line at all positions, the two assemblies do not differ there.
            found.assembly = found.assembly.or(Some(Assembly::First));
        }
        found
    }
}

/// Index of the arc of the cycle that contains an input, and the input shifted by whole turns into this arc.
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

/// The assembly of a position; none if coupler and output are in line. If the motion takes two turns, the result is
/// always the first assembly, and `input` is shifted into the turn in which this assembly meets the position.
fn assembly(
    linkage: &FourBar,
    cycle: &Cycle,
    direction: &Direction,
    z3: f64,
    input: &mut f64,
) -> Option<Assembly> {
    let side = direction.side(z3);
    if side.abs() <= tolerance::NEGLIGIBLE * (1.0 + z3) {
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

/// Inputs of the positions, added in the given order.
pub(in crate::synthesis) struct Met {
    /// Period of the motion; only for a driver that turns fully.
    period: Option<f64>,
    count: usize,
    last: f64,
    first: f64,
    /// Sum of the increments of the input from each position to the next, if the input only increases.
    up: f64,
    /// Sum of the magnitudes of the decrements, if the input only decreases.
    down: f64,
    /// For an oscillating driver: whether the input increases at every step, and whether it decreases at every step.
    monotone: [bool; 2],
    extremes: [f64; 2],
}

impl Met {
    /// No inputs yet. `period` is that of a driver that turns fully.
    pub(in crate::synthesis) fn new(period: Option<f64>) -> Self {
        Self {
            period,
            count: 0,
            last: 0.0,
            first: 0.0,
            up: 0.0,
            down: 0.0,
            monotone: [true; 2],
            extremes: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    pub(in crate::synthesis) fn next(&mut self, input: f64) {
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

    pub(in crate::synthesis) fn order(&self) -> Order {
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

    /// Range of the input from the first position to the last, in the shorter direction if both are possible. For an
    /// oscillating driver it is the range of all positions; otherwise, if the order is mixed, a whole period.
    pub(in crate::synthesis) fn span(&self) -> [f64; 2] {
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

/// Minimum transmission angle over a range of the input. As the diagonal grows, the angle rises to 90° and falls again;
/// the diagonal is monotone in the input from 0 to π. So the minimum is at an end or at a multiple of half a turn.
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
