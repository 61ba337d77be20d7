//! Scale of a chart's panel in pixels, and the range of the input axis.

use super::*;

impl Panel {
    /// Returns the number of pixels per unit along x and y.
    pub(super) fn to_pixels(&self) -> [f64; 2] {
        let span = |[from, to]: [f64; 2]| to - from;
        [self.width / span(self.x), self.height / span(self.y)]
    }

    /// Minimum distance between points along a curve, pixels.
    const APART: f64 = 4.0;

    /// Returns x and y, in pixels, of points along the curves of a plot. Labels keep clear of these points.
    pub(super) fn along(&self, plot: &Plot) -> Vec<f64> {
        let ([x0, x1], [y0, y1]) = (self.x, self.y);
        let mut points = Vec::new();
        for run in plot.curves.iter().flat_map(|curve| curve.within(y0, y1)) {
            let mut last = [f64::INFINITY; 2];
            for (x, y) in run {
                let at = [
                    self.left + self.width * (x - x0) / (x1 - x0),
                    self.top + self.height * (y1 - y) / (y1 - y0),
                ];
                if (at[0] - last[0]).hypot(at[1] - last[1]) >= Self::APART {
                    points.extend(at);
                    last = at;
                }
            }
        }
        points
    }
}

/// Returns the range of the input axis. For an oscillating crank this is the range of the crank with a margin on both
/// sides, if its share of the cycle's full axis is between [`LEAST_OF_A_TURN`] and [`MOST_OF_A_TURN`]. Otherwise it is
/// the full axis.
pub(super) fn axis(cycle: &Cycle) -> [f64; 2] {
    let whole = cycle.axis();
    let (Some(_), false, [[from, _], .., [_, to]] | [[from, to]]) =
        (cycle.period(), cycle.is_full(), cycle.arcs())
    else {
        return whole;
    };
    let beside = BESIDE * (to - from);
    let fitted = [from - beside, to + beside];
    let span = |[from, to]: [f64; 2]| to - from;
    let share = span(fitted) / span(whole);
    if (LEAST_OF_A_TURN..MOST_OF_A_TURN).contains(&share) {
        fitted
    } else {
        whole
    }
}
