//! Change points of dyads, wherever they occur: a motion has the derivatives of the smooth branch there.

use std::f64::consts::{PI, TAU};

use assur::gears::Mesh;
use assur::mechanism::{GearSpec, LinkageSpec, Mechanism, Quantity};
use assur::motion::Motion;
use assur::{Assembly, FourBar, Jet};

use super::random::Random;

/// Ways from a change point, within and beyond what is interpolated.
const WAYS: [f64; 9] = [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.05, 0.2];
/// Of a value and its derivatives, relative to the scale on which the motion changes: each order loses what the nodes
/// of the interpolation are apart.
const TOLERANCE: [f64; 6] = [1e-13, 1.5e-12, 2e-11, 3e-10, 5e-9, 8e-8];

fn motion(draft: &LinkageSpec) -> Motion {
    let mechanism = Mechanism::new(draft);
    Motion::new(mechanism.unwrap_or_else(|defects| panic!("{defects:?} {draft:?}")))
}

/// The angle of a link with five derivatives.
fn angle(motion: &Motion, link: &str, input: f64) -> Jet<6> {
    let pose = motion.pose(input);
    let pose = pose.unwrap_or_else(|unsolved| panic!("{link}: {unsolved}"));
    let mechanism = motion.mechanism();
    Quantity::Angle(mechanism.link(link).unwrap()).of(mechanism, &pose)
}

/// A crank that a wheel drives against its motor, so that its dyad is solved as any other.
fn geared(draft: LinkageSpec, at: f64) -> LinkageSpec {
    let mut draft = draft
        .point("M", -9.0, 0.0)
        .point("N", -9.0 + at.cos(), -at.sin());
    draft.frame.push("M".into());
    draft.gears.push(GearSpec {
        links: ["motor", "crank"].map(String::from),
        carrier: "frame".into(),
        teeth: [20.0, 20.0],
        mesh: Mesh::External,
    });
    draft.bar("motor", &["M", "N"]).crank("motor")
}

/// A four-bar in a pose.
fn drawn(linkage: &FourBar, assembly: Assembly, crank: f64) -> LinkageSpec {
    let [l1, l2, _, l4] = linkage.lengths();
    let pose = linkage.pose::<1>(assembly, crank).unwrap();
    let coupler = pose.coupler.value();
    let [bx, by] = [l1 * crank.cos(), l1 * crank.sin()];
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", bx, by)
        .point("C", bx + l2 * coupler.cos(), by + l2 * coupler.sin())
        .point("D", l4, 0.0);
    let draft = draft.fixed(&["A", "D"]).bar("crank", &["A", "B"]);
    draft.bar("coupler", &["B", "C"]).bar("rocker", &["D", "C"])
}

/// Lengths in another order.
fn shuffled(random: &mut Random, mut lengths: [f64; 4]) -> [f64; 4] {
    for k in (1..4).rev() {
        lengths.swap(k, random.below(k + 1));
    }
    lengths
}

