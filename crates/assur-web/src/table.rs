//! Tables of a motion, or of two motions at the same inputs, in the form that the page expects.

use assur::curvature::CircleOfCurvature;
use assur::mechanism::{Mechanism, PointId};
use assur::motion::{At, Column, Grid};
use assur_file::Problem;
use serde::Serialize;

use crate::force_quantity::ForceQuantity;
use crate::moving::Moving;

/// Contents of a table file.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepTable {
    pub(crate) dimensions: Vec<SweepDimension>,
    pub(crate) columns: Vec<SweepColumn>,
    pub(crate) rows: Vec<SweepRow>,
    /// Table of the compared mechanism at the same inputs.
    #[cfg_attr(test, ts(type = "SweepTable | null"))]
    pub(crate) compared: Option<Box<SweepTable>>,
}

/// A dimension of the linkage: the distance between two points of a link, or a coordinate of a frame point.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepDimension {
    #[cfg_attr(test, ts(type = "\"length\" | \"x\" | \"y\""))]
    kind: &'static str,
    /// Names of the two points, as in `A-B`, or of the single point.
    of: String,
    value: f64,
}

/// A quantity of a link or a point, or one of its derivatives with respect to the input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepColumn {
    /// Name of the column, as in all tables: `rocker.dangle`.
    name: String,
    /// Kind, subject and order of the quantity; none if the name is sufficient.
    quantity: Option<SweepQuantity>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepQuantity {
    #[cfg_attr(
        test,
        ts(
            type = "\"angle\" | \"x\" | \"y\" | \"distance\" | \"corner\" | \"between\" | \"transmission\" | \"pressure\" | \"radius\" | \"centre_x\" | \"centre_y\""
        )
    )]
    kind: &'static str,
    of: String,
    order: usize,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepRow {
    /// Input of the row: degrees for a crank, seconds for a gear train, otherwise in the unit of the lengths.
    pub(crate) input: f64,
    pub(crate) values: Vec<Option<f64>>,
    #[cfg_attr(test, ts(type = "{ readonly code: string } | null"))]
    pub(crate) reason: Option<Problem>,
}

impl SweepTable {
    /// Tabulates the motion at this many steps per turn of a crank, or over the range of a driven slide, and at the
    /// inputs where the motion turns back.
    pub(crate) fn of(moving: &Moving, steps: u32) -> Self {
        Self::at(moving, &places(moving, steps))
    }

    /// Tabulates the motion as [`Self::of`] does, with a table of another mechanism at the same inputs.
    pub(crate) fn beside(moving: &Moving, steps: u32, other: &Moving) -> Self {
        let places = places(moving, steps);
        Self {
            compared: Some(Box::new(Self::at(other, &places))),
            ..Self::at(moving, &places)
        }
    }

    /// Tabulates the motion at these inputs: all quantities, measures, plotted values, drawn circles of curvature and,
    /// if they are drawn, all forces.
    fn at(moving: &Moving, places: &[At]) -> Self {
        let (motion, mechanism) = (moving.motion(), moving.mechanism());
        let mut columns = Column::all(mechanism);
        let further = moving.measures().iter().copied().chain(moving.curves());
        for quantity in further {
            let orders = [0, 1, 2].map(|order| Column { quantity, order });
            if !columns.contains(&orders[0]) {
                columns.extend(orders);
            }
        }
        let curved = moving.figure().curved();
        let forces = (moving.has_arrows()).then(|| ForceQuantity::all(moving.forces()));
        let rows = places.iter().map(|at| {
            let row = motion.row(&columns, at.input);
            let mut values = row.values;
            let mut reason = row.reason.map(|unsolved| moving.problem(&unsolved));
            // Circles of curvature need more derivatives than any other column.
            let pose = (!curved.is_empty()).then(|| motion.pose::<5>(at.input).ok());
            let pose = pose.flatten();
            for point in &curved {
                let circle = pose.as_ref().map(|pose| moving.circle(pose, *point));
                if let Some(Err(none)) = &circle {
                    reason.get_or_insert_with(|| none.clone());
                }
                values.extend(circle_values(circle.and_then(Result::ok)));
            }
            if let Some(forces) = &forces {
                let found = moving.row_of_forces(at.input, forces);
                values.extend(found.unwrap_or_else(|problem| {
                    reason.get_or_insert(problem);
                    vec![None; forces.len()]
                }));
            }
            SweepRow {
                input: at.counted,
                values,
                reason,
            }
        });
        let rows = rows.collect();
        let columns = columns.into_iter();
        let circles = curved.iter();
        Self {
            dimensions: SweepDimension::all(moving),
            columns: columns
                .map(|column| SweepColumn::of(mechanism, column))
                .chain(circles.flat_map(|point| SweepColumn::of_circle(mechanism, *point)))
                .chain(forces.iter().flatten().map(|force| {
                    SweepColumn::named(force.heading(moving.forces(), moving.document()))
                }))
                .collect(),
            rows,
            compared: None,
        }
    }
}

/// The inputs of a table.
fn places(moving: &Moving, steps: u32) -> Vec<At> {
    let (motion, mechanism) = (moving.motion(), moving.mechanism());
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
    motion.rows(grid).collect()
}

/// Columns of a circle of curvature: the radius with two derivatives, then the centre.
const OF_CIRCLE: [(&str, usize); 5] = [
    ("radius", 0),
    ("radius", 1),
    ("radius", 2),
    ("centre_x", 0),
    ("centre_y", 0),
];

/// Values of a circle of curvature, in the order of [`OF_CIRCLE`].
fn circle_values(circle: Option<CircleOfCurvature>) -> [Option<f64>; OF_CIRCLE.len()] {
    circle.map_or(
        [None; OF_CIRCLE.len()],
        |CircleOfCurvature { centre, radius }| {
            let [value, first, second] = [0, 1, 2].map(|order| radius.derivative(order));
            [value, first, second, centre.x, centre.y].map(Some)
        },
    )
}

impl SweepDimension {
    /// The distances of each link's points from its first point, then the coordinates of the points of the frame.
    fn all(moving: &Moving) -> Vec<Self> {
        let (motion, mechanism) = (moving.motion(), moving.mechanism());
        let Ok(pose) = motion.pose::<1>(motion.drawn_input()) else {
            return Vec::new();
        };
        let draft = mechanism.spec();
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
        let (kind, of) = (
            quantity.kind_name(),
            quantity.subject(mechanism).into_owned(),
        );
        Self {
            name: column.name(mechanism),
            quantity: Some(SweepQuantity { kind, of, order }),
        }
    }

    fn of_circle(mechanism: &Mechanism, point: PointId) -> impl Iterator<Item = Self> {
        let of = mechanism.point_name(point);
        OF_CIRCLE.into_iter().map(move |(kind, order)| Self {
            name: format!("{of}.{}{kind}", "d".repeat(order)),
            quantity: Some(SweepQuantity {
                kind,
                of: of.to_owned(),
                order,
            }),
        })
    }

    pub(crate) fn named(name: String) -> Self {
        let quantity = None;
        Self { name, quantity }
    }
}
