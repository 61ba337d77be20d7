//! The table of a motion as CSV.

mod columns;
mod grid;

use std::io::Write;

use assur::motion::{Column, InputRate, Motion};
use assur_file::LinkageProblem;
use clap::Args;

use crate::csv::{Cell, Csv};
use crate::words::{Words, number};
use crate::{Failure, source};
use columns::Names;
pub(crate) use grid::{asked_for, inputs, rate};

/// Choice of the inputs of a table.
#[derive(Args)]
pub(crate) struct Rows {
    /// Step: degrees, or a length for a driven slide [default: 1°, or a 360th of the range]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    step: Option<f64>,
    /// First input, from which steps are counted: degrees, or a length for a driven slide [default:
    /// the beginning of the motion, with steps counted from 0°]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last input: degrees, or a length for a driven slide [default: the end of the motion]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    to: Option<f64>,
    /// Rows at these inputs only: degrees, or lengths for a driven slide
    #[arg(
        value_parser = number,
        long,
        value_name = "X,X",
        value_delimiter = ',',
        allow_hyphen_values = true,
        conflicts_with_all = ["step", "from", "to"]
    )]
    at: Vec<f64>,
}

/// Arguments of `assur sweep`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Catalogue name or file.
    name: source::Name,
    #[command(flatten)]
    rows: Rows,
    /// Only these columns, in this order, named as in the header without units. C.transmission and C.pressure, the
    /// transmission and pressure angles of the dyad with the inner joint C, can also be named
    #[arg(long, value_name = "NAME,NAME", allow_hyphen_values = true)]
    columns: Option<String>,
    /// Speed of the driver, rad/s, or length/s for a slide; gives derivatives with respect to time
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    omega: Option<f64>,
    /// Acceleration of the driver, rad/s², or length/s² for a slide [default: 0]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true, requires = "omega")]
    epsilon: Option<f64>,
    /// Angles in degrees instead of radians, also in derivatives, including those with respect to the angle of a crank
    #[arg(long)]
    degrees: bool,
    /// Units at the end of column names, as in rocker.angle_rad (with --degrees rocker.angle_deg) or C.vx_length_per_s
    #[arg(long)]
    header_units: bool,
    /// Decimal comma (0,5 for 0.5), with semicolons between cells
    #[arg(long)]
    decimal_comma: bool,
    /// Number of the assembly (see `assur assemblies`) at the first input of --at or --from, or else at the drawn
    /// input; its motion is followed from there [default: the drawn assembly]
    #[arg(long, value_name = "N")]
    assembly: Option<usize>,
}

/// Writes the table of a motion.
///
/// # Errors
/// A document that is not a mechanism; an invalid number, step or column; output that cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let drawn = source::moved(&asked.name)?;
    let motion: Motion = match asked.assembly {
        Some(number) => {
            let first = grid::first(&drawn.motion, &asked.rows)?;
            source::in_assembly(drawn, &asked.name, number, first)?.motion
        }
        None => drawn.motion,
    };
    let mechanism = motion.mechanism();
    let names = Names {
        mechanism,
        by_time: asked.omega.is_some(),
        degrees: asked.degrees,
        units: asked.header_units,
    };
    let columns = match &asked.columns {
        Some(chosen) => names.chosen(chosen)?,
        None => Column::all(mechanism),
    };
    let driven = match asked.omega {
        Some(omega) => InputRate {
            speed: grid::rate("--omega", omega)?,
            acceleration: grid::rate("--epsilon", asked.epsilon.unwrap_or(0.0))?,
        },
        None => InputRate::ANALOGUES,
    };
    let inputs = grid::inputs(&motion, &asked.rows)?;

    let csv = Csv {
        decimal_comma: asked.decimal_comma,
    };
    let scales: Vec<f64> = columns.iter().map(|column| names.scale(*column)).collect();
    let headers = columns.iter().map(|column| names.header(*column));
    let first = [names.input().to_owned()].into_iter();
    let header = first.chain(headers).chain(["reason".to_owned()]);
    csv.line(out, header.map(Cell::Text))?;
    let words = Words::english()?;
    for at in inputs {
        let row = motion.row_by_time(&columns, at.input, driven);
        let values = row.values.iter().zip(&scales);
        let values =
            values.map(|(value, scale)| value.map_or(Cell::Empty, |one| Cell::Number(one * scale)));
        let reason = row
            .reason
            .map(|unsolved| words.sentence(&LinkageProblem::unsolved(&unsolved, mechanism)));
        let first = [Cell::Number(at.counted)].into_iter();
        let last = [reason.transpose()?.map_or(Cell::Empty, Cell::Text)];
        csv.line(out, first.chain(values).chain(last))?;
    }
    Ok(())
}
