//! Fields of the dimensions of a linkage, and the reasons why a value of a dimension is refused.

use assur::mechanism::{Defect, Dimension, Mechanism};
use assur::motion::Refusal;
use assur::synthesis::dwell::{DesignVariable, SearchError};

use super::LinkageProblem;
use crate::{Field, Problem};

impl LinkageProblem {
    /// The reason why a search for a dwell that varies these dimensions is refused.
    pub fn refused(
        refused: SearchError,
        mechanism: &Mechanism,
        variables: &[DesignVariable],
    ) -> Self {
        let name = |index: usize| {
            let variable = variables.get(index);
            let name = variable.map(|one| match one.dimension {
                Dimension::Length(link) | Dimension::Side(link, _) | Dimension::Corner(link, _) => {
                    mechanism.link_name(link)
                }
                Dimension::Offset(slide) => &mechanism.spec().slides[slide.index()].link,
                Dimension::X(point) | Dimension::Y(point) => mechanism.point_name(point),
            });
            name.unwrap_or_default().to_owned()
        };
        let wish = |field: &'static str| Self::BadWish {
            field: field.into(),
        };
        match refused {
            SearchError::Tolerance => wish("band"),
            SearchError::Arc => wish("design.arc"),
            SearchError::Stroke => wish("design.stroke"),
            SearchError::Output => Self::NoOutput,
            SearchError::Rigid => Self::NothingMoves,
            SearchError::Dimension(index) => Self::NoDimension { name: name(index) },
            SearchError::Range(index) => match variables.get(index).map(|one| one.range) {
                Some([from, to]) if from > to => Self::Defect(Defect::RangeReversed {
                    link: name(index),
                    from,
                    to,
                }),
                _ => Self::BadRange { name: name(index) },
            },
            SearchError::Blocked => Self::Blocked,
        }
    }
}

/// The path of a dimension's field. Coordinates have paths of their own although they are saved in `at`.
pub fn dimension_field(dimension: Dimension) -> Field {
    match dimension {
        Dimension::Length(link) => format!("links[{}].length", link.index()),
        Dimension::Side(link, [from, to]) => {
            format!("links[{}].side[{from}][{to}]", link.index())
        }
        Dimension::Corner(link, point) => format!("links[{}].corner_deg[{point}]", link.index()),
        Dimension::Offset(slide) => format!("slides[{}].offset", slide.index()),
        Dimension::X(point) => format!("points[{}].x", point.index()),
        Dimension::Y(point) => format!("points[{}].y", point.index()),
    }
    .into()
}

/// Converts a value of a dimension to the unit of its field: angles to degrees.
pub fn in_field(dimension: Dimension, value: f64) -> f64 {
    match dimension {
        Dimension::Corner(..) => value.to_degrees(),
        _ => value,
    }
}

/// Converts a value of a dimension's field to the unit of the engine: angles to radians.
pub fn of_field(dimension: Dimension, value: f64) -> f64 {
    match dimension {
        Dimension::Corner(..) => value.to_radians(),
        _ => value,
    }
}

/// Path of the field `rate` of the driver with this index (not the first driver, which has no rate).
pub fn rate_field(driver: usize) -> Field {
    format!("drivers[{driver}].rate").into()
}

impl LinkageProblem {
    /// The reasons why a dimension of a mechanism cannot be set to a value.
    pub fn unset(
        refusal: Refusal,
        mechanism: &Mechanism,
        dimension: Dimension,
        value: f64,
    ) -> Vec<Problem> {
        let field = dimension_field(dimension);
        let problem = match refusal {
            Refusal::NotFinite => Problem::NotANumber { field },
            Refusal::NotPositive => Problem::NotPositive { field, value },
            Refusal::Absent => Self::NoDimension { name: field.into() }.into(),
            Refusal::Unposed => Self::Unreached.into(),
            Refusal::Defects(defects) => return Problem::all(defects),
            Refusal::LoopOpen {
                last, by, links, ..
            } => {
                let [last, by] = [last, by].map(|value| in_field(dimension, value));
                let links = links.into_iter().map(|link| mechanism.link_name(link));
                let links = links.map(str::to_owned).collect();
                let problem = if in_field(dimension, value) > last {
                    Self::TooLarge {
                        field,
                        by,
                        links,
                        last,
                    }
                } else {
                    Self::TooSmall {
                        field,
                        by,
                        links,
                        last,
                    }
                };
                problem.into()
            }
        };
        vec![problem]
    }
}
