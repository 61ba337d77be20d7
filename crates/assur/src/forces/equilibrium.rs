//! The equations of equilibrium of a body as a student writes them: ΣX, ΣY and ΣM about any point, with the unknowns in
//! senses of the student's choice.

use super::free_body::Cause;
use super::pair::{DriverId, Wrench};
use super::plan::{Component, ForceName};
use super::{Kinetostatics, Reactions};
use crate::index::BodyId;
use crate::mechanism::Mechanism;
use crate::{Point, Vector};

/// Factors smaller than this, for moments relative to the size of the mechanism, are rounding errors of zero.
const NOTHING: f64 = 1e-9;

/// Tolerance of an arm that a student reads off a drawing or rounds to three digits, relative to the arm.
const READ_OFF: f64 = 0.01;

/// An addend of the equations of equilibrium of a body: a force along a line, or a couple, in a given or chosen sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Addend {
    /// Its name.
    pub name: ForceName,
    /// True for a couple.
    pub is_couple: bool,
    /// Number of an unknown, by which its sense is chosen; None for a given force.
    pub unknown: Option<usize>,
    /// Place of the force, from the origin of the coordinates used while solving.
    at: Vector,
    /// Unit vector of the force in its sense; zero for a couple.
    pub direction: Vector,
    /// Its factors in ΣX, ΣY and ΣM: of a force the components of its unit vector and its arm, positive if it turns
    /// counter-clockwise; of a couple its sense, 1 or −1, in ΣM alone.
    pub factors: [f64; 3],
    /// Size in this sense; an unknown of negative size acts in the opposite one. None if statically indeterminate.
    pub size: Option<f64>,
}

/// Judgement of what a student gives for an addend; None where nothing is given or there is nothing to give.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Judged {
    /// Whether the signs in ΣX, ΣY and ΣM are right.
    pub signs: [Option<bool>; 3],
    /// Whether the arm is right.
    pub arm: Option<bool>,
}

impl Addend {
    /// Place of the force, or of the pair of a couple.
    pub fn place(&self, mechanism: &Mechanism) -> Point {
        mechanism.middle() + self.at
    }

    /// Whether the addend may be in an equation: a couple is in ΣM alone.
    pub fn is_in(&self, equation: usize) -> bool {
        !self.is_couple || equation == 2
    }

    /// Judges signs −1, 0 or 1 in ΣX, ΣY and ΣM, and an arm; NaN stands for what is not given. An arm may differ by one
    /// per cent; that of a couple is not judged.
    pub fn judged(&self, signs: [f64; 3], arm: f64) -> Judged {
        let mut judged = Judged::default();
        for (k, sign) in signs.into_iter().enumerate() {
            let factor = self.factors[k];
            let right = if factor == 0.0 { 0.0 } else { factor.signum() };
            if self.is_in(k) && !sign.is_nan() {
                judged.signs[k] = Some(sign == right);
            }
        }
        let right = self.factors[2].abs();
        if !self.is_couple && !arm.is_nan() {
            judged.arm = Some((arm - right).abs() <= READ_OFF * right);
        }
        judged
    }
}

