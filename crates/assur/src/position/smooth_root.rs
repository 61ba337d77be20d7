//! Where the links of a dyad pass through in line, at a change point, the square that its closed form takes the root of
//! touches zero, and the root has few digits left around it. In the smooth motion the root goes through zero with the
//! other sign, and is as exact as the square: a polynomial tells it there.

use crate::Jet;
use crate::index::StepId;

/// How many Taylor coefficients of the square are taken at each node.
pub(crate) const KNOWN: usize = 6;
/// How many of root/u are known at the change point: the first two of the square are zero.
const AT: usize = KNOWN - 2;
/// Conditions in all.
const CONDITIONS: usize = AT + 2 * KNOWN;

/// The signed root of a step of the plan around a change point.
#[derive(Clone, Debug)]
pub(crate) struct SmoothRoot {
    pub(crate) step: StepId,
    /// The input of the change point.
    pub(crate) input: f64,
    /// How far before and after it the outer nodes are.
    reach: f64,
    /// Newton's divided differences of root/u, u being the way from the change point by `reach`.
    differences: [f64; CONDITIONS],
}

impl SmoothRoot {
    /// Taylor's series by what is known at the change point, which serves close to it.
    pub(crate) fn beside(
        (step, sign): (StepId, f64),
        [input, reach]: [f64; 2],
        at: Jet<KNOWN>,
    ) -> Self {
        let root = root_over_u(at, reach);
        let known = |order: usize| {
            if order < AT {
                sign * root.coefficient(order)
            } else {
                0.0
            }
        };
        Self {
            step,
            input,
            reach,
            differences: std::array::from_fn(known),
        }
    }

    /// Hermite's interpolation between what is known at the change point and by `reach` before and after it: the
    /// square with its derivatives. `sign` is that of the root after the change point.
    pub(crate) fn new(
        (step, sign): (StepId, f64),
        [input, reach]: [f64; 2],
        [before, at, after]: [Jet<KNOWN>; 3],
    ) -> Self {
        let at = root_over_u(at, reach);
        let aside = |square: Jet<KNOWN>, u: f64| {
            by_u(square, reach).sqrt() * (Jet::linear(u, 1.0).recip() * u)
        };
        let [before, after] = [aside(before, -1.0), aside(after, 1.0)];
        let known = |k: usize, order: usize| match node(k) {
            0.0 => at.coefficient(order),
            1.0 => after.coefficient(order),
            _ => before.coefficient(order),
        };
        Self {
            step,
            input,
            reach,
            differences: divided(known).map(|difference| sign * difference),
        }
    }

    /// The same told by an input that is greater by this.
    pub(crate) fn shifted(&self, by: f64) -> Self {
        let input = self.input + by;
        Self {
            input,
            ..self.clone()
        }
    }

    /// Whether it tells of an input.
    pub(crate) fn covers(&self, input: f64) -> bool {
        (input - self.input).abs() <= 0.5 * self.reach
    }

    /// The signed root at an input.
    pub(crate) fn at<const N: usize>(&self, input: Jet<N>) -> Jet<N> {
        let u = (input + -self.input) * self.reach.recip();
        let terms = self.differences.iter().enumerate().rev();
        let over_u = terms.fold(Jet::constant(0.0), |sum, (k, difference)| {
            sum * (u + -node(k)) + *difference
        });
        u * over_u
    }
}

/// What is known by the input, by u.
fn by_u(square: Jet<KNOWN>, reach: f64) -> Jet<KNOWN> {
    let mut power = 1.0;
    Jet::from_coefficients(std::array::from_fn(|order| {
        let coefficient = square.coefficient(order) * power;
        power *= reach;
        coefficient
    }))
}

/// The root of a square with the factor u².
fn root_over_u(square: Jet<KNOWN>, reach: f64) -> Jet<AT> {
    let square = by_u(square, reach);
    let rest = std::array::from_fn(|order| square.coefficient(order + KNOWN - AT));
    Jet::from_coefficients(rest).sqrt()
}

/// The nodes by u, each as often as coefficients are known at it. Those of the change point come first: near it the
/// differences with the others hardly count.
fn node(k: usize) -> f64 {
    if k < AT {
        0.0
    } else if k < AT + KNOWN {
        1.0
    } else {
        -1.0
    }
}

/// Newton's divided differences of what is known at the nodes by its Taylor coefficients.
fn divided(known: impl Fn(usize, usize) -> f64) -> [f64; CONDITIONS] {
    let mut table = std::array::from_fn(|k| known(k, 0));
    for order in 1..CONDITIONS {
        for k in (order..CONDITIONS).rev() {
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
