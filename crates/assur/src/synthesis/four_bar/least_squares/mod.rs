//! Four positions and more: the best compromise, the least ΣJ over positive lengths.
//!
//! ΣJ has several local minima, so the search descends from many starts and reports where each descent ends. It is
//! deterministic and proceeds step by step, so that it can be displayed and stopped.

mod minimiser;
mod objective;
mod starts;
mod surface;
mod weighted_difference;

use crate::sorting::sort_by;
use std::f64::consts::TAU;

use super::{Proportions, Solution, Task};
use crate::angle::nearest_to;
use minimiser::Descent;
use objective::{Objective, Point};
pub use surface::Surface;
pub use weighted_difference::weighted_difference;

/// A local minimum of ΣJ.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimum {
    /// The linkage.
    pub solution: Solution,
    /// ΣJ with the weights of the task, in squares of the frame's length.
    pub value: f64,
    /// Maximum error of the output's angle over the positions, radians: [`Solution::output_error`].
    pub output_error: Option<f64>,
    /// Active bounds; empty for an interior minimum.
    pub held: Vec<Bound>,
    /// Number of descents that ended at this minimum.
    pub reached: usize,
    /// Paths of these descents, with start and end.
    pub paths: Vec<Vec<Proportions>>,
}

/// A length at a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// z₁ is at its lower bound.
    CouplerLeast,
    /// z₁ is at its upper bound.
    CouplerGreatest,
    /// z₂ is at its lower bound.
    OutputLeast,
    /// z₂ is at its upper bound.
    OutputGreatest,
    /// z₃ is at its lower bound.
    InputLeast,
    /// z₃ is at its upper bound.
    InputGreatest,
}

/// State of the search after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Number of finished descents.
    pub ended: usize,
    /// Number of starts, one for each descent.
    pub starts: usize,
    /// Current point of the present descent.
    pub proportions: Proportions,
    /// ΣJ at this point.
    pub value: f64,
    /// The least ΣJ of the finished descents.
    pub best: Option<f64>,
    /// True if all descents have finished.
    pub over: bool,
}

/// The search, which runs step by step.
#[derive(Clone, Debug)]
pub struct Search {
    task: Task,
    /// Sum of the task's weights: the factor from a weighted mean of J to ΣJ.
    weight: f64,
    ways: Ways,
}

/// Descents with given or with free starting angles.
#[derive(Clone, Debug)]
enum Ways {
    Given(Descents<2>),
    Free(Descents<4>),
}

impl Search {
    /// The search with the given angles of the task, for four or more positions. For fewer positions,
    /// [`TwoPositions`](super::TwoPositions) and [`ThreePositions`](super::ThreePositions) are exact.
    pub fn new(task: &Task) -> Self {
        Self::with(task, Ways::Given(Descents::new(task, starts::given(task))))
    }

    /// The search with free starting angles: φ₂ and φ₃ of the task are measured from unknown angles, which are found
    /// with the lengths. For six or more positions; for five see [`five_positions`](super::five_positions).
    pub fn free(task: &Task) -> Self {
        Self::with(task, Ways::Free(Descents::new(task, starts::free(task))))
    }

    fn with(task: &Task, ways: Ways) -> Self {
        let weights = task.positions().iter().map(|position| position.weight);
        Self {
            task: task.clone(),
            weight: weights.sum(),
            ways,
        }
    }

    /// Takes one step of the present descent, unless the search is over.
    pub fn step(&mut self) -> Progress {
        match &mut self.ways {
            Ways::Given(ways) => ways.step(),
            Ways::Free(ways) => ways.step(),
        }
        self.progress()
    }

    /// The current state of the search.
    pub fn progress(&self) -> Progress {
        let mut progress = match &self.ways {
            Ways::Given(ways) => ways.progress(),
            Ways::Free(ways) => ways.progress(),
        };
        progress.value *= self.weight;
        progress.best = progress.best.map(|best| best * self.weight);
        progress
    }

    /// Runs the search to its end.
    pub fn run(&mut self) -> Vec<Minimum> {
        while !self.progress().over {
            self.step();
        }
        self.minima()
    }

    /// Path of the present descent.
    pub fn path(&self) -> &[Proportions] {
        match &self.ways {
            Ways::Given(ways) => &ways.path,
            Ways::Free(ways) => &ways.path,
        }
    }

    /// The distinct local minima found so far, the least ΣJ first.
    pub fn minima(&self) -> Vec<Minimum> {
        match &self.ways {
            Ways::Given(ways) => ways.minima(&self.task, self.weight),
            Ways::Free(ways) => ways.minima(&self.task, self.weight),
        }
    }
}

