//! The scheme of a linkage on the page: the drawing as it stands, and its structure.

use assur::mechanism::Mechanism;
use assur_draw::{Annotations, Figure, Overlays, View};
use assur_file::{LinkageProblem, Problem, State};
use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::Capabilities;
use crate::convert::to_js;
use crate::summary::StructureSummary;

/// A linkage drawn where it stands.
pub(crate) struct Scheme {
    mechanism: Mechanism,
    figure: Figure,
    frame: Vec<f32>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SchemeSummary<'a> {
    /// Nothing does.
    #[cfg_attr(test, ts(type = "null"))]
    moves: Option<&'static str>,
    #[serde(flatten)]
    structure: StructureSummary<'a>,
    /// Nothing is dragged.
    #[cfg_attr(test, ts(type = "never[]"))]
    handles: [(); 0],
}

impl Scheme {
    pub(crate) fn new(state: &State) -> Result<Self, Vec<Problem>> {
        let motion = state.moved()?.motion;
        let mechanism = motion.mechanism();
        let view = View {
            overlays: Overlays {
                groups: state.view.groups,
                ..Overlays::default()
            },
            traced: Vec::new(),
            annotations: Annotations::default(),
        };
        let drawn = Figure::new(&motion, &view).and_then(|figure| {
            let pose = motion.pose::<1>(motion.home())?;
            let frame = figure.frame(&pose);
            Ok((figure, frame))
        });
        let (figure, frame) = drawn
            .map_err(|unsolved| vec![LinkageProblem::unsolved(&unsolved, mechanism).into()])?;
        Ok(Self {
            mechanism: mechanism.clone(),
            figure,
            frame,
        })
    }
}

impl Capabilities for Scheme {
    fn summary(&self) -> JsValue {
        to_js(&SchemeSummary {
            moves: None,
            structure: StructureSummary::new(&self.mechanism, &self.figure),
            handles: [],
        })
    }

    fn figure(&self) -> &Figure {
        &self.figure
    }

    fn still(&self) -> Vec<f32> {
        self.frame.clone()
    }
}
