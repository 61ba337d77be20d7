//! Parts that could not be imported unchanged, as codes with parameters. The words are in `lang/`.

use serde::Serialize;

/// A feature of the other program that could not be imported unchanged; serialised as `{"code": "…", parameters}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum LeftOut {
    /// Names of forces.
    Forces { names: Vec<String> },
    /// Names of links with masses.
    Masses { names: Vec<String> },
    /// Speed of a crank, in revolutions per minute.
    Speed { link: String, rpm: f64 },
    /// Frequency of an actuator, in cycles per minute.
    Pace { link: String, cycles: f64 },
    /// Number of parts that are drawn but do not belong to the mechanism.
    Drawn { parts: usize },
    /// Parts that became one rigid link.
    Welded { link: String, parts: Vec<String> },
    /// Links that cannot move: fixed to the frame at two points, or at one point and by a slide.
    Fixed { names: Vec<String> },
    /// Points that belong to no link.
    Unused { names: Vec<String> },
    /// Pins in circular slots, replaced by pins on links as long as the radius of the slot.
    Curved { names: Vec<String> },
    /// A slider without a line to slide on, replaced by a hinge.
    Slideless { point: String },
    /// Two wheels with a chain, replaced by a pair of wheels with the same sense of rotation.
    Chain { names: Vec<String> },
    /// Wheels with a ratio of sizes, `ratio`, that no permitted numbers of teeth give exactly.
    Teeth { names: Vec<String>, ratio: f64 },
    /// Wheels that do not form a pair, for example without a common carrier.
    Wheels { names: Vec<String> },
    /// A driver after the first one. Its rate relative to the first was changed from `rate` to `taken`, so that the
    /// motion repeats.
    Ratio { link: String, rate: f64, taken: f64 },
    /// A driven slide without a given range, or with a range that includes impossible lengths. The range from `min` to
    /// `max` was used instead.
    Range { point: String, min: f64, max: f64 },
    /// Oscillating actuators that are not the only driver, and now move in one direction only.
    OneWay { names: Vec<String> },
    /// A crank that oscillated through this angle, in degrees, and now keeps rotating.
    Swing { link: String, angle: f64 },
    /// An actuator that does not connect exactly two hinges, and became a rigid link.
    Actuator { link: String },
    /// A driver that was moved only by hand and is now at rest.
    ByHand { link: String },
    /// A driver that turns or moves nothing.
    Driver { point: String },
    /// A part fastened to another part that cannot carry it.
    Fastened { name: String },
    /// Scale of the drawing, which is ignored.
    Scale { factor: f64 },
    /// An unknown part at the end of a PMKS+ URL.
    Unknown { part: String },
}
