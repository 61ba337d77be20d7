//! The output of a linkage over a turn: stroke, dwell, phases.

use assur::mechanism::{Mechanism, Quantity};
use assur::motion::{OutputProfile, PhaseKind};
use serde::Serialize;

/// The default width of a band: degrees, or about this part of the size.
const BAND: f64 = 0.1;
const FINE: f64 = 1e-3;

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ProfileSummary {
    /// Width of the band, degrees or in the unit of the lengths.
    width: f64,
    /// Stroke from minimum to maximum; none if the output turns on and on.
    stroke: Option<f64>,
    dwell: Option<DwellSummary>,
    phases: Vec<PhaseSummary>,
}

/// The longest arc over which the output stays within the band: its ends, and the minimum and
/// maximum value.
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

/// The width of a band in the unit of the page, by default the usual one, and in the unit of the
/// engine.
pub(crate) fn band(mechanism: &Mechanism, quantity: Quantity, width: Option<f64>) -> (f64, f64) {
    if quantity.is_angle() {
        let width = width.unwrap_or(BAND);
        (width, width.to_radians())
    } else {
        // A power of ten, as a reader would choose.
        let usual = 10_f64.powi((FINE * mechanism.size()).log10().floor() as i32);
        let width = width.unwrap_or(usual);
        (width, width)
    }
}

impl ProfileSummary {
    /// The summary of a quantity's profile, with dwells within a band whose width is in degrees, or
    /// in the unit of the lengths.
    pub(crate) fn new(
        mechanism: &Mechanism,
        quantity: Quantity,
        profile: &OutputProfile<'_>,
        width: Option<f64>,
    ) -> Self {
        let (width, band) = band(mechanism, quantity, width);
        let (dwell, phases) = profile.dwell_and_cyclogram(band);
        Self {
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
        }
    }
}
