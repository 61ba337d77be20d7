//! Saved form of a differential train, whose input is time: wheels with magnets or teeth, two drives, loads.

mod shafts;

use assur::dynamics::{self, Poles, Run, Start};
use assur::gears::train::{
    ConditionKind, Coupling, Drive, Input, Layout, Shaft, TimedInput, Train, Turning,
};
use serde::{Deserialize, Serialize};

mod load;
mod problem;

pub use load::{
    BodiesDocument, MagnetsDocument, MemberDocument, MemberKind, MembersDocument, PolesDocument,
};
pub use problem::GearTrainProblem;

use super::Kind;
use super::numbers::{self, NumberField};
use crate::problem::Problems;
use crate::{LengthUnit, LinkageDocument, LinkageProblem, Problem};

/// Maximum number of characters in a title or source.
const MAX_TEXT: usize = 400;

/// Shortest and longest time span that may be plotted, seconds.
const SPANS: [f64; 2] = [0.5, 60.0];

/// Longest run under load, seconds.
const MAX_RUN: f64 = 30.0;

/// Maximum number of knots of a load.
const MAX_KNOTS: usize = 100;

/// A train of sun 1, satellites 2, carrier 3 and ring 4.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct GearTrainDocument {
    /// Title of the train.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Source of the train.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Name of the catalogue mechanism from which the train was made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<String>,
    /// Arrangement of the wheels.
    #[serde(default)]
    pub form: FormDocument,
    /// Number of plates or teeth of the sun.
    pub z1: f64,
    /// Number of plates or teeth of a satellite; if it is stepped, of its wheel in mesh with the sun.
    pub z2: f64,
    /// Number of plates or teeth of a stepped satellite's wheel in mesh with the ring.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z2_step: Option<f64>,
    /// Number of plates or teeth of the ring.
    pub z4: f64,
    /// Number of satellites.
    #[serde(default = "three")]
    pub satellites: f64,
    /// Coupling of the wheels: by magnets or by teeth in contact.
    #[serde(default)]
    pub coupling: CouplingDocument,
    /// Module: a wheel's diameter divided by its number of plates or teeth.
    #[serde(default = "module")]
    pub module_mm: f64,
    /// Distance of the satellites' axes from the main axis, for magnets; if absent, the gaps at sun and ring are equal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis_distance_mm: Option<f64>,
    /// Drives of two of the three shafts.
    pub drives: Vec<DriveDocument>,
    /// Working members 7 and 8: the tools, such as fans or brushes, that the train drives.
    #[serde(default)]
    pub members: MembersDocument,
    /// The observer in whose frame of reference the train is shown.
    #[serde(default)]
    pub observer: ObserverDocument,
    /// Whether the train runs under load; otherwise the wheels do not slip.
    #[serde(default)]
    pub loaded: bool,
    /// Plotted time span, and duration of a run under load, seconds.
    #[serde(default = "span")]
    pub span_s: f64,
    /// Load on the shaft that is not driven: knots [time in s, torque in N·m]. A positive torque opposes the rotation
    /// that the shaft would have without slip.
    #[serde(default)]
    pub load: Vec<[f64; 2]>,
    /// The magnets of the two meshes.
    #[serde(default)]
    pub magnets: MagnetsDocument,
    /// Inertia, mass and damping of the bodies.
    #[serde(default)]
    pub bodies: BodiesDocument,
}

fn three() -> f64 {
    3.0
}

fn module() -> f64 {
    4.0
}

fn span() -> f64 {
    6.0
}

/// Arrangement of wheels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of the engine")]
pub enum FormDocument {
    #[default]
    Planar,
    Stepped,
    Bevel,
}

/// Coupling of wheels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of the engine")]
pub enum CouplingDocument {
    #[default]
    Magnetic,
    Contact,
}

/// A coaxial shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of the engine")]
pub enum ShaftDocument {
    Sun,
    Carrier,
    Ring,
}

/// The observer in whose frame of reference a train is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "named by what he stands on")]
pub enum ObserverDocument {
    #[default]
    Ground,
    Sun,
    Carrier,
    Ring,
}

/// Drive of a shaft: a given speed, or a multiple of the speed of another shaft.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct DriveDocument {
    /// The driven shaft.
    pub shaft: ShaftDocument,
    /// Speed of the driven shaft, revolutions per minute; 0 if the shaft is held. Not used if `to` is given.
    #[serde(default)]
    pub rpm: f64,
    /// Duration of a uniform acceleration from rest to the speed `rpm`, seconds; 0 for an instantaneous start.
    #[serde(default)]
    pub start_s: f64,
    /// Another shaft, if the speed of the driven shaft is a multiple of the speed of that shaft.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<ShaftDocument>,
    /// Ratio of the driven shaft's speed to that of the shaft `to`.
    #[serde(default = "one")]
    pub factor: f64,
}

fn one() -> f64 {
    1.0
}

/// The train that a document describes.
#[derive(Clone, Debug)]
pub struct GearTrain {
    /// Layout of the wheels, in millimetres.
    pub layout: Layout,
    /// Coupling of the wheels.
    pub coupling: Coupling,
    /// Rotation of the wheels without slip.
    pub turning: Turning,
    /// Model of the train under load; none if the train cannot be run under load.
    pub differential: Option<dynamics::Differential>,
}

