//! Reactions of the pairs of a mechanism in a pose, and the torques and forces of its drives.

use super::applied::Applied;
use super::block::{Matrix, Total};
use super::pair::{Component, DriverId, Pair, PairId, Placed, Wrench};
use super::{Kinetostatics, Rubbing};
use crate::index::{BodyId, List};
use crate::mechanism::Mechanism;
use crate::position::State;
use crate::{Point, Vector};

/// Reactions of a mechanism in a pose, found by [`super::Kinetostatics::reactions`].
#[derive(Clone, Debug, Default)]
pub struct Reactions {
    reactions: Vec<Reaction>,
    drives: Vec<Option<f64>>,
    pub(super) applied: Vec<Applied>,
    /// Components of pairs and drives; None if statically indeterminate.
    pub(super) components: Vec<Option<f64>>,
    pub(super) values: Vec<f64>,
    pub(super) friction: Vec<Rubbing>,
    /// Components of the drives without friction; empty if there is none.
    pub(super) bare: Vec<f64>,
    held: usize,
    pub(super) placed: Vec<Placed>,
    pub(super) totals: List<BodyId, Total>,
    pub(super) matrices: Vec<Matrix>,
}

/// Reaction of a pair on the first of its bodies from the second. None stands for what is statically indeterminate:
/// redundant constraints share it, and equilibrium does not say how.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reaction {
    /// Force, x and y.
    pub force: [Option<f64>; 2],
    /// Moment about the hinge, the sliding point or the pitch point. It is zero except in a slide, whose normal force
    /// acts at the distance moment/force along the line from the sliding point, and in a mesh with an idler.
    pub moment: Option<f64>,
    /// Place of the force, from the origin of the coordinates used while solving.
    pub(crate) at: Vector,
}

impl Reaction {
    /// Force as a vector; None if a component is indeterminate.
    pub fn vector(&self) -> Option<Vector> {
        let [x, y] = self.force;
        Some(Vector::new(x?, y?))
    }

    /// True if the force and the moment are determined.
    pub fn is_determined(&self) -> bool {
        self.vector().is_some() && self.moment.is_some()
    }

    /// Place of the force.
    pub fn place(&self, mechanism: &Mechanism) -> Point {
        mechanism.middle() + self.at
    }

    /// The same reaction on the second body from the first.
    pub fn reversed(&self) -> Self {
        let opposite = |value: f64| 0.0 - value;
        Self {
            force: self.force.map(|value| value.map(opposite)),
            moment: self.moment.map(opposite),
            at: self.at,
        }
    }
}

impl Applied {
    /// Place of the force.
    pub fn place(&self, mechanism: &Mechanism) -> Point {
        mechanism.middle() + self.at
    }
}

impl Reactions {
    /// Reaction of a pair on the first of its bodies.
    pub fn of(&self, pair: PairId) -> &Reaction {
        &self.reactions[pair.0]
    }

    /// Torque or force of a driver on its driven link; None if statically indeterminate.
    pub fn drive(&self, driver: DriverId) -> Option<f64> {
        self.drives[driver.0]
    }

    /// Torque or force of the first driver; None if there is none or it is indeterminate.
    pub fn first_drive(&self) -> Option<f64> {
        self.drives.first().copied().flatten()
    }

    /// Forces that are not reactions: weights, inertia, loads, springs and dampers, and the friction in pairs.
    pub fn applied(&self) -> &[Applied] {
        &self.applied
    }

    /// Component of the first drive.
    pub(super) fn first_component(&self) -> Option<f64> {
        self.components.get(self.held).copied().flatten()
    }

    /// Places the components of pairs and drives in a pose.
    pub(super) fn place(&mut self, forces: &Kinetostatics, state: &State<3>) {
        self.placed.clear();
        for component in &forces.components {
            // The y-component of a hinge has the place of its x-component, the component before it.
            let placed = match (component.wrench, self.placed.last()) {
                (Wrench::Y(_), Some(x)) => Placed {
                    force: Vector::y(),
                    ..*x
                },
                _ => component.placed(state),
            };
            self.placed.push(placed);
        }
    }

    pub(super) fn fill(
        &mut self,
        pairs: &[Pair],
        starts: &[usize],
        components: &[Component],
        held: usize,
        size: f64,
    ) {
        self.held = held;
        let found = &self.components;
        let reactions = pairs.iter().zip(starts).map(|(pair, start)| {
            let placed = &self.placed[*start];
            let along = |value: Option<f64>| {
                let force = value.map(|value| placed.force * value);
                [force.map(|force| force.x), force.map(|force| force.y)]
            };
            let value = found[*start];
            let (force, moment) = match components[*start].wrench {
                Wrench::X(_) | Wrench::Y(_) => ([value, found[start + 1]], Some(0.0)),
                Wrench::Normal(_) => {
                    let couple = found[start + 1];
                    (along(value), couple.map(|couple| couple * size))
                }
                Wrench::Couples(all) => ([Some(0.0); 2], value.map(|value| value * all[0] * size)),
                _ => (along(value), Some(0.0)),
            };
            debug_assert!(pair.bodies[0] == components[*start].bodies[0]);
            Reaction {
                force,
                moment,
                at: placed.at,
            }
        });
        self.reactions.clear();
        self.reactions.extend(reactions);
        self.drives.clear();
        let drives = components[held..].iter().zip(&found[held..]);
        self.drives.extend(drives.map(|(drive, value)| {
            let unit = match drive.wrench {
                Wrench::Couple => size,
                _ => 1.0,
            };
            value.map(|value| value * unit)
        }));
    }
}
