//! Zeros and extrema of quantities over a motion, refined to rounding.

use std::f64::consts::TAU;

use super::{Extremum, InputRate, Kind, Motion};
use crate::mechanism::{Pose, Quantity, half_turns};
use crate::sorting::sort_by;
use crate::{Cycle, Jet};

/// What stands out of a quantity over a motion, in ascending crank angle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Features {
    /// Crank angles at which it passes zero.
    pub zeros: Vec<f64>,
    /// Its local extrema.
    pub extrema: Vec<Extremum>,
    /// The value that it has throughout, where it does not change: 0 where that is rounding alone.
    pub level: Option<f64>,
}

impl Features {
    /// Those of a multiple of the quantity.
    pub fn scaled(&self, ratio: f64) -> Self {
        Self {
            zeros: self.zeros.clone(),
            extrema: self.extrema.iter().map(|e| e.scaled(ratio)).collect(),
            level: self.level.map(|level| ratio * level),
        }
    }
}

/// Samples a turn; between two of them an extremum is found by the signs of two
/// more derivatives.
const GRID: usize = 360;
/// Extrema are looked for over no more turns: in no plot could two of them be told apart.
const MOST_TURNS: usize = 256;
/// No more samples are kept at once, of all quantities together.
const MOST_SAMPLES: usize = 1 << 18;
/// Halvings of a cell of the grid towards the inputs at which the crank is in line with the outer hinges of a dyad: near a
/// change point or where the hinges nearly meet, and only there, a motion changes within any small angle.
const GRADES: i32 = 52;
/// A derivative that varies by less than this relative to its size is constant.
pub(super) const CONSTANT: f64 = 1e-9;
/// Rounding of a value, relative to it.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// A part smaller than this, relative to the whole drawing, is judged as if it were as large: 10⁻¹² of the drawing is the
/// rounding of places.
const LEAST_PART: f64 = 1e-3;
/// Where an angle between two links stands while both turn, rounding alone passes zero to and fro within this, radians
/// or the unit of lengths.
const ALIKE: f64 = 1e-9;
/// An angle with less of an offset to a multiple of another, radians, is that.
const NO_OFFSET: f64 = 1e-12;

/// The reason why zeros and extrema were not looked for: a motion that repeats only after more turns than are searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooManyTurns {
    /// After how many turns of the crank it repeats.
    pub turns: usize,
    /// Most turns that are searched.
    pub most: usize,
}

impl Motion {
    /// Zeros and extrema of quantities and of their first two derivatives by time,
    /// as of [`features`]: found once for all that are multiples of the same one.
    /// Where an angle is folded it has neither.
    ///
    /// # Errors
    /// A motion of too many turns is not searched.
    pub fn features(
        &self,
        quantities: &[Quantity],
        input: InputRate,
    ) -> Result<Vec<[Features; 3]>, TooManyTurns> {
        let mechanism = self.mechanism();
        let multiples = quantities.iter().map(|one| self.multiple(*one));
        let multiples: Vec<(Quantity, f64)> = multiples.collect();
        let mut bases: Vec<Quantity> = Vec::new();
        for (base, _) in &multiples {
            if !bases.contains(base) {
                bases.push(*base);
            }
        }
        let stretches = self.stretches()?;
        let samples: usize = stretches.iter().map(Vec::len).sum();
        let at_once = (MOST_SAMPLES / samples.max(1)).max(1);
        let found = bases.chunks(at_once).flat_map(|bases| {
            let units: Vec<f64> = bases.iter().map(|base| self.unit(*base)).collect();
            let jets = self.telling(|pose: &Pose<5>| {
                let bases = bases.iter();
                bases.map(|base| base.unfolded(mechanism, pose)).collect()
            });
            let jets = |input: f64| -> Option<Vec<Jet<5>>> { jets(input).ok() };
            let found = features_over(&stretches, self.cycle(), &jets, &units, input);
            let found = bases.iter().zip(found);
            found.map(|(base, found)| {
                if base.is_folded() {
                    self.folded(*base, found)
                } else {
                    found
                }
            })
        });
        let found: Vec<[Features; 3]> = found.collect();
        let scaled = |(base, factor): (Quantity, f64)| {
            let mut known = bases.iter().zip(&found);
            let found = known.find(|(one, _)| **one == base);
            let found = found.map(|(_, found)| found.each_ref().map(|order| order.scaled(factor)));
            debug_assert!(found.is_some(), "every base was searched");
            found
        };
        Ok(multiples.into_iter().filter_map(scaled).collect())
    }