/// Four-bars that stretch out or fold: the closed form of the four-bar, which passes by itself, tells the same.
#[test]
fn four_bars_behind_a_wheel() {
    let mut random = Random::new(77);
    let mut passed = 0;
    for seed in 0..300 {
        let [a, b] = [0, 1].map(|_| random.within(0.4, 3.0));
        let c =
            random.within(0.2, a.min(b) * 0.9) * f64::from(u8::from(seed % 3 > 0)) + a.min(b) * 0.1;
        // The shortest and the longest together are as long as the other two.
        let longest = a + b - c;
        let lengths = shuffled(&mut random, [c, a, b, longest]);
        // What is short, a link or the diagonal, is turned by what rounding leaves of the long ones.
        let [l1, .., l4] = lengths;
        let diagonal = (l1 - l4).abs();
        let shortest = lengths.into_iter().fold(diagonal, f64::min);
        let rounded = longest / shortest;
        let linkage = FourBar::new(lengths).unwrap();
        let assembly = Assembly::ALL[random.below(2)];
        let cycle = linkage.cycle();
        let [from, to] = cycle.arcs()[0];
        let home = from + (to - from) * random.within(0.2, 0.8);
        let motion = motion(&geared(drawn(&linkage, assembly, home), home));
        for at in motion.change_points() {
            let crank_at = angle(&motion, "crank", *at).value();
            // One of both assemblies on all the way through; after a turn they may change.
            let mut worst = [0.0_f64; 2];
            for way in WAYS.into_iter().flat_map(|way| [way, -way]) {
                let input = at + way;
                if !motion.cycle().contains(motion.cycle().wrap(input)) {
                    continue;
                }
                let found = angle(&motion, "rocker", input);
                let crank = crank_at - way;
                let off = Assembly::ALL.map(|assembly| {
                    let Ok(pose) = linkage.pose::<6>(assembly, crank) else {
                        return f64::INFINITY;
                    };
                    let rocker = pose.rocker;
                    let scale =
                        (1..6).map(|order| rocker.derivative(order).abs().powf(1.0 / order as f64));
                    // The diagonal turns as fast as that, whether or not it shows.
                    let scale = scale.fold(l1.max(l4) / diagonal, f64::max);
                    let off = (0..6).map(|order| {
                        let sense = (-1.0_f64).powi(order as i32);
                        let off = found.derivative(order) - sense * rocker.derivative(order);
                        let off = if order == 0 {
                            off.sin().abs()
                        } else {
                            off.abs()
                        };
                        off / scale.powi(order as i32) / (rounded * TOLERANCE[order])
                    });
                    off.fold(0.0, f64::max)
                });
                worst = [0, 1].map(|one| worst[one].max(off[one]));
                passed += 1;
            }
            let off = worst[0].min(worst[1]);
            assert!(off < 1.0, "{seed}: {lengths:?} at {at}: {off}");
        }
    }
    assert!(passed > 5_000, "{passed}");
}

/// Parallelograms one after the other pass at once, also where they are drawn close to that; all their cranks turn alike.
#[test]
fn parallelograms_in_a_row() {
    for drawn in [53.0_f64, 0.3, 0.02, -0.01, -0.02, -0.1, -0.3, 179.98] {
        parallelograms_drawn_at(drawn.to_radians());
    }
}

fn parallelograms_drawn_at(drawn: f64) {
    let [x0, y0] = [2.0 * drawn.cos(), 2.0 * drawn.sin()];
    let mut draft = LinkageSpec::default()
        .point("A0", 0.0, 0.0)
        .point("B0", x0, y0)
        .fixed(&["A0"]);
    draft = draft.bar("crank", &["A0", "B0"]);
    for k in 1..4 {
        let x = f64::from(k) * 3.0;
        let [a, b, before] = [format!("A{k}"), format!("B{k}"), format!("B{}", k - 1)];
        draft = draft.point(&a, x, 0.0).point(&b, x + x0, y0);
        draft.frame.push(a.clone());
        draft = draft.bar(&format!("coupler {k}"), &[&before, &b]);
        draft = draft.bar(&format!("rocker {k}"), &[&a, &b]);
    }
    let motion = motion(&draft.crank("crank"));
    assert!(
        motion.cycle().is_full(),
        "{drawn}: {:?}",
        motion.dead_points()
    );
    for at in [0.0, PI] {
        for way in WAYS.into_iter().flat_map(|way| [way, -way]) {
            let input = at + way;
            for k in 1..4 {
                let rocker = angle(&motion, &format!("rocker {k}"), input);
                let wrapped = motion.cycle().wrap(input);
                for (order, tolerance) in TOLERANCE.into_iter().enumerate() {
                    let expected = [wrapped, 1.0, 0.0, 0.0, 0.0, 0.0][order];
                    let off = (rocker.derivative(order) - expected).abs();
                    assert!(
                        off < tolerance,
                        "{k}, order {order}, {way:e} beside {at}: {off:e}"
                    );
                }
            }
        }
    }
}

