//! Levitsky's quadratic approximation: least squares of Freudenstein's equations.
//!
//! Let z₁, z₂, z₃ be the lengths of coupler, output and input relative to the frame, φ₂ and φ₃ the angles of output and
//! input, and |r| the gap left for the coupler, so J = (|r| − z₁)². Levitsky's weighted difference is q = |r|² − z₁² =
//! (|r| − z₁)(|r| + z₁). The residual of Freudenstein's equation cos(φ₂ − φ₃) = Z + cos φ₂/z₃ + cos φ₃/z₂, with Z =
//! (z₁² − z₂² − z₃² − 1)/(2z₂z₃), is q/(2z₂z₃). So the sum of the squared residuals is ΣwJ with the weights w = ((|r| +
//! z₁)/(2z₂z₃))². For three positions ΣJ and ΣwJ are both zero, at the same linkage. For more positions the weights
//! differ little from position to position if J is small, and the minima of ΣJ and ΣwJ differ by the order of J.

use crate::numeric::linear::least_squares;
use crate::synthesis::four_bar::{Proportions, Task};

/// Finds the proportions with the least sum of squared residuals, with the weights of the task: a linear problem in Z,
/// 1/z₃ and 1/z₂. None if a length is not positive or is not determined by the positions.
pub fn weighted_difference(task: &Task) -> Option<Proportions> {
    let equations = task.directions([0.0; 2]).zip(task.positions());
    let rows = equations.map(|(at, position)| {
        let value = (at.output * at.input.conj()).re;
        let weight = position.weight.sqrt();
        let row = [1.0, at.output.re, at.input.re].map(|x| x * weight);
        (row, value * weight)
    });
    let rows: Vec<_> = rows.collect();
    let [z, v, u] = least_squares(&rows)?;
    let [output, input] = [u.recip(), v.recip()];
    let square = 1.0 + output * output + input * input + 2.0 * output * input * z;
    let sound = |x: f64| x > 0.0 && x.is_finite();
    [output, input, square]
        .into_iter()
        .all(sound)
        .then(|| Proportions {
            coupler: square.sqrt(),
            output,
            input,
        })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::synthesis::four_bar::{Frame, Position};

    fn task(positions: &[Position]) -> Task {
        let frame = Frame {
            length: 4.0,
            angle: 0.0,
        };
        Task::new(frame, positions, Task::RATIOS).unwrap()
    }

    /// Poses of the four-bar 1, 4, 3, 4 from triangles 3-4-5, 3-3-4 and 3-4-5 (crank at 180°), and the second of them
    /// mirrored in the frame: exact positions are met whatever their weights.
    #[test]
    fn exact_positions_give_the_linkage_back() {
        let poses = [
            (0.75_f64.atan(), FRAC_PI_2),
            (PI + (2.0_f64 / 3.0).acos(), (-2.0_f64 / 3.0).acos()),
            (PI, PI - (4.0_f64 / 3.0).atan()),
            (-PI - (2.0_f64 / 3.0).acos(), -(-2.0_f64 / 3.0).acos()),
        ];
        for weights in [[1.0; 4], [1.0, 5.0, 0.1, 2.0]] {
            let mut positions = poses.map(|(input, rocker)| Position::new(rocker + PI, input));
            for (position, weight) in positions.iter_mut().zip(weights) {
                position.weight = weight;
            }
            let found = weighted_difference(&task(&positions)).unwrap();
            for (z, expected) in found.z().into_iter().zip([1.0, 0.75, 0.25]) {
                assert!((z - expected).abs() < 1e-13, "{found:?}");
            }
        }
    }

    /// In a parallelogram cos φ₂ = −cos φ₃, so only the difference of 1/z₃ and 1/z₂ is determined.
    #[test]
    fn positions_of_a_parallelogram_do_not_determine_its_lengths() {
        let positions = [0.3, 0.9, 1.4, 2.0].map(|input| Position::new(input + PI, input));
        assert_eq!(weighted_difference(&task(&positions)), None);
    }

    /// An output given from pivot to joint would need a negative length.
    #[test]
    fn a_negative_length_is_no_solution() {
        let poses = [
            (0.75_f64.atan(), FRAC_PI_2),
            (PI + (2.0_f64 / 3.0).acos(), (-2.0_f64 / 3.0).acos()),
            (PI, PI - (4.0_f64 / 3.0).atan()),
        ];
        let positions = poses.map(|(input, rocker)| Position::new(rocker, input));
        assert_eq!(weighted_difference(&task(&positions)), None);
    }
}
