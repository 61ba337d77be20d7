//! Tables of forces: reactions and balancing torques by the input.

use std::io::Write;

use assur::forces::{Kinetostatics, Pair, PairId, Reactions};
use assur::mechanism::BodyId;
use assur_file::{ForceUnits, LinkageProblem};
use clap::Args;
use serde_json::{Value, json};

use crate::csv::{Cell, Csv};
use crate::source::{Moved, Name};
use crate::sweep::{Rows, inputs, rate};
use crate::words::{Words, number};
use crate::{Failure, source};

/// Parts of the shaking force and moment, as columns and fields.
const SHAKING: [&str; 3] = ["x", "y", "moment"];

/// Arguments of `assur forces`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Catalogue name or file.
    name: Name,
    #[command(flatten)]
    rows: Rows,
    /// Speed of the driver, rad/s, or length/s for a slide [default: the initial rate of the file, or 0]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    omega: Option<f64>,
    /// Acceleration of the driver, rad/s², or length/s² for a slide [default: 0]
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    epsilon: Option<f64>,
    /// Prints JSON.
    #[arg(long)]
    json: bool,
    /// Decimal comma (0,5 for 0.5), with semicolons between cells
    #[arg(long, conflicts_with = "json")]
    decimal_comma: bool,
}

/// A pair with the body on which its reaction is given, and the body from which it comes.
struct Column<'a> {
    pair: PairId,
    of: &'a Pair,
    bodies: [BodyId; 2],
}

impl Column<'_> {
    /// Force x, y and moment in newtons and newton metres; None where they are statically indeterminate.
    fn values(&self, found: &Reactions, units: ForceUnits) -> [Option<f64>; 3] {
        let on_first = found.of(self.pair);
        let reaction = if self.bodies == self.of.bodies {
            *on_first
        } else {
            on_first.reversed()
        };
        let [x, y] = reaction
            .force
            .map(|force| force.map(|force| force * units.force()));
        [x, y, reaction.moment.map(|moment| moment * units.torque())]
    }

    /// True if the moment may differ from zero.
    fn has_moment(&self) -> bool {
        self.of.is_slide() || self.of.is_mesh()
    }
}

