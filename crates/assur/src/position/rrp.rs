//! The dyad RRP: a link hinged on a solved point and on a link that slides along
//! a solved line.

use super::complex::Complex;
use super::{Arm, Dead, Obstacle, State, Track, root};

/// Link i hinged at B, joint C, link j sliding (the connecting rod and the slider
/// of a slider-crank).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rrp {
    pub(crate) arm: Arm,
    /// How j slides; its point is C.
    pub(crate) track: Track,
}

impl Rrp {
    /// In the line's own coordinates, B at (x, y) and C at (s, h), h constant:
    /// s = x + σ √(l² − (h − y)²).
    pub(crate) fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        sign: f64,
        step: usize,
    ) -> Result<(), Obstacle> {
        let length = self.arm.length();
        let b = state.place(self.arm.outer);
        let (start, direction) = state.line(&self.track);
        let from = (b - start) * direction.conjugate();
        let rise = -from.y() + self.track.off;
        let margin = -rise.square() + length * length;
        state.margins[step] = [margin, margin];
        let by = rise.value().abs() - length;
        let run = root(margin, length * length).map_err(|dead| match dead {
            Dead::At => Obstacle::DeadPoint,
            Dead::Beyond => Obstacle::OutOfReach { by },
        })? * sign;
        let to_c = direction * Complex::new(run, rise);
        state.lay(&self.arm, b, to_c);
        state.slid(&self.track, direction, b + to_c);
        Ok(())
    }
}
