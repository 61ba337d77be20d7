//! Comparison of two mechanisms in one plot: the curves of the second are thin and dashed.

use super::{Against, Chart};

/// Length of a dash, pixels.
const DASH: f64 = 6.0;
/// Length of the gap after a dash, pixels.
const GAP: f64 = 4.0;

impl Chart {
    /// Adds the other chart's curve of every quantity whose name is in both charts. The axes then span both charts.
    /// Nothing is added if the quantities or the inputs are of different kinds.
    pub fn compare(&mut self, other: &Self) {
        if self.turns != other.turns || self.kind != other.kind {
            return;
        }
        let same = |name: &str| other.series.iter().position(|series| series.name == name);
        let same: Vec<Option<usize>> = self.series.iter().map(|one| same(&one.name)).collect();
        if same.iter().all(Option::is_none) {
            return;
        }
        for (plot, theirs) in self.plots.iter_mut().zip(&other.plots) {
            plot.range = plot.range.with(theirs.range);
            for (curve, same) in plot.curves.iter_mut().zip(&same) {
                if let Some(same) = same {
                    curve.compare(&theirs.curves[*same]);
                }
            }
        }
        self.axis = [
            self.axis[0].min(other.axis[0]),
            self.axis[1].max(other.axis[1]),
        ];
    }
}

impl Against {
    /// Adds the curve of another plot, if it shows the same two quantities.
    pub fn compare(&mut self, other: &Self) {
        if self.axes != other.axes {
            return;
        }
        self.ranges = [0, 1].map(|k: usize| self.ranges[k].with(other.ranges[k]));
        self.compared.clone_from(&other.runs);
    }
}

/// Cuts a line into dashes of equal length on the screen, `scale` times as long as usual;
/// `to_pixels` is the number of pixels per unit along x and y.
pub(super) fn dashed(line: &[(f64, f64)], to_pixels: [f64; 2], scale: f64) -> Vec<Vec<(f64, f64)>> {
    let mut dashes: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut dash = Vec::new();
    let (mut drawn, mut left) = (true, DASH * scale);
    for pair in line.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let way = [to.0 - from.0, to.1 - from.1];
        let length = (way[0] * to_pixels[0]).hypot(way[1] * to_pixels[1]);
        let at = |along: f64| {
            let share = along / length;
            (from.0 + way[0] * share, from.1 + way[1] * share)
        };
        if drawn && dash.is_empty() {
            dash.push(from);
        }
        let mut along = 0.0;
        while length - along > left {
            along += left;
            if drawn {
                dash.push(at(along));
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash.push(at(along));
            }
            drawn = !drawn;
            left = scale * if drawn { DASH } else { GAP };
        }
        left -= length - along;
        if drawn {
            dash.push(to);
        }
    }
    dashes.push(dash);
    dashes.retain(|dash| dash.len() > 1);
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_are_of_one_length() {
        let line: Vec<(f64, f64)> = (0..=70).map(|x| (f64::from(x) / 10.0, 0.0)).collect();
        for samples in [&line[..], &[line[0], line[70]]] {
            let dashes = dashed(samples, [10.0, 1.0], 1.0);
            assert_eq!(dashes.len(), 7);
            for (k, dash) in (0_u8..).zip(&dashes) {
                let start = f64::from(k);
                assert!((dash[0].0 - start).abs() < 1e-9, "{k}: {dash:?}");
                let end = dash.last().map_or(0.0, |at| at.0);
                assert!((end - start - 0.6).abs() < 1e-9, "{k}: {dash:?}");
            }
        }
        assert!(dashed(&[(0.0, 0.0)], [1.0; 2], 1.0).is_empty());
        assert!(dashed(&[(0.0, 0.0), (0.0, 0.0)], [1.0; 2], 1.0).len() <= 1);
    }
}
