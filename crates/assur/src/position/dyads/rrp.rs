//! The dyad RRP: a link hinged to a solved point and to a link that slides along a solved line.

use crate::index::{BodyId, StepId};
use crate::position::complex::Complex;
use crate::position::{
    Arm, Cause, Dead, Enclosure, Predictor, Singularity, Solvable, State, StepContext, Track,
    product,
};

/// Link i is hinged at B and joined at C to the sliding link j (the connecting rod and the slider of a slider-crank).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rrp {
    pub(crate) arm: Arm,
    /// Track of j, with C as its point.
    pub(crate) track: Track,
}

impl Solvable for Rrp {
    /// In the line's coordinates, with B at (x, y), C at (s, h) and assembly sign σ: s = x + σ √(|BC|² − (h − y)²).
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let length = self.arm.length();
        let b = state.place(self.arm.outer);
        let (start, direction) = state.line(&self.track);
        let from = (b - start) * direction.conjugate();
        let rise = -from.y() + self.track.offset;
        let margin = -rise.square() + length * length;
        state.margins[context.step] = [margin, margin];
        let by = rise.value().abs() - length;
        let run = context
            .root(margin, length * length)
            .map_err(|dead| match dead {
                Dead::At => Cause::DeadPoint,
                Dead::Beyond => Cause::OutOfReach { by },
            })?;
        let to_c = direction * Complex::new(run, rise);
        state.lay(&self.arm, b, to_c);
        state.slid(&self.track, direction, b + to_c);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let Self { arm, track } = self;
        let (length, line) = (arm.length(), track.line.body);
        let at = from.track_point(track);
        let b = cell.point(from, arm.outer);
        // Vector from B to the point of the line's body that is at C at the start of the step. The length of the arm
        // must exceed the component of this vector perpendicular to the line.
        let to_c = cell.point_at(from, line, at).minus(&b);
        let [direction, rate] =
            [0, 1].map(|order| product(from.bodies[line].turn[order], track.heading));
        let left = crate::perpendicular;
        let rise = left(direction).dot(&to_c.at);
        let rise_rate = left(direction).dot(&to_c.rate) + left(rate).dot(&to_c.at);
        let (max_turn_rate, speed) = (cell.max_turn_rate(from, line), cell.max_speed(&to_c));
        let [_, far] = cell.distances(&to_c);
        let acceleration = to_c.acceleration
            + 2.0 * max_turn_rate * speed
            + cell.direction_acceleration(from, line) * far;
        let most = rise.abs().max((rise + rise_rate * cell.width).abs())
            + 0.5 * cell.step_len * cell.step_len * acceleration;
        if most >= length {
            return false;
        }
        let sine = ((length - most) * (length + most)).sqrt() / length;
        // Let n be the line's normal, ω and ε its angular velocity and acceleration, X = C − B, q = `to_c` (from B to a
        // point fixed to the line's body), λ the displacement of C from that point along the line. Then
        // n·X″ = n·q″ + 2λ′ω + λε, where |λ′| ≤ |X′| + |q′|.
        let free = sine - cell.step_len * max_turn_rate;
        if free <= 0.0 {
            return false;
        }
        let crude = speed * (1.0 + cell.step_len * max_turn_rate) / free;
        let slide_rate = crude + speed;
        let rest = to_c.acceleration
            + slide_rate * (2.0 * max_turn_rate + cell.step_len * cell.angular_acceleration(line));
        let v0 = cell.turn_rate(from, arm.body).abs() * length;
        let v = cell.bounded_speed(v0, (length * sine).recip(), rest / sine);
        let v = v.map_or(crude, |v| v.min(crude));
        let acceleration = (v * v / length + rest) / sine;
        if !acceleration.is_finite() {
            return false;
        }
        let joint = b.acceleration + acceleration;
        cell.set(
            arm.body,
            acceleration / length,
            [(arm.from, b.acceleration), (arm.to, joint)],
        );
        cell.set_slider(track, joint);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.arm.body, self.track.body].into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.arm.outer.body == body || self.track.line.body == body
    }

    fn singularity(&self) -> Singularity {
        Singularity::Perpendicular
    }

    fn scales(&self) -> [f64; 2] {
        [self.arm.length().powi(2); 2]
    }
}
