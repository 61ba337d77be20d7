//! Problems of input from a person, a file or a URL, as codes with parameters. Their texts are in `lang/`.

use std::borrow::Cow;

use assur::mechanism::Defect;
use assur::mobility::{CutError, SchemeDefect};
use assur::{Dimension, Fault, Invalid, Link, Unsolved};
use serde::Serialize;

use crate::{
    GearTrainProblem, LessonProblem, LinkageProblem, PathProblem, PictureProblem, PosesProblem,
    SynthesisProblem,
};

/// The path of a field in the saved form, such as `l1` or `wheels[2].z`.
pub type Field = Cow<'static, str>;

/// A problem; serialised as `{"code": "…", parameters}`. Angles are in radians.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum Problem {
    /// A field holds NaN or an infinity.
    NotANumber { field: Field },
    /// A field must be greater than zero.
    NotPositive { field: Field, value: f64 },
    /// A field is outside its range.
    OutOfRange {
        field: Field,
        value: f64,
        min: f64,
        max: f64,
    },
    /// A field must be a whole number.
    NotWhole { field: Field, value: f64 },
    /// A field has none of its allowed values.
    UnknownChoice { field: Field },
    /// The speed of the driver is 0, so that nothing moves in real time.
    AtRest { field: Field },
    /// A link of a four-bar is at least as long as the others together; `by` is the difference.
    TooLong { field: Field, by: f64 },
    /// Wheels in internal mesh have equal numbers of teeth.
    ConcentricWheels { field: Field },
    /// A wheel is in internal mesh with both smaller and larger wheels.
    MixedWheels { field: Field },
    /// Coupler and rocker together are too short at this crank angle; `by` is the missing length.
    Apart { phi: f64, by: f64 },
    /// Either the coupler or the rocker is too long at this crank angle; `by` is the excess length.
    Inside { phi: f64, by: f64, field: Field },
    /// The pose at this crank angle is undetermined.
    Undetermined { phi: f64 },
    /// The derivatives at this crank angle are unbounded.
    DeadPoint { phi: f64 },
    /// The text or object does not have the form of a state.
    BadState { path: String, detail: String },
    /// The version of the saved form is unknown.
    UnknownFormat { format: f64 },
    /// An object has a duplicate key.
    KeyTwice { path: String },
    /// The problems that follow belong to the compared mechanism.
    InCompared,
    /// The text is not JSON.
    NotJson { detail: String },
    /// A scheme has no motion.
    NoMotion,
    /// A problem of a linkage.
    #[serde(untagged)]
    Linkage(LinkageProblem),
    /// A problem of a synthesis.
    #[serde(untagged)]
    Synthesis(SynthesisProblem),
    /// A problem of poses of a body.
    #[serde(untagged)]
    Poses(PosesProblem),
    /// A problem of a path.
    #[serde(untagged)]
    Path(PathProblem),
    /// A problem of a scheme of links and pairs.
    #[serde(untagged)]
    Scheme(SchemeDefect),
    /// A problem of the cuts of a scheme.
    #[serde(untagged)]
    Cut(CutError),
    /// A problem of a lesson.
    #[serde(untagged)]
    Lesson(LessonProblem),
    /// A problem of a picture behind a drawing.
    #[serde(untagged)]
    Picture(PictureProblem),
    /// A problem of a differential.
    #[serde(untagged)]
    GearTrain(GearTrainProblem),
}

/// Implements the conversion from the problems of single subjects to [`Problem`].
macro_rules! of_parts {
    ($($variant:ident($part:ty),)+) => {
        $(impl From<$part> for Problem {
            fn from(part: $part) -> Self {
                Self::$variant(part)
            }
        })+
    };
}

of_parts! {
    Linkage(LinkageProblem),
    Synthesis(SynthesisProblem),
    Poses(PosesProblem),
    Path(PathProblem),
    Scheme(SchemeDefect),
    Cut(CutError),
    Lesson(LessonProblem),
    Picture(PictureProblem),
    GearTrain(GearTrainProblem),
}

#[derive(Default)]
pub(crate) struct Problems(pub(crate) Vec<Problem>);

impl Problems {
    pub(crate) fn add(&mut self, problem: impl Into<Problem>) {
        self.0.push(problem.into());
    }

