//! The curves of a chart: samples of the motion with exact derivatives, and the
//! ranges that show them.

use std::f64::consts::PI;

use assur::catalog::mixer::Mixer;
use assur::motion::Extremum;
use assur::{Pose, Swing};

/// Samples of an arc of the crank.
const SAMPLES: usize = 720;
/// Where the crank cannot turn fully, derivatives grow without bound towards the
/// dead points: ranges are taken where the transmission angle exceeds this.
const CLEAR: f64 = 15.0 * PI / 180.0;

/// What an axis spans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    pub(crate) min: f64,
    pub(crate) max: f64,
}

/// A curve over the crank angle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Curve {
    /// Unbroken runs of points.
    runs: Vec<Vec<(f64, f64)>>,
    /// Its extrema, marked by dots.
    pub(crate) extrema: Vec<(f64, f64)>,
}

/// For φ, φ′, φ″: the range, and the curves of the rocker and of wheel 5.
/// `extrema` are those of the rocker's φ′ and φ″.
pub(crate) fn plots(mixer: &Mixer, extrema: &[Vec<Extremum>; 2]) -> [(Range, [Curve; 2]); 3] {
    let runs = sample(mixer);
    let [first, second] = extrema.each_ref().map(|found| {
        let place = |extremum: &Extremum| (extremum.crank, extremum.value);
        found.iter().map(place).collect()
    });
    let marks = [swing_marks(mixer), first, second];
    let full = mixer.linkage.cycle().is_full();
    let ratio = mixer.gears.ratio();
    let mut order = 0;
    marks.map(|marks| {
        let curve = |factor: f64| Curve {
            runs: runs
                .iter()
                .map(|run| {
                    run.iter()
                        .map(|s| (s.crank, factor * s.rocker[order]))
                        .collect()
                })
                .collect(),
            extrema: marks.iter().map(|(x, y)| (*x, factor * y)).collect(),
        };
        let shown = runs.iter().flatten();
        let shown = shown.filter(|s| order == 0 || full || s.transmission > CLEAR);
        let values = shown.map(|s| s.rocker[order]).flat_map(|y| [y, ratio * y]);
        let plot = (range(values), [curve(1.0), curve(ratio)]);
        order += 1;
        plot
    })
}

struct Sample {
    crank: f64,
    rocker: [f64; 3],
    transmission: f64,
}

/// The motion, an unbroken run for every stretch without a gap.
fn sample(mixer: &Mixer) -> Vec<Vec<Sample>> {
    let linkage = &mixer.linkage;
    let at = |crank: f64| -> Option<Sample> {
        let pose: Pose<3> = linkage.pose(mixer.assembly, crank).ok()?;
        Some(Sample {
            crank,
            rocker: [0, 1, 2].map(|order| pose.rocker.derivative(order)),
            transmission: linkage.transmission_angle(crank).ok()?,
        })
    };
    let cycle = linkage.cycle();
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
        let cranks = (0..=count).map(|i| from + (to - from) * place(i as f64 / count as f64));
        let samples: Vec<Option<Sample>> = cranks.map(at).collect();
        let mut run = Vec::new();
        for sample in samples.into_iter().chain([None]) {
            match sample {
                Some(sample) => run.push(sample),
                None if run.is_empty() => {}
                None => runs.push(std::mem::take(&mut run)),
            }
        }
    }
    runs
}

/// The limit positions with the rocker's extreme angles.
fn swing_marks(mixer: &Mixer) -> Vec<(f64, f64)> {
    let swings = mixer.linkage.swings(mixer.assembly);
    let extreme = |angle: f64| {
        swings.iter().any(|swing| match swing {
            Swing::Between { min, max } => [*min, *max].contains(&angle),
            Swing::Turns => false,
        })
    };
    let limits = mixer.linkage.limits(mixer.assembly).into_iter();
    let extreme = limits.filter(|limit| extreme(limit.rocker));
    extreme.map(|limit| (limit.crank, limit.rocker)).collect()
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
                let mut crossings: Vec<(f64, f64)> = [min, max]
                    .into_iter()
                    .filter(|bound| (a.1 - bound) * (b.1 - bound) < 0.0)
                    .map(|bound| (a.0 + (b.0 - a.0) * (bound - a.1) / (b.1 - a.1), bound))
                    .collect();
                crossings.sort_by(|p, q| p.0.total_cmp(&q.0));
                part.extend(crossings);
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
    use super::*;

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
            extrema: Vec::new(),
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