    /// The grid over it.
    fn stretches(&self) -> Result<Vec<Vec<f64>>, TooManyTurns> {
        stretches(self.cycle(), &|arc| self.mechanism().in_line(arc))
    }

    /// Whether zeros and extrema can be looked for over it.
    ///
    /// # Errors
    /// It repeats only after too many turns.
    pub fn searchable(&self) -> Result<(), TooManyTurns> {
        searchable(self.cycle())
    }

    /// What counts as one of a quantity: 1 for an angle, the size of the mechanism for a coordinate, and for a distance no
    /// more than rounding asks for, as it may be within a small part of the drawing.
    pub(super) fn unit(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::X(_) | Quantity::Y(_) => self.mechanism().size(),
            Quantity::Distance(_) => self.unit_within(0.0),
            Quantity::Angle(_)
            | Quantity::Transmission(_)
            | Quantity::Pressure(_)
            | Quantity::Corner(_)
            | Quantity::Between(_) => 1.0,
        }
    }

    /// What counts as one of a length within a part of the drawing: the size of the part, or of the least part of which
    /// rounding leaves enough digits.
    pub(super) fn unit_within(&self, part: f64) -> f64 {
        part.max(LEAST_PART * self.mechanism().size())
    }

    /// Those of an angle from those of the angle before it is folded: what is folded turns its sense, and passes no
    /// zero.
    fn folded(&self, quantity: Quantity, found: [Features; 3]) -> [Features; 3] {
        let turned = |extremum: Extremum| {
            let pose = self.pose::<3>(extremum.input);
            debug_assert!(pose.is_ok(), "an extremum is found in a pose");
            let angle = quantity.unfolded(self.mechanism(), &pose.ok()?);
            Some(extremum.scaled(quantity.sense(&angle)))
        };
        let [value, first, second] = found.map(|mut order| {
            order
                .zeros
                .dedup_by(|one, other| (*one - *other).abs() < ALIKE);
            order.extrema.dedup_by(|one, other| {
                one.kind == other.kind && (one.input - other.input).abs() < ALIKE
            });
            order.extrema = order.extrema.into_iter().filter_map(turned).collect();
            order
        });
        let value = Features {
            zeros: Vec::new(),
            extrema: (value.extrema.into_iter())
                .map(|extremum| Extremum {
                    value: quantity.folded(extremum.value),
                    ..extremum
                })
                .collect(),
            level: value.level.map(|level| quantity.folded(level)),
        };
        let rate = |order: Features| Features {
            level: order.level.filter(|level| *level == 0.0),
            ..order
        };
        [value, rate(first), rate(second)]
    }

    /// The quantity that another is a multiple of, and how many times. With an offset
    /// to it an angle has zeros of its own.
    fn multiple(&self, quantity: Quantity) -> (Quantity, f64) {
        let Quantity::Angle(link) = quantity else {
            return (quantity, 1.0);
        };
        let multiple = self.mechanism().multiple_of(link);
        if multiple.offset.abs() < NO_OFFSET {
            (Quantity::Angle(multiple.of), multiple.factor)
        } else {
            (quantity, 1.0)
        }
    }
}

/// Zeros and extrema of quantities and of their first two derivatives by time
/// over a cycle: `motion` gives the quantities at a crank angle φ₁ from the line of the frame, `units` the size
/// that counts as one for each (1 for an angle, a length of the mechanism for a
/// coordinate).
///
/// Each is a root of the quantity or of the next derivative, found by safeguarded
/// Newton steps with the exact one after that. Where it is constant there are none, but its level.
///
/// # Errors
/// A cycle of too many turns is not searched.
pub fn features(
    cycle: &Cycle,
    motion: &dyn Fn(f64) -> Option<Vec<Jet<5>>>,
    units: &[f64],
    input: InputRate,
) -> Result<Vec<[Features; 3]>, TooManyTurns> {
    let stretches = stretches(cycle, &|arc| half_turns(0.0, arc).collect())?;
    Ok(features_over(&stretches, cycle, motion, units, input))
}

