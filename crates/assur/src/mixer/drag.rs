//! Dragging of the joints of a mixer.

use std::f64::consts::PI;

use super::Mixer;
use crate::{Assembly, FourBar, Point, Unsolved};

/// A joint that can be dragged. Joint A is fixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    /// Joint of crank and coupler; dragging it turns the crank.
    B,
    /// Joint of coupler and rocker; dragging it changes the lengths of both.
    C,
    /// Joint of rocker and frame; dragging it changes the lengths of both.
    D,
}

/// The change made by dragging a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dragged {
    /// New crank angle, radians; it differs from the old one by at most half a turn.
    Crank(f64),
    /// New lengths, valid or not, and the assembly.
    Lengths {
        /// Lengths l₁ … l₄ of crank, coupler, rocker and frame.
        lengths: [f64; 4],
        /// Assembly in which C is nearest to its required position; unchanged if the new lengths have no pose.
        assembly: Assembly,
    },
}

impl Mixer {
    /// Change of the mixer if `joint` is dragged to `to` while the crank angle is `crank`, radians.
    ///
    /// B follows `to` in direction only, because the crank keeps its length. C moves to `to`, which changes the lengths
    /// of coupler and rocker. D moves along the line of the frame to the abscissa of `to`; the lengths of frame and
    /// rocker change so that C stays. The lengths are not checked here but in [`Mixer::new`].
    ///
    /// # Errors
    /// [`Unsolved`]: an angle or a position that is not finite, or D dragged at a crank angle without a pose.
    pub fn dragged(&self, joint: Joint, crank: f64, to: Point) -> Result<Dragged, Unsolved> {
        if !(crank.is_finite() && to.x.is_finite() && to.y.is_finite()) {
            return Err(Unsolved::NotAnAngle);
        }
        let [l1, l2, _, l4] = self.linkage.lengths();
        let (a, d) = (Point::origin(), Point::new(l4, 0.0));
        let lengths = |lengths, c| Dragged::Lengths {
            lengths,
            assembly: nearest(lengths, crank, c).unwrap_or(self.assembly),
        };
        Ok(match joint {
            Joint::B if to == a => Dragged::Crank(crank),
            Joint::B => {
                let off = to.y.atan2(to.x) - crank;
                Dragged::Crank(crank + off - 2.0 * PI * (off / (2.0 * PI)).round())
            }
            Joint::C => {
                let b = Point::new(l1 * crank.cos(), l1 * crank.sin());
                lengths([l1, (to - b).norm(), (to - d).norm(), l4], to)
            }
            Joint::D => {
                let pose = self.linkage.pose::<1>(self.assembly, crank)?;
                let [.., c, _] = self.linkage.joints(&pose).map(|joint| joint.place());
                let rocker = (c - Point::new(to.x, 0.0)).norm();
                lengths([l1, l2, rocker, to.x], c)
            }
        })
    }
}

