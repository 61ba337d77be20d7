//! Mechanisms with redundant constraints that move: random sizes, random poses.

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
            assert_eq!((mobility.count, mobility.rank), (family.count, 1), "{name}");
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

/// A parallelogram without its coupler, and with a body for it of three links: a plate, a bar on it and a link from one
/// to the other. The bar is welded to the plate or shares two points with it.
fn doubled_body(random: &mut Random, is_welded: bool, order: usize) -> (LinkageSpec, LinkageSpec) {
    let base = turned(random.within(0.0, TAU), random.within(1.5, 3.0));
    let arm = turned(random.within(0.0, TAU), random.within(0.4, 1.2));
    let aside = turned(random.within(0.0, TAU), random.within(0.5, 1.5));
    let draft = LinkageSpec::default().point("A", 0.0, 0.0);
    let draft = with(draft, "D", base);
    let draft = with(draft, "B", arm);
    let draft = with(draft, "C", base + arm);
    let draft = with(draft, "F", 0.5 * base + arm);
    let draft = with(draft, "E", base + arm + aside);
    let plain = draft
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    let mut parts: [(&str, &[&str]); 3] = [
        ("coupler", &["B", "C", "F"]),
        (
            "bar",
            if is_welded {
                &["C", "E"]
            } else {
                &["C", "E", "F"]
            },
        ),
        ("double", &["E", "B"]),
    ];
    parts.rotate_left(order);
    let bars = parts.into_iter();
    let mut doubled = bars.fold(plain.clone(), |draft, (name, points)| {
        draft.bar(name, points)
    });
    if is_welded {
        let mut links = doubled.links.iter_mut();
        let bar = links.find(|link| link.name == "bar");
        bar.unwrap().fixed_to = Some("coupler".to_owned());
    }
    (plain, doubled)
}

/// A link between points of different links of one body, however that body is made, changes nothing but the count.
#[test]
fn a_body_is_doubled_by_a_link_on_two_of_its_links() {
    let mut random = Random::new(39);
    for is_welded in [true, false] {
        for order in 0..3 {
            for seed in 0..scaled(EACH) {
                let (plain, doubled) = doubled_body(&mut random, is_welded, order);
                let plain = plain.bar("coupler", &["B", "C"]);
                let at = format!("{is_welded} {order} {seed}");
                let [plain, doubled] = [plain, doubled].map(|draft| {
                    let mechanism = Mechanism::new(&draft);
                    Motion::new(mechanism.unwrap_or_else(|defects| panic!("{at}: {defects:?}")))
                });
                let mobility = doubled.mechanism().mobility();
                let q = if is_welded { 1 } else { 2 };
                assert_eq!((mobility.rank, mobility.q()), (1, q), "{at}");
                assert_eq!(mobility.redundant.len() as isize, q, "{at}");
                let formula = doubled.mechanism().formula();
                assert_eq!(
                    formula.matches("q₁(").count() as isize,
                    q,
                    "{at}: {formula}"
                );
                let [plain, doubled] = [&plain, &doubled].map(Motion::change_points);
                assert_eq!((plain.len(), doubled.len()), (2, 2), "{at}");
                for (one, other) in plain.iter().zip(doubled) {
                    assert!((one - other).abs() < 1e-9, "{at}: {one} {other}");
                }
            }
        }
    }
}

