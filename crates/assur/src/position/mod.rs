//! Positions of Assur groups, one file for each dyad, with derivatives to any
//! order: Taylor series of the input go through the closed forms.
//!
//! Bodies are numbered, 0 is the frame. A body has an origin and is turned by
//! e^(iθ); what is fixed to it has constant local coordinates. A group is solved
//! from bodies that were solved before it.

mod complex;
mod elimination;
mod four_bar;
mod group;
mod prp;
mod rpp;
mod rpr;
mod rrp;
mod rrr;

use crate::{Jet, Vector};
pub(crate) use complex::{Complex, conjugate, product, quotient};
pub(crate) use four_bar::Closed;
use group::Work;
pub(crate) use group::{Equation, Form, Group, Input};
pub(crate) use prp::Prp;
pub(crate) use rpp::Rpp;
pub(crate) use rpr::{Rpr, Side};
pub(crate) use rrp::Rrp;
pub(crate) use rrr::Rrr;

/// A margin that is this small beside its scale is zero: the rounding of the
/// squares it is made of.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A place on a body, in its local coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Anchor {
    pub(crate) body: usize,
    pub(crate) local: Vector,
}

/// A link of a dyad between a solved point and the inner joint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Arm {
    pub(crate) body: usize,
    /// The solved point it is hinged at.
    pub(crate) outer: Anchor,
    /// The hinges on the link.
    pub(crate) from: Vector,
    pub(crate) to: Vector,
    length: f64,
    /// The link's turn beside the vector from the one to the other.
    turn: Vector,
}

impl Arm {
    pub(crate) fn new(body: usize, outer: Anchor, [from, to]: [Vector; 2]) -> Self {
        Self {
            body,
            outer,
            from,
            to,
            length: (to - from).norm(),
            turn: quotient(Vector::x(), to - from),
        }
    }

    pub(crate) fn length(&self) -> f64 {
        self.length
    }
}

/// A link that slides along a line of a solved body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Track {
    pub(crate) body: usize,
    /// A point of the line and its direction, of length 1, on the solved body.
    pub(crate) line: Anchor,
    pub(crate) heading: Vector,
    /// The direction of the line on the link, of length 1.
    pub(crate) direction: Vector,
    /// A point of the link, and how far to the left of the line it stays.
    pub(crate) point: Vector,
    pub(crate) off: f64,
}

/// Where all bodies are, for the groups solved so far. It is made once and used
/// for every sample.
#[derive(Clone, Debug)]
pub(crate) struct State<const N: usize> {
    pub(crate) origin: Vec<Complex<N>>,
    pub(crate) turn: Vec<Complex<N>>,
    pub(crate) angle: Vec<Angle<N>>,
    /// How the bodies stand in a pose nearby, where their angles are to be found.
    near: Vec<Stand>,
    /// For every step of the plan what must not become negative: squares whose
    /// roots it takes, or the sine of the angle between two guides.
    pub(crate) margins: Vec<[Jet<N>; 2]>,
    /// The square of the mechanism's size.
    pub(crate) scale: f64,
    /// The unknowns of all groups that Newton's method solves.
    pub(crate) natural: Vec<Complex<N>>,
    /// The largest first correction of a group, beside the size: how far the
    /// guess was off.
    pub(crate) doubt: f64,
    work: Work<N>,
}

/// A pose of a motion that is being followed, with the derivatives that predict
/// the poses around it.
pub(crate) type Followed = State<4>;

/// How a body stands: its angle, with its whole turns, and e^(iθ).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stand {
    pub(crate) angle: f64,
    pub(crate) turn: Vector,
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
pub(crate) struct Near<'a> {
    /// How the bodies stand there.
    pub(crate) stands: &'a [Stand],
    /// The unknowns of all groups, real and imaginary parts.
    pub(crate) natural: &'a [f64],
}

impl<const N: usize> State<N> {
    pub(crate) fn new(bodies: usize, steps: usize, unknowns: usize, size: f64) -> Self {
        let nowhere = Complex::constant(Vector::zeros());
        Self {
            origin: vec![nowhere; bodies],
            turn: vec![Complex::constant(Vector::x()); bodies],
            angle: vec![Angle::Known(Jet::constant(0.0)); bodies],
            near: vec![Stand::default(); bodies],
            margins: vec![[Jet::constant(1.0); 2]; steps],
            scale: size * size,
            natural: vec![nowhere; unknowns],
            doubt: 0.0,
            work: Work::default(),
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
    pub(crate) fn angle(&self, body: usize) -> Jet<N> {
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
    pub(crate) fn winds(&mut self, body: usize, near: Near<'_>) {
        self.near[body] = near.stands[body];
        self.angle[body] = Angle::Turned;
    }

    /// How a body stands.
    pub(crate) fn stand(&self, body: usize) -> Stand {
        Stand {
            angle: self.angle(body).value(),
            turn: self.turn[body].value(),
        }
    }
}

/// Why a step of the plan finds no place for its links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Obstacle {
    /// The input is not finite, or outside a driven slide's range.
    Input,
    /// The solved joints are too far apart, or too close, by this length.
    Apart {
        /// Length.
        by: f64,
    },
    /// A link is too short by this length to reach its guide, or a line too far
    /// off a hinge to reach the other.
    OutOfReach {
        /// Length.
        by: f64,
    },
    /// Two guides that must cross are parallel.
    Parallel,
    /// Two hinges coincide: the links between may stand at any angle.
    Undetermined,
    /// The pose exists, its derivatives are unbounded.
    DeadPoint,
    /// There is a pose, but the motion that is shown does not come there.
    Unreached,
}

/// Whether a sum of [`Complex::nought`] tells that all is finite.
pub(crate) fn finite(sum: Vector) -> Result<(), Obstacle> {
    if sum == Vector::zeros() {
        Ok(())
    } else {
        Err(Obstacle::DeadPoint)
    }
}

/// How a margin fails to have a root.
pub(crate) enum Dead {
    /// It is zero within rounding, and derivatives are asked for.
    At,
    /// It is negative.
    Beyond,
}

/// Whether a margin is off zero; `scale` is the size of the squares it is made
/// of. Within rounding of zero it has a root only where no derivatives are asked.
pub(crate) fn clear<const N: usize>(margin: Jet<N>, scale: f64) -> Result<bool, Dead> {
    if margin.value() > ROUNDING * scale {
        Ok(true)
    } else if margin.value() < -ROUNDING * scale {
        Err(Dead::Beyond)
    } else if N == 1 {
        Ok(false)
    } else {
        Err(Dead::At)
    }
}

/// The square root of a margin. In line within rounding is in line: a root would
/// halve the digits.
pub(crate) fn root<const N: usize>(margin: Jet<N>, scale: f64) -> Result<Jet<N>, Dead> {
    Ok(if clear(margin, scale)? {
        margin.sqrt()
    } else {
        Jet::constant(0.0)
    })
}

/// Where two lines cross, each given by a point and its direction of length 1.
/// The sine of the angle between them is the margin: its square must not vanish.
pub(crate) fn crossing<const N: usize>(
    lines: [(Complex<N>, Complex<N>); 2],
    margin: &mut [Jet<N>; 2],
) -> Result<Complex<N>, Obstacle> {
    let [(p, u), (q, v)] = lines;
    let sine = v.dot(u.left());
    *margin = [sine.square(); 2];
    if sine.value().abs() <= ROUNDING {
        return Err(Obstacle::Parallel);
    }
    let along = (q - p).dot(v.left()) * -sine.recip();
    Ok(p + u.scaled(along))
}
