//! A recorded run that can be read again at any time.

use super::run::{Run, State, TICKS_PER_SECOND};
use super::{Halt, Reading};

/// Number of ticks between stored states.
const APART: u32 = 4;

/// A recording of a run over an interval of time.
#[derive(Clone, Debug)]
pub struct Recording {
    start: Run,
    /// Stored states, [`APART`] ticks apart.
    states: Vec<State>,
    halt: Option<Halt>,
}

impl Recording {
    /// Maximum duration, seconds.
    pub const MAX_DURATION: f64 = 3600.0;

    /// Records a run from its current state over the given time, at most [`Self::MAX_DURATION`], or until the run
    /// halts.
    pub fn new(start: Run, seconds: f64) -> Self {
        let mut run = start.clone();
        // NaN becomes 0.
        let seconds = seconds.clamp(0.0, Self::MAX_DURATION).max(0.0);
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

    /// Reason why the recording ended early, if it did.
    pub fn halt(&self) -> Option<Halt> {
        self.halt
    }

    /// Last time of the recording, seconds.
    pub fn end(&self) -> f64 {
        self.states.last().map_or(0.0, State::time)
    }

    /// The run at the last tick of the recording that is not later than the given time.
    pub fn at(&self, time: f64) -> Run {
        let time = time.min(self.end());
        let from = self.states.partition_point(|state| state.time() <= time);
        let mut run = self.start.clone();
        run.state = self.states[from.saturating_sub(1)];
        let ticks = (time - run.time()) * f64::from(TICKS_PER_SECOND);
        // The same steps were made for the recording, so they can fail only if the recording ended early.
        let gone = run.advance((ticks.max(0.0) as u32).min(APART));
        debug_assert!(gone.is_ok() || self.halt.is_some(), "{gone:?}");
        run
    }

    /// Readings at every stored state.
    pub fn readings(&self) -> impl Iterator<Item = Reading> + '_ {
        let mut run = self.start.clone();
        self.states.iter().map(move |state| {
            run.state = *state;
            run.reading()
        })
    }
}
