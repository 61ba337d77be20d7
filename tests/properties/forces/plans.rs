//! Force plans and the lever against the reactions.

use assur::Vector;
use assur::forces::{Cause, ForcePlan, Kinetostatics, Lever, Reactions, StepKind};
use assur::mechanism::{Mechanism, Pose};

use super::super::random::Random;

/// Greatest error of a plan and of the lever.
pub(super) struct Off {
    /// Gap of a polygon, or difference of a force from the reaction.
    pub(super) force: f64,
    /// Sum of moments, or difference of a moment or torque from the reaction.
    pub(super) moment: f64,
}

/// Sums of the equations of equilibrium of every body about a point of the linkage, with random unknowns reversed.
pub(super) fn equations(
    (mechanism, pose): (&Mechanism, &Pose<3>),
    forces: &Kinetostatics,
    found: &Reactions,
    seed: u64,
) -> Off {
    let mut random = Random::new(93_000_000 + seed);
    let mut off = Off {
        force: 0.0,
        moment: 0.0,
    };
    let points: Vec<_> = mechanism.point_ids().collect();
    for body in mechanism.bodies().skip(1) {
        let about = points[random.below(points.len())];
        let about = mechanism.place(pose, about).place();
        let reversed: Vec<usize> = (0..40).filter(|_| random.below(2) == 0).collect();
        let addends = forces.equilibrium(mechanism, found, body, about, &reversed);
        let sum = |k: usize| {
            let values = addends.iter().map(|one| one.factors[k] * one.size.unwrap());
            values.sum::<f64>().abs()
        };
        off.force = off.force.max(sum(0)).max(sum(1));
        off.moment = off.moment.max(sum(2));
        for one in &addends {
            let signs = one.factors.map(|factor| match factor {
                0.0 => 0.0,
                _ => factor.signum(),
            });
            let judged = one.judged(signs, one.factors[2].abs());
            let judged = judged.signs.into_iter().chain([judged.arm]);
            assert!(judged.flatten().all(|right| right), "seed {seed}: {one:?}");
        }
    }
    off
}

pub(super) fn plan(forces: &Kinetostatics, found: &Reactions, plan: &ForcePlan) -> Off {
    let mut off = Off {
        force: 0.0,
        moment: 0.0,
    };
    let is_polygon = |kind| matches!(kind, StepKind::Polygon | StepKind::Group);
    for step in &plan.steps {
        assert!(step.open.is_empty() && step.kind != StepKind::Indeterminate);
        let value: f64 = step.terms.iter().map(|term| term.value).sum();
        if is_polygon(step.kind) {
            let (Some(first), Some(last)) = (step.terms.first(), step.terms.last()) else {
                continue;
            };
            off.force = off.force.max((last.ends[1] - first.ends[0]).norm());
            for pair in step.terms.windows(2) {
                assert_eq!(pair[0].ends[1], pair[1].ends[0]);
            }
        } else if step.kind == StepKind::Along {
            off.force = off.force.max(value.abs());
        } else {
            off.moment = off.moment.max(value.abs());
        }
    }
    // The components found for a pair add up to its reaction.
    for (id, pair) in forces.pairs() {
        let expected = found.of(id);
        let (force, moment) = (expected.vector().unwrap(), expected.moment.unwrap());
        let mut sums: Vec<(Vector, f64)> = Vec::new();
        let mut constructed = None;
        for step in &plan.steps {
            let own = step.terms.iter().filter(|term| {
                let of = matches!(term.name.cause, Cause::Reaction { pair, .. } if pair == id);
                of && !term.known && pair.bodies.contains(&term.name.body)
            });
            let mut sum = None;
            for term in own {
                let sign = if term.name.body == pair.bodies[0] {
                    1.0
                } else {
                    -1.0
                };
                let all = sum.get_or_insert((Vector::zeros(), 0.0));
                all.0 += term.force * sign;
                all.1 += if term.is_couple {
                    term.value * sign
                } else {
                    0.0
                };
            }
            let Some(sum) = sum else { continue };
            if step.kind == StepKind::Group {
                sums.push(sum);
            } else {
                let all = constructed.get_or_insert((Vector::zeros(), 0.0));
                *all = (all.0 + sum.0, all.1 + sum.1);
            }
        }
        for (own, couple) in sums.into_iter().chain(constructed) {
            off.force = off.force.max((own - force).norm());
            // The couples of an idler on its two wheels are not opposite.
            if !pair.is_mesh() {
                off.moment = off.moment.max((couple - moment).abs());
            }
        }
    }
    off
}

/// Difference of the torque of the lever from that of the drive.
pub(super) fn lever(mechanism: &Mechanism, pose: &Pose<3>, found: &Reactions) -> Option<f64> {
    let lever = Lever::new(mechanism, pose, found);
    Some(lever.balancing? - found.first_drive()?)
}
