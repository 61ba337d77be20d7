//! The sides on which the block of a slide bears.

/// Side on which the block of a slide bears, by the sign of a component of the reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bearing {
    /// On one of its faces, by the normal force.
    Face(f64),
    /// On both of its ends, by the moment: the line of the reaction passes the block.
    Ends(f64),
}

impl Bearing {
    /// Bearing of a block under a normal force a and a moment b, in units of force, whose forces on the ends are together
    /// `arm` times b.
    pub(super) fn of([a, b]: [f64; 2], arm: f64) -> Self {
        if arm * b.abs() > a.abs() {
            Self::Ends(b.signum())
        } else {
            Self::Face(a.signum())
        }
    }

    /// Forces on the surfaces together, with their derivatives by both components.
    pub(super) fn force(self, [a, b]: [f64; 2], arm: f64) -> (f64, [f64; 2]) {
        match self {
            Self::Face(sign) => (sign * a, [sign, 0.0]),
            Self::Ends(sign) => (sign * arm * b, [0.0, sign * arm]),
        }
    }

    /// Distance, as a force, from a change of the bearing; negative beyond it.
    pub(super) fn margin(self, [a, b]: [f64; 2], arm: f64) -> f64 {
        match self {
            Self::Face(sign) => sign * a - arm * b.abs(),
            Self::Ends(sign) => sign * arm * b - a.abs(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A block of length 4 in a mechanism of size 2: a moment of b·2 bears on its ends, at 2 from the middle each, with
    /// b and b, which is more than the normal force a if b > a.
    #[test]
    fn a_block_bears_on_a_face_or_on_its_ends() {
        let arm = 2.0 * 2.0 / 4.0;
        assert_eq!(Bearing::of([-3.0, 2.0], arm), Bearing::Face(-1.0));
        assert_eq!(Bearing::of([3.0, -4.0], arm), Bearing::Ends(-1.0));
        let (force, by) = Bearing::Face(-1.0).force([-3.0, 2.0], arm);
        assert_eq!((force, by), (3.0, [-1.0, 0.0]));
        let (force, by) = Bearing::Ends(-1.0).force([3.0, -4.0], arm);
        assert_eq!((force, by), (4.0, [0.0, -1.0]));
        assert_eq!(Bearing::Face(-1.0).margin([-3.0, 2.0], arm), 1.0);
        assert_eq!(Bearing::Ends(-1.0).margin([5.0, -4.0], arm), -1.0);
    }
}