impl Kinetostatics {
    /// Addends of the equations of equilibrium of a body, moments about a place: given forces and couples in the senses
    /// in which they act, then the unknowns. Each component of a reaction is an unknown: x and y of a hinge, normal
    /// force and moment of a slide; then the balancing torques and forces.
    ///
    /// An unknown acts on the first body of its pair to the right, upwards, to the left of the line of a slide, or
    /// counter-clockwise, unless its number is in `reversed`; on the second body it is opposite.
    pub fn equilibrium(
        &self,
        mechanism: &Mechanism,
        found: &Reactions,
        body: BodyId,
        about: Point,
        reversed: &[usize],
    ) -> Vec<Addend> {
        let equations = Equations {
            about: about - mechanism.middle(),
            size: self.size,
            body,
        };
        let mut addends = Vec::new();
        for one in found.applied.iter().filter(|one| one.body == body) {
            let cause = Cause::Applied(one.source);
            let blank = equations.blank(cause, Component::Whole, one.at);
            let size = one.force.norm();
            if size > 0.0 {
                addends.push(equations.force(blank, one.force / size, Some(size)));
            }
            if one.couple != 0.0 {
                addends.push(equations.couple(blank, one.couple, Some(one.couple.abs())));
            }
        }
        for (index, component) in self.components.iter().enumerate() {
            let Some(which) = component.on().position(|one| one == body) else {
                continue;
            };
            let [a, b] = component.bodies;
            let from = if a == body { b } else { a };
            let cause = match self.pair_of(index) {
                Some(pair) => Cause::Reaction { pair, from },
                None => {
                    let driver = DriverId(index - self.held);
                    Cause::Drive { driver, from }
                }
            };
            let part = match component.wrench {
                Wrench::X(_) => Component::X,
                Wrench::Y(_) => Component::Y,
                _ => Component::Whole,
            };
            let sense = if reversed.contains(&index) { -1.0 } else { 1.0 };
            let placed = &found.placed[index];
            let size = found.components[index].map(|value| value * sense);
            // The moment of a slide is about its sliding point, where its normal force acts.
            let at = match self.pair_of(index) {
                Some(pair) => found.placed[self.starts[pair.0]].at,
                None => placed.at,
            };
            let mut blank = equations.blank(cause, part, at);
            blank.unknown = Some(index);
            let on_body = [1.0, -1.0, 0.0][which] * sense;
            if placed.force != Vector::zeros() && on_body != 0.0 {
                addends.push(equations.force(blank, placed.force * on_body, size));
            }
            let unit = placed.couples[which] * self.size;
            if unit != 0.0 {
                let size = size.map(|size| size * unit.abs());
                addends.push(equations.couple(blank, unit * sense, size));
            }
        }
        addends
    }
}

/// The equations of a body, with moments about a place.
struct Equations {
    about: Vector,
    size: f64,
    body: BodyId,
}

impl Equations {
    fn blank(&self, cause: Cause, part: Component, at: Vector) -> Addend {
        Addend {
            name: ForceName {
                body: self.body,
                cause,
                part,
            },
            is_couple: false,
            unknown: None,
            at,
            direction: Vector::zeros(),
            factors: [0.0; 3],
            size: None,
        }
    }

    fn force(&self, blank: Addend, direction: Vector, size: Option<f64>) -> Addend {
        let arm = (blank.at - self.about).perp(&direction);
        let clear = |value: f64, scale: f64| {
            if value.abs() <= NOTHING * scale {
                0.0
            } else {
                value
            }
        };
        Addend {
            direction,
            factors: [
                clear(direction.x, 1.0),
                clear(direction.y, 1.0),
                clear(arm, self.size),
            ],
            size,
            ..blank
        }
    }

