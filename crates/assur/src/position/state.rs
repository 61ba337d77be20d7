//! The pose of all bodies while the steps of the plan are solved in order. Angles are continuous with the last pose.

use super::group::KnownTerm;
use super::group::Work;
use super::{Arm, BodyPoint, Complex, SmoothRoot, Track, conjugate, product, quotient};
use crate::index::{BodyId, List, StepId};
use crate::{Jet, Vector};

/// The poses of the bodies solved so far, with buffers; made once and used for every sample.
#[derive(Clone, Debug)]
pub(crate) struct State<const N: usize> {
    pub(crate) bodies: List<BodyId, BodyPose<N>>,
    /// Margins of every step: the quantities under its square roots, or the squared sine of the angle between two
    /// guides. For a group: its Jacobian's determinant divided by a power of two, and the exponent of this power.
    pub(crate) margins: List<StepId, [Jet<N>; 2]>,
    /// The square of the mechanism's size.
    pub(crate) scale: f64,
    /// The unknowns of all groups solved by Newton's method.
    pub(crate) natural: Vec<Complex<N>>,
    /// Largest first and largest second Newton correction of all groups, in units of their unknowns. They estimate the
    /// errors of the guess and of the pose after the first correction.
    pub(crate) corrections: [f64; 2],
    pub(super) work: Work<N>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyPose<const N: usize> {
    pub(crate) origin: Complex<N>,
    /// Turn e^(iθ) of the body by its angle θ.
    pub(crate) turn: Complex<N>,
    pub(crate) angle: Angle<N>,
    /// Orientation of the body in a nearby pose, less than half a turn away.
    near: Orientation,
}

/// A pose with three derivatives, from which nearby poses are predicted.
pub(crate) type Predictor = State<4>;

/// Orientation of a body: its angle θ, with whole turns, and its turn e^(iθ).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Orientation {
    pub(crate) angle: f64,
    pub(crate) turn: Vector,
}

impl Orientation {
    /// Orientation with another turn e^(iθ), whose angle differs from this one's by less than half a turn.
    pub(crate) fn turned_to(self, turn: Vector) -> Self {
        let rotation = quotient(turn, self.turn);
        let angle = self.angle + rotation.y.atan2(rotation.x);
        Self { angle, turn }
    }
}

/// The angle of a body, continuous along the motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Angle<const N: usize> {
    /// Known angle, from which the turn of the body was computed.
    Known(Jet<N>),
    /// Angle of the turn e^(iθ) of the body, within half a turn of the nearby angle; computed on demand.
    Turned,
}

/// Nearby pose, used as the guess for a pose.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearby<'a> {
    pub(crate) orientations: &'a List<BodyId, Orientation>,
    /// The unknowns of all groups, real and imaginary parts.
    pub(crate) natural: &'a [f64],
    /// Signed roots around the change points that may be near.
    pub(crate) smooth_roots: &'a [SmoothRoot],
}

impl<const N: usize> State<N> {
    pub(crate) fn new(bodies: usize, steps: usize, unknowns: usize, size: f64) -> Self {
        let nowhere = Complex::constant(Vector::zeros());
        let body = BodyPose {
            origin: nowhere,
            turn: Complex::constant(Vector::x()),
            angle: Angle::Known(Jet::constant(0.0)),
            near: Orientation::default(),
        };
        Self {
            bodies: vec![body; bodies].into(),
            margins: vec![[Jet::constant(1.0); 2]; steps].into(),
            scale: size * size,
            natural: vec![nowhere; unknowns],
            corrections: [0.0; 2],
            work: Work::default(),
        }
    }

    /// A copy without buffers.
    pub(crate) fn placed(&self) -> Self {
        Self {
            margins: self.margins.clone(),
            natural: self.natural.clone(),
            ..self.bodies()
        }
    }

    /// A copy of the bodies alone.
    pub(crate) fn bodies(&self) -> Self {
        Self {
            bodies: self.bodies.clone(),
            margins: List::default(),
            natural: Vec::new(),
            work: Work::default(),
            ..*self
        }
    }

    /// Value of an input of a group.
    pub(crate) fn known_term(&self, input: KnownTerm) -> Complex<N> {
        match input {
            KnownTerm::Place(anchor) => self.place(anchor),
            KnownTerm::Direction(anchor) => self.bodies[anchor.body].turn.by(anchor.local),
        }
    }

    /// Position of a point of a solved body.
    #[inline(always)]
    pub(crate) fn place(&self, anchor: BodyPoint) -> Complex<N> {
        let body = &self.bodies[anchor.body];
        body.origin + body.turn.by(anchor.local)
    }

    /// A point of a track's line and the line's direction.
    pub(crate) fn line(&self, track: &Track) -> (Complex<N>, Complex<N>) {
        let direction = self.bodies[track.line.body].turn.by(track.heading);
        (self.place(track.line), direction)
    }

    /// Position of the point of a track.
    pub(crate) fn track_point(&self, track: &Track) -> Vector {
        let body = &self.bodies[track.body];
        body.origin.value() + product(body.turn.value(), track.point)
    }

    /// Places an arm from its first hinge at `at` along a vector of the arm's length.
    pub(crate) fn lay(&mut self, arm: &Arm, at: Complex<N>, along: Complex<N>) {
        self.put(arm.body, along.by(arm.turn), arm.from, at);
    }