/// A dimension of a doubled link is set on all links of its body that have it.
#[test]
fn a_dimension_is_set_on_all_doubled_links() {
    let mut random = Random::new(42);
    let mut number = 0;
    for seed in 0..scaled(EACH) {
        let four_bars = [["A", "B"], ["B", "C"], ["C", "D"]].map(|ends| doubled(&mut random, ends));
        let body = doubled_body(&mut random, false, seed as usize % 3).1;
        for draft in four_bars.into_iter().chain([body]) {
            let motion = Motion::new(Mechanism::new(&draft).unwrap());
            let mechanism = motion.mechanism();
            for dimension in mechanism.dimensions() {
                if matches!(dimension, Dimension::X(_) | Dimension::Y(_)) {
                    continue;
                }
                let was = mechanism.value(dimension).unwrap();
                let value = was + random.within(0.005, 0.01) * [1.0, -1.0][seed as usize % 2];
                let at = format!("{seed} {dimension:?} {was} → {value}: {draft:?}");
                // A side of a straight plate is the greatest or the least that there is.
                let is_end = matches!(dimension, Dimension::Side(_, [1, _]));
                let changed = match motion.changed(dimension, value, motion.drawn_input()) {
                    Err(Refusal::LoopOpen { .. }) if is_end => continue,
                    changed => changed.unwrap_or_else(|refusal| panic!("{at}: {refusal:?}")),
                };
                number += 1;
                let (pose, after) = (changed.motion.pose::<1>(changed.input), changed.motion);
                let (pose, after) = (pose.unwrap(), after.mechanism());
                let off = (after.value(dimension).unwrap() - value).rem_euclid(TAU);
                assert!(off.min(TAU - off) < 1e-12, "{at}");
                assert_eq!(after.doubled(), mechanism.doubled(), "{at}");
                for one in after.dimensions() {
                    let (link, [from, to]) = match one {
                        Dimension::Length(link) => (link, [0, 1]),
                        Dimension::Side(link, ends) => (link, ends),
                        _ => continue,
                    };
                    let points = after.points_of(link);
                    let place = |point: usize| after.place(&pose, points[point]).place();
                    let off = (place(from) - place(to)).norm() - after.value(one).unwrap();
                    assert!(off.abs() < 1e-12, "{at}: {one:?} {off}");
                }
            }
        }
    }
    assert!(number > 15 * scaled(EACH), "{number}");
}

/// A point that only a doubled link has is where the shape of that link has it, not where it is drawn.
#[test]
fn points_of_a_doubled_link_are_those_of_its_shape() {
    let mut random = Random::new(40);
    for seed in 0..scaled(EACH) {
        let mut draft = doubled(&mut random, ["C", "B"]).point("E", 1.5, 3.0);
        let length = (draft.points[2].at - draft.points[1].at).norm();
        let third = Point::new(length / 2.0, -2.0);
        for link in &mut draft.links[1..3] {
            link.shape = Some(vec![Point::origin(), Point::new(length, 0.0)]);
        }
        let double = &mut draft.links[2];
        double.points.push("E".to_owned());
        double.shape.iter_mut().for_each(|shape| shape.push(third));
        // Halfway between the ends of the coupler and 2 aside, drawn a little farther.
        let [b, c] = [1, 2].map(|k| draft.points[k].at);
        let across = Vector::new(b.y - c.y, c.x - b.x) / length;
        draft.points[4].at = b + (c - b) / 2.0 + across * random.within(2.001, 2.02);
        let motion = Motion::new(Mechanism::new(&draft).unwrap());
        let mechanism = motion.mechanism();
        for input in [motion.drawn_input(), random.within(0.0, TAU)] {
            let pose = motion.pose::<1>(input).unwrap();
            let place = |name| {
                mechanism
                    .place(&pose, mechanism.point(name).unwrap())
                    .place()
            };
            for end in ["B", "C"] {
                let off = (place("E") - place(end)).norm() - third.coords.norm();
                assert!(off.abs() < 1e-12, "{seed} {end} at {input}: {off}");
            }
        }
    }
}

/// The driver of a link that doubles the frame is named.
#[test]
fn a_driver_of_the_frame_is_named() {
    let mut random = Random::new(41);
    let mut draft = doubled(&mut random, ["A", "D"]);
    draft.drivers.clear();
    let draft = draft.crank("double");
    let said = [Defect::WithItself("double".to_owned())];
    assert_eq!(Mechanism::new(&draft).unwrap_err(), said);
}

/// Spoiled by more than rounding they are refused.
#[test]
fn spoiled_ones_are_refused() {
    let mut random = Random::new(36);
    for family in families() {
        let Some(point) = family.spoils else { continue };
        for seed in 0..scaled(EACH) {
            let mut draft = (family.drawn)(&mut random);
            let off = size(&draft) * 10_f64.powf(random.within(-6.0, -1.5));
            let way = turned(random.within(0.0, TAU), off);
            let spoiled = draft.points.iter_mut().find(|one| one.name == point);
            spoiled.unwrap().at += way;
            let name = family.name;
            let defects = Mechanism::new(&draft).err().unwrap_or_default();
            let locked =
                |defect: &Defect| matches!(defect, Defect::Locked { .. } | Defect::Instant { .. });
            assert!(defects.iter().any(locked), "{name} {seed}: {defects:?}");
        }
    }
}

