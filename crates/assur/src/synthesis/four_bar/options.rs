//! What there is to choose from, by how many positions are given.

use crate::sorting::sort_by;

use super::{
    Family, Line, Minimum, Search, Solution, StartsError, Task, ThreePositions, TwoPositions,
    five_positions,
};

/// The linkages that take up the positions of a task.
#[derive(Clone, Debug, PartialEq)]
pub enum Options {
    /// Those of a curve: two positions, or three, one of which follows from the others.
    Family(Family),
    /// These alone: three positions, or five with free starts.
    Exact(Vec<Solution>),
    /// Compromises, the least ΣJ first: more positions.
    Minima {
        /// Where the search ended.
        minima: Vec<Minimum>,
        /// From how many starts it went.
        starts: usize,
    },
}

/// Why there are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoOptions {
    /// One position is taken up by linkages of any output and input; with free starts it takes
    /// five. So many are needed at least.
    TooFew {
        /// The least number.
        least: usize,
    },
    /// Positions that are mirror images in the frame: any output and input will do.
    Any,
    /// No positive lengths are on the line of the first two positions.
    NoFamily(Line),
    /// Three positions ask for these z₂ and z₃, of which one at least is negative.
    Negative {
        /// z₂.
        output: f64,
        /// z₃.
        input: f64,
    },
    /// No positive lengths take up the positions exactly.
    NoSolution,
}

impl Options {
    /// What takes up the positions, with starting angles as given or free.
    ///
    /// # Errors
    /// Why there is nothing.
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

    /// Where a search ends.
    pub fn searched(mut search: Search) -> Self {
        Self::Minima {
            minima: search.run(),
            starts: search.progress().starts,
        }
    }

    /// The numbers of the solutions, from 0, in the order in which they are shown: of minima those first whose output is
    /// off by least, those last that a bound holds.
    pub fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.solutions().len()).collect();
        if let Self::Minima { minima, .. } = self {
            sort_by(&mut order, |a, b| minima[*a].order(&minima[*b]));
        }
        order
    }

    /// The number, from 0, of the solution that is shown first.
    pub fn best(&self) -> usize {
        self.order().first().copied().unwrap_or(0)
    }

    /// The numbered solutions in the order of their numbers: of minima the least ΣJ first.
    pub fn solutions(&self) -> Vec<&Solution> {
        match self {
            Self::Family(_) => Vec::new(),
            Self::Exact(solutions) => solutions.iter().collect(),
            Self::Minima { minima, .. } => minima.iter().map(|one| &one.solution).collect(),
        }
    }
}
