//! A mixer with its motion and its drawing; functions that read display lists.

use std::f64::consts::TAU;

use assur::gears::Mate;
use assur::mechanism::Pose;
use assur::mixer::{Carrier, Case, Dimensions, Mixer, Tracer};
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_draw::{Annotations, Figure, Overlays, View};

use crate::records::records;

pub(crate) const CRANK: usize = 1;
pub(crate) const COUPLER: usize = 2;
pub(crate) const ROCKER: usize = 3;

/// The look of a dashed line.
pub(crate) const DASHED: f32 = 3.0;

pub(crate) const ALL: Overlays = Overlays {
    traces: true,
    centres: true,
    vectors: true,
    loop_vectors: true,
    transmission: true,
    groups: false,
    numbers: false,
};

pub(crate) struct Drawn {
    pub(crate) mixer: Mixer,
    pub(crate) motion: Motion,
    pub(crate) figure: Figure,
}

impl Drawn {
    pub(crate) fn new(dimensions: &Dimensions, overlays: Overlays) -> Self {
        let mixer = Mixer::new(dimensions);
        let mixer = mixer.unwrap_or_else(|invalid| panic!("{invalid:?}"));
        let motion = mixer.motion();
        let motion = motion.unwrap_or_else(|unmoved| panic!("{unmoved:?}"));
        let joints = ["B", "C"].into_iter();
        let view = View {
            overlays,
            traced: joints
                .filter_map(|joint| motion.mechanism().point(joint))
                .collect(),
            annotations: Annotations::from(&mixer),
            ..View::default()
        };
        let figure = Figure::new(&motion, &view);
        let figure = figure.unwrap_or_else(|unsolved| panic!("{unsolved}"));
        Self {
            mixer,
            motion,
            figure,
        }
    }

    pub(crate) fn pose(&self, crank: f64) -> Pose<3> {
        let pose = self.motion.pose(crank);
        pose.unwrap_or_else(|unsolved| panic!("{unsolved}"))
    }

    pub(crate) fn frame(&self, crank: f64) -> Vec<f32> {
        self.figure.frame(&self.pose(crank))
    }

    /// Returns the records after the poses of the bodies: everything that is not fixed to a body.
    pub(crate) fn moving(&self, crank: f64) -> Vec<Vec<f32>> {
        let frame = self.frame(crank);
        records(&frame[1 + 3 * frame[0] as usize..])
    }

    /// Returns the positions of A, B, C and D by the closed form.
    pub(crate) fn joints(&self, crank: f64) -> [Point; 4] {
        let pose = self.mixer.linkage.pose::<1>(self.mixer.assembly, crank);
        let pose = pose.unwrap_or_else(|unsolved| panic!("{unsolved}"));
        self.mixer.linkage.joints(&pose).map(|joint| joint.place())
    }

    pub(crate) fn text(&self, label: &[f32]) -> &str {
        &self.figure.names()[label[2] as usize]
    }

    /// Returns the label with this text; panics if there is none.
    pub(crate) fn label<'a>(&self, records: &'a [Vec<f32>], text: &str) -> &'a [f32] {
        let mut labels = records.iter().filter(|record| record[0] == 4.0);
        let label = labels.find(|label| self.text(label) == text);
        label.unwrap_or_else(|| panic!("no label {text}"))
    }
}

pub(crate) fn with_lengths(lengths: [f64; 4]) -> Dimensions {
    Dimensions {
        lengths,
        ..Case::A.dimensions()
    }
}

pub(crate) fn place(numbers: &[f32]) -> Point {
    Point::new(f64::from(numbers[0]), f64::from(numbers[1]))
}

/// Returns the origin of a body's coordinates, and the angle of the body.
pub(crate) fn body(frame: &[f32], body: usize) -> (Point, f64) {
    let [x, y, angle] = [1, 2, 3].map(|i| f64::from(frame[3 * body + i]));
    (Point::new(x, y), angle)
}

/// Converts a position from the coordinates of a body to those of the drawing.
pub(crate) fn on_body(frame: &[f32], index: usize, x: f64, y: f64) -> Point {
    let (at, angle) = body(frame, index);
    let (sin, cos) = angle.sin_cos();
    at + Vector::new(cos * x - sin * y, sin * x + cos * y)
}

/// Returns the distance of a position from the segment between two others.
pub(crate) fn distance(place: Point, from: Point, to: Point) -> f64 {
    let along = to - from;
    let share = (place - from).dot(&along) / along.norm_squared();
    (place - (from + along * share.clamp(0.0, 1.0))).norm()
}

/// Returns a mixer with six wheels and with traced points on every kind of body.
pub(crate) fn full() -> Dimensions {
    let mut dimensions = Case::A.dimensions();
    dimensions.wheels = (0..6)
        .map(|i| Mate {
            teeth: 18.0 - f64::from(i),
            centre_line: f64::from(i) * TAU / 6.0,
        })
        .collect();
    dimensions.tracers = [
        (Carrier::Crank, 0.2, 0.1),
        (Carrier::Coupler, 0.4, 0.25),
        (Carrier::Rocker, 0.3, -0.1),
        (Carrier::Wheel(0), 0.1, 0.0),
        (Carrier::Wheel(5), 0.0, 0.08),
    ]
    .map(|(carrier, x, y)| Tracer { carrier, x, y })
    .to_vec();
    dimensions
}
