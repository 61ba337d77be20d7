//! Instant centres. The instant centre of two links is the point at which both have the same velocity: at this instant,
//! one link turns about it relative to the other.
//!
//! For joined links the pair determines the centre. All others follow from the theorem of Aronhold (*Grundzüge der
//! kinematischen Geometrie*, 1872) and Kennedy (*The Mechanics of Machinery*, 1886): the three centres of any three
//! links are on one line. Two such lines intersect in the wanted centre, so only positions are needed. In many linkages
//! with groups of Class III and higher, some centres are on no two known lines and follow only from velocities.
//! See Hall, *Kinematics and Linkage Design*, ch. 4.
//!
//! A centre is represented by a triple (X, Y, w): it is at (X/w, Y/w), or at infinity if w = 0. Let one link move
//! relative to another with the angular velocity θ′ and, at the origin, the velocity (x′, y′). Then their centre is
//! (−y′, x′, θ′). The triples of three links, taken in cyclic order, sum to zero, so the three centres are on one line.

mod kennedy;
mod projective;

use crate::index::BodyId;
use crate::mechanism::{Mechanism, Pose};
use crate::tolerance;
use crate::{Point, Vector};
use projective::Place;

/// Position of an instant centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Centre {
    /// At a point of the drawing.
    At(Point),
    /// At infinity along this unit vector, in either sense. The links have the same angular velocity, and slide
    /// relative to each other perpendicular to the vector.
    Infinity(Vector),
    /// Anywhere: the links do not move relative to each other at this instant.
    Anywhere,
}

/// Derivation of an instant centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The links are joined. The centre is at a hinge, at infinity normal to a slide, or at the pitch point of a mesh.
    Joint,
    /// Intersection of two of Kennedy's lines. Let i and j be the two links, and k and l the links given here. The
    /// lines are `P_ik P_kj` and `P_il P_lj`, where `P_ik` is the centre of links i and k.
    Kennedy([BodyId; 2]),
    /// From the velocities of the links, because the centre is on no two known lines, or the lines nearly coincide.
    Velocities,
}

/// The instant centre of two bodies.
///
/// ```
/// # use assur::{centres::Centre, linkage::LinkageSpec, mechanism::Mechanism, motion::Motion};
/// # let slider_crank = LinkageSpec::default()
/// #     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
/// #     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
/// #     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
/// let motion = Motion::new(Mechanism::new(&slider_crank).unwrap());
/// let centres = motion.mechanism().instant_centres(&motion.pose::<2>(90f64.to_radians()).unwrap());
/// assert_eq!(centres.len(), 6); // the pairs of four links
/// assert!(centres.iter().any(|one| matches!(one.centre, Centre::Infinity(_)))); // that of slider and frame, for one
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InstantCentre {
    /// The two bodies, in ascending order.
    pub bodies: [BodyId; 2],
    /// Position of the instant centre.
    pub centre: Centre,
    /// Derivation of the position.
    pub source: Source,
}

impl Mechanism {
    /// Lists the instant centres of all pairs of bodies in a pose with at least one derivative: first those of joined
    /// bodies, then those found by Kennedy's lines through earlier centres, then the rest.
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

    /// Lists the instant centres given by pairs and by Kennedy's theorem, in the order of derivation. Only positions
    /// are used, so this also works at a dead point, where there are no derivatives.
    pub fn kennedy<const N: usize>(&self, pose: &Pose<N>) -> Vec<InstantCentre> {
        kennedy::centres(self, pose)
    }

    /// Lists all instant centres from the velocities of the bodies, in a pose with at least one derivative.
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

