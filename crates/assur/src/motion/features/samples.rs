//! Samples of a function over a cycle, from which its roots are bracketed.

use std::f64::consts::TAU;

use super::{Extremum, Kind, TooManyTurns};
use crate::Cycle;
use crate::motion::{MAX_TURNS, SAMPLES_PER_TURN};
use crate::sorting::sort_by;

/// A function and its first two derivatives with respect to the input, at one input.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub(super) input: f64,
    pub(super) f: [f64; 3],
}

/// Samples over an arc; None at an input without a pose.
pub(super) type Samples = Vec<Option<Sample>>;

impl Sample {
    /// Extremum at this sample, which is a stationary point; None if the second derivative is zero.
    pub(super) fn extremum(&self) -> Option<Extremum> {
        let [value, _, second] = self.f;
        let kind = if second < 0.0 { Kind::Max } else { Kind::Min };
        (second != 0.0).then_some(Extremum {
            kind,
            input: self.input,
            value,
        })
    }
}

/// Sample inputs of each arc: evenly spaced, and denser towards the inputs that `in_line` returns, at which the crank
/// is in line with the outer hinges of a dyad. The motion may change abruptly there, if a change point is near or the
/// hinges nearly meet. A full cycle is centred on input 0, near which floating-point numbers are densest.
pub(super) fn grids(
    cycle: &Cycle,
    in_line: &dyn Fn([f64; 2]) -> Vec<f64>,
) -> Result<Vec<Vec<f64>>, TooManyTurns> {
    searchable(cycle)?;
    let graded = |[from, to]: [f64; 2]| {
        // The range of a driven slide counts as one turn.
        let turn = if cycle.turns() { TAU } else { to - from };
        let cell = turn / SAMPLES_PER_TURN as f64;
        // An even count puts a sample in the middle, which is the start of a full cycle.
        let count = 2.0 * (0.5 * (to - from) / cell).ceil();
        let mut inputs: Vec<f64> = (0..=count as usize)
            .map(|i| from + (to - from) * (i as f64 / count))
            .collect();
        for centre in in_line([from, to]) {
            for grade in 0..52 {
                let offset = cell * 0.5_f64.powi(grade);
                inputs.extend([centre - offset, centre + offset]);
            }
        }
        inputs.retain(|input| (from..=to).contains(input));
        sort_by(&mut inputs, f64::total_cmp);
        inputs.dedup();
        inputs
    };
    if cycle.is_full() {
        let [start, end] = cycle.axis();
        let half = 0.5 * (end - start);
        return Ok(vec![graded([start - half, start + half])]);
    }
    Ok(cycle.arcs().iter().copied().map(graded).collect())
}

/// Refuses a full cycle with too many turns to be searched. A motion that turns back may have any number of turns.
pub(super) fn searchable(cycle: &Cycle) -> Result<(), TooManyTurns> {
    let [start, end] = cycle.axis();
    let turns = ((end - start) / TAU).round() as usize;
    if cycle.is_full() && turns > MAX_TURNS {
        return Err(TooManyTurns {
            turns,
            most: MAX_TURNS,
        });
    }
    Ok(())
}

/// Closes the samples of a full cycle; other samples are returned unchanged. The given samples run from half a cycle
/// before the start of the cycle to half a cycle after it. The samples of a derivative (`order` above 0) keep their
/// inputs, and the last takes the values of the first. For the function itself, the samples before the start are moved
/// one cycle later, and a sample is added at the end of the cycle. If the function grows over a cycle, as the angle of
/// a turning link does, its growth is added to the moved samples.
pub(super) fn closed(
    cycle: &Cycle,
    mut samples: Samples,
    order: usize,
    at: &dyn Fn(f64) -> Option<Sample>,
) -> Samples {
    if !cycle.is_full() {
        return samples;
    }
    if order > 0 {
        if let [Some(first), .., Some(last)] = &mut samples[..] {
            last.f = first.f;
        }
        return samples;
    }
    let [start, end] = cycle.axis();
    // The first and the last sample are one cycle apart, so the first is dropped.
    let samples = samples.get(1..).unwrap_or_default();
    // An input at which a kite is indeterminate has no pose; the next sample is then taken.
    let growth = (samples.iter().flatten())
        .take_while(|sample| sample.input < start)
        .find_map(|sample| Some(at(sample.input + (end - start))?.f[0] - sample.f[0]));
    let a_cycle_later = |mut sample: Sample| {
        sample.input += end - start;
        sample.f[0] += growth?;
        Some(sample)
    };
    let middle = samples
        .iter()
        .position(|sample| sample.is_some_and(|sample| sample.input >= start));
    // If no sample is at or after the start, all samples are before it.
    let (before, after) = samples.split_at(middle.unwrap_or(samples.len()));
    let moved = before.iter().map(|sample| sample.and_then(a_cycle_later));
    // The value at the end is computed, not shifted by the growth: samples before the start may have been wrapped to
    // the end of the cycle, and the growth is then zero.
    let closing = after.first().map(|first| {
        let first = (*first)?;
        let input = first.input + (end - start);
        let [_, slope, second] = first.f;
        let f = [at(input)?.f[0], slope, second];
        Some(Sample { input, f })
    });
    after.iter().copied().chain(moved).chain(closing).collect()
}
