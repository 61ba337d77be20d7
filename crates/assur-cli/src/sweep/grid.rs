//! At which inputs a table has its rows.

use assur::motion::Motion;

use super::Asked;
use crate::Failure;
use crate::words::short;

/// No more rows are written.
const MOST_ROWS: f64 = 1e7;
/// Steps of a driven slide's range, if none are asked for.
const STEPS: f64 = 360.0;
/// Inputs nearer to each other, in steps, are one.
const NEAR: f64 = 1e-9;
/// No input that is asked for is greater: of an angle so large too few digits are left.
const GREATEST_ANGLE: f64 = 1e9;
const GREATEST_LENGTH: f64 = 1e30;
/// No speed or acceleration is greater.
const GREATEST_RATE: f64 = 1e9;

/// The input of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct At {
    /// As it is written: degrees of a crank, else in the unit of the lengths.
    pub(super) written: f64,
    /// As the engine has it.
    pub(super) input: f64,
}

impl At {
    fn written(written: f64, turns: bool) -> Self {
        let input = if turns { written.to_radians() } else { written };
        Self { written, input }
    }

    fn asked(option: &str, value: f64, turns: bool) -> Result<Self, Failure> {
        let greatest = if turns {
            GREATEST_ANGLE
        } else {
            GREATEST_LENGTH
        };
        Ok(Self::written(within(option, value, greatest)?, turns))
    }

    fn of(input: f64, turns: bool) -> Self {
        let written = if turns {
            decimal(input.to_degrees())
        } else {
            input
        };
        Self { written, input }
    }
}

/// The inputs of a table: those that are asked for by `--at`; else multiples of the step within the motion or
/// within what is asked for, with the ends of the motion where it turns back.
///
/// # Errors
/// A number that is none; a step or a stretch with too many rows or none.
pub(super) fn inputs(
    motion: &Motion,
    asked: &Asked,
) -> Result<Box<dyn Iterator<Item = At>>, Failure> {
    let turns = motion.mechanism().turns();
    if !asked.at.is_empty() {
        let all = asked.at.iter();
        let all = all.map(|at| At::asked("--at", *at, turns));
        let all = all.collect::<Result<Vec<_>, Failure>>()?;
        return Ok(Box::new(all.into_iter()));
    }
    let stretches = stretches(motion, asked)?;
    let cycle = motion.cycle();
    let mut ends: Vec<At> = Vec::new();
    if !cycle.is_full() {
        ends.extend(cycle.arcs().iter().flatten().map(|end| At::of(*end, turns)));
    }
    let whole: f64 = stretches.iter().map(Stretch::width).sum();
    let [start, end] = cycle.axis();
    let usual = if turns { 1.0 } else { (end - start) / STEPS };
    let step = asked.step.unwrap_or(usual);
    if !(step > 0.0 && step.is_finite()) {
        return refuse(format!(
            "--step {step}: a step is a number greater than zero"
        ));
    }
    if whole / step > MOST_ROWS {
        return refuse(format!(
            "--step {}: that makes more than {MOST_ROWS} rows",
            short(step)
        ));
    }
    // Round numbers, unless it is said where to begin; a slide's range has none of its own.
    let origin = match asked.from {
        Some(from) => from,
        None if turns => 0.0,
        None => start,
    };
    let grid = Grid {
        origin,
        step,
        turns,
    };
    let rows = stretches
        .into_iter()
        .flat_map(move |stretch| grid.rows(stretch, &ends));
    Ok(Box::new(rows))
}

/// What is asked for, else the arcs of the motion.
fn stretches(motion: &Motion, asked: &Asked) -> Result<Vec<Stretch>, Failure> {
    let turns = motion.mechanism().turns();
    let arcs = motion.cycle().arcs().iter();
    let arcs: Vec<Stretch> = arcs
        .map(|arc| Stretch(arc.map(|end| At::of(end, turns))))
        .collect();
    let [Some(first), Some(last)] = [arcs.first(), arcs.last()] else {
        return Ok(arcs);
    };
    let given = |option: &str, value: Option<f64>| {
        let at = value.map(|value| At::asked(option, value, turns));
        at.transpose()
    };
    let [from, to] = [given("--from", asked.from)?, given("--to", asked.to)?];
    if from.is_none() && to.is_none() {
        return Ok(arcs);
    }
    let [from, to] = [from.unwrap_or(first.0[0]), to.unwrap_or(last.0[1])];
    if from.written > to.written {
        let [from, to] = [from.written, to.written];
        return refuse(format!(
            "nothing is from {from} to {to}: --to is the greater one"
        ));
    }
    Ok(vec![Stretch([from, to])])
}

