//! Dry friction in hinges and slides: friction circles, losses and efficiency.

use nalgebra::{DMatrix, DVector};

use super::applied::{Applied, Source, relative, turning};
use super::kinetostatics::{Kinetostatics, Unbalanced};
use super::pair::{Kind, PairId};
use super::{Loading, Reactions};
use crate::index::BodyId;
use crate::mechanism::Guide;
use crate::position::State;
use crate::{Vector, tolerance};

/// Limit of the steps of Newton's method.
const MAX_STEPS: usize = 60;

/// Change of the friction in one step, relative to the greatest reaction, at which Newton's method has arrived.
const ARRIVED: f64 = 1e-13;

/// Friction of a pair of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Friction {
    pub(super) pair: PairId,
    /// Index in the list of the specification.
    pub(super) index: usize,
    pub(super) law: FrictionLaw,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FrictionLaw {
    /// Radius of the friction circle: the couple is this radius times the reaction.
    Hinge { circle: f64 },
    /// Coefficient of friction, and the length of the block; zero if it is not known.
    Slide { coefficient: f64, length: f64 },
}

/// Friction in a pair in a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rubbing {
    /// The pair.
    pub pair: PairId,
    /// Index in [`super::LoadingSpec::friction`].
    pub index: usize,
    /// Couple of a hinge, or force along the line of a slide, on the first body of the pair.
    pub value: f64,
    /// Power that the friction takes.
    pub loss: f64,
}

/// Friction of a pair whose bodies move relative to each other.
struct Sliding {
    of: Friction,
    /// Index of the first component of the pair.
    start: usize,
    /// Bodies of the pair; for a slide the one with the sliding point comes first.
    bodies: [BodyId; 2],
    /// Hinge or sliding point, from the origin of the coordinates.
    at: Vector,
    /// Direction of the line; zero for a hinge.
    along: Vector,
    /// Speed of the first body relative to the second: rad/s, or length/s along the line.
    speed: f64,
}

impl Sliding {
    /// None if the bodies do not move relative to each other: the friction is then undetermined, and taken as zero.
    fn new(forces: &Kinetostatics, of: Friction, state: &State<3>, rate: f64) -> Option<Self> {
        let (start, pair) = forces.held(of.pair);
        let sliding = match pair.kind {
            Kind::Hinge(at, _) => Self {
                of,
                start,
                bodies: pair.bodies,
                at: state.place(at)[0],
                along: Vector::zeros(),
                speed: relative(state, pair.bodies)[1] * rate,
            },
            Kind::Slide(guide) => {
                let along = super::pair::heading(state, &guide);
                Self {
                    of,
                    start,
                    bodies: [guide.at.body, guide.on],
                    at: state.place(guide.at)[0],
                    along,
                    speed: travel_rate(state, &guide, along) * rate,
                }
            }
            Kind::Mesh(_) => return None,
        };
        let least = tolerance::COINCIDENT
            * rate.abs()
            * if sliding.is_hinge() {
                1.0
            } else {
                forces.size()
            };
        (sliding.speed.abs() > least).then_some(sliding)
    }

    fn is_hinge(&self) -> bool {
        matches!(self.of.law, FrictionLaw::Hinge { .. })
    }

    /// Friction on the first body, and the opposite on the second, for a value of the friction as a force: a couple is
    /// the value times `size`.
    fn applied(&self, value: f64, size: f64) -> [Applied; 2] {
        let couple = if self.is_hinge() { value * size } else { 0.0 };
        [0, 1].map(|k| {
            let sign = [1.0, -1.0][k];
            Applied {
                body: self.bodies[k],
                at: self.at,
                force: self.along * (sign * value),
                couple: sign * couple,
                source: Source::Friction(self.of.index),
            }
        })
    }

    /// The friction as a force that the components of the pair cause, with its derivatives by the two components.
    fn friction(&self, [a, b]: [f64; 2], size: f64) -> (f64, [f64; 2]) {
        let sense = -self.speed.signum();
        match self.of.law {
            FrictionLaw::Hinge { circle } => {
                let factor = sense * circle / size;
                let reaction = a.hypot(b);
                let by = if reaction > 0.0 {
                    [a / reaction, b / reaction]
                } else {
                    [0.0; 2]
                };
                (factor * reaction, by.map(|part| factor * part))
            }
            FrictionLaw::Slide {
                coefficient,
                length,
            } => {
                let factor = sense * coefficient;
                // The block bears on its two ends if the line of the reaction passes it.
                let arm = if length > 0.0 {
                    2.0 * size / length
                } else {
                    0.0
                };
                if arm * b.abs() > a.abs() {
                    (factor * arm * b.abs(), [0.0, factor * arm * b.signum()])
                } else {
                    (factor * a.abs(), [factor * a.signum(), 0.0])
                }
            }
        }
    }
}

