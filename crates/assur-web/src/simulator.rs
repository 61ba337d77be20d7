//! The one object the page talks to.

use assur::Point;
use assur::catalog::mixer::Case;
use assur_draw::ROLES;
use assur_file::Document;
use assur_file::{MixerDocument, Problem, State};
use plotters::prelude::IntoDrawingArea;
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};
use web_sys::CanvasRenderingContext2d;

use crate::canvas::Canvas;
use crate::convert::{ChartLayout, ChartRequest, thrown, to_js};
use crate::linkage::Linkage;
use crate::mixer::Loaded as LoadedMixer;
use crate::shown::Shown;

/// A mechanism and all that is drawn of it. Angles are radians. What fails
/// throws an array of problems, `{code, …}`, and changes nothing.
#[wasm_bindgen]
#[derive(Default)]
pub struct Simulator {
    shown: Option<Box<dyn Shown>>,
}

#[wasm_bindgen]
impl Simulator {
    /// A simulator without a mechanism: the first call is `set`.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes the page's state and returns the summary of its motion.
    ///
    /// # Errors
    /// Every problem of the state; the mechanism set before stays.
    pub fn set(&mut self, state: JsValue) -> Result<JsValue, JsValue> {
        let source = || serde_wasm_bindgen::Deserializer::from(state.clone());
        let state = State::read(source).map_err(|problem| thrown([problem]))?;
        let shown = shown(&state).map_err(thrown)?;
        let summary = shown.summary();
        self.shown = Some(shown);
        Ok(summary)
    }

    /// The names of the labels of the display lists, in order.
    ///
    /// # Errors
    /// Before the first `set`.
    #[wasm_bindgen(js_name = labelNames)]
    pub fn label_names(&self) -> Result<Vec<String>, JsValue> {
        Ok(self.shown()?.labels())
    }

    /// The display list of everything rigid, grouped by body.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn scene(&self) -> Result<Vec<f32>, JsValue> {
        Ok(self.shown()?.scene().numbers().to_vec())
    }

    /// The bodies' poses `n, x, y, θ, …` at a crank angle and the display list of
    /// what changes its shape.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn frame(&self, phi: f64) -> Result<Vec<f32>, JsValue> {
        self.shown()?.frame(phi).map_err(one)
    }

    /// The names of the values of `readouts`, in order: the crank angle, of a mixer
    /// the transmission angle, then every quantity with its first (′) and second
    /// (″) derivative.
    ///
    /// # Errors
    /// Before the first `set`.
    #[wasm_bindgen(js_name = readoutNames)]
    pub fn readout_names(&self) -> Result<Vec<String>, JsValue> {
        Ok(self.shown()?.readout_names())
    }

    /// The values named by `readoutNames` at a crank angle; derivatives are those
    /// of the axes, by the crank angle or by time.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
    pub fn readouts(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        self.shown()?.readouts(phi).map_err(one)
    }

    /// The quantities that are plotted at a crank angle: of each in the order of
    /// the chart's series the value and the first two derivatives of the axes.
    ///
    /// # Errors
    /// As of `readouts`.
    pub fn plotted(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        self.shown()?.plotted(phi).map_err(one)
    }

    /// Where what can be dragged is at a crank angle, x and y of each: of a mixer
    /// the joints A, B, C, D and the traced points P₁, …; of a linkage the handles
    /// of its summary.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn joints(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        self.shown()?.joints(phi).map_err(one)
    }

    /// What dragging a joint (of a mixer `B`, `C`, `D`, or a traced point `P1`, …)
    /// to a place changes, with the crank at an angle: `{phi}` or `{document}` with
    /// the fields that become others. A traced point keeps to its link. Whether the
    /// fields make a mechanism is found out by `set`.
    ///
    /// # Errors
    /// An unknown joint, a place that is not finite; no pose to drag in.
    pub fn drag(&self, joint: &str, phi: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.shown()?.drag(joint, phi, Point::new(x, y));
        Ok(to_js(&change.map_err(one)?))
    }

    /// What tracing the point at a place changes, with the crank at an angle:
    /// `{document}` with one more traced point, on the link drawn nearest.
    ///
    /// # Errors
    /// Why there is no pose to put a point on; not of a mixer.
    pub fn trace(&self, phi: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.shown()?.trace(phi, Point::new(x, y));
        Ok(to_js(&change.map_err(one)?))
    }

    /// The crank angle moved by `delta`, and −1 where it turned back at the end
    /// of what it can turn through, else 1.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn advance(&self, phi: f64, delta: f64) -> Result<Vec<f64>, JsValue> {
        let (phi, sense) = self.shown()?.cycle().advance(phi, delta);
        Ok(vec![phi, sense])
    }

    /// Draws the plots with plotters on a canvas whose transform maps pixels of
    /// the reader to its backing store; `request` is `{width, height, palette}`.
    /// Returns where the page writes their text.
    ///
    /// # Errors
    /// A request of the wrong form; before the first `set`.
    pub fn chart(
        &self,
        context: &CanvasRenderingContext2d,
        request: JsValue,
    ) -> Result<JsValue, JsValue> {
        let chart = self.shown()?.chart();
        let request = ChartRequest::read(request).map_err(|problem| thrown([problem]))?;
        let size = (request.width, request.height);
        let canvas = Canvas::new(context, size, request.ratio, request.whole);
        let drawn = chart.draw(
            &canvas.into_drawing_area(),
            &request.palette(),
            request.scale,
        );
        let panels = drawn.map_err(|error| one(bad("chart", error.to_string())))?;
        Ok(to_js(&ChartLayout::new(chart, panels)))
    }

    /// The motion as a table `{columns, rows: [{phi_deg, values, reason}]}`, with
    /// `steps` rows to a turn of the crank and its end; `null` where there is no
    /// value, with the reason.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn sweep(&self, steps: u32) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.shown()?.table(steps)))
    }

    /// Of every constraint equation of the summary at a crank angle its left side,
    /// its right side and by how much they differ; with order 1 or 2 of its
    /// derivative by the crank angle.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
    pub fn equations(&self, phi: f64, order: usize) -> Result<Vec<f64>, JsValue> {
        self.shown()?.equations(phi, order).map_err(one)
    }

    fn shown(&self) -> Result<&dyn Shown, JsValue> {
        let shown = self.shown.as_deref();
        shown.ok_or_else(|| one(bad("", "no state has been set".to_owned())))
    }
}