/// Descents from several starts, one after the other.
#[derive(Clone, Debug)]
struct Descents<const N: usize> {
    objective: Objective,
    starts: Vec<Point<N>>,
    ended: usize,
    now: Descent<N>,
    path: Vec<Proportions>,
    found: Vec<Found<N>>,
}

/// A point at which one or more descents ended.
#[derive(Clone, Debug)]
struct Found<const N: usize> {
    x: Point<N>,
    value: f64,
    paths: Vec<Vec<Proportions>>,
}

/// Maximum difference between the ends of two descents to the same minimum. ΣJ is flat at a minimum. Rounding of its
/// value leaves only half of the digits of the point, and fewer in a long valley.
const SAME_END: f64 = 1e-5;

impl<const N: usize> Descents<N> {
    fn new(task: &Task, starts: Vec<Point<N>>) -> Self {
        let objective = Objective::new(task);
        let first = starts.first().copied().unwrap_or([0.0; N]);
        let now = Descent::new(&objective, first);
        let path = vec![objective.proportions(&now.x)];
        Self {
            objective,
            starts,
            ended: 0,
            now,
            path,
            found: Vec::new(),
        }
    }

    fn step(&mut self) {
        if self.ended >= self.starts.len() {
            return;
        }
        let before = self.now.x;
        self.now.step(&self.objective);
        if self.now.x != before {
            self.path.push(self.proportions());
        }
        if self.now.over {
            self.end();
        }
    }

    fn proportions(&self) -> Proportions {
        let coupler = self.now.here.coupler;
        self.objective.with_coupler(&self.now.x, coupler)
    }

    /// Records the end of the present descent and begins the next.
    fn end(&mut self) {
        let (x, value) = (self.now.x, self.now.here.value);
        let path = std::mem::take(&mut self.path);
        let known = self.found.iter_mut().find(|found| same(&found.x, &x));
        match known {
            Some(found) => {
                found.paths.push(path);
                if value < found.value {
                    (found.x, found.value) = (x, value);
                }
            }
            None => self.found.push(Found {
                x,
                value,
                paths: vec![path],
            }),
        }
        self.ended += 1;
        if let Some(start) = self.starts.get(self.ended) {
            self.now = Descent::new(&self.objective, *start);
            self.path = vec![self.proportions()];
        }
    }

    fn progress(&self) -> Progress {
        let values = self.found.iter().map(|found| found.value);
        Progress {
            ended: self.ended,
            starts: self.starts.len(),
            proportions: self.proportions(),
            value: self.now.here.value,
            best: values.reduce(f64::min),
            over: self.ended >= self.starts.len(),
        }
    }

    fn minima(&self, task: &Task, weight: f64) -> Vec<Minimum> {
        let mut found: Vec<&Found<N>> = self.found.iter().collect();
        sort_by(&mut found, |a, b| a.value.total_cmp(&b.value));
        let minimum = |found: &Found<N>| {
            let proportions = self.objective.proportions(&found.x);
            let mut paths = found.paths.clone();
            for end in paths.iter_mut().filter_map(|path| path.last_mut()) {
                *end = proportions;
            }
            let angles = if N == 4 {
                [found.x[2], found.x[3]].map(|angle| nearest_to(angle, 0.0))
            } else {
                [0.0; 2]
            };
            let solution = Solution::started(task, proportions, angles);
            Minimum {
                output_error: solution.output_error(task),
                solution,
                value: found.value * weight,
                held: held(task, &proportions),
                reached: found.paths.len(),
                paths,
            }
        };
        found.into_iter().map(minimum).collect()
    }
}

fn same<const N: usize>(a: &Point<N>, b: &Point<N>) -> bool {
    (0..N).all(|k| {
        let off = (a[k] - b[k]).abs();
        let off = if k < 2 { off } else { off % TAU };
        off < SAME_END || k >= 2 && TAU - off < SAME_END
    })
}

fn held(task: &Task, proportions: &Proportions) -> Vec<Bound> {
    let [least, greatest] = task.ratios();
    let bounds = [
        (
            proportions.coupler,
            Bound::CouplerLeast,
            Bound::CouplerGreatest,
        ),
        (
            proportions.output,
            Bound::OutputLeast,
            Bound::OutputGreatest,
        ),
        (proportions.input, Bound::InputLeast, Bound::InputGreatest),
    ];
    bounds
        .into_iter()
        .filter_map(|(z, low, high)| {
            let high = (z == greatest).then_some(high);
            (z == least).then_some(low).or(high)
        })
        .collect()
}
