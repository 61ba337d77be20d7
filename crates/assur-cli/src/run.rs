//! Tables of the motion under load over time.

use std::io::Write;

use assur::forces::{Blocked, Halt, LagrangeRun, Loading, Run};
use assur::mechanism::DriverSpec;
use assur::motion::Motion;
use assur_file::{LinkageDocument, LinkageProblem};
use clap::Args;

use crate::csv::{Cell, Csv};
use crate::source::{Moved, Name};
use crate::sweep::{asked_for, rate};
use crate::words::{Words, number};
use crate::{Failure, source};

/// Maximum number of rows of a motion under load.
const MAX_ROWS: f64 = 1e7;

/// Names of the last columns of every table.
const ENERGIES: [&str; 4] = ["kinetic", "potential", "work", "lost"];

/// Greatest time of a run, seconds.
const MAX_TIME: f64 = 1e6;

/// Arguments of `assur run`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Catalogue name or file.
    name: Name,
    /// Time at which the table ends, seconds
    #[arg(long, value_parser = number, value_name = "T")]
    until: f64,
    /// Interval between rows, seconds [default: a hundredth of the time]
    #[arg(long, value_parser = number, value_name = "T")]
    every: Option<f64>,
    /// Input at the start: degrees, or a length for a driven slide [default: that of the drawing]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Rate of the input at the start, rad/s, or length/s for a slide [default: the initial rate of the file, or 0]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    omega: Option<f64>,
    /// Decimal comma (0,5 for 0.5), with semicolons between cells
    #[arg(long)]
    decimal_comma: bool,
}

/// A run of one freedom, or of several.
enum Running {
    One(Box<Run>),
    Several(Box<LagrangeRun>, Vec<f64>),
}

/// Writes the table of a motion under load. If the motion ends before, its last row is at its end, and
/// standard error says so.
///
/// # Errors
/// A document that is not a mechanism, whose forces are invalid or that cannot be run; an invalid number; output that
/// cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let Moved { document, motion } = source::moved(&asked.name)?;
    let mechanism = motion.mechanism();
    let loading = document.loading(mechanism);
    let loading = loading.map_err(|problems| source::refused(&asked.name, &problems))?;
    let every = asked.every.unwrap_or_else(|| {
        let digits = decimals(asked.until) + 2;
        rounded(asked.until / 100.0, digits)
    });
    if !(asked.until > 0.0
        && asked.until <= MAX_TIME
        && every > 0.0
        && asked.until / every <= MAX_ROWS)
    {
        let said = format!(
            "--until and --every: give times greater than zero, at most {MAX_TIME} s and {MAX_ROWS} rows"
        );
        return Err(Failure::Input(said));
    }
    let from = asked
        .from
        .map(|from| asked_for("--from", from, mechanism.turns()));
    let from = from
        .transpose()?
        .map_or(motion.drawn_input(), |at| at.input);
    let speed = rate(
        "--omega",
        asked.omega.or(document.initial_rate).unwrap_or(0.0),
    )?;
    let running = Running::new(&document, &motion, &loading, [from, speed]);
    let mut running = running.map_err(|problem| source::refused(&asked.name, &[problem]))?;
    let csv = Csv {
        decimal_comma: asked.decimal_comma,
    };
    let header = running.header(&motion);
    csv.line(out, header.into_iter().map(Cell::Text))?;
    let energy = document.force_units().torque();
    let count = (asked.until / every * (1.0 + 1e-12)).floor() as usize;
    let digits = decimals(every);
    for row in 0..=count {
        let ended = running.advance(rounded(row as f64 * every, digits), &motion)?;
        let values = running.row(energy);
        csv.line(out, values.into_iter().map(Cell::Number))?;
        if let Some(said) = ended {
            // A failure to write to standard error cannot be reported.
            let _ = writeln!(std::io::stderr(), "{}: {said}", asked.name);
            break;
        }
    }
    Ok(())
}

