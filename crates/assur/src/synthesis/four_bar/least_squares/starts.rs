//! Starting points of a search for the least ΣJ: exact solutions for some of the positions, the least-squares solution
//! of Freudenstein's equations, and a grid. No start is random.

use crate::sorting::sort_by;
use std::f64::consts::TAU;

use super::objective::{Objective, Point};
use super::weighted_difference::weighted_difference;
use crate::synthesis::four_bar::{Task, ThreePositions, five};

/// Grid points along each of ln z₂ and ln z₃.
const GRID: usize = 8;
/// Maximum number of sets of three or five positions that are solved exactly.
const CHOICES: usize = 20;
/// Numbers of grid points along each length and along each angle, if the starting angles are free.
const COARSE: [usize; 2] = [3, 8];
/// Number of points of the [`COARSE`] grid from which the search starts: those with the least ΣJ.
const LOWEST: usize = 32;

/// Starting points if the starting angles are given.
pub(super) fn given(task: &Task) -> Vec<Point<2>> {
    let count = task.positions().len();
    let linear = weighted_difference(task).into_iter();
    let mut starts: Vec<Point<2>> = linear.map(|z| [z.output.ln(), z.input.ln()]).collect();
    for triple in choices::<3>(count) {
        if let ThreePositions::One(found) = ThreePositions::of(task, triple) {
            let z = found.proportions;
            starts.push([z.output.ln(), z.input.ln()]);
        }
    }
    let bounds = Objective::new(task).bounds();
    starts.extend(grid(GRID, bounds));
    starts
}

/// Starting points if the starting angles are free.
pub(super) fn free(task: &Task) -> Vec<Point<4>> {
    let count = task.positions().len();
    let mut starts = Vec::new();
    for five in choices::<5>(count) {
        for (z, [output, input]) in five::of(task, five).unwrap_or_default() {
            starts.push([z.output.ln(), z.input.ln(), output, input]);
        }
    }
    let objective = Objective::new(task);
    let [sizes, turns] = COARSE;
    let angle = |k: usize| k as f64 * TAU / turns as f64;
    let mut coarse: Vec<(f64, Point<4>)> = grid(sizes, objective.bounds())
        .flat_map(|[output, input]| {
            (0..turns * turns).map(move |k| [output, input, angle(k / turns), angle(k % turns)])
        })
        .map(|x| (objective.value(&x).0, x))
        .collect();
    sort_by(&mut coarse, |a, b| a.0.total_cmp(&b.0));
    starts.extend(coarse.into_iter().take(LOWEST).map(|(_, x)| x));
    starts
}

/// Grid of the midpoints of equal intervals along ln z₂ and ln z₃.
fn grid(places: usize, [from, to]: [f64; 2]) -> impl Iterator<Item = Point<2>> {
    let at = move |k: usize| from + (k as f64 + 0.5) / places as f64 * (to - from);
    (0..places * places).map(move |k| [at(k / places), at(k % places)])
}

/// At most [`CHOICES`] sets of K of the `count` positions, taken at even intervals from a list of such sets.
fn choices<const K: usize>(count: usize) -> Vec<[usize; K]> {
    let mut all: Vec<[usize; K]> = Vec::new();
    if count < K {
        return all;
    }
    // Listing all sets out of 12 positions is cheap. If there are more, 12 evenly spread positions are taken.
    let thinned: Vec<usize> = if count > 12 {
        (0..12).map(|k| k * (count - 1) / 11).collect()
    } else {
        (0..count).collect()
    };
    let mut next: [usize; K] = std::array::from_fn(|k| k);
    loop {
        all.push(next.map(|k| thinned[k]));
        // Increments the last index that can still grow; the indices after it take the next numbers.
        let Some(k) = (0..K).rev().find(|k| next[*k] < thinned.len() - K + k) else {
            break;
        };
        next[k] += 1;
        for j in k + 1..K {
            next[j] = next[j - 1] + 1;
        }
    }
    let step = all.len().div_ceil(CHOICES);
    all.into_iter().step_by(step).collect()
}

#[cfg(test)]
mod tests {
    use super::choices;

    #[test]
    fn choices_are_spread() {
        assert_eq!(choices::<3>(3), [[0, 1, 2]]);
        assert_eq!(choices::<3>(4).len(), 4);
        assert!(choices::<5>(4).is_empty());
        for count in [8, 12, 64] {
            let all = choices::<5>(count);
            assert!(all.len() <= 20 && all.len() > 10);
            assert!(all.iter().all(|five| five.is_sorted_by(|a, b| a < b)));
            assert!(all.iter().any(|five| five[4] == count - 1));
        }
    }
}
