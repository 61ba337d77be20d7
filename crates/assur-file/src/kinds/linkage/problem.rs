//! Problems of a linkage, as codes with parameters: paths of fields, names of links and points. The
//! words are in `lang/`.

use assur::mechanism::{Cause, Defect, Dimension, Mechanism, Singularity, Unsolved};
use assur::motion::{Refusal, TooManyTurns};
use assur::synthesis::dwell::{DesignVariable, SearchError};
use serde::Serialize;

use crate::{Field, Problem};

/// A problem of a linkage; serialised as `{"code": "…", parameters}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum LinkageProblem {
    /// A list that is too long.
    TooMany { path: String, max: usize },
    /// A name that is empty, too long or holds control characters.
    BadName { path: String, max: usize },
    /// A title or source that is too long or holds control characters.
    BadText { path: String, max: usize },
    /// A length together with a shape, or of a link without exactly two points.
    LengthOfTwo { path: String },
    /// A length that is not greater than zero.
    BadLength { path: String, value: f64 },
    /// A dwell band whose width is not greater than zero.
    BadBand { path: String, value: f64 },
    /// A length or shape of a link that is fixed to another and so lies on it as drawn.
    FixedAsDrawn { path: String },
    /// Neither a crank nor a slide with its range, or both.
    BadDriver { path: String },
    /// A plot of a quantity that does not exist.
    NothingToPlot { path: String },
    /// A trace of a point that does not exist.
    NothingToTrace { path: String },
    /// A lock that is not of two or three distinct points.
    BadLock { path: String },
    /// A drawing in which links are in line.
    OpenInLine { links: Vec<String> },
    /// A drawing in which a link is perpendicular to its guide.
    OpenPerpendicular { links: Vec<String> },
    /// A drawing in which a group is in a singular position.
    OpenSingular { links: Vec<String> },
    /// The input is not a number, or outside the range of the driven slide.
    BeyondRange,
    /// The motion does not reach this input, although a pose exists.
    Unreached,
    /// The motion could not be followed up to this input.
    Unfollowed,
    /// Extrema over the motion are not computed: it repeats only after many turns, and at most `most` are
    /// searched.
    TooManyTurns { turns: usize, most: usize },
    /// Links are too short, or too long, to meet.
    LinksApart { links: Vec<String>, by: f64 },
    /// A link does not reach its guide.
    OutOfReach { links: Vec<String>, by: f64 },
    /// Guides have become parallel.
    GuidesParallel { links: Vec<String> },
    /// Links may stand at any angle.
    LinksUndetermined { links: Vec<String> },
    /// Derivatives are unbounded: links are in line.
    LinksDeadPoint { links: Vec<String> },
    /// A redundant constraint of a link that does not hold where the others do.
    ConstraintBroken { link: String, by: f64 },
    /// Derivatives are unbounded: a link is perpendicular to its guide.
    LinksPerpendicular { links: Vec<String> },
    /// Derivatives are unbounded: a group is in a singular position.
    LinksSingular { links: Vec<String> },
    /// A point without a circle of curvature, as it stands still: at a cusp of its path, or for good.
    StandsStill { point: String },
    /// A point without a circle of curvature, as its path is straight here.
    StraightPath { point: String },
    /// A link that does not turn here and so has no inflection circle.
    NotTurning { link: String },
    /// A dimension that is set too large to be followed: these links come apart.
    TooLarge {
        field: Field,
        by: f64,
        links: Vec<String>,
        last: f64,
    },
    /// See [`LinkageProblem::TooLarge`].
    TooSmall {
        field: Field,
        by: f64,
        links: Vec<String>,
        last: f64,
    },
    /// A dwell requirement that is not greater than zero, or an arc of more than a turn.
    BadWish { field: Field },
    /// The mechanism has no such output.
    NoOutput,
    /// A search in which no dimension may change.
    NothingMoves,
    /// A dimension to be varied that does not exist or is not a single length.
    NoDimension { name: String },
    /// A range of a dimension that is empty, or excludes its value.
    BadRange { name: String },
    /// A search from a linkage whose driver does not turn fully, or comes close to a
    /// singular position.
    Blocked,
    /// Two points of a drawing that must be distinct and coincide.
    OnePlace { points: [String; 2] },
    /// Two points to be joined in a hinge that are of one link.
    OneLink { link: String, points: [String; 2] },
    /// A point to slide along a line that is an end of the line, or joined to one.
    OnItsLine { link: String, point: String },
    /// A link along which nothing can slide, since it does not have two points.
    NoLine { link: String },
    /// A dyad of three slides, which does not exist.
    NoSuchDyad,
    /// A defect of the specification.
    #[serde(untagged)]
    Defect(Defect),
}

impl LinkageProblem {
    /// Why a mechanism has no pose, with the names of its links.
    pub fn unsolved(unsolved: &Unsolved, mechanism: &Mechanism) -> Self {
        let links: Vec<String> = mechanism
            .links_of(unsolved.step)
            .map(str::to_owned)
            .collect();
        match unsolved.cause {
            Cause::Input => Self::BeyondRange,
            Cause::Unreached => Self::Unreached,
            Cause::Unfollowed => Self::Unfollowed,
            Cause::Apart { by } => Self::LinksApart { links, by },
            Cause::OutOfReach { by } => Self::OutOfReach { links, by },
            Cause::Parallel => Self::GuidesParallel { links },
            Cause::Undetermined => Self::LinksUndetermined { links },
            Cause::DeadPoint => match mechanism.singularity(unsolved.step) {
                Singularity::InLine => Self::LinksDeadPoint { links },
                Singularity::Perpendicular => Self::LinksPerpendicular { links },
                Singularity::Parallel => Self::GuidesParallel { links },
                Singularity::Group => Self::LinksSingular { links },
            },
            Cause::Locked { body, by } => Self::ConstraintBroken {
                link: mechanism.body_name(body).to_owned(),
                by,
            },
        }
    }
}

impl LinkageProblem {
    /// The reason why there is no search for a dwell that varies these dimensions.
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

/// The saved name of a dimension's field. A coordinate is one of `at`.
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

/// A value of a dimension in the unit of its field: angles in degrees.
pub fn in_field(dimension: Dimension, value: f64) -> f64 {
    match dimension {
        Dimension::Corner(..) => value.to_degrees(),
        _ => value,
    }
}

/// A value of a dimension's field in the unit of the engine: angles in radians.
pub fn of_field(dimension: Dimension, value: f64) -> f64 {
    match dimension {
        Dimension::Corner(..) => value.to_radians(),
        _ => value,
    }
}

/// The field of the rate of a further driver, by the driver's index.
pub fn rate_field(driver: usize) -> Field {
    format!("drivers[{driver}].rate").into()
}

impl LinkageProblem {
    /// Why a dimension of a mechanism cannot be set to a value.
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

impl From<TooManyTurns> for LinkageProblem {
    fn from(TooManyTurns { turns, most }: TooManyTurns) -> Self {
        Self::TooManyTurns { turns, most }
    }
}

impl From<Defect> for LinkageProblem {
    fn from(defect: Defect) -> Self {
        match defect {
            Defect::Singular { links, singularity } => match singularity {
                Singularity::InLine => Self::OpenInLine { links },
                Singularity::Perpendicular => Self::OpenPerpendicular { links },
                Singularity::Parallel => Defect::ParallelGuides { links }.into(),
                Singularity::Group => Self::OpenSingular { links },
            },
            defect => Self::Defect(defect),
        }
    }
}
