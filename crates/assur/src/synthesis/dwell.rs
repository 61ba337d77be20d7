//! Search for a mechanism ("Design your dwell") whose output dwells over a wanted arc of the crank and moves through a
//! wanted stroke over the rest of the turn.
//!
//! The dimensions are changed one at a time. A change that reduces the defects (deviations from the wanted arc and
//! stroke) is kept, and the next step of this dimension is twice as large. After any other change, the next step of
//! this dimension is half as large and reversed. This is Rosenbrock's search of 1960 without its rotation of axes: the
//! arc of a dwell jumps when the output leaves the band, so there is no gradient to follow. Each step evaluates one
//! candidate over a full turn.

use crate::mechanism::{Dimension, Mechanism, Quantity};
use crate::motion::{Motion, OutputProfile};
use crate::tolerance;

/// Requirements on the output, an angle (radians) or a coordinate (length).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Full width of the band within which the output counts as dwelling.
    pub tolerance: f64,
    /// Minimum arc of the crank over which the output dwells, radians.
    pub arc: f64,
    /// Difference of the maximum and minimum of the output.
    pub stroke: f64,
}

/// A dimension with its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DesignVariable {
    /// The dimension.
    pub dimension: Dimension,
    /// Bounds of the dimension; the initial value lies between them.
    pub range: [f64; 2],
}

/// Reasons why a search cannot start.
#[derive(Clone, Debug, PartialEq)]
pub enum SearchError {
    /// The tolerance is not positive and finite.
    Tolerance,
    /// The arc is not positive and finite, or exceeds a turn.
    Arc,
    /// The stroke is not positive and finite.
    Stroke,
    /// The mechanism has no such output, or the output is an undirected angle ([`Quantity::is_folded`]).
    Output,
    /// No dimension may be changed.
    Rigid,
    /// The mechanism lacks the dimension of the design variable with this index.
    Dimension(usize),
    /// The range of the design variable with this index is not finite, is empty, does not contain the initial value, or
    /// would let a length become zero.
    Range(usize),
    /// The crank does not turn fully, or the motion comes close to a singular pose.
    Blocked,
}

/// Achieved values of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation {
    /// The longest dwell within the tolerance, radians of the crank.
    pub arc: f64,
    /// Difference of the output's maximum and minimum.
    pub stroke: f64,
    /// Root of the sum of the squares of the relative defects of arc and stroke. An arc that is too long is no defect.
    pub residual: f64,
    /// Singularity margin of the motion ([`Motion::singularity_margin`]).
    pub singularity_margin: f64,
}

/// State of the search after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Number of candidates evaluated so far, including the initial mechanism.
    pub judged: usize,
    /// True if the last candidate was better than the previous best and was accepted.
    pub accepted: bool,
    /// Values of the best candidate.
    pub evaluation: Evaluation,
    /// Reason for the end of the search; None while it runs.
    pub end: Option<End>,
}

/// Reasons for the end of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every requirement is met.
    Fulfilled,
    /// No small change of a single dimension improves the mechanism.
    Settled,
}

/// A search that runs step by step, so that it can be displayed and stopped.
#[derive(Clone, Debug)]
pub struct Search {
    target: Target,
    output: Quantity,
    variables: Vec<DesignVariable>,
    /// Values of the variables in the best mechanism so far.
    values: Vec<f64>,
    /// Next steps of the variables.
    steps: Vec<f64>,
    next: usize,
    motion: Motion,
    progress: Progress,
}

/// First step of a dimension, relative to the width of its range.
const FIRST_STEP: f64 = 1.0 / 16.0;

impl Search {
    /// Starts a search from a mechanism; `output` is the name of a quantity, such as `CD.angle`.
    ///
    /// # Errors
    /// The first fault found in the arguments.
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
            steps: widths.map(|width| FIRST_STEP * width).collect(),
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

    /// The current state of the search.
    pub fn progress(&self) -> Progress {
        self.progress
    }

    /// The values of the variables in the best mechanism so far.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Evaluates one more candidate, unless the search is over.
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

    /// Finds the next value to try, and sets `self.next` to the index of its variable. None if all steps have become
    /// negligible.
    fn candidate(&mut self) -> Option<f64> {
        let live = |k: usize| self.steps[k].abs() > tolerance::DISTINCT * self.variables[k].width();
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
            // The dimension is at its bound: the other direction is tried.
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

/// Evaluation of a motion. None if the values to be evaluated are not defined, if the driver does not turn fully, or if
/// the motion comes so close to a singular pose that forces grow a thousandfold.
fn judged(motion: &Motion, output: Quantity, target: Target) -> Option<Evaluation> {
    let singularity_margin = motion.singularity_margin();
    if !motion.cycle().is_full() || singularity_margin.abs() < tolerance::NEAR {
        return None;
    }
    // A candidate whose cycle takes too many turns has no profile. It is therefore not accepted.
    let profile = OutputProfile::new(motion, output).ok()?;
    let arc = profile.dwell(target.tolerance)?.length();
    // An output that rotates continuously is infinitely far from any target.
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
