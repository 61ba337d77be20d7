//! Forces and couples in a pose that are not reactions: weights, inertia, loads, springs and dampers. Those of friction
//! depend on the reactions; `friction` and `moving_friction` add them.

use super::Loading;
use super::loading::{Damper, Load, Spring};
use super::masses::BodyMass;
use crate::Vector;
use crate::index::BodyId;
use crate::position::{BodyPoint, Complex, State, product};

/// A force at a place of a body, and a couple on the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Applied {
    /// The body.
    pub body: BodyId,
    /// Place of the force, from the origin of the coordinates used while solving.
    pub(crate) at: Vector,
    /// Force, x and y.
    pub force: Vector,
    /// Couple, positive counter-clockwise.
    pub couple: f64,
    /// What the force comes from.
    pub source: Source,
}

/// Source of a force: its kind, and for parts of the loading their index in their list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Gravity.
    Weight,
    /// Inertia of the body.
    Inertia,
    /// A load.
    Load(usize),
    /// A spring.
    Spring(usize),
    /// A damper.
    Damper(usize),
    /// Friction in a pair.
    Friction(usize),
}

/// Turn rate of a body with respect to the input, and its second derivative.
pub(super) fn turning(state: &State<3>, body: BodyId) -> [f64; 2] {
    // A turn u = e^(iθ) has θ′ = u × u′ and θ″ = u × u″; u″ is twice the second Taylor coefficient.
    let turn = &state.bodies[body].turn;
    let square = turn[0].norm_squared();
    [
        turn[0].perp(&turn[1]) / square,
        2.0 * turn[0].perp(&turn[2]) / square,
    ]
}

/// Vector between the ends of a spring or damper, and its length l with the derivative l′ with respect to the input.
pub(super) fn stretched(state: &State<3>, [from, to]: [BodyPoint; 2]) -> (Vector, [f64; 2]) {
    let way: Complex<3> = state.place(to) - state.place(from);
    let length = way[0].norm();
    let unit = way[0].try_normalize(0.0).unwrap_or_default();
    (unit, [length, unit.dot(&way[1])])
}

/// Angle of the first body relative to the second, with its derivative with respect to the input.
pub(super) fn relative(state: &State<3>, [one, other]: [BodyId; 2]) -> [f64; 2] {
    let angle = state.angle(one) - state.angle(other);
    [angle.value(), angle.derivative(1)]
}

impl Loading {
    /// Moving bodies with a mass or a flywheel, each with its centre of mass and its turn rates of [`turning`].
    pub(super) fn moving_masses(
        &self,
        state: &State<3>,
    ) -> impl Iterator<Item = (BodyId, &BodyMass, Complex<3>, [f64; 2])> {
        let moving = self.masses.enumerate().skip(1);
        moving
            .filter(|(_, mass)| mass.mass != 0.0 || mass.inertia != 0.0)
            .map(|(body, mass)| {
                let local = mass.centre;
                let centre = state.place(BodyPoint { body, local });
                (body, mass, centre, turning(state, body))
            })
    }

    /// Inertia forces in a pose at a unit acceleration of the input from rest.
    pub(super) fn unit_acceleration(&self, state: &State<3>) -> impl Iterator<Item = Applied> {
        self.moving_masses(state)
            .map(|(body, mass, centre, [turn, _])| Applied {
                body,
                at: centre[0],
                force: centre[1] * -mass.mass,
                couple: -mass.inertia * turn,
                source: Source::Inertia,
            })
    }

