//! Force transmission of dyads in a pose: the transmission angle of an RRR dyad and the pressure angle of an RRP dyad.
//! Both are acute angles between two lines, folded at 0 and at 90°, where their rates jump.

use crate::tolerance;
use std::f64::consts::PI;

use crate::index::{LinkId, PointId, StepId};
use crate::mechanism::readout::dyads::arms_of;
use crate::mechanism::{LinkOrFrame, Mechanism, OuterJoint, Pose, Quantity, RrrDyad};
use crate::position::{Rrp, Step};
use crate::{Jet, Vector};

/// Assur group of two links, two hinges and a slide: a rod, and a slider on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RrpDyad {
    /// Link with the two hinges.
    pub rod: LinkId,
    /// Link that slides.
    pub slider: LinkId,
    /// Point at which rod and slider are hinged to each other.
    pub inner: PointId,
    /// Hinge of the rod to a link already solved.
    pub outer: OuterJoint,
    /// Link with the line of the slide.
    pub on: LinkOrFrame,
    step: StepId,
}

impl Mechanism {
    /// Transmission and pressure angles of the dyads in the order of solving; those within groups with redundant
    /// constraints come last.
    pub fn transmitting(&self) -> Vec<Quantity> {
        let steps = self.steps().enumerate();
        let found = steps.filter_map(|(step, placing)| match placing {
            Step::Rrp(dyad) => self.rrp_dyad(step, dyad).map(Quantity::Pressure),
            other => {
                let dyad = self.dyad_of(arms_of(other)?);
                dyad.map(Quantity::Transmission)
            }
        });
        let passive = self.layout.passive.iter();
        let within = passive.flat_map(|passive| &passive.dyads);
        let within = within.filter_map(|arms| self.dyad_of(arms));
        found.chain(within.map(Quantity::Transmission)).collect()
    }

    fn rrp_dyad(&self, step: StepId, Rrp { arm, track }: &Rrp) -> Option<RrpDyad> {
        Some(RrpDyad {
            rod: self.link_of(arm.body)?,
            slider: self.link_of(track.body)?,
            inner: arm.joints[1],
            outer: self.outer_joint(arm),
            on: self.link_of(track.line.body),
            step,
        })
    }

    /// Angle from the first link of a dyad to the second, before folding to an acute angle.
    pub(in crate::mechanism) fn between_links<const N: usize>(
        &self,
        pose: &Pose<N>,
        dyad: &RrrDyad,
    ) -> Jet<N> {
        let at = |point: PointId| self.place(pose, point).place();
        let inner = at(dyad.inner);
        let lines = dyad.outer.map(|outer| at(outer.point) - inner);
        let angles = dyad.links.map(|link| self.angle(pose, link));
        turned(lines, angles)
    }

    /// Angle from the line of a dyad's slide to its rod, before folding to an acute angle.
    pub(in crate::mechanism) fn unfolded_pressure_angle<const N: usize>(
        &self,
        pose: &Pose<N>,
        dyad: &RrpDyad,
    ) -> Jet<N> {
        let Step::Rrp(Rrp { arm, track }) = &self.steps()[dyad.step] else {
            debug_assert!(false, "a dyad of this mechanism");
            return Jet::constant(0.0);
        };
        let state = &pose.state;
        let (_, way) = state.line(track);
        let [from, to] = [dyad.outer.point, dyad.inner].map(|point| self.place(pose, point));
        let lines = [way.value(), to.place() - from.place()];
        turned(
            lines,
            [track.line.body, arm.body].map(|body| state.angle(body)),
        )
    }

    pub(crate) fn rod_of(&self, dyad: &RrpDyad) -> f64 {
        self.length_between(dyad.rod, [dyad.inner, dyad.outer.point])
    }

    /// Component of a dyad's rod perpendicular to the line of the slide, from the outer to the inner hinge.
    pub(crate) fn rise<const N: usize>(&self, pose: &Pose<N>, dyad: &RrpDyad) -> Jet<N> {
        let Step::Rrp(Rrp { arm, track }) = &self.steps()[dyad.step] else {
            debug_assert!(false, "a dyad of this mechanism");
            return Jet::constant(0.0);
        };
        let state = &pose.state;
        let (start, way) = state.line(track);
        let from = (state.place(arm.outer) - start) * way.conjugate();
        -from.y() + track.offset
    }
}