/// Writes the table of reactions, as CSV or JSON.
///
/// # Errors
/// A document that is not a mechanism, or whose forces are invalid; an invalid number; output that cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let Moved { document, motion } = source::moved(&asked.name)?;
    let mechanism = motion.mechanism();
    let loading = document.loading(mechanism);
    let loading = loading.map_err(|problems| source::refused(&asked.name, &problems))?;
    let speed = asked.omega.or(document.initial_rate).unwrap_or(0.0);
    let rates = [
        rate("--omega", speed)?,
        rate("--epsilon", asked.epsilon.unwrap_or(0.0))?,
    ];
    let units = document.force_units();
    let forces = Kinetostatics::new(mechanism);
    let columns = forces.pairs().flat_map(|(pair, of)| {
        let [a, b] = of.bodies;
        [[a, b], [b, a]].map(|bodies| Column { pair, of, bodies })
    });
    let columns: Vec<Column<'_>> = columns.collect();
    let drivers = mechanism.spec().drivers.iter().map(|driver| {
        let is_crank = matches!(driver, assur::mechanism::DriverSpec::Crank { .. });
        let kind = if is_crank { "torque" } else { "force" };
        let name = mechanism.spec().driven(driver).unwrap_or_default();
        (name, kind, units.drive(is_crank))
    });
    let drivers: Vec<(&str, &str, f64)> = drivers.collect();
    let words = Words::english()?;
    let csv = Csv {
        decimal_comma: asked.decimal_comma,
    };
    if !asked.json {
        let first = if mechanism.turns() { "phi_deg" } else { "s" };
        let driven = drivers
            .iter()
            .map(|(name, kind, _)| format!("{name}.{kind}"));
        let reactions = columns.iter().flat_map(|column| {
            let name = column.of.name(mechanism);
            let [on, from] = column.bodies.map(|body| mechanism.body_name(body));
            let parts = ["x", "y", "moment"].into_iter();
            let parts = parts.take(if column.has_moment() { 3 } else { 2 });
            parts.map(move |part| format!("{name}.{on}.{from}.{part}"))
        });
        let header = std::iter::once(first.to_owned())
            .chain(driven)
            .chain(reactions);
        let shaking = SHAKING.map(|part| format!("shaking.{part}"));
        let friction = loading.has_friction().then_some(["lost", "efficiency"]);
        let friction = friction.into_iter().flatten().map(str::to_owned);
        let header = header
            .chain(shaking)
            .chain(friction)
            .chain(["reason".to_owned()]);
        csv.line(out, header.map(Cell::Text))?;
    }
    let mut rows: Vec<Value> = Vec::new();
    let mut found = Reactions::default();
    for at in inputs(&motion, &asked.rows)? {
        let reason = match motion.pose::<3>(at.input) {
            Err(unsolved) => Some(LinkageProblem::unsolved(&unsolved, mechanism)),
            Ok(pose) => {
                let balanced = forces.balance(&loading, &pose, at.input, rates, &mut found);
                let unbalanced = balanced.err();
                unbalanced.map(|why| LinkageProblem::unbalanced(why, mechanism))
            }
        };
        let is_found = reason.is_none();
        let reason = reason.map(|problem| words.sentence(&problem)).transpose()?;
        let torques = forces
            .drivers()
            .zip(&drivers)
            .map(|(driver, (name, kind, unit))| {
                let value = is_found.then(|| found.drive(driver)).flatten();
                (name, kind, value.map(|value| value * unit))
            });
        let reactions = columns.iter().map(|column| {
            let values = is_found.then(|| column.values(&found, units));
            (column, values.unwrap_or_default())
        });
        let shaking = is_found.then(|| found.shaking(mechanism));
        let shaking = shaking.map(|(force, moment)| {
            [
                force.x * units.force(),
                force.y * units.force(),
                moment * units.torque(),
            ]
        });
        let friction = loading.has_friction().then(|| {
            let lost = is_found.then(|| found.loss() * units.torque());
            let efficiency = is_found.then(|| found.efficiency(rates[0])).flatten();
            [lost, efficiency]
        });
        if asked.json {
            let drivers = torques.map(|(name, kind, value)| json!({ "name": name, *kind: value }));
            let reactions = reactions.map(|(column, [x, y, moment])| {
                let [on, from] = column.bodies.map(|body| mechanism.body_name(body));
                let pair = column.of.name(mechanism);
                json!({ "pair": pair, "on": on, "from": from, "x": x, "y": y, "moment": moment })
            });
            let mut row = json!({
                "input": at.counted,
                "drivers": drivers.collect::<Vec<_>>(),
                "reactions": reactions.collect::<Vec<_>>(),
            });
            if let Some(shaking) = shaking {
                row["shaking"] = SHAKING.into_iter().zip(shaking).collect();
            }
            if let Some([lost, efficiency]) = friction {
                row["lost"] = lost.into();
                row["efficiency"] = efficiency.into();
            }
            if let Some(reason) = reason {
                row["reason"] = reason.into();
            }
            rows.push(row);
        } else {
            let cell = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
            let torques = torques.map(|(.., value)| cell(value));
            let reactions = reactions.flat_map(|(column, values)| {
                let parts = if column.has_moment() { 3 } else { 2 };
                values.into_iter().take(parts).map(cell)
            });
            let first = std::iter::once(Cell::Number(at.counted));
            let last = [reason.map_or(Cell::Empty, Cell::Text)];
            let friction = friction.into_iter().flatten().map(cell);
            let shaking = (0..SHAKING.len()).map(|part| cell(shaking.map(|all| all[part])));
            let cells = first.chain(torques).chain(reactions);
            let cells = cells.chain(shaking).chain(friction);
            csv.line(out, cells.chain(last))?;
        }
    }
    if asked.json {
        writeln!(out, "{:#}", json!({ "rows": rows }))?;
    }
    Ok(())
}
