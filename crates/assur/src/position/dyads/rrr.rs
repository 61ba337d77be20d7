//! The dyad RRR: two links hinged to each other and to two solved points.

use crate::index::{BodyId, StepId};
use crate::position::complex::Complex;
use crate::position::{
    Arm, CLOSE, CLOSE_SQUARED, Cause, CrankFourBar, Dead, Enclosure, Predictor, Singularity,
    Solvable, State, StepContext, clear,
};
use crate::{Jet, Vector, tolerance};

/// Links i and j are joined at C; i is hinged at B, and j at D.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rrr {
    pub(crate) arms: [Arm; 2],
    /// Four-bar with i as coupler and j as rocker, if i is hinged to the driven crank and j to the frame. The sign of a
    /// four-bar stays the same at change points.
    pub(crate) four_bar: Option<CrankFourBar>,
}

/// The triangle BCD of two arms, with their joint C on either side of BD.
pub(in crate::position) struct Triangle<const N: usize> {
    b: Complex<N>,
    d: Complex<N>,
    diagonal: Complex<N>,
    /// r² = |BD|².
    square: Jet<N>,
    /// Sum l₂ + l₃ of the lengths of the arms; `difference` is l₂ − l₃.
    sum: f64,
    difference: f64,
    /// The margins P = (l₂ + l₃)² − r² and Q = r² − (l₂ − l₃)².
    pub(in crate::position) margins: [Jet<N>; 2],
}

impl<const N: usize> Triangle<N> {
    #[inline(always)]
    pub(in crate::position) fn of(state: &State<N>, [i, j]: &[Arm; 2]) -> Self {
        let [l2, l3] = [i.length(), j.length()];
        let [b, d] = [state.place(i.outer), state.place(j.outer)];
        let diagonal = d - b;
        let square = diagonal.norm_squared();
        let (sum, difference) = (l2 + l3, l2 - l3);
        let margins = [-square + sum * sum, square + -(difference * difference)];
        Self {
            b,
            d,
            diagonal,
            square,
            sum,
            difference,
            margins,
        }
    }

    /// √(P Q) of the margins P and Q, positive for C to the left of BD (`side` 1) and negative for C to its right (−1).
    #[inline(always)]
    pub(in crate::position) fn root(&self, side: f64) -> Jet<N> {
        let [p, q] = self.margins;
        (p * q).sqrt() * side
    }

    /// Places both arms from the root √(P Q).
    ///
    /// Let d = D − B, r = |d|, and let l₂ and l₃ be the lengths BC and CD. Then C − B = d (a + 2iσS) / r² with
    /// a = (r² + l₂² − l₃²)/2. S is the area of the triangle BCD, with 16 S² = P Q, and σ is the sign of the side.
    #[inline(always)]
    pub(in crate::position) fn lay(&self, state: &mut State<N>, [i, j]: &[Arm; 2], root: Jet<N>) {
        let along = (self.square + (self.sum * self.difference)) * 0.5;
        let to_c = self.diagonal * Complex::new(along, root * 0.5);
        let mut to_c = to_c.over(self.square);
        let scale = self.sum * self.sum;
        // Nearly in line, the constant length hardly determines the derivatives of C, so the derivatives from `root`
        // are kept.
        let is_in_line = root.value().powi(2) < CLOSE_SQUARED * self.square.value() * scale;
        if self.square.value() < CLOSE_SQUARED * scale && !is_in_line {
            to_c = Complex::of_constant_length(to_c.value(), self.diagonal, along);
        }
        state.lay(i, self.b, self.leg(i, to_c));
        state.lay(j, self.d, self.leg(j, to_c - self.diagonal));
    }

    /// Places two arms of equal length from the unit vector û of BD, which has a limit where B and D coincide:
    /// C − B = d/2 + i û √P/2. For C to the right of BD, û is opposite to BD.
    fn lay_on(&self, state: &mut State<N>, [i, j]: &[Arm; 2], direction: Complex<N>) {
        let half = self.diagonal.by(Vector::new(0.5, 0.0));
        let across = direction.left().scaled(self.margins[0].sqrt() * 0.5);
        state.lay(i, self.b, across + half);
        state.lay(j, self.d, across - half);
    }

    /// Vector of an arm between its hinges. If the other arm is much longer, only the direction of `along` is exact,
    /// and `along` is scaled to the length of the arm.
    #[inline(always)]
    fn leg(&self, arm: &Arm, along: Complex<N>) -> Complex<N> {
        if arm.length() < CLOSE * self.sum {
            along.unit().by(Vector::new(arm.length(), 0.0))
        } else {
            along
        }
    }
}

/// Scales of the rounding errors of P and Q. The base r has an error δ proportional to s = l₂ + l₃. Near r = s this
/// error changes P by s δ. Near r = |l₂ − l₃|, which may be much shorter, it changes Q by |l₂ − l₃| δ + δ².
fn scales(sum: f64, difference: f64) -> [f64; 2] {
    [sum, difference.abs() + tolerance::CONVERGED * sum].map(|length| sum * length)
}

impl Solvable for Rrr {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let triangle = Triangle::of(state, &self.arms);
        let Triangle {
            square,
            sum,
            difference,
            margins: [p, q],
            ..
        } = triangle;
        state.margins[context.step] = [p, q];
        if let Some(four_bar) = &self.four_bar {
            return four_bar.place(&self.arms, state, context, &triangle);
        }
        let smooth = context.smooth_root();
        if let Some(base) = smooth.and_then(|smooth| smooth.base_over_u(context.input)) {
            triangle.lay_on(state, &self.arms, base.unit());
            return Ok(());
        }
        if square.value() <= f64::EPSILON * f64::EPSILON * sum * sum {
            return Err(Cause::Undetermined);
        }
        let distance = square.value().sqrt();
        let beyond = |dead: Dead, by: f64| match dead {
            Dead::At => Cause::DeadPoint,
            Dead::Beyond => Cause::Apart { by },
        };
        let root = match smooth {
            Some(smooth) => smooth.at(context.input),
            None => {
                let [of_p, of_q] = scales(sum, difference);
                let far = clear(p, of_p).map_err(|dead| beyond(dead, distance - sum))?;
                let near =
                    clear(q, of_q).map_err(|dead| beyond(dead, difference.abs() - distance))?;
                if far && near {
                    triangle.root(context.sign.factor())
                } else {
                    Jet::constant(0.0)
                }
            }
        };
        triangle.lay(state, &self.arms, root);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        cell.enclose_arms(from, &self.arms)
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.arms.each_ref().map(|arm| arm.body).into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.arms.iter().any(|arm| arm.outer.body == body)
    }

    fn tracks_turns(&self) -> bool {
        self.four_bar.is_none()
    }

    fn passes_change_point(&self) -> bool {
        self.four_bar.is_none()
    }

    fn singularity(&self) -> Singularity {
        Singularity::InLine
    }

    fn square<const N: usize>(&self, [p, q]: [Jet<N>; 2]) -> Jet<N> {
        p * q
    }

    fn base<const N: usize>(&self, state: &State<N>) -> Option<Complex<N>> {
        let Triangle {
            diagonal,
            sum,
            difference,
            ..
        } = Triangle::of(state, &self.arms);
        let equal = self.four_bar.is_none() && difference.abs() <= tolerance::CONVERGED * sum;
        equal.then_some(diagonal)
    }

    fn scales(&self) -> [f64; 2] {
        let [l2, l3] = self.arms.each_ref().map(Arm::length);
        scales(l2 + l3, l2 - l3)
    }
}
