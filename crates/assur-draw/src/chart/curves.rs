//! The curves of a chart: samples of the motion with exact derivatives, and the ranges of the axes.

use assur::Jet;
use assur::motion::{Features, InputRate, Kind, Sampling, Shown, Spacing};
use assur::sorting::{extremes, sort_by};

use super::{Series, Settings};

/// Number of samples of a turn of the crank, of an arc shorter than a turn, or of a slide's range.
const TURN: usize = 720;
/// Minimum number of samples per turn. A plot of many turns cannot show more detail.
const COARSEST_TURN: usize = 60;
/// Maximum number of sampled values, of all quantities together.
const MAX_VALUES: usize = 1 << 18;
/// Approximate number of difference quotients shown in an unbroken run of samples, if there are few runs.
const DIFFERENCES: usize = 72;
/// Number of runs beyond which the total number of difference quotients no longer grows.
const FEW_RUNS: usize = 4;

/// Difference, as a share of the range, below which two values look the same: their dots overlap.
const TOLD_APART: f64 = 0.02;

/// The quantities of a chart at one input.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Values of the quantities, each with its first two derivatives.
    pub jets: Vec<Jet<3>>,
    /// Whether the pose is far from any dead point, where derivatives grow without bound.
    pub clear: bool,
}

/// A mark to be labelled on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Kind of the mark.
    pub kind: MarkKind,
    /// Input at the mark.
    pub crank: f64,
    /// Value of the curve at the mark.
    pub value: f64,
}

/// Kind of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// A local maximum.
    Max,
    /// A local minimum.
    Min,
    /// A zero.
    Zero,
}

/// Span of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    pub(crate) min: f64,
    pub(crate) max: f64,
}

/// Curves of the derivatives of one order, in the order of the series.
#[derive(Clone, Debug)]
pub(crate) struct Plot {
    pub(crate) range: Range,
    pub(crate) curves: Vec<Curve>,
}

/// A curve over the input.
#[derive(Clone, Debug, Default)]
pub(crate) struct Curve {
    /// Unbroken runs of points (input, value).
    runs: Vec<Vec<(f64, f64)>>,
    /// Unbroken runs of points of the curve shown for comparison.
    pub(super) compared: Vec<Vec<(f64, f64)>>,
    /// Zeros and extrema, marked by dots.
    marks: Vec<Mark>,
    /// Points (input, second derivative estimated from difference quotients of the first).
    pub(crate) differences: Vec<(f64, f64)>,
}

/// A sample with its input.
pub type At = (f64, Sample);

/// Makes the plots of series and their derivatives from unbroken runs. `full` states that no derivative is unbounded.
pub(crate) fn plots(
    runs: &[Vec<At>],
    full: bool,
    series: &[Series],
    Settings {
        input, differenced, ..
    }: Settings,
) -> [Plot; 3] {
    [0, 1, 2].map(|order| {
        let rate = |at: &At, index: usize| input.rate(&at.1.jets[index], order);
        let curve = |(index, series): (usize, &Series)| {
            let point = |at: &At| (at.0, rate(at, index));
            let all = DIFFERENCES * FEW_RUNS;
            let each = (all / runs.len().max(1)).clamp(1, DIFFERENCES);
            let differences = runs
                .iter()
                .step_by((runs.len() / all).max(1))
                .filter(|_| differenced && order == 2)
                .flat_map(|run| differences(run, each, index, input));
            Curve {
                runs: runs
                    .iter()
                    .map(|run| run[told(run, order, full)].iter().map(point).collect())
                    .collect(),
                compared: Vec::new(),
                marks: match &series.features {
                    Some(features) => marks(&features[order]),
                    None => Vec::new(),
                },
                differences: differences.collect(),
            }
        };
        let shown = runs.iter().flatten();
        let shown = shown.filter(|at| order == 0 || full || at.1.clear);
        let values = shown.flat_map(|at| (0..series.len()).map(move |index| rate(at, index)));
        Plot {
            range: range(values),
            curves: series.iter().enumerate().map(curve).collect(),
        }
    })
}

/// Returns the index range of the samples of a run that are plotted for a derivative of this order. If derivatives may
/// be unbounded, their values at the first and last sample are mere rounding error, so these two samples are left out.
pub(super) fn told(run: &[At], order: usize, full: bool) -> std::ops::Range<usize> {
    let ends = usize::from(order > 0 && !full && run.len() > 2);
    ends..run.len() - ends
}

/// Estimates the second derivative with respect to time from central differences of the first derivative with respect
/// to the input. The estimate is shown for comparison only; nothing is computed from it.
fn differences(
    run: &[At],
    count: usize,
    index: usize,
    input: InputRate,
) -> impl Iterator<Item = (f64, f64)> {
    let step = (run.len() / count).max(1);
    run.windows(3).step_by(step).map(move |three| {
        let [before, here, after] = [0, 1, 2].map(|i| three[i].1.jets[index].derivative(1));
        let second = (after - before) / (three[2].0 - three[0].0);
        let steady = input.speed * input.speed * second;
        (three[1].0, steady + input.acceleration * here)
    })
}

