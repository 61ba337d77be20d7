//! "Design your dwell": a mechanism whose output is to stand still for a wanted
//! arc of the crank and to swing by a wanted stroke in between.
//!
//! One dimension after the other is moved; what makes the defects smaller stays,
//! and is tried twice as wide next time, what does not is tried half as wide the
//! other way (Rosenbrock's search of 1960 without its turning of axes: an arc of
//! dwell leaps where the band breaks, so there is no gradient to follow). Each
//! step of the search is one candidate, judged over its full turn.

use crate::mechanism::{Dimension, Mechanism, Quantity};
use crate::motion::{Motion, OutputProfile};
use crate::tolerance;

/// What is wanted of the output, an angle (radians) or a coordinate (length).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// The full width of the band within which the output counts as standing.
    pub tolerance: f64,
    /// The arc of the crank over which it stands at least, radians.
    pub arc: f64,
    /// By how much it moves from its least to its greatest value.
    pub stroke: f64,
}

/// A dimension with its least and its greatest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DesignVariable {
    /// Which one.
    pub dimension: Dimension,
    /// How far it may go; its value at the start lies between.
    pub range: [f64; 2],
}

/// Why there is nothing to search.
#[derive(Clone, Debug, PartialEq)]
pub enum SearchError {
    /// The tolerance, the arc (up to a turn) or the stroke is not greater than
    /// zero and finite.
    Tolerance,
    /// See [`SearchError::Tolerance`].
    Arc,
    /// See [`SearchError::Tolerance`].
    Stroke,
    /// The mechanism has no such output.
    Output,
    /// No dimension may move.
    Rigid,
    /// The design variable of this index: the mechanism has no such dimension.
    Dimension(usize),
    /// The design variable of this index: its range is not finite, empty, or does not hold
    /// the value at the start; or a length may become zero.
    Range(usize),
    /// The crank does not turn fully, or the motion comes close to a singular pose.
    Blocked,
}

/// What a mechanism does of what is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation {
    /// The longest arc of the crank within the tolerance, radians.
    pub arc: f64,
    /// From the least to the greatest value of the output.
    pub stroke: f64,
    /// The root of the sum of the squared defects, each relative to what is wanted; a
    /// longer arc is no defect.
    pub residual: f64,
    /// [`Motion::singularity_margin`].
    pub singularity_margin: f64,
}

/// The search after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Candidates judged so far.
    pub judged: usize,
    /// Whether the last one was better and is now the draft.
    pub accepted: bool,
    /// What the best one reaches.
    pub evaluation: Evaluation,
    /// Why it is over, if it is.
    pub end: Option<End>,
}

/// Why a search is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All that is wanted is evaluation.
    Fulfilled,
    /// No dimension can be moved for the better.
    Settled,
}

/// A search, step by step, so that it can be shown and stopped.
#[derive(Clone, Debug)]
pub struct Search {
    target: Target,
    output: Quantity,
    variables: Vec<DesignVariable>,
    /// The value of each variable, and the step to try next.
    values: Vec<f64>,
    steps: Vec<f64>,
    next: usize,
    motion: Motion,
    progress: Progress,
}

/// The first step relative to the range of a dimension, and the least.
const FIRST: f64 = 1.0 / 16.0;
const LEAST: f64 = 1e-7;
/// No candidate may come closer to a singular pose.
const SINGULARITY_MARGIN: f64 = 1e-3;

