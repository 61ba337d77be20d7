//! What could not be taken over as it was, as a code with parameters. The words are in `lang/`.

use serde::Serialize;

/// Something that the other program has and a linkage has not, or has otherwise; serialised as
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
    /// Links that have masses.
    Masses { names: Vec<String> },
    /// How fast a crank is turned, revolutions per minute.
    Speed { link: String, rpm: f64 },
    /// How often a cylinder goes to and fro in a minute.
    Pace { link: String, cycles: f64 },
    /// So many parts that are only drawn.
    Drawn { parts: usize },
    /// Parts that became one rigid link.
    Welded { link: String, parts: Vec<String> },
    /// Links that do not move: fixed at two points, or fastened to what is fixed.
    Fixed { names: Vec<String> },
    /// Points that join nothing.
    Unused { names: Vec<String> },
    /// Pins in curved slots became pins on links of the slots' radii.
    Curved { names: Vec<String> },
    /// A slider without a line to slide on became a hinge.
    Slideless { point: String },
    /// A chain around two wheels became wheels that keep its sense.
    Chain { names: Vec<String> },
    /// Wheels whose ratio is no ratio of whole numbers that may be.
    Teeth { names: Vec<String>, ratio: f64 },
    /// Wheels that share no carrier, or are otherwise no pair.
    Wheels { names: Vec<String> },
    /// A further driver whose rate to the first has another value, so that the motion repeats.
    Ratio { link: String, rate: f64, taken: f64 },
    /// A driven slide whose range was not told, or reached beyond what can be.
    Range { point: String, min: f64, max: f64 },
    /// Cylinders that go to and fro beside other drivers go one way only.
    OneWay { names: Vec<String> },
    /// A crank that goes to and fro by an angle, in degrees, turns on.
    Swing { link: String, angle: f64 },
    /// A driver that is moved by hand alone stands still.
    ByHand { link: String },
    /// A driver that turns or moves nothing.
    Driver { point: String },
    /// A part that is fastened to what does not carry it.
    Fastened { name: String },
    /// The drawing's scale.
    Scale { factor: f64 },
    /// Something at the end of a link that is not known.
    Unknown { part: String },
}
