//! A linkage under load as a system of one freedom.

use std::f64::consts::TAU;

use crate::forces::applied::relative;
use crate::forces::friction::{Driven, FrictionTorque, MovingFriction};
use crate::forces::loading::Spring;
use crate::forces::{Loading, Motor, NoCycle, NoRun, Reduced, Unbalanced};
use crate::mechanism::{Pose, Unsolved};
use crate::motion::Motion;
use crate::numeric::gauss::Advance;
use crate::numeric::roots::root;
use crate::tolerance;

/// Distances ahead at which a step takes the contacts of pairs with friction, in units of the input. Near the place at
/// which its sense changes a pair is nearly at rest; its new sense is that at the first distance at which it moves.
const AHEAD: [f64; 3] = [tolerance::TRIPLE_ROOT, 1e-4, 1e-2];

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
    pub(super) friction: Option<MovingFriction>,
    /// Sense of the motion in the current step.
    sense: f64,
    /// Why the last pose that had no torques had none, if reactions are at fault.
    pub(super) unbalanced: Option<Unbalanced>,
}

/// Torques on the input in a pose at a rate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Torques {
    pub(super) reduced: Reduced,
    /// Torque of the motor, and its derivative by the rate.
    pub(super) motor: [f64; 2],
    pub(super) friction: FrictionTorque,
    pub(super) rate: f64,
}

impl Torques {
    /// Torque of all forces but inertia.
    pub(super) fn torque(&self) -> f64 {
        self.reduced.torque(self.rate) + self.motor[0] + self.friction.torque
    }

    pub(super) fn acceleration(&self) -> f64 {
        let centrifugal = 0.5 * self.reduced.inertia_slope * self.rate * self.rate;
        (self.torque() - centrifugal) / self.reduced.inertia
    }

    /// Distance of the pairs with friction from a change of a contact, and a little more than rounding; negative beyond it.
    pub(super) fn margin(&self) -> f64 {
        self.friction.margin + tolerance::NEGLIGIBLE
    }

    /// Power of the motor and of the given forces, and that lost in resistances, dampers and friction.
    pub(super) fn powers(&self) -> [f64; 2] {
        let resistance = self.reduced.resistance(self.rate) + self.friction.torque;
        let given = self.motor[0] + self.reduced.load;
        [given * self.rate, -resistance * self.rate]
    }
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
            friction: MovingFriction::new(mechanism, loading),
            sense: 1.0,
            unbalanced: None,
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

    /// Torques at an input and a rate; None where there is no pose, nothing with a mass moves with the input, or the
    /// friction is not found.
    pub(super) fn torques(&mut self, [input, rate]: [f64; 2]) -> Option<Torques> {
        let reduced = self.reduced(input)?;
        self.torques_in(reduced, [input, rate], false)
    }

    /// The same in the pose placed last, whose reduced quantities are given; with the derivatives of the friction, or
    /// without.
    pub(super) fn torques_in(
        &mut self,
        reduced: Reduced,
        [input, rate]: [f64; 2],
        slopes: bool,
    ) -> Option<Torques> {
        let motor = self.motor.torque(rate);
        let mut friction = FrictionTorque::NONE;
        if let Some(moving) = &mut self.friction {
            let (sense, drive) = (self.sense, motor[0]);
            let at = Driven {
                input,
                rate,
                sense,
                drive,
            };
            let found = moving.torque(&self.loading, self.pose.state(), at, slopes);
            self.unbalanced = found.err();
            friction = found.ok()?;
        }
        Some(Torques {
            reduced,
            motor,
            friction,
            rate,
        })
    }

    /// Reduced quantities at an input, with the friction at a constant rate among the loads, also if the reduced inertia
    /// is zero; None where there is no pose, or the friction is not found. Inertia forces, and so a part of the friction,
    /// have the square of the rate: the friction is exact at the rate and at half of it.
    pub(super) fn at_rate(&mut self, input: f64, rate: f64) -> Option<Reduced> {
        let mut reduced = self.reduced_or_massless(input)?;
        if let Some(moving) = &mut self.friction {
            let mut torque = |rate: f64| {
                let found = moving.at_rate(&self.loading, &self.pose, [input, rate]);
                self.unbalanced = found.err();
                found.ok()
            };
            let (whole, half) = (torque(rate)?, torque(0.5 * rate)?);
            let by_square = (whole - half) / 0.75;
            reduced.load += whole - by_square;
            reduced.quadratic += if rate == 0.0 {
                0.0
            } else {
                by_square / (rate * rate.abs())
            };
        }
        Some(reduced)
    }

