//! The driven slide.

use super::{
    BodyPoint, Cause, Complex, DriveLaw, Enclosure, Predictor, Solvable, State, StepContext, Track,
};
use crate::Jet;
use crate::index::{BodyId, StepId};

/// A body moved along a line of the frame, or of a body that moves, by the input, or in proportion to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slider {
    pub(crate) track: Track,
    /// Least and greatest coordinate.
    pub(crate) range: [f64; 2],
    pub(crate) course: DriveLaw,
}

impl Solvable for Slider {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
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

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let Self {
            track,
            range,
            course,
        } = self;
        let line = track.line.body;
        let at = from
            .place(BodyPoint {
                body: track.body,
                local: track.point,
            })
            .value();
        let (start, direction) = from.line(track);
        let here = (at - start.value()).dot(&direction.value());
        let there = here + course.rate * cell.width;
        if !(range[0]..=range[1]).contains(&there) {
            return false;
        }
        // C″ = Q″ + 2σ′v′ + σv″ with a constant rate σ′ along the line.
        let rate = course.rate.abs();
        let along = 2.0 * rate * cell.max_turn_rate(from, line)
            + cell.step_len * rate * cell.direction_acceleration(from, line);
        let acceleration = cell.place_at(from, line, at).acceleration + along;
        cell.slid(track, acceleration);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.track.body].into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.track.line.body == body
    }
}
