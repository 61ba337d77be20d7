//! The driven slide.

use super::{Cause, Complex, Course, Given, Solvable, State, Track};
use crate::Jet;
use crate::index::BodyId;

/// A body moved along a line of the frame, or of a body that moves, by the input, or in proportion to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slider {
    pub(crate) track: Track,
    /// Least and greatest coordinate.
    pub(crate) range: [f64; 2],
    pub(crate) course: Course,
}

impl Solvable for Slider {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        let Self {
            track,
            range,
            course,
        } = self;
        let coordinate = course.at(given.input);
        if !(range[0]..=range[1]).contains(&coordinate.value()) {
            return Err(Cause::Input);
        }
        let (start, direction) = state.line(track);
        let at = direction * Complex::new(coordinate, Jet::constant(track.off));
        state.slid(track, direction, start + at);
        Ok(())
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.track.body].into_iter()
    }

    fn rests_on(&self, body: BodyId) -> bool {
        self.track.line.body == body
    }
}