    /// Adds a problem if a number is not finite or is outside a range.
    pub(crate) fn range(&mut self, field: impl Into<Field>, value: f64, [min, max]: [f64; 2]) {
        let field = field.into();
        if !value.is_finite() {
            self.add(Problem::NotANumber { field });
        } else if !(min..=max).contains(&value) {
            self.add(Problem::OutOfRange {
                field,
                value,
                min,
                max,
            });
        }
    }

    /// Adds a problem if a title or source has control characters or more than `max` characters.
    pub(crate) fn text(&mut self, path: &str, text: Option<&String>, max: usize) {
        if text.is_some_and(|text| !is_plain(text, max)) {
            let path = path.to_owned();
            self.add(LinkageProblem::BadText { path, max });
        }
    }

    pub(crate) fn end(self) -> Result<(), Vec<Problem>> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(self.0)
        }
    }
}

/// True if a text has at most `longest` characters and no control characters.
pub(crate) fn is_plain(text: &str, longest: usize) -> bool {
    text.chars().count() <= longest && !text.contains(char::is_control)
}

impl Problem {
    /// The problem that reports a fault in the value of a field.
    pub(crate) fn of_fault(field: impl Into<Field>, fault: Fault) -> Self {
        let field = field.into();
        match fault {
            Fault::NotFinite => Self::NotANumber { field },
            Fault::NotPositive { value } => Self::NotPositive { field, value },
            Fault::OutOfRange { value, min, max } => Self::OutOfRange {
                field,
                value,
                min,
                max,
            },
            Fault::NotWhole { value } => Self::NotWhole { field, value },
            Fault::TooLong { by } => Self::TooLong { field, by },
            Fault::Concentric => Self::ConcentricWheels { field },
            Fault::BothSides => Self::MixedWheels { field },
            Fault::Absent => Self::UnknownChoice { field },
        }
    }

    /// Converts defects to problems.
    pub fn all(defects: Vec<impl Into<Self>>) -> Vec<Self> {
        defects.into_iter().map(Into::into).collect()
    }
}

impl From<Defect> for Problem {
    fn from(defect: Defect) -> Self {
        LinkageProblem::from(defect).into()
    }
}

impl From<Invalid> for Problem {
    fn from(invalid: Invalid) -> Self {
        Self::of_fault(field(invalid.dimension), invalid.fault)
    }
}

impl From<Unsolved> for Problem {
    fn from(unsolved: Unsolved) -> Self {
        match unsolved {
            Unsolved::NotAnAngle => Self::NotANumber {
                field: "phi_deg".into(),
            },
            Unsolved::Apart { crank, by } => Self::Apart { phi: crank, by },
            Unsolved::Inside { crank, by, longer } => Self::Inside {
                phi: crank,
                by,
                field: link_field(longer).into(),
            },
            Unsolved::Undetermined { crank } => Self::Undetermined { phi: crank },
            Unsolved::DeadPoint { crank } => Self::DeadPoint { phi: crank },
        }
    }
}

fn field(dimension: Dimension) -> Field {
    let name = match dimension {
        Dimension::Crank => "l1",
        Dimension::Coupler => "l2",
        Dimension::Rocker => "l3",
        Dimension::Frame => "l4",
        Dimension::DriverTeeth => "z4",
        Dimension::Wheels => "wheels",
        Dimension::DrivenTeeth(wheel) => return format!("wheels[{wheel}].z").into(),
        Dimension::Module => "module",
        Dimension::CentreLine(wheel) => return format!("wheels[{wheel}].centre_line_deg").into(),
        Dimension::Tracers => "tracers",
        Dimension::TracerCarrier(tracer) => return format!("tracers[{tracer}].link").into(),
        Dimension::TracerX(tracer) => return format!("tracers[{tracer}].x").into(),
        Dimension::TracerY(tracer) => return format!("tracers[{tracer}].y").into(),
    };
    name.into()
}

/// The name of the field with a link's length.
fn link_field(link: Link) -> &'static str {
    match link {
        Link::Crank => "l1",
        Link::Coupler => "l2",
        Link::Rocker => "l3",
        Link::Frame => "l4",
    }
}
