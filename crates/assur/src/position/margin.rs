//! Margins: the quantities under the square roots in the closed form of a dyad. They must not become negative.

use super::{Cause, Complex};
use crate::{Jet, tolerance};

/// Reason why a margin has no root.
pub(crate) enum Dead {
    /// The margin is zero within rounding: the derivatives of its root, which are required, are unbounded.
    At,
    /// The margin is negative.
    Beyond,
}

/// Returns true if a margin is positive, and false if it is zero within rounding and no derivatives are required.
/// `scale` is the size of the squared lengths in the margin.
///
/// # Errors
/// The margin is negative, or derivatives are required at a zero margin, where they would be unbounded.
pub(crate) fn clear<const N: usize>(margin: Jet<N>, scale: f64) -> Result<bool, Dead> {
    if margin.value() > tolerance::CONVERGED * scale {
        Ok(true)
    } else if margin.value() < -tolerance::CONVERGED * scale {
        Err(Dead::Beyond)
    } else if N == 1 {
        Ok(false)
    } else {
        Err(Dead::At)
    }
}

/// Square root of a margin; zero if the margin is zero within rounding, where the root would have only half the digits.
pub(crate) fn root<const N: usize>(margin: Jet<N>, scale: f64) -> Result<Jet<N>, Dead> {
    Ok(if clear(margin, scale)? {
        margin.sqrt()
    } else {
        Jet::constant(0.0)
    })
}

/// Intersects two lines (point, unit direction), and sets `margin` to the squared sine of the angle between them.
pub(crate) fn crossing<const N: usize>(
    lines: [(Complex<N>, Complex<N>); 2],
    margin: &mut [Jet<N>; 2],
) -> Result<Complex<N>, Cause> {
    let [(p, u), (q, v)] = lines;
    let sine = v.dot(u.left());
    *margin = [sine.square(); 2];
    if sine.value().abs() <= tolerance::CONVERGED {
        return Err(Cause::Parallel);
    }
    let along = (p - q).dot(v.left()) / sine;
    Ok(p + u.scaled(along))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vector;

    /// The root of 9, with the rate 12, is 3, with the rate 12/(2·3). Within rounding of zero the root is zero; its
    /// derivatives would be unbounded.
    #[test]
    fn a_margin_has_a_root_unless_it_is_negative() {
        let found = root(Jet::<2>::linear(9.0, 12.0), 1.0).ok().unwrap();
        assert_eq!([found.value(), found.derivative(1)], [3.0, 2.0]);
        for rounding in [1e-16, 0.0, -1e-16] {
            assert_eq!(
                root(Jet::<1>::constant(rounding), 1.0).ok(),
                Some(Jet::constant(0.0))
            );
            assert!(matches!(
                root(Jet::<2>::constant(rounding), 1.0),
                Err(Dead::At)
            ));
        }
        assert!(matches!(
            root(Jet::<1>::constant(-1.0), 1.0),
            Err(Dead::Beyond)
        ));
        // Relative to squared lengths of 10¹⁶, a difference of 1 is rounding.
        assert!(matches!(
            root(Jet::<2>::constant(-1.0), 1e16),
            Err(Dead::At)
        ));
    }

    /// The x-axis and the line from (4, 4) in the direction (3, 4)/5 meet in (1, 0); the sine between them is 4/5. If
    /// the second line moves along x at 2, so does the point; if it moves along y at 4, the point moves at −3 along x.
    #[test]
    fn two_lines_meet_and_their_crossing_moves_with_them() {
        let axis = (
            Complex::constant(Vector::zeros()),
            Complex::constant(Vector::x()),
        );
        let direction = Complex::constant(Vector::new(0.6, 0.8));
        for (velocity, expected) in [([2.0, 0.0], 2.0), ([0.0, 4.0], -3.0), ([3.0, 4.0], 0.0)] {
            let mut place = Complex::<2>::constant(Vector::new(4.0, 4.0));
            place[1] = Vector::from(velocity);
            let mut margin = [Jet::constant(0.0); 2];
            let found = crossing([axis, (place, direction)], &mut margin)
                .ok()
                .unwrap();
            assert!((found[0] - Vector::x()).norm() < 1e-15, "{found:?}");
            assert!(
                (found[1] - Vector::new(expected, 0.0)).norm() < 1e-15,
                "{found:?}"
            );
            assert!((margin[0].value() - 0.64).abs() < 1e-15);
        }
    }

    #[test]
    fn parallel_lines_do_not_meet() {
        let line = |y: f64, along: f64| {
            let place = Complex::<2>::constant(Vector::new(0.0, y));
            (place, Complex::constant(Vector::new(along, 0.0)))
        };
        for along in [1.0, -1.0] {
            let mut margin = [Jet::constant(1.0); 2];
            let met = crossing([line(0.0, 1.0), line(1.0, along)], &mut margin);
            assert!(matches!(met, Err(Cause::Parallel)));
            assert_eq!(margin[0].value(), 0.0);
        }
    }

    /// Nearly parallel lines: the x-axis, and a line that turns about the point (3, 0). Their intersection is on both
    /// in all derivatives.
    #[test]
    fn nearly_parallel() {
        let [origin, axis, pivot] =
            [0.0, 1.0, 3.0].map(|x| Complex::<3>::constant(Vector::x() * x));
        let turning = Complex::turn(Jet::linear(1e-5, 1.0));
        let start = pivot + turning.by(Vector::new(0.3, 0.0));
        let mut margin = [Jet::constant(0.0); 2];
        let found = crossing([(origin, axis), (start, turning)], &mut margin);
        let found = found.unwrap();
        assert!((found.value() - pivot.value()).norm() < 1e-11);
        let across = (found - start).dot(turning.left());
        for order in 0..3 {
            let off = [found.y(), across].map(|jet| jet.derivative(order).abs());
            assert!(off[0].max(off[1]) < 1e-15, "order {order}: {off:?}");
        }
    }
}
