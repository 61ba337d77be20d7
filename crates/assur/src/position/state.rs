//! Where all bodies are, while the groups are solved one after the other.

use std::f64::consts::TAU;

use super::group::Input;
use super::work::Work;
use super::{Anchor, Arm, Complex, SmoothRoot, Track, conjugate, quotient};
use crate::index::{BodyId, List, StepId};
use crate::{Jet, Vector};

/// Where all bodies are, for the groups solved so far. It is made once and used
/// for every sample.
#[derive(Clone, Debug)]
pub(crate) struct State<const N: usize> {
    pub(crate) origin: List<BodyId, Complex<N>>,
    pub(crate) turn: List<BodyId, Complex<N>>,
    pub(crate) angle: List<BodyId, Angle<N>>,
    /// The bodies' orientations in a pose nearby, where their angles are to be found.
    near: List<BodyId, Orientation>,
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
        Self {
            origin: vec![nowhere; bodies].into(),
            turn: vec![Complex::constant(Vector::x()); bodies].into(),
            angle: vec![Angle::Known(Jet::constant(0.0)); bodies].into(),
            near: vec![Orientation::default(); bodies].into(),
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
            origin: self.origin.clone(),
            turn: self.turn.clone(),
            angle: self.angle.clone(),
            near: self.near.clone(),
            margins: List::default(),
            natural: Vec::new(),
            work: Work::default(),
            ..*self
        }
    }

    /// What a group takes from what is solved.
    pub(crate) fn taken(&self, input: Input) -> Complex<N> {
        match input {
            Input::Place(anchor) => self.place(anchor),
            Input::Direction(anchor) => self.turn[anchor.body].by(anchor.local),
        }
    }

    /// Where a place on a solved body is.
    #[inline(always)]
    pub(crate) fn place(&self, anchor: Anchor) -> Complex<N> {
        self.origin[anchor.body] + self.turn[anchor.body].by(anchor.local)
    }

    /// A point of a track's line and the line's direction.
    pub(crate) fn line(&self, track: &Track) -> (Complex<N>, Complex<N>) {
        let direction = self.turn[track.line.body].by(track.heading);
        (self.place(track.line), direction)
    }

    /// Lays an arm from a point along a vector as long as it is.
    pub(crate) fn lay(&mut self, arm: &Arm, at: Complex<N>, along: Complex<N>) {
        let turn = along.by(arm.turn);
        self.turn[arm.body] = turn;
        self.origin[arm.body] = at - turn.by(arm.from);
    }

    /// Puts a sliding link with its point to a place.
    pub(crate) fn slid(&mut self, track: &Track, direction: Complex<N>, at: Complex<N>) {
        let turn = direction.by(conjugate(track.direction));
        self.turn[track.body] = turn;
        self.origin[track.body] = at - turn.by(track.point);
    }

    /// The angle of a body.
    pub(crate) fn angle(&self, body: BodyId) -> Jet<N> {
        match self.angle[body] {
            Angle::Known(angle) => angle,
            Angle::Turned => {
                let near = self.near[body];
                let turned = self.turn[body].by(conjugate(near.turn));
                turned.y().unit_atan2(turned.x()) + near.angle
            }
        }
    }

    /// The angle of a body is that of its turn, near what it was there.
    pub(crate) fn winds(&mut self, body: BodyId, near: Nearby<'_>) {
        self.near[body] = near.orientations[body];
        self.angle[body] = Angle::Turned;
    }

    /// The angle of a body is that of its turn, less than half a turn from this one.
    pub(crate) fn turned_near(&mut self, body: BodyId, near: Orientation) {
        self.near[body] = near;
        self.angle[body] = Angle::Turned;
    }

    /// How a body is turned. The angle is taken from the turn again, and only its whole turns from the pose nearby:
    /// rounding does not add up from pose to pose.
    pub(crate) fn orientation(&self, body: BodyId) -> Orientation {
        let turn = self.turn[body].value();
        let angle = match self.angle[body] {
            Angle::Known(angle) => angle.value(),
            Angle::Turned => {
                let angle = turn.y.atan2(turn.x);
                angle + TAU * ((self.near[body].angle - angle) / TAU).round()
            }
        };
        Orientation { angle, turn }
    }

    /// Tells how all bodies are turned.
    pub(crate) fn orient(&self, orientations: &mut List<BodyId, Orientation>) {
        for (body, orientation) in self.turn.ids().zip(orientations.iter_mut()) {
            *orientation = self.orientation(body);
        }
    }

    /// How all bodies are turned.
    pub(crate) fn orientations(&self) -> List<BodyId, Orientation> {
        self.turn.ids().map(|body| self.orientation(body)).collect()
    }

    /// Puts a body that turns by a known angle with a hinge of it to a place.
    #[inline(always)]
    pub(crate) fn pin(&mut self, body: BodyId, angle: Jet<N>, at: Anchor, hinge: Vector) {
        let turn = Complex::turn(angle);
        self.angle[body] = Angle::Known(angle);
        self.turn[body] = turn;
        self.origin[body] = self.place(at) - turn.by(hinge);
    }
}
