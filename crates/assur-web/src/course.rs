//! What the output of a linkage does over a turn: its stroke, its dwell, its phases.

use assur::mechanism::Quantity;
use assur::motion::{Course, Motion, PhaseKind};
use serde::Serialize;

/// The width of a band where none is given: degrees, or parts of the size.
const BAND: f64 = 0.1;
const FINE: f64 = 1e-3;

#[derive(Serialize)]
pub(crate) struct CourseSummary {
    /// Degrees, or in the unit of the lengths.
    width: f64,
    /// From the least value to the greatest; none of what turns on and on.
    stroke: Option<f64>,
    dwell: Option<DwellSummary>,
    phases: Vec<PhaseSummary>,
}

/// The longest arc on which the output stays within the band: from where to where,
/// and the least and the greatest value there.
#[derive(Serialize)]
struct DwellSummary {
    arc: [f64; 2],
    band: [f64; 2],
}

#[derive(Serialize)]
struct PhaseSummary {
    kind: &'static str,
    arc: [f64; 2],
}

impl CourseSummary {
    /// Of a quantity, with dwells within a band of a width in degrees, or in the
    /// unit of the lengths.
    pub(crate) fn new(motion: &Motion, quantity: Quantity, width: Option<f64>) -> Self {
        let usual = if quantity.is_angle() {
            BAND
        } else {
            FINE * motion.mechanism().size()
        };
        let width = width.unwrap_or(usual);
        let band = if quantity.is_angle() {
            width.to_radians()
        } else {
            width
        };
        let course = Course::new(motion, quantity);
        let strokes = course.strokes();
        let values = strokes.iter().flatten().map(|[_, value]| *value);
        let [least, most] = values.fold(
            [f64::INFINITY, f64::NEG_INFINITY],
            |[least, most], value| [least.min(value), most.max(value)],
        );
        let phases = course.cyclogram(band).into_iter();
        Self {
            width,
            stroke: (least <= most).then_some(most - least),
            dwell: course.dwell(band).map(|dwell| DwellSummary {
                arc: dwell.arc,
                band: dwell.band,
            }),
            phases: phases
                .map(|phase| PhaseSummary {
                    kind: match phase.kind {
                        PhaseKind::Rise => "rise",
                        PhaseKind::Dwell => "dwell",
                        PhaseKind::Return => "return",
                    },
                    arc: phase.arc,
                })
                .collect(),
        }
    }
}
