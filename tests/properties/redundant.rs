//! Mechanisms with redundant constraints that move, of random sizes and in random poses.

mod doubled;
mod nearly;

use std::f64::consts::TAU;

use assur::mechanism::{Defect, Dimension, LinkageSpec, Mechanism};
use assur::motion::{Motion, NEARLY, Refusal};
use assur::{Point, Vector};
use assur_tests::scaled;

use super::random::Random;

/// Mechanisms of each family in a quick run.
const EACH: u64 = 20;

/// A family of mechanisms: its name, a drawing, W by count, whether the crank turns fully.
struct Family {
    name: &'static str,
    drawn: fn(&mut Random) -> LinkageSpec,
    count: isize,
    turns: bool,
    /// A point that spoils it where it is drawn elsewhere, if there is one.
    spoils: Option<&'static str>,
}

fn turned(by: f64, length: f64) -> Vector {
    Vector::new(by.cos(), by.sin()) * length
}

fn with(draft: LinkageSpec, name: &str, at: Vector) -> LinkageSpec {
    draft.point(name, at.x, at.y)
}

/// A rod on equal parallel cranks, with pivots in line or not.
fn rods(random: &mut Random, in_line: bool, cranks: usize) -> LinkageSpec {
    let along = random.within(0.0, TAU);
    let angle = random.within(0.0, TAU);
    drawn_rods(random, in_line, cranks, [along, angle])
}

fn drawn_rods(
    random: &mut Random,
    in_line: bool,
    cranks: usize,
    [along, angle]: [f64; 2],
) -> LinkageSpec {
    let arm = turned(angle, random.within(0.4, 2.0));
    let mut draft = LinkageSpec::default();
    let (mut frame, mut rod) = (Vec::new(), Vec::new());
    for k in 0..cranks {
        let off = if in_line || k < 2 {
            0.0
        } else {
            random.within(0.3, 1.5)
        };
        let pivot = turned(along, 1.7 * k as f64 + random.within(0.0, 0.9))
            + turned(along + 0.25 * TAU, off);
        let (a, b) = (format!("A{k}"), format!("B{k}"));
        draft = with(with(draft, &a, pivot), &b, pivot + arm);
        frame.push(a);
        rod.push(b);
    }
    draft.frame.clone_from(&frame);
    let mut draft = draft.bar("rod", &rod.iter().map(String::as_str).collect::<Vec<_>>());
    for k in 0..cranks {
        draft = draft.bar(&format!("c{k}"), &[&frame[k], &rod[k]]);
    }
    draft.crank("c0")
}

/// A four-bar of which the link on two of its joints is doubled.
fn doubled(random: &mut Random, joints: [&str; 2]) -> LinkageSpec {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.5, random.within(0.6, 1.0))
        .point("C", 3.0, random.within(1.8, 2.4))
        .point("D", 3.0, 0.0);
    draft
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("double", &joints)
        .bar("rocker", &["D", "C"])
        .crank("crank")
}

/// A crank on the midpoint of a trammel's bar.
fn trammel(random: &mut Random) -> LinkageSpec {
    let arm = turned(random.within(0.1, TAU), random.within(0.5, 2.0));
    let draft = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("X", 1.0, 0.0)
        .point("Y", 0.0, 1.0);
    let draft = with(draft, "M", arm);
    let draft = with(draft, "P", Vector::new(2.0 * arm.x, 0.0));
    let draft = with(draft, "Q", Vector::new(0.0, 2.0 * arm.y));
    draft
        .fixed(&["O", "X", "Y"])
        .bar("crank", &["O", "M"])
        .bar("bar", &["P", "M", "Q"])
        .bar("p", &["P"])
        .bar("q", &["Q"])
        .slide("p", "P", "frame", ["O", "X"])
        .slide("q", "Q", "frame", ["O", "Y"])
        .crank("crank")
}

/// A double parallelogram: two cranks joined by two rods, and two more cranks above them with a rod.
fn double_parallelogram(random: &mut Random) -> LinkageSpec {
    let base = turned(random.within(-0.5, 0.5), random.within(1.5, 3.0));
    let (lower, upper) = (
        turned(random.within(0.3, 2.8), random.within(0.7, 1.5)),
        random.within(1.3, 2.2),
    );
    let draft = LinkageSpec::default().point("A", 0.0, 0.0);
    let draft = with(draft, "D", base);
    let draft = with(draft, "B", lower);
    let draft = with(draft, "C", base + lower);
    let draft = with(draft, "E", lower * upper);
    let draft = with(draft, "F", base + lower * upper);
    draft
        .fixed(&["A", "D"])
        .bar("left", &["A", "B", "E"])
        .bar("right", &["D", "C", "F"])
        .bar("middle", &["B", "C"])
        .bar("top", &["E", "F"])
        .crank("left")
}

