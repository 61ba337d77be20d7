//! The feet of the path on a curve, and the distances that a descent compares.
//!
//! The last descents compare both ways, as [`Deviation`](super::Deviation) does: places of the path with the curve, and
//! places of the curve with the path. The places of the curve are those at equal intervals and, by the exchange method
//! (E. J. Remez, 1934), those that were farthest from the path when each descent began.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{Fitted, mirrored};
use crate::angle::nearest_to;
use crate::numeric::max_abs;
use crate::synthesis::approximation::curve::dot;
use crate::synthesis::approximation::distance::part;
use crate::synthesis::approximation::target::{Course, Target};

/// The greatest step of a foot along τ.
const FOOT_STEP: f64 = 0.2;

/// Maximum number of further steps to a foot after a step that went past it. A step counts as past the foot if it
/// leaves more than the part `CONTRACTION` of the distance along the curve, on the other side.
const MORE_STEPS: usize = 8;
const CONTRACTION: f64 = 0.3;

/// Number of places at equal intervals of the traced curve that a descent compares with the path.
const EVEN: usize = 48;
/// Number of places of the traced curve among which feet are sought; `FINE` is that for the farthest places.
const SOUGHT: usize = 192;
const FINE: usize = 256;
/// Least interval between two compared places, as a fraction of the part that traces the path.
const APART: f64 = 1e-3;
/// Distance of two neighbouring places between which another is sought, unless they are within a part `SHORTEST` of the
/// interval.
const FAR_APART: f64 = 0.02;
const SHORTEST: f64 = 0.02;
/// Distance, relative to the greatest, from which a local maximum is compared.
const FAR: f64 = 0.5;

impl Fitted {
    /// The same linkage with the distances of the path's corners from its curve, and of places of its curve from the path,
    /// among its distances, if the path is a drawn curve without crank angles. Feet are sought anew. Each call adds the
    /// places of the curve that are then the farthest from the path.
    pub(in crate::synthesis::approximation) fn both_ways(mut self, target: &Target) -> Self {
        self.compares_both = target.course() != Course::Points && target.angles.is_none();
        self.both.clear();
        self.seek_feet(target);
        if self.compares_both {
            self.add_farthest(target);
        }
        self.settle(target, 2);
        self
    }

    /// Adds the places of the curve at which the distance from the path is a local maximum.
    fn add_farthest(&mut self, target: &Target) {
        let [from, to] = part(self, target);
        if to <= from {
            return;
        }
        let curve = self.sampled([from, to], FINE);
        let distances = curve.iter().map(|(_, place)| target.path.distance(*place));
        let distances: Vec<f64> = distances.collect();
        let far = FAR * max_abs(distances.iter().copied());
        let share = |tau: f64| (tau - from) / (to - from);
        let places = &mut self.places;
        if places.is_empty() {
            places.extend((0..EVEN).map(|k| (k as f64 + 0.5) / EVEN as f64));
        }
        for (k, beside) in distances.windows(3).enumerate() {
            if beside[1] > far && beside[1] >= beside[0] && beside[1] > beside[2] {
                places.push(share(curve[k + 1].0));
            }
        }
        places.sort_by(f64::total_cmp);
        places.dedup_by(|b, a| *b - *a < APART);
    }

    /// Moves each foot of a closed path to the nearest place of the whole curve. A foot that only follows its neighbourhood
    /// may stay on the wrong strand, as at a small loop.
    pub(super) fn seek_feet(&mut self, target: &Target) {
        if target.course() != Course::Closed {
            return;
        }
        let curve = self.sampled([0.0, TAU], SOUGHT);
        let mut feet = std::mem::take(&mut self.feet);
        let mut before = feet.first().copied();
        for (foot, wanted) in feet.iter_mut().zip(&target.compared) {
            let (tau, square) = nearest(&curve, *wanted);
            if square < (self.point(*foot) - wanted).norm_sqr() {
                *foot = tau;
            }
            *foot = nearest_to(*foot, before.unwrap_or(*foot));
            before = Some(*foot);
        }
        self.feet = feet;
        self.settle(target, 2);
    }

    /// Places of the curve with their τ, in order: at equal steps with both ends, and between them where the curve moves
    /// fast, as near a change point.
    pub(in crate::synthesis::approximation) fn sampled(
        &self,
        [from, to]: [f64; 2],
        count: usize,
    ) -> Vec<(f64, Complex<f64>)> {
        let at = |tau: f64| (tau, self.point(tau));
        let step = (to - from) / (count - 1) as f64;
        let mut found = vec![at(from)];
        for k in 1..count {
            let mut ahead = vec![at(from + step * k as f64)];
            while let (Some(next), Some(last)) = (ahead.pop(), found.last()) {
                let is_far = (next.1 - last.1).norm() > FAR_APART;
                if is_far && next.0 - last.0 > SHORTEST * step {
                    ahead.extend([next, at(0.5 * (last.0 + next.0))]);
                } else {
                    found.push(next);
                }
            }
        }
        found
    }