/// The same from samples at these crank angles.
fn features_over(
    stretches: &[Vec<f64>],
    cycle: &Cycle,
    motion: &dyn Fn(f64) -> Option<Vec<Jet<5>>>,
    units: &[f64],
    input: InputRate,
) -> Vec<[Features; 3]> {
    let at = |crank: &f64| Some((*crank, motion(*crank)?));
    let sweeps = stretches.iter();
    let sweeps = sweeps.map(|stretch| stretch.iter().map(at).collect());
    let sweeps: Vec<Vec<_>> = sweeps.collect();
    let of = |index: usize, order: usize| {
        let sample = |(crank, jets): &(f64, Vec<Jet<5>>)| Sample {
            crank: *crank,
            f: input.rates(&jets[index], order),
        };
        let at = |crank: f64| Some(sample(&(crank, motion(crank)?)));
        let sweeps = sweeps.iter().map(|stretch| {
            let samples: Vec<Option<Sample>> =
                stretch.iter().map(|at| at.as_ref().map(sample)).collect();
            if cycle.is_full() {
                closed(cycle, &samples, order, &at)
            } else {
                samples
            }
        });
        let sweeps: Vec<Vec<Option<Sample>>> = sweeps.collect();
        let size = units[index] * (input.scale(order).abs() + input.acceleration.abs());
        features_of(cycle, &sweeps, &at, Tolerance::of(order, size))
    };
    (0..units.len())
        .map(|index| [0, 1, 2].map(|order| of(index, order)))
        .collect()
}

/// The extrema alone of one quantity itself, as of [`features`], in fewer
/// derivatives.
///
/// # Errors
/// A cycle of too many turns is not searched.
pub(super) fn turning_points(
    motion: &Motion,
    quantity: &dyn Fn(f64) -> Option<Jet<3>>,
    unit: f64,
) -> Result<Vec<Extremum>, TooManyTurns> {
    let cycle = motion.cycle();
    let sample = |crank: f64| {
        let jet = quantity(crank)?;
        let f = [0, 1, 2].map(|order| jet.derivative(order));
        Some(Sample { crank, f })
    };
    let sweeps = motion.stretches()?.into_iter().map(|stretch| {
        let samples: Vec<Option<Sample>> = stretch.into_iter().map(sample).collect();
        if cycle.is_full() {
            closed(cycle, &samples, 0, &sample)
        } else {
            samples
        }
    });
    let sweeps: Vec<Vec<Option<Sample>>> = sweeps.collect();
    let Variation::Varied = course(&sweeps, Tolerance::of(0, unit)) else {
        return Ok(Vec::new());
    };
    let turns = ordered_roots(cycle, &sweeps, &sample, 1);
    Ok(turns.iter().filter_map(Sample::extremum).collect())
}

/// Zeros and extrema of one function of the crank angle, from samples of the
/// whole motion.
fn features_of(
    cycle: &Cycle,
    sweeps: &[Vec<Option<Sample>>],
    sample: &dyn Fn(f64) -> Option<Sample>,
    tolerance: Tolerance,
) -> Features {
    if let Variation::Level(level) = course(sweeps, tolerance) {
        return Features {
            level,
            ..Features::default()
        };
    }
    let [zeros, turns] = [0, 1].map(|order| ordered_roots(cycle, sweeps, sample, order));
    Features {
        zeros: zeros.iter().map(|sample| sample.crank).collect(),
        extrema: turns.iter().filter_map(Sample::extremum).collect(),
        level: None,
    }
}

/// Whether a function changes.
enum Variation {
    /// It does.
    Varied,
    /// It does not; its value, if there are any samples.
    Level(Option<f64>),
}

