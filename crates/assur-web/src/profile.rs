//! The output of a linkage over its motion: stroke, dwell, phases.

use assur::mechanism::{Mechanism, Quantity};
use assur::motion::{OutputProfile, PhaseKind};
use serde::Serialize;

use crate::moving::Moving;

/// Default width of the dwell band of an angle, degrees.
const BAND: f64 = 0.1;
/// Default width of the dwell band of a length, as a fraction of the linkage's size; it is rounded down to a power of
/// ten.
const FINE: f64 = 1e-3;

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ProfileSummary {
    /// Width of the dwell band: degrees for an angle, otherwise in the unit of the lengths.
    width: f64,
    /// Stroke from minimum to maximum; none if the output keeps rotating.
    stroke: Option<f64>,
    dwell: Option<DwellSummary>,
    phases: Vec<PhaseSummary>,
}

/// The longest dwell: the ends of its arc of the input, and the output's minimum and maximum over the arc.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DwellSummary {
    arc: [f64; 2],
    band: [f64; 2],
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PhaseSummary {
    #[cfg_attr(test, ts(type = "\"rise\" | \"dwell\" | \"return\""))]
    kind: &'static str,
    arc: [f64; 2],
}

/// The width of a dwell band, first in the page's unit (degrees for an angle), then in the engine's (radians). `width`
/// is in the page's unit; if it is none, the default width is returned.
pub(crate) fn band(mechanism: &Mechanism, quantity: Quantity, width: Option<f64>) -> (f64, f64) {
    if quantity.is_angle() {
        let width = width.unwrap_or(BAND);
        (width, width.to_radians())
    } else {
        let usual = 10_f64.powi((FINE * mechanism.size()).log10().floor() as i32);
        let width = width.unwrap_or(usual);
        (width, width)
    }
}

impl ProfileSummary {
    /// Stroke, longest dwell and phases of the first plotted quantity; none if it is not an output, or if the motion has
    /// too many turns to be searched.
    pub(crate) fn of(moving: &Moving) -> Option<Self> {
        let output = moving.plotted_output()?;
        let profile = OutputProfile::new(moving.motion(), output).ok()?;
        let (width, band) = band(moving.mechanism(), output, moving.document().band);
        let (dwell, phases) = profile.dwell_and_cyclogram(band);
        Some(Self {
            width,
            stroke: profile.stroke(),
            dwell: dwell.map(|dwell| DwellSummary {
                arc: dwell.arc,
                band: dwell.band,
            }),
            phases: (phases.into_iter())
                .map(|phase| PhaseSummary {
                    kind: match phase.kind {
                        PhaseKind::Rise => "rise",
                        PhaseKind::Dwell => "dwell",
                        PhaseKind::Return => "return",
                    },
                    arc: phase.arc,
                })
                .collect(),
        })
    }
}
