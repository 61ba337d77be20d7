//! Searches for linkages that trace a path, in workers of the page: the approximation, and all four-bars through nine
//! points.

use assur::Point;
use assur::synthesis::approximation::{Approximation, Norm, Search, Tracing, Wanted};
use assur::synthesis::cognates::CouplerFourBar;
use assur::synthesis::path;
use assur::synthesis::path::{CURVES, End, Homotopy, NinePoints, Start, StartError, Work};
use assur_file::{Document, PathDocument, Problem, State, TracingDocument};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use super::summary::{FoundTracing, TracingVerdict};
use crate::capabilities::unknown;
use crate::convert::{read, read_value, thrown, to_js};
use crate::simulator::one;

/// What an approximation is to be.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub(crate) struct TracingWishes {
    /// Whether the root of the mean square is to be small instead of the greatest distance.
    squares: bool,
    /// Whether four-bars are admitted.
    four_bars: bool,
    /// Whether slider-cranks are admitted.
    slider_cranks: bool,
    /// Whether four-bars without a link that turns fully are admitted.
    swinging: bool,
}

impl From<TracingWishes> for Wanted {
    fn from(wishes: TracingWishes) -> Self {
        Self {
            norm: if wishes.squares {
                Norm::Squares
            } else {
                Norm::Greatest
            },
            four_bars: wishes.four_bars,
            slider_cranks: wishes.slider_cranks,
            swinging: wishes.swinging,
            seed: 0,
        }
    }
}

/// State of an approximation.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TracingProgress {
    /// Number of linkages compared so far.
    candidates: usize,
    /// Whether the path is met within rounding, so that no better linkage exists.
    exact: bool,
    /// The best linkages, if this step has found a better one; null otherwise.
    found: Option<Vec<FoundTracing>>,
}

/// An approximation of a path, step by step.
#[wasm_bindgen]
pub struct PathSearch {
    search: Search,
}

pub(super) fn document(state: &JsValue) -> Result<PathDocument, JsValue> {
    let state: State = read(state)?;
    match state.document {
        Document::Path(document) => Ok(document),
        _ => Err(one(unknown("point-path"))),
    }
}

impl FoundTracing {
    pub(super) fn of(found: &Approximation) -> Self {
        Self {
            linkage: (&found.linkage).into(),
            greatest: found.deviation.greatest,
            root_mean_square: Some(found.deviation.root_mean_square),
            verdict: found.verdict.map(TracingVerdict::from),
            curve: None,
        }
    }
}

#[wasm_bindgen]
impl PathSearch {
    /// Starts a search for the path of a state.
    ///
    /// # Errors
    /// Malformed values; every problem of the path.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
        #[wasm_bindgen(unchecked_param_type = "TracingWishes")] wishes: JsValue,
    ) -> Result<Self, JsValue> {
        let wishes: TracingWishes = read_value(&wishes)?;
        let target = document(&state)?.target().map_err(thrown)?;
        Ok(Self {
            search: Search::new(target, wishes.into()),
        })
    }

    /// Compares this number of further linkages, and returns the state of the search.
    #[wasm_bindgen(unchecked_return_type = "TracingProgress")]
    pub fn step(&mut self, candidates: usize) -> JsValue {
        let first = self.search.progress().candidates == 0;
        let progress = self.search.step(candidates);
        let found = (progress.improved || first)
            .then(|| self.search.found().iter().map(FoundTracing::of).collect());
        to_js(&TracingProgress {
            candidates: progress.candidates,
            exact: progress.exact,
            found,
        })
    }
}

/// State of the search for all four-bars through nine points.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct NinePointProgress {
    /// Number of different coupler curves found and proved, real and complex.
    curves: usize,
    /// Number of all of them for generic points.
    all: usize,
    /// Number of curves that are found but not proved.
    unproved: usize,
    /// Number of paths of the present work that are not yet followed.
    left: usize,
    /// Whether all curves are found and proved.
    complete: bool,
}

/// Paths that a worker follows.
#[derive(Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(remote = "Work", deny_unknown_fields)]
pub(crate) struct PathWork {
    way: usize,
    careful: bool,
    paths: Vec<usize>,
}

