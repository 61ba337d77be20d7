//! What the page asks of a document that is open, whichever kind it is of: capabilities, of
//! which a kind has those that it has.

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

/// A document with all that is drawn of it.
pub(crate) trait Capabilities {
    /// What is said of it as a whole; it says by `moves` whether anything does.
    fn summary(&self) -> JsValue;

    /// What stands still in its drawing: that of its linkage, where it is one.
    fn rigid(&self) -> Rigid<'_> {
        let figure = self.linkage().map(Moving::figure);
        figure.map(Rigid::from).unwrap_or_default()
    }

    /// The place of what never moves, as of [`crate::Simulator::at`], where what falls open has
    /// done so by a share of its way; of what moves none.
    fn still(&self, _opened: f64) -> Here {
        Here::default()
    }

    /// What moves, is read, listed and plotted, where anything is.
    fn moves(&self) -> Option<&dyn Moves> {
        self.linkage().map(|moving| moving as &dyn Moves)
    }

    /// The linkage that moves, where it is one.
    fn linkage(&self) -> Option<&Moving> {
        None
    }

    /// What can be changed by hand, where anything can.
    fn edited(&self) -> Option<&dyn Edited> {
        None
    }

    /// The relations of the paper that it comes from, in numbers at an input; none where there is no such paper.
    ///
    /// # Errors
    /// No pose there, or derivatives unbounded.
    fn relations(&self, _input: f64) -> Result<Vec<Relation>, Problem> {
        Ok(Vec::new())
    }

    /// The linkage as it is drawn at an input, to be drawn on.
    ///
    /// # Errors
    /// What is no linkage; no pose there.
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

/// A quantity for which a paper gives a relation: of an item in the table of the paper, in the paper's letters.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RelationHere {
    item: &'static str,
    name: Cow<'static, str>,
    /// Whether it is an angle, radians.
    angle: bool,
    /// Whether it is an angle through which something has turned, so that whole turns count.
    turned: bool,
    /// Whether it counts something, and is a whole number.
    count: bool,
    value: f64,
    /// The value by the relation as it is printed; none where that divides by zero.
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
    /// How far off it is drawn, in the unit of the lengths.
    pub(crate) off: f64,
    /// The wheel on which the place is, a ring by its rim.
    pub(crate) wheel: Option<String>,
}

/// A document that moves by an input; its properties are in its summary.
pub(crate) trait Moves {
    /// All of a place of the motion. Where derivatives are unbounded there are no read-outs and no
    /// plotted values.
    ///
    /// # Errors
    /// Why there is no such place.
    fn at(&self, input: f64) -> Result<Here, Problem>;

    /// The plotted quantities at an input, as of [`Here`].
    ///
    /// # Errors
    /// Why there is no such place, or nothing of its derivatives.
    fn plotted_at(&self, input: f64) -> Result<Vec<f64>, Problem>;

    /// Why there is no place at an input, or nothing of its derivatives; nothing where there is.
    fn why(&self, input: f64) -> Option<Problem>;

    /// The names of the read-outs.
    fn readout_names(&self) -> Vec<String>;

    /// The input moved, and −1 where it turned back, else 1.
    fn advance(&self, input: f64, by: f64) -> (f64, f64);

    /// The plots, where they go on and on those around an input.
    fn chart(&self, around: f64) -> Cow<'_, Chart>;

    /// What is plotted against each other instead of these plots, where anything is.
    fn against(&self, around: f64) -> Option<Cow<'_, Against>>;

    /// The numbers of links, by which their angles are called.
    fn numbers(&self) -> &BTreeMap<String, String>;

    /// The motion as a table with so many rows to its period, or to its range.
    fn table(&self, steps: u32) -> SweepTable;
}

/// What stands still in a drawing.
#[derive(Default)]
pub(crate) struct Rigid<'a> {
    /// What the numbers of labels stand for.
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

/// What changes when a hand is laid on the drawing; problems are those that
/// [`crate::Simulator`] throws.
pub(crate) trait Edited {
    /// A point dragged to a place, with the input where it is.
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem>;

    /// A handle pressed and let go where it is.
    fn press(&self, handle: &str) -> Result<Change, Problem> {
        Err(unknown(handle))
    }

    /// The point at a place traced, with the input where it is.
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

    /// All assemblies at an input; none where they are not told.
    fn assemblies(&self, _input: f64) -> Option<AssembliesHere> {
        None
    }

    /// An assembly chosen, by its number at an input; nothing becomes other where it is the one that moves.
    fn assemble(&self, _number: usize, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown("assembly")])
    }
}

/// What is none of the points that can be dragged.
pub(crate) fn unknown(point: &str) -> Problem {
    Problem::BadState {
        path: "point".to_owned(),
        detail: point.to_owned(),
    }
}
