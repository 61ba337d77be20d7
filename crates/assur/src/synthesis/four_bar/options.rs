//! Solutions to choose from, depending on the number of positions.

use crate::sorting::sort_by;

use super::{
    Family, Line, Minimum, Search, Solution, StartsError, Task, ThreePositions, TwoPositions,
    five_positions,
};

/// The linkages through the positions of a task.
#[derive(Clone, Debug, PartialEq)]
pub enum Options {
    /// A one-parameter family: for two positions, or for three if the third adds no condition.
    Family(Family),
    /// Finitely many linkages: for three positions, or five with free starting angles.
    Exact(Vec<Solution>),
    /// Compromises by increasing ΣJ: for more positions, or for five special ones with free starting angles.
    Minima {
        /// Minima found by the search.
        minima: Vec<Minimum>,
        /// Number of starts of the search.
        starts: usize,
    },
}

/// Reasons why there are no solutions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoOptions {
    /// Too few positions. Any output and input meet a single position; free starting angles require five.
    TooFew {
        /// Minimum number of positions.
        least: usize,
    },
    /// The positions are mirror images in the line of the frame, and output and input of any lengths meet them.
    Any,
    /// Two positions require lengths on this line, on which no point has two positive lengths.
    NoFamily(Line),
    /// Three positions require these z₂ and z₃, at least one of them negative.
    Negative {
        /// z₂.
        output: f64,
        /// z₃.
        input: f64,
    },
    /// No positive lengths meet the positions exactly.
    NoSolution,
}

impl Options {
    /// Finds the solutions, with given or with free starting angles.
    ///
    /// # Errors
    /// The reason why there are no solutions.
    pub fn new(task: &Task, free: bool) -> Result<Self, NoOptions> {
        if free {
            return match five_positions(task) {
                Ok(found) if found.is_empty() => Err(NoOptions::NoSolution),
                Ok(found) => Ok(Self::Exact(found)),
                Err(StartsError::Family { .. }) => Err(NoOptions::TooFew { least: 5 }),
                Err(StartsError::TooMany | StartsError::Degenerate) => {
                    Ok(Self::searched(Search::free(task)))
                }
            };
        }
        match task.positions().len() {
            0 | 1 => Err(NoOptions::TooFew { least: 2 }),
            2 => Self::of_two(TwoPositions::new(task)),
            3 => match ThreePositions::new(task) {
                Some(ThreePositions::One(solution)) => Ok(Self::Exact(vec![solution])),
                Some(ThreePositions::Negative { output, input }) => {
                    Err(NoOptions::Negative { output, input })
                }
                Some(ThreePositions::Same(two)) => Self::of_two(Some(two)),
                _ => Err(NoOptions::NoSolution),
            },
            _ => Ok(Self::searched(Search::new(task))),
        }
    }

    fn of_two(two: Option<TwoPositions>) -> Result<Self, NoOptions> {
        match two {
            Some(TwoPositions::Family(family)) => Ok(Self::Family(family)),
            Some(TwoPositions::None(line)) => Err(NoOptions::NoFamily(line)),
            Some(TwoPositions::Any) => Err(NoOptions::Any),
            None => Err(NoOptions::TooFew { least: 2 }),
        }
    }

    /// The minima after running a search to its end.
    pub fn searched(mut search: Search) -> Self {
        Self::Minima {
            minima: search.run(),
            starts: search.progress().starts,
        }
    }

    /// Indices of the solutions, from 0, in display order: minima by increasing output error, those at a bound last.
    pub fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.solutions().len()).collect();
        if let Self::Minima { minima, .. } = self {
            sort_by(&mut order, |a, b| minima[*a].order(&minima[*b]));
        }
        order
    }

    /// Index, from 0, of the solution shown first.
    pub fn best(&self) -> usize {
        self.order().first().copied().unwrap_or(0)
    }

    /// The solutions in the order of their indices; minima by increasing ΣJ. Empty for a family.
    pub fn solutions(&self) -> Vec<&Solution> {
        match self {
            Self::Family(_) => Vec::new(),
            Self::Exact(solutions) => solutions.iter().collect(),
            Self::Minima { minima, .. } => minima.iter().map(|one| &one.solution).collect(),
        }
    }
}