impl Running {
    /// Begins a run from an input, at a rate of the first driver.
    fn new(
        document: &LinkageDocument,
        motion: &Motion,
        loading: &Loading,
        [from, speed]: [f64; 2],
    ) -> Result<Self, LinkageProblem> {
        let mechanism = motion.mechanism();
        let no_run = |reason| LinkageProblem::no_run(&reason, mechanism);
        if !document.is_run_by_drivers() {
            let motor = document.motor(mechanism)?;
            let run = Run::new(motion, loading, &motor, [from, speed]);
            return Ok(Self::One(Box::new(run.map_err(no_run)?)));
        }
        let (actuators, rates) = document.actuators(speed)?;
        let run = LagrangeRun::new(motion, loading, &actuators, from, &rates);
        let units = mechanism.spec().drivers.iter().map(|driver| {
            let is_crank = matches!(driver, DriverSpec::Crank { .. });
            document.force_units().drive(is_crank)
        });
        Ok(Self::Several(
            Box::new(run.map_err(no_run)?),
            units.collect(),
        ))
    }

    /// Names of the columns.
    fn header(&self, motion: &Motion) -> Vec<String> {
        let spec = motion.mechanism().spec();
        let columns: Vec<String> = match self {
            Self::One(_) => ["input", "rate", "acceleration"].map(str::to_owned).into(),
            Self::Several(..) => {
                let columns = spec.drivers.iter().flat_map(|driver| {
                    let name = spec.driven(driver).unwrap_or_default();
                    let is_crank = matches!(driver, DriverSpec::Crank { .. });
                    let drive = if is_crank { "torque" } else { "force" };
                    let parts = ["input", "rate", "acceleration", drive];
                    parts.map(|part| format!("{name}.{part}"))
                });
                columns.collect()
            }
        };
        let first = std::iter::once("t".to_owned()).chain(columns);
        first.chain(ENERGIES.map(str::to_owned)).collect()
    }

    /// Advances to a time; a sentence if the motion ends before.
    fn advance(&mut self, time: f64, motion: &Motion) -> Result<Option<String>, Failure> {
        let turns = motion.mechanism().turns();
        Ok(match self {
            Self::One(run) => run.advance(time).err().map(|halt| {
                let input = source::at(turns, run.reading().input);
                match halt {
                    Halt::End { end, .. } => {
                        let links = end.iter().flat_map(|end| motion.links_at(end));
                        let links: Vec<&str> = links.collect();
                        if links.is_empty() {
                            format!("the motion cannot be followed beyond {input}")
                        } else {
                            format!("the motion ends at {input}: {}", links.join(", "))
                        }
                    }
                    Halt::Locked { .. } => {
                        format!("the linkage locks itself by friction at {input}")
                    }
                }
            }),
            Self::Several(run, _) => match run.advance(time) {
                Ok(()) => None,
                Err(Blocked { unsolved, .. }) => {
                    let problem = LinkageProblem::unsolved(&unsolved, motion.mechanism());
                    let reason = Words::english()?.sentence(&problem)?;
                    let input = run.reading().coordinates.first().copied();
                    let input = source::at(turns, input.unwrap_or(0.0));
                    Some(format!("the motion ends at {input}: {reason}"))
                }
            },
        })
    }

    /// The values of a row; `energy` is the unit of energy.
    fn row(&mut self, energy: f64) -> Vec<f64> {
        let (mut row, energies) = match self {
            Self::One(run) => {
                let now = run.reading();
                let row = vec![now.time, now.input, now.rate, now.acceleration];
                (row, [now.kinetic, now.potential, now.work, now.lost])
            }
            Self::Several(run, units) => {
                let now = run.reading();
                let mut row = vec![now.time];
                for (index, unit) in units.iter().enumerate() {
                    row.extend([now.coordinates[index], now.rates[index]]);
                    row.extend([now.accelerations[index], now.torques[index] * unit]);
                }
                (row, [now.kinetic, now.potential, now.work, now.lost])
            }
        };
        row.extend(energies.map(|part| part * energy));
        row
    }
}

/// Number of digits after the decimal sign.
fn decimals(value: f64) -> usize {
    let text = value.to_string();
    text.split_once('.').map_or(0, |(_, digits)| digits.len())
}

/// A number rounded to digits after the decimal sign: 0.3 for 3 · 0.1.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.digits$}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_decimals_of_the_interval() {
        let times = |every: f64| [1.0, 3.0, 7.0].map(|k| rounded(k * every, decimals(every)));
        assert_eq!(times(0.1), [0.1, 0.3, 0.7]);
        assert_eq!(times(0.07), [0.07, 0.21, 0.49]);
        assert_eq!(times(2.0), [2.0, 6.0, 14.0]);
        assert_eq!(times(1e-7), [1e-7, 3e-7, 7e-7]);
        assert_eq!(rounded(0.7 / 100.0, decimals(0.7) + 2), 0.007);
    }
}