    /// The foot of a place near a given τ, and its distance; the given τ itself if no step reduces the distance.
    /// At the end of a narrow curve a step may go past the foot; then more steps follow, by the secant method.
    pub(in crate::synthesis::approximation) fn foot(
        &self,
        wanted: Complex<f64>,
        from: f64,
        steps: usize,
    ) -> (f64, f64) {
        let alpha = self.alpha();
        let approach = |tau: f64| {
            let pose = self.curve.place(tau);
            let off = self.laid(self.curve.point(&pose)) - wanted;
            let tangent = alpha * mirrored(self.curve.tangent(&pose), self.mirrored);
            let square = tangent.norm_sqr().max(f64::MIN_POSITIVE);
            (dot(off, tangent), square, off.norm())
        };
        let mut tau = from;
        let (mut along, mut square, first) = approach(from);
        let mut distance = first;
        let mut past = None;
        for k in 0..steps + MORE_STEPS {
            if k >= steps && past.is_none() {
                break;
            }
            let step = past.unwrap_or(along / square).clamp(-FOOT_STEP, FOOT_STEP);
            let before = along;
            tau -= step;
            (along, square, distance) = approach(tau);
            let is_past = along * before < 0.0 && along.abs() > CONTRACTION * before.abs();
            past = is_past.then(|| step * along / (before - along));
        }
        if distance <= first {
            (tau, distance)
        } else {
            (from, first)
        }
    }

    /// Moves each foot to the nearest place of the curve near it or, if crank angles are given, to the place at its
    /// angle, and measures the distances.
    pub(super) fn settle(&mut self, target: &Target, steps: usize) {
        let mut distances = std::mem::take(&mut self.distances);
        distances.clear();
        let start = self.x[9];
        for (k, wanted) in target.compared.iter().enumerate() {
            let (tau, distance) = match &target.angles {
                Some(angles) => {
                    let tau = start + self.sense * angles[k];
                    (tau, (self.point(tau) - wanted).norm())
                }
                None => self.foot(*wanted, self.feet[k], steps),
            };
            self.feet[k] = tau;
            distances.push(distance);
        }
        let known = std::mem::take(&mut self.both);
        if self.compares_both {
            let ends = part(self, target);
            let curve = if known.is_empty() {
                self.sampled(ends, SOUGHT)
            } else {
                Vec::new()
            };
            for (k, wanted) in target.corners().enumerate() {
                let from = known.get(k).map(|(tau, _)| *tau);
                let from = from.unwrap_or_else(|| nearest(&curve, wanted).0);
                let (tau, distance) = self.foot(wanted, from, steps);
                self.both.push((tau, wanted));
                distances.push(distance);
            }
            let [from, to] = ends;
            for share in &self.places {
                let tau = from + (to - from) * share;
                let place = self.point(tau);
                let nearest = target.path.nearest(place);
                self.both.push((tau, nearest));
                distances.push((place - nearest).norm());
            }
        }
        self.distances = distances;
    }
}

/// τ of the nearest of some places of a curve, and the square of its distance.
pub(in crate::synthesis::approximation) fn nearest(
    curve: &[(f64, Complex<f64>)],
    wanted: Complex<f64>,
) -> (f64, f64) {
    let mut found = (0.0, f64::INFINITY);
    for (tau, place) in curve {
        let square = (place - wanted).norm_sqr();
        if square < found.1 {
            found = (*tau, square);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::super::super::curve::Kind;
    use super::super::tests::start;
    use crate::Point;
    use crate::synthesis::approximation::{Course, Target};

    /// Feet on other strands of the curve itself return to their places when they are sought anew. Those that only follow
    /// their neighbourhood do not.
    #[test]
    fn feet_on_other_strands_are_found() {
        let mut fitted = start(Kind::FourBar, [1.1, 0.9, 1.3], false);
        let taus = (0..60).map(|k| TAU * f64::from(k) / 60.0);
        let points: Vec<Point> = taus
            .map(|tau| fitted.point(tau))
            .map(|place| Point::new(place.re, place.im))
            .collect();
        let target = Target::new(&points, Course::Closed, None).unwrap();
        let scale = 1.0 / target.size();
        let middle = target.scaled(Point::new(0.0, 0.0));
        for k in 0..2 {
            fitted.x[k] *= scale;
        }
        (fitted.x[2], fitted.x[3]) = (
            fitted.x[2] * scale + middle.re,
            fitted.x[3] * scale + middle.im,
        );
        let count = target.compared.len();
        let far = |k: usize| TAU * k as f64 / count as f64 + 2.5;
        fitted.feet = (0..count).map(far).collect();
        fitted.settle(&target, 3);
        assert!(fitted.greatest() > 0.1, "{}", fitted.greatest());
        fitted.seek_feet(&target);
        // The path is a polyline of 60 points.
        assert!(fitted.greatest() < 5e-3, "{}", fitted.greatest());
    }
}
