//! Properties of whole motions.

use std::f64::consts::{PI, TAU};

use assur::mechanism::Quantity;
use assur::motion::{Extremum, InputRate, features};
use assur::{Assembly, FourBar, Grashof, Swing};
use assur_tests::{Rocker, scaled};
use proptest::prelude::*;

use super::draw::{config, linkage};
use super::mixers::mixer;

/// The largest jump of `f` (value and rate) that does not shrink with the step:
/// bisects every step over which the value moves by more than `coarse` down to
/// neighbouring numbers, and takes off what the rate explains there.
fn jump(f: &dyn Fn(f64) -> Option<[f64; 2]>, from: f64, to: f64, coarse: f64) -> f64 {
    let (Some(a), Some(b)) = (f(from), f(to)) else {
        return 0.0;
    };
    let moved = (b[0] - a[0]).abs();
    if moved <= coarse {
        return 0.0;
    }
    let middle = 0.5 * (from + to);
    if middle <= from || middle >= to {
        return moved - 2.0 * (to - from) * a[1].abs().max(b[1].abs());
    }
    if f(middle).is_none() {
        return moved;
    }
    jump(f, from, middle, coarse).max(jump(f, middle, to, coarse))
}

/// The extrema of the first and the second derivative of the rocker's angle.
fn extrema(linkage: &FourBar, assembly: Assembly) -> [Vec<Extremum>; 2] {
    let motion = mixer(linkage, assembly).motion().unwrap();
    let rocker = Quantity::named(motion.mechanism(), "rocker.angle").unwrap();
    let [_, first, second] = motion
        .features(&[rocker], InputRate::ANALOGUES)
        .unwrap()
        .swap_remove(0);
    [first, second].map(|order| order.extrema)
}

