//! Properties of single poses.

use assur::{FourBar, Pose, Unsolved};
use assur_tests::{Rocker, scaled};
use proptest::prelude::*;

use super::draw::{config, lengths, posed};

/// How far the first two derivatives of l₁e₁ + l₂e₂ − l₃e₃ − l₄ are from zero,
/// relative to the longest link times the largest rate.
fn closure_rates(linkage: &FourBar, pose: &Pose<3>) -> [f64; 2] {
    let [l1, l2, l3, l4] = linkage.lengths();
    let terms = [(l1, pose.crank), (l2, pose.coupler), (-l3, pose.rocker)];
    let mut sums = [[0.0; 2]; 2];
    let mut sizes = [0.0_f64; 2];
    for (length, angle) in terms {
        let (sin, cos) = angle.value().sin_cos();
        let [first, second] = [angle.derivative(1), angle.derivative(2)];
        let square = first * first;
        let parts = [
            [-first * sin, first * cos],
            [-second * sin - square * cos, second * cos - square * sin],
        ];
        for ((sum, part), (size, rate)) in sums.iter_mut().zip(parts).zip(
            sizes
                .iter_mut()
                .zip([first.abs(), second.abs().max(square)]),
        ) {
            sum[0] += length * part[0];
            sum[1] += length * part[1];
            *size = size.max(rate);
        }
    }
    let longest = l1.max(l2).max(l3).max(l4);
    [0, 1].map(|i| sums[i][0].hypot(sums[i][1]) / (longest * sizes[i]))
}

/// (10), (11) and (13) of the mixer paper: derivatives from the angles alone,
/// with the sine that they divide by.
fn by_the_paper(linkage: &FourBar, pose: &Pose<3>) -> ([f64; 2], [f64; 2], f64) {
    let [l1, l2, l3, _] = linkage.lengths();
    let [p1, p2, p3] = [pose.crank, pose.coupler, pose.rocker].map(|angle| angle.value());
    let sine = (p3 - p2).sin();
    let v3 = l1 * (p1 - p2).sin() / (l3 * sine);
    let v2 = l1 * (p1 - p3).sin() / (l2 * sine);
    let a3 = (l1 * (p1 - p2).cos() + v2 * v2 * l2 - v3 * v3 * l3 * (p3 - p2).cos()) / (l3 * sine);
    let a2 = (l1 * (p1 - p3).cos() - v3 * v3 * l3 + v2 * v2 * l2 * (p2 - p3).cos()) / (l2 * sine);
    ([v2, v3], [a2, a3], sine)
}