/// What a function may vary by and be constant.
#[derive(Clone, Copy)]
struct Tolerance {
    absolute: f64,
    /// Relative to its largest value.
    relative: f64,
}

impl Tolerance {
    /// That of a quantity or of its derivative of an order, where `size` counts as one of it. A place far from the origin
    /// is rounded by its distance, but not judged by it.
    fn of(order: usize, size: f64) -> Self {
        Self {
            absolute: CONSTANT * size,
            relative: if order == 0 { ROUNDING } else { CONSTANT },
        }
    }
}

fn course(sweeps: &[Vec<Option<Sample>>], tolerance: Tolerance) -> Variation {
    let values = sweeps.iter().flatten().flatten().map(|s| s.f[0]);
    let [least, most] = values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    );
    let largest = least.abs().max(most.abs());
    let rounding = tolerance.absolute.max(tolerance.relative * largest);
    if most - least > rounding {
        return Variation::Varied;
    }
    let value = if largest > rounding {
        least.midpoint(most)
    } else {
        0.0
    };
    Variation::Level((least <= most).then_some(value))
}

/// [`all_roots`] within the cycle, in ascending order.
fn ordered_roots(
    cycle: &Cycle,
    sweeps: &[Vec<Option<Sample>>],
    sample: &dyn Fn(f64) -> Option<Sample>,
    order: usize,
) -> Vec<Sample> {
    let in_cycle = |crank: f64| {
        let [start, end] = cycle.axis();
        let wrapped = cycle.wrap(crank);
        if cycle.is_full() && wrapped >= end {
            start
        } else {
            wrapped
        }
    };
    let mut ordered = all_roots(sweeps, sample, order);
    sort_by(&mut ordered, |a, b| a.crank.total_cmp(&b.crank));
    // Beside a root rounding alone changes the sign to and fro; beside 0, where numbers lie closest, it does not.
    ordered.dedup_by(|later, one| later.crank - one.crank <= ROUNDING * later.crank.abs());
    let [start, end] = cycle.axis();
    if let (true, [first, .., last]) = (cycle.is_full(), &ordered[..])
        && first.crank + (end - start) - last.crank <= ROUNDING * last.crank.abs()
    {
        ordered.pop();
    }
    for found in &mut ordered {
        found.crank = in_cycle(found.crank);
    }
    sort_by(&mut ordered, |a, b| a.crank.total_cmp(&b.crank));
    ordered
}

/// Samples of a full cycle, closed. Rates stay around its start, beside which numbers lie closest, and end with what they
/// begin with. Values are put in order from the start to the end, the first of them once more at the end: an angle that
/// turns fully goes on from where it was a cycle before.
fn closed(
    cycle: &Cycle,
    samples: &[Option<Sample>],
    order: usize,
    at: &dyn Fn(f64) -> Option<Sample>,
) -> Vec<Option<Sample>> {
    if order > 0 {
        let mut samples = samples.to_vec();
        if let [Some(first), .., Some(last)] = &mut samples[..] {
            last.f = first.f;
        }
        return samples;
    }
    let [start, end] = cycle.axis();
    // The first and the last are a cycle from each other.
    let samples = samples.get(1..).unwrap_or_default();
    // Where there is no pose, at an input that a deltoid does not determine, its neighbour will do.
    let before = samples.iter().flatten();
    let before = before.take_while(|sample| sample.crank < start);
    let mut grown = before.filter_map(|sample| {
        let later = at(sample.crank + (end - start))?;
        Some(later.f[0] - sample.f[0])
    });
    let grown = grown.next();
    let later = |mut sample: Sample| {
        sample.crank += end - start;
        sample.f[0] += grown?;
        Some(sample)
    };
    let middle = samples
        .iter()
        .position(|sample| sample.is_some_and(|sample| sample.crank >= start));
    // Without one all are before it.
    let (before, after) = samples.split_at(middle.unwrap_or(samples.len()));
    let again = before.iter().map(|sample| sample.and_then(later));
    // Inputs before the start may be those of the cycle's end already: the end itself has its own growth.
    let closing = after.first().map(|first| {
        let first = (*first)?;
        let crank = first.crank + (end - start);
        let [_, slope, bend] = first.f;
        let f = [at(crank)?.f[0], slope, bend];
        Some(Sample { crank, f })
    });
    after.iter().copied().chain(again).chain(closing).collect()
}

