//! The driven slide.

use super::{Cause, Complex, DriveLaw, Enclosure, Predictor, Solvable, State, StepContext, Track};
use crate::Jet;
use crate::index::{BodyId, StepId};

/// Driven body on a line of the frame or of a moving body; its coordinate is a linear function of the input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slider {
    pub(crate) track: Track,
    /// Minimum and maximum coordinate.
    pub(crate) range: [f64; 2],
    pub(crate) law: DriveLaw,
}

impl Solvable for Slider {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let Self { track, range, law } = self;
        let coordinate = law.at(context.input);
        if !(range[0]..=range[1]).contains(&coordinate.value()) {
            return Err(Cause::Input);
        }
        let (start, direction) = state.line(track);
        let at = direction * Complex::new(coordinate, Jet::constant(track.offset));
        state.slid(track, direction, start + at);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let Self { track, range, law } = self;
        let line = track.line.body;
        let at = from.track_point(track);
        let (start, direction) = from.line(track);
        let here = (at - start.value()).dot(&direction.value());
        let there = here + law.rate * cell.width;
        if !(range[0]..=range[1]).contains(&there) {
            return false;
        }
        // C″ = Q″ + 2σ′v′ + σv″ for the slider's point C and the point Q of the line's body that coincides with C at
        // the start of the step. σ is the displacement along the line's direction v; its rate is constant.
        let rate = law.rate.abs();
        let along = 2.0 * rate * cell.max_turn_rate(from, line)
            + cell.step_len * rate * cell.direction_acceleration(from, line);
        let acceleration = cell.point_at(from, line, at).acceleration + along;
        cell.set_slider(track, acceleration);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.track.body].into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.track.line.body == body
    }
}
