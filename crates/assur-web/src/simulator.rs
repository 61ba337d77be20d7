//! The one object the page talks to.

use assur::catalog::mixer::{Case, Joint, Mixer, Quantity};
use assur::{Cycle, Jet, Point, Pose, Unsolved};
use assur_draw::chart::{Chart, Settings};
use assur_draw::{LABELS, Overlays, ROLES, Scene, plot};
use assur_file::{Axes, MixerDocument, Problem, State};
use plotters::prelude::IntoDrawingArea;
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};
use web_sys::CanvasRenderingContext2d;

use crate::canvas::Canvas;
use crate::convert::{Change, ChartLayout, ChartRequest, thrown, to_js};
use crate::summary::Summary;
use crate::table::SweepTable;

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
    quantities: Vec<Quantity>,
    plotted: Vec<Quantity>,
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
        let source = || serde_wasm_bindgen::Deserializer::from(state.clone());
        let state = State::read(source).map_err(|problem| thrown([problem]))?;
        let (mixer, plotted) = state.mixer().map_err(thrown)?;
        let overlays = Overlays {
            traces: state.view.traces,
            centres: state.view.centres,
            vectors: state.view.vectors,
            loop_vectors: state.view.loop_vectors,
            transmission: state.view.transmission,
        };
        let scene = Scene::new(&mixer, overlays);
        let summary = Summary::new(&mixer, scene.bounds());
        let settings = Settings {
            input: state.view.input(),
            physical: state.view.axes == Axes::Physical,
            differenced: state.view.differenced,
        };
        self.loaded = Some(Loaded {
            cycle: mixer.linkage.cycle(),
            quantities: mixer.quantities(),
            chart: plot(&mixer, &plotted, settings),
            plotted,
            scene,
            mixer,
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

    /// The names of the values of `readouts`, in order: the crank angle, the
    /// transmission angle, then every quantity with its first (′) and second (″)
    /// derivative.
    ///
    /// # Errors
    /// Before the first `set`.
    #[wasm_bindgen(js_name = readoutNames)]
    pub fn readout_names(&self) -> Result<Vec<String>, JsValue> {
        let names = self.loaded()?.quantities.iter().map(|q| q.name());
        let names = names.flat_map(|name| ["", "′", "″"].map(|stroke| [&name, stroke].concat()));
        let first = ["phi1", "transmission"].map(str::to_owned);
        Ok(first.into_iter().chain(names).collect())
    }

    /// The values named by `readoutNames` at a crank angle; derivatives are those
    /// of the axes, by the crank angle or by time.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
    pub fn readouts(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        let loaded = self.loaded()?;
        let transmission = solved(loaded.mixer.linkage.transmission_angle(phi))?;
        let values = loaded.rates(&loaded.quantities, phi)?;
        Ok([phi, transmission].into_iter().chain(values).collect())
    }

    /// The quantities that are plotted at a crank angle: of each in the order of
    /// the chart's series the value and the first two derivatives of the axes.
    ///
    /// # Errors
    /// As of `readouts`.
    pub fn plotted(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        let loaded = self.loaded()?;
        loaded.rates(&loaded.plotted, phi)
    }

    /// Where the joints A, B, C, D and the traced points P₁, … are at a crank
    /// angle: x and y of each.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn joints(&self, phi: f64) -> Result<Vec<f64>, JsValue> {
        let Loaded { mixer, .. } = self.loaded()?;
        let pose: Pose<1> = solved(mixer.linkage.pose(mixer.assembly, phi))?;
        let traced = mixer.tracers().iter().map(|one| mixer.traced(&pose, one));
        let points = mixer.linkage.joints(&pose).into_iter().chain(traced);
        Ok(points
            .map(|point| point.place())
            .flat_map(|at| [at.x, at.y])
            .collect())
    }

    /// What dragging a joint (`B`, `C` or `D`) or a traced point (`P1`, …) to a
    /// place changes, with the crank at an angle: `{phi}` or `{document}` with the
    /// fields that become others. A traced point keeps to its link. Whether the
    /// fields make a mechanism is found out by `set`.
    ///
    /// # Errors
    /// An unknown joint, a place that is not finite; no pose to drag D or a traced
    /// point in.
    pub fn drag(&self, joint: &str, phi: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let Loaded { mixer, .. } = self.loaded()?;
        let place = Point::new(x, y);
        let joint = match joint {
            "B" => Joint::B,
            "C" => Joint::C,
            "D" => Joint::D,
            other => {
                let index = (0..mixer.tracers().len()).find(|i| other == format!("P{}", i + 1));
                let Some(index) = index else {
                    return Err(thrown([Problem::BadState {
                        path: "joint".to_owned(),
                        detail: other.to_owned(),
                    }]));
                };
                let mut tracers = mixer.tracers().to_vec();
                let pose = solved(mixer.linkage.pose(mixer.assembly, phi))?;
                tracers[index] = mixer.tracer_at(&pose, tracers[index].carrier, place);
                return Ok(to_js(&Change::tracers(&tracers)));
            }
        };
        let dragged = solved(mixer.dragged(joint, phi, place))?;
        Ok(to_js(&Change::new(joint, dragged)))
    }

    /// What tracing the point at a place changes, with the crank at an angle:
    /// `{document}` with one more traced point, on the link drawn nearest.
    ///
    /// # Errors
    /// Why there is no pose to put a point on.
    pub fn trace(&self, phi: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let Loaded { mixer, scene, .. } = self.loaded()?;
        let place = Point::new(x, y);
        let pose = solved(mixer.linkage.pose(mixer.assembly, phi))?;
        let carrier = solved(scene.carrier_at(phi, place))?;
        let mut tracers = mixer.tracers().to_vec();
        tracers.push(mixer.tracer_at(&pose, carrier, place));
        Ok(to_js(&Change::tracers(&tracers)))
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
        let size = (request.width, request.height);
        let canvas = Canvas::new(context, size, request.ratio, request.whole);
        let drawn = loaded.chart.draw(
            &canvas.into_drawing_area(),
            &request.palette(),
            request.scale,
        );
        let panels = drawn.map_err(|error| {
            thrown([Problem::BadState {
                path: "chart".to_owned(),
                detail: error.to_string(),
            }])
        })?;
        Ok(to_js(&ChartLayout::new(&loaded.chart, panels)))
    }

    /// The motion as a table `{columns, rows: [{phi_deg, values, reason}]}`, with
    /// `steps` rows to a turn of the crank and its end; `null` where there is no
    /// value, with the reason.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn sweep(&self, steps: u32) -> Result<JsValue, JsValue> {
        Ok(to_js(&SweepTable::new(&self.loaded()?.mixer, steps)))
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

impl Loaded {
    /// Quantities at a crank angle, each with its derivatives of the axes.
    fn rates(&self, quantities: &[Quantity], phi: f64) -> Result<Vec<f64>, JsValue> {
        let jets: Vec<Jet<3>> = solved(self.mixer.jets(quantities, phi))?;
        let input = self.chart.settings().input;
        let rates = |jet: &Jet<3>| [0, 1, 2].map(|order| input.rate(jet, order));
        Ok(jets.iter().flat_map(rates).collect())
    }
}

/// What is solved, or the reason why not as it is thrown.
fn solved<T>(result: Result<T, Unsolved>) -> Result<T, JsValue> {
    result.map_err(|unsolved| thrown([unsolved]))
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
    let source = || serde_wasm_bindgen::Deserializer::from(state.clone());
    let state = State::read(source).map_err(|problem| thrown([problem]))?;
    state.mixer().map_err(thrown)?;
    Ok(to_js(&state))
}

/// The version of Assur.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