impl Search {
    /// A search from a mechanism; `output` is the name of a quantity, as `CD.angle`.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn new(
        mechanism: &Mechanism,
        output: &str,
        target: Target,
        variables: &[DesignVariable],
    ) -> Result<Self, SearchError> {
        let sound = |value: f64| value > 0.0 && value.is_finite();
        if !sound(target.tolerance) {
            return Err(SearchError::Tolerance);
        }
        if !sound(target.arc) || target.arc > std::f64::consts::TAU {
            return Err(SearchError::Arc);
        }
        if !sound(target.stroke) {
            return Err(SearchError::Stroke);
        }
        let output = Quantity::named(mechanism, output);
        let output = output
            .filter(|one| !one.is_folded())
            .ok_or(SearchError::Output)?;
        if variables.is_empty() {
            return Err(SearchError::Rigid);
        }
        let mut values = Vec::new();
        for (index, variable) in variables.iter().enumerate() {
            let value = mechanism.value(variable.dimension);
            let value = value.ok_or(SearchError::Dimension(index))?;
            let [from, to] = variable.range;
            let length = matches!(
                variable.dimension,
                Dimension::Length(_) | Dimension::Side(..)
            );
            let sound = from.is_finite() && to.is_finite() && from < to;
            if !sound || !(from..=to).contains(&value) || length && from <= 0.0 {
                return Err(SearchError::Range(index));
            }
            values.push(value);
        }
        let motion = Motion::new(mechanism.clone());
        let evaluation = judged(&motion, output, target).ok_or(SearchError::Blocked)?;
        let widths = variables.iter().map(|variable| variable.width());
        Ok(Self {
            target,
            output,
            values,
            steps: widths.map(|width| FIRST * width).collect(),
            variables: variables.to_vec(),
            next: 0,
            motion,
            progress: Progress {
                judged: 1,
                accepted: true,
                evaluation,
                end: (evaluation.residual <= tolerance::TRIPLE_ROOT).then_some(End::Fulfilled),
            },
        })
    }

    /// The best mechanism so far.
    pub fn mechanism(&self) -> &Mechanism {
        self.motion.mechanism()
    }

    /// What the search has come to.
    pub fn progress(&self) -> Progress {
        self.progress
    }

    /// The values of the variables in the best mechanism so far.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Judges one candidate more, unless the search is over.
    pub fn step(&mut self) -> Progress {
        self.progress.accepted = false;
        if self.progress.end.is_none() {
            match self.candidate() {
                Some(value) => self.judge(value),
                None => self.progress.end = Some(End::Settled),
            }
        }
        self.progress
    }

    /// The value to try next of the dimension `self.next`; none where no step is
    /// left to try.
    fn candidate(&mut self) -> Option<f64> {
        let live = |k: usize| self.steps[k].abs() > LEAST * self.variables[k].width();
        let count = self.variables.len();
        let mut idle = 0;
        while idle < count {
            let k = self.next;
            if !live(k) {
                self.next = (k + 1) % count;
                idle += 1;
                continue;
            }
            let [from, to] = self.variables[k].range;
            let value = (self.values[k] + self.steps[k]).clamp(from, to);
            if value != self.values[k] {
                return Some(value);
            }
            // At its bound already: the other way.
            self.steps[k] *= -0.5;
            return self.candidate();
        }
        None
    }

    fn judge(&mut self, value: f64) {
        let k = self.next;
        let dimension = self.variables[k].dimension;
        let changed = self
            .motion
            .changed(dimension, value, self.motion.drawn_input());
        self.progress.judged += 1;
        self.next = (k + 1) % self.variables.len();
        let before = self.progress.evaluation;
        let judged = changed.ok().and_then(|changed| {
            let evaluation = judged(&changed.motion, self.output, self.target)?;
            Some((changed.motion, evaluation))
        });
        let better = judged.filter(|(_, evaluation)| {
            evaluation.residual < before.residual
                && evaluation.singularity_margin * before.singularity_margin > 0.0
        });
        match better {
            Some((motion, evaluation)) => {
                self.motion = motion;
                self.values[k] = value;
                self.steps[k] *= 2.0;
                self.progress.evaluation = evaluation;
                self.progress.accepted = true;
                if evaluation.residual <= tolerance::TRIPLE_ROOT {
                    self.progress.end = Some(End::Fulfilled);
                }
            }
            None => self.steps[k] *= -0.5,
        }
    }
}

impl DesignVariable {
    fn width(&self) -> f64 {
        self.range[1] - self.range[0]
    }
}

/// What a motion reaches; none where the driver does not turn fully, or comes close to a
/// singular pose.
fn judged(motion: &Motion, output: Quantity, target: Target) -> Option<Evaluation> {
    let singularity_margin = motion.singularity_margin();
    if !motion.cycle().is_full() || singularity_margin.abs() < SINGULARITY_MARGIN {
        return None;
    }
    // A candidate of too many turns is not searched, and so fulfils nothing.
    let profile = OutputProfile::new(motion, output).ok()?;
    let arc = profile.dwell(target.tolerance)?.length();
    // What turns on and on is as far from any target as can be.
    let stroke = profile.stroke().unwrap_or(f64::NEG_INFINITY);
    let defects = [
        (1.0 - arc / target.arc).max(0.0),
        stroke / target.stroke - 1.0,
    ];
    let evaluation = Evaluation {
        arc,
        stroke,
        residual: defects[0].hypot(defects[1]),
        singularity_margin,
    };
    evaluation.residual.is_finite().then_some(evaluation)
}
