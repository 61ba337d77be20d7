//! Saved form of a path that a point of a linkage is to trace.

use assur::linkage::LinkageSpec;
use assur::synthesis::approximation::{Course, Search, Target, TargetError, Tracing, Wanted};
use assur::synthesis::cognates::{
    CouplerError, CouplerFourBar, CouplerSliderCrank, SliderCrankError,
};
use assur::synthesis::path::PathError;
use assur::{Point, Vector};
use serde::{Deserialize, Serialize};

use super::Kind;
use super::numbers::NumberField;
use crate::problem::Problems;
use crate::{LengthUnit, LinkageDocument, Problem};

/// A path, and the linkage that traces it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct PathDocument {
    /// Unit of lengths; if absent, only proportions count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// What the points mean.
    #[serde(default, skip_serializing_if = "CourseDocument::is_points")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub course: CourseDocument,
    /// The points of the path, in their order: 3 to 512.
    pub path: Vec<[f64; 2]>,
    /// Crank angles at the points, of which only the differences count; the crank may turn in either direction. If
    /// absent, they are free.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub angles_deg: Vec<f64>,
    /// The linkage that is shown; if absent, the best one of a short search.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub linkage: Option<TracingDocument>,
}

/// Meaning of the points of a path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum CourseDocument {
    /// Points to be passed in order; the path between them is free.
    #[default]
    Points,
    /// A curve from the first point to the last.
    Open,
    /// A closed curve, whose end joins its beginning.
    Closed,
}

/// A linkage with the point that traces the path, in one pose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum TracingDocument {
    /// A four-bar.
    FourBar {
        /// Fixed pivots of crank and rocker.
        pivots: [[f64; 2]; 2],
        /// Joints of the coupler with crank and rocker.
        joints: [[f64; 2]; 2],
        /// The traced point of the coupler.
        point: [f64; 2],
    },
    /// A slider-crank.
    SliderCrank {
        /// Fixed pivot of the crank.
        pivot: [f64; 2],
        /// Joints of the rod with crank and slider.
        joints: [[f64; 2]; 2],
        /// Direction of the guide.
        guide: [f64; 2],
        /// The traced point of the rod.
        point: [f64; 2],
    },
}

/// A problem of a path; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum PathProblem {
    /// A path has at least three different points.
    TooFewPoints {
        /// Number of different points.
        distinct: usize,
    },
    /// Crank angles are as many as points.
    AnglesOfPoints {
        /// Number of crank angles.
        angles: usize,
        /// Number of points.
        points: usize,
    },
    /// Crank angles belong to points, not to a curve.
    AnglesOfCurve,
    /// No linkage traces the path.
    NoTracing,
    /// No traced point is on the coupler of a four-bar or on the rod of a slider-crank.
    NoCouplerPoint,
    /// The places of a slider-crank leave a part of it without a length.
    NoSliderCrank,
    /// Only nine points determine a finite number of four-bars.
    NotNinePoints {
        /// Number of points.
        count: usize,
    },
    /// Two of nine points coincide, which leaves a family of four-bars.
    CoincidentPoints {
        /// Numbers of the points, from 1.
        first: usize,
        /// See `first`.
        second: usize,
    },
    /// Nine points are in line: no four-bar passes through them, a slide does.
    PointsInLine,
    /// Nine points are on a circle: a crank passes through them, with any coupler and rocker.
    PointsOnCircle {
        /// Radius of the circle.
        radius: f64,
    },
}

/// Limits of the number of points.
const POINTS: [f64; 2] = [3.0, 512.0];

/// Maximum absolute value of a coordinate; see [`TargetError`].
const FARTHEST: f64 = 1e9;

/// Candidates of the search of a document without a linkage: its first three batches.
const CANDIDATES: usize = 256 + 512 + 1024;

/// A path with the linkage that is shown.
#[derive(Clone, Debug)]
pub struct PathTask {
    /// The path.
    pub target: Target,
    /// The linkage; none if the search finds none.
    pub shown: Option<Tracing>,
    /// Unit of lengths.
    unit: Option<LengthUnit>,
}

impl CourseDocument {
    fn is_points(&self) -> bool {
        *self == Self::Points
    }
}

impl From<CourseDocument> for Course {
    fn from(course: CourseDocument) -> Self {
        match course {
            CourseDocument::Points => Self::Points,
            CourseDocument::Open => Self::Open,
            CourseDocument::Closed => Self::Closed,
        }
    }
}

impl From<&Tracing> for TracingDocument {
    fn from(tracing: &Tracing) -> Self {
        match tracing {
            Tracing::FourBar(linkage) => Self::FourBar {
                pivots: linkage.pivots().map(Point::into),
                joints: linkage.joints().map(Point::into),
                point: linkage.point().into(),
            },
            Tracing::SliderCrank(linkage) => Self::SliderCrank {
                pivot: linkage.pivot().into(),
                joints: linkage.joints().map(Point::into),
                guide: linkage.guide().into(),
                point: linkage.point().into(),
            },
        }
    }
}

impl From<PathError> for Problem {
    fn from(error: PathError) -> Self {
        match error {
            PathError::Count(count) => PathProblem::NotNinePoints { count }.into(),
            PathError::Place(k) => Self::NotANumber {
                field: format!("path[{k}]").into(),
            },
            PathError::Coincident(first, second) => PathProblem::CoincidentPoints {
                first: first + 1,
                second: second + 1,
            }
            .into(),
            PathError::Line => PathProblem::PointsInLine.into(),
            PathError::Circle { radius, .. } => PathProblem::PointsOnCircle { radius }.into(),
        }
    }
}

