//! Three positions: Freudenstein's equation, two lines in (1/z₂, 1/z₃) and their intersection.

use super::{Line, Proportions, Solution, Task, TwoPositions};
use crate::numeric::max_abs;
use crate::tolerance;

/// Exact linkages through three positions.
#[derive(Clone, Debug, PartialEq)]
pub enum ThreePositions {
    /// Exactly one linkage.
    One(Solution),
    /// One length or both are negative at the intersection of the two lines. Adding half a turn to the angles of each
    /// link of negative length gives a linkage.
    Negative {
        /// z₂.
        output: f64,
        /// z₃.
        input: f64,
    },
    /// No linkage, with the two lines: they are parallel, or meet where a length is infinite or the coupler's is zero.
    None([Line; 2]),
    /// The positions give only one line. The solutions for two of the positions satisfy all three.
    Same(TwoPositions),
}

impl ThreePositions {
    /// The linkages through the first three positions of a task; none if there are fewer.
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
        // If all coefficients of one line are zero, the other line remains.
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

/// True if parallel lines coincide.
fn same([a, b]: [Line; 2]) -> bool {
    let [x, y] = [a, b].map(|line| [line.output, line.input, line.right]);
    let size = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
    let off = (0..3).map(|k| x[k] * y[(k + 1) % 3] - x[(k + 1) % 3] * y[k]);
    max_abs(off) <= tolerance::NEGLIGIBLE * size(x) * size(y)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::synthesis::four_bar::{Frame, Position};

    /// Three poses of a four-bar with crank 1, coupler 4, rocker 3 and frame 4, from triangles: crank and coupler
    /// outstretched (3-4-5), folded (3-3-4), and the crank opposite to the frame (diagonal 5). φ₂ points from the
    /// rocker's joint to its pivot.
    #[test]
    fn from_triangles() {
        let poses = [
            (0.75_f64.atan(), FRAC_PI_2),
            (PI + (2.0_f64 / 3.0).acos(), (-2.0_f64 / 3.0).acos()),
            (PI, PI - (4.0_f64 / 3.0).atan()),
        ];
        let positions = poses.map(|(input, rocker)| Position::new(rocker + PI, input));
        let frame = Frame {
            length: 4.0,
            angle: 0.0,
        };
        let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
        let Some(ThreePositions::One(found)) = ThreePositions::new(&task) else {
            panic!("not one")
        };
        let lengths = found.proportions.lengths(4.0);
        for (length, expected) in lengths.into_iter().zip([1.0, 4.0, 3.0, 4.0]) {
            assert!((length - expected).abs() < 1e-13, "{lengths:?}");
        }
        assert!(found.worst_residual() < 1e-14);
    }

    fn found(positions: [[f64; 2]; 3], turned: f64) -> ThreePositions {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let positions = positions.map(|[output, input]| Position::new(output + turned, input));
        let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
        ThreePositions::new(&task).unwrap()
    }

    /// The output's angles of [`from_triangles`], given from pivot to joint: z₂ is −3/4, and z₃ is 1/4.
    #[test]
    fn an_output_given_in_the_opposite_direction_has_a_negative_length() {
        let positions = [
            [FRAC_PI_2, 0.75_f64.atan()],
            [(-2.0_f64 / 3.0).acos(), PI + (2.0_f64 / 3.0).acos()],
            [PI - (4.0_f64 / 3.0).atan(), PI],
        ];
        let ThreePositions::Negative { output, input } = found(positions, 0.0) else {
            panic!("not negative")
        };
        assert!((output + 0.75).abs() < 1e-13 && (input - 0.25).abs() < 1e-13);
        let ThreePositions::One(solution) = found(positions, PI) else {
            panic!("not one")
        };
        assert!((solution.proportions.coupler - 1.0).abs() < 1e-13);
    }

    /// A position and its mirror image in the frame have equal gaps whatever the lengths: only one line is left.
    #[test]
    fn a_mirrored_position_adds_no_condition() {
        let positions = [[1.0, 0.5], [-1.0, -0.5], [2.0, 1.2]];
        assert!(matches!(found(positions, 0.0), ThreePositions::Same(_)));
    }

    /// If φ₃ is 90° in all positions, Freudenstein's equation is v cos φ₂ = sin φ₂ + constant, with v = 1/z₃. Its
    /// differences for φ₂ = 0°, 90° and 180° are v = −1 and 2v = 0, which contradict each other.
    #[test]
    fn parallel_lines_leave_no_linkage() {
        let positions = [[0.0, FRAC_PI_2], [FRAC_PI_2, FRAC_PI_2], [PI, FRAC_PI_2]];
        let ThreePositions::None(lines) = found(positions, 0.0) else {
            panic!("not none")
        };
        for (line, [input, right]) in lines.into_iter().zip([[1.0, -1.0], [2.0, 0.0]]) {
            assert_eq!(line.output, 0.0);
            assert!((line.input - input).abs() < 1e-15 && (line.right - right).abs() < 1e-15);
        }
    }
}
