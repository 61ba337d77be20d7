//! View of a mechanism: the part of a state that does not affect the mechanism.

use assur::motion::InputRate;
use serde::{Deserialize, Serialize};

use crate::Problem;
use crate::problem::Problems;

/// Greatest magnitude of the input: a crank angle in degrees, a displacement in the unit of lengths,
/// or a time in seconds. Greater angles would lose decimals.
const INPUT_LIMIT: f64 = 1e6;

/// Greatest playback speed. A faster motion is no longer visible.
const SPEED_LIMIT: f64 = 1000.0;

/// Greatest magnitude of ω₁, rad/s.
const OMEGA_LIMIT: f64 = 1e4;
/// Greatest magnitude of ε₁, rad/s².
const EPSILON_LIMIT: f64 = 1e6;

/// Maximum number of characters in the name of a lesson.
const NAME_LIMIT: usize = 64;

/// The view of a mechanism. Its fields do not change the mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
pub struct View {
    /// The input if it is an angle: the crank angle, degrees.
    pub phi_deg: f64,
    /// The input if it is a length: the displacement of the driven slide, in the unit of lengths.
    #[serde(default)]
    pub s: f64,
    /// The input if it is time, seconds.
    #[serde(default)]
    pub t: f64,
    /// Whether the mechanism is moving.
    pub playing: bool,
    /// Sense of rotation of the crank, 1 or −1.
    #[cfg_attr(test, ts(type = "1 | -1"))]
    pub direction: f64,
    /// Playback speed, as a multiple of one turn in six seconds.
    pub speed: f64,
    /// Whether the paths of the points in the list `traces` of a linkage are shown.
    pub traces: bool,
    /// Whether centres of mass are shown.
    #[serde(default)]
    pub centres: bool,
    /// Whether velocity and acceleration analogues of moving points are shown; for a differential, velocities of a
    /// satellite.
    #[serde(default)]
    pub vectors: bool,
    /// Whether the vectors of the loop are shown.
    #[serde(default)]
    pub loop_vectors: bool,
    /// Whether the arc of the transmission angle is shown.
    #[serde(default)]
    pub transmission: bool,
    /// Whether links have the colours of their Assur groups.
    #[serde(default)]
    pub groups: bool,
    /// Whether the numbers of the links are shown.
    #[serde(default)]
    pub numbers: bool,
    /// Whether all assemblies are shown: a picture of each, and a map of them.
    #[serde(default)]
    pub all_assemblies: bool,
    /// Whether the other assemblies are shown, dashed, beside the one that moves.
    #[serde(default)]
    pub others: bool,
    /// Whether the polygons of velocities and accelerations are shown.
    #[serde(default)]
    pub polygons: bool,
    /// Whether reactions and applied forces are shown: arrows in the drawing, and a table of all reactions.
    #[serde(default)]
    pub forces: bool,
    /// Whether force plans, Zhukovsky's lever and free bodies are shown.
    #[serde(default)]
    pub force_plan: bool,
    /// Whether the motion under load is shown: motor, run in time, steady cycle, flywheel.
    #[serde(default)]
    pub under_load: bool,
    /// Whether the instant centres of all links are shown, with the lines that locate the instant centre of `about`
    /// relative to `relative_to`.
    #[serde(default)]
    pub instant_centres: bool,
    /// Whether the centrodes of `about` are shown.
    #[serde(default)]
    pub centrodes: bool,
    /// Whether the inflection circle of `about` is shown, and the circles of curvature and evolutes of traced paths.
    #[serde(default)]
    pub curvature: bool,
    /// The link whose instant centre, centrodes and inflection circle are shown. If empty, the first link with two or
    /// more points that is not joined to the frame; if there is none, the last link.
    #[serde(default)]
    pub about: String,
    /// The reference link of the instant centre of `about`; if empty, the frame.
    #[serde(default)]
    pub relative_to: String,
    /// Drawn and listed measures between points or links, by name: `A-C.distance`, `A-B-C.corner`,
    /// `crank-rocker.between`.
    #[serde(default)]
    pub measures: Vec<String>,
    /// Plotted quantities: `angles`, or the name of a quantity or a point, such as `C2`.
    #[serde(default = "angles")]
    pub plot: String,
    /// Two quantities plotted against each other instead of against the input, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub against: Option<Against>,
    /// The plot that is shown alone, if any.
    #[serde(default)]
    pub only: Only,
    /// Variable with respect to which derivatives are taken.
    #[serde(default)]
    pub axes: Axes,
    /// Angular velocity ω₁ of the crank, rad/s.
    #[serde(default = "one")]
    pub omega: f64,
    /// The unit in which ω₁ is written.
    #[serde(default)]
    pub omega_unit: SpeedUnit,
    /// Angular acceleration ε₁ of the crank, rad/s².
    #[serde(default)]
    pub epsilon: f64,
    /// Whether playback is at ω₁ instead of `speed`.
    #[serde(default)]
    pub true_time: bool,
    /// Whether the tools for drawing are shown.
    #[serde(default)]
    pub drawing: bool,
    /// Symbol unit of the drawing, in the unit of lengths, while a person draws. The page sets it; no file has it.
    #[serde(skip)]
    pub symbol: Option<f64>,
    /// Whether difference quotients of the first derivatives are plotted on top of the second derivatives.
    #[serde(default)]
    pub differenced: bool,
    /// The open lesson, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lesson: Option<OpenLesson>,
    /// Whether the page has large text, thick lines and high contrast, as for a projector.
    #[serde(default)]
    pub projector: bool,
    /// Language of the page.
    pub lang: String,
}

