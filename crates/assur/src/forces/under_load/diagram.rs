//! Wittenbauer's diagram: energy over reduced inertia through a cycle at a constant rate.

use super::balance::{Balance, balanced, interval, work};
use super::system::System;
use crate::forces::{Loading, Motor, NoCycle};
use crate::motion::Motion;
use crate::numeric::roots::bisect;
use crate::tolerance;

/// Energy and reduced moment of inertia through the cycle of a linkage without its flywheel, at the constant rate at
/// which the work of the drive over a cycle is that of the loads.
///
/// The change of the energy is exact if no force depends on the rate. Otherwise it is that at the mean rate, which a
/// cycle approaches as it becomes uniform.
#[derive(Clone, Debug)]
pub struct Diagram {
    system: System,
    balance: Balance,
    rate: f64,
    torque: f64,
    points: Vec<DiagramPoint>,
    /// Part of the reduced inertia that is the same in all poses.
    pub(super) constant: f64,
}

/// Point of a diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramPoint {
    /// Input.
    pub input: f64,
    /// Reduced moment of inertia J without the flywheel.
    pub inertia: f64,
    /// Change ΔE of the energy since the first point.
    pub energy: f64,
}

impl Diagram {
    /// The diagram of a linkage with a motor, near a rate; or without a motor, with a constant torque at a given mean
    /// rate, see [`crate::forces::SteadyCycle::new`].
    ///
    /// # Errors
    /// The reason why there is no cycle.
    pub fn new(
        motion: &Motion,
        loading: &Loading,
        motor: Option<&Motor>,
        rate: f64,
    ) -> Result<Self, NoCycle> {
        let bare = loading.with_flywheel(0.0);
        let (mut system, balance, steady) = balanced(motion, &bare, motor, rate)?;
        let torque = steady.motor.torque(steady.rate)[0];
        let mut energy = 0.0;
        let mut points = Vec::new();
        let mut shares: Vec<[f64; 2]> = Vec::new();
        let works = balance.works.iter().map(Some).chain([None]);
        for (k, works) in works.enumerate() {
            let input = k as f64 * balance.step;
            let mut inertia = 0.0;
            for (body, share) in system.shares(input).ok_or(NoCycle::NotFound)?.enumerate() {
                inertia += share;
                match shares.get_mut(body) {
                    Some([least, most]) => {
                        (*least, *most) = (least.min(share), most.max(share));
                    }
                    None => shares.push([share; 2]),
                }
            }
            points.push(DiagramPoint {
                input,
                inertia,
                energy,
            });
            energy += works.map_or(0.0, |one| work(*one, steady.rate) + torque * balance.step);
        }
        let alike = shares
            .iter()
            .filter(|[least, most]| most - least <= tolerance::COINCIDENT * most);
        let constant = alike.map(|[least, _]| least).sum();
        Ok(Self {
            system,
            balance,
            rate: steady.rate,
            torque,
            points,
            constant,
        })
    }

    /// The constant rate, which is the mean rate ω_m of the methods.
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// Torque of the drive at this rate.
    pub fn torque(&self) -> f64 {
        self.torque
    }

    /// Points through the cycle; the last is the first a period later.
    pub fn points(&self) -> &[DiagramPoint] {
        &self.points
    }

    /// The point at which a line of a slope k touches the diagram from above (`sense` 1) or from below (−1): there
    /// ΔE − kJ is greatest or least.
    pub(super) fn touch(&mut self, slope: f64, sense: f64) -> DiagramPoint {
        let height = |point: &DiagramPoint| sense * (point.energy - slope * point.inertia);
        let steps = self.points.len() - 1;
        let best =
            (0..steps).max_by(|a, b| height(&self.points[*a]).total_cmp(&height(&self.points[*b])));
        let best = best.unwrap_or(0);
        let sample = self.points[best];
        // The extreme itself is where the slope of ΔE − kJ by the input changes its sign.
        let (step, rate, torque) = (self.balance.step, self.rate, self.torque);
        let ends = [sample.input - step, sample.input + step];
        let system = &mut self.system;
        let mut rises = |input: f64| {
            system.at_rate(input, rate).is_some_and(|reduced| {
                let slope_of_energy = reduced.torque(rate) + torque;
                sense * (slope_of_energy - slope * reduced.inertia_slope) > 0.0
            })
        };
        if !rises(ends[0]) || rises(ends[1]) {
            return sample;
        }
        let found = bisect(ends, rises);
        let before = if found < sample.input {
            (best + steps - 1) % steps
        } else {
            best
        };
        let from = if found < sample.input {
            ends[0]
        } else {
            sample.input
        };
        let works = interval(system, [from, found - from], rate);
        let reduced = system.reduced_or_massless(found);
        works
            .zip(reduced)
            .map_or(sample, |(works, reduced)| DiagramPoint {
                input: found,
                inertia: reduced.inertia,
                energy: self.points[before].energy + work(works, rate) + torque * (found - from),
            })
    }
}
