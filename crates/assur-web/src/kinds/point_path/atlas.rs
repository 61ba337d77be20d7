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

/// A length relative to the crank.
#[derive(Clone, Copy, Deserialize, Serialize, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub(crate) enum AtlasRatio {
    Coupler,
    Rocker,
    Frame,
}

/// What the axes of the atlas leave open.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub(crate) struct AtlasPage {
    /// The length that is not on an axis, and its ratio to the crank.
    third: AtlasRatio,
    ratio: f64,
    /// The coupler point: shares of the coupler's length along it and to its left.
    point: [f64; 2],
}

/// Curves over two lengths.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AtlasHere {
    /// Lengths on the axes, to the right and upwards, with their common range relative to the crank.
    axes: [AtlasRatio; 2],
    range: [f64; 2],
    /// Number of values on each axis, at equal steps of the logarithm. The first axis runs fastest.
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

impl From<AtlasRatio> for Ratio {
    fn from(ratio: AtlasRatio) -> Self {
        match ratio {
            AtlasRatio::Coupler => Self::Coupler,
            AtlasRatio::Rocker => Self::Rocker,
            AtlasRatio::Frame => Self::Frame,
        }
    }
}

impl AtlasPage {
    /// The lengths on the axes.
    const fn axes(&self) -> [AtlasRatio; 2] {
        match self.third {
            AtlasRatio::Coupler => [AtlasRatio::Rocker, AtlasRatio::Frame],
            AtlasRatio::Rocker => [AtlasRatio::Coupler, AtlasRatio::Frame],
            AtlasRatio::Frame => [AtlasRatio::Coupler, AtlasRatio::Rocker],
        }
    }

    fn atlas(&self) -> Result<Atlas, JsValue> {
        let axes = self.axes().map(|ratio| Axis {
            ratio: ratio.into(),
            range: RANGE,
            count: COUNT,
        });
        let atlas = Atlas::new(axes, self.ratio, &[self.point]);
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
    let page: AtlasPage = read_value(&page)?;
    let atlas = page.atlas()?;
    let target = document(&state)?.target().map_err(thrown)?;
    let cells = atlas.cells(0..atlas.count(), PLACES, Some(&target));
    Ok(to_js(&AtlasHere {
        axes: page.axes(),
        range: RANGE,
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
    let atlas = read_value::<AtlasPage>(&page)?.atlas()?;
    let target = document(&state)?.target().map_err(thrown)?;
    let found = atlas.nearest(cell, &target);
    Ok(found.map_or(JsValue::NULL, |found| to_js(&FoundTracing::of(&found))))
}
