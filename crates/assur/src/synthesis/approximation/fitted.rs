//! A linkage in the plane of the path: the unknowns of a descent, and the feet of the path on its curve.

mod feet;

use nalgebra::Complex;

use super::compare::{Candidate, Match, Part};
use super::curve::{Curve, Kind, Swing, dot, times_i};
use super::distance::Deviation;
use super::target::Target;
use super::turning;
use crate::numeric::max_abs;
use crate::tolerance;
pub(super) use feet::nearest;

/// Number of unknowns: two each for α, β and w, three dimensions, and the crank angle at the first place.
pub(super) const UNKNOWNS: usize = 10;
pub(super) type Unknowns = [f64; UNKNOWNS];

/// The greatest length of a linkage, relative to the size of the path.
const REACH: f64 = 25.0;
/// A linkage in the plane of the path, with its feet.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub(super) kind: Kind,
    pub(super) mirrored: bool,
    pub(super) x: Unknowns,
    pub(super) curve: Curve,
    /// τ at the compared places of the path, not reduced to a turn.
    pub(super) feet: Vec<f64>,
    /// Sense in which the crank turns through the given angles, ±1; 0 if none are given.
    sense: f64,
    /// Distances at the compared places, then those of [`Self::both`].
    pub(super) distances: Vec<f64>,
    /// Pairs of places, as [`Deviation`] compares them both ways: τ of the traced curve, and the place of the path. First
    /// those of the path's corners with their feet, then those of the curve with the nearest places of the path. Empty
    /// until [`Self::both_ways`].
    pub(super) both: Vec<(f64, Complex<f64>)>,
    /// Senses in which the first two unknowns of the dimensions are at their limits; 0 inside.
    pub(super) limits: [f64; 2],
    compares_both: bool,
    /// Places of the traced curve that are compared with the path, as fractions of the part that traces it.
    places: Vec<f64>,
}

impl Fitted {
    /// A candidate in the place, size and direction in which it is nearest to the path.
    pub(super) fn new(candidate: &Candidate, found: &Match, target: &Target) -> Option<Self> {
        let feet = candidate.parameters(found, target);
        let curve = candidate.curve;
        let places: Vec<Complex<f64>> = (feet.iter())
            .map(|tau| mirrored(curve.point(&curve.place(*tau)), candidate.mirrored))
            .collect();
        let count = places.len() as f64;
        let mean = |of: &[Complex<f64>]| of.iter().sum::<Complex<f64>>() / count;
        let (from, to) = (mean(&places), mean(&target.compared));
        let (mut product, mut square) = (Complex::new(0.0, 0.0), 0.0);
        for (place, wanted) in places.iter().zip(&target.compared) {
            product += (place - from).conj() * (wanted - to);
            square += (place - from).norm_sqr();
        }
        let alpha = product / square;
        let beta = to - alpha * from;
        let [x, y, z] = unknowns(&curve);
        let (start, sense) = match candidate.part {
            Part::Timed([from, sense]) => (from, sense),
            _ => (0.0, 0.0),
        };
        let w = curve.w;
        let x = [
            alpha.re, alpha.im, beta.re, beta.im, w.re, w.im, x, y, z, start,
        ];
        let mut fitted = Self {
            kind: curve.kind,
            mirrored: candidate.mirrored,
            x,
            curve,
            feet,
            sense,
            distances: Vec::new(),
            both: Vec::new(),
            limits: [0.0; 2],
            compares_both: false,
            places: Vec::new(),
        };
        let sound = x.iter().all(|x| x.is_finite()) && fitted.within_reach();
        sound.then(|| {
            fitted.settle(target, 3);
            fitted.seek_feet(target);
            fitted
        })
    }

    /// A curve placed in the plane of the path by α and β.
    pub(super) fn placed(curve: Curve, [alpha, beta]: [Complex<f64>; 2], feet: Vec<f64>) -> Self {
        let [x, y, z] = unknowns(&curve);
        let w = curve.w;
        Self {
            kind: curve.kind,
            mirrored: false,
            x: [
                alpha.re, alpha.im, beta.re, beta.im, w.re, w.im, x, y, z, 0.0,
            ],
            curve,
            feet,
            sense: 0.0,
            distances: Vec::new(),
            both: Vec::new(),
            limits: [0.0; 2],
            compares_both: false,
            places: Vec::new(),
        }
    }

