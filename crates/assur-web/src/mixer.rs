//! The mixer on the page.

use assur::catalog::mixer::{Joint, Mixer, Quantity};
use assur::{Cycle, Jet, Point, Pose};
use assur_draw::chart::Chart;
use assur_draw::{LABELS, List, Overlays, Scene, plot};
use assur_file::{Problem, State};
use wasm_bindgen::prelude::JsValue;

use crate::convert::{Change, to_js};
use crate::shown::{Shown, rates, settings, strokes, unknown};
use crate::summary::Summary;
#[cfg(feature = "linkages")]
use crate::table::SweepTable;

/// A mixer with all that is drawn of it.
pub(crate) struct Loaded {
    mixer: Mixer,
    cycle: Cycle,
    quantities: Vec<Quantity>,
    plotted: Vec<Quantity>,
    scene: Scene,
    chart: Chart,
}

impl Loaded {
    pub(crate) fn new(state: &State) -> Result<Self, Vec<Problem>> {
        let (mixer, plotted) = state.mixer()?;
        let overlays = Overlays {
            traces: state.view.traces,
            centres: state.view.centres,
            vectors: state.view.vectors,
            loop_vectors: state.view.loop_vectors,
            transmission: state.view.transmission,
            groups: state.view.groups,
        };
        Ok(Self {
            cycle: mixer.linkage.cycle(),
            quantities: mixer.quantities(),
            chart: plot(&mixer, &plotted, settings(&state.view)),
            plotted,
            scene: Scene::new(&mixer, overlays),
            mixer,
        })
    }

    /// Quantities at a crank angle, each with its derivatives of the axes.
    fn rates(&self, quantities: &[Quantity], phi: f64) -> Result<Vec<f64>, Problem> {
        let jets: Vec<Jet<3>> = self.mixer.jets(quantities, phi)?;
        Ok(rates(&jets, self.chart.settings().input))
    }
}

impl Shown for Loaded {
    fn summary(&self) -> JsValue {
        to_js(&Summary::new(&self.mixer, self.scene.bounds()))
    }

    fn labels(&self) -> Vec<String> {
        LABELS.map(str::to_owned).to_vec()
    }

    fn scene(&self) -> &List {
        self.scene.rigid()
    }

    fn frame(&self, phi: f64) -> Result<Vec<f32>, Problem> {
        Ok(self.scene.frame(phi)?)
    }

    fn readout_names(&self) -> Vec<String> {
        let names = self.quantities.iter().flat_map(|one| strokes(&one.name()));
        let first = ["phi1", "transmission"].map(str::to_owned);
        first.into_iter().chain(names).collect()
    }

    fn readouts(&self, phi: f64) -> Result<Vec<f64>, Problem> {
        let transmission = self.mixer.linkage.transmission_angle(phi)?;
        let values = self.rates(&self.quantities, phi)?;
        Ok([phi, transmission].into_iter().chain(values).collect())
    }

    fn plotted(&self, phi: f64) -> Result<Vec<f64>, Problem> {
        self.rates(&self.plotted, phi)
    }

    fn joints(&self, phi: f64) -> Result<Vec<f64>, Problem> {
        let mixer = &self.mixer;
        let pose: Pose<1> = mixer.linkage.pose(mixer.assembly, phi)?;
        let traced = mixer.tracers().iter().map(|one| mixer.traced(&pose, one));
        let points = mixer.linkage.joints(&pose).into_iter().chain(traced);
        Ok(points
            .map(|point| point.place())
            .flat_map(|at| [at.x, at.y])
            .collect())
    }

    fn drag(&self, joint: &str, phi: f64, place: Point) -> Result<Change, Problem> {
        let mixer = &self.mixer;
        let joint = match joint {
            "B" => Joint::B,
            "C" => Joint::C,
            "D" => Joint::D,
            other => {
                let index = (0..mixer.tracers().len()).find(|i| other == format!("P{}", i + 1));
                let index = index.ok_or_else(|| unknown(other))?;
                let mut tracers = mixer.tracers().to_vec();
                let pose = mixer.linkage.pose(mixer.assembly, phi)?;
                tracers[index] = mixer.tracer_at(&pose, tracers[index].carrier, place);
                return Ok(Change::tracers(&tracers));
            }
        };
        Ok(Change::new(joint, mixer.dragged(joint, phi, place)?))
    }

    fn trace(&self, phi: f64, place: Point) -> Result<Change, Problem> {
        let mixer = &self.mixer;
        let pose = mixer.linkage.pose(mixer.assembly, phi)?;
        let carrier = self.scene.carrier_at(phi, place)?;
        let mut tracers = mixer.tracers().to_vec();
        tracers.push(mixer.tracer_at(&pose, carrier, place));
        Ok(Change::tracers(&tracers))
    }

    fn cycle(&self) -> &Cycle {
        &self.cycle
    }

    fn chart(&self) -> &Chart {
        &self.chart
    }

    #[cfg(feature = "linkages")]
    fn table(&self, steps: u32) -> SweepTable {
        SweepTable::new(&self.mixer, steps)
    }
}