/// A slider-crank whose rod is as long as its crank: the slider goes through the crank's centre, as a trammel's does.
#[test]
fn isosceles_slider_crank() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.6, 0.8)
        .point("C", 1.2, 0.0)
        .point("G", -1.0, 0.0)
        .point("H", 4.0, 0.0)
        .fixed(&["A", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["G", "H"])
        .crank("crank");
    let motion = motion(&draft);
    assert!(motion.cycle().is_full(), "{:?}", motion.dead_points());
    assert_eq!(motion.change_points().len(), 2);
    let mechanism = motion.mechanism();
    let slider = Quantity::X(mechanism.point("C").unwrap());
    for at in [0.5 * PI, 1.5 * PI] {
        for way in WAYS.into_iter().flat_map(|way| [way, -way]) {
            let input = at + way;
            let rod = angle(&motion, "rod", input);
            let x = slider.of(mechanism, &motion.pose::<6>(input).unwrap());
            let (sine, cosine) = input.sin_cos();
            let expected = [cosine, -sine, -cosine, sine, cosine, -sine];
            for (order, tolerance) in TOLERANCE.into_iter().enumerate() {
                let off = (x.derivative(order) - 2.0 * expected[order]).abs();
                assert!(
                    off < tolerance,
                    "x, order {order}, {way:e} beside {at}: {off:e}"
                );
                let expected = [0.0, -1.0, 0.0, 0.0, 0.0, 0.0][order];
                let off = if order == 0 {
                    (rod.value() + input).sin()
                } else {
                    rod.derivative(order) - expected
                };
                assert!(
                    off.abs() < tolerance,
                    "rod, order {order}, {way:e} beside {at}: {off:e}"
                );
            }
        }
    }
}

/// A slotted lever on a pivot at (3, 0), at a distance from its slot. Its pin, on a crank of 2, is as near as 1 to the pivot.
fn slotted(distance: f64) -> Motion {
    let at: f64 = 1.0;
    let [bx, by] = [2.0 * at.cos(), 2.0 * at.sin()];
    let [x, y] = [bx - 3.0, by];
    let square = x * x + y * y;
    let run = (square - distance * distance).sqrt();
    // Along the slot, with the pivot to its side.
    let [ux, uy] = [
        (x * run - y * distance) / square,
        (x * distance + y * run) / square,
    ];
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", bx, by)
        .point("D", 3.0, 0.0)
        .point("P", bx - ux, by - uy)
        .point("Q", bx + ux, by + uy)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("block", &["B"])
        .bar("lever", &["D", "P", "Q"])
        .slide("block", "B", "lever", ["P", "Q"])
        .crank("crank");
    motion(&draft)
}

/// A slotted lever that passes a change point, across the line of centres: the poses around it follow Taylor's series at
/// the change point.
#[test]
fn slotted_lever() {
    let motion = slotted(1.0);
    // It is back after two turns.
    let [at, _] = motion.change_points()[..] else {
        panic!("{:?} {:?}", motion.change_points(), motion.dead_points())
    };
    let here = angle(&motion, "lever", at);
    for way in [1e-4_f64, 1e-3, 0.01, 0.03]
        .into_iter()
        .flat_map(|way| [way, -way])
    {
        let told = (0..6).rev().fold(0.0, |sum, order| {
            let factorial: f64 = (1..=order).map(|k| k as f64).product();
            sum * way + here.derivative(order) / factorial
        });
        let off = (angle(&motion, "lever", at + way).value() - told)
            .sin()
            .abs();
        assert!(
            off < 1e-13 + 100.0 * way.powi(6),
            "{way:e} beside {at}: {off:e}"
        );
    }
}

