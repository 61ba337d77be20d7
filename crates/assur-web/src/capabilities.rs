//! Capabilities of an open document, whatever its kind: each kind implements those that it has.

use std::borrow::Cow;
use std::collections::BTreeMap;

use assur::{Point, Relation};
use assur_draw::Figure;
use assur_draw::chart::{Against, Chart};
use assur_file::{LinkageDocument, Problem};
use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::assemblies::AssembliesHere;
use crate::change::Change;
use crate::here::Here;
use crate::moving::Moving;
use crate::table::SweepTable;

/// An open document with its drawing.
pub(crate) trait Capabilities {
    /// Summary of the document; its field `moves` says whether it moves.
    fn summary(&self) -> JsValue;

    /// What stands still in its drawing: that of its linkage, where it is one.
    fn rigid(&self) -> Rigid<'_> {
        let figure = self.linkage().map(Moving::figure);
        figure.map(Rigid::from).unwrap_or_default()
    }

    /// The frame and handles of a document that never moves, as in [`crate::Simulator::at`], opened
    /// by a share of the way; empty for one that moves.
    fn still(&self, _opened: f64) -> Here {
        Here::default()
    }

    /// The moving document, with its read-outs and plots, if it moves.
    fn moves(&self) -> Option<&dyn Moves> {
        self.linkage().map(|moving| moving as &dyn Moves)
    }

    /// The moving linkage, if it is one.
    fn linkage(&self) -> Option<&Moving> {
        None
    }

    /// The document as it is changed by hand, if it can be.
    fn edited(&self) -> Option<&dyn Edited> {
        None
    }

    /// The relations of the paper that it comes from, in numbers at an input; empty without such a paper.
    ///
    /// # Errors
    /// No pose there, or derivatives unbounded.
    fn relations(&self, _input: f64) -> Result<Vec<Relation>, Problem> {
        Ok(Vec::new())
    }

    /// The linkage as it is drawn at an input, to be drawn on.
    ///
    /// # Errors
    /// A document that is not a linkage; no pose there.
    fn drawn(&self, input: f64) -> Result<LinkageDocument, Problem> {
        let moving = self.linkage().ok_or_else(|| unknown("drawing"))?;
        moving.drawn(input)
    }

    /// The link that is drawn nearest to a place, at an input.
    fn link_at(&self, input: f64, at: Point) -> Option<LinkHere> {
        let moving = self.linkage()?;
        let pose = moving.pose(input).ok()?;
        let (link, off) = moving.figure().link_at(&pose, at)?;
        let name = |link| moving.mechanism().link_name(link).to_owned();
        let wheel = moving.figure().wheel_at(&pose, at).map(name);
        let link = name(link);
        Some(LinkHere { link, off, wheel })
    }
}

/// A relation from a paper: a quantity of an item in the paper's table, in the paper's letters.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RelationHere {
    item: &'static str,
    name: Cow<'static, str>,
    /// Whether it is an angle, radians.
    angle: bool,
    /// Whether it is an angle of rotation, of which whole turns count.
    turned: bool,
    /// Whether it is a count, and so a whole number.
    count: bool,
    value: f64,
    /// The value by the relation as printed; none if that divides by zero.
    printed: Option<f64>,
}

impl From<Relation> for RelationHere {
    fn from(relation: Relation) -> Self {
        Self {
            item: relation.item,
            name: relation.name,
            angle: relation.is_angle,
            turned: relation.is_turned,
            count: relation.is_count,
            value: relation.value,
            printed: relation.printed,
        }
    }
}

/// A link near a place.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LinkHere {
    pub(crate) link: String,
    /// Its distance from the place, in the unit of the lengths.
    pub(crate) off: f64,
    /// The wheel at the place, a ring only on its rim.
    pub(crate) wheel: Option<String>,
}

/// A document that moves with an input; its properties are in its summary.
pub(crate) trait Moves {
    /// Everything at an input. Where derivatives are unbounded there are no read-outs and no
    /// plotted values.
    ///
    /// # Errors
    /// No pose at this input.
    fn at(&self, input: f64) -> Result<Here, Problem>;

    /// The plotted quantities at an input, as in [`Here`].
    ///
    /// # Errors
    /// No pose at this input, or derivatives unbounded.
    fn plotted_at(&self, input: f64) -> Result<Vec<f64>, Problem>;

    /// The reason why there is no pose at an input, or why derivatives are unbounded; none otherwise.
    fn why(&self, input: f64) -> Option<Problem>;

    /// The names of the read-outs.
    fn readout_names(&self) -> Vec<String>;

    /// The input after a step, and −1 if it turned back, otherwise 1.
    fn advance(&self, input: f64, by: f64) -> (f64, f64);

    /// The plots; of an endless motion those around an input.
    fn chart(&self, around: f64) -> Cow<'_, Chart>;

    /// The plot of one quantity against another that replaces these plots, if any.
    fn against(&self, around: f64) -> Option<Cow<'_, Against>>;

    /// The numbers of links, which denote their angles.
    fn numbers(&self) -> &BTreeMap<String, String>;

    /// The motion as a table with this number of rows per period, or per range.
    fn table(&self, steps: u32) -> SweepTable;
}

/// What stands still in a drawing.
#[derive(Default)]
pub(crate) struct Rigid<'a> {
    /// The names to which the numbers of labels refer.
    pub(crate) names: &'a [String],
    /// Its display list.
    pub(crate) list: &'a [f32],
}

impl<'a> From<&'a Figure> for Rigid<'a> {
    fn from(figure: &'a Figure) -> Self {
        Self {
            names: figure.names(),
            list: figure.rigid().numbers(),
        }
    }
}

/// Changes made by hand in the drawing; problems are those that [`crate::Simulator`] throws.
pub(crate) trait Edited {
    /// A point dragged to a place, at a given input.
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem>;

    /// A handle pressed and released without a drag.
    fn press(&self, handle: &str) -> Result<Change, Problem> {
        Err(unknown(handle))
    }

    /// The point at a place traced, at a given input.
    fn trace(&self, _input: f64, _at: Point) -> Result<Change, Problem> {
        Err(unknown("tracer"))
    }

    /// A dimension, by its field, set to a value from the pose at an input.
    fn set(&self, field: &str, _value: f64, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown(field)])
    }

    /// Another link driven, from the pose at an input.
    fn drive(&self, link: &str, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown(link)])
    }

    /// All assemblies at an input; none for kinds that do not show them.
    fn assemblies(&self, _input: f64) -> Option<AssembliesHere> {
        None
    }

    /// An assembly chosen by its number at an input; nothing changes if it is the one that moves.
    fn assemble(&self, _number: usize, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown("assembly")])
    }
}

/// The problem of an unknown handle.
pub(crate) fn unknown(point: &str) -> Problem {
    Problem::BadState {
        path: "point".to_owned(),
        detail: point.to_owned(),
    }
}