/// Reads and writes a work as [`PathWork`].
#[derive(Serialize, Deserialize)]
struct Given(#[serde(with = "PathWork")] Work);

/// The search for all four-bars through nine points. It gives out work and collects the ends of paths.
#[wasm_bindgen]
pub struct NinePointSearch {
    search: path::Search,
}

fn nine_points(state: &JsValue) -> Result<NinePoints, JsValue> {
    let document = document(state)?;
    let points: Vec<Point> = document.path.iter().copied().map(Point::from).collect();
    NinePoints::new(&points).map_err(|error| one(Problem::from(error)))
}

#[wasm_bindgen]
impl NinePointSearch {
    /// Starts a search for the path of a state.
    ///
    /// # Errors
    /// A malformed state; points that are not nine, or that leave a family.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
    ) -> Result<Self, JsValue> {
        Ok(Self {
            search: path::Search::new(nine_points(&state)?),
        })
    }

    /// The paths to be followed next; null while paths are under way, and at the end of the search.
    #[wasm_bindgen(unchecked_return_type = "PathWork | null")]
    pub fn work(&mut self) -> JsValue {
        self.search
            .work()
            .map_or(JsValue::NULL, |work| to_js(&Given(work)))
    }

    /// Adds ends of paths, as [`NinePointWorker::track`] gives them.
    pub fn add(&mut self, ends: &[f64]) {
        for end in ends.as_chunks::<{ End::NUMBERS }>().0 {
            self.search.add(End::from_numbers(end));
        }
    }

    /// State of the search.
    #[wasm_bindgen(unchecked_return_type = "NinePointProgress")]
    pub fn progress(&self) -> JsValue {
        to_js(&NinePointProgress {
            curves: self.search.count(),
            all: CURVES,
            unproved: self.search.unproved(),
            left: self.search.left(),
            complete: self.search.is_complete(),
        })
    }

    /// The real four-bars found so far: those that pass through all points in one motion and in order first, then by
    /// their transmission angle.
    #[wasm_bindgen(unchecked_return_type = "FoundTracing[]")]
    pub fn found(&self) -> JsValue {
        let found = self.search.ranked().into_iter().filter_map(|found| {
            let (four_bar, curve) = (found.four_bar, found.curve);
            let linkage = CouplerFourBar::new(four_bar.pivots, four_bar.hinges, four_bar.point);
            Some(FoundTracing {
                linkage: TracingDocument::from(&Tracing::FourBar(linkage.ok()?)),
                greatest: four_bar.residual,
                root_mean_square: None,
                verdict: four_bar.verdict.ok().map(Into::into),
                curve: Some(curve),
            })
        });
        to_js(&found.collect::<Vec<_>>())
    }
}

/// A worker of the search for all four-bars through nine points.
#[wasm_bindgen]
pub struct NinePointWorker {
    start: Start,
    points: NinePoints,
}

#[wasm_bindgen]
impl NinePointWorker {
    /// A worker with the start data, for the path of a state.
    ///
    /// # Errors
    /// A malformed state; points as for [`NinePointSearch`]; damaged start data.
    #[wasm_bindgen(constructor)]
    pub fn new(
        start: &[u8],
        #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
    ) -> Result<Self, JsValue> {
        let damaged = |_: StartError| {
            one(Problem::BadState {
                path: "nine-points.bin".to_owned(),
                detail: "damaged".to_owned(),
            })
        };
        Ok(Self {
            start: Start::read(start).map_err(damaged)?,
            points: nine_points(&state)?,
        })
    }

    /// Follows the paths of a work: the ends of all of them, one after another, as numbers.
    ///
    /// # Errors
    /// A malformed work.
    pub fn track(
        &self,
        #[wasm_bindgen(unchecked_param_type = "PathWork")] work: JsValue,
    ) -> Result<Vec<f64>, JsValue> {
        let Given(work) = read_value(&work)?;
        let homotopy = Homotopy::new(&self.start, &self.points, &work);
        let ends = work.paths.iter().filter_map(|path| homotopy.track(*path));
        Ok(ends.flat_map(|end| end.numbers()).collect())
    }
}
