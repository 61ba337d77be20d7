//! A given linkage beside a path: the places of its motion nearest to the points of the path.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::approximation::{PathVerdict, Tracing, crank_angles};
use super::distance::Deviation;
use super::target::{Course, Target};
use crate::angle::nearest_to;
use crate::mechanism::{Mechanism, PointId, Pose};
use crate::motion::{Motion, Sampling, Shown, Spacing};
use crate::sorting::extremes;
use crate::tolerance;
use crate::{Point, Vector};

/// How a linkage traces a path.
#[derive(Clone, Debug)]
pub struct Traced {
    /// Inputs of the motion at which the traced point is nearest to the points of the path or, with crank angles, at
    /// which the crank is at these angles. None for a point that is nearest to the curve of the other assembly, which the
    /// motion does not reach.
    pub inputs: Vec<Option<f64>>,
    /// Distances of the points of the path from the traced curve at these places, in the unit of the path.
    pub distances: Vec<f64>,
    /// Distances between path and curve.
    pub deviation: Deviation,
    /// Order, circuit, branch, Grashof type and transmission; None if the points are met at equal angles.
    pub verdict: Option<PathVerdict>,
}

/// The nearest place to a point of the path.
#[derive(Clone, Copy, Debug)]
struct Foot {
    /// True if the place belongs to the other assembly.
    is_other: bool,
    input: f64,
    distance: f64,
}

/// Samples of a turn of the crank as the angle at the first point, and steps from the best one.
const STARTS: usize = 120;
const START_STEPS: usize = 30;
/// Samples of a turn of the motion.
const SAMPLES: usize = 360;
/// Maximum number of samples of a motion.
const MOST: usize = 1440;
/// Steps from a sample to a foot.
const STEPS: usize = 8;
/// A step, as a part of the distance of two samples, at which a foot is found.
const SETTLED: f64 = 1e-9;
/// Sections of the golden section: they reach the digits of the input.
const SECTIONS: usize = 70;
const GOLDEN: f64 = 1.618_033_988_749_895;
/// Distance, in units of the size, up to which a point is on a curve.
const MET: f64 = 1e-7;
/// Distances that differ by less, in units of the size, are equal: the curve meets itself there.
const EQUAL: f64 = tolerance::COINCIDENT;

impl Traced {
    /// A moving linkage beside a path. The motion must be that of [`Tracing::spec`].
    ///
    /// The motion of a four-bar stays in one assembly. If it ends at dead points, the curve of the other assembly belongs
    /// to the same circuit and counts; else it counts only for points that lie on it and not on the traced curve. None if
    /// the motion has no place, or if crank angles are given and the crank does not drive it through a full turn.
    pub fn new(linkage: &Tracing, motion: &Motion, target: &Target) -> Option<Self> {
        let shown = Curve::new(motion, target)?;
        let reflected = match linkage {
            Tracing::FourBar(linkage) if target.turns.is_none() => linkage.reflected(),
            _ => None,
        };
        let reflected = reflected.map(Tracing::FourBar);
        let other = reflected.and_then(|linkage| Mechanism::new(&linkage.spec()).ok());
        let other = other.map(Motion::new);
        let other = other.as_ref().and_then(|motion| Curve::new(motion, target));
        let feet = match &target.turns {
            Some(turns) => shown.timed(linkage, turns)?,
            None => shown.feet()?,
        };
        let is_joined = !motion.cycle().is_full();
        let beside = other.as_ref().and_then(Curve::feet).unwrap_or_default();
        let feet = feet.into_iter().enumerate().map(|(k, (input, distance))| {
            let shown = Foot {
                is_other: false,
                input,
                distance,
            };
            let nearer = beside.get(k).filter(|(_, off)| {
                let is_met = *off <= MET && distance > MET;
                is_met || (is_joined && off + EQUAL < distance)
            });
            nearer.map_or(shown, |(input, distance)| Foot {
                is_other: true,
                input: *input,
                distance: *distance,
            })
        });
        let feet: Vec<Foot> = feet.collect();
        let mut places = Vec::new();
        for (curve, is_other) in [(Some(&shown), false), (other.as_ref(), true)] {
            if let Some(curve) = curve.filter(|_| is_joined || !is_other) {
                let feet = feet.iter().filter(|foot| foot.is_other == is_other);
                let inputs: Vec<f64> = feet.map(|foot| foot.input).collect();
                places.extend(curve.between(&inputs, target.course()));
            }
        }
        let distances: Vec<f64> = feet.iter().map(|foot| foot.distance).collect();
        let deviation = Deviation::both_ways(distances.clone(), &places, target);
        let bars = feet.iter().map(|foot| {
            let curve = if foot.is_other {
                other.as_ref()?
            } else {
                &shown
            };
            bars(linkage, curve.motion, foot.input)
        });
        let bars: Option<Vec<[Vector; 2]>> = bars.collect();
        let verdict = bars.and_then(|bars| {
            let angles = crank_angles(&bars);
            PathVerdict::new(linkage, &bars, &angles)
        });
        let shown = |foot: &Foot| (!foot.is_other).then_some(foot.input);
        Some(Self {
            inputs: feet.iter().map(shown).collect(),
            distances: (distances.iter()).map(|off| off * target.size()).collect(),
            deviation: deviation.times(target.size()),
            verdict,
        })
    }
}

