//! Cyclogram of a quantity: the sequence of rises, dwells and returns over a cycle.

use super::profile::is_width;
use super::{Dwell, OutputProfile};
use crate::sorting::sort_by;

/// Kind of a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseKind {
    /// The quantity grows.
    Rise,
    /// The quantity stays within the tolerance.
    Dwell,
    /// The quantity falls.
    Return,
}

/// A phase: one bar of the cyclogram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// Rise, dwell or return.
    pub kind: PhaseKind,
    /// Inputs at the ends of the phase.
    pub arc: [f64; 2],
    /// Values at the ends of the phase.
    pub values: [f64; 2],
}

impl OutputProfile<'_> {
    /// Phases of a cycle: dwells around the extrema and the ends of an arc, each within a band of full width
    /// `tolerance`, and the strokes between the dwells. Of overlapping dwells only the longest is kept. Empty if the
    /// tolerance is not positive and finite.
    pub fn cyclogram(&self, tolerance: f64) -> Vec<Phase> {
        self.phases(self.touching(tolerance), tolerance)
    }

    /// Phases of a cycle, as in [`Self::cyclogram`], from given dwells that may overlap.
    pub(super) fn phases(&self, mut arcs: Vec<Dwell>, tolerance: f64) -> Vec<Phase> {
        let (Some(first), true) = (self.stations.first(), is_width(tolerance)) else {
            return Vec::new();
        };
        let period = self.period;
        if self.monotone {
            arcs.clear();
        }
        sort_by(&mut arcs, |a, b| b.length().total_cmp(&a.length()));
        let mut dwells: Vec<Dwell> = Vec::new();
        let overlap = |a: &Dwell, b: &Dwell| {
            let shifts = period.map_or([0.0; 3], |period| [-period, 0.0, period]);
            shifts
                .iter()
                .any(|shift| a.arc[0] < b.arc[1] + shift && b.arc[0] + shift < a.arc[1])
        };
        for arc in arcs {
            let whole = period.is_some_and(|period| arc.length() >= period);
            if !whole && arc.length() > 0.0 && !dwells.iter().any(|other| overlap(&arc, other)) {
                dwells.push(arc);
            }
        }
        sort_by(&mut dwells, |a, b| a.arc[0].total_cmp(&b.arc[0]));
        let start = dwells.first().map_or(first[0], |dwell| dwell.arc[0]);
        let [from, to] = match period {
            Some(period) => [start, start + period],
            None => [first[0], self.stations[self.stations.len() - 1][0]],
        };
        let mut phases = Vec::new();
        let mut at = from;
        for dwell in &dwells {
            self.strokes_between([at, dwell.arc[0]], &mut phases);
            phases.extend(self.phase(Some(PhaseKind::Dwell), dwell.arc));
            at = dwell.arc[1];
        }
        self.strokes_between([at, to], &mut phases);
        phases
    }

    /// Adds the rises and returns between two dwells, divided at extrema.
    fn strokes_between(&self, [from, to]: [f64; 2], phases: &mut Vec<Phase>) {
        let inner = self.within([from, to]).map(|[input, _]| input);
        let inner = inner.filter(|input| *input > from && *input < to);
        let cuts: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
        for pair in cuts.windows(2) {
            if let [a, b] = pair
                && a < b
            {
                phases.extend(self.phase(None, [*a, *b]));
            }
        }
    }

    /// A phase on an arc; a rise or a return if no kind is given.
    fn phase(&self, kind: Option<PhaseKind>, arc: [f64; 2]) -> Option<Phase> {
        let values = [self.value(arc[0])?, self.value(arc[1])?];
        let stroke = if values[1] > values[0] {
            PhaseKind::Rise
        } else {
            PhaseKind::Return
        };
        Some(Phase {
            kind: kind.unwrap_or(stroke),
            arc,
            values,
        })
    }
}
