//! Margins: squares whose roots a dyad takes, which must not become negative.

use super::{Cause, Complex};
use crate::Jet;

/// A margin that is this small relative to its scale is zero: the rounding of the
/// squares it is made of.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

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
) -> Result<Complex<N>, Cause> {
    let [(p, u), (q, v)] = lines;
    let sine = v.dot(u.left());
    *margin = [sine.square(); 2];
    if sine.value().abs() <= ROUNDING {
        return Err(Cause::Parallel);
    }
    let along = (q - p).dot(v.left()) * -sine.recip();
    Ok(p + u.scaled(along))
}
