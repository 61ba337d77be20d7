//! Coupler curves of four-bars and slider-cranks of crank length 1, with derivatives with respect to the dimensions.
//!
//! The crank pin A is e^(iφ). With the fixed pivot D = l₄ and d = D − A, the coupler is the vector b = B − A = d(X +
//! iY)/(2|d|²), X = l₂² − l₃² + |d|², Y² = PQ, P = 2l₄(cos φ − c₋), Q = 2l₄(c₊ − cos φ). c₋ and c₊ are the cosines of
//! the limits of the crank. The coupler point is A + wb. A crank that turns fully has Y > 0; the other assembly is a
//! mirror image. A crank that swings through φ = −h cos τ, about 0 or π, passes through both assemblies in a turn of τ,
//! and Y has the sign of sin τ; so the curve is smooth in τ.

use nalgebra::Complex;

/// A kind of linkage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Four hinges.
    FourBar,
    /// Three hinges and a slider on the frame.
    SliderCrank,
}

/// Motion of the crank over a turn of the parameter τ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Swing {
    /// φ = τ.
    Full,
    /// φ = −h cos τ.
    AboutZero(f64),
    /// φ = π − h cos τ.
    AboutPi(f64),
}

/// The coupler curve of a linkage with a crank of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Curve {
    pub(super) kind: Kind,
    /// l₂, l₃, l₄ of a four-bar; rod, offset and 0 of a slider-crank.
    pub(super) sizes: [f64; 3],
    pub(super) w: Complex<f64>,
    pub(super) swing: Swing,
    /// c₋ and c₊, the cosines of the limits of the crank.
    limits: [f64; 2],
}

/// The pose at a value of τ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// A.
    pub(super) a: Complex<f64>,
    /// B − A.
    pub(super) b: Complex<f64>,
    /// Derivatives of the angles of crank and coupler with respect to τ.
    rates: [f64; 2],
}

/// The greatest ratio of two lengths of a linkage.
pub(super) const RATIO: f64 = 30.0;
/// The least sine of the transmission angle of a crank that turns fully. Nearer to a change point, rounding may move
/// the linkage to its other assembly.
pub(super) const LEAST_SINE: f64 = 0.01;

impl Curve {
    /// The curve for given unknowns: the logarithms of l₂, l₃ and l₄, or the logarithm of the rod and the ratio of the
    /// offset to rod less crank. None if the crank has no motion ([`swing`]), if it turns through a change point or
    /// near one, or if a ratio of lengths exceeds [`RATIO`].
    pub(super) fn new(kind: Kind, unknowns: [f64; 3], w: Complex<f64>) -> Option<Self> {
        let [x, y, z] = unknowns;
        let (sizes, swing, limits) = match kind {
            Kind::FourBar => {
                let sizes = [x.exp(), y.exp(), z.exp()];
                let (swing, limits) = swing(sizes)?;
                (sizes, swing, limits)
            }
            Kind::SliderCrank => {
                let rod = x.exp();
                let offset = y * (rod - 1.0);
                let rise = (1.0 + offset.abs()) / rod;
                let sound = (1.0 - rise) * (1.0 + rise) >= LEAST_SINE * LEAST_SINE;
                sound.then_some(([rod, offset, 0.0], Swing::Full, [-1.0, 1.0]))?
            }
        };
        let lengths = match kind {
            Kind::FourBar => &sizes[..],
            Kind::SliderCrank => &sizes[..1],
        };
        let [least, greatest] = (lengths.iter()).fold([1.0_f64; 2], |[least, greatest], length| {
            [least.min(*length), greatest.max(*length)]
        });
        let arm = w.norm() * sizes[0];
        let sound = greatest <= RATIO * least && arm <= RATIO;
        sound.then_some(Self {
            kind,
            sizes,
            w,
            swing,
            limits,
        })
    }

    /// The pose at a value of τ.
    pub(super) fn place(&self, tau: f64) -> Place {
        let (angle, rate) = match self.swing {
            Swing::Full => (tau, 1.0),
            Swing::AboutZero(h) => (-h * tau.cos(), h),
            Swing::AboutPi(h) => (-h * tau.cos(), h),
        };
        let turn = Complex::cis(angle);
        match self.swing {
            Swing::Full => self.at_crank(turn),
            Swing::AboutZero(h) => self.swung(turn, h, tau, rate),
            Swing::AboutPi(h) => self.swung(-turn, h, tau, rate),
        }
    }

