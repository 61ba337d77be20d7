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
    let along = (q - p).dot(v.left()) * -sine.recip();
    Ok(p + u.scaled(along))
}