/// Whether the cranks are drawn within half a degree of a pose in line with their pivots, if they are cranks on a rod.
fn is_in_line(draft: &LinkageSpec) -> bool {
    let place = |name: &str| draft.points.iter().find(|point| point.name == name);
    let [Some(a), Some(b), Some(c)] = ["A0", "A1", "B0"].map(place) else {
        return false;
    };
    let [line, crank] = [b.at - a.at, c.at - a.at].map(|way| way.normalize());
    line.perp(&crank).abs() < 0.5_f64.to_radians()
}

/// As files with four decimals have them: made exact they move, and no point has moved by more than a few of these. A
/// drawing in line may have no offer: there the rounding outweighs the shape.
#[test]
fn nearly_exact_ones_are_made_exact() {
    let mut random = Random::new(37);
    for family in families()
        .into_iter()
        .filter(|family| family.spoils.is_some())
    {
        for seed in 0..scaled(EACH) / 4 {
            let name = family.name;
            let mut draft = (family.drawn)(&mut random);
            for point in &mut draft.points {
                point.at = (point.at * 1e4).map(f64::round) / 1e4;
            }
            if Mechanism::new(&draft).is_ok() {
                continue;
            }
            let Some(exact) = draft.made_exact() else {
                assert!(is_in_line(&draft), "{name} {seed}: {:?}", draft.points);
                continue;
            };
            // Near a singular pose more than the last digit has to change.
            let most = NEARLY * size(&draft);
            assert!(exact.by <= most, "{name} {seed}: {}", exact.by);
            let motion = Motion::new(Mechanism::new(&exact.spec).unwrap());
            assert_eq!(motion.cycle().is_full(), family.turns, "{name} {seed}");
        }
    }
}

/// Parallel cranks of other lengths let their rod move in the drawn pose only; cranks that are not parallel not even there.
#[test]
fn unequal_cranks_are_mobile_for_an_instant() {
    let cranks = |turns: [f64; 3]| {
        let mut draft = LinkageSpec::default();
        for (k, (length, turn)) in [1.0, 1.2, 0.8].into_iter().zip(turns).enumerate() {
            let (x, y) = (2.0 * k as f64, 0.3 * k as f64);
            let end = [x + length * f64::cos(turn), y + length * f64::sin(turn)];
            draft = draft.point(&format!("A{k}"), x, y);
            draft = draft.point(&format!("B{k}"), end[0], end[1]);
        }
        let draft = draft
            .fixed(&["A0", "A1", "A2"])
            .bar("rod", &["B0", "B1", "B2"]);
        let draft = draft
            .bar("crank", &["A0", "B0"])
            .bar("second", &["A1", "B1"]);
        draft.bar("third", &["A2", "B2"]).crank("crank")
    };
    let defects = |turns| Mechanism::new(&cranks(turns)).unwrap_err();
    let instant = |defect: &Defect| matches!(defect, Defect::Instant { links } if links.len() == 5);
    assert!(
        defects([1.0; 3]).iter().all(instant),
        "{:?}",
        defects([1.0; 3])
    );
    let locked = |defect: &Defect| matches!(defect, Defect::Locked { .. });
    assert!(defects([1.0, 1.4, 0.9]).iter().all(locked));
}

/// A pose that is looked at beside the drawn one may be in line: the cranks turn fully all the same.
#[test]
fn a_pose_beside_the_drawn_one_may_be_in_line() {
    let mut random = Random::new(38);
    for cranks in 3..=6 {
        for aside in [-0.02, -7e-3, -1e-3, 1e-3, 7e-3, 0.05] {
            for aside in [aside, aside + 1e-7] {
                let along = random.within(0.0, TAU);
                let draft = drawn_rods(&mut random, true, cranks, [along, along + aside]);
                let motion = Motion::new(Mechanism::new(&draft).unwrap());
                assert!(motion.cycle().is_full(), "{cranks} cranks {aside}");
            }
        }
    }
}