/// The traced curve at samples of the motion, in units of the path's size.
struct Curve<'a> {
    motion: &'a Motion,
    point: PointId,
    target: &'a Target,
    pieces: Vec<Vec<(f64, Complex<f64>)>>,
}

impl<'a> Curve<'a> {
    fn new(motion: &'a Motion, target: &'a Target) -> Option<Self> {
        let point = motion.mechanism().point("P")?;
        let sampling = Sampling {
            turn: SAMPLES,
            coarsest: SAMPLES,
            most: MOST,
            spacing: Spacing::Crowded,
            shown: Shown::First,
        };
        let mut curve = Self {
            motion,
            point,
            target,
            pieces: Vec::new(),
        };
        let pieces = motion.samples(sampling).into_iter();
        let pieces = pieces.map(|inputs| {
            let places = inputs.into_iter();
            let places = places.filter_map(|input| Some((input, curve.place(input)?)));
            places.collect::<Vec<_>>()
        });
        curve.pieces = pieces.filter(|piece| piece.len() > 2).collect();
        (!curve.pieces.is_empty()).then_some(curve)
    }

    fn place(&self, input: f64) -> Option<Complex<f64>> {
        let pose: Pose<1> = self.motion.pose(input).ok()?;
        let at = self.motion.mechanism().place(&pose, self.point).place();
        Some(self.target.scaled(at))
    }

    /// The nearest places to the points of the path: inputs and distances.
    fn feet(&self) -> Option<Vec<(f64, f64)>> {
        let mut feet: Vec<(f64, f64)> = Vec::new();
        for wanted in self.target.points() {
            let near = feet.last().map(|foot| foot.0);
            feet.push(self.foot(self.target.scaled(*wanted), near)?);
        }
        Some(feet)
    }

    /// The places at given turns of the crank from the first point, in the sense and from the angle for which the sum of
    /// the squared distances is least.
    fn timed(&self, linkage: &Tracing, turns: &[f64]) -> Option<Vec<(f64, f64)>> {
        let [start, end] = self.motion.cycle().axis();
        let angle = |input: f64| bars(linkage, self.motion, input).map(|[crank, _]| crank);
        let (from, to) = (angle(start)?, angle(start + 1.0)?);
        let is_crank = (from.perp(&to).atan2(from.dot(&to)) - 1.0).abs() <= SETTLED;
        if !(self.motion.cycle().is_full() && is_crank) {
            return None;
        }
        let input = |from: f64, sense: f64, turn: f64| {
            start + (from + sense * turn - start).rem_euclid(end - start)
        };
        let points: Vec<Complex<f64>> = (self.target.points().iter())
            .map(|at| self.target.scaled(*at))
            .collect();
        let sum = |from: f64, sense: f64| {
            let squares = turns.iter().zip(&points).map(|(turn, wanted)| {
                let place = self.place(input(from, sense, *turn));
                place.map_or(f64::INFINITY, |place| (place - wanted).norm_sqr())
            });
            squares.sum::<f64>()
        };
        let froms = (0..STARTS).map(|k| start + TAU * k as f64 / STARTS as f64);
        let starts = froms.flat_map(|from| [1.0, -1.0].map(|sense| (from, sense)));
        let sums = starts.map(|(from, sense)| (sum(from, sense), from, sense));
        let (mut least, mut from, sense) = sums.min_by(|a, b| a.0.total_cmp(&b.0))?;
        for _ in 0..START_STEPS {
            let (mut slope, mut square) = (0.0, 0.0);
            for (turn, wanted) in turns.iter().zip(&points) {
                let pose = self.motion.pose::<2>(input(from, sense, *turn)).ok()?;
                let here = self.motion.mechanism().place(&pose, self.point);
                let tangent = here.derivative(1) / self.target.size();
                let off = self.target.scaled(here.place()) - wanted;
                slope += off.re * tangent.x + off.im * tangent.y;
                square += tangent.norm_squared();
            }
            let next = from - slope / square;
            let there = sum(next, sense);
            if there.is_nan() || there >= least {
                break;
            }
            (from, least) = (next, there);
        }
        let places = turns.iter().zip(&points).map(|(turn, wanted)| {
            let input = input(from, sense, *turn);
            Some((input, (self.place(input)? - wanted).norm()))
        });
        places.collect()
    }

