//! Sentences on tasks that have no linkage, and the names of verdicts.

use assur::synthesis::approximation::{self, TargetError};
use assur::synthesis::four_bar::{
    Bound, Line, MemberError, Order, Passage, StartsError, Task, TaskError, ThreePositions,
};
use assur::synthesis::path::{PathError, StartError};
use assur::synthesis::poses;
use serde_json::{Value, json};

use super::Degrees;

pub(super) const NO_POSITION: &str = "there is no position";
pub(super) const COUPLERS: &str = "--coupler takes one angle for each position";
pub(super) const TRIAL: &str = "--lengths are tried as they are: without --l2 and --free";
pub(super) const NO_TRACING: &str =
    "the search finds no linkage that traces the path; let it compare more, with --candidates";
pub(super) const NO_FIVE: &str = "no four-bar takes up these five positions";
pub(super) const TURNED: &str = "with every PHI2 turned by 180° the positions fit positive lengths: PHI2 is the \
     direction from the output link's hinge with the coupler to its fixed pivot";
pub(super) const ANY: &str = "the positions are mirror images of each other in the line of the frame: every \
     linkage that takes up the one takes up the other in its other assembly, whatever l2 and l3 are";
pub(super) const ONE: &str = "one position: a linkage for every l2 and l3, with l1 as long as the gap that they \
     leave; with l2 and l3 as long as the frame:";
pub(super) const PARALLEL: &str =
    "condition (13) fails: the output link and the driver are parallel";

pub(super) const POSE: &str = "a pose is a place and an angle in degrees, as 2,1.5,30";
pub(super) const POINT: &str = "a point is two numbers, as 2,1.5";
pub(super) const REGION: &str = "a region is two opposite corners, as -1,0,4,2";
pub(super) const WANTED: &str =
    "the poses leave families of dyads: --pivot X,Y or --point X,Y picks one";

/// Describes the fault of a task of poses in a sentence.
pub(super) fn pose_error(error: &poses::TaskError) -> String {
    let pose = |k: usize| format!("pose {}", k + 1);
    match *error {
        poses::TaskError::TooFew { count } => {
            format!("two to five poses are wanted, here is {count}")
        }
        poses::TaskError::TooMany { count } => {
            format!("two to five poses are wanted, here are {count}")
        }
        poses::TaskError::X(k) => format!("{}: x must be from -1e9 to 1e9", pose(k)),
        poses::TaskError::Y(k) => format!("{}: y must be from -1e9 to 1e9", pose(k)),
        poses::TaskError::Angle(k) => format!("{}: the angle is not a finite number", pose(k)),
    }
}

/// States that a pose equals an earlier one.
pub(super) fn repeated(k: usize) -> String {
    format!(
        "pose {} repeats an earlier one and adds no condition",
        k + 1
    )
}

/// Describes special poses in a sentence.
pub(super) fn special(special: &poses::Special) -> String {
    match special {
        poses::Special::Still => "all poses are equal: every dyad guides the body".to_owned(),
        poses::Special::Rotation { pole } => format!(
            "the poses are rotations about ({}, {}): a hinge there guides the body",
            short(pole.x),
            short(pole.y)
        ),
        poses::Special::Line { along } => format!(
            "the poses are parallel and on a line: a slide along ({}, {}) guides the body",
            short(along.x),
            short(along.y)
        ),
        poses::Special::Parallelogram { arm } => format!(
            "the poses are parallel and on a circle: every parallelogram guides the body whose links go from a hinge \
             on the body by ({}, {}) to the hinge on the frame",
            short(arm.x),
            short(arm.y)
        ),
        poses::Special::Parallel => {
            "the poses are parallel, but neither on a line nor on a circle: no dyad guides the body"
                .to_owned()
        }
    }
}

/// Explains in a sentence why points of a path are no task.
pub(super) fn path_error(error: &PathError) -> String {
    match *error {
        PathError::Count(count) => format!(
            "--through: nine points leave a finite number of four-bars, here {} {count}",
            if count == 1 { "is" } else { "are" }
        ),
        PathError::Place(k) => place_error(k),
        PathError::Coincident(j, k) => format!(
            "points {} and {} coincide: fewer than nine different points leave a family of four-bars",
            j + 1,
            k + 1
        ),
        PathError::Line => {
            "all points are in line: no four-bar moves a point through them, a slide does"
                .to_owned()
        }
        PathError::Circle { centre, radius } => format!(
            "all points are on the circle of radius {} about ({}, {}): a crank moves its end through them, with any \
             coupler and rocker",
            short(radius),
            short(beside(centre.x, radius)),
            short(beside(centre.y, radius))
        ),
    }
}