impl TracingDocument {
    /// Coordinates of all places, and of the direction of a guide.
    fn coordinates(&self) -> impl Iterator<Item = f64> + use<> {
        let places = match *self {
            Self::FourBar {
                pivots: [a, d],
                joints: [b, c],
                point,
            } => [a, b, c, d, point],
            Self::SliderCrank {
                pivot,
                joints: [b, c],
                guide,
                point,
            } => [pivot, b, c, guide, point],
        };
        places.into_iter().flatten()
    }

    /// True if a document may hold the linkage: no coordinate is too large.
    pub fn is_near(&self) -> bool {
        self.coordinates().all(|one| one.abs() <= FARTHEST)
    }

    fn tracing(&self) -> Result<Tracing, Vec<Problem>> {
        match *self {
            Self::FourBar {
                pivots,
                joints,
                point,
            } => {
                let made = CouplerFourBar::new(
                    pivots.map(Point::from),
                    joints.map(Point::from),
                    point.into(),
                );
                made.map(Tracing::FourBar).map_err(|error| match error {
                    CouplerError::Lengths(faults) => {
                        faults.into_iter().map(Problem::from).collect()
                    }
                    CouplerError::NotFinite => vec![Problem::NotANumber {
                        field: "linkage".into(),
                    }],
                })
            }
            Self::SliderCrank {
                pivot,
                joints,
                guide,
                point,
            } => {
                let made = CouplerSliderCrank::new(
                    pivot.into(),
                    joints.map(Point::from),
                    Vector::from(guide),
                    point.into(),
                );
                made.map(Tracing::SliderCrank).map_err(|error| {
                    vec![match error {
                        SliderCrankError::NotFinite => Problem::NotANumber {
                            field: "linkage".into(),
                        },
                        SliderCrankError::Crank
                        | SliderCrankError::Rod
                        | SliderCrankError::Guide => PathProblem::NoSliderCrank.into(),
                    }]
                })
            }
        }
    }
}

impl PathDocument {
    /// The path.
    ///
    /// # Errors
    /// Every problem of the document.
    pub fn target(&self) -> Result<Target, Vec<Problem>> {
        let mut problems = Problems::default();
        let most = [-FARTHEST, FARTHEST];
        problems.range("path", self.path.len() as f64, POINTS);
        for (k, [x, y]) in self.path.iter().enumerate() {
            problems.range(format!("path[{k}].x"), *x, most);
            problems.range(format!("path[{k}].y"), *y, most);
        }
        for (k, angle) in self.angles_deg.iter().enumerate() {
            problems.range(format!("angles_deg[{k}]"), *angle, most);
        }
        let mut coordinates = (self.linkage.iter()).flat_map(TracingDocument::coordinates);
        if let Some(far) = coordinates.find(|one| !(-FARTHEST..=FARTHEST).contains(one)) {
            problems.range("linkage", far, most);
        }
        if !problems.0.is_empty() {
            return Err(problems.0);
        }
        let points: Vec<Point> = self.path.iter().copied().map(Point::from).collect();
        let angles: Vec<f64> = self
            .angles_deg
            .iter()
            .map(|angle| angle.to_radians())
            .collect();
        let angles = (!angles.is_empty()).then_some(&angles[..]);
        Target::new(&points, self.course.into(), angles).map_err(|error| {
            vec![match error {
                TargetError::TooFew { distinct } => PathProblem::TooFewPoints { distinct }.into(),
                TargetError::NotFinite(k) => Problem::NotANumber {
                    field: format!("path[{k}]").into(),
                },
                TargetError::Angles { count } => PathProblem::AnglesOfPoints {
                    angles: count,
                    points: points.len(),
                }
                .into(),
                TargetError::Angle(k) => Problem::NotANumber {
                    field: format!("angles_deg[{k}]").into(),
                },
                TargetError::AnglesOfCurve => PathProblem::AnglesOfCurve.into(),
            }]
        })
    }

    /// The path with the linkage that is shown: the given one, or the best one of a short search.
    ///
    /// # Errors
    /// Every problem of the document.
    pub fn task(&self) -> Result<PathTask, Vec<Problem>> {
        let target = self.target()?;
        let shown = match &self.linkage {
            Some(linkage) => Some(linkage.tracing()?),
            None => {
                let mut search = Search::new(target.clone(), Wanted::default());
                search.step(CANDIDATES);
                search.best().map(|best| best.linkage)
            }
        };
        Ok(PathTask {
            target,
            shown,
            unit: self.unit,
        })
    }
}

impl PathTask {
    /// The shown linkage for the simulator, with the path of its point.
    ///
    /// # Errors
    /// There is no linkage.
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let shown = self
            .shown
            .as_ref()
            .ok_or_else(|| vec![PathProblem::NoTracing.into()])?;
        Ok(self.tracing(&shown.spec()))
    }

    /// A linkage that traces the path with its point P, for the simulator.
    pub fn tracing(&self, spec: &LinkageSpec) -> LinkageDocument {
        let mut document = LinkageDocument::new(spec);
        document.traces = vec!["P".to_owned()];
        document.unit = self.unit;
        document
    }
}

impl Kind for PathDocument {
    fn unit(&self) -> LengthUnit {
        self.unit.unwrap_or(LengthUnit::None)
    }

    fn chooses_unit(&self) -> bool {
        true
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        self.task()?.linkage()
    }

    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(Vec::new())
    }
}
