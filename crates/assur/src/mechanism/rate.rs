//! At what rates further drivers go with the first, and after how many of its turns all are back.

use std::f64::consts::TAU;

use super::Mechanism;
use super::draft::{Defect, Draft, DraftDriver};
use crate::position::{Course, Step};

/// A motion that has not repeated after so many turns of the first crank is followed no further.
pub(crate) const MOST_TURNS: usize = 24;

/// A rate is a ratio of whole numbers, within this.
const WHOLE: f64 = 1e-11;

/// After how many turns of the first crank every driver is back; none where one is a slide that goes on, or the
/// first is.
///
/// # Errors
/// Each driver with a rate that will not do.
pub(super) fn rounds(draft: &Draft) -> Result<Option<usize>, Vec<Defect>> {
    let defect = |driver: &DraftDriver| Defect::Rate {
        link: draft.driven(driver).unwrap_or_default().to_owned(),
        rate: driver.rate(),
    };
    let [first, further @ ..] = &draft.drivers[..] else {
        return Ok(None);
    };
    let turns = matches!(first, DraftDriver::Crank { .. });
    let mut found = Vec::new();
    if first.rate() != 1.0 {
        found.push(defect(first));
    }
    let mut rounds = turns.then_some(1);
    for driver in further {
        let rate = driver.rate();
        let back = match driver {
            _ if !rate.is_finite() => None,
            _ if !turns => Some(None),
            DraftDriver::Crank { .. } => {
                let all = rounds.unwrap_or(1);
                let mut together = (1..=MOST_TURNS).filter(|turns| turns % all == 0);
                let is_whole = |turns: &usize| {
                    let turned = rate * *turns as f64;
                    (turned - turned.round()).abs() <= WHOLE * *turns as f64
                };
                together.find(is_whole).map(|turns| rounds.map(|_| turns))
            }
            DraftDriver::Slide { .. } if rate == 0.0 => Some(rounds),
            // It comes to an end of its range before the motion is cut.
            DraftDriver::Slide { range, .. } => {
                let way = (range[1] - range[0]) / rate.abs();
                (way < TAU * (MOST_TURNS - 1) as f64).then_some(None)
            }
        };
        match back {
            Some(back) => rounds = back,
            None => found.push(defect(driver)),
        }
    }
    if found.is_empty() {
        Ok(rounds)
    } else {
        Err(found)
    }
}

impl Mechanism {
    /// By how much the coordinate of each driver grows with that of the first.
    pub fn rates(&self) -> impl Iterator<Item = f64> {
        self.draft.drivers.iter().map(DraftDriver::rate)
    }

    /// What the input grows by until all drivers are back: whole turns of a crank. None of a slide, and where a
    /// further driver is a slide that goes on with the crank.
    pub(crate) fn period(&self) -> Option<f64> {
        self.rounds.map(|rounds| TAU * rounds as f64)
    }

    /// The same in turns; 1 where there is none.
    pub(crate) fn rounds(&self) -> usize {
        self.rounds.unwrap_or(1)
    }

    /// Takes the drawing for that at another input, whole turns of the crank away: further drivers, too, are where
    /// they are drawn.
    pub(super) fn counted_from(&mut self, input: f64) {
        let turns = ((input - self.home) / TAU).round();
        if !self.turns() || turns == 0.0 {
            return;
        }
        for step in self.steps.iter_mut() {
            let course = match step {
                Step::Crank(crank) => &mut crank.course,
                Step::Slider(slider) => &mut slider.course,
                _ => continue,
            };
            if *course != Course::FIRST {
                course.offset -= course.rate * turns * TAU;
            }
        }
    }
}
