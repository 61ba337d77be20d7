//! Read-outs and plots of a differential over time.

mod moves;

use std::borrow::Cow;
use std::collections::BTreeMap;

use assur::dynamics::{Body, Halt, Mesh, Reading, Recording};
use assur::gears::train::{Shaft, Turned, Turning};
use assur::{Jet, Relation};
use assur_draw::TrainPose;
use assur_draw::chart::{Against, At, Axis, Chart, Kind, Sample, Series, Settings};
use assur_file::{GearTrainDocument, Problem, View};

use super::GearTrain;
use super::quantity::{BODIES, Column, NUMBERS, Quantity, plotted};
use crate::capabilities::Moves;
use crate::here::{Here, ReadoutId};
use crate::pair::{INPUT, Pair};
use crate::table::{SweepColumn, SweepRow, SweepTable};

/// Number of intervals between the samples of a curve without load.
const SAMPLES: usize = 240;

/// A differential over time, with its plots.
pub(crate) struct Course {
    pub(crate) train: assur_file::GearTrain,
    observer: Option<Shaft>,
    span: f64,
    /// The recorded run of a train under load.
    recording: Option<Recording>,
    /// Peak torque of the magnetic field on the central wheel of each mesh, N·m; none without load.
    peaks: Option<[f64; 2]>,
    plotted: Vec<Quantity>,
    /// Two quantities plotted against each other, in place of the plots over time.
    pair: Option<Pair<Column>>,
    numbers: BTreeMap<String, String>,
    /// Plots of a run under load; none for the endless motion without load, or if `pair` is plotted.
    chart: Option<Chart>,
    against: Option<Against>,
}

/// State of the train at a time.
struct Known {
    /// Rotation of the bodies relative to the observer.
    turned: Turned,
    /// Angle of the ground relative to the observer.
    ground: f64,
    reading: Option<Reading>,
}

impl Course {
    pub(crate) fn new(
        train: assur_file::GearTrain,
        document: &GearTrainDocument,
        view: &View,
    ) -> Result<Self, Vec<Problem>> {
        let differential = train.differential.as_ref().filter(|_| document.loaded);
        let run = differential.map(|differential| train.run(differential));
        let recording = run
            .transpose()?
            .map(|run| Recording::new(run, document.span_s));
        let loaded = recording.is_some();
        let plotted = plotted(&view.plot, loaded).ok_or_else(|| {
            let field = "plot".into();
            vec![Problem::UnknownChoice { field }]
        })?;
        let pair = Pair::of(view, |name| Column::named(name, loaded))?;
        let peaks = differential.map(|differential| Mesh::ALL.map(|mesh| differential.peak(mesh)));
        let numbers = BODIES.iter().zip(NUMBERS);
        let mut course = Self {
            peaks,
            train,
            observer: document.observer.shaft(),
            span: document.span_s,
            recording,
            plotted,
            numbers: numbers
                .map(|(name, number)| ((*name).to_owned(), number.to_owned()))
                .collect(),
            pair,
            chart: None,
            against: None,
        };
        course.plot_run();
        Ok(course)
    }

    pub(crate) fn loaded(&self) -> bool {
        self.recording.is_some()
    }

    /// The reason why a run ended before the end of its span, if it did.
    pub(crate) fn halt(&self) -> Option<Halt> {
        self.recording.as_ref().and_then(Recording::halt)
    }

    /// The read-outs at the end of a run.
    pub(crate) fn last(&self) -> Option<Reading> {
        let recording = self.recording.as_ref()?;
        Some(recording.at(recording.end()).reading())
    }

    /// End of the time axis, which begins at 0.
    pub(crate) fn end(&self) -> f64 {
        self.recording.as_ref().map_or(self.span, Recording::end)
    }

    pub(crate) fn plotted(&self) -> &[Quantity] {
        &self.plotted
    }

    pub(crate) fn numbers(&self) -> &BTreeMap<String, String> {
        &self.numbers
    }

    /// All quantities with read-outs.
    fn quantities(&self) -> impl Iterator<Item = Quantity> {
        Quantity::all(self.loaded())
    }

    /// Names of the additional read-outs under load.
    fn names_of_run(&self) -> impl Iterator<Item = String> {
        let names = OF_RUN.iter().filter(|_| self.loaded());
        names.map(|name| (*name).to_owned())
    }

    fn known(&self, time: f64) -> Known {
        match &self.recording {
            Some(recording) => self.of_reading(recording.at(time).reading()),
            None => self.seen(self.train.turning.at(time), None),
        }
    }

    fn of_reading(&self, reading: Reading) -> Known {
        self.seen(reading.turned(), Some(reading))
    }

    fn seen(&self, turned: Turned, reading: Option<Reading>) -> Known {
        match self.observer {
            Some(shaft) => Known {
                ground: -turned.angles[shaft.index()].part(),
                turned: turned.seen_from(shaft),
                reading,
            },
            None => Known {
                ground: 0.0,
                turned,
                reading,
            },
        }
    }

    /// The relations of the paper at a time, relative to the ground.
    pub(crate) fn relations(&self, time: f64) -> Vec<Relation> {
        let recording = self.recording.as_ref();
        let reading = recording.map(|recording| recording.at(time).reading());
        let turned = match &reading {
            Some(reading) => reading.turned(),
            None => self.train.turning.at(time),
        };
        let mut all = (self.train.layout).relations(self.train.coupling, &turned.speeds);
        all.extend(
            reading
                .iter()
                .flat_map(|reading| reading.energy.relations()),
        );
        all
    }

