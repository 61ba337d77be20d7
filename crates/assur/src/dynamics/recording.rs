//! A run that is kept, so that any time of it can be gone back to.

use super::run::{Run, State, TICKS_PER_SECOND};
use super::{Halt, Reading};

/// So many ticks are gone from a kept state at most.
const APART: u32 = 4;

/// A run over a span of time.
#[derive(Clone, Debug)]
pub struct Recording {
    start: Run,
    /// States, [`APART`] ticks from each other, from the start on.
    states: Vec<State>,
    halt: Option<Halt>,
}

impl Recording {
    /// The longest span, seconds.
    pub const LONGEST: f64 = 3600.0;

    /// A run from where it is on, for so many seconds within [`Self::LONGEST`], or until it can be followed no further.
    pub fn new(start: Run, seconds: f64) -> Self {
        let mut run = start.clone();
        // What is no number is 0.
        let seconds = seconds.clamp(0.0, Self::LONGEST).max(0.0);
        let count = (seconds * f64::from(TICKS_PER_SECOND) / f64::from(APART)) as usize;
        let mut states = Vec::with_capacity(count + 1);
        states.push(run.state);
        let mut halt = None;
        for _ in 0..count {
            if let Err(reason) = run.advance(APART) {
                halt = Some(reason);
                break;
            }
            states.push(run.state);
        }
        Self {
            start,
            states,
            halt,
        }
    }

    /// Why it ends before its span does, where it does.
    pub fn halt(&self) -> Option<Halt> {
        self.halt
    }

    /// Its last time, seconds.
    pub fn end(&self) -> f64 {
        self.states.last().map_or(0.0, State::time)
    }

    /// The run at the tick at or before a time, of those that it has.
    pub fn at(&self, time: f64) -> Run {
        let time = time.min(self.end());
        let from = self.states.partition_point(|state| state.time() <= time);
        let mut run = self.start.clone();
        run.state = self.states[from.saturating_sub(1)];
        let ticks = (time - run.time()) * f64::from(TICKS_PER_SECOND);
        // What has been gone once can be gone again.
        let gone = run.advance((ticks.max(0.0) as u32).min(APART));
        debug_assert!(gone.is_ok() || self.halt.is_some(), "{gone:?}");
        run
    }

    /// What is read at every kept state.
    pub fn readings(&self) -> impl Iterator<Item = Reading> + '_ {
        let mut run = self.start.clone();
        self.states.iter().map(move |state| {
            run.state = *state;
            run.reading()
        })
    }
}
