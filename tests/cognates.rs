//! Cognates, moved by the engine: every linkage traces the curve of the first. From a pose of a cognate the crank and
//! the coupler of the first linkage are laid off; the curve is the same if they close with its rocker.

use assur::linkage::LinkageSpec;
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur::synthesis::cognates::{CouplerFourBar, CouplerSliderCrank};
use assur::{Grashof, Point, Vector, perpendicular};
use assur_tests::scaled;
use nalgebra::Complex;

use crate::properties::random::Random;

/// Relative to the size of the linkage.
const SAME: f64 = 1e-10;

fn over(vector: Vector, ratio: Complex<f64>) -> Vector {
    let quotient = Complex::new(vector.x, vector.y) / ratio;
    Vector::new(quotient.re, quotient.im)
}

fn place(random: &mut Random) -> Point {
    Point::new(random.within(-4.0, 4.0), random.within(-4.0, 4.0))
}

/// A point of a bar in the plane of the bar: every third on its line, every seventh near a joint.
fn carried(random: &mut Random, k: usize, [a, b]: [Point; 2]) -> Point {
    let across = if k.is_multiple_of(3) {
        0.0
    } else {
        random.within(-2.0, 2.0)
    };
    let along = if k.is_multiple_of(7) {
        1e-2
    } else {
        random.within(-2.0, 2.0)
    };
    a + (b - a) * along + perpendicular(b - a) * across
}

/// Whether the driver of a specification turns fully, and the places of given points in poses over the whole motion.
fn poses(spec: &LinkageSpec, names: [&str; 2]) -> (bool, Vec<[Point; 2]>) {
    let motion = Motion::new(Mechanism::new(spec).unwrap());
    let mechanism = motion.mechanism();
    let ids = names.map(|name| mechanism.point(name).unwrap());
    let arcs = motion.cycle().arcs().iter();
    let inputs = arcs.flat_map(|[from, to]| {
        (1..12).map(move |k| from + (to - from) * (f64::from(k) / 12.0 + 0.01))
    });
    let of = |input: f64| {
        let pose = motion.pose::<1>(input).unwrap();
        ids.map(|id| mechanism.place(&pose, id).place())
    };
    (motion.cycle().is_full(), inputs.map(of).collect())
}

/// All linkages of 150 random four-bars: both cognates, three five-bars with gears.
#[test]
fn all_linkages_trace_the_curve_of_the_four_bar() {
    let mut random = Random::new(42);
    let (mut seen, mut worst) = (0, 0.0_f64);
    for k in 0..scaled(150_u16) {
        let pivots = [place(&mut random), place(&mut random)];
        let joints = [place(&mut random), place(&mut random)];
        let point = carried(&mut random, k.into(), joints);
        let Ok(linkage) = CouplerFourBar::new(pivots, joints, point) else {
            continue;
        };
        let ([a0, b0], w) = (pivots, linkage.ratio());
        let v = w - 1.0;
        let [first, second] = linkage.cognates().map(|cognate| cognate.unwrap().spec());
        let [coupler, crank, rocker] = linkage.geared().map(|linkage| linkage.unwrap().spec());
        // A and B of the first linkage, from the joint B and the point P of the other.
        type Laid<'a> = Box<dyn Fn(Point, Point) -> [Point; 2] + 'a>;
        let with_coupler = |b: Point, p: Point| {
            let a = a0 + (p - b);
            [a, a + over(b - a0, w)]
        };
        let laid: [(LinkageSpec, Laid); 6] = [
            (linkage.spec(), Box::new(|a, p| [a, a + over(p - a, w)])),
            (first, Box::new(with_coupler)),
            (
                second,
                Box::new(|joint, p| {
                    let b = b0 + (p - joint);
                    [b - over(joint - b0, v), b]
                }),
            ),
            (coupler, Box::new(with_coupler)),
            (crank, Box::new(|a, p| [a, a + over(p - a, w)])),
            (rocker, Box::new(|b, p| [b - over(p - b, v), b])),
        ];
        let [l1, l2, l3, l4] = linkage.lengths();
        let size = (l1 + l2 + l3 + l4) * w.norm().max(v.norm()).max(1.0);
        for (n, (spec, laid)) in laid.into_iter().enumerate() {
            let (turns, poses) = poses(&spec, ["B", "P"]);
            assert!(!poses.is_empty(), "{k} {n}: {linkage:?}");
            // A four-bar of which one link turns fully traces its whole curve, and so do its cognates.
            let grashof = linkage.grashof() != Ok(Grashof::TripleRocker);
            assert!(n > 2 || turns == grashof, "{k} {n}: {linkage:?}");
            for [joint, p] in poses {
                let [a, b] = laid(joint, p);
                for (bar, length) in [(a - a0, l1), (b - a, l2), (b - b0, l3)] {
                    // A bar is laid off with an error of the pose over |w| or |1 − w|.
                    let off = (bar.norm() - length).abs() * w.norm().min(v.norm()).min(1.0);
                    worst = worst.max(off / size);
                    assert!(off <= SAME * size, "{k} {n}: {off:e} {linkage:?}");
                }
                seen += 1;
            }
        }
    }
    assert!(seen > 7_500, "{seen} poses, {worst:e}");
}

/// Both slider-cranks of 150: A = A₀ + (P − A′), B − A = (A′ − A₀)/w, and B is on the guide.
#[test]
fn both_slider_cranks_trace_the_same_curve() {
    let mut random = Random::new(43);
    let mut seen = 0;
    for k in 0..scaled(150_u16) {
        let (pivot, joints) = (place(&mut random), [place(&mut random), place(&mut random)]);
        let point = carried(&mut random, k.into(), joints);
        let angle = random.within(0.0, 6.0);
        let guide = Vector::new(angle.cos(), angle.sin());
        let linkage = CouplerSliderCrank::new(pivot, joints, guide, point).unwrap();
        let (w, [l1, l2, offset]) = (linkage.ratio(), linkage.lengths());
        let size = (l1 + l2) * w.norm().max(1.0);
        for (n, spec) in [linkage.spec(), linkage.cognate().unwrap().spec()]
            .iter()
            .enumerate()
        {
            for [joint, p] in poses(spec, ["B", "P"]).1 {
                let a = if n == 0 { joint } else { pivot + (p - joint) };
                let b = a + if n == 0 {
                    over(p - a, w)
                } else {
                    over(joint - pivot, w)
                };
                let across = (b - pivot).dot(&perpendicular(guide));
                for off in [
                    (a - pivot).norm() - l1,
                    (b - a).norm() - l2,
                    across - offset,
                ] {
                    let off = off.abs() * w.norm().min(1.0);
                    assert!(off <= SAME * size, "{k} {n}: {off:e} {linkage:?}");
                }
                seen += 1;
            }
        }
    }
    assert!(seen > 3_000, "{seen} poses");
}
