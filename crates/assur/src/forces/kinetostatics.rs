//! Reactions and balancing torques of a mechanism in a pose, block by block in the order opposite to solving.

use std::f64::consts::TAU;

use super::applied::Applied;
use super::block::{Block, Form, Held, Matrix, Total, Work};
use super::pair::{Component, DriverId, Kind, Pair, PairId, Wrench, drives, pairs, placing};
use super::{Loading, Reactions};
use crate::index::{BodyId, Id, StepId};
use crate::mechanism::{Mechanism, Pose};
use crate::position::State;

/// Pairs, drives and order of the equilibrium of a mechanism.
///
/// A group of n bodies has 3n equations of equilibrium and as many components of reactions. The last group is loaded by
/// known forces alone; its reactions load the bodies on which it hangs.
#[derive(Clone, Debug)]
pub struct Kinetostatics {
    pub(super) pairs: Vec<Pair>,
    /// Index of the first component of each pair.
    pub(super) starts: Vec<usize>,
    /// Components of the pairs, then the drives.
    pub(super) components: Vec<Component>,
    /// Number of components of pairs.
    pub(super) held: usize,
    pub(super) blocks: Vec<Block>,
    bodies: usize,
    pub(super) size: f64,
    /// Unit of the input: a radian, or a part of the range of a slide.
    unit: f64,
}

/// The reason why a pose has no reactions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unbalanced {
    /// The bodies placed by a step cannot be balanced: the pose is singular, and reactions are unbounded.
    Singular {
        /// The step; [`Mechanism::links_of`] gives the names of its links.
        step: StepId,
    },
    /// No reactions satisfy the law of friction: the mechanism is self-locking.
    Locked,
    /// Newton's method does not find reactions that satisfy the law of friction. Whether there are any is unknown.
    Unsettled,
}

impl Kinetostatics {
    /// Pairs and order of equilibrium of a mechanism.
    pub fn new(mechanism: &Mechanism) -> Self {
        let pairs = pairs(mechanism);
        let mut starts = Vec::with_capacity(pairs.len());
        let mut components = Vec::new();
        for pair in &pairs {
            starts.push(components.len());
            components.extend(pair.components());
        }
        let held = components.len();
        components.extend(drives(mechanism));
        let mut found = Self {
            starts,
            held,
            bodies: mechanism.bodies().len(),
            size: mechanism.scale_of_places(),
            unit: mechanism.span() / TAU,
            blocks: Vec::new(),
            components,
            pairs,
        };
        found.blocks = if mechanism.is_redundant() {
            vec![Block {
                step: StepId::FIRST,
                bodies: mechanism.bodies().skip(1).collect(),
                components: (0..found.components.len()).collect(),
                form: Form::Redundant,
            }]
        } else {
            let steps = mechanism.steps().ids().rev();
            steps.map(|step| found.block(mechanism, step)).collect()
        };
        found
    }

    fn block(&self, mechanism: &Mechanism, step: StepId) -> Block {
        let last = |component: &Component| {
            let bodies = component.on();
            bodies.map(|body| placing(mechanism, body)).max()
        };
        let own = self.components.iter().enumerate();
        let own = own.filter(|(_, component)| last(component) == Some(step.number() + 1));
        let mut block = Block {
            step,
            bodies: mechanism.steps()[step].bodies(),
            components: own.map(|(index, _)| index).collect(),
            form: Form::Redundant,
        };
        block.form = self.form(&block).unwrap_or_else(|| Form::Group {
            pattern: block.pattern(&self.components),
        });
        block
    }

    /// Closed form of a block; None for a group that needs a matrix.
    fn form(&self, block: &Block) -> Option<Form> {
        let drives = block.components.iter().filter(|index| **index >= self.held);
        let drives: Vec<usize> = drives.copied().collect();
        let lower = self.pairs.iter().zip(&self.starts);
        let lower = lower.filter(|(pair, start)| {
            !matches!(pair.kind, Kind::Mesh(_)) && block.components.contains(start)
        });
        let lower: Vec<(&Pair, Held)> = lower
            .map(|(pair, start)| (pair, Held([*start, start + 1])))
            .collect();
        if block.components.len() != 2 * lower.len() + drives.len() {
            return None;
        }
        let inside = |body: &BodyId| block.bodies.contains(body);
        match (&block.bodies[..], &lower[..], &drives[..]) {
            ([body], [(pair, held)], [drive]) => {
                let wrench = self.components[*drive].wrench;
                let fits = matches!(wrench, Wrench::Along(_)) == pair.is_slide();
                let own = self.components[*drive].bodies.contains(body);
                (fits && own).then_some(Form::Driven {
                    pair: *held,
                    drive: *drive,
                })
            }
            ([i, j], [_, _, _], []) => {
                let outer = |body: &BodyId| {
                    let mut of = lower.iter().filter(|(pair, _)| {
                        pair.bodies.contains(body) && !pair.bodies.iter().all(inside)
                    });
                    of.next().map(|(_, held)| *held)
                };
                let mut inner = lower.iter();
                let inner = inner.find(|(pair, _)| pair.bodies.iter().all(inside));
                Some(Form::Dyad {
                    outer: [outer(i)?, outer(j)?],
                    inner: inner?.1.0,
                })
            }
            _ => None,
        }
    }