proptest! {
    #![proptest_config(config(scaled(20_000)))]

    /// The loop closes to 1e-13 of the longest link, and so do its derivatives
    /// relative to the size of their terms; whatever is solved is finite.
    #[test]
    fn closes((linkage, assembly, crank) in posed()) {
        let longest = linkage.lengths().into_iter().fold(0.0, f64::max);
        let position = match linkage.pose::<1>(assembly, crank) {
            Ok(position) => position,
            Err(Unsolved::Undetermined { .. }) => {
                let [l1, l2, l3, l4] = linkage.lengths();
                prop_assert!((l1 - l4).abs() < 1e-14 * longest, "{linkage:?} {crank}");
                prop_assert!((l2 - l3).abs() < 1e-14 * longest, "{linkage:?} {crank}");
                return Ok(());
            }
            Err(other) => return Err(TestCaseError::fail(format!("{linkage:?}: {other}"))),
        };
        let [.., b, c, _] = linkage.joints(&position).map(|joint| joint.place());
        let [_, l2, l3, _] = linkage.lengths();
        let (sin, cos) = position.coupler.value().sin_cos();
        let gap = (b.x + l2 * cos - c.x).hypot(b.y + l2 * sin - c.y);
        prop_assert!(gap <= 1e-13 * longest, "{linkage:?} at {crank}: {gap:e}");

        match linkage.pose::<3>(assembly, crank) {
            Ok(pose) => {
                prop_assert!(pose.coupler.is_finite() && pose.rocker.is_finite());
                let [first, second] = closure_rates(&linkage, &pose);
                // φ₅ and the angles beside it turn fast against each other where the
                // diagonal is short: every derivative loses l/l₅ of its digits.
                let d = linkage.joints(&position)[3].place();
                let steep = longest / (d - b).norm();
                let bound = 1e-14 * steep.max(10.0);
                prop_assert!(first <= bound, "{linkage:?} at {crank}: {first:e}");
                let bound = 1e-13 * steep.powi(2).max(10.0);
                prop_assert!(second <= bound, "{linkage:?} at {crank}: {second:e}");
            }
            Err(Unsolved::DeadPoint { .. }) => {
                let transmission = linkage.transmission_angle(crank).unwrap();
                // The angle of a triangle that is flat within rounding.
                let flat = (2e-14 * longest * longest / (l2 * l3)).sqrt();
                prop_assert!(transmission < flat, "{linkage:?} at {crank}: {transmission}");
            }
            Err(other) => return Err(TestCaseError::fail(format!("{linkage:?}: {other}"))),
        }
    }

    /// Derivatives agree with the paper's formulas as far as those, dividing by a
    /// sine, can be trusted.
    #[test]
    fn derivatives_agree_with_the_paper((linkage, assembly, crank) in posed()) {
        let Ok(pose) = linkage.pose::<3>(assembly, crank) else { return Ok(()) };
        let (first, second, sine) = by_the_paper(&linkage, &pose);
        if sine.abs() < 1e-14 {
            return Ok(()); // 0/0 at a change point: `closes` and `smooth` hold there
        }
        let [l1, l2, l3, l4] = linkage.lengths();
        let longest = l1.max(l2).max(l3).max(l4);
        // The angles are known to ε over the sine, and the formulas divide by it
        // once more for each derivative.
        let steep = longest / (l2.min(l3) * sine.abs());
        let rounding = 1e-14 * steep / sine.abs();
        let size = 1.0 + first[0].abs().max(first[1].abs());
        for (index, angle) in [pose.coupler, pose.rocker].into_iter().enumerate() {
            let off = (angle.derivative(1) - first[index]).abs();
            prop_assert!(off <= rounding * size, "{linkage:?} at {crank}: φ′ {off:e}");
            let off = (angle.derivative(2) - second[index]).abs();
            let bound = 10.0 * rounding * size * size * steep;
            prop_assert!(off <= bound, "{linkage:?} at {crank}: φ″ {off:e} > {bound:e}");
        }
    }

    /// Any numbers at all: an answer or a reason, never a panic, never NaN.
    #[test]
    fn any_numbers(
        lengths in any::<[f64; 4]>(),
        sound in lengths(),
        crank in prop_oneof![any::<f64>(), -20.0..20.0_f64],
    ) {
        for lengths in [lengths, sound] {
            match FourBar::new(lengths) {
                Err(reasons) => prop_assert!(!reasons.is_empty()),
                Ok(linkage) => check_everything(&linkage, crank)?,
            }
        }
    }
}

fn check_everything(linkage: &FourBar, crank: f64) -> Result<(), TestCaseError> {
    let cycle = linkage.cycle();
    prop_assert!(!cycle.arcs().is_empty());
    prop_assert!(
        cycle.arcs().iter().all(|[from, to]| from < to),
        "{linkage:?}"
    );
    let (worst, at) = linkage.worst_transmission();
    prop_assert!(worst.is_finite() && at.is_finite());
    for assembly in assur::Assembly::ALL {
        if let Ok(pose) = linkage.pose::<5>(assembly, crank) {
            prop_assert!(pose.coupler.is_finite() && pose.rocker.is_finite());
        }
        match linkage.pose::<1>(assembly, crank) {
            Ok(_) => prop_assert!(linkage.transmission_angle(crank).is_ok()),
            Err(Unsolved::NotAnAngle) => prop_assert!(!crank.is_finite()),
            Err(Unsolved::Apart { by, .. } | Unsolved::Inside { by, .. }) => {
                prop_assert!(by > 0.0 && by.is_finite(), "{linkage:?} at {crank}: {by}");
                prop_assert!(!cycle.is_full());
            }
            Err(Unsolved::Undetermined { .. } | Unsolved::DeadPoint { .. }) => {}
        }
        for stroke in linkage
            .swings(assembly)
            .into_iter()
            .filter_map(|swing| swing.stroke())
        {
            prop_assert!(stroke.is_finite() && stroke >= 0.0, "{linkage:?}: {stroke}");
        }
        for limit in linkage.limits(assembly) {
            prop_assert!(limit.crank.is_finite() && limit.rocker.is_finite());
        }
        let (advanced, _) = cycle.advance(crank, 0.3);
        prop_assert!(advanced.is_finite(), "{advanced}");
    }
    Ok(())
}
