//! Capabilities of an open document; each kind of document implements those that it has.

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
use crate::here::{Here, ReadoutId};
use crate::moving::Moving;
use crate::table::SweepTable;

/// An open document with its drawing.
pub(crate) trait Capabilities {
    /// Summary of the document; the field `moves` of the summary says whether the document moves.
    fn summary(&self) -> JsValue;

    /// The shapes that move rigidly with bodies; by default those of the moving linkage, if there is one.
    fn rigid(&self) -> Rigid<'_> {
        let figure = self.linkage().map(Moving::figure);
        figure.map(Rigid::from).unwrap_or_default()
    }

    /// The frame and handles of a document that never moves, as in [`crate::Simulator::at`]; empty for a document that
    /// moves. `_opened` is the fraction by which the last cut of a scheme is open.
    fn still(&self, _opened: f64) -> Here {
        Here::default()
    }

    /// The document as one that moves, with read-outs and plots; none if it does not move.
    fn moves(&self) -> Option<&dyn Moves> {
        self.linkage().map(|moving| moving as &dyn Moves)
    }

    /// The moving linkage that the document describes, if any.
    fn linkage(&self) -> Option<&Moving> {
        None
    }

    /// Changes by hand in the drawing, if the document allows them.
    fn edited(&self) -> Option<&dyn Edited> {
        None
    }

    /// Relations of the paper that describes this document, with their values at an input. Empty without such a paper.
    ///
    /// # Errors
    /// No pose at this input, or unbounded derivatives.
    fn relations(&self, _input: f64) -> Result<Vec<Relation>, Problem> {
        Ok(Vec::new())
    }

    /// The linkage as drawn at an input, ready for editing.
    ///
    /// # Errors
    /// A document that is not a linkage; no pose at this input.
    fn drawn(&self, input: f64) -> Result<LinkageDocument, Problem> {
        let moving = self.linkage().ok_or_else(|| unknown("drawing"))?;
        moving.drawn(input)
    }

    /// Finds the link that is drawn nearest to a place, at an input.
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

/// A relation from a paper: its item in the paper's table, and its quantity in the paper's notation.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RelationHere {
    item: &'static str,
    name: Cow<'static, str>,
    /// Whether the value is an angle, in radians.
    angle: bool,
    /// Whether the value is an angle of rotation, in which whole turns count.
    turned: bool,
    /// Whether the value is a count, which is a whole number.
    count: bool,
    value: f64,
    /// The value given by the relation as printed; none if this relation divides by zero.
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
    /// Distance of the link from the place, in the unit of the lengths.
    pub(crate) off: f64,
    /// The wheel at the place, if there is one; a ring counts only at its rim.
    pub(crate) wheel: Option<String>,
}

/// A document that moves with an input; its properties are in its summary.
pub(crate) trait Moves {
    /// Everything shown at an input. If derivatives are unbounded, there are no read-outs and no plotted values.
    ///
    /// # Errors
    /// No pose at this input.
    fn at(&self, input: f64) -> Result<Here, Problem>;

    /// The plotted quantities at an input, as in [`Here`].
    ///
    /// # Errors
    /// No pose at this input, or unbounded derivatives.
    fn plotted_at(&self, input: f64) -> Result<Vec<f64>, Problem>;

    /// The reason why there is no pose at an input, or why derivatives are unbounded; none otherwise.
    fn why(&self, input: f64) -> Option<Problem>;

    /// The subjects of the read-outs in [`Here`], in the same order.
    fn readouts(&self) -> Vec<ReadoutId>;

    /// Moves the input by a step. Where the motion turns back, the input turns back, too. Returns the new input, and −1
    /// after an odd number of reversals, otherwise 1.
    fn advance(&self, input: f64, by: f64) -> (f64, f64);

    /// The plots against the input. For a gear train without load, they cover the span of time that contains `around`.
    fn chart(&self, around: f64) -> Cow<'_, Chart>;

    /// The plot of one quantity against another that replaces the plots against the input, if any.
    fn against(&self, around: f64) -> Option<Cow<'_, Against>>;

    /// Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂.
    fn numbers(&self) -> &BTreeMap<String, String>;

    /// The motion as a table, with this number of steps per turn of a crank, or over the range of any other input.
    fn table(&self, steps: u32) -> SweepTable;
}

/// Shapes of a drawing that move rigidly with the bodies.
#[derive(Default)]
pub(crate) struct Rigid<'a> {
    /// Names to which the labels in `list` refer by index.
    pub(crate) names: &'a [String],
    /// Display list of the shapes.
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

/// Changes made by hand in the drawing. [`crate::Simulator`] throws the problems of a change.
pub(crate) trait Edited {
    /// Drags a point to a place, from the pose at an input.
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem>;

    /// Presses a handle and releases it without a drag.
    fn press(&self, handle: &str) -> Result<Change, Problem> {
        Err(unknown(handle))
    }

    /// Traces the point at a place, from the pose at an input.
    fn trace(&self, _input: f64, _at: Point) -> Result<Change, Problem> {
        Err(unknown("tracer"))
    }

    /// Sets the number in a field to a value, starting from the pose at an input.
    fn set(&self, field: &str, _value: f64, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown(field)])
    }

    /// Makes another link the driver, from the pose at an input.
    fn drive(&self, link: &str, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown(link)])
    }

    /// All assemblies at an input; none for kinds that do not show them.
    fn assemblies(&self, _input: f64) -> Option<AssembliesHere> {
        None
    }

    /// Chooses an assembly by its number at an input. Nothing changes if it is already the document's assembly.
    fn assemble(&self, _number: usize, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown("assembly")])
    }
}

/// The problem of an unknown name or choice, such as a handle; its path is always `point`.
pub(crate) fn unknown(point: &str) -> Problem {
    Problem::BadState {
        path: "point".to_owned(),
        detail: point.to_owned(),
    }
}
