//! View of a mechanism: the part of a state that does not affect the mechanism.

use assur::motion::InputRate;
use serde::{Deserialize, Serialize};

use crate::Problem;
use crate::problem::Problems;

/// Greatest input: the crank angle, in degrees, that still has all its decimals; the displacement
/// of a driven slide, in the unit of the lengths; the time, seconds.
const INPUT_LIMIT: f64 = 1e6;

/// The greatest speed; a faster motion is no longer visible.
const SPEED_LIMIT: f64 = 1000.0;

/// The greatest ω₁ in rad/s and ε₁ in rad/s², in either sense.
const OMEGA_LIMIT: f64 = 1e4;
const EPSILON_LIMIT: f64 = 1e6;

/// The longest name of a lesson.
const NAME_LIMIT: usize = 64;

/// The view of a mechanism; nothing here changes the mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
pub struct View {
    /// Input, if it is an angle: the crank angle, degrees.
    pub phi_deg: f64,
    /// Input, if it is a length: the displacement of the driven slide, in the unit of the lengths.
    #[serde(default)]
    pub s: f64,
    /// Input, if it is time, seconds.
    #[serde(default)]
    pub t: f64,
    /// Whether the mechanism is moving.
    pub playing: bool,
    /// 1 or −1: sense in which the crank turns.
    #[cfg_attr(test, ts(type = "1 | -1"))]
    pub direction: f64,
    /// Multiple of one turn in six seconds.
    pub speed: f64,
    /// Paths of the joints shown.
    pub traces: bool,
    /// Centres of mass shown. Older states lack this field and the next.
    #[serde(default)]
    pub centres: bool,
    /// Velocity and acceleration analogues of the joints shown.
    #[serde(default)]
    pub vectors: bool,
    /// Vectors of the loop shown.
    #[serde(default)]
    pub loop_vectors: bool,
    /// Arc of the transmission angle shown.
    #[serde(default)]
    pub transmission: bool,
    /// Links in the colours of their Assur groups.
    #[serde(default)]
    pub groups: bool,
    /// Numbers of the links shown.
    #[serde(default)]
    pub numbers: bool,
    /// All assemblies shown: a picture of each, and their map.
    #[serde(default)]
    pub all_assemblies: bool,
    /// The other assemblies shown beside the one that moves, dashed.
    #[serde(default)]
    pub others: bool,
    /// Polygons of velocities and accelerations shown.
    #[serde(default)]
    pub polygons: bool,
    /// Instant centres of all links shown, with the lines that give that of `about` against `relative_to`.
    #[serde(default)]
    pub instant_centres: bool,
    /// Centrodes of `about` shown.
    #[serde(default)]
    pub centrodes: bool,
    /// The inflection circle of `about` and the circles of curvature of traced points, with the evolutes of their paths, shown.
    #[serde(default)]
    pub curvature: bool,
    /// The link of these instant centres, centrodes and circles; empty: the first coupler.
    #[serde(default)]
    pub about: String,
    /// The reference link of the instant centre of `about`; empty: the frame.
    #[serde(default)]
    pub relative_to: String,
    /// Measures between points or links, by name (`A-C.distance`, `A-B-C.corner`,
    /// `crank-rocker.between`): drawn, read out and listed.
    #[serde(default)]
    pub measures: Vec<String>,
    /// Plotted quantities: `angles`, or the name of a point (`C2`).
    #[serde(default = "angles")]
    pub plot: String,
    /// Quantities plotted against each other instead, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub against: Option<Against>,
    /// The plot that is shown alone, if any.
    #[serde(default)]
    pub only: Only,
    /// Variable by which derivatives are taken.
    #[serde(default)]
    pub axes: Axes,
    /// ω₁ of the crank, rad/s.
    #[serde(default = "one")]
    pub omega: f64,
    /// The unit in which ω₁ is written.
    #[serde(default)]
    pub omega_unit: SpeedUnit,
    /// ε₁ of the crank, rad/s².
    #[serde(default)]
    pub epsilon: f64,
    /// Playback at ω₁ instead of `speed`.
    #[serde(default)]
    pub true_time: bool,
    /// The tools for drawing shown.
    #[serde(default)]
    pub drawing: bool,
    /// Difference quotients of φ′ shown over φ″.
    #[serde(default)]
    pub differenced: bool,
    /// The open lesson, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lesson: Option<OpenLesson>,
    /// Large text, thick lines, high contrast.
    #[serde(default)]
    pub projector: bool,
    /// Language of the page.
    pub lang: String,
}

/// A lesson, open at one of its steps.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct OpenLesson {
    /// Its name: that of its folder.
    pub id: String,
    /// The step, counted from 1.
    pub step: u8,
}

/// A quantity, or a derivative of one, plotted against another one, by their names in tables
/// (`C.x`, `rocker.dangle`).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Against {
    /// The abscissa; `input` is the input.
    pub x: String,
    /// The ordinate.
    pub y: String,
}

/// The plot that is shown alone, if one is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Only {
    /// None: all three are shown.
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
    /// The order of the derivatives that are shown alone; none if all are.
    pub fn order(self) -> Option<usize> {
        match self {
            Self::All => None,
            Self::Value => Some(0),
            Self::First => Some(1),
            Self::Second => Some(2),
        }
    }
}

/// Variable by which derivatives are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Axes {
    /// The crank angle.
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
    /// Radians in a second.
    #[default]
    RadPerS,
    /// Turns in a minute.
    PerMin,
}

fn angles() -> String {
    "angles".to_owned()
}

fn one() -> f64 {
    1.0
}

impl Default for View {
    /// The view of a file that does not contain one. (No language: the reader's.)
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

    /// Checks every number and choice.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
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
    /// Whether the name is valid for a folder and the step is counted from 1.
    fn is_sound(&self) -> bool {
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        let length = self.id.len();
        (1..=NAME_LIMIT).contains(&length) && self.id.chars().all(plain) && self.step > 0
    }
}
