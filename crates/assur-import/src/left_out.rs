//! Parts that could not be imported unchanged, as codes with parameters. The words are in `lang/`.

use serde::Serialize;

/// A feature of the other program that a linkage lacks or has in another form; serialised as
/// `{"code": "…", parameters}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum LeftOut {
    /// Forces, by name.
    Forces { names: Vec<String> },
    /// Links with masses.
    Masses { names: Vec<String> },
    /// Speed of a crank, revolutions per minute.
    Speed { link: String, rpm: f64 },
    /// Frequency of a cylinder, cycles per minute.
    Pace { link: String, cycles: f64 },
    /// This number of parts that are only drawn.
    Drawn { parts: usize },
    /// Parts that became one rigid link.
    Welded { link: String, parts: Vec<String> },
    /// Links that do not move: fixed at two points, or fastened to a fixed part.
    Fixed { names: Vec<String> },
    /// Points that join nothing.
    Unused { names: Vec<String> },
    /// Pins in curved slots became pins on links of the slots' radii.
    Curved { names: Vec<String> },
    /// A slider without a line to slide on became a hinge.
    Slideless { point: String },
    /// A chain around two wheels became wheels with the same sense of rotation.
    Chain { names: Vec<String> },
    /// Wheels whose ratio is not one of possible numbers of teeth.
    Teeth { names: Vec<String>, ratio: f64 },
    /// Wheels without a common carrier, or otherwise not a pair.
    Wheels { names: Vec<String> },
    /// A further driver whose rate relative to the first was changed so that the motion repeats.
    Ratio { link: String, rate: f64, taken: f64 },
    /// A driven slide whose range was not given, or went beyond what is possible.
    Range { point: String, min: f64, max: f64 },
    /// Oscillating cylinders beside other drivers go one way only.
    OneWay { names: Vec<String> },
    /// A crank that oscillates by an angle, in degrees, turns on.
    Swing { link: String, angle: f64 },
    /// A driver moved only by hand is at rest.
    ByHand { link: String },
    /// A driver that turns or moves nothing.
    Driver { point: String },
    /// A part fastened to one that does not carry it.
    Fastened { name: String },
    /// The drawing's scale.
    Scale { factor: f64 },
    /// An unknown part at the end of a link.
    Unknown { part: String },
}