    /// Converts a triple in the coordinates of [`Self::scaled`] to a centre.
    fn centre_at(&self, place: Place) -> Centre {
        match projective::affine(place) {
            Ok(at) => Centre::At(self.unscaled(at)),
            Err(direction) => Centre::Infinity(direction),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::LinkageSpec;
    use crate::linkage::samples::slider_crank;
    use crate::motion::Motion;

    /// The centre of two bodies in the drawn pose, by Kennedy's theorem and from velocities; `""` is the frame.
    fn centre(spec: &LinkageSpec, names: [&str; 2]) -> [Centre; 2] {
        let mechanism = Mechanism::new(spec).unwrap();
        let motion = Motion::new(mechanism);
        let mechanism = motion.mechanism();
        let pose = motion.pose::<2>(motion.drawn_input()).unwrap();
        let mut bodies = names.map(|name| mechanism.body_of(mechanism.link(name)));
        bodies.sort();
        let both = [
            mechanism.kennedy(&pose),
            mechanism.centres_by_velocities(&pose),
        ];
        both.map(|all| all.iter().find(|one| one.bodies == bodies).unwrap().centre)
    }

    /// Asserts that Kennedy's theorem and the velocities both give this point or, if `is_finite` is false, this
    /// direction at infinity.
    fn check(spec: &LinkageSpec, names: [&str; 2], expected: Vector, is_finite: bool) {
        for found in centre(spec, names) {
            match found {
                Centre::At(place) if is_finite => {
                    assert!(
                        (place.coords - expected).norm() < 1e-12,
                        "{names:?}: {place}"
                    );
                }
                Centre::Infinity(along) if !is_finite => {
                    assert!(along.perp(&expected).abs() < 1e-12, "{names:?}: {along}");
                }
                _ => panic!("{names:?}: {found:?}"),
            }
        }
    }

    /// A crank from (0, 0) to (1, 1) and a rocker from (6, 0) to (4, 2). The lines of crank and rocker, y = x and y = 6
    /// − x, meet in (3, 3). The line of the coupler, y = (x + 2)/3, meets that of the frame in (−2, 0), so the rocker
    /// turns at 2/8 of the speed of the crank.
    #[test]
    fn the_six_centres_of_a_four_bar() {
        let four_bar = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 1.0, 1.0)
            .point("C", 4.0, 2.0)
            .point("D", 6.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["C", "D"])
            .crank("crank");
        for (names, expected) in [
            (["crank", ""], [0.0, 0.0]),
            (["crank", "coupler"], [1.0, 1.0]),
            (["coupler", "rocker"], [4.0, 2.0]),
            (["rocker", ""], [6.0, 0.0]),
            (["coupler", ""], [3.0, 3.0]),
            (["crank", "rocker"], [-2.0, 0.0]),
        ] {
            check(&four_bar, names, Vector::from(expected), true);
        }
        let motion = Motion::new(Mechanism::new(&four_bar).unwrap());
        let pose = motion.pose::<2>(motion.drawn_input()).unwrap();
        let rocker = motion.mechanism().link("rocker").unwrap();
        let rate = motion.mechanism().angle(&pose, rocker).derivative(1);
        assert!((rate - 0.25).abs() < 1e-14, "{rate}");
    }

    /// A slider-crank with a crank of length 3 at a right angle to the slide, and a rod from B at (0, 3) to (4, 0). The
    /// rod translates for an instant. Crank and slider have the same velocity at B, where the rod meets the normal to
    /// the slide through the pivot A.
    #[test]
    fn a_crank_at_a_right_angle_to_the_slide_moves_the_rod_without_turning_it() {
        let slider_crank = slider_crank([[0.0, 3.0], [4.0, 0.0]]);
        check(&slider_crank, ["rod", ""], Vector::y(), false);
        check(&slider_crank, ["slider", ""], Vector::y(), false);
        check(
            &slider_crank,
            ["crank", "slider"],
            Vector::new(0.0, 3.0),
            true,
        );
    }

    /// A slotted lever about (0, 0), with its block at the end (3, 4) of a crank about (3, 0). The centre of crank and
    /// lever is on the line through the two fixed pivots, where the normal to the slot at (3, 4) meets this line: 3 +
    /// 16/3 from the pivot of the lever.
    #[test]
    fn crank_and_slotted_lever_meet_on_the_normal_of_the_slot() {
        let lever = LinkageSpec::default()
            .point("O", 0.0, 0.0)
            .point("E", 6.0, 8.0)
            .point("A", 3.0, 0.0)
            .point("B", 3.0, 4.0)
            .fixed(&["O", "A"])
            .bar("crank", &["A", "B"])
            .bar("lever", &["O", "E"])
            .bar("block", &["B"])
            .slide("block", "B", "lever", ["O", "E"])
            .crank("crank");
        check(
            &lever,
            ["crank", "lever"],
            Vector::new(25.0 / 3.0, 0.0),
            true,
        );
        check(&lever, ["block", "lever"], Vector::new(4.0, -3.0), false);
    }
}