proptest! {
    #![proptest_config(config(scaled(400)))]

    /// No silent change of branch: both angles are continuous over every arc, over
    /// both turns where a cycle takes two, and from its end to its start.
    #[test]
    fn continuous((linkage, assembly) in linkage()) {
        let cycle = linkage.cycle();
        for angle in [0, 1] {
            let at = |crank: f64| {
                let pose = linkage.pose::<1>(assembly, crank).ok()?;
                // At a dead point the rate is unbounded.
                let rate = linkage.pose::<2>(assembly, crank).map_or(f64::INFINITY, |pose| {
                    [pose.coupler, pose.rocker][angle].derivative(1)
                });
                Some([[pose.coupler, pose.rocker][angle].value(), rate])
            };
            for [from, to] in cycle.arcs() {
                // Around 0, where numbers lie closest; over the seam of a full cycle.
                let width = if cycle.is_full() { to - from + 1.0 } else { to - from };
                let from = if cycle.is_full() { from - 0.5 * width } else { *from };
                for step in 0..200 {
                    let a = from + width * f64::from(step) / 200.0;
                    let b = from + width * f64::from(step + 1) / 200.0;
                    let off = jump(&at, a, b.min(from + width), 0.4);
                    prop_assert!(off <= 0.0, "{linkage:?} {assembly:?} {a}..{b}: {off}");
                }
            }
            if cycle.is_full() {
                // A cycle later the pose is the same one.
                let [start, end] = cycle.axis();
                let (Some(a), Some(b)) = (at(start + 0.7), at(end + 0.7)) else { continue };
                let turns = (b[0] - a[0]) / TAU;
                prop_assert!((turns - turns.round()).abs() < 1e-9, "{linkage:?}: {turns} turns");
            }
        }
    }

    /// The rocker's speed is continuous too where it is bounded: through a change
    /// point the motion keeps to its smooth branch.
    #[test]
    fn smooth((linkage, assembly) in linkage()) {
        let cycle = linkage.cycle();
        if !cycle.is_full() {
            return Ok(());
        }
        let rate = |crank: f64| {
            let pose = linkage.pose::<3>(assembly, crank).ok()?;
            let [rate, bend] = [1, 2].map(|order| pose.rocker.derivative(order));
            Some([rate.atan(), bend / (1.0 + rate * rate)])
        };
        let [start, end] = cycle.axis();
        for step in 0..400 {
            let [a, b] = [step - 200, step - 199].map(|i| (end - start) * f64::from(i) / 400.0);
            let off = jump(&rate, a, b, 0.4);
            prop_assert!(off <= 0.0, "{linkage:?} {assembly:?} {a}..{b}: {off}");
        }
    }

    /// The loop can be closed on the arcs and nowhere else.
    #[test]
    fn arcs_are_where_it_closes((linkage, assembly) in linkage(), crank in -PI..TAU) {
        let cycle = linkage.cycle();
        let wrapped = cycle.wrap(crank);
        let ends = linkage.dead_points();
        prop_assume!(ends.iter().all(|end| (end - wrapped).abs() > 1e-6));
        match linkage.pose::<1>(assembly, crank) {
            Ok(_) => prop_assert!(cycle.contains(crank), "{linkage:?} at {crank}"),
            Err(assur::Unsolved::Undetermined { .. }) => {}
            Err(reason) => prop_assert!(!cycle.contains(crank), "{linkage:?}: {reason}"),
        }
    }

    /// Every class of Grashof moves as its name says.
    #[test]
    fn classes_move_as_named((linkage, assembly) in linkage()) {
        let (full, turns) = (linkage.cycle().is_full(), linkage.swings(assembly) == [Swing::Turns]);
        match linkage.grashof() {
            Grashof::CrankRocker => prop_assert!(full && !turns, "{linkage:?}"),
            Grashof::DoubleCrank => prop_assert!(full && turns, "{linkage:?}"),
            Grashof::RockerCrank | Grashof::DoubleRocker | Grashof::TripleRocker => {
                prop_assert!(!full && !turns, "{linkage:?}");
            }
            Grashof::ChangePoint => {}
        }
        let change = linkage.grashof() == Grashof::ChangePoint;
        prop_assert!(change || linkage.change_points().is_empty(), "{linkage:?}");
    }

    /// The swing is what a fine sweep finds, its limits are places of rest.
    #[test]
    fn swing_is_the_sweeps((linkage, assembly) in linkage()) {
        // Dead points are known as well as a crank angle can be told from the next.
        let rocker = |crank| linkage.pose::<1>(assembly, crank).map(|pose| pose.rocker.value());
        let blur = |end: &f64| {
            let [a, b] = [-2e-15, 2e-15].map(|off| rocker(end + off));
            let at = rocker(*end).unwrap();
            (a.unwrap_or(at) - at).abs().max((b.unwrap_or(at) - at).abs())
        };
        let slack = linkage.dead_points().iter().map(blur).fold(1e-7, f64::max);
        let cycle = linkage.cycle();
        let swings = linkage.swings(assembly);
        prop_assert_eq!(swings.len(), cycle.arcs().len());
        for ([from, to], swing) in cycle.arcs().iter().zip(swings) {
            let Swing::Between { min, max } = swing else { continue };
            let mut seen = [f64::INFINITY, f64::NEG_INFINITY];
            for step in 0..=2000 {
                if let Ok(angle) = rocker(from + (to - from) * f64::from(step) / 2000.0) {
                    seen = [seen[0].min(angle), seen[1].max(angle)];
                }
            }
            // Never less than a sweep finds.
            prop_assert!(min <= seen[0] + slack && max >= seen[1] - slack, "{linkage:?} {seen:?}");
            for limit in linkage.limits(assembly) {
                let here = (*from..=*to).contains(&limit.crank);
                prop_assert!(!here || (min..=max).contains(&limit.rocker), "{linkage:?}");
            }
        }
        for limit in linkage.limits(assembly) {
            if let Ok(pose) = linkage.pose::<3>(assembly, limit.crank) {
                let [rate, bend] = [1, 2].map(|order| pose.rocker.derivative(order));
                let [_, b, _, d] = linkage.joints(&pose).map(|joint| joint.place());
                let longest = linkage.lengths().into_iter().fold(0.0, f64::max);
                // Digits go where the diagonal or the rocker is short, as in poses.rs.
                let shortest = (d - b).norm().min(linkage.lengths()[2]);
                let lost = 1e-15 * longest / shortest;
                let bound = 1e-11 * (1.0 + bend.abs()) + lost;
                prop_assert!(rate.abs() < bound, "{linkage:?} {rate:e}");
            }
        }
    }

    /// The rocker's travel is what a fine sweep adds up to.
    #[test]
    fn travel_is_the_sweeps((linkage, assembly) in linkage()) {
        let rocker = |crank| linkage.pose::<1>(assembly, crank).map(|pose| pose.rocker.value());
        let cycle = linkage.cycle();
        let travels = linkage.travels(assembly);
        prop_assert_eq!(travels.len(), cycle.arcs().len());
        for (([from, to], swing), travel) in
            cycle.arcs().iter().zip(linkage.swings(assembly)).zip(travels)
        {
            let mut seen = 0.0;
            let mut last = None;
            for step in 0..=2000 {
                let Ok(angle) = rocker(from + (to - from) * f64::from(step) / 2000.0) else { continue };
                seen += last.map_or(0.0, |last: f64| (angle - last).abs());
                last = Some(angle);
            }
            let ways = if cycle.is_full() { 1.0 } else { 2.0 };
            // A sweep misses no more than the turnings' own steps, and adds nothing.
            prop_assert!(travel >= ways * seen - 1e-6, "{linkage:?} {travel} {seen}");
            prop_assert!(travel <= ways * seen + 0.1, "{linkage:?} {travel} {seen}");
            match swing {
                Swing::Turns => prop_assert!(travel > TAU - 1e-9, "{linkage:?}: {travel}"),
                Swing::Between { min, max } => {
                    prop_assert!(travel >= 2.0 * (max - min) - 1e-6, "{linkage:?}: {travel}");
                }
            }
        }
    }

    /// Extrema are extreme: no sample of a fine sweep lies beyond them.
    #[test]
    fn extrema_bound_a_sweep((linkage, assembly) in linkage()) {
        let cycle = linkage.cycle();
        if !cycle.is_full() {
            return Ok(()); // unbounded towards the dead points
        }
        let [start, end] = cycle.axis();
        for (order, found) in (1..).zip(extrema(&linkage, assembly)) {
            let values = found.iter().map(|extremum| extremum.value);
            let [least, most] = values.fold([f64::INFINITY, -f64::INFINITY], |[a, b], v| {
                [a.min(v), b.max(v)]
            });
            for step in 0..1000 {
                let crank = start + (end - start) * f64::from(step) / 1000.0;
                let Ok(pose) = linkage.pose::<3>(assembly, crank) else { continue };
                let value = pose.rocker.derivative(order);
                let slack = 1e-9 * (1.0 + value.abs());
                prop_assert!(
                    found.is_empty() || (least - slack..=most + slack).contains(&value),
                    "{linkage:?} {assembly:?} {order} at {crank}: {value} in {least}..{most}"
                );
            }
        }
    }

    /// Rates by time: no sample of a fine sweep lies beyond the extrema, and every
    /// change of its sign has its zero.
    #[test]
    fn rates_have_their_zeros_and_extrema(
        (linkage, assembly) in linkage(),
        speed in -20.0..20.0_f64,
        acceleration in -50.0..50.0_f64,
    ) {
        let cycle = linkage.cycle();
        if !cycle.is_full() {
            return Ok(()); // unbounded towards the dead points
        }
        let input = InputRate { speed, acceleration };
        let motion = |crank: f64| Some(vec![linkage.pose::<5>(assembly, crank).ok()?.rocker]);
        let found = features(&cycle, &motion, &[1.0], input).unwrap();
        let [start, end] = cycle.axis();
        let scales = [1.0, speed.abs(), speed * speed + acceleration.abs()];
        for (order, (features, scale)) in found[0].iter().zip(scales).enumerate() {
            let values = features.extrema.iter().map(|extremum| extremum.value);
            let [least, most] = values.fold([f64::INFINITY, -f64::INFINITY], |[a, b], v| {
                [a.min(v), b.max(v)]
            });
            let mut before: Option<(f64, f64)> = None;
            for step in 0..1000 {
                let crank = start + (end - start) * f64::from(step) / 1000.0;
                let Some(jets) = motion(crank) else { continue };
                let value = input.rate(&jets[0], order);
                let slack = 1e-9 * (scale + value.abs());
                // An angle that turns fully has extrema, if any, of its ripple only.
                prop_assert!(
                    order == 0 || features.extrema.is_empty()
                        || (least - slack..=most + slack).contains(&value),
                    "{linkage:?} {assembly:?} {input:?} {order} at {crank}: {value} in {least}..{most}"
                );
                if let Some((at, last)) = before
                    && last * value < 0.0
                    && last.abs().min(value.abs()) > 1e-7 * scale
                    && !features.extrema.is_empty()
                {
                    prop_assert!(
                        features.zeros.iter().any(|zero| (at..=crank).contains(zero)),
                        "{linkage:?} {assembly:?} {input:?} {order} in {at}..{crank}"
                    );
                }
                before = Some((crank, value));
            }
        }
    }

    /// The worst transmission angle is no better than any of a sweep.
    #[test]
    fn worst_transmission_is_the_worst((linkage, _) in linkage(), t in 0.0..1.0_f64) {
        let (worst, at) = linkage.worst_transmission();
        prop_assert!((linkage.transmission_angle(at).unwrap() - worst).abs() < 1e-15);
        for [from, to] in linkage.cycle().arcs() {
            if let Ok(angle) = linkage.transmission_angle(from + t * (to - from)) {
                prop_assert!(worst <= angle + 1e-12, "{linkage:?} {t}");
            }
        }
    }

    /// Forward and back by the same steps returns, and never leaves the arcs.
    #[test]
    fn advance_returns((linkage, _) in linkage(), t in 0.01..0.99_f64, steps in 1..200_usize) {
        let cycle = linkage.cycle();
        let [from, to] = cycle.arcs()[0];
        let start = from + t * (to - from);
        let (mut crank, mut sense) = (start, 1.0);
        for leg in [1.0, -1.0] {
            sense *= leg;
            for _ in 0..steps {
                let (next, turned) = cycle.advance(crank, sense * 0.37);
                (crank, sense) = (next, sense * turned);
                prop_assert!(cycle.contains(crank), "{linkage:?} {crank}");
            }
        }
        let off = (crank - start).rem_euclid(to - from);
        prop_assert!(off.min(to - from - off) < 1e-9, "{linkage:?} {start} {crank}");
    }
}