/// The assembly in which C is nearest to a position; None if no assembly has a pose.
fn nearest(lengths: [f64; 4], crank: f64, c: Point) -> Option<Assembly> {
    let linkage = FourBar::new(lengths).ok()?;
    let off = |assembly| {
        let pose = linkage.pose::<1>(assembly, crank).ok()?;
        let [.., there, _] = linkage.joints(&pose).map(|joint| joint.place());
        Some(((there - c).norm(), assembly))
    };
    let found = Assembly::ALL.into_iter().filter_map(off);
    Some(
        found
            .reduce(|best, next| if next.0 < best.0 { next } else { best })?
            .1,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gears::Mesh;
    use crate::mixer::Case;

    fn mixer(lengths: [f64; 4], assembly: Assembly) -> Mixer {
        let dimensions = super::super::Dimensions {
            lengths,
            assembly,
            mesh: Mesh::External,
            ..Case::A.dimensions()
        };
        Mixer::new(&dimensions).unwrap()
    }

    fn c_of(mixer: &Mixer, crank: f64) -> Point {
        let pose = mixer.linkage.pose::<1>(mixer.assembly, crank).unwrap();
        mixer.linkage.joints(&pose)[2].place()
    }

    #[test]
    fn b_drives_the_crank_by_the_shorter_way() {
        let mixer = mixer([0.37, 0.85, 0.55, 0.85], Assembly::First);
        for (crank, to, expected) in [
            (0.1, Point::new(0.0, 5.0), 0.5 * PI),
            (6.2, Point::new(3.0, 0.3), 2.0 * PI + 0.1_f64.atan()),
            (-6.2, Point::new(0.2, 0.0), -2.0 * PI),
            (1.0, Point::origin(), 1.0),
        ] {
            match mixer.dragged(Joint::B, crank, to) {
                Ok(Dragged::Crank(found)) => assert!((found - expected).abs() < 1e-14, "{found}"),
                other => panic!("{other:?}"),
            }
        }
    }

    /// The last target makes the four-bar a parallelogram.
    #[test]
    fn c_follows_to_either_side() {
        for start in Assembly::ALL {
            let mixer = mixer([0.37, 0.85, 0.55, 0.85], start);
            for step in -12..24 {
                let crank = f64::from(step) * 0.5 + 0.03;
                let b = Point::new(0.37 * crank.cos(), 0.37 * crank.sin());
                for to in [
                    Point::new(1.0, 0.6),
                    Point::new(0.9, -0.7),
                    Point::new(-0.4, 0.2),
                    b + crate::Vector::new(0.85, 0.0),
                ] {
                    let Ok(Dragged::Lengths { lengths, assembly }) =
                        mixer.dragged(Joint::C, crank, to)
                    else {
                        panic!("{to}")
                    };
                    assert_eq!([lengths[0], lengths[3]], [0.37, 0.85]);
                    let Ok(linkage) = FourBar::new(lengths) else {
                        continue;
                    };
                    let after = Mixer {
                        linkage,
                        assembly,
                        ..mixer.clone()
                    };
                    let off = (c_of(&after, crank) - to).norm();
                    assert!(off < 1e-9, "{crank} {to}: off by {off}");
                }
            }
        }
    }

    #[test]
    fn d_keeps_to_the_frame_line_and_c_stays() {
        let before = mixer([0.37, 0.85, 0.55, 0.85], Assembly::Second);
        let c = c_of(&before, 1.2);
        for x in [0.5, 0.8, 0.95] {
            let Ok(Dragged::Lengths { lengths, assembly }) =
                before.dragged(Joint::D, 1.2, Point::new(x, 0.4))
            else {
                panic!("{x}")
            };
            assert_eq!([lengths[0], lengths[1], lengths[3]], [0.37, 0.85, x]);
            let after = mixer(lengths, assembly);
            assert!((c_of(&after, 1.2) - c).norm() < 1e-9, "{x}");
        }
    }

    #[test]
    fn what_cannot_be_is_a_value() {
        let swings = mixer([0.6, 0.85, 0.3, 0.85], Assembly::First);
        let d = swings.dragged(Joint::D, 3.1, Point::new(0.8, 0.0));
        assert!(matches!(d, Err(Unsolved::Apart { .. })), "{d:?}");
        for (crank, to) in [
            (f64::NAN, Point::origin()),
            (1.0, Point::new(f64::INFINITY, 0.0)),
            (1.0, Point::new(0.0, f64::NAN)),
        ] {
            for joint in [Joint::B, Joint::C, Joint::D] {
                assert_eq!(swings.dragged(joint, crank, to), Err(Unsolved::NotAnAngle));
            }
        }
        // Invalid lengths are returned too; `Mixer::new` refuses them.
        let Ok(Dragged::Lengths { lengths, assembly }) =
            swings.dragged(Joint::D, 1.0, Point::new(-1.0, 0.0))
        else {
            panic!("lengths")
        };
        assert_eq!((lengths[3], assembly), (-1.0, Assembly::First));
        assert!(FourBar::new(lengths).is_err());
    }
}
