//! Sentences on impossible trains, and names of conditions.

use assur::Fault;
use assur::gears::train::{InputError, Member, Relation, Shaft, TrainError};

pub(super) const NO_CONTACT: &str = "z4 - z1 is odd or too small for gears in contact, z2 = (z4 - z1)/2: give z2, \
     without which the satellite's speed is unknown";

/// Says that the ring has `teeth` teeth too many, or too few if negative, and that profile shift may compensate.
pub(super) fn shifted(teeth: f64) -> String {
    let count = teeth.abs();
    let noun = if count == 1.0 { "tooth" } else { "teeth" };
    let more = if teeth > 0.0 { "more" } else { "fewer" };
    format!(
        "z4 has {count} {noun} {more} than standard gears need for a common axis; gears with profile shift may still \
         be built"
    )
}

/// Explains in a sentence why there is no train with these numbers.
pub(super) fn train_error(error: &TrainError) -> String {
    match *error {
        TrainError::Teeth { member, fault } => number(member_name(member), fault),
        TrainError::RingNotLarger { sun, ring } => format!(
            "z4 = {ring} must be greater than z1 = {sun}: in a plane the ring is larger than the sun"
        ),
        TrainError::SatelliteNotInside { satellite, ring } => format!(
            "z4 = {ring} must be greater than {satellite}, the satellite's: it runs inside the ring"
        ),
        TrainError::NoCones {
            sun,
            satellite,
            ring,
        } => format!(
            "bevel wheels with z1 = {sun}, z2 = {satellite}, z4 = {ring} have no pitch cones with one apex: \
             |z4 - z1| must be less than 2 z2"
        ),
        TrainError::Satellites { fault } => number("the number of satellites", fault),
        TrainError::Module { fault } => number("the module", fault),
        TrainError::AxisDistance { fault } => number("the distance of the axes", fault),
    }
}

/// Explains in a sentence why the inputs do not determine the motion.
pub(super) fn input_error(error: &InputError) -> String {
    let speed = |shaft: Shaft| format!("w{}", shaft.number());
    match *error {
        InputError::Number { shaft, fault } => {
            number(&format!("{} or its tie", speed(shaft)), fault)
        }
        InputError::Rise { shaft, fault } => {
            number(&format!("the time in which {} rises", speed(shaft)), fault)
        }
        InputError::TooFast {
            shaft,
            speed: value,
        } => {
            format!("{} would be {value}, too fast", speed(shaft))
        }
        InputError::TiedToItself { shaft } => format!("{} is tied to itself", speed(shaft)),
        InputError::Twice { shaft } => format!("{} is given twice", speed(shaft)),
        InputError::Underdetermined { given } => format!(
            "the motion is under-determined: the train has two freedoms, so two of w1, w3, w4 and ties are needed, \
             here are {given}"
        ),
        InputError::Overdetermined { given } => format!(
            "the motion is over-determined: the train has two freedoms, so two of w1, w3, w4 and ties are needed, \
             here are {given}"
        ),
        InputError::SingularTie { shaft, to, factor } => format!(
            "with the tie {} = {factor} {} the train is singular: no other input determines its motion",
            speed(shaft),
            speed(to)
        ),
    }
}

fn member_name(member: Member) -> &'static str {
    match member {
        Member::Sun => "z1",
        Member::Satellite => "z2",
        Member::Step => "z2-step",
        Member::Ring => "z4",
    }
}

/// Explains in a sentence the fault of a number.
fn number(name: &str, fault: Fault) -> String {
    match fault {
        Fault::NotPositive { value } => format!("{name} must be greater than zero, not {value}"),
        Fault::NotWhole { value } => format!("{name} must be whole, not {value}"),
        Fault::OutOfRange { value, min, max } => {
            format!("{name} must be from {min} to {max}, not {value}")
        }
        _ => format!("{name} is not a finite number"),
    }
}

pub(super) fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::Greater => ">",
        Relation::Less => "<",
        Relation::Multiple => "multiple of",
    }
}
