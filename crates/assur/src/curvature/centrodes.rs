//! Centrodes of a link: the paths of its pole, which is the instant centre of the link relative to the frame. The path
//! in the frame is the fixed centrode; the path on the link is the moving centrode, which rolls on the fixed one.

use super::along::along;
use crate::index::LinkId;
use crate::mechanism::Pose;
use crate::motion::Motion;
use crate::{Point, Vector, perpendicular};

/// Distance beyond which a pole counts as at infinity, in sizes of the mechanism.
const FARTHEST: f64 = 100.0;

/// Contact of the two centrodes at an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    /// The input.
    pub input: f64,
    /// The pole in the coordinates of the drawing.
    pub fixed: Point,
    /// The pole in the coordinates of the link, defined as in [`crate::mechanism::TracerSpec::at`].
    pub moving: Vector,
}

/// The centrodes of a link over a motion, as poles in continuous pieces. Between two pieces the pole passes through
/// infinity, or there is no pose with a derivative. Within a piece the sense of rotation of the link is the same.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Centrodes {
    /// The pieces, at ascending inputs.
    pub pieces: Vec<Vec<Rolling>>,
}

impl Centrodes {
    /// Samples the centrodes of a link that moves relative to the frame. They are empty for a pure translation, and a
    /// single point for rotation about a hinge of the frame.
    pub fn of(motion: &Motion, link: LinkId) -> Self {
        let at = |input, pose: &Pose<3>| rolling_at(motion, pose, link, input);
        Self {
            pieces: along(motion, at),
        }
    }
}

/// The pole of a link in a pose, and the sign of the link's angular velocity. None if the pole is at infinity.
fn rolling_at(motion: &Motion, pose: &Pose<3>, link: LinkId, input: f64) -> Option<(Rolling, f64)> {
    let mechanism = motion.mechanism();
    let (velocity, spin) = mechanism.twist(pose, mechanism.body_of(Some(link)));
    let pole = perpendicular(velocity) / spin;
    // Without rotation the quotient is NaN or infinite, and the comparison is false.
    let is_near = pole.norm() < FARTHEST;
    if !is_near {
        return None;
    }
    let fixed = mechanism.unscaled(pole);
    let moving = mechanism.on_link(pose, link, fixed);
    let rolling = Rolling {
        input,
        fixed,
        moving,
    };
    Some((rolling, spin.signum()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::LinkageSpec;
    use crate::mechanism::Mechanism;

    /// Cranks of length 2 on a frame of length 1 with a coupler of length 1, crossed: C is the mirror image of (1, 2)
    /// in the line BD.
    fn antiparallelogram() -> Motion {
        let spec = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 2.0)
            .point("C", -0.6, 1.2)
            .point("D", 1.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank");
        Motion::new(Mechanism::new(&spec).unwrap())
    }

    /// The lines of the crossed cranks meet in the pole P, and by symmetry PA + PD = PB + PC = 2: two equal ellipses
    /// roll on each other.
    #[test]
    fn centrodes_of_an_antiparallelogram_are_ellipses_with_the_hinges_as_foci() {
        let motion = antiparallelogram();
        let coupler = motion.mechanism().link("coupler").unwrap();
        let centrodes = Centrodes::of(&motion, coupler);
        let all: Vec<&Rolling> = centrodes.pieces.iter().flatten().collect();
        assert!(all.len() > 360, "{}", all.len());
        for Rolling { fixed, moving, .. } in all {
            for place in [fixed.coords, *moving] {
                let sum = place.norm() + (place - Vector::x()).norm();
                assert!((sum - 2.0).abs() < 1e-9, "{place}: {sum}");
            }
        }
    }

    #[test]
    fn centrodes_of_a_crank_are_its_pivot() {
        let motion = antiparallelogram();
        for (link, pivot) in [("crank", [0.0, 0.0]), ("rocker", [1.0, 0.0])] {
            let centrodes = Centrodes::of(&motion, motion.mechanism().link(link).unwrap());
            let mut all = centrodes.pieces.iter().flatten();
            assert!(all.clone().count() > 360, "{link}");
            assert!(all.all(|one| {
                (one.fixed - Point::from(pivot)).norm() < 1e-9 && one.moving.norm() < 1e-9
            }));
        }
    }
}
