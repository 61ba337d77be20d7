//! The inputs of the rows of a table.

use assur::motion::{At, Grid, Motion};

use super::Rows;
use crate::Failure;
use crate::words::short;

const MAX_ROWS: f64 = 1e7;
/// Default number of steps over the range of a driven slide.
const STEPS: f64 = 360.0;
/// Greatest angle accepted from the command line, degrees. Beyond it, too few digits remain for fractions of a turn.
const MAX_ANGLE: f64 = 1e9;
/// Greatest length accepted from the command line, in the unit of length of the file.
const MAX_LENGTH: f64 = 1e30;
/// Greatest speed or acceleration accepted from the command line.
const MAX_RATE: f64 = 1e9;

/// Returns the unit of inputs in tables, expressed in the engine's unit: a degree in radians, or 1 for lengths.
fn unit(turns: bool) -> f64 {
    if turns { 1_f64.to_radians() } else { 1.0 }
}

/// Checks and converts an input given by an option.
///
/// # Errors
/// The value is not a number, or is too large.
pub(crate) fn asked_for(option: &str, value: f64, turns: bool) -> Result<At, Failure> {
    let greatest = if turns { MAX_ANGLE } else { MAX_LENGTH };
    Ok(At::counted(within(option, value, greatest)?, unit(turns)))
}

/// Returns the inputs of the rows: those of `--at`, or else the multiples of the step over the
/// motion or the requested interval. Inputs at which the motion turns back are included.
///
/// # Errors
/// An invalid number; a step or an interval with too many rows or none.
pub(crate) fn inputs(
    motion: &Motion,
    asked: &Rows,
) -> Result<Box<dyn Iterator<Item = At>>, Failure> {
    let turns = motion.mechanism().turns();
    if !asked.at.is_empty() {
        let all = asked.at.iter();
        let all = all.map(|at| asked_for("--at", *at, turns));
        let all = all.collect::<Result<Vec<_>, Failure>>()?;
        return Ok(Box::new(all.into_iter()));
    }
    let stretches = stretches(motion, asked)?;
    let ends = motion.ends_in(unit(turns));
    let widths = stretches.iter();
    let whole: f64 = widths.map(|[from, to]| to.counted - from.counted).sum();
    let [start, end] = motion.cycle().axis();
    let usual = if turns { 1.0 } else { (end - start) / STEPS };
    let step = asked.step.unwrap_or(usual);
    if !(step > 0.0 && step.is_finite()) {
        return refuse(format!(
            "--step {step}: a step is a number greater than zero"
        ));
    }
    if whole / step > MAX_ROWS {
        return refuse(format!(
            "--step {}: that makes more than {MAX_ROWS} rows",
            short(step)
        ));
    }
    // Without `--from`, crank angles are multiples of the step, and inputs of a slide begin at the start of its range.
    let origin = match asked.from {
        Some(from) => from,
        None if turns => 0.0,
        None => start,
    };
    let grid = Grid {
        unit: unit(turns),
        origin,
        step,
    };
    let rows = stretches
        .into_iter()
        .flat_map(move |stretch| grid.rows(stretch, &ends));
    Ok(Box::new(rows))
}

/// Returns the first input of `--at`, or else that of `--from`, if given.
///
/// # Errors
/// An invalid number.
pub(super) fn first(motion: &Motion, asked: &Rows) -> Result<Option<f64>, Failure> {
    let turns = motion.mechanism().turns();
    let first = match (asked.at.first(), asked.from) {
        (Some(at), _) => Some(asked_for("--at", *at, turns)?),
        (None, Some(from)) => Some(asked_for("--from", from, turns)?),
        (None, None) => None,
    };
    Ok(first.map(|first| first.input))
}

/// Returns the interval from `--from` to `--to`, or else the arcs of the motion.
fn stretches(motion: &Motion, asked: &Rows) -> Result<Vec<[At; 2]>, Failure> {
    let turns = motion.mechanism().turns();
    let arcs = motion.arcs_in(unit(turns));
    let [Some(first), Some(last)] = [arcs.first(), arcs.last()] else {
        return Ok(arcs);
    };
    let given = |option: &str, value: Option<f64>| {
        let at = value.map(|value| asked_for(option, value, turns));
        at.transpose()
    };
    let [from, to] = [given("--from", asked.from)?, given("--to", asked.to)?];
    if from.is_none() && to.is_none() {
        return Ok(arcs);
    }
    let [from, to] = [from.unwrap_or(first[0]), to.unwrap_or(last[1])];
    if from.counted > to.counted {
        let [from, to] = [from.counted, to.counted];
        return refuse(format!(
            "nothing is from {from} to {to}: --to is the greater one"
        ));
    }
    Ok(vec![[from, to]])
}

/// Checks a speed or an acceleration given by an option.
///
/// # Errors
/// The value is not a number, or is too large.
pub(crate) fn rate(option: &str, value: f64) -> Result<f64, Failure> {
    within(option, value, MAX_RATE)
}

fn within(option: &str, value: f64, greatest: f64) -> Result<f64, Failure> {
    if value.abs() <= greatest {
        Ok(value)
    } else {
        refuse(format!(
            "{option} {}: give a number from -{greatest:e} to {greatest:e}",
            short(value)
        ))
    }
}

fn refuse<T>(said: String) -> Result<T, Failure> {
    Err(Failure::Input(said))
}
