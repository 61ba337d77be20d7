//! The signed root of a dyad around a change point, by Hermite interpolation.
//!
//! The closed form of a dyad takes the square root of a quantity, called the square here. At a change point the
//! square touches zero, and near this point its root loses digits. In the smooth motion the root changes sign; a
//! polynomial that matches the root's derivatives at three nodes has all digits.

use crate::Jet;
use crate::index::StepId;

/// Number of Taylor coefficients of the square at each node.
pub(crate) const KNOWN: usize = 6;
/// Number of Taylor coefficients of root/u at the change point, with u as in [`SmoothRoot`]. The first two coefficients
/// of the square are zero at this point.
const KNOWN_AT_CHANGE: usize = KNOWN - 2;
/// Newton's divided differences, one for each coefficient at the three nodes.
type Differences = [f64; KNOWN_AT_CHANGE + 2 * KNOWN];

/// The signed root of a step of the plan around a change point.
#[derive(Clone, Debug)]
pub(crate) struct SmoothRoot {
    pub(crate) step: StepId,
    /// The input of the change point.
    pub(crate) input: f64,
    /// Distance from the change point to the nodes before and after it.
    radius: f64,
    /// Divided differences of root/u, with u = (input − change point) / radius.
    differences: Differences,
}

impl SmoothRoot {
    /// Taylor series of the root at the change point, from the square there (`at`). It serves for inputs close to the
    /// change point.
    pub(crate) fn beside(
        (step, sign): (StepId, f64),
        [input, radius]: [f64; 2],
        at: Jet<KNOWN>,
    ) -> Self {
        let root = root_over_u(at, radius);
        let known = |order: usize| {
            if order < KNOWN_AT_CHANGE {
                sign * root.coefficient(order)
            } else {
                0.0
            }
        };
        Self {
            step,
            input,
            radius,
            differences: std::array::from_fn(known),
        }
    }

    /// Hermite interpolation from the square and its derivatives at the change point and at `radius` before and after
    /// it. `sign` is the sign of the root after the change point.
    pub(crate) fn new(
        (step, sign): (StepId, f64),
        [input, radius]: [f64; 2],
        [before, at, after]: [Jet<KNOWN>; 3],
    ) -> Self {
        let at = root_over_u(at, radius);
        let aside =
            |square: Jet<KNOWN>, u: f64| in_u(square, radius).sqrt() * u / Jet::linear(u, 1.0);
        let [before, after] = [aside(before, -1.0), aside(after, 1.0)];
        let known = |k: usize, order: usize| match node(k) {
            0.0 => at.coefficient(order),
            1.0 => after.coefficient(order),
            _ => before.coefficient(order),
        };
        Self {
            step,
            input,
            radius,
            differences: divided(known).map(|difference| sign * difference),
        }
    }

    /// The same root, with its change point moved to an input greater by `shift`.
    pub(crate) fn shifted(&self, shift: f64) -> Self {
        let input = self.input + shift;
        Self {
            input,
            ..self.clone()
        }
    }

    /// True if the interpolation is valid at an input.
    pub(crate) fn covers(&self, input: f64) -> bool {
        (input - self.input).abs() <= 0.5 * self.radius
    }

    /// The signed root at an input.
    pub(crate) fn at<const N: usize>(&self, input: Jet<N>) -> Jet<N> {
        let u = (input + -self.input) * self.radius.recip();
        let terms = self.differences.iter().enumerate().rev();
        let over_u = terms.fold(Jet::constant(0.0), |sum, (k, difference)| {
            sum * (u + -node(k)) + *difference
        });
        u * over_u
    }
}

/// Converts a series in the input into a series in u.
fn in_u(square: Jet<KNOWN>, radius: f64) -> Jet<KNOWN> {
    let mut power = 1.0;
    Jet::from_coefficients(std::array::from_fn(|order| {
        let coefficient = square.coefficient(order) * power;
        power *= radius;
        coefficient
    }))
}

