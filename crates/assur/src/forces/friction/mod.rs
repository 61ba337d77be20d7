//! Dry friction in hinges and slides: friction circles, losses and efficiency.
//!
//! | file | subject |
//! |---|---|
//! | `coulomb` | Coulomb's law for all pairs together |
//! | `bearing` | the sides on which a block bears |
//! | `moving_friction` | friction where the drive is given and the acceleration is not |

mod bearing;
mod coulomb;
mod moving_friction;

pub(super) use moving_friction::{Driven, FrictionTorque, MovingFriction};

use self::coulomb::{Law, Sliding};
use super::kinetostatics::{Kinetostatics, Unbalanced};
use super::pair::PairId;
use super::{Loading, Reactions};
use crate::position::State;
use crate::tolerance;

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
        let sense = if rate == 0.0 { 0.0 } else { rate.signum() };
        let all = loading.friction.iter();
        let all = all.filter_map(|of| {
            let mut sliding = Sliding::new(self, *of, state)?;
            sliding.sense = sliding.direction() * sense;
            Some(sliding)
        });
        let moving = all.filter(|one| one.sense != 0.0 && one.is_known(found));
        let sliding: Vec<Sliding> = moving.collect();
        if sliding.is_empty() {
            return Ok(());
        }
        let size = self.size();
        let applied = std::mem::take(&mut found.applied);
        let bare = found.values.clone();
        let responses = sliding.iter();
        let responses = responses.map(|one| self.caused(state, one.applied(1.0, size), found));
        let responses = responses.collect::<Result<Vec<_>, _>>()?;
        let law = Law {
            sliding: &sliding,
            bare: &bare,
            responses: &responses,
            size,
        };
        let (friction, _) = law.friction()?;
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
                loss: -value * one.by_input * rate,
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