    /// The input at which the curve is nearest to a place, and the distance. Of equally near places of points of a
    /// path it is the one nearest to the input before.
    fn foot(&self, wanted: Complex<f64>, near: Option<f64>) -> Option<(f64, f64)> {
        let mut feet: Vec<(f64, f64)> = Vec::new();
        let mut least = f64::INFINITY;
        for piece in &self.pieces {
            let off = |k: usize| (piece[k].1 - wanted).norm();
            let last = piece.len() - 1;
            for k in 0..=last {
                let here = off(k);
                let is_least = (k == 0 || here <= off(k - 1)) && (k == last || here <= off(k + 1));
                // Farther minima are no candidates unless the curve passes between two samples.
                let side = (piece[k.min(last - 1) + 1].1 - piece[k.min(last - 1)].1).norm();
                if is_least && here <= least + 2.0 * side {
                    least = least.min(here);
                    feet.push(self.refined(wanted, piece, k));
                }
            }
        }
        let least = feet.iter().map(|foot| foot.1).fold(f64::INFINITY, f64::min);
        feet.retain(|foot| foot.1 <= least + EQUAL);
        let period = self.motion.cycle().period();
        let far = |input: f64| match (near, period) {
            (Some(near), Some(_)) => (nearest_to(input, near) - near).abs(),
            (Some(near), None) => (input - near).abs(),
            (None, _) => 0.0,
        };
        feet.into_iter()
            .min_by(|a, b| far(a.0).total_cmp(&far(b.0)))
    }

    /// The foot near a sample, between its neighbours.
    fn refined(&self, wanted: Complex<f64>, piece: &[(f64, Complex<f64>)], k: usize) -> (f64, f64) {
        let low = piece[k.saturating_sub(1)].0;
        let high = piece[(k + 1).min(piece.len() - 1)].0;
        let mut best = (piece[k].0, (piece[k].1 - wanted).norm());
        for _ in 0..STEPS {
            let Ok(pose) = self.motion.pose::<2>(best.0) else {
                break;
            };
            let here = self.motion.mechanism().place(&pose, self.point);
            let tangent: Vector = here.derivative(1) / self.target.size();
            let off = self.target.scaled(here.place()) - wanted;
            let step = (off.re * tangent.x + off.im * tangent.y) / tangent.norm_squared();
            let next = (best.0 - step).clamp(low, high);
            let is_settled = (next - best.0).abs() <= SETTLED * (high - low);
            let Some(place) = step.is_finite().then(|| self.place(next)).flatten() else {
                break;
            };
            let distance = (place - wanted).norm();
            let is_nearer = distance < best.1;
            if is_nearer {
                best = (next, distance);
            }
            if is_settled {
                return best;
            }
            if !is_nearer {
                break;
            }
        }
        self.by_golden_section(wanted, [low, high], best)
    }

    /// The foot by the golden section. Next to a dead point the point moves too quickly for the steps.
    fn by_golden_section(
        &self,
        wanted: Complex<f64>,
        [mut low, mut high]: [f64; 2],
        mut best: (f64, f64),
    ) -> (f64, f64) {
        let off = |input: f64| {
            let place = self.place(input);
            place.map_or(f64::INFINITY, |place| (place - wanted).norm())
        };
        let inner = |low: f64, high: f64| {
            let part = (high - low) / GOLDEN;
            [high - part, low + part]
        };
        let mut ends = inner(low, high);
        let mut offs = ends.map(off);
        for _ in 0..SECTIONS {
            for (input, distance) in ends.into_iter().zip(offs) {
                if distance < best.1 {
                    best = (input, distance);
                }
            }
            let left = offs[0] < offs[1];
            [low, high] = if left {
                [low, ends[1]]
            } else {
                [ends[0], high]
            };
            let next = inner(low, high);
            (ends, offs) = if left {
                ([next[0], ends[0]], [off(next[0]), offs[0]])
            } else {
                ([ends[1], next[1]], [offs[1], off(next[1])])
            };
        }
        best
    }

