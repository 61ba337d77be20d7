//! Table (CSV) of all assemblies of a linkage at one input.

use std::io::{self, Write};

use assur::circuits::NoAssembly;
use assur::mechanism::Quantity;
use clap::Args;

use crate::csv::{Cell, Csv};
use crate::source::Name;
use crate::sweep::asked_for;
use crate::words::number;
use crate::{Failure, source};

/// Arguments of `assur assemblies`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Catalogue name or file.
    name: Name,
    /// Input of the assemblies, in degrees, or a length if a slide is driven [default: the drawn input]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    at: Option<f64>,
    /// Instead of the table, writes the linkage drawn in assembly number N, as a file
    #[arg(long, value_name = "N")]
    assemble: Option<usize>,
}

/// Writes the table or, on request, the linkage drawn in one assembly. Warns on standard error if the table may be
/// incomplete.
///
/// # Errors
/// A document that is not a mechanism; a mechanism without links; an invalid number; output that cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let at = |turns: bool| {
        let at = asked.at.map(|at| asked_for("--at", at, turns));
        Ok(at.transpose()?.map(|at| at.input))
    };
    let moved = source::laid_out(&asked.name, at)?;
    let output = moved.output(&asked.name)?;
    let motion = &moved.motion;
    let mechanism = motion.mechanism();
    let input = at(mechanism.turns())?.unwrap_or(motion.drawn_input());
    let found = motion.assemblies_at(input, output);
    if let Some(number) = asked.assemble {
        let pose = number.checked_sub(1).and_then(|k| found.poses.get(k));
        let none = || {
            let none = NoAssembly {
                of: found.poses.len(),
                whole: found.whole,
            };
            source::no_assembly(&asked.name, mechanism, number, none, input)
        };
        let pose = pose.ok_or_else(none)?;
        let drawn = moved.document.redrawn(&mechanism.drawn_in(pose));
        serde_json::to_writer_pretty(&mut *out, &drawn).map_err(io::Error::from)?;
        writeln!(out)?;
        return Ok(());
    }
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
        // A failure to write to standard error cannot be reported.
        let _ = writeln!(
            io::stderr(),
            "assur: {name}: there may be more assemblies at {at}"
        );
    }
    Ok(())
}
