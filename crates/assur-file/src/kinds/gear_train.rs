//! A differential train by time, as it is saved: wheels with magnets or teeth, two drives, and what loads it.

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

/// The longest text, in characters.
const LONGEST_TEXT: usize = 400;

/// The spans of time that are plotted, seconds.
const SPANS: [f64; 2] = [0.5, 60.0];

/// A run under load is followed for no longer, seconds.
const LONGEST_RUN: f64 = 30.0;

/// The most knots of a load.
const MOST_KNOTS: usize = 100;

/// A train of sun 1, satellites 2, carrier 3 and ring 4.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct GearTrainDocument {
    /// What it is called.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Where it comes from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// The mechanism of the catalogue that it was made from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<String>,
    /// How the wheels stand.
    #[serde(default)]
    pub form: FormDocument,
    /// Plates or teeth of the sun.
    pub z1: f64,
    /// Those of a satellite; of a stepped one where it meets the sun.
    pub z2: f64,
    /// Those of a stepped satellite where it meets the ring.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z2_step: Option<f64>,
    /// Those of the ring.
    pub z4: f64,
    /// How many satellites there are.
    #[serde(default = "three")]
    pub satellites: f64,
    /// How the wheels turn each other.
    #[serde(default)]
    pub coupling: CouplingDocument,
    /// Module: a wheel's diameter over its number.
    #[serde(default = "module")]
    pub module_mm: f64,
    /// Of magnets: how far the satellites' axes are from the main one; without it gaps are equal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis_distance_mm: Option<f64>,
    /// What turns two of the three shafts.
    pub drives: Vec<DriveDocument>,
    /// Working members 7 and 8.
    #[serde(default)]
    pub members: MembersDocument,
    /// From where it is seen.
    #[serde(default)]
    pub observer: ObserverDocument,
    /// Whether it runs under load; else nothing slips.
    #[serde(default)]
    pub loaded: bool,
    /// The span of time that is plotted, and that a run under load lasts.
    #[serde(default = "span")]
    pub span_s: f64,
    /// Times (s) and torques (N·m) of a load on the shaft that is not driven, against the sense in which that turns while nothing slips.
    #[serde(default)]
    pub load: Vec<[f64; 2]>,
    /// The magnets of the two meshes.
    #[serde(default)]
    pub magnets: MagnetsDocument,
    /// The bodies in the order of their numbers 1, 2, 3, 4.
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

/// How wheels stand.
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

/// How wheels turn each other.
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

/// Who looks on, and stands still for himself.
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

/// What turns a shaft: a speed, or a tie to another shaft.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct DriveDocument {
    /// Which.
    pub shaft: ShaftDocument,
    /// Its speed, revolutions per minute; 0: it is held. Of a tied shaft, the speed that it has without the tie.
    #[serde(default)]
    pub rpm: f64,
    /// It rises evenly from rest in so many seconds; 0: it has that speed at once.
    #[serde(default)]
    pub start_s: f64,
    /// The shaft to which it is tied.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<ShaftDocument>,
    /// Its speed relative to that of the shaft to which it is tied.
    #[serde(default = "one")]
    pub factor: f64,
}

fn one() -> f64 {
    1.0
}

/// What a document comes to.
#[derive(Clone, Debug)]
pub struct GearTrain {
    /// The wheels in their places, in millimetres.
    pub layout: Layout,
    /// How they turn each other.
    pub coupling: Coupling,
    /// How they turn while nothing slips.
    pub turning: Turning,
    /// What moves under load; none where that is not followed.
    pub differential: Option<dynamics::Differential>,
}

impl GearTrainDocument {
    /// The train in its motion.
    ///
    /// # Errors
    /// Everything that is wrong with it.
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

    /// Checks what the engine does not ask about.
    fn check(&self) -> Vec<Problem> {
        let mut problems = Problems::default();
        problems.text("title", self.title.as_ref(), LONGEST_TEXT);
        problems.text("source", self.source.as_ref(), LONGEST_TEXT);
        let longest = if self.loaded { LONGEST_RUN } else { SPANS[1] };
        problems.range("span_s", self.span_s, [SPANS[0], longest]);
        for (k, drive) in self.drives.iter().enumerate() {
            // What is not in use is a number all the same; the engine looks at the other.
            let most = [-Turning::FASTEST, Turning::FASTEST];
            match drive.to {
                Some(_) => {
                    problems.range(format!("drives[{k}].rpm"), drive.rpm, most);
                    let start = [0.0, Turning::LONGEST_RISE];
                    problems.range(format!("drives[{k}].start_s"), drive.start_s, start);
                }
                None => problems.range(format!("drives[{k}].factor"), drive.factor, most),
            }
        }
        if self.load.len() > MOST_KNOTS {
            let (path, max) = ("load".to_owned(), MOST_KNOTS);
            problems.add(LinkageProblem::TooMany { path, max });
        }
        problems.0
    }
}

impl GearTrain {
    /// It under load from the start, where nothing slips yet.
    ///
    /// # Errors
    /// A start that cannot be.
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
