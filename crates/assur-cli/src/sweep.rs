//! The table of a motion as CSV.

use std::io::Write;

use assur::motion::{Column, Motion};
use assur_file::LinkageProblem;

use crate::Failure;
use crate::words::Words;

/// No more rows are written.
const MOST_ROWS: f64 = 1e7;
/// Steps of a driven slide's range, if none are asked for.
const STEPS: f64 = 360.0;

/// Writes the table.
///
/// # Errors
/// A step that is none; what cannot be written.
pub(crate) fn write(
    out: &mut impl Write,
    motion: &Motion,
    step: Option<f64>,
) -> Result<(), Failure> {
    let mechanism = motion.mechanism();
    let turns = mechanism.turns();
    let [start, end] = if turns {
        [0.0, 360.0]
    } else {
        motion.cycle().axis()
    };
    let step = step.unwrap_or(if turns { 1.0 } else { (end - start) / STEPS });
    let rows = ((end - start) / step * (1.0 + 1e-12)).floor();
    if !(step > 0.0 && rows <= MOST_ROWS) {
        let said = format!("--step {step}: a step is greater than zero, and not that small");
        return Err(Failure::Input(said));
    }
    let columns = Column::all(mechanism);
    let names = columns.iter().map(|column| column.name(mechanism));
    let first = if turns { "phi_deg" } else { "s" };
    let header = [first.to_owned()].into_iter().chain(names);
    line(out, header.chain(["reason".to_owned()]))?;
    let words = Words::english()?;
    for k in 0..=rows as u64 {
        let at = (start + decimal(k as f64 * step)).min(end);
        let input = if turns { at.to_radians() } else { at };
        let row = motion.row(&columns, input);
        let values = row.values.iter();
        let values = values.map(|value| value.map(number).unwrap_or_default());
        let reason = row
            .reason
            .map(|unsolved| words.sentence(&LinkageProblem::unsolved(&unsolved, mechanism).into()));
        let cells = [number(at)].into_iter().chain(values);
        line(out, cells.chain([reason.transpose()?.unwrap_or_default()]))?;
    }
    Ok(())
}

/// One line, cells quoted where they must be.
fn line(out: &mut impl Write, cells: impl Iterator<Item = String>) -> Result<(), Failure> {
    for (k, cell) in cells.enumerate() {
        if k > 0 {
            out.write_all(b",")?;
        }
        if cell.contains(['"', ',', '\n', '\r']) {
            write!(out, "\"{}\"", cell.replace('"', "\"\""))?;
        } else {
            out.write_all(cell.as_bytes())?;
        }
    }
    out.write_all(b"\n")?;
    Ok(())
}

/// The shortest text that reads back as the same number.
fn number(value: f64) -> String {
    let value = value + 0.0;
    if value == 0.0 || (1e-5..1e16).contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
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
    fn cells_are_quoted() {
        let mut out = Vec::new();
        let cells = ["plain", "a, b", "\"c\"", ""].map(str::to_owned);
        line(&mut out, cells.into_iter()).unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "plain,\"a, b\",\"\"\"c\"\"\",\n"
        );
    }

    #[test]
    fn numbers_read_back() {
        for value in [
            0.1 + 0.2,
            1.0 / 3.0,
            -1e-17,
            6.02e23,
            360.0,
            f64::MIN_POSITIVE,
        ] {
            assert_eq!(number(value).parse::<f64>().unwrap(), value);
        }
        assert_eq!([-0.0, 5.0, 1e-17].map(number), ["0", "5", "1e-17"]);
        assert_eq!(decimal(3.0 * 0.1), 0.3);
    }
}
