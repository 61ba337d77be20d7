//! The dyad RPP: a link hinged to a solved point and sliding on a link that slides along a solved line.

use super::rpr::Side;
use crate::Vector;
use crate::index::{BodyId, StepId};
use crate::position::complex::{Complex, conjugate};
use crate::position::{
    Cause, Enclosure, Predictor, Singularity, Solvable, State, StepContext, Track, crossing,
};

/// Link i is hinged at B and slides on link j; link j slides along the solved line (block and yoke of a Scotch yoke).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rpp {
    pub(crate) side: Side,
    pub(crate) track: Track,
    /// Unit vector along the line of the inner slide, in the coordinates of j; `through` is a point of this line.
    pub(crate) direction: Vector,
    pub(crate) through: Vector,
}

impl Solvable for Rpp {
    /// Both angles follow from the angle of the solved line. The guided point of j is the intersection of two lines at
    /// constant offsets: a parallel to the solved line, and a parallel to the inner slide, offset from B.
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let Self { side, track, .. } = self;
        let (start, direction) = state.line(track);
        let turn_j = direction.by(conjugate(track.direction));
        let inner = turn_j.by(self.direction);
        let turn_i = inner.by(conjugate(side.direction));
        let b = state.place(side.outer);
        state.put(side.body, turn_i, side.hinge, b);

        let shift = |of: Complex<N>, by: f64| of.by(Vector::new(0.0, by));
        let guide = (start + shift(direction, track.offset), direction);
        // The line of the inner slide, shifted to pass through the guided point of j.
        let across = turn_j.by(track.point - self.through);
        let sliding = (b + shift(inner, side.offset) + across, inner);
        let at = crossing([guide, sliding], &mut state.margins[context.step])?;
        state.slid(track, direction, at);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let Self { side, track, .. } = self;
        let angular_acceleration = cell.angular_acceleration(track.line.body);
        let hinge = cell.point(from, side.outer).acceleration;
        cell.set(side.body, angular_acceleration, [(side.hinge, hinge); 2]);
        let at = from.track_point(track);
        let lines = [
            (track.line.body, track.heading),
            (side.body, side.direction),
        ];
        let Some(acceleration) = cell.crossing_acceleration(from, at, lines) else {
            return false;
        };
        cell.set_slider(track, acceleration);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.side.body, self.track.body].into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.side.outer.body == body || self.track.line.body == body
    }

    fn singularity(&self) -> Singularity {
        Singularity::Parallel
    }
}
