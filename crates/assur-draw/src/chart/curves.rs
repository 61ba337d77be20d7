//! The curves of a chart: samples of the motion with exact derivatives, and the
//! ranges that show them.

use std::f64::consts::PI;

use assur::motion::{Features, Input, Kind};
use assur::{Cycle, Jet};

use super::{Series, Settings};

/// Samples of an arc of the crank.
const SAMPLES: usize = 720;
/// Every so many samples a difference is shown next to the exact derivative.
const DIFFERENCED: usize = 10;

/// The quantities of a chart at one crank angle.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Each with its first two derivatives.
    pub jets: Vec<Jet<3>>,
    /// Whether the derivatives are far from growing without bound.
    pub clear: bool,
}

/// What is to be labelled on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// What it is.
    pub kind: MarkKind,
    /// At which crank angle.
    pub crank: f64,
    /// The value there.
    pub value: f64,
}

/// What a mark stands at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// A local maximum.
    Max,
    /// A local minimum.
    Min,
    /// A zero.
    Zero,
}

/// What an axis spans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    pub(crate) min: f64,
    pub(crate) max: f64,
}

/// The curves of one order, in the order of the series.
#[derive(Clone, Debug)]
pub(crate) struct Plot {
    pub(crate) range: Range,
    pub(crate) curves: Vec<Curve>,
}

/// A curve over the crank angle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Curve {
    /// Unbroken runs of points.
    runs: Vec<Vec<(f64, f64)>>,
    /// Its zeros and extrema, marked by dots.
    marks: Vec<Mark>,
    /// Differences of samples of the derivative before it.
    pub(crate) differences: Vec<(f64, f64)>,
}

/// A sample in its place.
type At = (f64, Sample);

/// The plots of the series and of their derivatives.
pub(crate) fn plots(
    cycle: &Cycle,
    series: &[Series],
    sample: &dyn Fn(f64) -> Option<Sample>,
    Settings {
        input, differenced, ..
    }: Settings,
) -> [Plot; 3] {
    let runs = sampled(cycle, sample);
    [0, 1, 2].map(|order| {
        let rate = |at: &At, index: usize| input.rate(&at.1.jets[index], order);
        let curve = |(index, series): (usize, &Series)| {
            let point = |at: &At| (at.0, rate(at, index));
            let differences = runs
                .iter()
                .filter(|_| differenced && order == 2)
                .flat_map(|run| differences(run, index, input));
            Curve {
                runs: runs
                    .iter()
                    .map(|run| run.iter().map(point).collect())
                    .collect(),
                marks: marks(&series.features[order]),
                differences: differences.collect(),
            }
        };
        let shown = runs.iter().flatten();
        let shown = shown.filter(|at| order == 0 || cycle.is_full() || at.1.clear);
        let values = shown.flat_map(|at| (0..series.len()).map(move |index| rate(at, index)));
        Plot {
            range: range(values),
            curves: series.iter().enumerate().map(curve).collect(),
        }
    })
}

/// The second derivative by time from centred differences of the samples of the
/// first one by the crank angle: a proof for the eye, nothing is computed from it.
fn differences(run: &[At], index: usize, input: Input) -> impl Iterator<Item = (f64, f64)> {
    run.windows(3).step_by(DIFFERENCED).map(move |three| {
        let [before, here, after] = [0, 1, 2].map(|i| three[i].1.jets[index].derivative(1));
        let second = (after - before) / (three[2].0 - three[0].0);
        let steady = input.speed * input.speed * second;
        (three[1].0, steady + input.acceleration * here)
    })
}

/// The motion, an unbroken run for every stretch without a gap.
fn sampled(cycle: &Cycle, sample: &dyn Fn(f64) -> Option<Sample>) -> Vec<Vec<At>> {
    let turns = if cycle.is_full() {
        cycle.arcs().len()
    } else {
        1
    };
    let count = SAMPLES * turns;
    let place = |t: f64| {
        // Crowded towards dead points, where curves turn upright.
        if cycle.is_full() {
            t
        } else {
            0.5 - 0.5 * (PI * t).cos()
        }
    };
    let mut runs = Vec::new();
    for [from, to] in cycle.arcs() {
        let mut run = Vec::new();
        for i in 0..=count {
            let crank = from + (to - from) * place(i as f64 / count as f64);
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
        crank: extremum.crank,
        value: extremum.value,
    });
    extrema.chain(zeros).collect()
}

/// The range of the values with a margin; of a constant, room around it.
fn range(values: impl Iterator<Item = f64>) -> Range {
    let [min, max] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], value| {
        [min.min(value), max.max(value)]
    });
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

