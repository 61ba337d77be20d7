//! Any linkage on the page.

use assur::Point;
use assur::mechanism::Quantity;
use assur_draw::{Annotations, List};
use assur_file::{
    LinkDocument, LinkageDocument, LinkageProblem, PointDocument, Problem, State, TracerDocument,
};
use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::change::Change;
use crate::convert::to_js;
use crate::moving::Moving;
use crate::shown::{Edited, Shown, unknown};
use crate::summary::MotionSummary;

/// A linkage with all that is drawn of it.
pub(crate) struct Linkage(Moving);

impl Linkage {
    pub(crate) fn new(state: &State) -> Result<Self, Vec<Problem>> {
        let moved = state.moved()?;
        let explain =
            |mechanism: &_, unsolved: &_| LinkageProblem::unsolved(unsolved, mechanism).into();
        let quantities = Quantity::all(moved.motion.mechanism());
        let moving = Moving::new(
            &state.view,
            moved,
            Annotations::default(),
            quantities,
            Box::new(explain),
        )?;
        Ok(Self(moving))
    }
}

/// The fields of a linkage that are others where it is drawn anew. The drawing tells the
/// assembly, so none is left that is meant by its number.
#[derive(Serialize)]
pub(crate) struct Redrawn {
    points: Vec<PointDocument>,
    links: Vec<LinkDocument>,
    tracers: Vec<TracerDocument>,
    assembly: Option<usize>,
}

impl Redrawn {
    pub(crate) fn of(document: LinkageDocument) -> Self {
        Self {
            points: document.points,
            links: document.links,
            tracers: document.tracers,
            assembly: None,
        }
    }
}

/// The fields of a linkage that carries one more traced point.
#[derive(Serialize)]
struct Traced {
    tracers: Vec<TracerDocument>,
}

impl Shown for Linkage {
    fn summary(&self) -> JsValue {
        to_js(&MotionSummary::new(&self.0))
    }

    fn labels(&self) -> &[String] {
        self.0.figure().names()
    }

    fn scene(&self) -> &List {
        self.0.figure().rigid()
    }

    fn moving(&self) -> Option<&Moving> {
        Some(&self.0)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }
}

impl Edited for Linkage {
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem> {
        let moving = &self.0;
        let mechanism = moving.mechanism();
        let index = mechanism.point(point);
        let index = index.filter(|_| to.coords.iter().all(|x| x.is_finite()));
        let index = index.ok_or_else(|| unknown(point))?;
        if let Some(driven) = moving.driven_to(index, input, to) {
            return driven.map(Change::input);
        }
        let pose = moving.pose(input)?;
        let draft = mechanism.redrawn(&pose, index, to);
        Ok(Change::document(&Redrawn::of(LinkageDocument::new(&draft))))
    }

    fn trace(&self, input: f64, at: Point) -> Result<Change, Problem> {
        let moving = &self.0;
        let (pose, mechanism) = (moving.pose(input)?, moving.mechanism());
        let link = moving.figure().link_at(&pose, at);
        let link = link.ok_or_else(|| unknown("tracer"))?;
        let mut tracers = moving.document().tracers.clone();
        let taken = |name: &String| mechanism.points().any(|point| point == name);
        let mut names = (1..).map(|k| format!("P{k}"));
        let name = names.find(|name| !taken(name)).unwrap_or_default();
        let [x, y] = mechanism.on_link(&pose, link, at).into();
        tracers.push(TracerDocument {
            name,
            link: mechanism.link_name(link).to_owned(),
            at: [x, y],
        });
        Ok(Change::document(&Traced { tracers }))
    }
}
