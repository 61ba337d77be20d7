//! Zeros and extrema of quantities over a motion, to full precision.

mod extremum;
mod roots;
mod samples;

pub use extremum::{Extremum, Kind};

use super::{InputRate, Motion};
use crate::mechanism::{Pose, Quantity, half_turns};
use crate::sorting::extremes;
use crate::{Cycle, Jet, tolerance};
use roots::ordered_roots;
use samples::{Sample, Samples, closed, grids, searchable};

/// Zeros and extrema of a quantity over a motion, in ascending order of input.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Features {
    /// Inputs of the zeros.
    pub zeros: Vec<f64>,
    /// Local extrema of the quantity.
    pub extrema: Vec<Extremum>,
    /// Value of a constant quantity; 0 if the value differs from 0 only by rounding. None if the quantity varies.
    pub level: Option<f64>,
}

impl Features {
    /// Features of the quantity multiplied by a ratio.
    pub fn scaled(&self, ratio: f64) -> Self {
        Self {
            zeros: self.zeros.clone(),
            extrema: self.extrema.iter().map(|e| e.scaled(ratio)).collect(),
            level: self.level.map(|level| ratio * level),
        }
    }
}

/// Maximum number of samples held at once, for all quantities together: about ten megabytes.
const MAX_SAMPLES: usize = 1 << 18;

/// Error: the motion repeats only after more turns than are searched for zeros and extrema.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooManyTurns {
    /// Number of turns of the crank after which the motion repeats.
    pub turns: usize,
    /// Maximum number of turns searched.
    pub most: usize,
}

