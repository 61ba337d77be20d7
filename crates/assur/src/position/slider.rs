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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::position::dyads::tests::{at, place, track};
    use crate::position::{Sign, Step};

    fn slider(line: usize, law: DriveLaw, offset: f64) -> Slider {
        let mut track = track(2, at(line, 0.0, 0.0));
        track.offset = offset;
        Slider {
            track,
            range: [-10.0, 10.0],
            law,
        }
    }

    fn check(slider: Slider, expected: [[f64; 2]; 3]) {
        let found = place(&Step::from(slider), Sign::Plus, at(2, 0.0, 0.0));
        let mut both = found.as_flattened().iter().zip(expected.as_flattened());
        assert!(both.all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
    }

    /// Archimedes' spiral: the point of a slide at the distance φ from the pivot, on a line that turns with the crank.
    /// At 90° its acceleration is −φ along the line and 2·1·1 across it, by Coriolis.
    #[test]
    fn a_slide_on_a_turning_line_has_coriolis_acceleration() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let expected = [[0.0, quarter], [-quarter, 1.0], [-2.0, -quarter]];
        check(slider(1, DriveLaw::FIRST, 0.0), expected);
    }

    /// The coordinate is twice the input less 1, and the point is 3 to the left of the line.
    #[test]
    fn a_slide_on_the_frame_moves_straight() {
        let law = DriveLaw::through(0, 2.0, [0.0, -1.0]);
        let coordinate = std::f64::consts::PI - 1.0;
        check(
            slider(0, law, 3.0),
            [[coordinate, 3.0], [2.0, 0.0], [0.0, 0.0]],
        );
    }

    /// A law with the rate −2 and the coordinate 5 at the input 1 gives the coordinate 1 at the input 3. Along a line
    /// from the coordinate 4 at the rate 3 it gives 10 at the input 2, and the opposite law −10.
    #[test]
    fn the_law_of_a_drive_is_linear() {
        let law = DriveLaw::through(1, -2.0, [1.0, 5.0]);
        let at = law.at(Jet::<3>::linear(3.0, 1.0));
        assert_eq!(
            [0, 1, 2].map(|order| at.derivative(order)),
            [1.0, -2.0, 0.0]
        );
        let back = law.reversed().at(Jet::<2>::linear(3.0, 1.0));
        assert_eq!([0, 1].map(|order| back.derivative(order)), [-1.0, 2.0]);
        assert_eq!(law.reversed().coordinate(3.0), (1, 1.0));
        for (mut law, expected) in [(law, 10.0), (law.reversed(), -10.0)] {
            law.follow(&[0.0, 4.0], &[0.0, 3.0]);
            assert_eq!(law.at(Jet::<1>::constant(2.0)).value(), expected);
        }
    }
}
