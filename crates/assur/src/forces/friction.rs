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

/// Shortest step of the share of the coefficients while friction is followed.
const SHORTEST: f64 = 1e-6;

/// Determinant below which friction grows without bound. Near the share at which it does, the determinant is proportional
/// to the share that is left, and so a few [`SHORTEST`] at the last step.
const LOCKING: f64 = 1e-3;

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

/// Coulomb's law for all sliding pairs together. The components are those without friction and, in proportion to each
/// friction, those that a friction of size one causes alone.
struct Law<'a> {
    sliding: &'a [Sliding],
    bare: &'a [f64],
    responses: &'a [Vec<f64>],
    size: f64,
}

impl Law<'_> {
    /// Friction under a share of all coefficients, by Newton's method from a guess, with the determinant of the equations
    /// for its change; None if it does not arrive.
    fn settle(&self, share: f64, mut friction: DVector<f64>) -> Option<(DVector<f64>, f64)> {
        let count = self.sliding.len();
        let most = |most: f64, value: &f64| most.max(value.abs());
        let greatest = self.bare.iter().fold(0.0, most);
        for _ in 0..MAX_STEPS {
            let mut matrix = DMatrix::identity(count, count);
            let mut rest = friction.clone();
            for (row, one) in self.sliding.iter().enumerate() {
                let value = |component: usize| {
                    let caused = self.responses.iter().zip(friction.iter());
                    let caused = caused.map(|(by, size)| by[component] * size);
                    self.bare[component] + caused.sum::<f64>()
                };
                let components = [value(one.start), value(one.start + 1)];
                let (caused, by) = one.friction(components, self.size);
                rest[row] -= share * caused;
                for (column, response) in self.responses.iter().enumerate() {
                    let change = by[0] * response[one.start] + by[1] * response[one.start + 1];
                    matrix[(row, column)] -= share * change;
                }
            }
            let factors = matrix.lu();
            let step = factors.solve(&rest)?;
            friction -= &step;
            if !friction.iter().all(|value| value.is_finite()) {
                return None;
            }
            if step.amax() <= ARRIVED * greatest.max(friction.amax()) {
                return Some((friction, factors.determinant()));
            }
        }
        None
    }

    /// Friction under the whole coefficients, followed from none while they grow. If the determinant approaches zero on the
    /// way, the friction grows without bound: with greater coefficients nothing balances it.
    ///
    /// # Errors
    /// The mechanism is self-locking, or the friction is lost on the way.
    fn follow(&self) -> Result<DVector<f64>, Unbalanced> {
        let (mut share, mut step) = (0.0, 0.5);
        let (mut friction, mut determinant) = (DVector::zeros(self.sliding.len()), 1.0);
        while share < 1.0 {
            let next = f64::min(share + step, 1.0);
            match self.settle(next, friction.clone()) {
                Some((found, next_determinant)) if next_determinant > 0.0 => {
                    (friction, determinant, share) = (found, next_determinant, next);
                    step *= 2.0;
                }
                _ if step > SHORTEST => step *= 0.5,
                _ if determinant < LOCKING => return Err(Unbalanced::Locked),
                _ => return Err(Unbalanced::Unsettled),
            }
        }
        Ok(friction)
    }
}

impl Kinetostatics {
    /// Adds the friction of the pairs to the reactions without friction in `found`. The reactions depend on the friction
    /// linearly, the friction on them by Coulomb's law: Newton's method, from no friction.
    ///
    /// # Errors
    /// No friction satisfies the law, so the mechanism is self-locking in this pose; or Newton's method does not find it.
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
        let law = Law {
            sliding: &sliding,
            bare: &bare,
            responses: &responses,
            size,
        };
        let friction = match law.settle(1.0, DVector::zeros(count)) {
            Some((friction, _)) => friction,
            None => law.follow()?,
        };
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

impl Loading {
    /// Hinges with friction and the radii of their friction circles.
    pub fn friction_circles(&self) -> impl Iterator<Item = (PairId, f64)> {
        self.friction.iter().filter_map(|one| match one.law {
            FrictionLaw::Hinge { circle } => Some((one.pair, circle)),
            FrictionLaw::Slide { .. } => None,
        })
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::Id;

    /// A slide with the normal force 10 + r F and the coefficient 0.5, so that F = −0.5 |10 + r F| for the speed 1.
    fn slide(response: f64, coefficient: f64) -> Result<f64, Unbalanced> {
        let law = FrictionLaw::Slide {
            coefficient,
            length: 0.0,
        };
        let bodies = [0, 1].map(BodyId::at);
        let (pair, index) = (PairId(0), 0);
        let sliding = [Sliding {
            of: Friction { pair, index, law },
            start: 0,
            bodies,
            at: Vector::zeros(),
            along: Vector::x(),
            speed: 1.0,
        }];
        let law = Law {
            sliding: &sliding,
            bare: &[10.0, 0.0],
            responses: &[vec![response, 0.0]],
            size: 1.0,
        };
        law.follow().map(|friction| friction[0])
    }

    /// With r = 1: F = −5 − F/2, so F = −10/3. With r = −1: F = −5 + F/2, so F = −10.
    #[test]
    fn friction_that_is_followed() {
        for (response, expected) in [(1.0, -10.0 / 3.0), (-1.0, -10.0), (-1.9, -100.0)] {
            let found = slide(response, 0.5).unwrap();
            assert!((found - expected).abs() < 1e-10 * expected.abs(), "{found}");
        }
    }

    /// With r = −2.1 the normal force would grow by more than the friction that it causes.
    #[test]
    fn self_locking_is_not_a_failure_of_the_method() {
        assert_eq!(slide(-2.1, 0.5), Err(Unbalanced::Locked));
        assert_eq!(slide(-2.1, 0.45).map(f64::round), Ok(-82.0));
        assert_eq!(slide(1.0, f64::NAN), Err(Unbalanced::Unsettled));
        assert_eq!(slide(f64::INFINITY, 0.5), Err(Unbalanced::Unsettled));
    }
}