/// The same with a pivot too far from the slot by 2e-13, which counts as rounding. With B − D = d and the crank at φ, the
/// slot has the direction arg d + atan2(1, √24 sin(φ/2)), because d² = 1 + 24 sin²(φ/2).
#[test]
fn slotted_lever_across_but_for_rounding() {
    let motion = slotted(1.0 + 2e-13);
    let at = motion.change_points()[0];
    // Where the root is interpolated; beyond, it is that of d² less the square of the distance.
    let ways = WAYS.into_iter().filter(|way| *way < 0.1);
    for way in ways.flat_map(|way| [way, -way]) {
        let crank = Jet::<6>::linear(at + way, 1.0);
        let [(sine, cosine), (half, _)] = [crank, crank * 0.5].map(Jet::sin_cos);
        let diagonal = (sine * 2.0).atan2(cosine * 2.0 + -3.0);
        let slot = diagonal + Jet::constant(1.0).atan2(half * 24_f64.sqrt());
        let found = angle(&motion, "lever", at + way);
        for (order, tolerance) in TOLERANCE.into_iter().enumerate().skip(1) {
            let off = (found.derivative(order) - slot.derivative(order)).abs();
            assert!(
                off < tolerance,
                "order {order}, {way:e} beside {at}: {off:e}"
            );
        }
    }
}

/// A four-bar that drives a slider off its crank, drawn in a pose.
fn with_slider(linkage: &FourBar, assembly: Assembly, crank: f64, rod: f64) -> LinkageSpec {
    let draft = drawn(linkage, assembly, crank);
    let b = draft.points[1].at;
    let slides = b.x + (rod * rod - b.y * b.y).sqrt();
    let mut draft = draft.point("E", slides, 0.0);
    draft = draft.bar("rod", &["B", "E"]).bar("block", &["E"]);
    draft
        .slide("block", "E", "frame", ["A", "D"])
        .crank("crank")
}

/// A linkage that is drawn next to its change point goes as far as one that is drawn elsewhere.
#[test]
fn drawings_next_to_a_change_point() {
    let mut random = Random::new(78);
    let mut compared = 0;
    for seed in 0..200 {
        let [a, b] = [0, 1].map(|_| random.within(0.4, 3.0));
        let c = random.within(0.2, 0.8) * a.min(b);
        let lengths = shuffled(&mut random, [c, a, b, a + b - c]);
        let linkage = FourBar::new(lengths).unwrap();
        let assembly = Assembly::ALL[random.below(2)];
        let rod = lengths[0] * random.within(0.5, 2.0);
        // In line with the frame, where it is at the change point.
        let at = [0.0, PI].map(|at| [at + 0.1, at - 0.1]);
        let is_there = |crank: &f64| {
            let reach = (lengths[0] * crank.sin()).abs() < rod;
            reach && linkage.pose::<1>(assembly, *crank).is_ok()
        };
        for ways in at.into_iter().filter(|ways| ways.iter().all(is_there)) {
            let elsewhere = motion(&with_slider(&linkage, assembly, ways[0], rod));
            let change = 0.5 * (ways[0] + ways[1]);
            for way in [1e-6, 1e-8, 1e-9, 1e-10]
                .into_iter()
                .flat_map(|way| [way, -way])
            {
                let Ok(mechanism) =
                    Mechanism::new(&with_slider(&linkage, assembly, change + way, rod))
                else {
                    continue;
                };
                let beside = Motion::new(mechanism);
                let [[from, to], range] = [&beside, &elsewhere].map(|one| one.cycle().arcs()[0]);
                let turns = TAU * ((range[0] - from) / TAU).round();
                let off = (from + turns - range[0])
                    .abs()
                    .max((to + turns - range[1]).abs());
                assert!(
                    off < 1e-6,
                    "{seed}: {lengths:?} {assembly:?} {way} from {change}, rod {rod}: {from} to {to}, not {range:?}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}
