//! A linkage on the page.

use assur::mechanism::{Dimension, LinkageSpec, Mechanism, Quantity};
use assur::motion::{Changed, Motion};
use assur::{CombinedMethod, Point, Relation};
use assur_draw::Annotations;
use assur_file::{
    DriverDocument, LinkDocument, LinkageDocument, LinkageProblem, PointDocument, Problem, State,
    TracerDocument, dimension_field, of_field, rate_field,
};
use serde::Serialize;
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::assemblies::AssembliesHere;
use crate::capabilities::{Capabilities, Edited, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::dimensions::DimensionSummary;
use crate::moving::Moving;
use crate::summary::MotionSummary;

pub(crate) struct Linkage {
    moving: Moving,
    /// The linkage in the notation of the paper on the combined method; none if the paper does not describe it.
    of_paper: Option<CombinedMethod>,
}

/// Id of the mechanism in the catalogue that the paper on the combined method describes.
const COMBINED_METHOD: &str = "class4-dwell";

impl Linkage {
    #[inline(never)]
    pub(crate) fn new(state: &State, made: Option<Motion>) -> Result<Self, Vec<Problem>> {
        let moved = match made {
            Some(motion) => state.moved_by(motion)?,
            None => state.moved()?,
        };
        let explain =
            |mechanism: &_, unsolved: &_| LinkageProblem::unsolved(unsolved, mechanism).into();
        let quantities = Quantity::all(moved.motion.mechanism());
        let mut annotations = Annotations::of_linkage(moved.document.ground);
        let mut of_paper = None;
        if moved.document.origin.as_deref() == Some(COMBINED_METHOD) {
            of_paper = CombinedMethod::of(moved.motion.mechanism());
        }
        if of_paper.is_some() {
            annotations = annotations.with_letters_of_combined_method();
        }
        let moving = Moving::new(
            &state.view,
            moved,
            annotations,
            quantities,
            Box::new(explain),
        )?;
        Ok(Self { moving, of_paper })
    }
}

/// Fields of a linkage document that change when the linkage is redrawn. The drawing itself
/// determines the assembly, so the assembly's number is removed.
#[derive(Serialize)]
pub(crate) struct Redrawn {
    points: Vec<PointDocument>,
    links: Vec<LinkDocument>,
    drivers: Vec<DriverDocument>,
    tracers: Vec<TracerDocument>,
    assembly: Option<usize>,
}

impl Redrawn {
    pub(crate) fn of(draft: &LinkageSpec) -> Self {
        let document = LinkageDocument::new(draft);
        Self {
            points: document.points,
            links: document.links,
            drivers: document.drivers,
            tracers: document.tracers,
            assembly: None,
        }
    }
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LinkageSummary<'a> {
    #[serde(flatten)]
    motion: MotionSummary<'a>,
    dimensions: Vec<DimensionSummary<'a>>,
    /// Links that can drive the linkage, by rotating or sliding.
    drivers: Vec<&'a str>,
    rates: Vec<RateSummary<'a>>,
}

/// Rate of a further driver's coordinate relative to the first driver's coordinate.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RateSummary<'a> {
    field: String,
    link: &'a str,
    rate: f64,
    role: &'static str,
}

impl Linkage {
    fn mechanism(&self) -> &Mechanism {
        self.moving.mechanism()
    }

    fn rates(&self) -> Vec<RateSummary<'_>> {
        let mechanism = self.mechanism();
        let draft = mechanism.spec();
        let further = draft.drivers.iter().enumerate().skip(1);
        let rates = further.filter_map(|(index, driver)| {
            let link = draft.driven(driver)?;
            let role = mechanism.link(link)?;
            Some(RateSummary {
                field: rate_field(index).into_owned(),
                link,
                rate: driver.rate(),
                role: self.moving.figure().role(role).name(),
            })
        });
        rates.collect()
    }

    /// The fields of the redrawn document, the input if it has changed, and the motion.
    fn changed(&self, changed: Changed, input: f64) -> Change {
        let redrawn = Redrawn::of(changed.motion.mechanism().spec());
        let other = (changed.input != input).then_some(changed.input);
        let change = Change::document(&redrawn).and_input(other);
        change.and_motion(changed.motion)
    }
}

impl Capabilities for Linkage {
    fn summary(&self) -> JsValue {
        let mechanism = self.mechanism();
        to_js(&LinkageSummary {
            motion: MotionSummary::new(&self.moving),
            dimensions: DimensionSummary::all(&self.moving),
            drivers: mechanism.drivable(),
            rates: self.rates(),
        })
    }

