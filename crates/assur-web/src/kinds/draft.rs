//! A linkage that is being drawn, and edits of any linkage.

use std::collections::BTreeMap;

use assur::Point;
use assur_draw::{Sketch, SketchView};
use assur_edit::{Advice, Edit, Mend, edited, selected};
use assur_file::{Document, DraftDocument, LengthUnit, LinkageDocument, Problem, State};
use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::{Capabilities, Edited, LinkHere, Rigid, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::here::Here;
use crate::summary::{CountsSummary, HandleSummary};

/// A drawing, with advice on its motion.
pub(crate) struct Drawing {
    document: LinkageDocument,
    /// Advice for a drawing that does not move; none if it could move.
    advice: Option<Advice>,
    sketch: Sketch,
}

/// Summary of a drawing that does not move.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DraftSummary<'a> {
    /// Always null: a drawing has no motion.
    #[cfg_attr(test, ts(type = "null"))]
    moves: Option<&'static str>,
    bounds: [f64; 4],
    handles: Vec<HandleSummary<'a>>,
    roles: BTreeMap<&'a str, &'static str>,
    /// Mobility W by count; none if the drawing could move, or if a defect of the drawing prevents counting.
    mobility: Option<isize>,
    /// Numbers of links and pairs; none if a defect of the drawing prevents counting.
    counts: Option<CountsSummary>,
    drivers: usize,
    /// Every reason why the drawing does not move.
    #[cfg_attr(test, ts(type = "readonly Problem[]"))]
    reasons: &'a [Problem],
    loose: &'a [String],
    locked: &'a [String],
    #[cfg_attr(test, ts(type = "readonly Mend[]"))]
    mends: &'a [Mend],
}

/// A drawing after an edit.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Drawn {
    /// The document: a `linkage` if it can move, otherwise a `draft`.
    #[serde(flatten)]
    #[cfg_attr(test, ts(skip))]
    document: Document,
    /// The point that was used or added last.
    point: Option<String>,
    /// The link that was added last.
    link: Option<String>,
    /// Whether locked lengths or angles kept the edit from reaching its target.
    held: bool,
}

impl Drawing {
    #[inline(never)]
    pub(crate) fn new(state: &State, document: &DraftDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let DraftDocument(document) = document;
        let advice = Advice::of(document)?;
        let told = advice.as_ref();
        let view = SketchView {
            loose: told.map(|one| one.loose.clone()).unwrap_or_default(),
            locked: told.map(|one| one.locked.clone()).unwrap_or_default(),
            sheet: match document.unit {
                Some(LengthUnit::Mm) => 20.0,
                Some(LengthUnit::Cm) => 2.0,
                _ => 1.0,
            },
            symbol: state.view.symbol,
        };
        Ok(Self {
            sketch: Sketch::new(&document.spec(), &view),
            document: document.clone(),
            advice,
        })
    }
}

impl Capabilities for Drawing {
    fn summary(&self) -> JsValue {
        let Self {
            document, sketch, ..
        } = self;
        let advice = self.advice.as_ref();
        let roles = document.links.iter().zip(sketch.roles());
        let handles = sketch
            .handles()
            .iter()
            .map(|(name, role, _)| HandleSummary {
                name,
                role: role.name(),
                pressed: false,
            });
        to_js(&DraftSummary {
            moves: None,
            bounds: sketch.bounds(),
            handles: handles.collect(),
            roles: roles
                .map(|(link, role)| (link.name.as_str(), role.name()))
                .collect(),
            mobility: advice.and_then(|advice| advice.mobility),
            counts: document.spec().counts().ok().map(CountsSummary::from),
            drivers: document.drivers.len(),
            reasons: advice.map_or(&[], |advice| &advice.problems),
            loose: advice.map_or(&[], |advice| &advice.loose),
            locked: advice.map_or(&[], |advice| &advice.locked),
            mends: advice.map_or(&[], |advice| &advice.mends),
        })
    }

    fn rigid(&self) -> Rigid<'_> {
        Rigid {
            names: self.sketch.names(),
            list: &[],
        }
    }

    fn still(&self, _opened: f64) -> Here {
        let handles = self.sketch.handles().iter();
        Here::still(self.sketch.frame(), handles.map(|(_, _, at)| *at))
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }

    fn drawn(&self, _input: f64) -> Result<LinkageDocument, Problem> {
        Ok(self.document.clone())
    }

    fn link_at(&self, _input: f64, at: Point) -> Option<LinkHere> {
        let (link, off) = self.sketch.link_at(at)?;
        let link = link.to_owned();
        let wheel = self.sketch.wheel_at(at).map(str::to_owned);
        Some(LinkHere { link, off, wheel })
    }
}

impl Edited for Drawing {
    fn drag(&self, point: &str, _input: f64, to: Point) -> Result<Change, Problem> {
        let handles = self.sketch.handles().iter();
        let mut handles = handles.map(|(name, _, _)| name);
        if !handles.any(|name| name == point) {
            return Err(unknown(point));
        }
        let (point, at) = (point.to_owned(), to.into());
        let moved = edited(&self.document, &Edit::Place { point, at });
        let moved = moved.map_err(|_| unknown("place"))?;
        Ok(Change::document(&moved.document))
    }
}

/// Applies an edit to the open document in its pose at an input.
///
/// # Errors
/// A document that cannot be edited as a drawing; the reason why the edit is impossible.
pub(crate) fn edit(
    open: &dyn Capabilities,
    edit: &Edit,
    input: f64,
) -> Result<JsValue, Vec<Problem>> {
    let before = open.drawn(input).map_err(|problem| vec![problem])?;
    let after = edited(&before, edit)?;
    Ok(to_js(&Drawn {
        document: after.document.as_it_moves(),
        point: after.point,
        link: after.link,
        held: after.is_held,
    }))
}

/// Copies the given links and points of the open document, in its pose at an input, to a separate drawing.
///
/// # Errors
/// A document that cannot be edited as a drawing.
pub(crate) fn part(
    open: &dyn Capabilities,
    points: &[String],
    links: &[String],
    input: f64,
) -> Result<LinkageDocument, Problem> {
    Ok(selected(&open.drawn(input)?, points, links))
}