/// A pantograph, a parallelogram with long sides, with a spare link parallel to its short one.
fn pantograph(random: &mut Random) -> LinkageSpec {
    let (one, other) = (
        turned(random.within(0.9, 1.3), random.within(1.0, 1.6)),
        turned(random.within(-0.3, 0.3), random.within(0.7, 1.2)),
    );
    let part = random.within(0.3, 0.7);
    let draft = LinkageSpec::default().point("O", 0.0, 0.0);
    let draft = with(draft, "K", one);
    let draft = with(draft, "L", other);
    let draft = with(draft, "M", one + other);
    let draft = with(draft, "S", one * part);
    let draft = with(draft, "T", one * part + other);
    let centre = one + other - turned(random.within(0.0, TAU), 0.03);
    let draft = with(draft, "G", centre);
    draft
        .fixed(&["O", "G"])
        .bar("crank", &["G", "M"])
        .bar("arm", &["O", "S", "K"])
        .bar("mate", &["O", "L"])
        .bar("far", &["K", "M"])
        .bar("side", &["L", "T", "M"])
        .bar("spare", &["S", "T"])
        .crank("crank")
}

/// Peaucellier's cell with a slide along the line that it draws.
fn peaucellier(random: &mut Random) -> LinkageSpec {
    let (long, short) = (random.within(3.0, 3.2), random.within(1.4, 1.6));
    let r = random.within(0.95, 1.3);
    let phi = random.within(-0.5, 0.5);
    // O at the origin, its crank on C = (r, 0), so that P goes through O.
    let p = Vector::new(r + r * phi.cos(), r * phi.sin());
    let way = p.normalize();
    let foot = p.norm();
    // The rhombus: half of its diagonal along the way, and across.
    let power = long * long - short * short;
    let q = way * (power / foot);
    let middle = (p + q) / 2.0;
    let half = (short * short - ((q - p).norm() / 2.0).powi(2)).sqrt();
    let across = Vector::new(-way.y, way.x) * half;
    let draft = LinkageSpec::default().point("O", 0.0, 0.0);
    let draft = with(draft, "Z", Vector::new(r, 0.0));
    let draft = with(draft, "P", p);
    let draft = with(draft, "Q", q);
    let draft = with(draft, "U", middle + across);
    let draft = with(draft, "V", middle - across);
    let draft = with(draft, "G", Vector::new(q.x, -1.0));
    let draft = with(draft, "H", Vector::new(q.x, 1.0));
    draft
        .fixed(&["O", "Z", "G", "H"])
        .bar("crank", &["Z", "P"])
        .bar("ou", &["O", "U"])
        .bar("ov", &["O", "V"])
        .bar("pu", &["P", "U"])
        .bar("pv", &["P", "V"])
        .bar("qu", &["Q", "U"])
        .bar("qv", &["Q", "V"])
        .bar("block", &["Q"])
        .slide("block", "Q", "frame", ["G", "H"])
        .crank("crank")
}

fn families() -> Vec<Family> {
    let family = |name, drawn, count, turns, spoils| Family {
        name,
        drawn,
        count,
        turns,
        spoils,
    };
    vec![
        family(
            "3 cranks in line",
            |r| rods(r, true, 3),
            0,
            true,
            Some("B2"),
        ),
        family("3 cranks", |r| rods(r, false, 3), 0, true, Some("B2")),
        family(
            "4 cranks in line",
            |r| rods(r, true, 4),
            -1,
            true,
            Some("B3"),
        ),
        family("4 cranks", |r| rods(r, false, 4), -1, true, Some("B3")),
        family(
            "5 cranks in line",
            |r| rods(r, true, 5),
            -2,
            true,
            Some("B4"),
        ),
        family("5 cranks", |r| rods(r, false, 5), -2, true, Some("B4")),
        family("6 cranks", |r| rods(r, false, 6), -3, true, Some("B5")),
        family(
            "6 cranks in line",
            |r| rods(r, true, 6),
            -3,
            true,
            Some("B5"),
        ),
        family(
            "3 cranks, all drawn in line",
            |r| {
                let along = r.within(0.0, TAU);
                drawn_rods(r, true, 3, [along; 2])
            },
            0,
            true,
            None,
        ),
        family("doubled crank", |r| doubled(r, ["A", "B"]), 0, true, None),
        family("doubled coupler", |r| doubled(r, ["C", "B"]), 0, true, None),
        family("doubled rocker", |r| doubled(r, ["D", "C"]), 0, true, None),
        family("doubled frame", |r| doubled(r, ["A", "D"]), 0, true, None),
        family("trammel", trammel, 0, true, Some("M")),
        family(
            "double parallelogram",
            double_parallelogram,
            0,
            true,
            Some("F"),
        ),
        family("pantograph", pantograph, 0, true, Some("T")),
        family("Peaucellier", peaucellier, 0, false, Some("Q")),
    ]
}