    fn linkage(&self) -> Option<&Moving> {
        Some(&self.moving)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }

    fn relations(&self, input: f64) -> Result<Vec<Relation>, Problem> {
        let Some(method) = &self.of_paper else {
            return Ok(Vec::new());
        };
        let pose = self.moving.motion().pose::<3>(input);
        let pose = pose.map_err(|unsolved| self.moving.problem(&unsolved))?;
        Ok(method.relations(self.mechanism(), &pose))
    }
}

impl Edited for Linkage {
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem> {
        let moving = &self.moving;
        let mechanism = moving.mechanism();
        let index = mechanism.point(point).ok_or_else(|| unknown(point))?;
        if let Some(driven) = moving.driven_to(index, input, to) {
            return driven.map(Change::input);
        }
        if mechanism.dimensions().contains(&Dimension::X(index)) {
            let moved = moving.motion().hinge_moved(index, to, input);
            let moved = moved.map_err(|_| unknown(point))?;
            return Ok(self.changed(moved, input));
        }
        let pose = moving.pose(input)?;
        let draft = mechanism.redrawn(&pose, index, to);
        Ok(Change::document(&Redrawn::of(&draft)))
    }

    fn set(&self, field: &str, value: f64, input: f64) -> Result<Change, Vec<Problem>> {
        let mechanism = self.mechanism();
        let drivers = mechanism.spec().drivers.len();
        if let Some(driver) = (1..drivers).find(|driver| rate_field(*driver) == field) {
            let changed = self.moving.motion().at_rate(driver, value, input);
            return Ok(self.changed(changed.map_err(Problem::all)?, input));
        }
        let mut dimensions = mechanism.dimensions().into_iter();
        let dimension = dimensions.find(|one| dimension_field(*one) == field);
        let dimension = dimension.ok_or_else(|| vec![unknown(field)])?;
        // An angle has many equivalent values, whole turns apart. The one nearest to the present value is set, or named
        // in the refusal.
        let value = mechanism.nearest(dimension, of_field(dimension, value));
        let changed = self.moving.motion().changed(dimension, value, input);
        let changed = changed
            .map_err(|refusal| LinkageProblem::unset(refusal, mechanism, dimension, value))?;
        Ok(self.changed(changed, input))
    }

    fn drive(&self, link: &str, input: f64) -> Result<Change, Vec<Problem>> {
        let motion = self.moving.motion();
        let driver = motion.driver(link);
        let driver = driver.map_err(|turns| vec![LinkageProblem::from(turns).into()])?;
        let driver = driver.ok_or_else(|| vec![unknown(link)])?;
        let changed = motion.driven_by(&driver, input);
        Ok(self.changed(changed.map_err(Problem::all)?, input))
    }

    fn assemblies(&self, input: f64) -> Option<AssembliesHere> {
        Some(self.moving.assemblies(input))
    }

    fn assemble(&self, number: usize, input: f64) -> Result<Change, Vec<Problem>> {
        let (found, shown) = self.moving.assembled(input);
        let chosen = number.checked_sub(1);
        let pose = chosen.and_then(|chosen| found.poses.get(chosen));
        let pose = pose.ok_or_else(|| vec![unknown("assembly")])?;
        if shown == chosen {
            return Ok(Change::default());
        }
        let draft = self.mechanism().drawn_in(pose);
        Ok(Change::document(&Redrawn::of(&draft)))
    }

    fn trace(&self, input: f64, at: Point) -> Result<Change, Problem> {
        let moving = &self.moving;
        let (pose, mechanism) = (moving.pose(input)?, moving.mechanism());
        let link = moving.figure().link_at(&pose, at);
        let (link, _) = link.ok_or_else(|| unknown("tracer"))?;
        let mut tracers = moving.document().tracers.clone();
        let taken = |name: &String| mechanism.points().any(|point| point == name);
        let mut number = 1;
        while taken(&format!("P{number}")) {
            number += 1;
        }
        let [x, y] = mechanism.on_link(&pose, link, at).into();
        tracers.push(TracerDocument {
            name: format!("P{number}"),
            link: mechanism.link_name(link).to_owned(),
            at: [x, y],
        });
        Ok(Change::document(&json!({ "tracers": tracers })))
    }
}
