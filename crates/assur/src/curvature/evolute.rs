//! The evolute: the path of the centre of curvature.

use super::Curvature;
use super::along::along;
use crate::Point;
use crate::index::PointId;
use crate::mechanism::Pose;
use crate::motion::Motion;

/// Centres of curvature of a point's path over a motion, at ascending inputs and in continuous pieces. At an inflection
/// of the path the centre passes through infinity to the other side. At a cusp of the path, or without a pose with
/// derivatives, there is no centre. A cusp of the evolute marks a point of stationary curvature.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Evolute {
    /// The pieces, at ascending inputs.
    pub pieces: Vec<Vec<Point>>,
}

impl Evolute {
    /// Samples the evolute for a point; empty if the point is at rest or its path is straight.
    pub fn of(motion: &Motion, point: PointId) -> Self {
        let mechanism = motion.mechanism();
        let size = mechanism.size();
        let centre = |_, pose: &Pose<4>| {
            let bend = Curvature::of(&mechanism.place(pose, point), size)?;
            Some((bend.centre?, bend.curvature))
        };
        Self {
            pieces: along(motion, centre),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::LinkageSpec;
    use crate::linkage::samples::slider_crank;
    use crate::mechanism::Mechanism;

    /// A parallelogram of sides 2 and 5, with a point P of the coupler, and a motion of a full turn.
    fn parallelogram() -> Motion {
        let spec = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 2.0)
            .point("C", 5.0, 2.0)
            .point("D", 5.0, 0.0)
            .point("P", 3.0, 6.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C", "P"])
            .bar("rocker", &["D", "C"])
            .crank("crank");
        Motion::new(Mechanism::new(&spec).unwrap())
    }

    /// The coupler of a parallelogram moves without turning: P moves like B, on a circle about A shifted by (3, 4).
    #[test]
    fn points_of_a_parallelogram_have_one_centre_each() {
        let motion = parallelogram();
        for (name, centre) in [("B", [0.0, 0.0]), ("C", [5.0, 0.0]), ("P", [3.0, 4.0])] {
            let point = motion.mechanism().point(name).unwrap();
            let evolute = Evolute::of(&motion, point);
            let all: Vec<&Point> = evolute.pieces.iter().flatten().collect();
            assert!(all.len() > 360, "{name}: {}", all.len());
            for place in all {
                assert!(
                    (place - Point::from(centre)).norm() < 1e-11,
                    "{name}: {place}"
                );
            }
        }
    }

    #[test]
    fn a_fixed_point_has_no_evolute() {
        let motion = parallelogram();
        let pivot = motion.mechanism().point("D").unwrap();
        assert_eq!(Evolute::of(&motion, pivot), Evolute::default());
    }

    #[test]
    fn a_straight_path_has_no_evolute() {
        let spec = slider_crank([[0.0, 3.0], [4.0, 0.0]]);
        let motion = Motion::new(Mechanism::new(&spec).unwrap());
        let slider = motion.mechanism().point("C").unwrap();
        assert_eq!(Evolute::of(&motion, slider), Evolute::default());
    }
}