    /// The pairs: hinges in the order of the points, then slides, then meshes.
    pub fn pairs(&self) -> impl ExactSizeIterator<Item = (PairId, &Pair)> {
        self.pairs
            .iter()
            .enumerate()
            .map(|(k, pair)| (PairId(k), pair))
    }

    /// The drivers, in the order of the specification.
    pub fn drivers(&self) -> impl ExactSizeIterator<Item = DriverId> + use<> {
        (0..self.components.len() - self.held).map(DriverId)
    }

    /// Bodies of the blocks, in the order in which their reactions are found.
    pub fn order(&self) -> impl Iterator<Item = &[BodyId]> {
        self.blocks.iter().map(|block| &block.bodies[..])
    }

    /// Reactions in a pose at an input with a rate and an acceleration with respect to time.
    ///
    /// # Errors
    /// The pose is singular, the mechanism is self-locking in it, or its friction is not found.
    pub fn reactions(
        &self,
        loading: &Loading,
        pose: &Pose<3>,
        input: f64,
        motion: [f64; 2],
    ) -> Result<Reactions, Unbalanced> {
        let mut found = Reactions::default();
        self.balance(loading, pose, input, motion, &mut found)?;
        Ok(found)
    }

    /// Writes the reactions in a pose into `found`, whose buffers are used again.
    ///
    /// # Errors
    /// Those of [`Self::reactions`]; `found` is then invalid.
    pub fn balance(
        &self,
        loading: &Loading,
        pose: &Pose<3>,
        input: f64,
        motion: [f64; 2],
        found: &mut Reactions,
    ) -> Result<(), Unbalanced> {
        let state = pose.state();
        found.applied.clear();
        loading.apply(state, input, motion, &mut found.applied);
        found.place(self, state);
        found.friction.clear();
        found.bare.clear();
        self.solve(state, found)?;
        if !loading.friction.is_empty() {
            self.rub(loading, state, motion[0], found)?;
        }
        found.fill(
            &self.pairs,
            &self.starts,
            &self.components,
            self.held,
            self.size,
        );
        Ok(())
    }

    /// Finds the components of pairs and drives that balance the applied forces in `found`.
    pub(super) fn solve(&self, state: &State<3>, found: &mut Reactions) -> Result<(), Unbalanced> {
        if found.totals.len() != self.bodies {
            found.totals = vec![Total::default(); self.bodies].into();
        }
        for total in found.totals.iter_mut() {
            *total = Total::default();
        }
        for Applied {
            body,
            at,
            force,
            couple,
            ..
        } in &found.applied
        {
            let arm = at - state.bodies[*body].origin[0];
            let total = &mut found.totals[*body];
            total.force += force;
            total.moment += arm.perp(force) + couple;
        }
        found.values.clear();
        found.values.resize(self.components.len(), 0.0);
        found.matrices.resize(self.blocks.len(), Matrix::default());
        found.components.clear();
        found.components.resize(self.components.len(), None);
        for (block, matrix) in self.blocks.iter().zip(&mut found.matrices) {
            let mut work = Work {
                state,
                components: &self.components,
                placed: &found.placed,
                totals: &mut found.totals,
                values: &mut found.values,
                size: self.size,
                matrix,
            };
            let step = block.step;
            if block.form == Form::Redundant {
                let solved = block.redundant(&mut work, &mut found.components);
                solved.ok_or(Unbalanced::Singular { step })?;
            } else {
                let solved = block.solve(&mut work);
                solved.ok_or(Unbalanced::Singular { step })?;
                for component in &block.components {
                    found.components[*component] = Some(found.values[*component]);
                }
            }
        }
        Ok(())
    }

    /// A pair, with the index of its first component.
    pub(super) fn held(&self, pair: PairId) -> (usize, &Pair) {
        (self.starts[pair.0], &self.pairs[pair.0])
    }

    /// Number of components of pairs, before those of the drives.
    pub(super) fn pairs_held(&self) -> usize {
        self.held
    }

    /// Unit of the input.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// Length by which couples are divided.
    pub(super) fn size(&self) -> f64 {
        self.size
    }
}