/// Derivative, by the input, of the travel of a sliding point along its line.
fn travel_rate(state: &State<3>, guide: &Guide, along: Vector) -> f64 {
    let point = state.place(guide.at);
    let line = &state.bodies[guide.on];
    let arm = point[0] - line.origin[0];
    let carried = line.origin[1] + crate::perpendicular(arm) * turning(state, guide.on)[0];
    along.dot(&(point[1] - carried))
}

impl Kinetostatics {
    /// Adds the friction of the pairs to the reactions without friction in `found`. The reactions depend on the friction
    /// linearly, the friction on them by Coulomb's law: Newton's method, from no friction.
    ///
    /// # Errors
    /// No friction satisfies the law: the mechanism is self-locking in this pose.
    pub(super) fn rub(
        &self,
        loading: &Loading,
        state: &State<3>,
        rate: f64,
        found: &mut Reactions,
    ) -> Result<(), Unbalanced> {
        let is_known = |one: &Sliding| {
            let own = &found.components[one.start..one.start + 2];
            own.iter().all(Option::is_some)
        };
        let all = loading.friction.iter();
        let all = all.filter_map(|of| Sliding::new(self, *of, state, rate));
        let sliding: Vec<Sliding> = all.filter(is_known).collect();
        let count = sliding.len();
        if count == 0 {
            return Ok(());
        }
        let size = self.size();
        let applied = std::mem::take(&mut found.applied);
        let bare = found.values.clone();
        let mut responses = Vec::with_capacity(count);
        for one in &sliding {
            found.applied.extend(one.applied(1.0, size));
            self.solve(state, found)?;
            responses.push(found.values.clone());
            found.applied.clear();
        }
        let greatest = bare
            .iter()
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let mut friction = DVector::<f64>::zeros(count);
        let mut arrived = false;
        for _ in 0..MAX_STEPS {
            let mut matrix = DMatrix::identity(count, count);
            let mut rest = friction.clone();
            for (row, one) in sliding.iter().enumerate() {
                let value = |component: usize| {
                    let caused = responses.iter().zip(friction.iter());
                    bare[component] + caused.map(|(by, size)| by[component] * size).sum::<f64>()
                };
                let (caused, by) = one.friction([value(one.start), value(one.start + 1)], size);
                rest[row] -= caused;
                for (column, response) in responses.iter().enumerate() {
                    let change = by[0] * response[one.start] + by[1] * response[one.start + 1];
                    matrix[(row, column)] -= change;
                }
            }
            let Some(step) = matrix.lu().solve(&rest) else {
                return Err(Unbalanced::Locked);
            };
            friction -= &step;
            if !friction.iter().all(|value| value.is_finite()) {
                return Err(Unbalanced::Locked);
            }
            if step.amax() <= ARRIVED * greatest.max(friction.amax()) {
                arrived = true;
                break;
            }
        }
        if !arrived {
            return Err(Unbalanced::Locked);
        }
        found.applied = applied;
        found.bare = bare[self.pairs_held()..].to_vec();
        for (one, value) in sliding.iter().zip(friction.iter()) {
            found.applied.extend(one.applied(*value, size));
            let value = if one.is_hinge() { value * size } else { *value };
            // On the first body of the pair, which need not be the one with the sliding point.
            let sign = if self.held(one.of.pair).1.bodies[0] == one.bodies[0] {
                1.0
            } else {
                -1.0
            };
            found.friction.push(Rubbing {
                pair: one.of.pair,
                index: one.of.index,
                value: sign * value,
                loss: -value * one.speed,
            });
        }
        self.solve(state, found)
    }
}

impl Reactions {
    /// Friction in the pairs whose bodies move relative to each other. A pair at rest is left out: its friction is
    /// undetermined and taken as zero, as is that of a statically indeterminate pair.
    pub fn friction(&self) -> &[Rubbing] {
        &self.friction
    }

    /// Power that friction takes.
    pub fn loss(&self) -> f64 {
        self.friction.iter().map(|one| one.loss).sum()
    }

    /// Efficiency of the driver: the torque without friction over that with friction if the driver drives, the reciprocal if
    /// it is driven back. Zero or negative: what drives it back, loads or inertia, cannot move it at this moment. None without
    /// friction, with several drivers, and if the work of the driver is negligible beside that of friction.
    pub fn efficiency(&self, rate: f64) -> Option<f64> {
        let &[bare] = &self.bare[..] else {
            return None;
        };
        let drive = self.first_component()?;
        // Power of friction as that of a drive of the same unit.
        let taken = (drive - bare).abs();
        if bare.abs() <= tolerance::COINCIDENT * taken {
            return None;
        }
        Some(if bare * rate > 0.0 {
            bare / drive
        } else {
            drive / bare
        })
    }
}
