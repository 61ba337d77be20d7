//! Rates of the drivers relative to the first driver.

use super::{Driver, Moves};
use crate::LeftOut;

/// Maximum number of turns of the first crank before all cranks are back at their start (docs/file-format.md).
const MAX_TURNS: u32 = 24;

/// Speed, as a fraction of the fastest driver's, below which a driver counts as at rest.
const STILL: f64 = 1e-9;

/// Reorders the drivers so that the first one moves, and pairs each driver with its rate. None stands for the rate 1;
/// if all drivers are at rest, every rate is none.
pub(super) fn of(
    mut drivers: Vec<Driver>,
    left_out: &mut Vec<LeftOut>,
) -> Vec<(Driver, Option<f64>)> {
    let fastest = drivers.iter().map(|driver| driver.speed.abs());
    let still = STILL * fastest.fold(0.0, f64::max);
    let moves = |driver: &Driver| driver.speed.abs() > still;
    let Some(first) = drivers.iter().position(moves) else {
        return drivers.into_iter().map(|driver| (driver, None)).collect();
    };
    drivers[..=first].rotate_right(1);
    let speed = drivers[0].speed;
    let turns = matches!(drivers[0].moves, Moves::Crank { .. });
    let wished: Vec<f64> = drivers.iter().map(|driver| driver.speed / speed).collect();
    let cranks = || {
        let cranks = drivers.iter().zip(&wished);
        let cranks = cranks.filter(|(driver, _)| matches!(driver.moves, Moves::Crank { .. }));
        cranks.map(|(_, rate)| *rate)
    };
    let near = |rate: f64, turns: u32| (rate * f64::from(turns)).round() / f64::from(turns);
    let off = |turns: u32| {
        let offs = cranks().map(|rate| (near(rate, turns) - rate).abs());
        offs.fold(0.0, f64::max)
    };
    // Rates of cranks are rounded to fractions; their denominator is a number of turns of the first crank. `least` is
    // the least rounding error, `round` the smallest denominator that attains it.
    let least = (1..=MAX_TURNS).map(off).fold(f64::INFINITY, f64::min);
    let round = (1..=MAX_TURNS)
        .find(|turns| off(*turns) <= least + 1e-12)
        .unwrap_or(1);
    let rated = drivers.into_iter().zip(wished).enumerate();
    rated
        .map(|(k, (driver, rate))| {
            let crank = matches!(driver.moves, Moves::Crank { .. });
            let taken = if turns && crank {
                near(rate, round)
            } else {
                rate
            };
            if (taken - rate).abs() > 1e-9 {
                let link = driver.called.clone();
                left_out.push(LeftOut::Ratio { link, rate, taken });
            }
            (driver, (k > 0 && taken != 1.0).then_some(taken))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::Body;
    use super::*;

    fn cranks(speeds: &[f64]) -> (Vec<Option<f64>>, usize) {
        let drivers = speeds.iter().enumerate().map(|(bar, speed)| Driver {
            moves: Moves::Crank {
                bar,
                base: Body::Frame,
            },
            speed: *speed,
            called: String::new(),
        });
        let mut left_out = Vec::new();
        let rated = of(drivers.collect(), &mut left_out);
        (
            rated.into_iter().map(|(_, rate)| rate).collect(),
            left_out.len(),
        )
    }

    #[test]
    fn rates_are_such_that_the_motion_repeats() {
        assert_eq!(cranks(&[15.0, 10.0]), (vec![None, Some(2.0 / 3.0)], 0));
        assert_eq!(
            cranks(&[15.0, 15.0, -15.0]),
            (vec![None, None, Some(-1.0)], 0)
        );
        // A driver at rest does not become the first.
        assert_eq!(cranks(&[0.0, 4.0]), (vec![None, Some(0.0)], 0));
        // With speeds of 15.7 and 15 the motion would repeat only after 150 turns.
        assert_eq!(cranks(&[15.0, 15.7]), (vec![None, Some(22.0 / 21.0)], 1));
        assert_eq!(cranks(&[0.0, 0.0]), (vec![None, None], 0));
        // A driver far slower than the others does not become the first: their rates would be infinite.
        assert_eq!(cranks(&[1e-308, 1e9]), (vec![None, Some(0.0)], 0));
    }
}
