//! A path on the page, with a linkage whose point traces it.

pub(crate) mod atlas;
pub(crate) mod search;
pub(crate) mod summary;

use assur::Point;
use assur::motion::{Sampling, Spacing};
use assur::synthesis::approximation::{Course, Traced, Tracing};
use assur::synthesis::cognates::{CouplerFourBar, CouplerSliderCrank};
use assur_draw::{Guidance, GuidanceSheet, Role};
use assur_file::{
    CourseDocument, Document, Moved, PathDocument, PathProblem, PathTask, Problem, State,
};
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::{Capabilities, Edited, Rigid, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::handle::{Handle, HandlePlace};
use crate::here::Here;
use crate::kinds::task;
use crate::moving::Moving;
use summary::PathSummary;

/// Greatest number of points that can be dragged one by one.
const MOST_HANDLES: usize = 24;

/// Number of points taken from the curve of a linkage that becomes a path: few enough to be dragged one by one.
const PLACES: usize = MOST_HANDLES;

/// Distance of a point from the traced curve, as a part of the path's size, up to which the point is met.
const MET: f64 = 1e-6;

/// Number of steps of a dragged point over the size of the path.
const STEPS: f64 = 500.0;

pub(crate) struct Path {
    document: PathDocument,
    task: PathTask,
    /// The shown linkage; none if no linkage traces the path.
    shown: Option<Shown>,
    /// The path alone.
    sheet: GuidanceSheet,
    /// Handles of the points.
    held: Vec<Handle>,
}

/// The linkage that is shown.
struct Shown {
    /// As a document for the simulator.
    linkage: Document,
    moving: Moving,
    traced: Traced,
}

impl Path {
    #[inline(never)]
    pub(crate) fn new(state: &State, document: &PathDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let task = document.task()?;
        let shown = Shown::new(state, &task)?;
        let sheet = GuidanceSheet::new(&drawing(&task, &[]), state.view.symbol);
        Ok(Self {
            held: held(&task).collect(),
            document: document.clone(),
            task,
            shown,
            sheet,
        })
    }
}

/// Converts a moving linkage to the path of its first traced point that is on the coupler of a four-bar or on the rod of
/// a slider-crank, with that linkage.
///
/// # Errors
/// No pose at this input; no such point.
pub(crate) fn of(moving: &Moving, input: f64) -> Result<PathDocument, Problem> {
    let (mechanism, motion) = (moving.mechanism(), moving.motion());
    let pose = moving.pose(input)?;
    let document = moving.document();
    let tracers = document.tracers.iter().map(|tracer| &tracer.name);
    let tracing = document.traces.iter().chain(tracers).find_map(|name| {
        let four_bar = CouplerFourBar::of(mechanism, &pose, name).map(Tracing::FourBar);
        let slider_crank = || CouplerSliderCrank::of(mechanism, &pose, name);
        let found = four_bar.or_else(|| slider_crank().map(Tracing::SliderCrank))?;
        Some((mechanism.point(name)?, found))
    });
    let (point, tracing) = tracing.ok_or(PathProblem::NoCouplerPoint)?;
    let inputs = motion.samples(Sampling {
        turn: PLACES,
        coarsest: PLACES,
        most: PLACES,
        spacing: Spacing::Even,
        shown: assur::motion::Shown::First,
    });
    let is_full = motion.cycle().is_full();
    let places = inputs.iter().flatten().filter_map(|input| {
        let pose = motion.pose::<1>(*input).ok()?;
        Some(mechanism.place(&pose, point).place().into())
    });
    let mut path: Vec<[f64; 2]> = places.collect();
    if is_full {
        path.pop();
    }
    Ok(PathDocument {
        unit: document.unit,
        course: if is_full {
            CourseDocument::Closed
        } else {
            CourseDocument::Open
        },
        path,
        angles_deg: Vec::new(),
        linkage: Some((&tracing).into()),
    })
}

/// The path as it is drawn. `distances` are those of its points from the traced curve.
fn drawing(task: &PathTask, distances: &[f64]) -> Guidance {
    let points = task.target.points();
    let mut path = Vec::new();
    if task.target.course() != Course::Points {
        path.extend(points);
        if task.target.course() == Course::Closed {
            path.extend(points.first());
        }
    }
    let within = MET * task.target.size();
    let marks = listed(task).iter().enumerate().map(|(k, at)| {
        let number = match task.target.course() {
            Course::Points => (k + 1).to_string(),
            Course::Open | Course::Closed => String::new(),
        };
        let is_met = distances.get(k).is_some_and(|distance| *distance <= within);
        (number, *at, is_met)
    });
    Guidance {
        marks: marks.collect(),
        path,
        ..Guidance::default()
    }
}

/// The points that can be dragged one by one: none if there are too many.
fn listed(task: &PathTask) -> &[Point] {
    let points = task.target.points();
    if points.len() > MOST_HANDLES {
        &[]
    } else {
        points
    }
}

/// Handles of the points that can be dragged.
fn held(task: &PathTask) -> impl Iterator<Item = Handle> + '_ {
    listed(task).iter().enumerate().map(|(k, at)| Handle {
        name: format!("point{}", k + 1),
        role: Role::Accent2.name(),
        at: HandlePlace::Fixed(*at),
    })
}

impl Shown {
    fn new(state: &State, task: &PathTask) -> Result<Option<Self>, Vec<Problem>> {
        let Some(tracing) = &task.shown else {
            return Ok(None);
        };
        let linkage = task.linkage()?;
        let moved = Moved::new(linkage.clone(), &state.view.plot)?;
        let Some(traced) = Traced::new(tracing, &moved.motion, &task.target) else {
            return Ok(None);
        };
        let moving = task::moving(&state.view, moved, drawing(task, &traced.distances))?;
        Ok(Some(Self {
            linkage: Document::Linkage(linkage),
            moving: moving.held_by(held(task)),
            traced,
        }))
    }
}

impl Capabilities for Path {
    fn summary(&self) -> JsValue {
        to_js(&PathSummary::new(self))
    }

    fn rigid(&self) -> Rigid<'_> {
        match &self.shown {
            Some(shown) => shown.moving.figure().into(),
            None => Rigid {
                names: self.sheet.names(),
                list: &[],
            },
        }
    }

    fn still(&self, _opened: f64) -> Here {
        Here::still(self.sheet.frame(), listed(&self.task).iter().copied())
    }

    fn linkage(&self) -> Option<&Moving> {
        self.shown.as_ref().map(|shown| &shown.moving)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }
}

impl Edited for Path {
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem> {
        if let Some(moving) = self.linkage()
            && let Some(driven) = moving.mechanism().point(point)
        {
            let to = moving.driven_to(driven, input, to);
            return to.unwrap_or_else(|| Err(unknown(point))).map(Change::input);
        }
        let number = self.held.iter().position(|handle| handle.name == point);
        let number = number.ok_or_else(|| unknown(point))?;
        let mut points = self.document.path.clone();
        let steps = 10.0_f64.powf((STEPS / self.task.target.size()).log10().ceil());
        points[number] = [to.x, to.y].map(|value| (value * steps).round() / steps);
        Ok(Change::document(&json!({ "path": points })))
    }
}
