//! A given linkage beside a path: the places of its motion nearest to the points of the path.

mod curve;

use super::approximation::{PathVerdict, Tracing, crank_angles};
use super::distance::Deviation;
use super::target::Target;
use crate::mechanism::{Mechanism, Pose};
use crate::motion::Motion;
use crate::tolerance;
use crate::{Point, Vector};
use curve::Curve;

/// Comparison of a given linkage with a path.
#[derive(Clone, Debug)]
pub struct Traced {
    /// Inputs of the motion at which the traced point is nearest to the points of the path or, with crank angles, at
    /// which the crank is at these angles. None for a point that is nearest to the curve of the other assembly, which
    /// the motion does not reach.
    pub inputs: Vec<Option<f64>>,
    /// Distances of the points of the path from the traced curve at these places, in the unit of the path.
    pub distances: Vec<f64>,
    /// Distances between path and curve.
    pub deviation: Deviation,
    /// Order, circuit, branch, Grashof type and transmission; None if two points are met in one position.
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

/// Maximum distance, in units of the size, at which a point counts as on a curve.
const MET: f64 = 1e-7;
/// Difference below which two distances count as equal, in units of the size, as where the curve crosses itself.
const EQUAL: f64 = tolerance::COINCIDENT;

impl Traced {
    /// A moving linkage beside a path. The motion must be that of [`Tracing::spec`].
    ///
    /// The motion of a four-bar stays in one assembly. If it ends at dead points, the curve of the other assembly
    /// belongs to the same circuit and is compared, too; otherwise only with points that lie on it and not on the
    /// traced curve. None if the motion has no pose, or if crank angles are given and the input is no crank that turns
    /// fully.
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

/// Vectors of crank and rocker at an input; for a slider-crank the guide's direction takes the place of the rocker.
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
mod tests;
