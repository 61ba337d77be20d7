//! The steady cycle under load, and the flywheel for a wanted non-uniformity.

use std::io::Write;

use assur::forces::{Diagram, Loading, MAX_NON_UNIFORMITY, Motor, NoCycle, SteadyCycle};
use assur_file::LinkageProblem;
use clap::Args;
use serde_json::{Value, json};

use crate::csv::{Cell, Csv};
use crate::source::{Moved, Name};
use crate::sweep::rate;
use crate::words::{Words, number};
use crate::{Failure, source};

/// Arguments of `assur cycle`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Catalogue name or file.
    name: Name,
    /// Rate of the crank near which the cycle is sought, rad/s; without a motor, its mean [default: the initial rate of
    /// the file]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    omega: Option<f64>,
    /// Coefficient of non-uniformity for which a flywheel is sought
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    delta: Option<f64>,
    /// Prints JSON.
    #[arg(long)]
    json: bool,
    /// Decimal comma (0,5 for 0.5), with semicolons between cells
    #[arg(long, conflicts_with = "json")]
    decimal_comma: bool,
}

/// Names of the columns after the method.
const COLUMNS: [&str; 7] = [
    "flywheel", "delta", "mean", "least", "greatest", "torque", "period",
];

/// Writes the table of cycles: with the flywheel of the file and, for a wanted non-uniformity, with one of each method.
///
/// # Errors
/// A document that is not a mechanism, whose forces are invalid or that has no steady cycle; an invalid number; output
/// that cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let Moved { document, motion } = source::moved(&asked.name)?;
    let mechanism = motion.mechanism();
    let one = |problem: LinkageProblem| source::refused(&asked.name, &[problem]);
    let loading = document.loading(mechanism);
    let loading = loading.map_err(|problems| source::refused(&asked.name, &problems))?;
    let motor = document.motor(mechanism).map_err(one)?;
    let motor: Option<&Motor> = document.motor.as_ref().map(|_| &motor);
    let speed = asked.omega.or(document.initial_rate).unwrap_or(0.0);
    let speed = rate("--omega", speed)?;
    let problem = |reason: &NoCycle| LinkageProblem::no_cycle(reason, mechanism);
    let none = |reason: NoCycle| one(problem(&reason));
    let unit = document.force_units().torque();

    let mut wheels = vec![("given", loading.flywheel())];
    if let Some(delta) = asked.delta {
        if !loading.bears_flywheel() {
            return Err(one(LinkageProblem::FlywheelNoCrank));
        }
        let mut diagram = Diagram::new(&motion, &loading, motor, speed).map_err(none)?;
        let found = diagram.wittenbauer(delta).zip(diagram.mertsalov(delta));
        let (wittenbauer, mertsalov) = found.ok_or_else(|| {
            Failure::Input(format!(
                "--delta: give a number greater than 0 and at most {MAX_NON_UNIFORMITY}"
            ))
        })?;
        wheels.push(("Wittenbauer", wittenbauer.flywheel));
        wheels.push(("Mertsalov", mertsalov.flywheel));
    }

    let values = |loading: &Loading| -> Result<[f64; 7], NoCycle> {
        let cycle = SteadyCycle::new(&motion, loading, motor, speed)?;
        let [least, greatest] = cycle.rates;
        let mean = cycle.mean();
        Ok([
            loading.flywheel() * unit,
            cycle.non_uniformity(),
            mean,
            least,
            greatest,
            cycle.motor().torque(mean)[0] * unit,
            cycle.time,
        ])
    };
    let words = Words::english()?;
    let csv = Csv {
        decimal_comma: asked.decimal_comma,
    };
    let mut rows: Vec<Value> = Vec::new();
    let columns = ["method"].into_iter().chain(COLUMNS).chain(["reason"]);
    let header = columns.map(|name| Cell::Text(name.to_owned()));
    let header: Vec<Cell> = header.collect();
    let mut header = Some(header).filter(|_| !asked.json);
    for (method, wheel) in &wheels {
        let found = values(&loading.with_flywheel(*wheel));
        let (values, reason) = match found {
            Ok(values) => (values.map(Some), None),
            // A linkage that stops without a flywheel may have a cycle with one.
            Err(reason) if reason == NoCycle::NotFound && wheels.len() > 1 => {
                let flywheel = Some(wheel * unit);
                let values = [flywheel, None, None, None, None, None, None];
                (values, Some(words.sentence(&problem(&reason))?))
            }
            Err(reason) => return Err(none(reason)),
        };
        if let Some(header) = header.take() {
            csv.line(out, header.into_iter())?;
        }
        if asked.json {
            let mut row = json!({ "method": method });
            for (name, value) in COLUMNS.iter().zip(values) {
                row[*name] = value.into();
            }
            if let Some(reason) = reason {
                row["reason"] = reason.into();
            }
            rows.push(row);
        } else {
            let first = [Cell::Text((*method).to_owned())].into_iter();
            let cells = values
                .into_iter()
                .map(|value| value.map_or(Cell::Empty, Cell::Number));
            let last = [reason.map_or(Cell::Empty, Cell::Text)];
            csv.line(out, first.chain(cells).chain(last))?;
        }
    }
    if asked.json {
        writeln!(out, "{:#}", json!({ "rows": rows }))?;
    }
    Ok(())
}
