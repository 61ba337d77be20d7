//! Three positions: Freudenstein's equation, two lines in (1/z₂, 1/z₃) and their point.

use super::{Line, Proportions, Solution, Task, TwoPositions};

/// What three positions leave open.
#[derive(Clone, Debug, PartialEq)]
pub enum ThreePositions {
    /// The one linkage.
    One(Solution),
    /// The one point of the lines has lengths that are negative: the linkage takes up the
    /// positions with that link's angle half a turn on.
    Negative {
        /// z₂.
        output: f64,
        /// z₃.
        input: f64,
    },
    /// The lines meet where a length is infinite or the coupler's is nothing, or nowhere: there
    /// is no such linkage. The two lines.
    None([Line; 2]),
    /// All positions are on the same line: what two of them leave open.
    Same(TwoPositions),
}

impl ThreePositions {
    /// The linkages that take up the first three positions of a task; none where there are fewer.
    pub fn new(task: &Task) -> Option<Self> {
        (task.positions().len() >= 3).then(|| Self::of(task, [0, 1, 2]))
    }

    pub(super) fn of(task: &Task, [i, j, k]: [usize; 3]) -> Self {
        let lines = [Line::new(task, [i, j]), Line::new(task, [i, k])];
        let empty = |line: &Line| {
            *line
                == Line {
                    output: 0.0,
                    input: 0.0,
                    right: 0.0,
                }
        };
        // A line that says nothing leaves what the other one says.
        if empty(&lines[0]) {
            return Self::Same(TwoPositions::of(task, [i, k]));
        }
        if empty(&lines[1]) {
            return Self::Same(TwoPositions::of(task, [i, j]));
        }
        let Some([u, v]) = lines[0].meet(lines[1]) else {
            return if same(lines) {
                Self::Same(TwoPositions::of(task, [i, j]))
            } else {
                Self::None(lines)
            };
        };
        let [output, input] = [u.recip(), v.recip()];
        if !(output.is_finite() && input.is_finite()) {
            return Self::None(lines);
        }
        if output < 0.0 || input < 0.0 {
            return Self::Negative { output, input };
        }
        let gaps = [i, j, k].map(|k| task.direction(k, [0.0; 2]).gap(output, input).norm());
        let coupler = gaps.into_iter().sum::<f64>() / 3.0;
        if coupler > 0.0 && coupler.is_finite() {
            let proportions = Proportions {
                coupler,
                output,
                input,
            };
            Self::One(Solution::new(task, proportions))
        } else {
            Self::None(lines)
        }
    }
}

/// True where parallel lines are one.
fn same([a, b]: [Line; 2]) -> bool {
    let [x, y] = [a, b].map(|line| [line.output, line.input, line.right]);
    let size = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
    let off = (0..3).map(|k| x[k] * y[(k + 1) % 3] - x[(k + 1) % 3] * y[k]);
    off.fold(0.0, |most: f64, off| most.max(off.abs())) <= 1e-13 * size(x) * size(y)
}
