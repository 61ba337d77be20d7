//! The dyad RRR: two links hinged on each other and on two solved points.

use super::complex::Complex;
use super::{Arm, Cause, Dead, Given, Solvable, State, clear};
use crate::Jet;
use crate::index::BodyId;

/// Links i and j with the joint C between them, i hinged at B, j at D.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rrr {
    pub(crate) arms: [Arm; 2],
}

/// Lays both arms with the joint to the left of BD (1), to its right (−1), or on it (0); P
/// and Q as of [`Rrr`].
pub(super) fn lay<const N: usize>(
    state: &mut State<N>,
    [i, j]: &[Arm; 2],
    [p, q]: [Jet<N>; 2],
    side: f64,
) {
    let [l2, l3] = [i.length(), j.length()];
    let [b, d] = [state.place(i.outer), state.place(j.outer)];
    let diagonal = d - b;
    let square = diagonal.norm_squared();
    let along = (square + ((l2 + l3) * (l2 - l3))) * 0.5;
    let across = if side == 0.0 {
        Jet::constant(0.0)
    } else {
        (p * q).sqrt() * (0.5 * side)
    };
    let to_c = (diagonal * Complex::new(along, across)).scaled(square.recip());
    state.lay(i, b, to_c);
    state.lay(j, d, to_c - diagonal);
}

impl Solvable for Rrr {
    /// With d = D − B and r = |d|: C − B = d (a + 2iσS) / r², a = (r² + l₂² − l₃²)/2
    /// and 16 S² = P Q, P = (l₂ + l₃)² − r², Q = r² − (l₂ − l₃)², S the area of BCD.
    /// The sign σ is that of S: C to the left of BD or to its right.
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        let [i, j] = &self.arms;
        let [l2, l3] = [i.length(), j.length()];
        let [b, d] = [state.place(i.outer), state.place(j.outer)];
        let diagonal = d - b;
        let square = diagonal.norm_squared();
        let (sum, difference) = (l2 + l3, l2 - l3);
        let p = -square + sum * sum;
        let q = square + -(difference * difference);
        state.margins[given.step] = [p, q];
        let scale = sum * sum;
        if square.value() <= f64::EPSILON * f64::EPSILON * scale {
            return Err(Cause::Undetermined);
        }
        let distance = square.value().sqrt();
        let beyond = |dead: Dead, by: f64| match dead {
            Dead::At => Cause::DeadPoint,
            Dead::Beyond => Cause::Apart { by },
        };
        let far = clear(p, scale).map_err(|dead| beyond(dead, distance - sum))?;
        let near = clear(q, scale).map_err(|dead| beyond(dead, difference.abs() - distance))?;
        let side = if far && near {
            given.sign.factor()
        } else {
            0.0
        };
        lay(state, &self.arms, [p, q], side);
        Ok(())
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.arms.each_ref().map(|arm| arm.body).into_iter()
    }

    fn rests_on(&self, body: BodyId) -> bool {
        self.arms.iter().any(|arm| arm.outer.body == body)
    }

    fn has_sign(&self) -> bool {
        true
    }

    fn passes(&self) -> bool {
        true
    }

    fn stretches_and_folds(&self) -> bool {
        true
    }

    fn scale(&self) -> f64 {
        let [i, j] = &self.arms;
        (i.length() + j.length()).powi(2)
    }
}
