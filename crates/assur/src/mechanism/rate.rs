//! Rates of further drivers relative to the first driver, and periods in turns of the first crank.

use std::f64::consts::TAU;

use crate::index::{BodyId, List};
use crate::linkage::spec::{Defect, DriverSpec};
use crate::mechanism::plan::resolved::{Driver, Resolved};
use crate::mechanism::{Layout, Mechanism};
use crate::position::Step;

/// Maximum period of the drivers, in turns of the first crank; also limits the search for circuits with wheels.
pub(crate) const MAX_PERIOD: usize = 24;

/// Number of turns that stands for "never returns"; it is greater than the number of turns of any followed motion.
pub(crate) const NEVER: usize = 10_000_000;

/// Tolerance within which a rate counts as a ratio of whole numbers.
const WHOLE: f64 = 1e-11;

/// Number of turns of the first crank after which every driver is in its initial position again. None if the first
/// driver is a slide, or if a further driver is a slide that does not return.
///
/// # Errors
/// The drivers with inadmissible rates.
pub(super) fn period_turns(spec: &Resolved<'_>) -> Result<Option<usize>, Vec<Defect>> {
    let defect = |driver: &Driver| Defect::Rate {
        link: spec.link_name(spec.driven(driver)).to_owned(),
        rate: driver.rate(),
    };
    let [first, further @ ..] = &spec.drivers[..] else {
        return Ok(None);
    };
    let turns = matches!(first, Driver::Crank { .. });
    let mut found = Vec::new();
    if first.rate() != 1.0 {
        found.push(defect(first));
    }
    let mut period_turns = turns.then_some(1);
    for driver in further {
        let rate = driver.rate();
        let back = match driver {
            _ if !rate.is_finite() => None,
            _ if !turns => Some(None),
            Driver::Crank { .. } => {
                let all = period_turns.unwrap_or(1);
                let mut together = (1..=MAX_PERIOD).filter(|turns| turns % all == 0);
                together
                    .find(|turns| is_whole(rate, *turns))
                    .map(|turns| period_turns.map(|_| turns))
            }
            Driver::Slide { .. } if rate == 0.0 => Some(period_turns),
            // The slide must reach an end of its range before the followed motion is cut off.
            Driver::Slide { range, .. } => {
                let way = (range[1] - range[0]) / rate.abs();
                (way < TAU * (MAX_PERIOD - 1) as f64).then_some(None)
            }
        };
        match back {
            Some(back) => period_turns = back,
            None => found.push(defect(driver)),
        }
    }
    if found.is_empty() {
        Ok(period_turns)
    } else {
        Err(found)
    }
}

/// Denominator of a ratio of numbers of teeth, found from its continued fraction; None if [`NEVER`] or more.
fn denominator(ratio: f64) -> Option<usize> {
    let mut rest = ratio;
    let mut denominators = [0.0, 1.0];
    while denominators[1] < NEVER as f64 {
        let turned = ratio * denominators[1];
        // Bound on the rounding error of a sum of products of a few ratios.
        let exact = 64.0 * f64::EPSILON * (1.0 + ratio.abs()) * denominators[1];
        if (turned - turned.round()).abs() <= exact {
            return Some(denominators[1] as usize);
        }
        rest = (rest - rest.floor()).recip();
        denominators = [
            denominators[1],
            rest.floor() * denominators[1] + denominators[0],
        ];
    }
    None
}

/// Least common multiple; None if [`NEVER`] or more.
fn common(a: usize, b: usize) -> Option<usize> {
    let multiple = (a / num_integer::gcd(a, b).max(1)).checked_mul(b)?;
    (multiple < NEVER).then_some(multiple)
}

/// True if a body that turns at a given rate returns after a given number of turns of the crank.
fn is_whole(rate: f64, turns: usize) -> bool {
    let turned = rate * turns as f64;
    (turned - turned.round()).abs() <= WHOLE * turns as f64
}

impl Layout {
    /// Extends the two periods until the wheels that turn in proportion to the input also return: `turns_of_assemblies`
    /// by the wheels that carry other links, `period_turns` also by those that show their orientation. A period becomes
    /// [`NEVER`] if one of its wheels does not return.
    pub(super) fn count_turns_of_wheels(&mut self) {
        let [carrying, seen] = [false, true].map(|seen| {
            self.together(|body| self.carries(body) || seen && self.shows_its_angle(body))
        });
        (self.period_turns, self.turns_of_assemblies) = (seen, carrying);
    }

    /// Number of turns after which all drivers and the selected bodies that turn in proportion to the input return.
    /// None if the drivers have no period.
    fn together(&self, counts: impl Fn(BodyId) -> bool) -> Option<usize> {
        let period_turns = self.period_turns?;
        let rates = self.rates_of_bodies();
        let bodies = self.bodies.ids().filter(|body| counts(*body));
        let mut turns = bodies.filter_map(|body| rates[body]).map(denominator);
        let together = turns.try_fold(period_turns, |all, turns| common(all, turns?));
        Some(together.unwrap_or(NEVER))
    }

    /// Rate of each body's angle with respect to the input, if drivers and numbers of teeth make it constant.
    fn rates_of_bodies(&self) -> List<BodyId, Option<f64>> {
        let mut rates = self.placed_by.same_len(None);
        rates[BodyId::FRAME] = Some(0.0);
        for step in self.steps.iter() {
            match step {
                Step::Crank(crank) => {
                    let base = rates[crank.at.body];
                    rates[crank.body] = base.map(|base| base + crank.law.rate);
                }
                Step::Slider(slider) => rates[slider.track.body] = rates[slider.track.line.body],
                Step::Epicyclic(train) => {
                    for member in &train.members {
                        let terms = member.ratios.iter();
                        let terms = terms.map(|(body, ratio)| Some(rates[*body]? * ratio));
                        rates[member.body] = terms.sum();
                    }
                }
                _ => {}
            }
        }
        rates
    }
}