/// The parallelogram 1-2-1-2 of theory.md: a constant σ without the sign of the
/// roots gives φ₃ = 179°, 180°, 179.67° here; the smooth branch goes on to 181°.
#[test]
fn parallelogram_stays_one() {
    let linkage = FourBar::new([1.0, 2.0, 1.0, 2.0]).unwrap();
    for degrees in [-400, -180, -90, 0, 90, 179, 180, 181, 359, 360, 361, 900] {
        let crank = f64::from(degrees).to_radians();
        let pose = linkage.pose::<3>(Assembly::First, crank).unwrap();
        assert!((pose.rocker.value() - crank).abs() < 1e-14, "{degrees}");
        assert!(pose.coupler.value().abs() < 1e-14, "{degrees}");
        assert!((pose.rocker.derivative(1) - 1.0).abs() < 1e-13, "{degrees}");
        assert!(pose.rocker.derivative(2).abs() < 1e-12, "{degrees}");
    }
    let [zero, pi] = linkage.change_points()[..] else {
        panic!("two change points")
    };
    assert_eq!([zero.crank, pi.crank], [0.0, PI]);
    let rates = pi.continuations.map(|pose| pose.rocker.derivative(1));
    assert!((rates[0] - 1.0).abs() < 1e-13);
    // The antiparallelogram's rocker turns three times as fast against it there.
    assert!((rates[1] + 1.0 / 3.0).abs() < 1e-13, "{rates:?}");
    assert!(extrema(&linkage, Assembly::First)[0].is_empty());
}

/// A deltoid's diagonal vanishes at φ₁ = 0: an error there, smooth beside it.
#[test]
fn deltoid_names_the_angle() {
    let linkage = FourBar::new([1.0, 2.0, 2.0, 1.0]).unwrap();
    for assembly in Assembly::ALL {
        for crank in [0.0, TAU] {
            assert_eq!(
                linkage.pose::<1>(assembly, crank),
                Err(assur::Unsolved::Undetermined { crank })
            );
        }
        let [before, after] =
            [-1e-9, 1e-9].map(|crank| linkage.pose::<2>(assembly, crank).unwrap());
        assert!((before.rocker.value() - after.rocker.value()).abs() < 1e-8);
        // φ₅ turns at ½; the angle at D falls by l₁/(l₂ + l₃) on either side.
        let rate = 0.5 + 0.25 * assembly.sign();
        assert!((before.rocker.derivative(1) - rate).abs() < 1e-8);
        assert!((after.rocker.derivative(1) - rate).abs() < 1e-8);
    }
    assert_eq!(linkage.cycle().axis(), [0.0, 2.0 * TAU]);
}
