//! The dyad PRP: two links that slide along solved lines and are hinged to each other.

use crate::Vector;
use crate::index::{BodyId, StepId};
use crate::position::{
    Cause, Enclosure, Predictor, Singularity, Solvable, State, StepContext, Track, crossing,
};

/// Links i and j; the point of both tracks is the joint C between them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Prp {
    pub(crate) tracks: [Track; 2],
}

impl Solvable for Prp {
    /// C is the intersection of the parallels to both lines at constant offsets.
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let [i, j] = &self.tracks;
        let lines = [i, j].map(|track| {
            let (start, direction) = state.line(track);
            let offset = direction.by(Vector::new(0.0, track.offset));
            (start + offset, direction)
        });
        let c = crossing(lines, &mut state.margins[context.step])?;
        state.slid(i, lines[0].1, c);
        state.slid(j, lines[1].1, c);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let [i, j] = &self.tracks;
        let at = from.track_point(i);
        let lines = [i, j].map(|track| (track.line.body, track.heading));
        let Some(acceleration) = cell.crossing_acceleration(from, at, lines) else {
            return false;
        };
        cell.set_slider(i, acceleration);
        cell.set_slider(j, acceleration);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.tracks.each_ref().map(|track| track.body).into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.tracks.iter().any(|track| track.line.body == body)
    }

    fn singularity(&self) -> Singularity {
        Singularity::Parallel
    }
}
