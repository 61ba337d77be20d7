//! A linkage under load as a system of one freedom.

use std::f64::consts::TAU;

use super::applied::relative;
use super::loading::Spring;
use super::{Loading, Motor, NoRun, Reduced};
use crate::mechanism::{Pose, Unsolved};
use crate::motion::Motion;
use crate::tolerance;

/// A linkage under load with one freedom.
#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) motion: Motion,
    pub(super) loading: Loading,
    pub(super) motor: Motor,
    /// Scalar product of gravity with the origin of the coordinates used while solving.
    height: f64,
    pose: Pose<3>,
    /// Unit of the input: a radian, or a part of the range of a slide.
    pub(super) unit: f64,
    /// Knots of the tables of loads.
    knots: Vec<f64>,
}

impl System {
    pub(super) fn new(motion: &Motion, loading: &Loading, motor: &Motor) -> Result<Self, NoRun> {
        motor.check().map_err(NoRun::Motor)?;
        let mechanism = motion.mechanism();
        if mechanism.spec().drivers.len() != 1 {
            return Err(NoRun::SeveralDrivers);
        }
        let mut system = Self {
            motion: motion.clone(),
            loading: loading.clone(),
            motor: motor.clone(),
            height: mechanism.middle().coords.dot(&loading.gravity),
            pose: mechanism.blank(),
            unit: mechanism.span() / TAU,
            knots: loading.knots().collect(),
        };
        match system.wound() {
            Some(index) => Err(NoRun::Wound(index)),
            None => Ok(system),
        }
    }

    /// A spring between links of which one turns fully relative to the other over the cycle of the motion.
    fn wound(&mut self) -> Option<usize> {
        let cycle = self.motion.cycle();
        let &[from, to] = cycle.arcs().first().filter(|_| cycle.is_full())?;
        let ends = [from, to - tolerance::DOUBLE_ROOT * (to - from)];
        let springs = self.loading.springs.clone();
        springs.iter().position(|spring| {
            let Spring::Torsion { bodies, .. } = spring else {
                return false;
            };
            let angles = ends.map(|input| {
                let placed = self.motion.place(input, &mut self.pose);
                placed.map(|()| relative(self.pose.state(), *bodies)[0])
            });
            matches!(angles, [Ok(first), Ok(last)] if (last - first).abs() > 1.0)
        })
    }

    /// Reduced quantities at an input; None where there is no pose, or nothing with a mass moves with the input.
    pub(super) fn reduced(&mut self, input: f64) -> Option<Reduced> {
        let reduced = self.reduced_or_massless(input)?;
        (reduced.inertia > 0.0).then_some(reduced)
    }

    /// Reduced quantities at an input, also if the reduced inertia is zero; None where there is no pose.
    pub(super) fn reduced_or_massless(&mut self, input: f64) -> Option<Reduced> {
        self.place(input).ok()?;
        let state = self.pose.state();
        Some(self.loading.reduced_in(state, input, self.height))
    }

    /// Way from an input in a sense to the next knot of a table. A step beyond it would not see the knot if no
    /// stage is behind it.
    pub(super) fn way_to_knot(&self, input: f64, sense: f64) -> f64 {
        let ways = self.knots.iter().map(|knot| {
            let way = (sense * (knot - input)).rem_euclid(TAU);
            if way > tolerance::NEGLIGIBLE {
                way
            } else {
                TAU
            }
        });
        ways.fold(TAU, f64::min)
    }

    /// Part of each moving body in the reduced moment of inertia at an input; None where there is no pose.
    pub(super) fn shares(&mut self, input: f64) -> Option<impl Iterator<Item = f64>> {
        self.place(input).ok()?;
        let masses = self.loading.moving_masses(self.pose.state());
        Some(masses.map(|(_, mass, centre, [turn, _])| {
            mass.mass * centre[1].norm_squared() + mass.inertia * turn * turn
        }))
    }

    pub(super) fn place(&mut self, input: f64) -> Result<(), Unsolved> {
        self.motion.place(input, &mut self.pose)
    }

    pub(super) fn acceleration(&self, reduced: &Reduced, rate: f64) -> f64 {
        let torque = reduced.torque(rate) + self.motor.torque(rate)[0];
        (torque - 0.5 * reduced.inertia_slope * rate * rate) / reduced.inertia
    }
}
