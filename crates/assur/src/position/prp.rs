//! The dyad PRP: two links that slide along solved lines and are hinged on each
//! other.

use super::{Obstacle, State, Track, crossing};
use crate::Vector;

/// Links i and j; the point of both tracks is the joint C between them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Prp {
    pub(crate) tracks: [Track; 2],
}

impl Prp {
    /// C is where the parallels to both lines, at constant distances, cross.
    pub(crate) fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        step: usize,
    ) -> Result<(), Obstacle> {
        let [i, j] = &self.tracks;
        let lines = [i, j].map(|track| {
            let (start, direction) = state.line(track);
            let off = direction.by(Vector::new(0.0, track.off));
            (start + off, direction)
        });
        let c = crossing(lines, &mut state.margins[step])?;
        state.slid(i, lines[0].1, c);
        state.slid(j, lines[1].1, c);
        Ok(())
    }
}
