//! The atlas of coupler curves beside a path.

use assur::synthesis::approximation::{Atlas, Axis, Cell, Ratio};
use assur_file::{Field, Problem};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use super::search::document;
use super::summary::FoundTracing;
use crate::convert::{read_value, thrown, to_js};
use crate::simulator::one;

/// Number of values on each axis, and their range relative to the crank.
const COUNT: usize = 12;
const RANGE: [f64; 2] = [0.6, 6.0];

/// Number of points of each curve.
const PLACES: usize = 49;

/// What the axes of the atlas leave open.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub(crate) struct AtlasPage {
    /// Length of the frame relative to the crank.
    frame: f64,
    /// The coupler point: shares of the coupler's length along it and to its left.
    point: [f64; 2],
}

/// Curves over the lengths of coupler and rocker.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AtlasHere {
    /// Number of values on each axis: the coupler runs fastest.
    count: usize,
    cells: Vec<AtlasCell>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AtlasCell {
    /// Lengths of coupler, rocker and frame; the crank is 1.
    lengths: [f64; 3],
    /// Grashof type; null if the lengths form no linkage.
    grashof: Option<&'static str>,
    /// Minimum transmission angle of the motion, radians.
    transmission: Option<f64>,
    /// From 0, a curve of the shape of the path, to 1.
    unlikeness: Option<f64>,
    /// Coordinates of the places of the curve, x and y in turn.
    curve: Vec<f64>,
}

impl From<Cell> for AtlasCell {
    fn from(cell: Cell) -> Self {
        let [_, coupler, rocker, frame] = cell.lengths;
        Self {
            lengths: [coupler, rocker, frame],
            grashof: cell.grashof.map(|grashof| grashof.code()),
            transmission: cell.transmission,
            unlikeness: cell.unlikeness,
            curve: cell.curve.iter().flat_map(|at| [at.x, at.y]).collect(),
        }
    }
}

impl AtlasPage {
    fn read(page: &JsValue) -> Result<Atlas, JsValue> {
        let Self { frame, point } = read_value(page)?;
        let axis = |ratio| Axis {
            ratio,
            range: RANGE,
            count: COUNT,
        };
        let axes = [axis(Ratio::Coupler), axis(Ratio::Rocker)];
        let atlas = Atlas::new(axes, frame, &[point]);
        atlas.map_err(|_| {
            one(Problem::UnknownChoice {
                field: Field::from("atlas"),
            })
        })
    }
}

/// The curves of the atlas, with their likeness to the path of a state.
///
/// # Errors
/// Malformed values; every problem of the path.
#[wasm_bindgen(js_name = pathAtlas, unchecked_return_type = "AtlasHere")]
pub fn path_atlas(
    #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
    #[wasm_bindgen(unchecked_param_type = "AtlasPage")] page: JsValue,
) -> Result<JsValue, JsValue> {
    let atlas = AtlasPage::read(&page)?;
    let target = document(&state)?.target().map_err(thrown)?;
    let cells = atlas.cells(0..atlas.count(), PLACES, Some(&target));
    Ok(to_js(&AtlasHere {
        count: COUNT,
        cells: cells.into_iter().map(AtlasCell::from).collect(),
    }))
}

/// The linkage of a cell of the atlas, placed on the path of a state; null if it cannot be placed.
///
/// # Errors
/// As for [`path_atlas`].
#[wasm_bindgen(js_name = pathOfCell, unchecked_return_type = "FoundTracing | null")]
pub fn path_of_cell(
    #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
    #[wasm_bindgen(unchecked_param_type = "AtlasPage")] page: JsValue,
    cell: usize,
) -> Result<JsValue, JsValue> {
    let atlas = AtlasPage::read(&page)?;
    let target = document(&state)?.target().map_err(thrown)?;
    let found = atlas.nearest(cell, &target);
    Ok(found.map_or(JsValue::NULL, |found| to_js(&FoundTracing::of(&found))))
}
