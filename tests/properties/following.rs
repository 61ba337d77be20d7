//! Properties of every motion, shared by the tests of chains of dyads and of higher groups.

use assur::JetPoint;
use assur::mechanism::{LinkageSpec, Mechanism, Pose};
use assur::motion::Motion;

pub(crate) use super::random::Random;

/// Inputs over the whole motion, the ends not quite included.
pub(crate) fn inputs(motion: &Motion, random: &mut Random) -> Vec<f64> {
    let arcs = motion.cycle().arcs().to_vec();
    let inside = |random: &mut Random| {
        let [from, to] = arcs[random.below(arcs.len())];
        from + (to - from) * random.within(0.0, 1.0)
    };
    (0..8).map(|_| inside(random)).collect()
}

/// By how much a moving point differs from another, each derivative relative to the
/// size that derivatives of this order have.
pub(crate) fn worst<const N: usize>(a: &JetPoint<N>, b: &JetPoint<N>, size: f64, rate: f64) -> f64 {
    (0..N)
        .map(|order| {
            let scale = size * rate.powi(order as i32);
            (a.derivative(order) - b.derivative(order)).norm() / scale
        })
        .fold(0.0, f64::max)
}

/// The size of the mechanism in a pose: between guides nearly parallel links go far.
pub(crate) fn size_at(mechanism: &Mechanism, pose: &Pose<1>) -> f64 {
    let places = mechanism
        .point_ids()
        .map(|point| mechanism.place(pose, point).place());
    places.fold(mechanism.size(), |size, at| size.max(at.coords.norm()))
}

/// How fast the pose changes: the scale of its derivatives. Near a dead point
/// they grow without bound, and their errors with them.
pub(crate) fn rate(mechanism: &Mechanism, pose: &Pose<4>) -> f64 {
    let points = mechanism
        .point_ids()
        .map(|point| mechanism.place(pose, point));
    let rates = points.flat_map(|point| {
        (1..4).map(move |order| {
            (point.derivative(order).norm() / mechanism.size()).powf(1.0 / order as f64)
        })
    });
    rates.fold(1.0, f64::max)
}

/// Every point is where each of its links carries it, with all derivatives; a
/// link's angle is that of the line between its points; a sliding point keeps
/// its distance from the line. How many poses with derivatives there were.
pub(crate) fn closes(seed: u64, draft: &LinkageSpec, motion: &Motion, inputs: &[f64]) -> usize {
    let mut checked = 0;
    let mechanism = motion.mechanism();
    let size = mechanism.size();
    for input in inputs {
        let input = *input;
        let position = motion.pose::<1>(input);
        let position =
            position.unwrap_or_else(|e| panic!("{seed} at {input}: {e} {:?}", motion.cycle()));
        let Ok(pose) = motion.pose::<4>(input) else {
            continue;
        };
        checked += 1;
        let rate = rate(mechanism, &pose);
        for (link, named) in mechanism.link_ids().zip(&draft.links) {
            for point in mechanism.points_of(link) {
                let here = mechanism.carried(&pose, link, *point).unwrap();
                let off = worst(&here, &mechanism.place(&pose, *point), size, rate);
                assert!(
                    off < 1e-9,
                    "{seed} at {input}: {} of {} is off by {off:e}",
                    mechanism.point_name(*point),
                    named.name
                );
                let [here, there] = [
                    mechanism.carried(&position, link, *point).unwrap(),
                    mechanism.place(&position, *point),
                ];
                let off = (here.place() - there.place()).norm() / size_at(mechanism, &position);
                assert!(off < 1e-12, "{seed} at {input}: closure {off:e}");
            }
            if let [first, second, ..] = mechanism.points_of(link)[..] {
                let [a, b] = [first, second].map(|point| draft.points[point.index()].at);
                let length = (b - a).norm();
                let end =
                    mechanism
                        .place(&pose, first)
                        .offset(mechanism.angle(&pose, link), length, 0.0);
                let off = worst(&end, &mechanism.place(&pose, second), size, rate);
                assert!(
                    off < 1e-9,
                    "{seed} at {input}: {} is turned off by {off:e}",
                    named.name
                );
            }
        }
        for slide in &draft.slides {
            let index = |name: &String| mechanism.point(name).unwrap();
            let [a, b] = slide
                .line
                .each_ref()
                .map(|name| mechanism.place(&position, index(name)).place());
            let at = mechanism.place(&position, index(&slide.point)).place();
            let heading = (b - a).normalize();
            let [da, db, dp] = [&slide.line[0], &slide.line[1], &slide.point]
                .map(|name| draft.points[index(name).index()].at);
            let drawn = (db - da).normalize();
            let [now, then] = [heading.perp(&(at - a)), drawn.perp(&(dp - da))];
            assert!(
                (now - then).abs() < 1e-12 * size_at(mechanism, &position),
                "{seed} at {input}: off the guide {:e}",
                now - then
            );
        }
    }
    checked
}