    /// Places a sliding link from its direction and the position of its point.
    pub(crate) fn slid(&mut self, track: &Track, direction: Complex<N>, at: Complex<N>) {
        let turn = direction.by(conjugate(track.direction));
        self.put(track.body, turn, track.point, at);
    }

    /// Places a body from its turn e^(iθ) and the position of one of its points.
    #[inline(always)]
    pub(crate) fn put(&mut self, body: BodyId, turn: Complex<N>, local: Vector, at: Complex<N>) {
        let body = &mut self.bodies[body];
        body.turn = turn;
        body.origin = at - turn.by(local);
    }

    pub(crate) fn angle(&self, body: BodyId) -> Jet<N> {
        let body = &self.bodies[body];
        match body.angle {
            Angle::Known(angle) => angle,
            Angle::Turned => {
                let turned = body.turn.by(conjugate(body.near.turn));
                turned.y().unit_atan2(turned.x()) + body.near.angle
            }
        }
    }

    /// Makes the angle of a body follow from its turn e^(iθ), within half a turn of the nearby angle.
    pub(crate) fn track_turn(&mut self, body: BodyId, near: Nearby<'_>) {
        self.turned_near(body, near.orientations[body]);
    }

    /// Makes the angle of a body follow from its turn e^(iθ), within half a turn of an orientation's angle.
    pub(crate) fn turned_near(&mut self, body: BodyId, near: Orientation) {
        let body = &mut self.bodies[body];
        body.near = near;
        body.angle = Angle::Turned;
    }

    /// Orientation of a body. Its angle θ follows from the turn e^(iθ); only the number of revolutions comes from the
    /// nearby orientation, so rounding errors do not accumulate from pose to pose. If the outer hinges of a dyad
    /// coincide, the complex number for e^(iθ) may have any length before it is normalized.
    pub(crate) fn orientation(&self, body: BodyId) -> Orientation {
        let body = &self.bodies[body];
        let turn = body.turn.value();
        let turn = turn.try_normalize(0.0).unwrap_or(turn);
        let angle = match body.angle {
            Angle::Known(angle) => angle.value(),
            Angle::Turned => {
                let angle = turn.y.atan2(turn.x);
                crate::angle::nearest_to(angle, body.near.angle)
            }
        };
        Orientation { angle, turn }
    }

    /// Writes the orientations of all bodies into a list.
    pub(crate) fn orient(&self, orientations: &mut List<BodyId, Orientation>) {
        for (body, orientation) in self.bodies.ids().zip(orientations.iter_mut()) {
            *orientation = self.orientation(body);
        }
    }

    /// Values of the unknowns of all groups, real and imaginary parts.
    pub(crate) fn natural_values(&self) -> impl Iterator<Item = f64> {
        let places = self.natural.iter().map(|place| place.value());
        places.flat_map(|place| [place.x, place.y])
    }

    pub(crate) fn orientations(&self) -> List<BodyId, Orientation> {
        self.bodies
            .ids()
            .map(|body| self.orientation(body))
            .collect()
    }

    /// Places a body of known angle with its hinge at a point of a solved body.
    #[inline(always)]
    pub(crate) fn pin(&mut self, body: BodyId, angle: Jet<N>, at: BodyPoint, hinge: Vector) {
        self.put(body, Complex::turn(angle), hinge, self.place(at));
        self.bodies[body].angle = Angle::Known(angle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    fn cis(angle: f64) -> Vector {
        Vector::new(angle.cos(), angle.sin())
    }

    /// From 170°, turning to the direction of −170° gives 190°; turning back gives 170°.
    #[test]
    fn an_angle_continues_beyond_half_a_turn() {
        let [from, to] = [170_f64, -170.0].map(f64::to_radians);
        let start = Orientation {
            angle: from,
            turn: cis(from),
        };
        let next = start.turned_to(cis(to));
        assert!(
            (next.angle - 190_f64.to_radians()).abs() < 1e-14,
            "{next:?}"
        );
        assert!((next.turned_to(cis(from)).angle - from).abs() < 1e-14);
    }

    #[test]
    fn steps_of_a_quarter_turn_count_whole_turns() {
        let mut forwards = Orientation {
            angle: 0.0,
            turn: Vector::x(),
        };
        let mut backwards = forwards;
        for step in 1..=40 {
            forwards = forwards.turned_to(cis(f64::from(step) * FRAC_PI_2));
            backwards = backwards.turned_to(cis(f64::from(-step) * FRAC_PI_2));
        }
        assert!((forwards.angle - 10.0 * TAU).abs() < 1e-12, "{forwards:?}");
        assert!(
            (backwards.angle + 10.0 * TAU).abs() < 1e-12,
            "{backwards:?}"
        );
    }

    #[test]
    fn whole_turns_of_the_nearby_pose_are_kept() {
        let start = Orientation {
            angle: 5.0 * TAU,
            turn: Vector::x(),
        };
        let found = start.turned_to(-Vector::y()).angle;
        assert!((found - (5.0 * TAU - FRAC_PI_2)).abs() < 1e-14);
        let found = start.turned_to(cis(0.9 * PI)).angle;
        assert!((found - (5.0 * TAU + 0.9 * PI)).abs() < 1e-14);
    }
}