/// Returns the density of samples for this number of quantities.
pub(crate) fn sampling(quantities: usize) -> Sampling {
    Sampling {
        turn: TURN,
        coarsest: COARSEST_TURN,
        most: MAX_VALUES / quantities.max(1),
        spacing: Spacing::Crowded,
        shown: Shown::Spread,
    }
}

/// Returns the samples at the inputs of each piece, in runs. An input without a sample ends a run.
pub(crate) fn sampled(
    pieces: Vec<Vec<f64>>,
    sample: &dyn Fn(f64) -> Option<Sample>,
) -> Vec<Vec<At>> {
    let mut runs = Vec::new();
    for piece in pieces {
        let mut run = Vec::new();
        for crank in piece {
            if let Some(sample) = sample(crank) {
                run.push((crank, sample));
            } else if !run.is_empty() {
                runs.push(std::mem::take(&mut run));
            }
        }
        runs.push(run);
    }
    runs.retain(|run| !run.is_empty());
    runs
}

fn marks(features: &Features) -> Vec<Mark> {
    let zeros = features.zeros.iter().map(|crank| Mark {
        kind: MarkKind::Zero,
        crank: *crank,
        value: 0.0,
    });
    let extrema = features.extrema.iter().map(|extremum| Mark {
        kind: match extremum.kind {
            Kind::Max => MarkKind::Max,
            Kind::Min => MarkKind::Min,
        },
        crank: extremum.input,
        value: extremum.value,
    });
    extrema.chain(zeros).collect()
}

/// Returns the range of the values with a margin, also around a constant value.
pub(super) fn range(values: impl Iterator<Item = f64>) -> Range {
    let [min, max] = extremes(values);
    if min > max {
        return Range {
            min: -1.0,
            max: 1.0,
        };
    }
    let size = min.abs().max(max.abs());
    let room = if max - min > 1e-9 * size.max(1.0) {
        0.1 * (max - min)
    } else {
        0.5 * size.max(1.0)
    };
    Range {
        min: min - room,
        max: max + room,
    }
}

impl Range {
    /// Returns the least range that includes both ranges.
    pub(super) fn with(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }
}

impl Curve {
    /// Returns the marks with values between `min` and `max` that can be distinguished, in ascending order of the
    /// input. Of successive marks at nearly equal values (a dwell), only both ends and the curve's extremes are kept.
    pub(crate) fn marks(&self, min: f64, max: f64) -> Vec<Mark> {
        let inside = |mark: &&Mark| (min..=max).contains(&mark.value);
        let mut marks: Vec<Mark> = self.marks.iter().filter(inside).copied().collect();
        sort_by(&mut marks, |a, b| a.crank.total_cmp(&b.crank));
        let level = TOLD_APART * (max - min);
        let by_value = |a: &&Mark, b: &&Mark| a.value.total_cmp(&b.value);
        let peaks = [marks.iter().max_by(by_value), marks.iter().min_by(by_value)];
        let peaks = peaks.map(Option::<&Mark>::copied);
        let mut kept = Vec::new();
        let mut rest = &marks[..];
        while let Some(first) = rest.first() {
            let alike = |mark: &&Mark| (mark.value - first.value).abs() < level;
            let (dwell, beyond) = rest.split_at(rest.iter().take_while(alike).count().max(1));
            let last = dwell.len() - 1;
            let ends = dwell.iter().enumerate();
            let ends =
                ends.filter(|(k, mark)| [0, last].contains(k) || peaks.contains(&Some(**mark)));
            kept.extend(ends.map(|(_, mark)| *mark));
            rest = beyond;
        }
        kept
    }

    /// Returns the runs, clipped to values between `min` and `max`.
    pub(crate) fn within(&self, min: f64, max: f64) -> Vec<Vec<(f64, f64)>> {
        cut(&self.runs, min, max)
    }

    /// Returns the runs of the curve shown for comparison, clipped to values between `min` and `max`.
    pub(crate) fn compared_within(&self, min: f64, max: f64) -> Vec<Vec<(f64, f64)>> {
        cut(&self.compared, min, max)
    }

    pub(super) fn compare(&mut self, other: &Self) {
        self.compared.clone_from(&other.runs);
    }
}

/// Clips runs to values between `min` and `max`.
fn cut(runs: &[Vec<(f64, f64)>], min: f64, max: f64) -> Vec<Vec<(f64, f64)>> {
    let inside = |y: f64| (min..=max).contains(&y);
    let mut cut = Vec::new();
    for run in runs {
        let mut part = Vec::new();
        for pair in run.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            if part.is_empty() && inside(a.1) {
                part.push(a);
            }
            // The curve is cut where it crosses `min` or `max`.
            let bounds = if a.1 < b.1 { [min, max] } else { [max, min] };
            let crossed = bounds.into_iter();
            let crossed = crossed.filter(|bound| (a.1 - bound) * (b.1 - bound) < 0.0);
            part.extend(crossed.map(|bound| {
                let share = (bound - a.1) / (b.1 - a.1);
                (a.0 + (b.0 - a.0) * share, bound)
            }));
            if inside(b.1) {
                part.push(b);
            } else if !part.is_empty() {
                cut.push(std::mem::take(&mut part));
            }
        }
        cut.push(part);
    }
    cut.retain(|part| part.len() > 1);
    cut
}

#[cfg(test)]
mod tests;
