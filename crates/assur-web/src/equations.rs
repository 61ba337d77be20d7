//! The constraint equations of a linkage, for the page.

use assur::mechanism::{Constraint, ConstraintKind, FRAME, LinkOrFrame, Mechanism, PointId, Pose};
use serde::Serialize;

/// Subject of a constraint equation. The `points` of an offset are the sliding point and two points of its line. `on`
/// is the body with the line of a slide; `carrier` is the body to which both wheels in mesh are hinged.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(crate) enum EquationSummary<'a> {
    Distance {
        link: &'a str,
        points: [&'a str; 2],
    },
    Offset {
        link: &'a str,
        points: [&'a str; 3],
    },
    Direction {
        link: &'a str,
        on: &'a str,
    },
    Mesh {
        links: [&'a str; 2],
        carrier: &'a str,
        teeth: [f64; 2],
    },
}

impl<'a> EquationSummary<'a> {
    /// The constraint equations of a mechanism, in the order of [`sides`].
    pub(crate) fn all(mechanism: &'a Mechanism) -> Vec<Self> {
        let constraints = mechanism.constraints();
        let all = constraints.iter().map(|one| Self::new(mechanism, one));
        all.collect()
    }

    fn new(mechanism: &'a Mechanism, constraint: &Constraint) -> Self {
        let link = |link: LinkOrFrame| link.map_or(FRAME, |link| mechanism.link_name(link));
        let point = |point: PointId| mechanism.point_name(point);
        match constraint.kind {
            ConstraintKind::Distance { link: of, points } => Self::Distance {
                link: link(Some(of)),
                points: points.map(point),
            },
            ConstraintKind::Offset {
                link: of,
                point: slid,
                line: [p, q],
            } => Self::Offset {
                link: link(of),
                points: [slid, p, q].map(point),
            },
            ConstraintKind::Direction { link: of, on } => Self::Direction {
                link: link(of),
                on: link(on),
            },
            ConstraintKind::Mesh {
                links,
                carrier,
                teeth,
            } => Self::Mesh {
                links: links.map(link),
                carrier: link(carrier),
                teeth,
            },
        }
    }
}

/// Left side, right side and residual of every constraint equation or, for order 1 or 2, of its derivative.
pub(crate) fn sides<const N: usize>(
    mechanism: &Mechanism,
    pose: &Pose<N>,
    order: usize,
) -> Vec<f64> {
    let constraints = mechanism.constraints();
    let sides = constraints
        .iter()
        .map(|one| mechanism.sides(pose, one, order));
    sides
        .flat_map(|sides| [sides.left, sides.right, sides.residual()])
        .collect()
}
