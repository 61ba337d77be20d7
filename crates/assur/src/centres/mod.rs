//! Instant centres: of any two links the place at which both have the same velocity, so that one turns about it against
//! the other at this instant.
//!
//! Of links that are joined the pair tells it, of all others the theorem of Aronhold (*Grundzüge der kinematischen
//! Geometrie*, 1872) and Kennedy (*The Mechanics of Machinery*, 1886): the three centres of any three links are on one
//! line. Two such lines cross in the centre that is looked for, and nothing but places is needed. Where no two known
//! lines lead to a centre, as in many linkages with groups of Class III and higher, only velocities tell it. See Hall,
//! *Kinematics and Linkage Design*, ch. 4.
//!
//! A centre is at (X/w, Y/w), with w = 0 for one at infinity: the differences of two links' velocities are such a triple
//! (−y′, x′, θ′) at the origin, and that the three of three links add up to nothing is the theorem.

mod kennedy;
mod projective;

use crate::index::BodyId;
use crate::mechanism::{Mechanism, Pose};
use crate::tolerance;
use crate::{Point, Vector};
use projective::Place;

/// Where an instant centre is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Centre {
    /// At a place of the drawing.
    At(Point),
    /// At infinity, in this direction or the opposite one, of length 1: the links have one angular velocity, and slide
    /// against each other across it.
    Infinity(Vector),
    /// Anywhere: the links do not move against each other at this instant.
    Anywhere,
}

/// How an instant centre is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The links are joined: at their hinge, at infinity across their slide, at the pitch point of wheels in mesh.
    Joint,
    /// Where two of Kennedy's lines cross: of the links i and j, by the links k and l, the lines `P_ik P_kj` and
    /// `P_il P_lj`.
    Kennedy([BodyId; 2]),
    /// By the velocities of the links: no two lines lead to it, or only such that hardly cross.
    Velocities,
}

/// The instant centre of two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InstantCentre {
    /// The bodies, ascending.
    pub bodies: [BodyId; 2],
    /// Where it is.
    pub centre: Centre,
    /// How it is found.
    pub source: Source,
}

impl Mechanism {
    /// The instant centres of all pairs of bodies in a pose with at least one derivative, in the order in which they
    /// are found: of those that are joined, then by Kennedy's lines, each by ones before it, then the rest.
    pub fn instant_centres<const N: usize>(&self, pose: &Pose<N>) -> Vec<InstantCentre> {
        let mut centres = self.kennedy(pose);
        let by_velocities = self.centres_by_velocities(pose).into_iter();
        let known = centres.len();
        for centre in by_velocities {
            if centres[..known]
                .iter()
                .all(|known| known.bodies != centre.bodies)
            {
                centres.push(centre);
            }
        }
        centres
    }

    /// Those of them that pairs and Kennedy's theorem tell, in the order in which they are found. Only places count:
    /// at a dead point, where there are no derivatives, it answers as well.
    pub fn kennedy<const N: usize>(&self, pose: &Pose<N>) -> Vec<InstantCentre> {
        kennedy::centres(self, pose)
    }

    /// All instant centres by the velocities of the bodies, of a pose with at least one derivative.
    pub fn centres_by_velocities<const N: usize>(&self, pose: &Pose<N>) -> Vec<InstantCentre> {
        let twists: Vec<Place> = self
            .bodies()
            .map(|body| {
                let (velocity, spin) = self.twist(pose, body);
                Place::new(-velocity.y, velocity.x, spin)
            })
            .collect();
        let fastest = twists.iter().map(|twist| twist.norm()).fold(0.0, f64::max);
        let mut centres = Vec::new();
        for first in self.bodies() {
            for second in self.bodies().skip(first.index() + 1) {
                let apart = twists[second.index()] - twists[first.index()];
                let moves = apart.norm() > tolerance::NEGLIGIBLE * fastest;
                centres.push(InstantCentre {
                    bodies: [first, second],
                    centre: if moves {
                        self.centre_at(apart)
                    } else {
                        Centre::Anywhere
                    },
                    source: Source::Velocities,
                });
            }
        }
        centres
    }

    /// The centre at a place in the coordinates of [`Self::scaled`].
    fn centre_at(&self, place: Place) -> Centre {
        match projective::affine(place) {
            Ok(at) => Centre::At(self.unscaled(at)),
            Err(direction) => Centre::Infinity(direction),
        }
    }
}