/// An open lesson, with the step that is shown.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct OpenLesson {
    /// Name of the lesson, which is also that of its folder.
    pub id: String,
    /// The step, counted from 1.
    pub step: u8,
}

/// Two quantities or derivatives plotted against each other, by their column headings in tables, such
/// as `C.x` or `rocker.dangle`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Against {
    /// The abscissa; `input` stands for the input.
    pub x: String,
    /// The ordinate.
    pub y: String,
}

/// The plot that is shown alone, if one is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Only {
    /// All three plots are shown.
    #[default]
    All,
    /// The plot of the quantities themselves.
    Value,
    /// The plot of their first derivatives.
    First,
    /// The plot of their second derivatives.
    Second,
}

impl Only {
    /// The order of the derivatives that are shown alone; none if all plots are shown.
    pub fn order(self) -> Option<usize> {
        match self {
            Self::All => None,
            Self::Value => Some(0),
            Self::First => Some(1),
            Self::Second => Some(2),
        }
    }
}

/// Variable with respect to which derivatives are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Axes {
    /// The input, such as the crank angle.
    #[default]
    Analogues,
    /// Time, with ω₁ and ε₁ of the crank.
    Physical,
}

/// A unit of angular velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum SpeedUnit {
    /// Radians per second.
    #[default]
    RadPerS,
    /// Revolutions per minute.
    PerMin,
}

fn angles() -> String {
    "angles".to_owned()
}

fn one() -> f64 {
    1.0
}

impl Default for View {
    /// The view for a file that contains none. The empty language stands for the reader's own.
    fn default() -> Self {
        Self {
            phi_deg: 0.0,
            s: 0.0,
            t: 0.0,
            playing: false,
            direction: 1.0,
            speed: 1.0,
            traces: true,
            centres: false,
            vectors: false,
            loop_vectors: false,
            transmission: false,
            groups: false,
            numbers: false,
            all_assemblies: false,
            others: false,
            polygons: false,
            forces: false,
            force_plan: false,
            under_load: false,
            instant_centres: false,
            centrodes: false,
            curvature: false,
            about: String::new(),
            relative_to: String::new(),
            measures: Vec::new(),
            plot: angles(),
            against: None,
            only: Only::default(),
            axes: Axes::default(),
            omega: one(),
            omega_unit: SpeedUnit::default(),
            epsilon: 0.0,
            true_time: false,
            drawing: false,
            symbol: None,
            differenced: false,
            lesson: None,
            projector: false,
            lang: String::new(),
        }
    }
}

impl View {
    /// The input rate for plots and read-outs.
    pub fn input(&self) -> InputRate {
        match self.axes {
            Axes::Analogues => InputRate::ANALOGUES,
            Axes::Physical => InputRate {
                speed: self.omega,
                acceleration: self.epsilon,
            },
        }
    }

    /// Checks all numbers, the sense of rotation and the open lesson. Names are checked when the mechanism is drawn.
    ///
    /// # Errors
    /// All problems, each naming its field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Problems::default();
        for (field, value, limit) in [
            ("phi_deg", self.phi_deg, INPUT_LIMIT),
            ("s", self.s, INPUT_LIMIT),
            ("t", self.t, INPUT_LIMIT),
            ("omega", self.omega, OMEGA_LIMIT),
            ("epsilon", self.epsilon, EPSILON_LIMIT),
        ] {
            problems.range(field, value, [-limit, limit]);
        }
        if self.true_time && self.omega == 0.0 {
            let field = "omega".into();
            problems.add(Problem::AtRest { field });
        }
        if self.direction.abs() != 1.0 {
            let field = "direction".into();
            problems.add(Problem::UnknownChoice { field });
        }
        let value = self.speed;
        if value.is_finite() && value <= 0.0 {
            let field = "speed".into();
            problems.add(Problem::NotPositive { field, value });
        } else {
            problems.range("speed", value, [0.0, SPEED_LIMIT]);
        }
        if !self.lesson.as_ref().is_none_or(OpenLesson::is_sound) {
            let field = "lesson".into();
            problems.add(Problem::UnknownChoice { field });
        }
        problems.end()
    }
}

impl OpenLesson {
    /// Whether the name is valid for a folder, and the step is at least 1.
    fn is_sound(&self) -> bool {
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        let length = self.id.len();
        (1..=NAME_LIMIT).contains(&length) && self.id.chars().all(plain) && self.step > 0
    }
}