impl Curve {
    /// The marks between `min` and `max`.
    pub(crate) fn marks(&self, min: f64, max: f64) -> Vec<Mark> {
        let inside = |mark: &&Mark| (min..=max).contains(&mark.value);
        self.marks.iter().filter(inside).copied().collect()
    }

    /// The runs cut to the values between `min` and `max`.
    pub(crate) fn within(&self, min: f64, max: f64) -> Vec<Vec<(f64, f64)>> {
        let inside = |y: f64| (min..=max).contains(&y);
        let mut cut = Vec::new();
        for run in &self.runs {
            let mut part = Vec::new();
            for pair in run.windows(2) {
                let [a, b] = [pair[0], pair[1]];
                if part.is_empty() && inside(a.1) {
                    part.push(a);
                }
                // Where the curve crosses a bound, it is cut there.
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
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use assur::FourBar;

    use super::*;
    use crate::list::Role;

    /// The plots of q = sin φ₁ over a full turn.
    fn sine(input: Input, differenced: bool) -> [Plot; 3] {
        let cycle = FourBar::new([0.37, 0.85, 0.55, 0.85]).unwrap().cycle();
        let series = Series {
            name: "sine".to_owned(),
            role: Role::Ink,
            features: Default::default(),
        };
        let sample = |crank| {
            let jets = vec![Jet::linear(crank, 1.0).sin_cos().0];
            Some(Sample { jets, clear: true })
        };
        let settings = Settings {
            input,
            physical: true,
            differenced,
        };
        plots(&cycle, &[series], &sample, settings)
    }

    /// Centred differences of cos φ₁ over ±h are −sin φ₁ (sin h)/h: near the exact
    /// derivative, and not it.
    #[test]
    fn differences_are_of_the_samples() {
        let input = Input {
            speed: -3.0,
            acceleration: 2.0,
        };
        for input in [Input::ANALOGUES, input] {
            let [value, first, second] = sine(input, true);
            assert!(value.curves[0].differences.is_empty());
            assert!(first.curves[0].differences.is_empty());
            let differences = &second.curves[0].differences;
            assert_eq!(differences.len(), SAMPLES / DIFFERENCED);
            let h = TAU / SAMPLES as f64;
            let square = input.speed * input.speed;
            for (crank, shown) in differences {
                let steady = -square * crank.sin() * h.sin() / h;
                let expected = steady + input.acceleration * crank.cos();
                assert!((shown - expected).abs() < 1e-11 * square, "{crank}");
            }
            let exact = second.curves[0].runs[0].clone();
            let off = differences.iter().map(|(crank, shown)| {
                let at = exact.iter().find(|(at, _)| at == crank).unwrap();
                (shown - at.1).abs() / square
            });
            let most = off.fold(0.0, f64::max);
            assert!((1e-6..1e-4).contains(&most), "{most:e}");
        }
        assert!(
            sine(Input::ANALOGUES, false)[2].curves[0]
                .differences
                .is_empty()
        );
    }

    /// Every curve has what it is by time: q, ω₁ q′, ω₁² q″ + ε₁ q′.
    #[test]
    fn curves_are_rates() {
        let input = Input {
            speed: -3.0,
            acceleration: 2.0,
        };
        let plots = sine(input, false);
        for (order, plot) in plots.iter().enumerate() {
            for (crank, value) in &plot.curves[0].runs[0] {
                let (sin, cos) = crank.sin_cos();
                let expected = [sin, -3.0 * cos, -9.0 * sin + 2.0 * cos][order];
                assert!((value - expected).abs() < 1e-14 * 9.0, "{order} {crank}");
            }
        }
    }

    #[test]
    fn curves_are_cut_at_the_bounds() {
        let curve = Curve {
            runs: vec![vec![
                (0.0, 0.0),
                (1.0, 4.0),
                (2.0, 0.0),
                (3.0, -4.0),
                (4.0, 4.0),
            ]],
            ..Curve::default()
        };
        let parts = curve.within(-1.0, 1.0);
        let expected = [
            vec![(0.0, 0.0), (0.25, 1.0)],
            vec![(1.75, 1.0), (2.0, 0.0), (2.25, -1.0)],
            vec![(3.375, -1.0), (3.625, 1.0)],
        ];
        assert_eq!(parts, expected);
    }

    #[test]
    fn a_constant_has_room() {
        let range = range([1.0, 1.0].into_iter());
        assert!(range.min < 0.9 && range.max > 1.1);
    }
}