/// Explains in a sentence why points with their crank angles are no path.
pub(super) fn target_error(error: &TargetError) -> String {
    match *error {
        TargetError::TooFew { distinct } => format!(
            "--through: a path has at least three different points, here {} {distinct}",
            if distinct == 1 { "is" } else { "are" }
        ),
        TargetError::NotFinite(k) => place_error(k),
        TargetError::Angles { count } => {
            format!(
                "--angle: give one crank angle per point, here {} {count}",
                if count == 1 { "is" } else { "are" }
            )
        }
        TargetError::Angle(k) => format!("crank angle {}: it must be from -1e9 to 1e9", k + 1),
        TargetError::AnglesOfCurve => {
            "--angle: crank angles belong to points, not to a curve; leave --course out".to_owned()
        }
    }
}

fn place_error(k: usize) -> String {
    format!("point {}: x and y must be from -1e9 to 1e9", k + 1)
}

/// Names in a sentence the linkage for a path on a line or on a circle.
pub(super) fn special_path(special: &approximation::Special) -> String {
    match special {
        approximation::Special::Line { .. } => {
            "all points are in line: the slider of a slider-crank traces the path exactly"
                .to_owned()
        }
        approximation::Special::Circle { centre, radius } => format!(
            "all points are on the circle of radius {} about ({}, {}): the end of a crank traces the path exactly",
            short(*radius),
            short(beside(centre.x, *radius)),
            short(beside(centre.y, *radius))
        ),
    }
}

/// Returns a coordinate, or zero if it is only a rounding error relative to a length.
fn beside(coordinate: f64, length: f64) -> f64 {
    if coordinate.abs() < 1e-9 * length {
        0.0
    } else {
        coordinate
    }
}

/// Describes the fault of the start data of the search for nine points in a sentence.
pub(super) fn start_error(error: StartError) -> String {
    match error {
        StartError::Form => "the start data for nine points are not whole".to_owned(),
        StartError::Checksum => "the start data for nine points are damaged".to_owned(),
        StartError::Curve(k) => format!("the start data for nine points have no curve {}", k + 1),
    }
}

/// Describes the fault of a task in a sentence.
pub(super) fn task_error(error: &TaskError) -> String {
    let position = |k: usize| format!("position {}", k + 1);
    match *error {
        TaskError::FrameLength => "the frame's length must be from 1e-9 to 1e9".to_owned(),
        TaskError::FrameAngle => "the frame's angle is not a finite number".to_owned(),
        TaskError::NoPosition => NO_POSITION.to_owned(),
        TaskError::TooMany { count } => {
            format!(
                "{count} positions are too many: no more than {} are accepted",
                Task::MAX_POSITIONS
            )
        }
        TaskError::Output(k) => format!("{}: PHI2 is not a finite number", position(k)),
        TaskError::Input(k) => format!("{}: PHI3 is not a finite number", position(k)),
        TaskError::Weight(k) => format!("{}: a weight is a number above zero", position(k)),
        TaskError::Equal([j, k]) => {
            format!("positions {} and {} are the same", j + 1, k + 1)
        }
        TaskError::Ratios => "the ratios of lengths are no range".to_owned(),
    }
}

/// Formats the positions taken from a wanted function, as lines `position PHI2,PHI3`. PHI2,PHI3 can be pasted after the
/// option `--position`.
pub(super) fn positions(given: &[Degrees]) -> impl Iterator<Item = String> + '_ {
    let said = |one: &Degrees| {
        format!(
            "{:<14} {},{}",
            "position",
            short(one.output),
            short(one.input)
        )
    };
    given.iter().map(said)
}

/// Explains why no linkage passes through two positions.
pub(super) fn no_family(line: &Line) -> String {
    format!(
        "no four-bar takes up both positions: {} has no positive lengths; PHI2 is the direction from the output link's \
         hinge with the coupler to its fixed pivot, and angles half a turn on may have some",
        equation(line)
    )
}