    /// Adds the forces in a pose to a list, without friction. The input has a rate and an acceleration with respect to time.
    pub(super) fn apply(
        &self,
        state: &State<3>,
        input: f64,
        [rate, acceleration]: [f64; 2],
        list: &mut Vec<Applied>,
    ) {
        for (body, mass, centre, [turn, twice]) in self.moving_masses(state) {
            let (at, square) = (centre[0], rate * rate);
            if mass.mass != 0.0 && self.gravity != Vector::zeros() {
                list.push(Applied {
                    body,
                    at,
                    force: self.gravity * mass.mass,
                    couple: 0.0,
                    source: Source::Weight,
                });
            }
            let accelerated = centre[2] * (2.0 * square) + centre[1] * acceleration;
            list.push(Applied {
                body,
                at,
                force: accelerated * -mass.mass,
                couple: -mass.inertia * (twice * square + turn * acceleration),
                source: Source::Inertia,
            });
        }
        for (index, load) in self.loads.iter().enumerate() {
            let (body, at, force, couple) = self.load(load, state, input, rate);
            let source = Source::Load(index);
            list.push(Applied {
                body,
                at,
                force,
                couple,
                source,
            });
        }
        for (index, spring) in self.springs.iter().enumerate() {
            let source = Source::Spring(index);
            match *spring {
                Spring::Straight {
                    ends,
                    stiffness,
                    free_length,
                } => {
                    let (unit, [length, _]) = stretched(state, ends);
                    pull(
                        state,
                        ends,
                        unit * (stiffness * (length - free_length)),
                        source,
                        list,
                    );
                }
                Spring::Torsion {
                    bodies,
                    stiffness,
                    free_angle,
                } => {
                    let [angle, _] = relative(state, bodies);
                    twist(
                        state,
                        bodies,
                        -stiffness * (angle - free_angle),
                        source,
                        list,
                    );
                }
            }
        }
        for (index, damper) in self.dampers.iter().enumerate() {
            let source = Source::Damper(index);
            match *damper {
                Damper::Straight { ends, damping } => {
                    let (unit, [_, stretching]) = stretched(state, ends);
                    pull(
                        state,
                        ends,
                        unit * (damping * stretching * rate),
                        source,
                        list,
                    );
                }
                Damper::Torsion { bodies, damping } => {
                    let [one, other] = bodies.map(|body| turning(state, body)[0]);
                    twist(state, bodies, -damping * (one - other) * rate, source, list);
                }
            }
        }
    }

    fn load(
        &self,
        load: &Load,
        state: &State<3>,
        input: f64,
        rate: f64,
    ) -> (BodyId, Vector, Vector, f64) {
        let none = Vector::zeros();
        match load {
            Load::Force {
                at,
                direction,
                turns,
                law,
            } => {
                let direction = directed(state, *at, *direction, *turns);
                let force = direction * law.value(input, self.turns);
                (at.body, state.place(*at)[0], force, 0.0)
            }
            Load::Torque { body, law } => {
                let at = state.bodies[*body].origin[0];
                (*body, at, none, law.value(input, self.turns))
            }
            Load::Drag {
                at,
                coefficients: [linear, square],
            } => {
                let place = state.place(*at);
                let velocity = place[1] * rate;
                let force = velocity * -(linear + square * velocity.norm());
                (at.body, place[0], force, 0.0)
            }
            Load::AngularDrag {
                body,
                coefficients: [linear, square],
            } => {
                let at = state.bodies[*body].origin[0];
                let rate = turning(state, *body)[0] * rate;
                (*body, at, none, -(linear + square * rate.abs()) * rate)
            }
        }
    }
}

/// Direction of a force in the frame.
pub(super) fn directed(state: &State<3>, at: BodyPoint, own: Vector, turns: bool) -> Vector {
    if turns {
        product(own, state.bodies[at.body].turn[0])
    } else {
        own
    }
}

/// Adds the forces at the two ends of a spring or damper; `force` is that on the first end.
fn pull(
    state: &State<3>,
    ends: [BodyPoint; 2],
    force: Vector,
    source: Source,
    list: &mut Vec<Applied>,
) {
    for (end, force) in ends.into_iter().zip([force, -force]) {
        list.push(Applied {
            body: end.body,
            at: state.place(end)[0],
            force,
            couple: 0.0,
            source,
        });
    }
}

/// Adds the couples on the two bodies of a spring or damper; `couple` is that on the first body.
fn twist(
    state: &State<3>,
    bodies: [BodyId; 2],
    couple: f64,
    source: Source,
    list: &mut Vec<Applied>,
) {
    for (body, couple) in bodies.into_iter().zip([couple, -couple]) {
        list.push(Applied {
            body,
            at: state.bodies[body].origin[0],
            force: Vector::zeros(),
            couple,
            source,
        });
    }
}
