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

/// True if a margin is positive. False if it is zero within rounding error and no derivatives are required; they would
/// be unbounded. `scale` is the size of the squared lengths in the margin.
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
    use super::crossing;
    use crate::position::Complex;
    use crate::{Jet, Vector};

    /// Nearly parallel lines: the x axis, and a line that turns about the point (3, 0). Their intersection is on both in all
    /// derivatives.
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
