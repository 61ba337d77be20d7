//! Where all bodies are, while the groups are solved one after the other.

use std::f64::consts::TAU;

use super::group::KnownTerm;
use super::group::Work;
use super::{Arm, BodyPoint, Complex, SmoothRoot, Track, conjugate, quotient};
use crate::index::{BodyId, List, StepId};
use crate::{Jet, Vector};

/// Where all bodies are, for the groups solved so far. It is made once and used
/// for every sample.
#[derive(Clone, Debug)]
pub(crate) struct State<const N: usize> {
    pub(crate) bodies: List<BodyId, BodyPose<N>>,
    /// For every step of the plan what must not become negative: squares whose
    /// roots it takes, or the sine of the angle between two guides; of a group the determinant of its Jacobian, as a
    /// multiple of a power of two, and the exponent of that.
    pub(crate) margins: List<StepId, [Jet<N>; 2]>,
    /// The square of the mechanism's size.
    pub(crate) scale: f64,
    /// The unknowns of all groups that Newton's method solves.
    pub(crate) natural: Vec<Complex<N>>,
    /// The largest of the groups' first and of their second corrections by Newton's
    /// method, relative to the size: how far the guess was off, and how far the first
    /// correction still was.
    pub(crate) corrections: [f64; 2],
    pub(super) work: Work<N>,
}

/// Where a body is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyPose<const N: usize> {
    pub(crate) origin: Complex<N>,
    /// e^(iθ) of its angle.
    pub(crate) turn: Complex<N>,
    pub(crate) angle: Angle<N>,
    /// Its orientation in a pose nearby, where its angle is to be found.
    near: Orientation,
}

/// A pose with the derivatives that predict the poses around it.
pub(crate) type Predictor = State<4>;

/// How a body is turned: its angle, with its whole turns, and e^(iθ).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Orientation {
    pub(crate) angle: f64,
    pub(crate) turn: Vector,
}

impl Orientation {
    /// Turned otherwise, by less than half a turn.
    pub(crate) fn turned_to(self, turn: Vector) -> Self {
        let by = quotient(turn, self.turn);
        let angle = self.angle + by.y.atan2(by.x);
        Self { angle, turn }
    }
}

/// The angle of a body, continuous along the motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Angle<const N: usize> {
    /// What its turn was made of.
    Known(Jet<N>),
    /// That of its turn, less than half a turn from that of the pose nearby: found
    /// when it is asked for.
    Turned,
}

/// What is known of a pose before it is solved: a pose nearby.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearby<'a> {
    /// How the bodies are turned there.
    pub(crate) orientations: &'a List<BodyId, Orientation>,
    /// The unknowns of all groups, real and imaginary parts.
    pub(crate) natural: &'a [f64],
    /// Change points that may be near.
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

    /// The same bodies in the same places, without the room that it took to find them.
    pub(crate) fn placed(&self) -> Self {
        Self {
            margins: self.margins.clone(),
            natural: self.natural.clone(),
            ..self.bodies()
        }
    }

    /// The same bodies in the same places, and nothing else.
    pub(crate) fn bodies(&self) -> Self {
        Self {
            bodies: self.bodies.clone(),
            margins: List::default(),
            natural: Vec::new(),
            work: Work::default(),
            ..*self
        }
    }

    /// What a group takes from what is solved.
    pub(crate) fn taken(&self, input: KnownTerm) -> Complex<N> {
        match input {
            KnownTerm::Place(anchor) => self.place(anchor),
            KnownTerm::Direction(anchor) => self.bodies[anchor.body].turn.by(anchor.local),
        }
    }

    /// Where a place on a solved body is.
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

    /// Lays an arm from a point along a vector as long as it is.
    pub(crate) fn lay(&mut self, arm: &Arm, at: Complex<N>, along: Complex<N>) {
        self.put(arm.body, along.by(arm.turn), arm.from, at);
    }

    /// Puts a sliding link with its point to a place.
    pub(crate) fn slid(&mut self, track: &Track, direction: Complex<N>, at: Complex<N>) {
        let turn = direction.by(conjugate(track.direction));
        self.put(track.body, turn, track.point, at);
    }

    /// Puts a body that is turned so, e^(iθ), with one of its places to a place.
    #[inline(always)]
    pub(crate) fn put(&mut self, body: BodyId, turn: Complex<N>, local: Vector, at: Complex<N>) {
        let body = &mut self.bodies[body];
        body.turn = turn;
        body.origin = at - turn.by(local);
    }

    /// The angle of a body.
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

    /// The angle of a body is that of its turn, near what it was there.
    pub(crate) fn tracks_turns(&mut self, body: BodyId, near: Nearby<'_>) {
        self.turned_near(body, near.orientations[body]);
    }

    /// The angle of a body is that of its turn, less than half a turn from this one.
    pub(crate) fn turned_near(&mut self, body: BodyId, near: Orientation) {
        let body = &mut self.bodies[body];
        body.near = near;
        body.angle = Angle::Turned;
    }

    /// How a body is turned. The angle is taken from the turn again, and only its whole turns from the pose nearby:
    /// rounding does not add up from pose to pose. Where the outer hinges of a dyad meet, rounding may leave a turn of any length.
    pub(crate) fn orientation(&self, body: BodyId) -> Orientation {
        let body = &self.bodies[body];
        let turn = body.turn.value();
        let turn = turn.try_normalize(0.0).unwrap_or(turn);
        let angle = match body.angle {
            Angle::Known(angle) => angle.value(),
            Angle::Turned => {
                let angle = turn.y.atan2(turn.x);
                angle + TAU * ((body.near.angle - angle) / TAU).round()
            }
        };
        Orientation { angle, turn }
    }

    /// Tells how all bodies are turned.
    pub(crate) fn orient(&self, orientations: &mut List<BodyId, Orientation>) {
        for (body, orientation) in self.bodies.ids().zip(orientations.iter_mut()) {
            *orientation = self.orientation(body);
        }
    }

    /// How all bodies are turned.
    pub(crate) fn orientations(&self) -> List<BodyId, Orientation> {
        self.bodies
            .ids()
            .map(|body| self.orientation(body))
            .collect()
    }

    /// Puts a body that turns by a known angle with a hinge of it to a place.
    #[inline(always)]
    pub(crate) fn pin(&mut self, body: BodyId, angle: Jet<N>, at: BodyPoint, hinge: Vector) {
        self.put(body, Complex::turn(angle), hinge, self.place(at));
        self.bodies[body].angle = Angle::Known(angle);
    }
}