    fn within_reach(&self) -> bool {
        let scale = self.x[0].hypot(self.x[1]);
        let longest = self
            .curve
            .longest()
            .max(self.curve.w.norm() * self.curve.sizes[0]);
        scale * longest <= REACH && scale > tolerance::COINCIDENT
    }

    pub(super) fn alpha(&self) -> Complex<f64> {
        Complex::new(self.x[0], self.x[1])
    }

    fn beta(&self) -> Complex<f64> {
        Complex::new(self.x[2], self.x[3])
    }

    /// Converts a place from the plane of the curve, in which the crank has length 1, to the plane of the path.
    pub(super) fn laid(&self, place: Complex<f64>) -> Complex<f64> {
        self.alpha() * mirrored(place, self.mirrored) + self.beta()
    }

    /// Place of the coupler point at a value of τ.
    pub(super) fn point(&self, tau: f64) -> Complex<f64> {
        self.laid(self.curve.point(&self.curve.place(tau)))
    }

    /// Place of the coupler point on its link, and the dimensions; equal for similar curves.
    pub(super) fn shape(&self) -> [f64; 5] {
        let [x, y, z] = match self.curve.kind {
            Kind::FourBar => self.curve.sizes.map(f64::ln),
            Kind::SliderCrank => unknowns(&self.curve),
        };
        [self.x[4], self.x[5], x, y, z]
    }

    /// Place of the coupler point when the crank has turned through a given angle from the first place.
    pub(super) fn at_turn(&self, turn: f64) -> Complex<f64> {
        self.point(self.x[9] + self.sense * turn)
    }

    /// The deviation from the distances that are compared.
    pub(super) fn at_feet(&self) -> Deviation {
        Deviation::from_distances(&self.distances)
    }

    /// The greatest distance that is compared.
    pub(super) fn greatest(&self) -> f64 {
        max_abs(self.distances.iter().copied())
    }

    /// The linkage with other unknowns, those beyond their limits moved to them; None if there is none.
    pub(super) fn moved(&self, x: Unknowns, target: &Target) -> Option<Self> {
        let mut next = self.with_unknowns(x)?;
        next.within_reach().then(|| {
            next.settle(target, 1);
            next
        })
    }

    /// The linkage with other unknowns, before its feet are settled.
    fn with_unknowns(&self, mut x: Unknowns) -> Option<Self> {
        let w = Complex::new(x[4], x[5]);
        let mut dimensions = [x[6], x[7], x[8]];
        let (unknowns, limits) = if has_turning_crank(&self.curve) {
            let is_long = self.curve.sizes[2] > 1.0;
            let (sizes, limits) = turning::sizes(&mut dimensions, is_long);
            (sizes.map(f64::ln), limits)
        } else {
            (dimensions, [0.0; 2])
        };
        let curve = Curve::new(self.kind, unknowns, w)?;
        x[6..9].copy_from_slice(&dimensions);
        if std::mem::discriminant(&curve.swing) != std::mem::discriminant(&self.curve.swing) {
            return None;
        }
        Some(Self {
            x,
            curve,
            limits,
            ..self.clone()
        })
    }

    /// Signed distances that are compared, each with its derivatives with respect to the unknowns. A distance does not
    /// change to first order as its foot moves along the curve.
    pub(super) fn rows(&self, target: &Target) -> Vec<(Unknowns, f64)> {
        let timed = target.angles.is_some();
        let row = |tau: f64, wanted: Complex<f64>, is_foot: bool| {
            let (by, tangent) = self.derivatives(tau, timed);
            let off = self.point(tau) - wanted;
            let normal = if is_foot && tangent.norm() > tolerance::COINCIDENT {
                times_i(tangent / tangent.norm())
            } else {
                off / off.norm().max(f64::MIN_POSITIVE)
            };
            (
                by.map(|by| dot(by, normal)),
                off.norm().copysign(dot(off, normal)),
            )
        };
        let feet = self.feet.iter().zip(&target.compared);
        let feet = feet.map(|(tau, wanted)| row(*tau, *wanted, !timed));
        let both = self
            .both
            .iter()
            .map(|(tau, place)| row(*tau, *place, false));
        feet.chain(both).collect()
    }