impl Mechanism {
    /// Maximum rate, in radians per unit of the input, of the links that turn in proportion to the input. These are
    /// links turned by drivers, and wheels that carry another link or a point off their centre. 0 if there are none.
    pub fn quickest(&self) -> f64 {
        let rates = self.layout.rates_of_bodies();
        let bodies = self.bodies();
        let seen =
            bodies.filter(|body| self.layout.carries(*body) || self.layout.shows_its_angle(*body));
        let rates = seen.filter_map(|body| rates[body]);
        rates.fold(0.0, |most, rate| most.max(rate.abs()))
    }

    /// Rate of each driver's coordinate relative to the coordinate of the first driver.
    pub fn rates(&self) -> impl Iterator<Item = f64> {
        self.spec.drivers.iter().map(DriverSpec::rate)
    }

    /// Period of the drivers and visible wheels, in radians of the first crank. None for a driven slide, or if a
    /// further driver is a slide that does not return.
    pub(crate) fn period(&self) -> Option<f64> {
        self.layout
            .period_turns
            .map(|period_turns| TAU * period_turns as f64)
    }

    /// Number of turns of the crank after which the assemblies repeat: the drivers, and the wheels that carry other
    /// links, have then returned. None in the same cases as [`Self::period`].
    pub(crate) fn turns_of_assemblies(&self) -> Option<usize> {
        self.layout.turns_of_assemblies
    }

    /// Interval of inputs within the ranges of all driven slides; infinite if there are no driven slides.
    pub(crate) fn within_ranges(&self) -> [f64; 2] {
        let within = self.steps().iter().flat_map(|step| match step {
            Step::Slider(slider) => vec![(slider.law, slider.range)],
            Step::Group(group) => group.ranges().collect(),
            _ => Vec::new(),
        });
        let all = [f64::NEG_INFINITY, f64::INFINITY];
        let moving = within.filter(|(course, _)| course.rate != 0.0);
        moving.fold(all, |[low, high], (course, range)| {
            let ends = range.map(|end| (end - course.offset) / course.rate);
            [
                low.max(ends[0].min(ends[1])),
                high.min(ends[0].max(ends[1])),
            ]
        })
    }

    /// [`Self::period`] in turns of the first crank; 1 if there is no period.
    pub(crate) fn period_turns(&self) -> usize {
        self.layout.period_turns.unwrap_or(1)
    }

    /// Number of turns after which a mechanism of only cranks and wheels repeats, from the numbers of teeth. None for
    /// any other mechanism, or if the number is [`NEVER`] or more.
    pub(crate) fn turns_of_wheels(&self) -> Option<usize> {
        let mut steps = self.steps().iter();
        let alone = steps.all(|step| matches!(step, Step::Crank(_) | Step::Epicyclic(_)));
        self.layout
            .period_turns
            .filter(|turns| alone && *turns < NEVER)
    }

    /// Least number of turns after which a motion may repeat: the least common multiple of the period of drivers and
    /// wheels and the period of the four-bars in closed form (one turn, or two if a turn swaps their assembly). None if
    /// [`NEVER`] or more.
    pub(crate) fn least_turns(&self) -> Option<usize> {
        let turns = self.closed_steps().map(|closed| closed.turns());
        common(turns.max().unwrap_or(1), self.period_turns())
    }

    /// Shift of the input that leaves the poses of a motion between two dead points unchanged: [`Self::least_turns`] in
    /// radians. None if there is no such number or no period of the drivers, or if a group depends on the number of
    /// turns of the crank.
    pub(crate) fn period_of_arcs(&self) -> Option<f64> {
        let rates = self.layout.rates_of_bodies();
        let mut counted = self.steps().iter().flat_map(|step| match step {
            Step::Group(group) => group.turned_by().collect(),
            _ => Vec::new(),
        });
        let counts_turns = counted.any(|body| rates[body].is_some_and(|rate| rate != 0.0));
        let turns = self.least_turns().filter(|_| !counts_turns)?;
        self.layout.period_turns.map(|_| TAU * turns as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn denominators_of_ratios_of_teeth() {
        for (ratio, expected) in [
            (20.0 / 60.0, Some(3)),
            (-2.5, Some(2)),
            (7.0, Some(1)),
            (0.0, Some(1)),
            (36.0 / 37.0 * 23.0 / 41.0, Some(37 * 41)),
        ] {
            assert_eq!(denominator(ratio), expected, "{ratio}");
        }
    }

    #[test]
    fn wheels_return_together_after_the_least_common_multiple() {
        for (a, b, expected) in [
            (4, 6, Some(12)),
            (1, 5, Some(5)),
            (9, 9, Some(9)),
            (999_983, 999_979, None),
        ] {
            assert_eq!(common(a, b), expected);
        }
    }

    #[test]
    fn a_rate_is_whole_after_as_many_turns_as_its_denominator() {
        for (rate, turns, expected) in [
            (0.5, 2, true),
            (0.5, 3, false),
            (-1.0 / 3.0, 3, true),
            (1.0 / 3.0, 2, false),
            (0.333, 3, false),
        ] {
            assert_eq!(is_whole(rate, turns), expected, "{rate} {turns}");
        }
    }
}