/// The samples at which the derivative `order`, 0 or 1, of the function vanishes.
fn all_roots(
    sweeps: &[Vec<Option<Sample>>],
    sample: &dyn Fn(f64) -> Option<Sample>,
    order: usize,
) -> Vec<Sample> {
    // What a deltoid does not determine parts its motion: there rates may jump.
    let cells = sweeps.iter().flat_map(|samples| samples.windows(2));
    let cells = cells.filter_map(|pair| match pair {
        [Some(a), Some(b)] => Some(roots(sample, order, *a, *b)),
        _ => None,
    });
    cells.flatten().collect()
}

/// A function of the crank angle and its first two derivatives by it.
#[derive(Clone, Copy)]
struct Sample {
    crank: f64,
    f: [f64; 3],
}

impl Sample {
    /// What it is if its rate vanishes.
    fn extremum(&self) -> Option<Extremum> {
        let [value, _, bend] = self.f;
        let kind = if bend < 0.0 { Kind::Max } else { Kind::Min };
        (bend != 0.0).then_some(Extremum {
            kind,
            input: self.crank,
            value,
        })
    }
}

/// The grid of each arc: even, and graded towards the inputs that `in_line` gives within it. A full cycle is
/// taken around 0, beside which numbers lie closest.
fn stretches(
    cycle: &Cycle,
    in_line: &dyn Fn([f64; 2]) -> Vec<f64>,
) -> Result<Vec<Vec<f64>>, TooManyTurns> {
    searchable(cycle)?;
    let graded = |[from, to]: [f64; 2]| {
        // A driven slide's way has no turns: it is one cell grid long.
        let whole = if cycle.turns() { TAU } else { to - from };
        let cell = whole / GRID as f64;
        // An even count: the start of a full cycle, in the middle, is a sample.
        let count = 2.0 * (0.5 * (to - from) / cell).ceil();
        let mut cranks: Vec<f64> = (0..=count as usize)
            .map(|i| from + (to - from) * (i as f64 / count))
            .collect();
        for input in in_line([from, to]) {
            for grade in 0..GRADES {
                let step = cell * 0.5_f64.powi(grade);
                cranks.extend([input - step, input + step]);
            }
        }
        cranks.retain(|crank| (from..=to).contains(crank));
        sort_by(&mut cranks, f64::total_cmp);
        cranks.dedup();
        cranks
    };
    if cycle.is_full() {
        let [start, end] = cycle.axis();
        let half = 0.5 * (end - start);
        return Ok(vec![graded([start - half, start + half])]);
    }
    Ok(cycle.arcs().iter().copied().map(graded).collect())
}

/// Whether a cycle has no more turns than are searched. An arc of a motion to and fro has as many as were followed.
fn searchable(cycle: &Cycle) -> Result<(), TooManyTurns> {
    let [start, end] = cycle.axis();
    let turns = ((end - start) / TAU).round() as usize;
    if cycle.is_full() && turns > MOST_TURNS {
        return Err(TooManyTurns {
            turns,
            most: MOST_TURNS,
        });
    }
    Ok(())
}

/// Roots of the derivative `order` between two neighbouring samples: none, one
/// where it changes its sign, two where it turns within the cell and passes zero
/// there and back.
fn roots(
    sample: &dyn Fn(f64) -> Option<Sample>,
    order: usize,
    a: Sample,
    b: Sample,
) -> Vec<Sample> {
    let [slope, bend] = [0, 1].map(|k| move |s: &Sample| s.f[order + k]);
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
    sample: &dyn Fn(f64) -> Option<Sample>,
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
    // A jump has no place where `f` is small: it is where the sign changes.
    let off = best.crank < low.crank || best.crank > high.crank;
    let nearer = if f(&low).abs() < f(&high).abs() {
        low
    } else {
        high
    };
    Some(if off { nearer } else { best })
}