    /// The pose at e^(iφ) for a crank that turns fully.
    #[inline]
    pub(super) fn at_crank(&self, a: Complex<f64>) -> Place {
        match self.kind {
            Kind::FourBar => {
                let [_, _, l4] = self.sizes;
                let [low, high] = self.limits;
                let square = (4.0 * l4 * l4 * (a.re - low) * (high - a.re)).max(0.0);
                let area = square.sqrt();
                let b = self.coupler(a, area);
                let c = a + b - l4;
                // b × c = Y/2.
                let turn = 2.0 * cross(c, a) / area.max(f64::MIN_POSITIVE);
                Place {
                    a,
                    b,
                    rates: [1.0, turn],
                }
            }
            Kind::SliderCrank => {
                let [rod, offset, _] = self.sizes;
                let rise = offset - a.im;
                let along = ((rod - rise) * (rod + rise)).max(0.0).sqrt();
                Place {
                    a,
                    b: Complex::new(along, rise),
                    rates: [1.0, -a.re / along.max(f64::MIN_POSITIVE)],
                }
            }
        }
    }

    /// Vector B − A of the coupler from Y, which is `area`.
    #[inline]
    fn coupler(&self, a: Complex<f64>, area: f64) -> Complex<f64> {
        let [l2, l3, l4] = self.sizes;
        let d = Complex::new(l4, 0.0) - a;
        let square = d.norm_sqr();
        let along = (l2 - l3) * (l2 + l3) + square;
        d * Complex::new(along, area) * (0.5 / square)
    }

    /// The pose of a crank that swings through an angle h to both sides.
    fn swung(&self, a: Complex<f64>, h: f64, tau: f64, rate: f64) -> Place {
        let [_, _, l4] = self.sizes;
        let [low, high] = self.limits;
        let (sin, cos) = (0.5 * tau).sin_cos();
        // With s and c, the sine and cosine of τ/2, the factor of Y² that vanishes at the limits is
        // 2l₄ · 2 sin(hs²) sin(hc²).
        let ends = over(h, sin * sin) * over(h, cos * cos);
        let other = match self.swing {
            Swing::AboutPi(_) => a.re - low,
            _ => high - a.re,
        };
        // Y = sin τ · slope.
        let slope = 0.5 * (8.0 * l4 * l4 * ends * other).max(0.0).sqrt();
        let b = self.coupler(a, 2.0 * sin * cos * slope);
        let c = a + b - l4;
        let scale = 2.0 * rate / slope.max(f64::MIN_POSITIVE);
        Place {
            a,
            b,
            rates: [scale * cross(b, c), scale * cross(c, a)],
        }
    }

    /// The coupler point A + wb.
    #[inline]
    pub(super) fn point(&self, place: &Place) -> Complex<f64> {
        place.a + self.w * place.b
    }

    /// Derivative of the point with respect to τ.
    pub(super) fn tangent(&self, place: &Place) -> Complex<f64> {
        let [crank, coupler] = place.rates;
        times_i(place.a * crank + self.w * place.b * coupler)
    }