/// Series of root/u, from a square that has the factor u².
fn root_over_u(square: Jet<KNOWN>, radius: f64) -> Jet<KNOWN_AT_CHANGE> {
    let square = in_u(square, radius);
    let rest = std::array::from_fn(|order| square.coefficient(order + KNOWN - KNOWN_AT_CHANGE));
    Jet::from_coefficients(rest).sqrt()
}

/// Nodes in u, each repeated once for every coefficient known at it. The change point is first, so that in Newton's
/// polynomial the terms of the other nodes have the factor u⁴, which is small near the change point.
fn node(k: usize) -> f64 {
    if k < KNOWN_AT_CHANGE {
        0.0
    } else if k < KNOWN_AT_CHANGE + KNOWN {
        1.0
    } else {
        -1.0
    }
}

/// Newton's divided differences, from the Taylor coefficients at the nodes.
fn divided(known: impl Fn(usize, usize) -> f64) -> Differences {
    let mut table: Differences = std::array::from_fn(|k| known(k, 0));
    for order in 1..table.len() {
        for k in (order..table.len()).rev() {
            let width = node(k) - node(k - order);
            table[k] = if width == 0.0 {
                known(k, order)
            } else {
                (table[k] - table[k - 1]) / width
            };
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::SmoothRoot;
    use crate::Jet;
    use crate::index::StepId;

    /// The signed root x(1 + x) of x²(1 + x)²: at x = 0.1 it is 0.11, and its derivative 1 + 2x is 1.2.
    #[test]
    fn a_root_through_zero() {
        let square = |x: f64| {
            let x = Jet::linear(x, 1.0);
            (x * (x + 1.0)).square()
        };
        let nodes = [-0.25, 0.0, 0.25].map(square);
        let root = SmoothRoot::new((StepId::FIRST, 1.0), [0.0, 0.25], nodes);
        for (input, value, derivative) in [(0.1, 0.11, 1.2), (-0.1, -0.09, 0.8), (0.0, 0.0, 1.0)] {
            let found = root.at(Jet::<2>::linear(input, 1.0));
            assert!(root.covers(input) && !root.covers(0.2));
            assert!((found.value() - value).abs() < 1e-14, "{found:?}");
            assert!(
                (found.derivative(1) - derivative).abs() < 1e-13,
                "{found:?}"
            );
        }
    }

    /// The root of (x − 2)² is x − 2 or, with the other sign, 2 − x. The interpolation is valid up to half of the
    /// distance of the nodes.
    #[test]
    fn the_root_keeps_its_sign_after_the_change_point() {
        let square = |x: f64| Jet::linear(x - 2.0, 1.0).square();
        for sign in [1.0, -1.0] {
            let nodes = [1.5, 2.0, 2.5].map(square);
            let root = SmoothRoot::new((StepId::FIRST, sign), [2.0, 0.5], nodes);
            for x in [1.8, 2.0, 2.1] {
                let found = root.at(Jet::<3>::linear(x, 1.0));
                assert!(
                    (found.value() - sign * (x - 2.0)).abs() < 1e-15,
                    "{found:?}"
                );
                assert!((found.derivative(1) - sign).abs() < 1e-14, "{found:?}");
                assert!(found.derivative(2).abs() < 1e-13, "{found:?}");
            }
            assert!(root.covers(2.25) && !root.covers(2.26));
            let shifted = root.shifted(1.0);
            assert!(shifted.covers(3.25) && !shifted.covers(2.25));
            assert!((shifted.at(Jet::<1>::constant(3.1)).value() - sign * 0.1).abs() < 1e-15);
        }
    }

    /// The series of root/u at the change point has four terms. For the root x(1 + x) two terms suffice.
    #[test]
    fn a_series_at_the_change_point_alone() {
        let x = Jet::linear(0.0, 1.0);
        let root = SmoothRoot::beside((StepId::FIRST, -1.0), [0.0, 0.5], (x * (x + 1.0)).square());
        for (input, value) in [(0.01, -0.0101), (-0.01, 0.0099), (0.0, 0.0)] {
            let found = root.at(Jet::<1>::constant(input)).value();
            assert!((found - value).abs() < 1e-16, "{found}");
        }
    }
}
