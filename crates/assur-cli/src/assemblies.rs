//! All assemblies at an input as CSV.

use std::io::{self, Write};

use assur::mechanism::Quantity;
use clap::Args;

use crate::csv::{Cell, Csv};
use crate::sweep::asked_for;
use crate::{Failure, source};

/// What is asked for.
#[derive(Args)]
pub(crate) struct Asked {
    /// Catalogue name or file.
    name: String,
    /// The input: degrees, of a driven slide a length [default: the drawn one]
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: Option<f64>,
}

/// Writes the table; where there may be more assemblies standard error says so.
///
/// # Errors
/// What is no mechanism; a number that is none; what cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let moved = source::moved(&asked.name)?;
    let output = moved.output(&asked.name)?;
    let motion = &moved.motion;
    let mechanism = motion.mechanism();
    let input = match asked.at {
        Some(at) => asked_for("--at", at, mechanism.turns())?.input,
        None => motion.home(),
    };
    let found = motion.assemblies_at(input, output);
    let csv = Csv {
        decimal_comma: false,
    };
    let names = mechanism
        .link_ids()
        .map(|link| Quantity::Angle(link).name(mechanism, 0));
    let header = ["assembly".to_owned()].into_iter().chain(names);
    csv.line(out, header.map(Cell::Text))?;
    for (index, pose) in found.poses.iter().enumerate() {
        let values = mechanism.link_ids();
        let values = values.map(|link| Cell::Number(mechanism.folded_angle(pose, link)));
        let number = [Cell::Text((index + 1).to_string())].into_iter();
        csv.line(out, number.chain(values))?;
    }
    if !found.whole {
        let at = source::at(mechanism.turns(), input);
        let name = &asked.name;
        // With standard error gone there is nobody left to tell.
        let _ = writeln!(
            io::stderr(),
            "assur: {name}: there may be more assemblies at {at}"
        );
    }
    Ok(())
}
