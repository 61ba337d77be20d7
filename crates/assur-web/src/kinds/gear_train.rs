//! Differential gear train on the page, with time as the input: without slip, or under load.

pub(crate) mod course;
mod quantity;
pub(crate) mod summary;

use assur::Relation;
use assur_draw::{TrainFigure, TrainView, WorkingMember};
use assur_file::{GearTrainDocument, MemberDocument, MemberKind, Problem, State};
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::{Capabilities, Edited, Moves, Rigid, unknown};
use crate::change::Change;
use crate::convert::to_js;
use course::Course;
use summary::GearTrainSummary;

pub(crate) struct GearTrain {
    document: GearTrainDocument,
    course: Course,
    figure: TrainFigure,
}

impl GearTrain {
    #[inline(never)]
    pub(crate) fn new(state: &State, document: &GearTrainDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let train = document.train()?;
        let member = |member: Option<MemberDocument>| member.map(|one| drawn(one.kind));
        let view = TrainView {
            coupling: train.coupling,
            poles: document.magnets.poles(),
            members: [document.members.satellite, document.members.carrier].map(member),
            velocities: state.view.vectors,
        };
        let figure = TrainFigure::new(&train.layout, view);
        let course = Course::new(train, document, &state.view)?;
        Ok(Self {
            document: document.clone(),
            course,
            figure,
        })
    }
}

fn drawn(kind: MemberKind) -> WorkingMember {
    match kind {
        MemberKind::Fan => WorkingMember::Fan,
        MemberKind::Brush => WorkingMember::Brush,
        MemberKind::Stirrer => WorkingMember::Stirrer,
        MemberKind::Scraper => WorkingMember::Scraper,
        MemberKind::Blade => WorkingMember::Blade,
        MemberKind::Propeller => WorkingMember::Propeller,
        MemberKind::RoadWheel => WorkingMember::RoadWheel,
    }
}

impl Capabilities for GearTrain {
    fn summary(&self) -> JsValue {
        to_js(&GearTrainSummary::new(self))
    }

    fn rigid(&self) -> Rigid<'_> {
        Rigid {
            names: self.figure.names(),
            list: self.figure.rigid().numbers(),
        }
    }

    fn moves(&self) -> Option<&dyn Moves> {
        Some(self)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }

    fn relations(&self, input: f64) -> Result<Vec<Relation>, Problem> {
        Ok(self.course.relations(input))
    }
}

/// Default times of a load, as fractions of the span: start of the rise, full load, start of the fall, end.
const LOADED: [f64; 4] = [0.15, 0.5, 0.7, 0.75];

impl Edited for GearTrain {
    /// Sets the greatest torque of the load, the only dimension of a train. The times of the load are kept, except for
    /// a load without torque that does not have four knots: it gets the times of [`LOADED`].
    fn set(&self, field: &str, value: f64, _input: f64) -> Result<Change, Vec<Problem>> {
        if field != "load" {
            return Err(vec![unknown(field)]);
        }
        let field = "load".into();
        if !value.is_finite() {
            return Err(vec![Problem::NotANumber { field }]);
        }
        if value < 0.0 {
            let (min, max) = (0.0, f64::MAX);
            return Err(vec![Problem::OutOfRange {
                field,
                value,
                min,
                max,
            }]);
        }
        let most = summary::greatest(&self.document.load);
        let load: Vec<[f64; 2]> = if most > 0.0 {
            let knots = self.document.load.iter();
            knots
                .map(|[time, torque]| [*time, torque * (value / most)])
                .collect()
        } else {
            // A load whose torques were all set to zero still has its times.
            let times: Vec<f64> = self.document.load.iter().map(|[time, _]| *time).collect();
            let times = <[f64; 4]>::try_from(times);
            let [from, full, until, off] =
                times.unwrap_or_else(|_| LOADED.map(|part| part * self.document.span_s));
            vec![[from, 0.0], [full, value], [until, value], [off, 0.0]]
        };
        Ok(Change::document(&json!({ "load": load })))
    }

    fn drag(&self, point: &str, _input: f64, _to: assur::Point) -> Result<Change, Problem> {
        Err(unknown(point))
    }
}