/// The greatest distance between two points of a drawing.
fn size(draft: &LinkageSpec) -> f64 {
    let points = draft.points.iter();
    let pairs = points.flat_map(|p| draft.points.iter().map(move |q| (p.at - q.at).norm()));
    pairs.fold(0.0, f64::max)
}

/// The residuals of a draft's constraints, the redundant ones too, where its points are.
fn residual(draft: &LinkageSpec, place: impl Fn(&str) -> Point) -> f64 {
    let drawn = |name: &str| draft.points.iter().find(|p| p.name == name).unwrap().at;
    let mut worst: f64 = 0.0;
    for link in &draft.links {
        for (k, one) in link.points.iter().enumerate() {
            for other in &link.points[..k] {
                let [now, then] = [
                    (place(one) - place(other)).norm(),
                    (drawn(one) - drawn(other)).norm(),
                ];
                worst = worst.max((now - then).abs());
            }
        }
    }
    for slide in &draft.slides {
        let off = |at: &dyn Fn(&str) -> Point| {
            let [from, to] = slide.line.each_ref().map(|name| at(name));
            (to - from).normalize().perp(&(at(&slide.point) - from))
        };
        worst = worst.max((off(&place) - off(&drawn)).abs());
    }
    worst
}

#[test]
fn they_move_and_all_constraints_hold() {
    let mut random = Random::new(35);
    for family in families() {
        let mut moved = 0;
        for seed in 0..scaled(EACH) {
            let name = family.name;
            let draft = (family.drawn)(&mut random);
            let size = size(&draft);
            let mechanism = Mechanism::new(&draft)
                .unwrap_or_else(|defects| panic!("{name} {seed}: {defects:?}"));
            assert_eq!(mechanism.counts().mobility, family.count, "{name}");
            let mobility = mechanism.mobility();
            assert_eq!(
                (mobility.by_count, mobility.by_rank),
                (family.count, 1),
                "{name}"
            );
            assert_eq!(
                mobility.redundant.len() as isize,
                1 - family.count,
                "{name}"
            );
            let motion = Motion::new(mechanism);
            if family.turns {
                assert!(motion.change_points().is_empty(), "{name} {seed}");
                assert!(motion.dead_points().is_empty(), "{name} {seed}");
            }
            let cycle = motion.cycle();
            assert_eq!(
                cycle.is_full(),
                family.turns,
                "{name} {seed}: {:?}",
                cycle.arcs()
            );
            let mechanism = motion.mechanism();
            for [from, to] in cycle.arcs() {
                for k in 0..=72 {
                    let input = from + (to - from) * f64::from(k) / 72.0;
                    if !family.turns && (k == 0 || k == 72) {
                        continue;
                    }
                    let pose = motion.pose::<4>(input);
                    let pose = pose.unwrap_or_else(|e| panic!("{name} {seed} {input}: {e:?}"));
                    let place = |point: &str| {
                        let point = mechanism.point(point).unwrap();
                        mechanism.place(&pose, point).place()
                    };
                    let off = residual(&draft, place);
                    assert!(off <= 1e-12 * size, "{name} {seed} at {input}: {off}");
                    moved += 1;
                }
            }
        }
        assert!(
            moved > 70 * scaled(EACH) as usize,
            "{}: {moved}",
            family.name
        );
    }
}

/// A parallelogram of which a link is doubled passes through the antiparallelogram where the parallelogram does.
#[test]
fn change_points_are_those_of_the_whole_set() {
    let mut random = Random::new(38);
    for joints in [["A", "B"], ["B", "C"], ["D", "C"], ["A", "D"]] {
        for seed in 0..scaled(EACH) {
            let base = turned(random.within(0.0, TAU), random.within(1.5, 3.0));
            let arm = turned(random.within(0.0, TAU), random.within(0.4, 1.2));
            let draft = LinkageSpec::default().point("A", 0.0, 0.0);
            let draft = with(draft, "D", base);
            let draft = with(draft, "B", arm);
            let draft = with(draft, "C", base + arm);
            let plain = draft
                .fixed(&["A", "D"])
                .bar("crank", &["A", "B"])
                .bar("coupler", &["B", "C"])
                .bar("rocker", &["D", "C"])
                .crank("crank");
            let doubled = plain.clone().bar("double", &joints);
            let moved = [plain, doubled].map(|draft| Motion::new(Mechanism::new(&draft).unwrap()));
            let [plain, doubled] = moved.each_ref().map(Motion::change_points);
            assert_eq!((plain.len(), doubled.len()), (2, 2), "{joints:?} {seed}");
            for (one, other) in plain.iter().zip(doubled) {
                assert!(
                    (one - other).abs() < 1e-9,
                    "{joints:?} {seed}: {one} {other}"
                );
            }
        }
    }
}
