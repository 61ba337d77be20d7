//! Doubled links.

use super::*;

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
                assert_eq!((mobility.by_rank, mobility.q()), (1, q), "{at}");
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
    let said = [Defect::WithItself {
        link: "double".to_owned(),
    }];
    assert_eq!(Mechanism::new(&draft).unwrap_err(), said);
}