    /// Begins a step from an input at a rate in a sense: pairs with friction slide and bear as they do just ahead.
    pub(super) fn take_contacts(&mut self, [input, rate]: [f64; 2], sense: f64) {
        self.sense = sense;
        let Some(moving) = &mut self.friction else {
            return;
        };
        moving.release();
        let ways = AHEAD.map(|ahead| sense * ahead * self.unit);
        for way in ways {
            let is_placed = self.motion.place(input + way, &mut self.pose).is_ok();
            if is_placed && moving.take_senses(&self.loading, self.pose.state()) {
                break;
            }
        }
        // Along the motion the rate changes, too: ω² by 2ε over the way of the input.
        let Some(here) = self.torques([input, rate]) else {
            return;
        };
        let square = rate * rate + 2.0 * here.acceleration() * ways[0];
        let rate = sense * square.max(0.0).sqrt();
        let is_placed = self.place(input + ways[0]).is_ok();
        if let Some(moving) = self.friction.as_mut().filter(|_| is_placed) {
            let at = Driven {
                input: input + ways[0],
                rate,
                sense,
                drive: self.motor.torque(rate)[0],
            };
            moving.take_bearings(&self.loading, self.pose.state(), at);
        }
    }

    /// A step that ends at a pose and before its margin vanishes: where a contact of a pair with friction changes, or the
    /// linkage stops. `trial` makes a step of a length. A step whose root is shorter than `least` has lost a contact from
    /// the start; it keeps the contact for the length `short`. None if no step ends at a pose.
    pub(super) fn ended<const N: usize>(
        &mut self,
        mut advance: Advance<N>,
        [least, short]: [f64; 2],
        mut trial: impl FnMut(&mut Self, f64) -> Option<Advance<N>>,
        margin: impl Fn(&mut Self, &Advance<N>) -> Option<f64>,
    ) -> Option<Advance<N>> {
        let mut end = margin(self, &advance);
        while end.is_none() && advance.length > least {
            advance = trial(self, 0.5 * advance.length)?;
            end = margin(self, &advance);
        }
        let end = end?;
        if end >= 0.0 {
            return Some(advance);
        }
        let ends = [[0.0, -end], [advance.length, end]];
        let length = root(ends, |length| {
            let advance = trial(self, length)?;
            margin(self, &advance)
        })?;
        let short = advance.length.min(short);
        trial(self, if length > least { length } else { short })
    }

    /// Acceleration of the input; zero where friction holds the linkage, or nothing is found.
    pub(super) fn acceleration(&mut self, input: f64, rate: f64) -> f64 {
        let Some(sense) = self.sense(input, rate) else {
            return 0.0;
        };
        self.take_contacts([input, rate], sense);
        let torques = self.torques([input, rate]);
        torques.map_or(0.0, |torques| torques.acceleration())
    }

    /// Sense of the motion, also from rest; None if friction holds the linkage at rest.
    pub(super) fn sense(&mut self, input: f64, rate: f64) -> Option<f64> {
        if rate != 0.0 {
            return Some(rate.signum());
        }
        let mut starts = |sense: f64| {
            self.take_contacts([input, 0.0], sense);
            let torques = self.torques([input, 0.0]);
            torques.is_some_and(|torques| torques.acceleration() * sense > 0.0)
        };
        let moves = [1.0, -1.0].into_iter().find(|sense| starts(*sense));
        moves.or((!self.has_friction()).then_some(1.0))
    }

    /// The reason why a cycle is not found, from the last pose that had no torques.
    pub(super) fn no_cycle(&self) -> NoCycle {
        match self.unbalanced {
            Some(Unbalanced::Locked) => NoCycle::Locked,
            _ => NoCycle::NotFound,
        }
    }

    pub(super) fn has_friction(&self) -> bool {
        self.friction.is_some()
    }

    /// The greatest step from an input in a sense: to the next knot of a table of the loads, at most the span of the
    /// motion.
    pub(super) fn way_to_knot(&self, input: f64, sense: f64) -> f64 {
        let way = self.loading.way_to_knot(input, sense);
        way.min(TAU * self.unit)
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
}