    /// Places of the curve along the part of the motion from the first foot to the last.
    fn between(&self, inputs: &[f64], course: Course) -> Vec<Complex<f64>> {
        if inputs.is_empty() && course != Course::Closed {
            return Vec::new();
        }
        let all = || self.pieces.iter().flatten();
        let part = match self.motion.cycle().period() {
            _ if course == Course::Closed => None,
            Some(period) => {
                let mut unwrapped: Vec<f64> = Vec::new();
                for input in inputs {
                    let near = unwrapped.last().copied().unwrap_or(*input);
                    unwrapped.push(nearest_to(*input, near));
                }
                let [from, to] = extremes(unwrapped.into_iter());
                (to - from < period).then_some((from, to, period))
            }
            None => {
                let [from, to] = extremes(inputs.iter().copied());
                Some((from, to, f64::INFINITY))
            }
        };
        let Some((from, to, period)) = part else {
            return all().map(|(_, place)| *place).collect();
        };
        let turned = |input: f64| {
            if period.is_finite() {
                from + (input - from).rem_euclid(period)
            } else {
                input
            }
        };
        let within = |input: f64| (from..=to).contains(&turned(input));
        let places = all().filter(|(input, _)| within(*input));
        places.map(|(_, place)| *place).collect()
    }
}

