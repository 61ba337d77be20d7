//! Free bodies: all forces and couples on each body in a pose, with their places.

use super::applied::Source;
use super::pair::{Component, DriverId, PairId};
use super::{Kinetostatics, Reactions};
use crate::index::BodyId;
use crate::mechanism::Mechanism;
use crate::{Point, Vector};

/// What a force or couple on a body comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// A weight, the inertia of the body, a load, a spring, a damper, or friction in a pair.
    Applied(Source),
    /// The reaction of a pair.
    Reaction {
        /// The pair.
        pair: PairId,
        /// The other body. For the carrier of an idler, the first of the two wheels.
        from: BodyId,
    },
    /// The balancing torque or force.
    Drive {
        /// The driver.
        driver: DriverId,
        /// The other body.
        from: BodyId,
    },
}

/// A force and a couple on a body. None stands for what is statically indeterminate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acting {
    /// What they come from.
    pub cause: Cause,
    /// Place of the force, from the origin of the coordinates used while solving.
    pub(super) at: Vector,
    /// Force, x and y.
    pub force: Option<Vector>,
    /// Couple, positive counter-clockwise. For a slide, the moment of the reaction about the sliding point.
    pub couple: Option<f64>,
}

impl Acting {
    /// Place of the force.
    pub fn place(&self, mechanism: &Mechanism) -> Point {
        mechanism.middle() + self.at
    }

    /// True if it is known that nothing acts.
    fn is_nothing(&self) -> bool {
        self.force == Some(Vector::zeros()) && self.couple == Some(0.0)
    }
}

impl Kinetostatics {
    /// Forces and couples on a body: applied ones, then reactions, then balancing torques and forces. Applied ones of
    /// size zero are left out.
    pub fn free_body(&self, found: &Reactions, body: BodyId) -> Vec<Acting> {
        let applied = found.applied.iter().filter(|one| one.body == body);
        let applied = applied.map(|one| Acting {
            cause: Cause::Applied(one.source),
            at: one.at,
            force: Some(one.force),
            couple: Some(one.couple),
        });
        let mut all: Vec<Acting> = applied.filter(|one| !one.is_nothing()).collect();
        for k in 0..self.pairs.len() {
            let range = self.components_of(PairId(k));
            let other = |component: &Component| {
                let [a, b] = component.bodies;
                if a == body { b } else { a }
            };
            if let Some(one) = self.acting(found, body, range.clone()) {
                let (pair, from) = (PairId(k), other(&self.components[range.start]));
                all.push(Acting {
                    cause: Cause::Reaction { pair, from },
                    ..one
                });
            }
        }
        for (driver, at) in self.drivers().zip(self.held..) {
            if let Some(one) = self.acting(found, body, at..at + 1) {
                let [a, b] = self.components[at].bodies;
                let from = if a == body { b } else { a };
                all.push(Acting {
                    cause: Cause::Drive { driver, from },
                    ..one
                });
            }
        }
        all
    }

    /// Indices of the components of a pair.
    pub(super) fn components_of(&self, pair: PairId) -> std::ops::Range<usize> {
        let next = self.starts.get(pair.0 + 1);
        self.starts[pair.0]..next.map_or(self.held, |next| *next)
    }

    /// What components exert on a body together; None if they do not act on it.
    fn acting(
        &self,
        found: &Reactions,
        body: BodyId,
        range: std::ops::Range<usize>,
    ) -> Option<Acting> {
        let mut all: Option<Acting> = None;
        for index in range {
            let placed = &found.placed[index];
            let on = self.components[index].on();
            let Some(which) = on.into_iter().position(|one| one == body) else {
                continue;
            };
            let acting = all.get_or_insert(Acting {
                cause: Cause::Applied(Source::Weight),
                at: placed.at,
                force: Some(Vector::zeros()),
                couple: Some(0.0),
            });
            let value = found.components[index];
            let sign = [1.0, -1.0, 0.0][which];
            if placed.force != Vector::zeros() {
                let sum = acting.force.zip(value);
                acting.force = sum.map(|(sum, value)| sum + placed.force * (sign * value));
            }
            if placed.couples[which] != 0.0 {
                let sum = acting.couple.zip(value);
                let unit = placed.couples[which] * self.size;
                acting.couple = sum.map(|(sum, value)| sum + unit * value);
            }
        }
        all
    }

    /// Pair to which a component belongs; None for a drive.
    pub(super) fn pair_of(&self, component: usize) -> Option<PairId> {
        let before = self.starts.partition_point(|start| *start <= component);
        (component < self.held).then(|| PairId(before - 1))
    }
}
