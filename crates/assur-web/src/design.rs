//! "Design your dwell" on the page: a search in steps, run in a worker of the page.

use assur::mechanism::Quantity;
use assur::synthesis::dwell::{
    DesignVariable, End, Evaluation, Progress, Search, SearchError, Target,
};
use assur_file::{Document, LinkageProblem, Problem, State, dimension_field};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::convert::{read, read_directly, thrown, to_js};
use crate::kinds::Redrawn;
use crate::profile::band;
use crate::simulator::one;

/// Requirements on the first plotted output. The document gives the width of the output's dwell band.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Wishes {
    /// Minimum arc of the crank over which the output dwells, radians.
    arc: f64,
    /// Stroke of the output, from minimum to maximum: radians, or in the unit of the lengths.
    stroke: f64,
    movable: Vec<Movement>,
}

/// A dimension that may change, named by its field. `by` is the greatest increase and decrease, as a fraction of its
/// value.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Movement {
    field: String,
    by: f64,
}

/// A search for a linkage with a wanted dwell.
#[wasm_bindgen]
pub struct Design {
    search: Search,
    /// [`Evaluation::residual`] of the original linkage.
    before: f64,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct StepSummary {
    judged: usize,
    accepted: bool,
    before: f64,
    #[serde(with = "ReachedSummary")]
    #[cfg_attr(test, ts(as = "ReachedSummary"))]
    reached: Evaluation,
    #[cfg_attr(test, ts(type = "\"fulfilled\" | \"settled\" | null"))]
    end: Option<&'static str>,
    #[cfg_attr(test, ts(type = "Partial<LinkageDocument> | null"))]
    document: Option<Redrawn>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(remote = "Evaluation")]
pub(crate) struct ReachedSummary {
    arc: f64,
    stroke: f64,
    residual: f64,
    singularity_margin: f64,
}

#[wasm_bindgen]
impl Design {
    /// Starts a search from the linkage of a state. `wishes` is `{arc, stroke, movable: [{field, by}]}`; `by` is the
    /// greatest change of the dimension, as a fraction of its value.
    ///
    /// # Errors
    /// A malformed state or malformed wishes; then every problem of the state; then the first problem of the wishes.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Wishes")] wishes: JsValue,
    ) -> Result<Self, JsValue> {
        let state = read(&state)?;
        // JSON would refuse NaN and infinity. Read directly, they reach the search, which reports their field.
        let wishes = read_directly(&wishes, "wishes").map_err(one)?;
        Self::of(&state, &wishes).map_err(thrown)
    }

    /// Evaluates the next mechanism: `{judged, accepted, before, reached: {arc, stroke, residual, singularity_margin},
    /// end, document}`. `before` is the original's residual; `reached` describes the best mechanism so far. `end` is
    /// `fulfilled`, `settled` or, if the search goes on, null. `document` has the changed fields; null if the mechanism
    /// was not accepted.
    #[wasm_bindgen(unchecked_return_type = "StepSummary")]
    pub fn step(&mut self) -> JsValue {
        let Progress {
            judged,
            accepted,
            evaluation,
            end,
        } = self.search.step();
        to_js(&StepSummary {
            judged,
            accepted,
            before: self.before,
            reached: evaluation,
            end: end.map(|end| match end {
                End::Fulfilled => "fulfilled",
                End::Settled => "settled",
            }),
            document: accepted.then(|| self.redrawn()),
        })
    }
}

impl Design {
    fn of(state: &State, wishes: &Wishes) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let none = |problem: LinkageProblem| vec![Problem::from(problem)];
        let Document::Linkage(document) = &state.document else {
            return Err(none(LinkageProblem::NoOutput));
        };
        let motion = document.motion()?;
        let mechanism = motion.mechanism();
        let plotted = document.plotted(mechanism, &state.view.plot);
        let output: Option<Quantity> = plotted.and_then(|all| all.first().copied());
        let output = output.ok_or_else(|| none(LinkageProblem::NoOutput))?;
        let dimensions = mechanism.dimensions();
        let lengths = wishes.movable.iter().map(|Movement { field, by }| {
            let mut dimensions = dimensions.iter().copied();
            let dimension = dimensions.find(|one| dimension_field(*one) == *field);
            let valued = dimension.and_then(|one| Some((one, mechanism.value(one)?)));
            let (dimension, value) = valued.ok_or_else(|| {
                let name = field.clone();
                none(LinkageProblem::NoDimension { name })
            })?;
            Ok(DesignVariable {
                dimension,
                range: [value * (1.0 - by), value * (1.0 + by)],
            })
        });
        let variables: Vec<DesignVariable> = lengths.collect::<Result<_, Vec<Problem>>>()?;
        let target = Target {
            tolerance: band(mechanism, output, document.band).1,
            arc: wishes.arc,
            stroke: wishes.stroke,
        };
        let search = Search::new(mechanism, &output.name(mechanism, 0), target, &variables);
        let search = search.map_err(|error: SearchError| {
            none(LinkageProblem::refused(error, mechanism, &variables))
        })?;
        Ok(Self {
            before: search.progress().evaluation.residual,
            search,
        })
    }

    /// Fields of the document that change if the best linkage so far replaces the original.
    fn redrawn(&self) -> Redrawn {
        Redrawn::of(self.search.mechanism().spec())
    }
}