    fn couple(&self, blank: Addend, sense: f64, size: Option<f64>) -> Addend {
        Addend {
            is_couple: true,
            factors: [0.0, 0.0, sense.signum()],
            size,
            ..blank
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forces::{Loading, samples};
    use crate::motion::Motion;

    /// The slider-crank with its reactions: the rod has the force (100, −70) in B and (−100, 80) in C; the guide exerts
    /// 100 on the slider.
    fn slider_crank() -> (Motion, Kinetostatics, Reactions) {
        let (motion, spec) = samples::slider_crank();
        let mechanism = motion.mechanism();
        let loading = Loading::new(mechanism, &spec).unwrap();
        let forces = Kinetostatics::new(mechanism);
        let input = motion.drawn_input();
        let pose = motion.pose::<3>(input).unwrap();
        let found = forces.reactions(&loading, &pose, input, [0.0; 2]).unwrap();
        (motion, forces, found)
    }

    fn body(mechanism: &Mechanism, name: &str) -> BodyId {
        mechanism.body_of(mechanism.link(name))
    }

    fn near(found: [f64; 3], wanted: [f64; 3]) {
        for (one, other) in found.into_iter().zip(wanted) {
            assert!((one - other).abs() < 1e-12, "{found:?}, not {wanted:?}");
        }
    }

    #[test]
    fn the_rod_by_hand() {
        let (motion, forces, found) = slider_crank();
        let mechanism = motion.mechanism();
        let rod = body(mechanism, "rod");
        let about_b = Point::new(0.0, 3.0);
        let all = forces.equilibrium(mechanism, &found, rod, about_b, &[]);
        assert_eq!(all.len(), 5);
        // The weight, and the components in C, whose pair has the slider as its first or second body.
        near(all[0].factors, [0.0, -1.0, -2.0]);
        assert_eq!((all[0].size, all[0].unknown), (Some(10.0), None));
        for one in &all[1..] {
            let force = one.direction * one.size.unwrap();
            let at = one.place(mechanism);
            let whole = if (at - about_b).norm() < 1e-12 {
                near([one.factors[2], 0.0, 0.0], [0.0; 3]);
                Vector::new(100.0, -70.0)
            } else {
                Vector::new(-100.0, 80.0)
            };
            let part = one.direction * one.direction.dot(&whole);
            assert!((force - part).norm() < 1e-12, "{force}");
        }
    }

    #[test]
    fn a_reversed_unknown_changes_its_signs_and_its_value_on_both_bodies() {
        let (motion, forces, found) = slider_crank();
        let mechanism = motion.mechanism();
        let place = Point::new(1.0, 1.0);
        let of = |name: &str, reversed: &[usize]| {
            let body = body(mechanism, name);
            forces.equilibrium(mechanism, &found, body, place, reversed)
        };
        let unknown = of("rod", &[])[1].unknown.unwrap();
        for name in ["crank", "rod", "slider"] {
            for (one, other) in of(name, &[]).iter().zip(of(name, &[unknown])) {
                let turn = if one.unknown == Some(unknown) {
                    -1.0
                } else {
                    1.0
                };
                assert_eq!(one.factors.map(|factor| factor * turn), other.factors);
                assert_eq!(one.size.map(|size| size * turn), other.size);
            }
        }
        // On the two bodies the unknown has opposite senses and one size.
        let same = |one: &Addend| one.unknown == Some(unknown);
        let all = ["crank", "rod", "slider"].map(|name| of(name, &[]).into_iter().find(same));
        let both: Vec<Addend> = all.into_iter().flatten().collect();
        assert_eq!(both.len(), 2);
        assert_eq!(both[0].direction, -both[1].direction);
        assert_eq!(both[0].size, both[1].size);
    }

    #[test]
    fn signs_and_arms_are_judged() {
        let (motion, forces, found) = slider_crank();
        let mechanism = motion.mechanism();
        let rod = body(mechanism, "rod");
        let about = Point::new(0.0, 3.0);
        let weight = forces.equilibrium(mechanism, &found, rod, about, &[])[0];
        let judged = weight.judged([0.0, -1.0, 1.0], 2.01);
        assert_eq!(judged.signs, [Some(true), Some(true), Some(false)]);
        assert_eq!(judged.arm, Some(true));
        let judged = weight.judged([f64::NAN, 1.0, -1.0], 2.1);
        assert_eq!(judged.signs, [None, Some(false), Some(true)]);
        assert_eq!(judged.arm, Some(false));
        // A torque has no sign in ΣX, and no arm.
        let crank = body(mechanism, "crank");
        let all = forces.equilibrium(mechanism, &found, crank, about, &[]);
        let torque = all.last().unwrap();
        assert!(torque.is_couple && torque.size.is_some_and(|size| (size + 300.0).abs() < 1e-12));
        let judged = torque.judged([0.0, 0.0, 1.0], 1.0);
        assert_eq!((judged.signs, judged.arm), ([None, None, Some(true)], None));
    }
}