    fn pose(&self, known: &Known) -> TrainPose {
        let of_peaks = |(reading, peaks): (&Reading, [f64; 2])| {
            [0, 1].map(|mesh: usize| reading.meshes[mesh].torque / peaks[mesh])
        };
        TrainPose {
            angles: known.turned.angles.map(|angle| angle.part()),
            speeds: known.turned.speeds,
            torques: known.reading.as_ref().zip(self.peaks).map(of_peaks),
            ground: known.ground,
        }
    }

    fn sample(&self, time: f64, known: &Known) -> At {
        let jets = self.plotted.iter();
        let jets = jets.map(|one| Jet::of_derivatives(known.rates(*one)));
        let jets: Vec<Jet<3>> = jets.collect();
        (time, Sample { jets, clear: true })
    }

    fn series(&self) -> Vec<Series> {
        let series = self.plotted.iter().map(|one| Series {
            name: one.name(),
            role: one.role(),
            features: None,
        });
        series.collect()
    }

    /// Makes the plots of a whole run under load.
    fn plot_run(&mut self) {
        let Some(recording) = &self.recording else {
            return;
        };
        let known = recording.readings();
        let known = known.map(|reading| (reading.time, self.of_reading(reading)));
        let known: Vec<(f64, Known)> = known.collect();
        if let Some(pair) = &self.pair {
            self.against = Some(self.plotted_against(pair, &known));
            return;
        }
        let samples = known.iter().map(|(time, known)| self.sample(*time, known));
        let span = [0.0, self.end()];
        let samples = samples.collect();
        self.chart = Some(Chart::by_time(span, Kind::Angle, self.series(), samples));
    }

    /// The span that contains a time, for a motion without end: start of the span, and samples over it.
    fn around(&self, time: f64) -> (f64, Vec<(f64, Known)>) {
        let start = self.span * (on_axis(time) / self.span).floor();
        let known = (0..=SAMPLES).map(|step| {
            let time = start + self.span * step as f64 / SAMPLES as f64;
            (time, self.known(time))
        });
        (start, known.collect())
    }

    /// The plots over the span that contains a time.
    fn plotted_around(&self, time: f64) -> Chart {
        let (start, known) = self.around(time);
        let samples = known.iter().map(|(time, known)| self.sample(*time, known));
        let span = [start, start + self.span];
        Chart::by_time(span, Kind::Angle, self.series(), samples.collect())
    }

    /// The plot of one quantity against another, from samples.
    fn plotted_against(&self, pair: &Pair<Column>, known: &[(f64, Known)]) -> Against {
        let Pair { x, y } = *pair;
        let sample = |(time, known): &(f64, Known)| {
            let jet = |column: Column| Jet::of_derivatives(known.rates(column.quantity));
            let jets = vec![x.map_or(Jet::linear(*time, 1.0), jet), jet(y)];
            (*time, Sample { jets, clear: true })
        };
        let axis = |column: Option<Column>| Axis {
            name: column.map(|column| column.quantity.name()),
            kind: column.map_or(Kind::Length, |_| Kind::Angle),
            order: column.map_or(0, |column| column.order),
        };
        let run = known.iter().map(sample).collect();
        let axes = [axis(x), axis(Some(y))];
        Against::new(axes, y.quantity.role(), &[run], true, Settings::BY_TIME)
    }

    /// The quantities of the plotted curves.
    pub(crate) fn curves(&self) -> Vec<Quantity> {
        match &self.pair {
            Some(pair) => pair.quantities(|column| Some(column.quantity)),
            None => self.plotted.clone(),
        }
    }

    /// The plotted values at a time.
    fn on_plots(&self, time: f64, known: &Known) -> Vec<f64> {
        match &self.pair {
            Some(pair) => pair
                .values(time, |column| {
                    Some(known.rates(column.quantity)[column.order])
                })
                .unwrap_or_default(),
            None => {
                let plotted = self.plotted.iter();
                plotted.flat_map(|one| known.rates(*one)).collect()
            }
        }
    }
}

/// Clamps a time to its limits; NaN becomes 0.
fn on_axis(time: f64) -> f64 {
    time.clamp(0.0, Turning::MAX_TIME).max(0.0)
}

impl Known {
    /// A quantity and its first two derivatives with respect to time.
    fn rates(&self, quantity: Quantity) -> [f64; 3] {
        match quantity {
            Quantity::Angle(body) => {
                let Turned {
                    angles,
                    speeds,
                    accelerations,
                    ..
                } = &self.turned;
                [angles[body].radians(), speeds[body], accelerations[body]]
            }
            // Load angles are read only under load.
            Quantity::LoadAngle(mesh) => self.reading.as_ref().map_or([0.0; 3], |reading| {
                let one = &reading.meshes[mesh];
                [one.advance, one.slip_speed, one.slip_acceleration]
            }),
        }
    }
}

/// Names of a run's read-outs other than angles and their derivatives: torques and the energy balance.
const OF_RUN: [&str; 11] = [
    "sun.field",
    "ring.field",
    "sun.drive",
    "carrier.drive",
    "ring.drive",
    "kinetic",
    "potential",
    "driven",
    "dissipated",
    "delivered",
    "imbalance",
];

/// Values of the read-outs [`OF_RUN`], in the same order.
fn of_run(reading: &Reading) -> [f64; OF_RUN.len()] {
    let drive = |body| reading.body(body).drive_torque.unwrap_or(0.0);
    let energy = &reading.energy;
    [
        reading.mesh(Mesh::Sun).torque,
        reading.mesh(Mesh::Ring).torque,
        drive(Body::Sun),
        drive(Body::Carrier),
        drive(Body::Ring),
        energy.kinetic,
        energy.potential,
        energy.driven,
        energy.dissipated,
        energy.delivered,
        energy.imbalance(),
    ]
}