    /// Derivatives of the place at a foot with respect to all unknowns, then with respect to τ.
    pub(super) fn derivatives(
        &self,
        tau: f64,
        timed: bool,
    ) -> ([Complex<f64>; UNKNOWNS], Complex<f64>) {
        let pose = self.curve.place(tau);
        let alpha = self.alpha();
        let laid = |z: Complex<f64>| alpha * mirrored(z, self.mirrored);
        let (point, tangent) = (self.curve.point(&pose), laid(self.curve.tangent(&pose)));
        let unit = mirrored(point, self.mirrored);
        let by = self.curve.derivatives(&pose, timed).map(laid);
        let [x, y, z] = if has_turning_crank(&self.curve) {
            turning::chained(by, self.curve.sizes)
        } else {
            by
        };
        let one = Complex::new(1.0, 0.0);
        let start = if timed {
            tangent
        } else {
            Complex::new(0.0, 0.0)
        };
        let by = [
            unit,
            times_i(unit),
            one,
            times_i(one),
            laid(pose.b),
            laid(times_i(pose.b)),
            x,
            y,
            z,
            start,
        ];
        (by, tangent)
    }
}

/// True for a four-bar whose crank turns fully. The unknowns of its dimensions are those of [`turning`].
fn has_turning_crank(curve: &Curve) -> bool {
    curve.kind == Kind::FourBar && curve.swing == Swing::Full
}

/// The unknowns of a curve's dimensions.
fn unknowns(curve: &Curve) -> [f64; 3] {
    let [x, y, z] = curve.sizes;
    match curve.kind {
        Kind::FourBar if curve.swing == Swing::Full => turning::coordinates(curve.sizes),
        Kind::FourBar => [x.ln(), y.ln(), z.ln()],
        Kind::SliderCrank => [x.ln(), y / (x - 1.0), 0.0],
    }
}

fn mirrored(z: Complex<f64>, mirrored: bool) -> Complex<f64> {
    if mirrored { z.conj() } else { z }
}

#[cfg(test)]
pub(super) mod tests {
    use std::f64::consts::PI;

    use super::*;

    pub(in crate::synthesis::approximation) fn start(
        kind: Kind,
        unknowns: [f64; 3],
        mirrored: bool,
    ) -> Fitted {
        let curve = Curve::new(kind, unknowns, Complex::new(0.4, 0.7)).unwrap();
        Fitted {
            kind,
            mirrored,
            x: {
                let [x, y, z] = super::unknowns(&curve);
                [0.3, 0.1, -0.05, 0.02, 0.4, 0.7, x, y, z, 0.0]
            },
            curve,
            feet: Vec::new(),
            sense: 0.0,
            distances: Vec::new(),
            both: Vec::new(),
            limits: [0.0; 2],
            compares_both: false,
            places: Vec::new(),
        }
    }

    /// Derivatives with respect to the dimensions agree with difference quotients, normal to the curve, for each motion
    /// of the crank.
    #[test]
    fn derivatives_are_those_of_the_point() {
        let four = [
            [1.1, 0.9, 1.3],
            [0.1, 0.3, 0.6],
            [0.9, 0.2, 0.5],
            [0.3, 0.2, -0.4],
        ];
        let slider = [[1.0, 0.4, 0.0]];
        let all = four
            .map(|x| (Kind::FourBar, x))
            .into_iter()
            .chain(slider.map(|x| (Kind::SliderCrank, x)));
        for (kind, x) in all {
            for mirror in [false, true] {
                let fitted = start(kind, x, mirror);
                for tau in [0.3, 1.7, PI, 4.0, 5.9] {
                    let (by, tangent) = fitted.derivatives(tau, false);
                    let normal = times_i(tangent / tangent.norm());
                    for (k, by) in by.iter().enumerate().take(9) {
                        let step = 1e-6;
                        let shifted = |sign: f64| {
                            let mut x = fitted.x;
                            x[k] += sign * step;
                            fitted.with_unknowns(x).unwrap().point(tau)
                        };
                        let quotient = (shifted(1.0) - shifted(-1.0)) / (2.0 * step);
                        let off = dot(quotient - by, normal);
                        assert!(off.abs() < 1e-7, "{kind:?} {x:?} {tau} {k}: {off:e}");
                    }
                    let quotient = (fitted.point(tau + 1e-6) - fitted.point(tau - 1e-6)) / 2e-6;
                    assert!((quotient - tangent).norm() < 1e-7, "{kind:?} {x:?} {tau}");
                }
            }
        }
    }
}