/// Rows from here to there.
#[derive(Clone, Copy)]
struct Stretch([At; 2]);

impl Stretch {
    fn width(&self) -> f64 {
        self.0[1].written - self.0[0].written
    }
}

/// Where rows stand.
#[derive(Clone, Copy)]
struct Grid {
    origin: f64,
    step: f64,
    turns: bool,
}

impl Grid {
    /// The multiples of the step and those of the ends that are within, ascending.
    fn rows(
        self,
        Stretch([first, last]): Stretch,
        ends: &[At],
    ) -> impl Iterator<Item = At> + use<> {
        let Self {
            origin,
            step,
            turns,
        } = self;
        let within = |end: &&At| (first.input..=last.input).contains(&end.input);
        let ends: Vec<At> = ends.iter().filter(within).copied().collect();
        let index = |at: At| (at.written - origin) / step;
        let [low, high] = [(index(first) - NEAR).ceil(), (index(last) + NEAR).floor()];
        let count = (high - low + 1.0).max(0.0) as u64;
        let beside: Vec<f64> = ends.iter().map(|end| index(*end)).collect();
        let rows = (0..count).map(move |k| low + k as f64);
        let rows = rows.filter(move |k| beside.iter().all(|end| (end - k).abs() > NEAR));
        let rows = rows.map(move |k| {
            let At { written, input } = At::written(decimal(origin + decimal(k * step)), turns);
            At {
                written: written.max(first.written).min(last.written),
                input: input.max(first.input).min(last.input),
            }
        });
        merged(rows, ends)
    }
}

/// Both in one, ascending.
fn merged(rows: impl Iterator<Item = At>, ends: Vec<At>) -> impl Iterator<Item = At> {
    let mut rows = rows.peekable();
    let mut ends = ends.into_iter().peekable();
    std::iter::from_fn(move || match (rows.peek(), ends.peek()) {
        (Some(row), Some(end)) if row.input < end.input => rows.next(),
        (_, Some(_)) => ends.next(),
        (_, None) => rows.next(),
    })
}

/// A speed or an acceleration that is asked for.
///
/// # Errors
/// No number, or one too great.
pub(super) fn rate(option: &str, value: f64) -> Result<f64, Failure> {
    within(option, value, GREATEST_RATE)
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

/// A multiple of a decimal step as it is written: 3 × 0.1 is 0.3.
fn decimal(value: f64) -> f64 {
    let rounded = (value * 1e9).round() / 1e9;
    if (rounded - value).abs() <= 1e-14 * value.abs() {
        rounded
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_of_decimal_steps_are_as_they_are_written() {
        assert_eq!(decimal(3.0 * 0.1), 0.3);
        assert_eq!(decimal(89.99999999999999), 90.0);
        assert_eq!(decimal(89.999999999), 89.999999999);
    }

    #[test]
    fn a_grid_with_its_ends() {
        let grid = |origin, step| Grid {
            origin,
            step,
            turns: false,
        };
        let rows = |grid: Grid, from, to, ends: &[f64]| -> Vec<f64> {
            let stretch = Stretch([from, to].map(|end| At::of(end, false)));
            let ends: Vec<At> = ends.iter().map(|end| At::of(*end, false)).collect();
            grid.rows(stretch, &ends).map(|at| at.input).collect()
        };
        let none: &[f64] = &[];
        assert_eq!(rows(grid(0.0, 7.0), 0.0, 20.0, none), [0.0, 7.0, 14.0]);
        assert_eq!(
            rows(grid(0.0, 10.0), -12.5, 15.0, &[-12.5, 15.0]),
            [-12.5, -10.0, 0.0, 10.0, 15.0]
        );
        // An end on the grid is one row, as the engine has it.
        let near = 20.0 - 1e-12;
        assert_eq!(
            rows(grid(0.0, 10.0), 0.0, near, &[0.0, near]),
            [0.0, 10.0, near]
        );
        // Ends outside are none, those between are rows too.
        assert_eq!(
            rows(grid(1.5, 1.0), 1.5, 4.0, &[-3.0, 2.25, 5.0]),
            [1.5, 2.25, 2.5, 3.5]
        );
        assert_eq!(rows(grid(0.0, 10.0), 11.0, 19.0, none), none);
    }
}