/// Crank and rocker at an input; the rocker of a slider-crank is the direction of its guide.
fn bars(linkage: &Tracing, motion: &Motion, input: f64) -> Option<[Vector; 2]> {
    let pose: Pose<1> = motion.pose(input).ok()?;
    let mechanism = motion.mechanism();
    let place = |name: &str| -> Option<Point> {
        let point = mechanism.point(name)?;
        Some(mechanism.place(&pose, point).place())
    };
    let crank = place("B")? - place("A")?;
    let other = match linkage {
        Tracing::FourBar(_) => place("C")? - place("D")?,
        Tracing::SliderCrank(linkage) => linkage.guide(),
    };
    Some([crank, other])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::cognates::CouplerFourBar;

    /// Crank 2, coupler 5, rocker 4, frame 5, with P at a distance from the coupler.
    fn four_bar() -> (Tracing, Motion) {
        let at = |x: f64, y: f64| Point::new(x, y);
        let b = at(0.0, 2.0);
        let c = {
            // C is 5 from B and 4 from D.
            let d = at(5.0, 0.0);
            let (arm, span) = (d - b, (d - b).norm());
            let along = (25.0 - 16.0 + span * span) / (2.0 * span);
            let across = (25.0 - along * along).sqrt();
            let unit = arm / span;
            b + unit * along + Vector::new(-unit.y, unit.x) * across
        };
        let linkage = CouplerFourBar::new([at(0.0, 0.0), at(5.0, 0.0)], [b, c], at(1.0, 5.0));
        let linkage = Tracing::FourBar(linkage.unwrap());
        let motion = Motion::new(Mechanism::new(&linkage.spec()).unwrap());
        (linkage, motion)
    }

    fn place(motion: &Motion, input: f64) -> Point {
        let mechanism = motion.mechanism();
        let pose = motion.pose::<1>(input).unwrap();
        mechanism
            .place(&pose, mechanism.point("P").unwrap())
            .place()
    }

    #[test]
    fn feet_of_points_on_the_curve_are_their_inputs() {
        let (linkage, motion) = four_bar();
        let wanted = [0.1, 0.9, 1.7, 2.2, 3.3, 4.4, 5.5];
        let points = wanted.map(|input| place(&motion, input));
        let target = Target::new(&points, Course::Points, None).unwrap();
        let traced = Traced::new(&linkage, &motion, &target).unwrap();
        for (input, expected) in traced.inputs.iter().zip(wanted) {
            let input = input.unwrap();
            let off = nearest_to(input, expected) - expected;
            assert!(off.abs() < 1e-7, "{input}, not {expected}");
        }
        assert!(traced.deviation.greatest < 1e-12, "{:?}", traced.deviation);
        let Some(PathVerdict::FourBar(verdict)) = traced.verdict else {
            panic!("{:?}", traced.verdict);
        };
        assert_eq!(verdict.order, crate::synthesis::four_bar::Order::Growing);
    }

    /// Points of both assemblies: of a crank-rocker on two circuits, of a triple rocker on two branches of one. The motion
    /// reaches those of one assembly, and the verdict names the defect.
    #[test]
    fn points_of_the_other_assembly_are_not_reached() {
        use crate::synthesis::four_bar::Passage;
        let at = |x: f64, y: f64| Point::new(x, y);
        let place_c = |b: Point, d: Point, [coupler, rocker]: [f64; 2]| {
            let (arm, span) = (d - b, (d - b).norm());
            let along = (coupler.powi(2) - rocker.powi(2) + span * span) / (2.0 * span);
            let unit = arm / span;
            let across = (coupler.powi(2) - along * along).sqrt();
            b + unit * along + Vector::new(-unit.y, unit.x) * across
        };
        let cases = [
            ([0.0, 2.0], [5.0, 4.0], Passage::OtherCircuit),
            ([0.0, 4.0], [3.0, 3.5], Passage::AcrossDeadPoint),
        ];
        for ([x, y], lengths, expected) in cases {
            let (a, d, b) = (at(0.0, 0.0), at(5.0, 0.0), at(x, y));
            let c = place_c(b, d, lengths);
            let point = b + 0.5 * (c - b) + Vector::new(0.3, 1.0);
            let linkage = CouplerFourBar::new([a, d], [b, c], point).unwrap();
            let reflected = linkage.reflected().unwrap();
            let motion =
                |linkage: &CouplerFourBar| Motion::new(Mechanism::new(&linkage.spec()).unwrap());
            let (shown, other) = (motion(&linkage), motion(&reflected));
            let [from, to] = shown.cycle().arcs()[0];
            let input = |share: f64| from + share * (to - from);
            let of = |motion: &Motion, share: f64| place(motion, input(share));
            let points = [
                of(&shown, 0.3),
                of(&shown, 0.45),
                of(&other, 0.5),
                of(&shown, 0.6),
            ];
            let target = Target::new(&points, Course::Points, None).unwrap();
            let traced = Traced::new(&Tracing::FourBar(linkage), &shown, &target).unwrap();
            let reached: Vec<bool> = traced.inputs.iter().map(Option::is_some).collect();
            assert_eq!(reached, [true, true, false, true], "{expected:?}");
            assert!(traced.deviation.greatest < 1e-9, "{:?}", traced.deviation);
            let Some(PathVerdict::FourBar(verdict)) = traced.verdict else {
                panic!("{:?}", traced.verdict);
            };
            assert_eq!(verdict.passage, expected);
        }
    }

    /// Points at given turns of the crank, forwards and backwards, from an angle that is not given.
    #[test]
    fn crank_angles_are_met_in_either_sense() {
        let (linkage, motion) = four_bar();
        let turns = [0.0, 0.4, 1.1, 1.9, 3.0];
        for sense in [1.0, -1.0] {
            let points = turns.map(|turn| place(&motion, 1.3 + sense * turn));
            let target = Target::new(&points, Course::Points, Some(&turns)).unwrap();
            let traced = Traced::new(&linkage, &motion, &target).unwrap();
            assert!(traced.deviation.greatest < 1e-11, "{:?}", traced.deviation);
            let [first, second] = [0, 1].map(|k| traced.inputs[k].unwrap());
            let step = nearest_to(second - first, 0.0);
            assert!((step - sense * 0.4).abs() < 1e-9, "{step}");
            // Other turns are not met, though the points are on the curve.
            let others = turns.map(|turn| 1.1 * turn);
            let target = Target::new(&points, Course::Points, Some(&others)).unwrap();
            let traced = Traced::new(&linkage, &motion, &target).unwrap();
            assert!(traced.deviation.greatest > 1e-3, "{:?}", traced.deviation);
        }
    }

    /// A closed polyline of the curve itself, and the same moved by a tenth.
    #[test]
    fn a_drawn_curve_is_compared_both_ways() {
        let (linkage, motion) = four_bar();
        let along = |k: usize| place(&motion, f64::from(k as u32) * std::f64::consts::TAU / 200.0);
        for moved in [0.0, 0.1] {
            let points: Vec<Point> = (0..200)
                .map(|k| along(k) + Vector::new(moved, 0.0))
                .collect();
            let target = Target::new(&points, Course::Closed, None).unwrap();
            let traced = Traced::new(&linkage, &motion, &target).unwrap();
            let off = traced.deviation.greatest - moved;
            assert!(off.abs() < 2e-3, "{moved}: {:?}", traced.deviation);
        }
    }

    /// Half of the curve: the other half does not count.
    #[test]
    fn only_the_traced_part_counts() {
        let (linkage, motion) = four_bar();
        let points: Vec<Point> = (0..100)
            .map(|k| place(&motion, 5.0 + 0.03 * f64::from(k)))
            .collect();
        let target = Target::new(&points, Course::Open, None).unwrap();
        let traced = Traced::new(&linkage, &motion, &target).unwrap();
        assert!(traced.deviation.greatest < 2e-3, "{:?}", traced.deviation);
    }
}
