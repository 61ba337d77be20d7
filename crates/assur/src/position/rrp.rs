//! The dyad RRP: a link hinged on a solved point and on a link that slides along
//! a solved line.

use super::complex::Complex;
use super::{Arm, Cause, Dead, Given, Solvable, State, Track, root};
use crate::index::BodyId;

/// Link i hinged at B, joint C, link j sliding (the connecting rod and the slider
/// of a slider-crank).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rrp {
    pub(crate) arm: Arm,
    /// How j slides; its point is C.
    pub(crate) track: Track,
}

impl Solvable for Rrp {
    /// In the line's own coordinates, B at (x, y) and C at (s, h), h constant:
    /// s = x + σ √(l² − (h − y)²).
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        let length = self.arm.length();
        let b = state.place(self.arm.outer);
        let (start, direction) = state.line(&self.track);
        let from = (b - start) * direction.conjugate();
        let rise = -from.y() + self.track.off;
        let margin = -rise.square() + length * length;
        state.margins[given.step] = [margin, margin];
        let by = rise.value().abs() - length;
        let run = root(margin, length * length).map_err(|dead| match dead {
            Dead::At => Cause::DeadPoint,
            Dead::Beyond => Cause::OutOfReach { by },
        })? * given.sign.factor();
        let to_c = direction * Complex::new(run, rise);
        state.lay(&self.arm, b, to_c);
        state.slid(&self.track, direction, b + to_c);
        Ok(())
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.arm.body, self.track.body].into_iter()
    }

    fn rests_on(&self, body: BodyId) -> bool {
        self.arm.outer.body == body || self.track.line.body == body
    }

    fn has_sign(&self) -> bool {
        true
    }

    fn passes(&self) -> bool {
        true
    }

    fn scale(&self) -> f64 {
        self.arm.length().powi(2)
    }
}