/// The mechanism of a state with all that is drawn of it.
fn shown(state: &State) -> Result<Box<dyn Shown>, Vec<Problem>> {
    Ok(match &state.document {
        Document::Mixer(_) => Box::new(LoadedMixer::new(state)?),
        Document::Linkage(document) => Box::new(Linkage::new(state, document)?),
    })
}

/// One problem as it is thrown.
fn one(problem: Problem) -> JsValue {
    thrown([problem])
}

fn bad(path: &str, detail: String) -> Problem {
    Problem::BadState {
        path: path.to_owned(),
        detail,
    }
}

/// The names of the roles of display lists and palettes, in order.
#[wasm_bindgen(js_name = roleNames)]
pub fn role_names() -> Vec<String> {
    ROLES.map(str::to_owned).to_vec()
}

/// The presets of the lesson: `{id, document}` for each case of the figure.
#[wasm_bindgen]
pub fn presets() -> JsValue {
    #[derive(Serialize)]
    struct Preset {
        id: &'static str,
        document: MixerDocument,
    }
    let preset = |case: Case| Preset {
        id: match case {
            Case::A => "a",
            Case::B => "b",
            Case::C => "c",
        },
        document: MixerDocument::new(&case.dimensions()),
    };
    to_js(&Case::ALL.map(preset))
}

/// A state from outside (an address, a file, what was kept), read and checked:
/// the same state with the keys we know and no others.
///
/// # Errors
/// Every problem of the state.
#[wasm_bindgen(js_name = readState)]
pub fn read_state(state: JsValue) -> Result<JsValue, JsValue> {
    let source = || serde_wasm_bindgen::Deserializer::from(state.clone());
    let state = State::read(source).map_err(|problem| thrown([problem]))?;
    shown(&state).map_err(thrown)?;
    Ok(to_js(&state))
}

/// The version of Assur.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
