//! A scheme of links and pairs on the page: its drawing, whole or cut open, and its mobility by count and by geometry.

pub(crate) mod summary;

use assur::mobility::{CutError, SchemeSpec, Sections, generated};
use assur::{Point, Relation};
use assur_draw::{SchemeFigure, SchemeHandle, SchemeView};
use assur_file::{PlaceDocument, Problem, SchemeDocument, State};
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::{Capabilities, Edited, Rigid, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::here::Here;
use crate::moving::Moving;
use summary::SchemeSummary;

pub(crate) struct Scheme {
    document: SchemeDocument,
    scheme: assur::mobility::Scheme,
    /// Counts after the cuts, or the reason why the cuts are too few or too many.
    sections: Result<Sections, CutError>,
    figure: SchemeFigure,
    handles: Vec<SchemeHandle>,
}

impl Scheme {
    #[inline(never)]
    pub(crate) fn new(state: &State, document: &SchemeDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let scheme = document.scheme()?;
        let cuts = document.cuts(&scheme)?;
        let sections = scheme.sections(&cuts);
        if let Err(twice @ CutError::CutTwice { .. }) = sections {
            return Err(vec![twice.into()]);
        }
        let marked = match &sections {
            Err(CutError::StillClosed { pairs }) if !cuts.is_empty() => {
                pairs.iter().filter_map(|pair| scheme.pair(pair)).collect()
            }
            _ => Vec::new(),
        };
        let ends = document.ends();
        let ends = ends.filter_map(|(link, at)| Some((scheme.link(link)?, at)));
        let view = SchemeView {
            cuts,
            ends: ends.collect(),
            look: document.look_deg.map(f64::to_radians),
            marked,
            counted: sections.is_ok() && document.task.is_none(),
        };
        let figure = SchemeFigure::new(&scheme, view);
        Ok(Self {
            document: document.clone(),
            handles: figure.handles(),
            scheme,
            sections,
            figure,
        })
    }
}

/// Converts a moving linkage, in the pose at an input, to a scheme of links and pairs.
///
/// # Errors
/// No pose at this input.
pub(crate) fn of(moving: &Moving, input: f64) -> Result<SchemeDocument, Problem> {
    let pose = moving.pose(input)?;
    let draft = SchemeSpec::of(moving.mechanism(), &pose);
    let linkage = moving.document();
    let mut document = SchemeDocument::new(&draft);
    document.title.clone_from(&linkage.title);
    document.source.clone_from(&linkage.source);
    Ok(document)
}

/// Makes the practice task with this number.
pub(crate) fn task(number: u32) -> SchemeDocument {
    let mut document = SchemeDocument::new(&generated(number));
    document.task = Some(number);
    document
}

impl Capabilities for Scheme {
    fn summary(&self) -> JsValue {
        to_js(&SchemeSummary::new(self))
    }

    fn rigid(&self) -> Rigid<'_> {
        Rigid {
            names: self.figure.names(),
            // Empty, because any link may move when a cut opens.
            list: &[],
        }
    }

    fn still(&self, opened: f64) -> Here {
        let handles = self.figure.held_at(opened);
        Here::still(self.figure.frame(opened), handles.into_iter())
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }

    fn relations(&self, _input: f64) -> Result<Vec<Relation>, Problem> {
        Ok(self.scheme.relations(self.sections.as_ref().ok()))
    }
}

impl Edited for Scheme {
    /// Moves a pair of two links if no cut is made: after a cut, the pairs of the open chain are not drawn in place.
    fn drag(&self, point: &str, _input: f64, to: Point) -> Result<Change, Problem> {
        let handle = self.handles.iter().find(|handle| handle.name == point);
        let handle = handle.ok_or_else(|| unknown(point))?;
        if !self.document.cut.is_empty() || self.scheme.pairs()[handle.pair].links.len() > 2 {
            return Ok(Change::default());
        }
        let mut pairs = self.document.pairs.clone();
        let at = self.figure.dragged(handle.pair, to);
        pairs[handle.pair].at = Some(PlaceDocument::of(at, self.scheme.is_planar()));
        Ok(Change::document(&json!({ "pairs": pairs })))
    }

    /// Cuts a pair, or joins it again.
    fn press(&self, handle: &str) -> Result<Change, Problem> {
        if !self.handles.iter().any(|one| one.name == handle) {
            return Err(unknown(handle));
        }
        let mut cut = self.document.cut.clone();
        match cut.iter().position(|name| name == handle) {
            Some(place) => {
                cut.remove(place);
            }
            None => cut.push(handle.to_owned()),
        }
        Ok(Change::document(&json!({ "cut": cut })))
    }

    /// Makes one of the listed replacements of pairs; `value` is its number, from 1.
    fn set(&self, field: &str, value: f64, _input: f64) -> Result<Change, Vec<Problem>> {
        let mended = self.scheme.replacements(summary::MENDED);
        let mended = mended.map_err(|_| vec![unknown(field)])?;
        let mut list = (1..).zip(&mended.list);
        let chosen = list.find(|(number, _)| field == "mended" && f64::from(*number) == value);
        let (_, chosen) = chosen.ok_or_else(|| vec![unknown(field)])?;
        let document = SchemeDocument::new(&self.scheme.replaced(chosen));
        let pairs = document.pairs;
        Ok(Change::document(&json!({ "pairs": pairs })))
    }
}