impl GearTrainDocument {
    /// The train that the document describes, with its motion.
    ///
    /// # Errors
    /// The problems of the document; those of the model under load only if there are no others.
    pub fn train(&self) -> Result<GearTrain, Vec<Problem>> {
        let mut problems = self.check();
        let layout = self.layout();
        let layout = layout.map_err(|found| problems.extend(found));
        let Ok(layout) = layout else {
            return Err(problems);
        };
        let turning = Turning::new(*layout.train(), &self.inputs());
        let turning = turning.map_err(|errors| {
            problems.extend(errors.into_iter().map(|error| self.input_problem(error)));
        });
        let coupling = self.coupling.into();
        if coupling == Coupling::Magnetic {
            let odd = layout.odd_wheels().map(problem::odd_plates);
            problems.extend(odd);
            let gaps = layout.conditions(coupling).into_iter();
            let gaps = gaps.filter(|one| !one.met()).filter_map(|one| {
                Some(GearTrainProblem::Contact {
                    mesh: match one.kind {
                        ConditionKind::SunGap => ShaftDocument::Sun,
                        ConditionKind::RingGap => ShaftDocument::Ring,
                        _ => return None,
                    },
                    distance: one.left,
                    limit: one.right,
                })
            });
            problems.extend(gaps.map(Problem::from));
        }
        match turning {
            Ok(turning) if problems.is_empty() => {
                let differential = self.differential(&layout, &turning)?;
                Ok(GearTrain {
                    layout,
                    coupling,
                    turning,
                    differential,
                })
            }
            _ => Err(problems),
        }
    }

    fn layout(&self) -> Result<Layout, Vec<Problem>> {
        let named = |errors: Vec<_>| -> Vec<Problem> {
            errors.into_iter().map(problem::of_train).collect()
        };
        let [z1, z2, z4] = [self.z1, self.z2, self.z4];
        let train = match self.form {
            FormDocument::Planar => Train::planar([z1, z2, z4]),
            FormDocument::Stepped => Train::stepped([z1, z2, self.z2_step.unwrap_or(z2), z4]),
            FormDocument::Bevel => Train::bevel([z1, z2, z4]),
        };
        let train = train.map_err(named)?;
        let layout = Layout::new(
            train,
            self.satellites,
            self.module_mm,
            self.axis_distance_mm,
        );
        let layout = layout.map_err(named)?;
        Ok(match self.magnets.poles() {
            Poles::Alike => layout,
            Poles::Alternating => layout.alternating(),
        })
    }

    fn inputs(&self) -> Vec<TimedInput> {
        let drives = self.drives.iter().map(|drive| TimedInput {
            input: Input {
                shaft: drive.shaft.into(),
                drive: match drive.to {
                    None => Drive::Given(drive.rpm),
                    Some(to) => Drive::Tied {
                        to: to.into(),
                        factor: drive.factor,
                    },
                },
            },
            rise: drive.start_s,
        });
        drives.collect()
    }

    /// Checks the fields that the engine does not check.
    fn check(&self) -> Vec<Problem> {
        let mut problems = Problems::default();
        problems.text("title", self.title.as_ref(), MAX_TEXT);
        problems.text("source", self.source.as_ref(), MAX_TEXT);
        let longest = if self.loaded { MAX_RUN } else { SPANS[1] };
        problems.range("span_s", self.span_s, [SPANS[0], longest]);
        for (k, drive) in self.drives.iter().enumerate() {
            // Fields that are not in use must be within limits, too. The engine checks the fields in use.
            let most = [-Turning::FASTEST, Turning::FASTEST];
            match drive.to {
                Some(_) => {
                    problems.range(format!("drives[{k}].rpm"), drive.rpm, most);
                    let start = [0.0, Turning::MAX_RISE];
                    problems.range(format!("drives[{k}].start_s"), drive.start_s, start);
                }
                None => problems.range(format!("drives[{k}].factor"), drive.factor, most),
            }
        }
        if self.load.len() > MAX_KNOTS {
            let (path, max) = ("load".to_owned(), MAX_KNOTS);
            problems.add(LinkageProblem::TooMany { path, max });
        }
        problems.0
    }
}

impl GearTrain {
    /// A run under load that starts without slip.
    ///
    /// # Errors
    /// Problems of the initial state.
    pub fn run(&self, differential: &dynamics::Differential) -> Result<Run, Vec<Problem>> {
        let [sun, _, _, ring] = self.turning.at(0.0).speeds;
        let start = Start::synchronous(differential, sun, ring);
        let run = Run::new(differential.clone(), &start);
        run.map_err(|defects| defects.into_iter().map(problem::of_load).collect())
    }
}

impl Kind for GearTrainDocument {
    fn unit(&self) -> LengthUnit {
        LengthUnit::Mm
    }

    fn origin(&self) -> Option<&str> {
        self.origin.as_deref()
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        Err(vec![GearTrainProblem::ByTime.into()])
    }

    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(numbers::written(self, &numbers::GEAR_TRAIN))
    }
}