impl Motion {
    /// Zeros and extrema of quantities and of their first two derivatives with respect to time, by [`features`].
    /// Quantities that are multiples of one another are searched once. Kinks of folded angles do not count as
    /// extrema, nor jumps of their rates as zeros.
    ///
    /// # Errors
    /// The motion has too many turns to be searched.
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
        let grids = self.grids()?;
        let samples: usize = grids.iter().map(Vec::len).sum();
        let at_once = (MAX_SAMPLES / samples.max(1)).max(1);
        let found = bases.chunks(at_once).flat_map(|bases| {
            let units: Vec<f64> = bases.iter().map(|base| self.unit(*base)).collect();
            let jets = self.telling(|pose: &Pose<5>| {
                let bases = bases.iter();
                bases.map(|base| base.unfolded(mechanism, pose)).collect()
            });
            let jets = |input: f64| -> Option<Vec<Jet<5>>> { jets(input).ok() };
            let found = features_over(&grids, self.cycle(), &jets, &units, input);
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

    fn grids(&self) -> Result<Vec<Vec<f64>>, TooManyTurns> {
        grids(self.cycle(), &|arc| self.mechanism().in_line(arc))
    }

    /// Checks that zeros and extrema can be searched.
    ///
    /// # Errors
    /// The motion has too many turns to be searched.
    pub fn searchable(&self) -> Result<(), TooManyTurns> {
        searchable(self.cycle())
    }

    /// Scale of tolerances for a quantity: 1 for an angle, and the size of the mechanism for a coordinate. The points
    /// of a distance may be in a small part of the drawing, so the scale of a distance is the minimum of
    /// [`Self::unit_within`].
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

    /// Scale of tolerances for lengths within a part of the drawing: the size of the part, but at least a thousandth of
    /// the drawing's size. The tolerance, 10⁻⁹ of the scale, is then not below the rounding error of points, which is
    /// 10⁻¹² of the drawing's size.
    pub(super) fn unit_within(&self, part: f64) -> f64 {
        part.max(1e-3 * self.mechanism().size())
    }

    /// Features of a folded angle and of its two derivatives, from those of the unfolded angle. Folding may turn a
    /// maximum into a minimum and vice versa. Zeros of the angle itself are dropped, because the folded angle has a
    /// kink there.
    fn folded(&self, quantity: Quantity, found: [Features; 3]) -> [Features; 3] {
        let with_sense = |extremum: Extremum| {
            let pose = self.pose::<3>(extremum.input);
            debug_assert!(pose.is_ok(), "an extremum is found in a pose");
            let angle = quantity.unfolded(self.mechanism(), &pose.ok()?);
            Some(extremum.scaled(quantity.sense(&angle)))
        };
        // While two links turn as one, rounding makes the angle between them cross zero several times.
        let coincide = |one: f64, other: f64| (one - other).abs() < tolerance::COINCIDENT;
        let [value, first, second] = found.map(|mut order| {
            order.zeros.dedup_by(|one, other| coincide(*one, *other));
            order
                .extrema
                .dedup_by(|one, other| one.kind == other.kind && coincide(one.input, other.input));
            order.extrema = order.extrema.into_iter().filter_map(with_sense).collect();
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

    /// Quantity of which a given quantity is a multiple, and the factor. The zeros of an angle with an offset are not
    /// those of the other angle, so such an angle counts as a multiple of itself only.
    fn multiple(&self, quantity: Quantity) -> (Quantity, f64) {
        let Quantity::Angle(link) = quantity else {
            return (quantity, 1.0);
        };
        let multiple = self.mechanism().multiple_of(link);
        if multiple.offset.abs() < tolerance::NEGLIGIBLE {
            (Quantity::Angle(multiple.of), multiple.factor)
        } else {
            (quantity, 1.0)
        }
    }
}

/// Finds zeros and extrema of quantities and of their first two derivatives with respect to time over a cycle. `motion`
/// gives the quantities at a crank angle φ₁, measured from the line of the frame. `units` gives the scale of tolerances
/// for each quantity: 1 for an angle, a length of the mechanism for a coordinate.
///
/// Each zero or extremum is a root of the quantity or of its next derivative, found by safeguarded Newton steps with
/// exact derivatives. A constant quantity has a level instead.
///
/// # Errors
/// The cycle has too many turns to be searched.
pub fn features(
    cycle: &Cycle,
    motion: &dyn Fn(f64) -> Option<Vec<Jet<5>>>,
    units: &[f64],
    input: InputRate,
) -> Result<Vec<[Features; 3]>, TooManyTurns> {
    let grids = grids(cycle, &|arc| half_turns(0.0, arc).collect())?;
    Ok(features_over(&grids, cycle, motion, units, input))
}

/// Finds [`features`] from samples at the inputs of each grid.
fn features_over(
    grids: &[Vec<f64>],
    cycle: &Cycle,
    motion: &dyn Fn(f64) -> Option<Vec<Jet<5>>>,
    units: &[f64],
    rate: InputRate,
) -> Vec<[Features; 3]> {
    let at = |input: &f64| Some((*input, motion(*input)?));
    let poses = grids.iter().map(|grid| grid.iter().map(at).collect());
    let poses: Vec<Vec<_>> = poses.collect();
    let of = |index: usize, order: usize| {
        let sample = |(input, jets): &(f64, Vec<Jet<5>>)| Sample {
            input: *input,
            f: rate.rates(&jets[index], order),
        };
        let at = |input: f64| Some(sample(&(input, motion(input)?)));
        let arcs = poses.iter().map(|poses| {
            let samples = poses.iter().map(|pose| pose.as_ref().map(sample)).collect();
            closed(cycle, samples, order, &at)
        });
        let arcs: Vec<Samples> = arcs.collect();
        let scale = units[index] * (rate.scale(order).abs() + rate.acceleration.abs());
        features_of(cycle, &arcs, &at, Tolerance::of(order, scale))
    };
    (0..units.len())
        .map(|index| [0, 1, 2].map(|order| of(index, order)))
        .collect()
}

/// Extrema of one quantity, from its first two derivatives.
///
/// # Errors
/// The motion has too many turns to be searched.
pub(super) fn turning_points(
    motion: &Motion,
    quantity: &dyn Fn(f64) -> Option<Jet<3>>,
    unit: f64,
) -> Result<Vec<Extremum>, TooManyTurns> {
    let cycle = motion.cycle();
    let sample = |input: f64| {
        let jet = quantity(input)?;
        let f = [0, 1, 2].map(|order| jet.derivative(order));
        Some(Sample { input, f })
    };
    let arcs = motion.grids()?.into_iter().map(|grid| {
        let samples = grid.into_iter().map(sample).collect();
        closed(cycle, samples, 0, &sample)
    });
    let arcs: Vec<Samples> = arcs.collect();
    let Variation::Varies = variation(&arcs, Tolerance::of(0, unit)) else {
        return Ok(Vec::new());
    };
    let turns = ordered_roots(cycle, &arcs, &sample, 1);
    Ok(turns.iter().filter_map(Sample::extremum).collect())
}

/// Zeros and extrema of one function of the input, from samples of the whole motion.
fn features_of(
    cycle: &Cycle,
    arcs: &[Samples],
    sample: &dyn Fn(f64) -> Option<Sample>,
    tolerance: Tolerance,
) -> Features {
    if let Variation::Constant(level) = variation(arcs, tolerance) {
        return Features {
            level,
            ..Features::default()
        };
    }
    let [zeros, turns] = [0, 1].map(|order| ordered_roots(cycle, arcs, sample, order));
    Features {
        zeros: zeros.iter().map(|sample| sample.input).collect(),
        extrema: turns.iter().filter_map(Sample::extremum).collect(),
        level: None,
    }
}

/// Variation of a function over the motion.
enum Variation {
    Varies,
    /// Constant value; None if there are no samples.
    Constant(Option<f64>),
}

/// Maximum variation of a function that counts as constant.
#[derive(Clone, Copy)]
struct Tolerance {
    absolute: f64,
    /// Tolerance as a fraction of the function's largest absolute value.
    relative: f64,
}

impl Tolerance {
    /// Tolerance of a quantity (order 0) or of its derivative, for a scale of the quantity. The relative tolerance is
    /// needed because the rounding error of a point grows with its distance from the origin.
    fn of(order: usize, scale: f64) -> Self {
        Self {
            absolute: tolerance::COINCIDENT * scale,
            relative: if order == 0 {
                tolerance::CONVERGED
            } else {
                tolerance::COINCIDENT
            },
        }
    }
}

fn variation(arcs: &[Samples], tolerance: Tolerance) -> Variation {
    let values = arcs.iter().flatten().flatten().map(|s| s.f[0]);
    let [least, most] = extremes(values);
    let largest = least.abs().max(most.abs());
    let rounding = tolerance.absolute.max(tolerance.relative * largest);
    if most - least > rounding {
        return Variation::Varies;
    }
    let value = if largest > rounding {
        least.midpoint(most)
    } else {
        0.0
    };
    Variation::Constant((least <= most).then_some(value))
}
