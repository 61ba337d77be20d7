//! The columns of a table: their choice, names and units.

use assur::mechanism::{Mechanism, Quantity};
use assur::motion::Column;

use crate::Failure;

/// Style of the column names for a mechanism.
#[derive(Clone, Copy)]
pub(super) struct Names<'a> {
    pub(super) mechanism: &'a Mechanism,
    /// Whether derivatives are with respect to time instead of the input.
    pub(super) by_time: bool,
    /// Whether angles are in degrees.
    pub(super) degrees: bool,
    /// Whether names end in units.
    pub(super) units: bool,
}

impl Names<'_> {
    /// Returns the heading of the input column.
    pub(super) fn input(self) -> &'static str {
        match (self.mechanism.turns(), self.units) {
            (true, _) => "phi_deg",
            (false, false) => "s",
            (false, true) => "s_length",
        }
    }

    pub(super) fn header(self, column: Column) -> String {
        let name = self.name(column);
        if self.units {
            format!("{name}_{}", self.unit(column))
        } else {
            name
        }
    }

    fn name(self, column: Column) -> String {
        if self.by_time {
            column.name_by_time(self.mechanism)
        } else {
            column.name(self.mechanism)
        }
    }

    /// Returns the unit of a column; the unit of lengths, which is unknown, is called `length`.
    fn unit(self, column: Column) -> String {
        let angle = if self.degrees { "deg" } else { "rad" };
        let unit = |turns: bool| if turns { angle } else { "length" };
        let of = unit(column.quantity.is_angle());
        let by = if self.by_time {
            "s"
        } else {
            unit(self.mechanism.turns())
        };
        match column.order {
            0 => of.to_owned(),
            1 => format!("{of}_per_{by}"),
            order => format!("{of}_per_{by}{order}"),
        }
    }

    /// Returns the factor that converts the engine's values of a column to the unit of the table.
    pub(super) fn scale(self, column: Column) -> f64 {
        let by_angle = !self.by_time && self.mechanism.turns();
        let of = i32::from(column.quantity.is_angle());
        let by = if by_angle { column.order as i32 } else { 0 };
        match of - by {
            0 => 1.0,
            _ if !self.degrees => 1.0,
            angles => 1_f64.to_degrees().powi(angles),
        }
    }

    /// Finds columns by their names in a list separated by commas; a name may itself contain commas.
    ///
    /// # Errors
    /// An unknown name; the message lists the existing names.
    pub(super) fn chosen(self, names: &str) -> Result<Vec<Column>, Failure> {
        let all: Vec<(String, Column)> = Column::all(self.mechanism)
            .into_iter()
            .chain(Column::transmitting(self.mechanism))
            .map(|column| (self.name(column), column))
            .collect();
        let mut chosen = Vec::new();
        let mut rest = names;
        while !rest.is_empty() {
            let first = all.iter().filter_map(|(name, column)| {
                let after = rest.strip_prefix(name.as_str())?;
                let after = if after.is_empty() {
                    after
                } else {
                    after.strip_prefix(',')?
                };
                Some((name.len(), *column, after))
            });
            let Some((_, column, after)) = first.max_by_key(|(length, ..)| *length) else {
                return Err(self.unknown(rest.split(',').next().unwrap_or(rest)));
            };
            chosen.push(column);
            rest = after;
        }
        Ok(chosen)
    }

    fn unknown(self, name: &str) -> Failure {
        let mechanism = self.mechanism;
        let ends = |quantities: &[Quantity]| {
            let orders = [0, 1, 2].into_iter();
            let columns = orders.flat_map(|order| {
                let quantities = quantities.iter();
                quantities.map(move |quantity| Column {
                    quantity: *quantity,
                    order,
                })
            });
            let names = columns.map(|column| self.name(column));
            let ends = names.filter_map(|name| Some(format!(".{}", name.rsplit_once('.')?.1)));
            ends.collect::<Vec<_>>().join(", ")
        };
        let list = |names: Vec<&str>| names.join(", ");
        let mut there = Vec::new();
        if let Some(link) = mechanism.link_ids().next() {
            let links = mechanism.link_ids().map(|link| mechanism.link_name(link));
            let ends = ends(&[Quantity::Angle(link)]);
            there.push(format!("{ends} of {}", list(links.collect())));
        }
        if let Some(point) = mechanism.point_ids().next() {
            let points = mechanism.point_ids();
            let points = points.map(|point| mechanism.point_name(point));
            let ends = ends(&[Quantity::X(point), Quantity::Y(point)]);
            there.push(format!("{ends} of {}", list(points.collect())));
        }
        let further = Column::transmitting(mechanism).map(|column| self.name(column));
        let further: Vec<String> = further.collect();
        if !further.is_empty() {
            there.push(further.join(", "));
        }
        let there = there.join("; ");
        Failure::Input(format!("--columns: there is no {name}; there are {there}"))
    }
}
