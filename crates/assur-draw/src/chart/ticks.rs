//! Ticks of the axes: round numbers, spaced to fit their labels.

use super::curves::Range;

/// A tick of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// Value at the tick, in degrees for an angle.
    pub value: f64,
    /// Position along the axis, pixels from the left or upper edge of the plot.
    pub at: f64,
}

/// Steps between labels of angles, degrees.
const ANGLES: [f64; 12] = [
    1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0, 360.0,
];

/// Least spacing of crank-angle ticks on a long axis, degrees.
const FINEST: f64 = 30.0;
/// Span of crank angles below which an axis counts as short, degrees.
const SHORT: f64 = 120.0;
/// Least spacing of crank-angle ticks on a short axis, degrees.
const FINEST_OF_SHORT: f64 = 5.0;
/// Span of crank angles below which the spacing of ticks has no least value, degrees.
const VERY_SHORT: f64 = 20.0;

/// Returns ticks in degrees for a range of crank angles in radians. They are at least 50 × `scale` pixels apart.
pub(super) fn crank([start, end]: [f64; 2], width: f64, scale: f64) -> Vec<Tick> {
    let (from, to) = (start.to_degrees(), end.to_degrees());
    let span = to - from;
    let finest = if span < VERY_SHORT {
        0.0
    } else if span < SHORT {
        FINEST_OF_SHORT
    } else {
        FINEST
    };
    let step = angle_step(span * 50.0 * scale / width, finest);
    multiples(step, from, to)
        .map(|value| Tick {
            value,
            at: (value - from) / span * width,
        })
        .collect()
}

/// Returns ticks of an input that is a length or a time. They are at least 50 × `scale` pixels apart.
pub(super) fn way([from, to]: [f64; 2], width: f64, scale: f64) -> Vec<Tick> {
    multiples(round_step((to - from) * 50.0 * scale / width), from, to)
        .map(|value| Tick {
            value,
            at: (value - from) / (to - from) * width,
        })
        .collect()
}

/// Returns ticks along the abscissa, in degrees for an angle. They are at least 50 × `scale` pixels apart.
pub(super) fn abscissae(range: Range, angle: bool, width: f64, scale: f64) -> Vec<Tick> {
    let (step, [from, to]) = stepped(range, angle, 50.0 * scale / width);
    let at = |value: f64| (value - from) / (to - from) * width;
    let ticks = multiples(step, from, to);
    ticks
        .map(|value| Tick {
            value,
            at: at(value),
        })
        .collect()
}

/// Returns ticks along the ordinate, in degrees for an angle. They are at least 28 pixels apart, or 18 × `scale` if
/// that is more, to fit larger text.
pub(super) fn values(range: Range, angle: bool, height: f64, scale: f64) -> Vec<Tick> {
    let (step, [from, to]) = stepped(range, angle, (18.0 * scale).max(28.0) / height);
    multiples(step, from, to)
        .map(|value| Tick {
            value,
            at: (to - value) / (to - from) * height,
        })
        .collect()
}

/// Returns the step between ticks (at least the share `apart` of the axis) and the axis range, in degrees for an angle.
fn stepped(range: Range, angle: bool, apart: f64) -> (f64, [f64; 2]) {
    let degrees = |value: f64| if angle { value.to_degrees() } else { value };
    let [from, to] = [range.min, range.max].map(degrees);
    let least = (to - from) * apart;
    let step = if angle {
        angle_step(least, 1.0)
    } else {
        round_step(least)
    };
    (step, [from, to])
}

/// Returns the smallest usual step of angles that is at least `least` and at least `finest`, degrees. Steps below 1°
/// are round numbers, steps beyond a turn are whole turns.
fn angle_step(least: f64, finest: f64) -> f64 {
    if least < 1.0 && finest <= least {
        return round_step(least);
    }
    let listed = ANGLES.into_iter().find(|step| *step >= least.max(finest));
    listed.unwrap_or_else(|| 360.0 * (least / 360.0).ceil())
}

/// Returns the smallest step not below `least` that is 1, 2 or 5 times a power of ten.
fn round_step(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|step| step * power >= least);
    step.unwrap_or(10.0) * power
}

/// Returns the multiples of `step` in the range, with a tolerance for rounding; at most a hundred.
fn multiples(step: f64, from: f64, to: f64) -> impl Iterator<Item = f64> {
    let slack = 1e-9 * step;
    let first = ((from - slack) / step).ceil();
    (0..100)
        .map(move |i| (first + f64::from(i)) * step + 0.0)
        .take_while(move |value| *value <= to + slack)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn written(ticks: &[Tick]) -> Vec<f64> {
        ticks.iter().map(|tick| tick.value).collect()
    }

    #[test]
    fn crank_angles_are_the_usual_ones() {
        let wide = crank([0.0, TAU], 330.0, 1.0);
        assert_eq!(
            written(&wide),
            [0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0]
        );
        assert_eq!(wide[6].at, 330.0);
        assert_eq!(
            written(&crank([0.0, TAU], 160.0, 1.0)),
            [0.0, 120.0, 240.0, 360.0]
        );
        assert_eq!(crank([0.0, 2.0 * TAU], 330.0, 1.0).len(), 7);
        assert_eq!(written(&crank([0.0, TAU], 330.0, 2.0)).len(), 4);
        let short = [35.0_f64, 105.0].map(f64::to_radians);
        assert_eq!(
            written(&crank(short, 330.0, 1.0)),
            [45.0, 60.0, 75.0, 90.0, 105.0]
        );
        assert_eq!(written(&crank(short, 900.0, 1.0))[..3], [35.0, 40.0, 45.0]);
        let little = [-2.4_f64, 2.4].map(f64::to_radians);
        assert_eq!(
            written(&crank(little, 330.0, 1.0)),
            [-2.0, -1.0, 0.0, 1.0, 2.0]
        );
        let less = [-0.25_f64, 0.25].map(f64::to_radians);
        assert_eq!(crank(less, 330.0, 1.0).len(), 5);
    }

    #[test]
    fn values_are_round_and_fit() {
        let range = Range {
            min: -1.3,
            max: 2.2,
        };
        let ticks = values(range, false, 150.0, 1.0);
        assert_eq!(written(&ticks), [-1.0, 0.0, 1.0, 2.0]);
        for scale in [1e-9, 1e-3, 1.0, 1e5, 1e12] {
            let range = Range {
                min: -1.3 * scale,
                max: 2.2 * scale,
            };
            let count = values(range, false, 150.0, 1.0).len();
            assert!((2..=5).contains(&count), "{count} at {scale}");
            let count = values(range, true, 150.0, 1.0).len();
            assert!((1..=5).contains(&count), "{count} at {scale}");
        }
    }
}