/// Directed angle from the first line to the second. The lines turn with links at the given angles.
fn turned<const N: usize>([u, v]: [Vector; 2], [a, b]: [Jet<N>; 2]) -> Jet<N> {
    let grown = b - a;
    grown + (u.perp(&v).atan2(u.dot(&v)) - grown.value())
}

/// Acute angle between two lines, from their directed angle.
pub(in crate::mechanism) fn acute(angle: f64) -> f64 {
    let turned = angle.rem_euclid(PI);
    turned.min(PI - turned)
}

/// Sense of the acute angle: 1 if it grows with the directed angle, −1 otherwise; at a fold, the sense just after it.
pub(in crate::mechanism) fn sense<const N: usize>(angle: &Jet<N>) -> f64 {
    let (sin, cos) = angle.value().sin_cos();
    if (sin * cos).abs() > tolerance::NEGLIGIBLE {
        return (sin * cos).signum();
    }
    let rates = [1, 2].map(|order| angle.derivative(order));
    let grows = rates
        .into_iter()
        .find(|rate| rate.abs() > tolerance::COINCIDENT);
    let grows = grows.unwrap_or(1.0).signum();
    if sin.abs() < cos.abs() { grows } else { -grows }
}

/// Acute angle between two lines, with its derivatives, from their directed angle.
pub(in crate::mechanism) fn folded<const N: usize>(angle: Jet<N>) -> Jet<N> {
    let folded = angle * sense(&angle);
    folded + (acute(angle.value()) - folded.value())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::samples::slider_crank;
    use crate::motion::Motion;

    #[test]
    fn angles_between_lines_are_acute() {
        for (directed, expected) in [
            (30.0, 30.0),
            (100.0, 80.0),
            (180.0, 0.0),
            (-30.0, 30.0),
            (270.0, 90.0),
        ] {
            let found = acute(f64::to_radians(directed)).to_degrees();
            assert!((found - expected).abs() < 1e-13, "{directed}: {found}");
        }
    }

    /// From 0 to 90° the acute angle grows with the directed angle; from 90° to 180° it falls. At a fold its rate is
    /// that just after the fold.
    #[test]
    fn the_acute_angle_is_folded_at_right_angles_and_in_line() {
        for (directed, rate, expected) in [
            (30.0, 2.0, [30.0, 2.0]),
            (100.0, 2.0, [80.0, -2.0]),
            (200.0, 2.0, [20.0, 2.0]),
            (0.0, -2.0, [0.0, 2.0]),
            (90.0, 2.0, [90.0, -2.0]),
            (90.0, -2.0, [90.0, -2.0]),
        ] {
            let found = folded(Jet::<2>::linear(f64::to_radians(directed), rate));
            assert!(
                (found.value().to_degrees() - expected[0]).abs() < 1e-13,
                "{found:?}"
            );
            assert_eq!(found.derivative(1), expected[1], "{directed}");
        }
    }

    /// Crank 3 and rod 5: sin α = 3/5 |sin φ|. At 90° α is greatest; at 0° the rod is along the slide, and α′ = 3/5.
    #[test]
    fn the_pressure_angle_of_a_slider_crank() {
        let spec = slider_crank([[0.0, 3.0], [4.0, 0.0]]);
        let motion = Motion::new(Mechanism::new(&spec).unwrap());
        let mechanism = motion.mechanism();
        let [pressure] = mechanism.transmitting()[..] else {
            panic!("not one")
        };
        for (degrees, expected) in [
            (90.0, [0.6_f64.asin(), 0.0]),
            (0.0, [0.0, 0.6]),
            (30.0, [0.3_f64.asin(), f64::NAN]),
        ] {
            let pose = motion.pose::<2>(f64::to_radians(degrees)).unwrap();
            let found = pressure.of(mechanism, &pose);
            assert!(
                (found.value() - expected[0]).abs() < 1e-14,
                "{degrees}: {found:?}"
            );
            let off = (found.derivative(1) - expected[1]).abs();
            assert!(expected[1].is_nan() || off < 1e-14, "{degrees}: {found:?}");
        }
    }
}
