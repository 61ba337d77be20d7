//! Problems of a linkage, as codes with parameters: paths of fields, names of links and points. Their
//! texts are in `lang/`.

use assur::forces::Unbalanced;
use assur::mechanism::{Cause, Defect, Mechanism, Singularity, Unsolved};
use assur::motion::TooManyTurns;
use serde::Serialize;

use crate::Field;

/// A problem of a linkage; serialised as `{"code": "…", parameters}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum LinkageProblem {
    /// A list that is too long.
    TooMany {
        path: String,
        max: usize,
    },
    /// A name that is empty or too long, or contains control characters.
    BadName {
        path: String,
        max: usize,
    },
    /// A title or source that is too long or contains control characters.
    BadText {
        path: String,
        max: usize,
    },
    /// A length of a link that also has a shape, or that does not have exactly two points.
    LengthOfTwo {
        path: String,
    },
    /// A length that is not greater than zero.
    BadLength {
        path: String,
        value: f64,
    },
    /// A dwell band whose width is not greater than zero.
    BadBand {
        path: String,
        value: f64,
    },
    /// A length or shape of a link that is fixed to another link and so takes its dimensions from the drawing.
    FixedAsDrawn {
        path: String,
    },
    /// A driver that is neither a crank nor a slide with its range, or that is both.
    BadDriver {
        path: String,
    },
    /// A plot of a quantity that does not exist.
    NothingToPlot {
        path: String,
    },
    /// A trace of a point that does not exist.
    NothingToTrace {
        path: String,
    },
    /// A lock that does not name two or three distinct points.
    BadLock {
        path: String,
    },
    /// A drawing in which links are in line.
    OpenInLine {
        links: Vec<String>,
    },
    /// A drawing in which a link is perpendicular to its guide.
    OpenPerpendicular {
        links: Vec<String>,
    },
    /// A drawing in which a group is in a singular position.
    OpenSingular {
        links: Vec<String>,
    },
    /// The input is not finite, or outside the range of the driven slide.
    BeyondRange,
    /// The motion does not reach this input, although a pose exists.
    Unreached,
    /// The motion could not be followed up to this input.
    Unfollowed,
    /// Extrema are not computed: the motion repeats only after `turns` turns, and at most `most` turns are searched.
    TooManyTurns {
        turns: usize,
        most: usize,
    },
    /// Links are too short, or too long, to meet.
    LinksApart {
        links: Vec<String>,
        by: f64,
    },
    /// A link does not reach its guide.
    OutOfReach {
        links: Vec<String>,
        by: f64,
    },
    /// Guides have become parallel.
    GuidesParallel {
        links: Vec<String>,
    },
    /// The angles of links are undetermined.
    LinksUndetermined {
        links: Vec<String>,
    },
    /// Derivatives are unbounded: links are in line.
    LinksDeadPoint {
        links: Vec<String>,
    },
    /// A redundant constraint of a link does not hold where the other constraints do.
    ConstraintBroken {
        link: String,
        by: f64,
    },
    /// Derivatives are unbounded: a link is perpendicular to its guide.
    LinksPerpendicular {
        links: Vec<String>,
    },
    /// Derivatives are unbounded: a group is in a singular position.
    LinksSingular {
        links: Vec<String>,
    },
    /// A point without a circle of curvature because it is at rest: at a cusp of its path, or permanently.
    StandsStill {
        point: String,
    },
    /// A point without a circle of curvature because its path is straight there.
    StraightPath {
        point: String,
    },
    /// A link that does not rotate in this pose and so has no inflection circle.
    NotTurning {
        link: String,
    },
    /// A dimension that cannot be increased to a value: this value exceeds the last possible one, `last`, by `by`.
    /// Beyond `last`, these links cannot be joined.
    TooLarge {
        field: Field,
        by: f64,
        links: Vec<String>,
        last: f64,
    },
    /// A dimension that cannot be decreased to a value; see [`LinkageProblem::TooLarge`].
    TooSmall {
        field: Field,
        by: f64,
        links: Vec<String>,
        last: f64,
    },
    /// A required band, arc or stroke of a dwell is not positive and finite, or the required arc exceeds a turn.
    BadWish {
        field: Field,
    },
    /// The output of which a dwell is sought does not exist or is an undirected angle.
    NoOutput,
    /// A search in which no dimension may change.
    NothingMoves,
    /// A dimension to be changed that the mechanism does not have.
    NoDimension {
        name: String,
    },
    /// A dimension's range that is not finite, is empty, excludes the dimension's value, or lets a length become zero.
    BadRange {
        name: String,
    },
    /// A search from a linkage whose driver cannot turn fully, or that comes close to a singular position.
    Blocked,
    /// Two points of a drawing that coincide but must be distinct.
    OnePlace {
        points: [String; 2],
    },
    /// Two points that cannot be joined in a hinge, since both belong to the same link.
    OneLink {
        link: String,
        points: [String; 2],
    },
    /// A point that cannot slide along a line, since it defines the line or belongs to the line's link.
    OnItsLine {
        link: String,
        point: String,
    },
    /// A link without a line, since it has fewer than two distinct points.
    NoLine {
        link: String,
    },
    /// A dyad of three slides, which does not exist.
    NoSuchDyad,
    /// A load, spring, damper or motor with too many fields, or with too few.
    UnclearForce {
        path: String,
    },
    /// A load, spring or damper on a link that does not exist.
    ForceOnNoLink {
        path: String,
        name: String,
    },
    /// A load, spring or damper at a point that its link does not have.
    ForceOnNoPoint {
        path: String,
        link: String,
        point: String,
    },
    /// A force, stiffness, damping or speed that is not a valid number, or a table out of order.
    ForceNoNumber {
        path: String,
    },
    /// A spring or damper with both ends on one rigid body.
    ForceIdle {
        path: String,
    },
    /// Friction at a point without a hinge, or of a link that does not slide.
    FrictionNoPair {
        path: String,
        name: String,
    },
    /// Friction of a pair that an earlier entry names already.
    FrictionTwice {
        path: String,
        name: String,
    },
    /// Friction that Newton's method does not find in a pose.
    FrictionUnsettled,
    /// Friction that holds the mechanism, whatever the driver does.
    SelfLocking,
    /// A motion under load of a linkage with several drivers.
    RunSeveralDrivers,
    /// Dry friction in a motion under load of a linkage with several drivers.
    RunFriction,
    /// A motion under load of links without mass.
    RunNoInertia,
    /// A spring between two links of which one turns fully relative to the other.
    RunWound {
        path: String,
    },
    /// A flywheel on a linkage whose first driver is no crank.
    FlywheelNoCrank,
    /// A steady cycle without a motor and without a mean rate.
    CycleNoRate,
    /// A steady cycle of a driver that does not turn fully.
    CycleNotFull,
    /// A steady cycle for whose loads the motor does too little or too much work at every rate.
    CycleUnbalanced,
    /// A steady cycle that is not found, because the linkage stops or its energy does not settle.
    CycleNotFound,
    CycleLocked,
    /// A coefficient of non-uniformity that is not greater than zero, or too great.
    BadNonUniformity {
        max: f64,
    },
    /// Counterweights of a linkage that is not a four-bar with hinges.
    NotFourBar,
    /// Counterweights of a four-bar without masses, or with masses that are already balanced.
    AlreadyBalanced,
    /// Links whose reactions are unbounded in a singular pose.
    ReactionsUnbounded {
        links: Vec<String>,
    },
    /// A defect of the specification.
    #[serde(untagged)]
    Defect(Defect),
}

impl LinkageProblem {
    /// The reason why a pose has no reactions, with the names of the links concerned.
    pub fn unbalanced(unbalanced: Unbalanced, mechanism: &Mechanism) -> Self {
        match unbalanced {
            Unbalanced::Singular { step } => Self::ReactionsUnbounded {
                links: mechanism.links_of(step).map(str::to_owned).collect(),
            },
            Unbalanced::Locked => Self::SelfLocking,
            Unbalanced::Unsettled => Self::FrictionUnsettled,
        }
    }

    /// The reason why a mechanism has no pose, with the names of the links concerned.
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
