//! The signed root of a dyad around a change point, by Hermite interpolation.
//!
//! The closed form of a dyad takes the square root of a quantity, called the square here. At a change point the
//! square touches zero, and near this point its root loses digits. In the smooth motion the root changes sign; a
//! polynomial that matches the root's derivatives at three nodes has all digits.
//!
//! If the two links of a dyad RRR are equally long, its outer hinges may coincide at the change point. The vector
//! between them, the base, has a simple zero there. Divided by the input from the change point it keeps a direction,
//! and the links are placed by this direction.

use super::Complex;
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
    /// Divided differences of x/u and y/u of the base, if it vanishes at the change point; with the sign of the root.
    base: Option<[Differences; 2]>,
}

/// Taylor series of a dyad at a node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    /// The quantity under the root.
    pub(crate) square: Jet<KNOWN>,
    /// The base, if it vanishes at the change point.
    pub(crate) base: Option<Complex<KNOWN>>,
}

impl Node {
    fn bases(&self) -> Option<[Jet<KNOWN>; 2]> {
        self.base.map(|base| [base.x(), base.y()])
    }
}

impl SmoothRoot {
    /// Smooth root from its Taylor series at the change point, which follows from the series `at` this point. It is
    /// valid for inputs close to the change point.
    pub(crate) fn beside((step, sign): (StepId, f64), [input, radius]: [f64; 2], at: Node) -> Self {
        let series = |over_u: Jet<KNOWN_AT_CHANGE>| -> Differences {
            std::array::from_fn(|order| match order < KNOWN_AT_CHANGE {
                true => sign * over_u.coefficient(order),
                false => 0.0,
            })
        };
        let base = at.bases();
        Self {
            step,
            input,
            radius,
            differences: series(root_over_u(at.square, radius)),
            base: base.map(|xy| xy.map(|of| series(over_u(of, radius)))),
        }
    }

    /// Smooth root by Hermite interpolation from the series at the change point and at `radius` before and after it.
    /// `sign` is the sign of the root after the change point.
    pub(crate) fn new(
        (step, sign): (StepId, f64),
        [input, radius]: [f64; 2],
        nodes: [Node; 3],
    ) -> Self {
        let signed = |at: Jet<KNOWN_AT_CHANGE>, [before, after]: [Jet<KNOWN>; 2]| {
            let known = |k: usize, order: usize| match node(k) {
                0.0 => at.coefficient(order),
                1.0 => after.coefficient(order),
                _ => before.coefficient(order),
            };
            divided(known).map(|difference| sign * difference)
        };
        let aside = |of: Jet<KNOWN>, u: f64| of / Jet::linear(u, 1.0);
        let root = |node: Node, u: f64| aside(in_u(node.square, radius).sqrt() * u, u);
        let [before, at, after] = nodes;
        let bases = nodes.map(|node| node.bases());
        let base = match bases {
            [Some(before), Some(at), Some(after)] => Some([0, 1].map(|axis: usize| {
                let aside = |of: [Jet<KNOWN>; 2], u: f64| aside(in_u(of[axis], radius), u);
                let beside = [aside(before, -1.0), aside(after, 1.0)];
                signed(over_u(at[axis], radius), beside)
            })),
            _ => None,
        };
        Self {
            step,
            input,
            radius,
            differences: signed(
                root_over_u(at.square, radius),
                [root(before, -1.0), root(after, 1.0)],
            ),
            base,
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
        let u = self.u(input);
        u * newton(&self.differences, u)
    }

    /// True if the outer hinges of the dyad coincide at the change point.
    pub(crate) fn has_base(&self) -> bool {
        self.base.is_some()
    }

    /// The base at an input divided by u, with the sign of the root after the change point; None if it does not vanish
    /// at the change point.
    pub(crate) fn base_over_u<const N: usize>(&self, input: Jet<N>) -> Option<Complex<N>> {
        let u = self.u(input);
        let [x, y] = self.base.as_ref()?;
        Some(Complex::new(newton(x, u), newton(y, u)))
    }

    fn u<const N: usize>(&self, input: Jet<N>) -> Jet<N> {
        (input + -self.input) * self.radius.recip()
    }
}

/// Value of Newton's polynomial.
fn newton<const N: usize>(differences: &Differences, u: Jet<N>) -> Jet<N> {
    let terms = differences.iter().enumerate().rev();
    terms.fold(Jet::constant(0.0), |sum, (k, difference)| {
        sum * (u + -node(k)) + *difference
    })
}

/// Converts a series in the input into a series in u.
fn in_u(series: Jet<KNOWN>, radius: f64) -> Jet<KNOWN> {
    let mut power = 1.0;
    Jet::from_coefficients(std::array::from_fn(|order| {
        let coefficient = series.coefficient(order) * power;
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

/// Series of a quantity divided by u, if the quantity has the factor u.
fn over_u(of: Jet<KNOWN>, radius: f64) -> Jet<KNOWN_AT_CHANGE> {
    let of = in_u(of, radius);
    Jet::from_coefficients(std::array::from_fn(|order| of.coefficient(order + 1)))
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
    use super::{Node, SmoothRoot};
    use crate::index::StepId;
    use crate::position::Complex;
    use crate::{Jet, Vector};

    fn square(square: Jet<6>) -> Node {
        let base = None;
        Node { square, base }
    }

    /// The signed root x(1 + x) of x²(1 + x)²: at x = 0.1 it is 0.11, and its derivative 1 + 2x is 1.2.
    #[test]
    fn a_root_through_zero() {
        let nodes = [-0.25, 0.0, 0.25].map(|x| {
            let x = Jet::linear(x, 1.0);
            square((x * (x + 1.0)).square())
        });
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
        for sign in [1.0, -1.0] {
            let nodes = [1.5, 2.0, 2.5].map(|x| square(Jet::linear(x - 2.0, 1.0).square()));
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
        let at = square((x * (x + 1.0)).square());
        let root = SmoothRoot::beside((StepId::FIRST, -1.0), [0.0, 0.5], at);
        assert!(!root.has_base() && root.base_over_u(x).is_none());
        for (input, value) in [(0.01, -0.0101), (-0.01, 0.0099), (0.0, 0.0)] {
            let found = root.at(Jet::<1>::constant(input)).value();
            assert!((found - value).abs() < 1e-16, "{found}");
        }
    }

    /// The base (x, x²) has the direction (1, x)/√(1 + x²) after the change point at 0, and as (base/u)/|base/u| also
    /// before it. With the radius 0.5, base/u is (0.5, 0.5 x).
    #[test]
    fn a_base_through_zero_keeps_its_direction() {
        let at = |x: f64| {
            let x = Jet::linear(x, 1.0);
            let base = Complex::new(x, x.square());
            Node {
                square: base.norm_squared(),
                base: Some(base),
            }
        };
        let whole = SmoothRoot::new((StepId::FIRST, 1.0), [0.0, 0.5], [-0.5, 0.0, 0.5].map(at));
        let near = SmoothRoot::beside((StepId::FIRST, -1.0), [0.0, 0.5], at(0.0));
        for (root, sign) in [(whole, 1.0), (near, -1.0)] {
            assert!(root.has_base());
            for x in [-0.2, -1e-9, 0.0, 1e-9, 0.2] {
                let found = root.base_over_u(Jet::<2>::linear(x, 1.0)).unwrap();
                for (order, expected) in [[0.5, 0.5 * x], [0.0, 0.5]].into_iter().enumerate() {
                    let off = found[order] - Vector::from(expected) * sign;
                    assert!(off.norm() < 1e-14, "{x}, {order}: {found:?}");
                }
            }
        }
    }
}
