//! The table of a motion, under names of the page.

use assur::mechanism::Mechanism;
use assur::motion::{Column, Grid};
use assur_file::Problem;
use serde::Serialize;

use crate::moving::Moving;

/// What a table file holds.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepTable {
    pub(crate) dimensions: Vec<SweepDimension>,
    pub(crate) columns: Vec<SweepColumn>,
    pub(crate) rows: Vec<SweepRow>,
}

/// A dimension of the linkage: how far two points of a link are apart, or a coordinate of a point of the frame.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepDimension {
    #[cfg_attr(test, ts(type = "\"length\" | \"x\" | \"y\""))]
    kind: &'static str,
    /// Of two points, as in `A-B`, or of one.
    of: String,
    value: f64,
}

/// A quantity of a link or a point, or its derivative of an order by the input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepColumn {
    /// As in all tables: `rocker.dangle`.
    name: String,
    /// None where the name is all that is told.
    quantity: Option<SweepQuantity>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepQuantity {
    #[cfg_attr(
        test,
        ts(type = "\"angle\" | \"x\" | \"y\" | \"distance\" | \"corner\"")
    )]
    kind: &'static str,
    of: String,
    order: usize,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepRow {
    /// Degrees of a crank, else in the unit of the lengths.
    pub(crate) input: f64,
    pub(crate) values: Vec<Option<f64>>,
    #[cfg_attr(test, ts(type = "{ readonly code: string } | null"))]
    pub(crate) reason: Option<Problem>,
}

impl SweepTable {
    /// The motion as a table with this many steps to a turn of the crank, or to the range of
    /// a driven slide, and where it turns back.
    pub(crate) fn of(moving: &Moving, steps: u32) -> Self {
        let (motion, mechanism) = (moving.motion(), moving.mechanism());
        let measured = moving.measures().iter();
        let measured = measured.flat_map(|quantity| {
            [0, 1, 2].map(|order| Column {
                quantity: *quantity,
                order,
            })
        });
        let mut columns = Column::all(mechanism);
        columns.extend(measured);
        let steps = f64::from(steps.max(1));
        let [start, end] = motion.cycle().axis();
        let grid = if mechanism.turns() {
            Grid {
                unit: 1_f64.to_radians(),
                origin: 0.0,
                step: 360.0 / steps,
            }
        } else {
            Grid {
                unit: 1.0,
                origin: start,
                step: (end - start) / steps,
            }
        };
        let rows = motion.rows(grid).map(|at| {
            let row = motion.row(&columns, at.input);
            SweepRow {
                input: at.counted,
                values: row.values,
                reason: row.reason.map(|unsolved| moving.problem(&unsolved)),
            }
        });
        Self {
            dimensions: SweepDimension::all(moving),
            rows: rows.collect(),
            columns: columns
                .iter()
                .map(|column| SweepColumn::of(mechanism, *column))
                .collect(),
        }
    }
}

impl SweepDimension {
    /// Of each link the distances of its points from the first, then where the points of the frame are.
    fn all(moving: &Moving) -> Vec<Self> {
        let (motion, mechanism) = (moving.motion(), moving.mechanism());
        let Ok(pose) = motion.pose::<1>(motion.home()) else {
            return Vec::new();
        };
        let draft = mechanism.draft();
        let place = |name: &String| {
            let point = mechanism.point(name)?;
            Some(mechanism.place(&pose, point).place())
        };
        let bars = draft.links.iter().flat_map(|link| {
            let first = link.points.iter().take(1);
            first.flat_map(|first| link.points.iter().skip(1).map(move |other| [first, other]))
        });
        let lengths = bars.filter_map(|[a, b]| {
            let value = (place(b)? - place(a)?).norm();
            let of = format!("{a}-{b}");
            let kind = "length";
            Some(Self { kind, of, value })
        });
        let fixed = draft.frame.iter().flat_map(|name| {
            let coordinates = place(name).map(|at| [("x", at.x), ("y", at.y)]);
            let of = name.clone();
            coordinates
                .into_iter()
                .flatten()
                .map(move |(kind, value)| Self {
                    kind,
                    of: of.clone(),
                    value,
                })
        });
        lengths.chain(fixed).collect()
    }
}

impl SweepColumn {
    fn of(mechanism: &Mechanism, column: Column) -> Self {
        let Column { quantity, order } = column;
        let (kind, of) = (quantity.what(), quantity.whose(mechanism).into_owned());
        Self {
            name: column.name(mechanism),
            quantity: Some(SweepQuantity { kind, of, order }),
        }
    }

    /// One of which the name is all that is told.
    pub(crate) fn named(name: String) -> Self {
        let quantity = None;
        Self { name, quantity }
    }
}