    /// Derivatives of the point with respect to the three unknowns of [`Self::new`]. One of the three angles is held
    /// constant: the crank's if it is the input (`driven`), otherwise the one for which the equations are best
    /// conditioned. Another choice changes the derivatives by a multiple of the tangent.
    pub(super) fn derivatives(&self, place: &Place, driven: bool) -> [Complex<f64>; 3] {
        let (a, b, w) = (place.a, place.b, self.w);
        if self.kind == Kind::SliderCrank {
            let [rod, _, _] = self.sizes;
            // The offset is y(l₂ − 1): it changes with the rod, too.
            let share = self.sizes[1] / (rod - 1.0);
            let by_rod = b + times_i(b) * ((share * rod - b.im) / b.re);
            let by_share = times_i(b) * ((rod - 1.0) / b.re);
            return [w * by_rod, w * by_share, Complex::new(0.0, 0.0)];
        }
        let [_, _, l4] = self.sizes;
        let c = a + b - l4;
        let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
        // If dl₂/l₂, dl₃/l₃ or dl₄/l₄ is 1, the closure is a dφ₁ + b dφ₂ − c dφ₃ = −ir with its r from `gaps`.
        let gaps = [-b, c, Complex::new(l4, 0.0)];
        std::array::from_fn(|k| {
            let gap = -times_i(gaps[k]);
            let [crank, coupler] = if driven || bc.abs() >= ca.abs() && bc.abs() >= ab.abs() {
                [0.0, cross(gap, c) / bc]
            } else if ca.abs() >= ab.abs() {
                [-cross(gap, c) / ca, 0.0]
            } else {
                [cross(gap, b) / ab, cross(a, gap) / ab]
            };
            let own = if k == 0 {
                w * b
            } else {
                Complex::new(0.0, 0.0)
            };
            times_i(a * crank + w * b * coupler) + own
        })
    }

    /// Poses at equal steps of τ from a first value over a span.
    pub(super) fn places(&self, [from, span]: [f64; 2], count: usize) -> Vec<Place> {
        let step = span / (count.max(2) - 1) as f64;
        (0..count)
            .map(|k| self.place(from + step * k as f64))
            .collect()
    }

    /// The longest of the lengths, the crank included.
    pub(super) fn longest(&self) -> f64 {
        let [x, y, z] = self.sizes;
        x.max(y.abs()).max(z).max(1.0)
    }
}

/// Motion of a crank of length 1, and the cosines of its limits. None if the crank turns fully but near a change point,
/// or if it swings between limits on one side of the frame. In the latter case a cognate has a crank that turns fully.
fn swing([l2, l3, l4]: [f64; 3]) -> Option<(Swing, [f64; 2])> {
    let cosine = |diagonal: f64| (1.0 + (l4 - diagonal) * (l4 + diagonal)) / (2.0 * l4);
    let [low, high] = [cosine(l2 + l3), cosine(l2 - l3)];
    let swing = match (low <= -1.0, high >= 1.0) {
        (true, true) => {
            // The transmission angle μ is least where the crank lies along the frame. Y = 2l₂l₃ sin μ is compared there
            // with Y² = 4l₄²(cos φ − c₋)(c₊ − cos φ).
            let factors = ((1.0 - low) * (high - 1.0)).min((-1.0 - low) * (high + 1.0));
            let is_clear = l4 * l4 * factors >= (LEAST_SINE * l2 * l3).powi(2);
            is_clear.then_some(Swing::Full)?
        }
        (false, true) if low < 1.0 => Swing::AboutZero(low.acos()),
        (true, false) if high > -1.0 => Swing::AboutPi((-high).acos()),
        _ => return None,
    };
    Some((swing, [low, high]))
}

/// sin(hx)/x, with its limit h at x = 0.
fn over(h: f64, x: f64) -> f64 {
    if x > 1e-9 { (h * x).sin() / x } else { h }
}

pub(super) fn times_i(z: Complex<f64>) -> Complex<f64> {
    Complex::new(-z.im, z.re)
}

/// a × b.
pub(super) fn cross(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.im - a.im * b.re
}

/// a · b.
pub(super) fn dot(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.re + a.im * b.im
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_crank_turns_through_a_change_point_or_near_one() {
        let curve = |kind, unknowns| Curve::new(kind, unknowns, Complex::new(0.5, 0.5));
        let swing = |coupler: f64| {
            let unknowns = [coupler, 1.5, 1.5].map(f64::ln);
            curve(Kind::FourBar, unknowns).map(|curve| curve.swing)
        };
        // A coupler of 2 would give a change point: 1 + 2 = 1.5 + 1.5.
        assert_eq!([swing(1.9999), swing(1.999_999)], [None, None]);
        assert_eq!(swing(1.99), Some(Swing::Full));
        let turns = |share: f64| curve(Kind::SliderCrank, [3f64.ln(), share, 0.0]).is_some();
        assert_eq!([1.0, 0.99999, 0.9].map(turns), [false, false, true]);
    }
}