/// Six cranks drawn with four decimals, three degrees from in line.
#[test]
fn a_drawing_near_in_line_is_made_exact() {
    let pivots = [
        [0.7285, -0.1718],
        [1.6824, -0.3968],
        [3.8784, -0.9147],
        [5.5156, -1.3008],
        [7.4113, -1.7478],
        [8.6789, -2.0468],
    ];
    let ends = [
        [-0.1645, 0.0893],
        [0.7893, -0.1357],
        [2.9853, -0.6536],
        [4.6226, -1.0397],
        [6.5182, -1.4868],
        [7.7858, -1.7857],
    ];
    let mut draft = drawn_rods(&mut Random::new(0), true, 6, [0.0, 1.0]);
    for (name, at) in ["A", "B"].into_iter().zip([pivots, ends]) {
        for (k, at) in at.into_iter().enumerate() {
            let name = format!("{name}{k}");
            let drawn = draft.points.iter_mut().find(|point| point.name == name);
            drawn.unwrap().at = Point::new(at[0], at[1]);
        }
    }
    let exact = draft.made_exact().unwrap();
    assert!(exact.by <= 1e-3, "{}", exact.by);
    let motion = Motion::new(Mechanism::new(&exact.spec).unwrap());
    assert!(motion.cycle().is_full());
}

/// A point of the frame far off makes no two links one body.
#[test]
fn a_link_that_nearly_doubles_another_is_not_one_body_with_it() {
    let draft = doubled(&mut Random::new(43), ["B", "C"]).point("Z", 1e6, 0.0);
    let mut draft = draft.fixed(&["Z"]);
    let mechanism = Mechanism::new(&draft).unwrap();
    let coupler = Dimension::Length(mechanism.link("coupler").unwrap());
    let length = mechanism.value(coupler).unwrap();
    for (name, length) in [("coupler", length), ("double", length + 1e-3)] {
        let link = draft.links.iter_mut().find(|link| link.name == name);
        link.unwrap().shape = Some(vec![Point::origin(), Point::new(length, 0.0)]);
    }
    let defects = Mechanism::new(&draft).unwrap_err();
    assert!(
        matches!(defects[..], [Defect::Locked { .. }]),
        "{defects:?}"
    );
}

/// What the frame, or a plate on which another link lies, keeps is no dimension of a link that doubles it.
#[test]
fn dimensions_that_others_keep() {
    let mut random = Random::new(44);
    let mechanism = Mechanism::new(&doubled(&mut random, ["A", "D"])).unwrap();
    let [crank, double] = ["crank", "double"].map(|name| mechanism.link(name).unwrap());
    let [a, d] = ["A", "D"].map(|name| mechanism.point(name).unwrap());
    assert!(mechanism.value(Dimension::Length(crank)).is_some());
    for none in [Dimension::Length(double), Dimension::X(a), Dimension::Y(d)] {
        assert_eq!(mechanism.value(none), None, "{none:?}");
    }
    let mut draft = doubled(&mut random, ["B", "C"]).point("E", 1.5, 2.5);
    draft = draft.point("M", 1.0, 2.0).bar("arm", &["M", "E"]);
    for link in &mut draft.links {
        match &*link.name {
            "coupler" | "double" => link.points.push("M".to_owned()),
            "arm" => link.fixed_to = Some("double".to_owned()),
            _ => {}
        }
    }
    let mechanism = Mechanism::new(&draft).unwrap();
    let coupler = mechanism.link("coupler").unwrap();
    for none in [
        Dimension::Length(coupler),
        Dimension::Side(coupler, [0, 2]),
        Dimension::Corner(coupler, 2),
    ] {
        assert_eq!(mechanism.value(none), None, "{none:?}");
    }
}

/// The change points of parallelograms, whatever their size: one at each end of the turn.
#[test]
fn change_points_at_the_beginning_of_a_turn_are_found() {
    let mut random = Random::new(46);
    for scale in [1.0, 1e6, 1e-6] {
        for _ in 0..scaled(100) {
            let base = Vector::new(random.within(1.5, 3.5) * scale, 0.0);
            let arm = turned(random.within(0.1, 3.0), random.within(0.4, 1.2) * scale);
            let draft = with(LinkageSpec::default().point("A", 0.0, 0.0), "D", base);
            let draft = with(with(draft, "B", arm), "C", base + arm)
                .fixed(&["A", "D"])
                .bar("crank", &["A", "B"])
                .bar("coupler", &["B", "C"])
                .bar("rocker", &["D", "C"])
                .crank("crank");
            let motion = Motion::new(Mechanism::new(&draft).unwrap());
            assert_eq!(motion.change_points().len(), 2, "{draft:?}");
        }
    }
}
