//! The dyad RPR: two links hinged to solved points and sliding on each other.

use crate::index::{BodyId, PointId, StepId};
use crate::position::complex::{Complex, conjugate, product};
use crate::position::{
    BodyPoint, CLOSE_SQUARED, Cause, Dead, Enclosure, Predictor, Singularity, Solvable, State,
    StepContext,
};
use crate::{Jet, Vector};

/// Links i and j are hinged at B and D and slide on each other (the slotted lever and the block of an inverted
/// slider-crank).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rpr {
    pub(crate) sides: [Side; 2],
}

/// A link of the dyad, with its hinge and its line of sliding.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Side {
    pub(crate) body: BodyId,
    pub(crate) outer: BodyPoint,
    /// Hinge in the coordinates of the link.
    pub(crate) hinge: Vector,
    pub(crate) joint: PointId,
    /// Unit vector in the direction of sliding, in the coordinates of the link.
    pub(crate) direction: Vector,
    /// Offset of the line from the hinge, positive to the left.
    pub(crate) offset: f64,
}

impl Solvable for Rpr {
    /// Let u be the direction of sliding and d = D − B. Let w and h be the components of d along u and across it; h is
    /// constant. Then d = u (w + ih), so w = σ √(d² − h²) with the assembly sign σ, and u = d (w − ih) / d².
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let [i, j] = &self.sides;
        let [b, d] = [state.place(i.outer), state.place(j.outer)];
        let between = d - b;
        let square = between.norm_squared();
        let apart = i.offset - j.offset;
        let margin = square + -(apart * apart);
        state.margins[context.step] = [margin, margin];
        let scale = (apart * apart).max(square.value());
        let by = apart.abs() - square.value().sqrt();
        if square.value() <= f64::EPSILON * f64::EPSILON * state.scale {
            return Err(Cause::Undetermined);
        }
        let run = context.root(margin, scale).map_err(|dead| match dead {
            Dead::At => Cause::DeadPoint,
            Dead::Beyond => Cause::OutOfReach { by },
        })?;
        let along = Complex::new(run, Jet::constant(-apart));
        let mut direction = (between * along).over(square);
        // If d is nearly perpendicular to u, the condition u × d = h hardly determines the derivatives of u, so those
        // from the root are kept.
        let is_across = run.value().powi(2) < CLOSE_SQUARED * square.value();
        if square.value() < CLOSE_SQUARED * state.scale && !is_across {
            // If d is short, the closed form would lose digits in the derivatives. They are computed instead from
            // u × d = h with |u| = 1.
            let unit = direction.value().normalize();
            direction = Complex::of_constant_length(unit, between.left(), Jet::constant(-apart));
        }
        for (side, at) in [(i, b), (j, d)] {
            let turn = direction.by(conjugate(side.direction));
            state.put(side.body, turn, side.hinge, at);
        }
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        // Angular velocity ω and acceleration ε, from d = u (w + ih): ω w = u × d′ and ε w = u × d″ + ω²h − 2ω w′.
        let [i, j] = &self.sides;
        let [b, d] = [i, j].map(|side| cell.point(from, side.outer));
        let base = d.minus(&b);
        let apart = (i.offset - j.offset).abs();
        let [least, most] = cell.distances(&base);
        if least <= apart {
            return false;
        }
        let run = ((least - apart) * (least + apart)).sqrt();
        let speed = cell.max_speed(&base);
        let crude = speed / run;
        let lengthens = 2.0 * most * speed / run;
        let angular_acceleration = |max_turn_rate: f64| {
            (base.acceleration + max_turn_rate * (max_turn_rate * apart + lengthens)) / run
        };
        let max_turn_rate = crude
            .min(cell.turn_rate(from, i.body).abs() + cell.step_len * angular_acceleration(crude));
        let angular_acceleration = angular_acceleration(max_turn_rate);
        for (side, outer) in [(i, b), (j, d)] {
            cell.set(
                side.body,
                angular_acceleration,
                [(side.hinge, outer.acceleration); 2],
            );
        }
        angular_acceleration.is_finite()
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.sides.each_ref().map(|side| side.body).into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.sides.iter().any(|side| side.outer.body == body)
    }

    fn singularity(&self) -> Singularity {
        Singularity::Perpendicular
    }

    fn scales(&self) -> [f64; 2] {
        let [i, j] = &self.sides;
        [(i.offset - j.offset).powi(2); 2]
    }
}

impl Side {
    /// Side whose line passes through a given point of the link.
    pub(crate) fn new(
        body: BodyId,
        outer: BodyPoint,
        (joint, hinge): (PointId, Vector),
        (through, direction): (Vector, Vector),
    ) -> Self {
        Self {
            body,
            outer,
            hinge,
            joint,
            direction,
            offset: product(through - hinge, conjugate(direction)).y,
        }
    }
}
