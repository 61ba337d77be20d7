//! A random linkage that moves, with poses of its motion to compare others with.

use assur::mechanism::{Defect, LinkageSpec, Mechanism};
use assur::motion::Motion;

use super::condition::Condition;
use super::equations::Equations;
use super::linkage::Linkage;
use super::redrawn::with_shapes;
use super::shown::Shown;
use crate::properties::random::Random;

/// So many poses of each motion are compared.
pub(crate) const POSES: usize = 12;
/// What rounding leaves of a pose that is well determined, relative to its size: a few hundred
/// operations of 1e-16 one after the other.
const ROUNDING: f64 = 2e-14;
/// To first order an error grows in a pose as its condition says while the second order does not
/// count: while the error times the square of the condition is less than this.
const FIRST_ORDER: f64 = 1e-3;

/// A pose of a motion with what it can be compared by.
pub(crate) struct Known {
    pub(crate) input: f64,
    pub(crate) shown: Shown,
    pub(crate) condition: Condition,
}

pub(crate) struct Subject {
    pub(crate) draft: LinkageSpec,
    pub(crate) motion: Motion,
    pub(crate) equations: Equations,
    pub(crate) poses: Vec<Known>,
}

/// Why a drawing makes no subject.
pub(crate) struct Refused {
    pub(crate) draft: LinkageSpec,
    pub(crate) defects: Vec<Defect>,
    /// Whether it is a pose in which everything is joined and well determined.
    pub(crate) sound: bool,
}

impl Subject {
    /// Of a seed with so many parts.
    ///
    /// # Errors
    /// Where that is no mechanism, as with guides that happen to be parallel.
    pub(crate) fn new(seed: u64, parts: usize) -> Result<Self, Box<Refused>> {
        let draft = with_shapes(&Linkage::new(seed, parts).draft);
        let refused = |draft: LinkageSpec, defects: Vec<Defect>| {
            let joined = |defect: &Defect| {
                matches!(
                    defect,
                    Defect::Open { .. }
                        | Defect::Singular { .. }
                        | Defect::CoincidentHinges { .. }
                        | Defect::DrawnBeyondRange { .. }
                        | Defect::Misdrawn { .. }
                )
            };
            let sound = defects.iter().any(joined) && {
                let equations = Equations::new(&draft);
                let condition = equations.condition(&equations.drawn());
                determined(condition, uncertainty(1.0, equations.shortest(), 1.0))
            };
            Box::new(Refused {
                draft,
                defects,
                sound,
            })
        };
        let mechanism = match Mechanism::new(&draft) {
            Ok(mechanism) => mechanism,
            Err(defects) => return Err(refused(draft, defects)),
        };
        let motion = Motion::new(mechanism);
        let equations = Equations::new(&draft);
        let mut random = Random::new(80_000_000 + seed);
        let [from, to] = motion.cycle().arcs()[0];
        let mut poses = vec![];
        for k in 0..4 * POSES {
            // Some close to an end.
            let part = match k % 6 {
                4 => 10.0_f64.powf(random.within(-5.0, -1.0)),
                5 => 1.0 - 10.0_f64.powf(random.within(-5.0, -1.0)),
                _ => random.within(0.0, 1.0),
            };
            let input = from + (to - from) * part;
            let Ok(pose) = motion.pose::<3>(input) else {
                continue;
            };
            let shown = Shown::of(motion.mechanism(), &pose);
            let condition = equations.condition(&shown);
            if determined(condition, ROUNDING) {
                poses.push(Known {
                    input,
                    shown,
                    condition,
                });
            }
            if poses.len() == POSES {
                break;
            }
        }
        if poses.len() < 2 {
            return Err(refused(draft, vec![]));
        }
        Ok(Self {
            draft,
            motion,
            equations,
            poses,
        })
    }
}

/// What is uncertain of each equation of a drawing, relative to its size: rounding of what is
/// computed, of coordinates `far` sizes from the origin, and of angles that are told by two points
/// so close together; and of a pose that reaches out.
pub(crate) fn uncertainty(far: f64, shortest: f64, reach: f64) -> f64 {
    (ROUNDING * reach + 4.0 * f64::EPSILON * far) / shortest
}

/// Whether an error of the equations has no more than its linear effect on a pose.
pub(crate) fn determined(condition: Condition, error: f64) -> bool {
    error * condition.pose * condition.pose < FIRST_ORDER
}