/// Drawn at any other of its poses it is the same mechanism: no way along the
/// motion leads onto another branch. How many poses were compared.
pub(crate) fn leads_to_itself(
    seed: u64,
    draft: &LinkageSpec,
    motion: &Motion,
    inputs: &[f64],
) -> usize {
    let mut checked = 0;
    let mechanism = motion.mechanism();
    let Ok(there) = motion.pose::<4>(inputs[0]) else {
        return 0;
    };
    // Next to a singular pose the drawing itself is not told apart.
    if rate(mechanism, &there) > 1e3 {
        return 0;
    }
    let mut redrawn = draft.clone();
    for (point, place) in mechanism.point_ids().zip(&mut redrawn.points) {
        place.at = mechanism.place(&there, point).place();
    }
    let other = Mechanism::new(&redrawn).unwrap_or_else(|e| panic!("{seed}: {e:?}"));
    let again = Motion::new(other);
    let other = again.mechanism();
    for input in &inputs[1..] {
        let Ok(pose) = motion.pose::<4>(*input) else {
            continue;
        };
        if rate(mechanism, &pose) > 1e3 {
            continue;
        }
        let same = again.pose::<1>(*input);
        let same = same.unwrap_or_else(|e| {
            panic!(
                "{seed}: drawn at {}, not at {input}: {e} {:?} {:?}",
                inputs[0],
                motion.cycle(),
                again.cycle()
            )
        });
        for point in mechanism.point_ids() {
            let off =
                (mechanism.place(&pose, point).place() - other.place(&same, point).place()).norm();
            assert!(
                off < 1e-8 * mechanism.size(),
                "{seed}: drawn at {}, at {input} {point:?} is off by {off:e}",
                inputs[0]
            );
        }
        checked += 1;
    }
    checked
}

/// From sample to sample nothing jumps: a pose is where its neighbour's
/// derivatives say.
pub(crate) fn does_not_jump(seed: u64, motion: &Motion) {
    let mechanism = motion.mechanism();
    for [from, to] in motion.cycle().arcs() {
        let count = 1_000;
        let width = (to - from) / f64::from(count);
        let mut before: Option<Pose<4>> = None;
        for k in 0..=count {
            let here = motion
                .pose::<4>((from + width * f64::from(k)).min(*to))
                .ok();
            if let (Some(a), Some(b)) = (&before, &here)
                && rate(mechanism, a).max(rate(mechanism, b)) * width < 0.1
            {
                for link in mechanism.link_ids() {
                    let [p, q] = [a, b].map(|pose| mechanism.angle(pose, link));
                    let promised =
                        p.value() + width * (p.derivative(1) + 0.5 * width * p.derivative(2));
                    assert!(
                        (q.value() - promised).abs() < 0.05,
                        "{seed}: link {link:?} jumps at {k}: {} {}",
                        q.value(),
                        promised
                    );
                }
            }
            before = here;
        }
    }
}
