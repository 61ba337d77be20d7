//! The one object the page talks to.

use assur::catalog::mixer::{Case, Joint, Mixer};
use assur::motion::extrema;
use assur::{Cycle, Point, Pose, Unsolved};
use assur_draw::chart::Chart;
use assur_draw::{LABELS, Overlays, ROLES, Scene};
use assur_file::{MixerDocument, Problem, State};
use plotters::prelude::IntoDrawingArea;
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};
use web_sys::CanvasRenderingContext2d;

use crate::canvas::Canvas;
use crate::convert::{Change, ChartLayout, ChartRequest, thrown, to_js};
use crate::summary::Summary;

/// A mechanism and all that is drawn of it. Angles are radians. What fails
/// throws an array of problems, `{code, …}`, and changes nothing.
#[wasm_bindgen]
#[derive(Default)]
pub struct Simulator {
    loaded: Option<Loaded>,
}

struct Loaded {
    mixer: Mixer,
    cycle: Cycle,
    scene: Scene,
    chart: Chart,
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
        let source = serde_wasm_bindgen::Deserializer::from(state);
        let state = State::read(source).map_err(|problem| thrown([problem]))?;
        let mixer = match (state.check(), state.document.mixer()) {
            (Ok(()), Ok(mixer)) => mixer,
            (checked, mixer) => {
                let problems = [checked.err(), mixer.err()];
                return Err(thrown(problems.into_iter().flatten().flatten()));
            }
        };
        let overlays = Overlays {
            traces: state.view.traces,
            centres: state.view.centres,
            vectors: state.view.vectors,
            loop_vectors: state.view.loop_vectors,
            transmission: state.view.transmission,
        };
        let scene = Scene::new(&mixer, overlays);
        let extrema = extrema(&mixer.linkage, mixer.assembly, |pose| pose.rocker);
        let summary = Summary::new(&mixer, &extrema, scene.bounds());
        self.loaded = Some(Loaded {
            mixer,
            cycle: mixer.linkage.cycle(),
            chart: Chart::new(&mixer, &extrema),
            scene,
        });
        Ok(to_js(&summary))
    }

    /// The display list of everything rigid, grouped by body.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn scene(&self) -> Result<Vec<f32>, JsValue> {
        Ok(self.loaded()?.scene.rigid().numbers().to_vec())
    }

    /// The bodies' poses `n, x, y, θ, …` at a crank angle and the display list of
    /// what changes its shape.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn frame(&self, phi: f64) -> Result<Vec<f32>, JsValue> {
        solved(self.loaded()?.scene.frame(phi))
    }

    /// The values named by `readoutNames` at a crank angle.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
    pub fn readouts(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        let Loaded { mixer, .. } = self.loaded()?;
        let pose: Pose<3> = solved(mixer.linkage.pose(mixer.assembly, phi))?;
        let transmission = solved(mixer.linkage.transmission_angle(phi))?;
        let wheel5 = mixer.gears.driven(pose.rocker);
        let angles = [pose.coupler, pose.rocker, wheel5];
        let values = angles
            .iter()
            .flat_map(|angle| [0, 1, 2].map(|k| angle.derivative(k)));
        Ok([phi]
            .into_iter()
            .chain(values)
            .chain([transmission])
            .collect())
    }

    /// Where the joints A, B, C, D are at a crank angle: x and y of each.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn joints(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        let Loaded { mixer, .. } = self.loaded()?;
        let pose: Pose<1> = solved(mixer.linkage.pose(mixer.assembly, phi))?;
        let joints = mixer.linkage.joints(&pose).map(|joint| joint.place());
        Ok(joints.iter().flat_map(|at| [at.x, at.y]).collect())
    }

    /// What dragging a joint (`B`, `C` or `D`) to a place changes, with the crank
    /// at an angle: `{phi}` or `{document}` with the fields that become others.
    /// Whether those make a mechanism is found out by `set`.
    ///
    /// # Errors
    /// An unknown joint, a place that is not finite; no pose to drag D in.
    pub fn drag(&self, joint: &str, phi: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let Loaded { mixer, .. } = self.loaded()?;
        let joint = match joint {
            "B" => Joint::B,
            "C" => Joint::C,
            "D" => Joint::D,
            other => {
                return Err(thrown([Problem::BadState {
                    path: "joint".to_owned(),
                    detail: other.to_owned(),
                }]));
            }
        };
        let dragged = solved(mixer.dragged(joint, phi, Point::new(x, y)))?;
        Ok(to_js(&Change::new(joint, dragged)))
    }

    /// The crank angle moved by `delta`, and −1 where it turned back at the end
    /// of what it can turn through, else 1.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn advance(&self, phi: f64, delta: f64) -> Result<Vec<f64>, JsValue> {
        let (phi, sense) = self.loaded()?.cycle.advance(phi, delta);
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
        let loaded = self.loaded()?;
        let request = ChartRequest::read(request).map_err(|problem| thrown([problem]))?;
        let canvas = Canvas::new(context, (request.width, request.height));
        let drawn = loaded
            .chart
            .draw(&canvas.into_drawing_area(), &request.palette());
        let panels = drawn.map_err(|error| {
            thrown([Problem::BadState {
                path: "chart".to_owned(),
                detail: error.to_string(),
            }])
        })?;
        Ok(to_js(&ChartLayout::from(panels)))
    }

    fn loaded(&self) -> Result<&Loaded, JsValue> {
        self.loaded.as_ref().ok_or_else(|| {
            thrown([Problem::BadState {
                path: String::new(),
                detail: "no state has been set".to_owned(),
            }])
        })
    }
}

/// What is solved, or the reason why not as it is thrown.
fn solved<T>(result: Result<T, Unsolved>) -> Result<T, JsValue> {
    result.map_err(|unsolved| thrown([unsolved]))
}

/// The names of the values of `readouts`, in order: angles are followed by their
/// first (d) and second (dd) derivative by the crank angle.
#[wasm_bindgen(js_name = readoutNames)]
pub fn readout_names() -> Vec<String> {
    let angles = ["coupler", "rocker", "wheel5"];
    let values = angles
        .iter()
        .flat_map(|name| ["", "d", "dd"].map(|d| format!("{d}{name}")));
    let first = ["phi1".to_owned()];
    let last = ["transmission".to_owned()];
    first.into_iter().chain(values).chain(last).collect()
}

/// The names of the roles of display lists and palettes, in order.
#[wasm_bindgen(js_name = roleNames)]
pub fn role_names() -> Vec<String> {
    ROLES.map(str::to_owned).to_vec()
}

/// The names of the labels of display lists, in order.
#[wasm_bindgen(js_name = labelNames)]
pub fn label_names() -> Vec<String> {
    LABELS.map(str::to_owned).to_vec()
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
    let source = serde_wasm_bindgen::Deserializer::from(state);
    let state = State::read(source).map_err(|problem| thrown([problem]))?;
    match (state.check(), state.document.mixer()) {
        (Ok(()), Ok(_)) => Ok(to_js(&state)),
        (checked, mixer) => {
            let problems = [checked.err(), mixer.err()];
            Err(thrown(problems.into_iter().flatten().flatten()))
        }
    }
}

/// The version of Assur.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