fn equation(line: &Line) -> String {
    format!(
        "{}/z2 + {}/z3 = {} (zi = li/l0)",
        short(line.output),
        short(line.input),
        short(line.right)
    )
}

/// Explains why no linkage passes through three positions.
pub(super) fn three(found: &ThreePositions, task: &Task) -> String {
    let length = task.frame().length;
    match found {
        ThreePositions::Negative { output, input } => {
            let [l2, l3] = [output, input].map(|z| short(z * length));
            format!(
                "no four-bar takes up all three positions with positive lengths: the one solution is l2 = {l2}, \
                 l3 = {l3}; where a length is negative, angles half a turn on have it positive"
            )
        }
        ThreePositions::None([a, b]) => format!(
            "no four-bar takes up all three positions: {} and {} have no solution",
            equation(a),
            equation(b)
        ),
        ThreePositions::One(_) | ThreePositions::Same(_) => String::new(),
    }
}

/// Explains why the family has no linkage with this length l₂ of the output link.
pub(super) fn member(error: &MemberError, l2: f64, length: f64) -> String {
    match error {
        MemberError::OutOfRange(range) => {
            let from = short(range.from * length);
            let to = range
                .to
                .map(|to| format!(" and less than {}", short(to * length)));
            format!(
                "--l2 {}: the linkages that take up both positions have l2 greater than {from}{}",
                short(l2),
                to.unwrap_or_default()
            )
        }
        MemberError::Same(z) => format!(
            "--l2 {}: all linkages that take up both positions have l2 = {}",
            short(l2),
            short(z * length)
        ),
    }
}

/// Explains why the linkages of a task with free starting angles cannot be listed.
pub(super) fn starts(error: StartsError) -> String {
    match error {
        StartsError::Family { freedoms } => format!(
            "--free: it takes five positions, these leave a family of {freedoms} freedom{}",
            if freedoms == 1 { "" } else { "s" }
        ),
        StartsError::Degenerate => {
            "--free: these positions are special, they leave no finite number of linkages"
                .to_owned()
        }
        StartsError::TooMany => "--free: more than five positions".to_owned(),
    }
}

pub(super) fn passage(passage: Passage) -> String {
    match passage {
        Passage::Continuous => "continuous".to_owned(),
        Passage::ThroughChangePoint => "through-change-point".to_owned(),
        Passage::AcrossDeadPoint => "across-dead-point".to_owned(),
        Passage::OtherCircuit => "other-circuit".to_owned(),
        Passage::Unreached(k) => format!("unreached-{}", k + 1),
    }
}

pub(super) fn order(order: Order) -> &'static str {
    match order {
        Order::Growing => "growing",
        Order::Falling => "falling",
        Order::Either => "either",
        Order::Mixed => "mixed",
    }
}

pub(super) fn bound(bound: Bound) -> &'static str {
    match bound {
        Bound::CouplerLeast => "l1-least",
        Bound::CouplerGreatest => "l1-greatest",
        Bound::OutputLeast => "l2-least",
        Bound::OutputGreatest => "l2-greatest",
        Bound::InputLeast => "l3-least",
        Bound::InputGreatest => "l3-greatest",
    }
}

/// States whether a condition (or a theorem's premise) holds as printed, and whether its conclusion is true in fact.
pub(super) fn asked(holds: bool, truth: bool) -> Value {
    json!({"as_printed": yes_or_no(holds), "in_fact": yes_or_no(truth)})
}

/// Returns the word for a truth value.
pub(super) fn yes_or_no(truth: bool) -> &'static str {
    if truth { "yes" } else { "no" }
}

/// Formats a value for the text report.
pub(super) fn value(value: &Value) -> String {
    match value {
        Value::Null => "-".to_owned(),
        Value::Number(number) => number.as_f64().map_or(number.to_string(), short),
        Value::String(text) => text.clone(),
        Value::Bool(truth) => yes_or_no(*truth).to_owned(),
        Value::Array(all) => {
            let all: Vec<String> = all.iter().map(self::value).collect();
            all.join(", ")
        }
        Value::Object(parts) => {
            let all = parts
                .iter()
                .map(|(key, part)| format!("{key} {}", self::value(part)));
            all.collect::<Vec<String>>().join(", ")
        }
    }
}

/// Formats a number with at most ten significant digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        format!("{}", rounded + 0.0)
    } else {
        format!("{rounded:e}")
    }
}
