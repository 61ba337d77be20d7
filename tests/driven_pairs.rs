//! Drivers between links that both move: arms of robots, hydraulic cylinders, platforms.

use std::f64::consts::{PI, TAU};

use assur::gears::Mesh;
use assur::mechanism::{Defect, Dimension, Draft, DraftDriver, DraftGear, FRAME, Mechanism};
use assur::motion::{DeadPointKind, Motion};
use assur::{Jet, Vector};

/// With a driver: a link that is turned against another one.
fn turned(mut draft: Draft, link: &str, base: &str, rate: f64) -> Draft {
    draft.drivers.push(DraftDriver::Crank {
        link: link.to_owned(),
        base: base.to_owned(),
        rate,
    });
    draft
}

/// With a driver: a slide over a range.
fn moved(mut draft: Draft, slide: usize, range: [f64; 2], rate: f64) -> Draft {
    draft
        .drivers
        .push(DraftDriver::Slide { slide, range, rate });
    draft
}

fn motion(draft: &Draft) -> Motion {
    Motion::new(Mechanism::new(draft).unwrap())
}

fn along(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// Less whole turns.
fn reduced(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// An angle and its derivatives by the input.
fn angle(motion: &Motion, link: &str, input: f64) -> [f64; 3] {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(input).unwrap();
    let angle = mechanism.angle(&pose, mechanism.link(link).unwrap());
    [0, 1, 2].map(|order| angle.derivative(order))
}

fn place(motion: &Motion, point: &str, input: f64) -> [Vector; 3] {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(input).unwrap();
    let place = mechanism.place(&pose, mechanism.point(point).unwrap());
    [
        place.place().coords,
        place.derivative(1),
        place.derivative(2),
    ]
}

fn assert_angle(found: [f64; 3], exact: [f64; 3], within: f64, what: &str) {
    let off = reduced(found[0] - exact[0]).abs();
    assert!(off < within, "{what}: {found:?} {exact:?}");
    for order in 1..3 {
        let off = (found[order] - exact[order]).abs();
        assert!(
            off < within * (1.0 + exact[order].abs()),
            "{what}: {found:?} {exact:?}"
        );
    }
}

/// The derivatives of every point are those that differences of its places show.
fn assert_smooth(motion: &Motion, input: f64, h: f64) {
    let mechanism = motion.mechanism();
    for point in mechanism.points() {
        let at = |k: f64| place(motion, point, input + k * h)[0];
        let [_, first, second] = place(motion, point, input);
        let one = (at(-2.0) - at(2.0) + (at(1.0) - at(-1.0)) * 8.0) / (12.0 * h);
        let two =
            ((at(1.0) + at(-1.0)) * 16.0 - at(2.0) - at(-2.0) - at(0.0) * 30.0) / (12.0 * h * h);
        let scale = mechanism.size() + first.norm() + second.norm();
        assert!(
            (one - first).norm() < 1e-8 * scale,
            "{point} {input}: {one} {first}"
        );
        assert!(
            (two - second).norm() < 1e-5 * scale,
            "{point} {input}: {two} {second}"
        );
    }
}

/// Three links one on the other.
fn arm() -> Draft {
    Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.2, 0.5)
        .point("C", 1.0, 1.6)
        .point("D", 0.3, 1.9)
        .fixed(&["A"])
        .bar("a", &["A", "B"])
        .bar("b", &["B", "C"])
        .bar("c", &["C", "D"])
}

/// Its drawn angles and its lengths.
fn drawn_arm() -> [[f64; 3]; 2] {
    let ways = [[1.2, 0.5], [-0.2, 1.1], [-0.7, 0.3_f64]];
    [
        ways.map(|[x, y]| f64::atan2(y, x)),
        ways.map(|[x, y]| f64::hypot(x, y)),
    ]
}

/// The angles of a robot's arm add up.
#[test]
fn arms_of_a_robot() {
    let [drawn, lengths] = drawn_arm();
    let rates = [-0.5, 2.0];
    let draft = turned(
        turned(arm().crank("a"), "b", "a", rates[0]),
        "c",
        "b",
        rates[1],
    );
    let motion = motion(&draft);
    assert_eq!(motion.cycle().period(), Some(2.0 * TAU));
    for k in 0..100 {
        let input = 2.0 * TAU * f64::from(k) / 100.0;
        let off = input - drawn[0];
        let turns = [1.0, 1.0 + rates[0], 1.0 + rates[0] + rates[1]];
        let angles = [0, 1, 2].map(|link| drawn[link] + turns[link] * off);
        for ((link, exact), rate) in ["a", "b", "c"].into_iter().zip(angles).zip(turns) {
            assert!(
                (angle(&motion, link, input)[0] - exact).abs() < 1e-12,
                "{link} {input}"
            );
            assert_angle(angle(&motion, link, input), [exact, rate, 0.0], 1e-13, link);
        }
        let terms = || lengths.into_iter().zip(angles).zip(turns);
        let end = terms().map(|((l, at), _)| l * along(at)).sum::<Vector>();
        let second = terms()
            .map(|((l, at), rate)| -l * rate * rate * along(at))
            .sum::<Vector>();
        let found = place(&motion, "D", input);
        assert!((found[0] - end).norm() < 1e-13, "{input}");
        assert!((found[2] - second).norm() < 1e-12, "{input}");
    }
}

/// The base may be named as what is turned: the same pair, counted the other way.
#[test]
fn a_pair_counted_the_other_way() {
    let [drawn, _] = drawn_arm();
    let draft = turned(turned(arm(), FRAME, "a", 1.0), "b", "c", 1.0);
    let draft = turned(draft, "a", "b", 0.0);
    let motion = motion(&draft);
    assert!(reduced(motion.home() + drawn[0]).abs() < 1e-14);
    for input in [-2.0, motion.home(), 0.4, 3.0] {
        let off = input - motion.home();
        // θ_a = −φ; θ_a − θ_b stays; θ_b − θ_c grows with φ.
        assert_angle(
            angle(&motion, "a", input),
            [drawn[0] - off, -1.0, 0.0],
            1e-13,
            "a",
        );
        assert_angle(
            angle(&motion, "b", input),
            [drawn[1] - off, -1.0, 0.0],
            1e-13,
            "b",
        );
        assert_angle(
            angle(&motion, "c", input),
            [drawn[2] - 2.0 * off, -2.0, 0.0],
            1e-13,
            "c",
        );
    }
}

/// A telescopic arm that turns: x + iy = s e^(iφ), s = s₀ + u (φ − φ₀).
#[test]
fn a_slide_on_an_arm() {
    let rate = 0.25;
    let draft = Draft::default()
        .point("A", 0.0, 0.0)
        .point("U", 1.0, 0.0)
        .point("P", 2.0, 0.0)
        .fixed(&["A"])
        .bar("arm", &["A", "U"])
        .bar("rod", &["P"])
        .slide("rod", "P", "arm", ["A", "U"])
        .crank("arm");
    let motion = motion(&moved(draft.clone(), 0, [1.0, 3.0], rate));
    for input in [-3.5, -1.0, 0.0, 2.0, 3.9] {
        let s = 2.0 + rate * input;
        let [ahead, left] = [along(input), along(input + 0.5 * PI)];
        let found = place(&motion, "P", input);
        assert!((found[0] - s * ahead).norm() < 1e-14);
        assert!((found[1] - rate * ahead - s * left).norm() < 1e-14);
        assert!((found[2] - 2.0 * rate * left + s * ahead).norm() < 1e-14);
    }
    let ends: Vec<_> = motion
        .dead_points()
        .iter()
        .map(|end| (end.kind, end.input.round()))
        .collect();
    assert_eq!(
        ends,
        [(DeadPointKind::Range, -4.0), (DeadPointKind::Range, 4.0)]
    );

    // The rod is solved first and the line follows it: pushed by the other end.
    let pushed = Draft::default()
        .point("A", 0.0, 0.0)
        .point("U", 1.0, 0.0)
        .point("P", 2.0, 0.0)
        .point("Q", 2.0, 1.0)
        .fixed(&["P"])
        .bar("rod", &["P", "Q"])
        .bar("cylinder", &["A", "U"])
        .slide("rod", "P", "cylinder", ["A", "U"])
        .crank("rod");
    let motion = self::motion(&moved(pushed, 0, [1.0, 3.0], rate));
    for input in [-1.0, 0.5 * PI, 3.0] {
        let turn = input - 0.5 * PI;
        let found = place(&motion, "A", input);
        let exact = Vector::new(2.0, 0.0) - (2.0 + rate * turn) * along(turn);
        assert!((found[0] - exact).norm() < 1e-14, "{input}");
    }
}

/// A lever D–B that a cylinder A turns; its rod's hinge is off the line of the cylinder.
fn cylinder(range: [f64; 2]) -> Draft {
    let draft = Draft::default()
        .point("A", 0.0, 0.0)
        .point("U", 1.0, 0.0)
        .point("B", 3.0, 0.5)
        .point("D", 4.0, -1.0)
        .fixed(&["A", "D"])
        .bar("cylinder", &["A", "U"])
        .bar("rod", &["B"])
        .bar("lever", &["D", "B"])
        .slide("rod", "B", "cylinder", ["A", "U"]);
    moved(draft, 0, range, 1.0)
}

/// The angle at D of the triangle A D B with two given sides, from the third one c and its rates.
fn angle_opposite(c: Jet<3>, a: f64, b: f64) -> [f64; 3] {
    let [c, first, second] = [0, 1, 2].map(|order| c.derivative(order));
    let cos = (a * a + b * b - c * c) / (2.0 * a * b);
    let sin = (1.0 - cos * cos).sqrt();
    // sin γ γ′ = c c′ / (ab).
    let rate = c * first / (a * b * sin);
    let change = ((first * first + c * second) / (a * b) - cos * rate * rate) / sin;
    [cos.acos(), rate, change]
}

/// The hinge of the rod from that of the cylinder: √(s² + e²), with two derivatives by s.
fn reach(s: f64, e: f64) -> Jet<3> {
    let c = s.hypot(e);
    Jet::of_derivatives([c, s / c, e * e / c.powi(3)])
}

#[test]
fn a_cylinder_turns_a_lever() {
    let (e, to_a) = (0.5, f64::atan2(1.0, -4.0));
    let (length, base) = (1.0_f64.hypot(1.5), 4.0_f64.hypot(1.0));
    let lever = |s: f64| {
        let [angle, rate, change] = angle_opposite(reach(s, e), length, base);
        // B is above the line from D to A: clockwise from it.
        [to_a - angle, -rate, -change]
    };
    let within = motion(&cylinder([2.7, 4.5]));
    assert!((within.home() - 3.0).abs() < 1e-15);
    for k in 0..=18 {
        let s = 2.7 + 0.1 * f64::from(k);
        assert_angle(angle(&within, "lever", s), lever(s), 1e-11, &format!("{s}"));
    }
    assert!(
        within
            .dead_points()
            .iter()
            .all(|end| end.kind == DeadPointKind::Range)
    );
    let ends: Vec<f64> = within.dead_points().iter().map(|end| end.input).collect();
    assert!(
        (ends[0] - 2.7).abs() < 1e-9 && (ends[1] - 4.5).abs() < 1e-9,
        "{ends:?}"
    );

    // Further than the lever goes: it is in line with D–A.
    let beyond = motion(&cylinder([0.1, 9.0]));
    let ends = beyond.dead_points();
    assert!(ends.iter().all(|end| end.kind == DeadPointKind::Singular));
    let exact = [base - length, base + length].map(|c| (c * c - e * e).sqrt());
    for (end, exact) in ends.iter().zip(exact) {
        assert!((end.input - exact).abs() < 1e-7, "{} {exact}", end.input);
        let links: Vec<&str> = beyond.links_at(end).collect();
        assert_eq!(links, ["cylinder", "rod", "lever"]);
    }
}

/// A coupler turned against the crank it hangs on: |AC|² = a² + b² + 2ab cos φ.
#[test]
fn a_coupler_turned_against_its_crank() {
    let draft = Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("C", 2.5, 3.0)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("a", &["A", "B"])
        .bar("b", &["B", "C"])
        .bar("c", &["D", "C"]);
    let motion = motion(&turned(draft, "b", "a", 1.0));
    assert!(motion.cycle().is_full());
    assert_eq!(motion.cycle().period(), Some(TAU));
    assert!((motion.home() - f64::atan2(3.0, 1.5)).abs() < 1e-15);
    let (a, b) = (1.0, 1.5_f64.hypot(3.0));
    for k in 0..72 {
        let input = TAU * f64::from(k) / 72.0 + 0.01;
        let [square, first, second] = [
            a * a + b * b + 2.0 * a * b * input.cos(),
            -2.0 * a * b * input.sin(),
            -2.0 * a * b * input.cos(),
        ];
        let diagonal = square.sqrt();
        let rate = first / (2.0 * diagonal);
        let diagonal =
            Jet::of_derivatives([diagonal, rate, (0.5 * second - rate * rate) / diagonal]);
        let [angle_at_d, rate, change] = angle_opposite(diagonal, b, 4.0);
        let exact = [PI - angle_at_d, -rate, -change];
        assert_angle(
            angle(&motion, "c", input),
            exact,
            1e-11,
            &format!("{input}"),
        );
        let [[a, ..], [b, ..]] = ["a", "b"].map(|link| angle(&motion, link, input));
        assert!(reduced(b - a - input).abs() < 1e-13);
    }
    // The row of the drawn input is the drawing.
    assert!((place(&motion, "B", motion.home())[0] - Vector::new(1.0, 0.0)).norm() < 1e-13);
    assert_eq!(motion.mechanism().formula(), "I(a,b) → II₂(a+b,c)");
}

/// Random numbers that are the same every time.
struct Random(u64);

impl Random {
    /// Between 0 and 1.
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}

/// An excavator's boom and stick, each with a cylinder; the second at a rate.
fn excavator(random: &mut Random, rate: f64) -> Draft {
    let mut near = |x: f64, y: f64| (x + random.within(-0.3, 0.3), y + random.within(-0.3, 0.3));
    let places = [
        ("O", near(0.0, 0.0)),
        ("A", near(1.5, -0.5)),
        ("B", near(2.5, 2.0)),
        ("U", near(2.0, 0.4)),
        ("E", near(2.6, 3.2)),
        ("J", near(5.0, 3.0)),
        ("F", near(4.3, 4.2)),
        ("V", near(3.6, 3.8)),
        ("T", near(6.0, 0.5)),
    ];
    let mut draft = Draft::default();
    for (name, (x, y)) in places {
        draft = draft.point(name, x, y);
    }
    let draft = draft
        .fixed(&["O", "A"])
        .bar("boom", &["O", "B", "E", "J"])
        .bar("lower", &["A", "U"])
        .bar("piston", &["B"])
        .bar("stick", &["J", "F", "T"])
        .bar("upper", &["E", "V"])
        .bar("plunger", &["F"])
        .slide("piston", "B", "lower", ["A", "U"])
        .slide("plunger", "F", "upper", ["E", "V"]);
    let draft = moved(draft, 0, [0.5, 8.0], 1.0);
    moved(draft, 1, [0.2, 8.0], rate)
}

/// Where the point of a slide is from the start of its line: along the line and to the left of it.
fn on_line(motion: &Motion, [from, to, point]: [&str; 3], input: f64) -> [f64; 2] {
    let [from, to, point] = [from, to, point].map(|name| place(motion, name, input)[0]);
    let along = (to - from).normalize();
    [along.dot(&(point - from)), along.perp(&(point - from))]
}

#[test]
fn cylinders_of_excavators() {
    let mut random = Random(7);
    for case in 0..40 {
        let rate = random.within(-0.5, 0.5);
        let motion = motion(&excavator(&mut random, rate));
        let home = motion.home();
        let [_, off] = on_line(&motion, ["A", "U", "B"], home);
        let [start, off_above] = on_line(&motion, ["E", "V", "F"], home);
        for part in [-0.8, -0.3, 0.0, 0.4, 0.7] {
            let ends: Vec<f64> = motion.dead_points().iter().map(|end| end.input).collect();
            let end = if part < 0.0 { ends[0] } else { ends[1] };
            let input = home + f64::abs(part) * (end - home);
            let what = format!("{case} {input}");
            let [way, left] = on_line(&motion, ["A", "U", "B"], input);
            assert!(
                (way - input).abs() < 1e-12 && (left - off).abs() < 1e-12,
                "{what}"
            );
            let [way, left] = on_line(&motion, ["E", "V", "F"], input);
            assert!(
                (way - start - rate * (input - home)).abs() < 1e-12,
                "{what}"
            );
            assert!((left - off_above).abs() < 1e-12, "{what}");
            for constraint in motion.mechanism().constraints() {
                let pose = motion.pose::<3>(input).unwrap();
                for order in 0..3 {
                    let residual = motion
                        .mechanism()
                        .sides(&pose, constraint, order)
                        .residual();
                    let scale = place(&motion, "T", input)[order].norm() + 10.0;
                    assert!(
                        residual.abs() < 1e-11 * scale,
                        "{what} {constraint:?} {order}"
                    );
                }
            }
            assert_smooth(&motion, input, 1e-3);
        }
    }
}

/// The planar platform on three cylinders, 3-RPR: Class III, all three drivers within its group.
#[test]
fn a_platform_on_three_cylinders() {
    let [feet, top] = [
        [("A", 0.0, 0.0), ("B", 6.0, 0.0), ("C", 3.0, 6.0)],
        [("P", 3.0, 1.2), ("Q", 3.7, 2.4), ("R", 2.3, 2.4)],
    ];
    let mut draft = Draft::default();
    for (name, x, y) in feet.into_iter().chain(top) {
        draft = draft.point(name, x, y);
    }
    draft = draft
        .bar("platform", &["P", "Q", "R"])
        .fixed(&["A", "B", "C"]);
    for (slide, (foot, head)) in feet.into_iter().zip(top).enumerate() {
        let (end, cylinder, rod) = (
            format!("E{slide}"),
            format!("leg{slide}"),
            format!("rod{slide}"),
        );
        // A point of the line halfway.
        draft = draft
            .point(&end, 0.5 * (foot.1 + head.1), 0.5 * (foot.2 + head.2))
            .bar(&cylinder, &[foot.0, &end])
            .bar(&rod, &[head.0])
            .slide(&rod, head.0, &cylinder, [foot.0, &end]);
    }
    let rates = [1.0, -0.3, 0.4];
    for (slide, rate) in rates.into_iter().enumerate() {
        draft = moved(draft, slide, [0.5, 6.0], rate);
    }
    let motion = motion(&draft);
    assert_eq!(motion.mechanism().structure().class(), 3);
    let home = motion.home();
    let lengths =
        [0, 1, 2].map(|leg: usize| (feet[leg].1 - top[leg].1).hypot(feet[leg].2 - top[leg].2));
    assert!((home - lengths[0]).abs() < 1e-15);
    for off in [-0.4, -0.1, 0.0, 0.2, 0.5] {
        for leg in 0..3 {
            let way =
                place(&motion, top[leg].0, home + off)[0] - place(&motion, feet[leg].0, home)[0];
            assert!(
                (way.norm() - lengths[leg] - rates[leg] * off).abs() < 1e-12,
                "{leg} {off}"
            );
        }
        assert_smooth(&motion, home + off, 1e-3);
    }
}

/// A planet turned against its carrier around a sun that stands: z₁ θ_c = z₂ φ.
#[test]
fn a_planet_turned_against_its_carrier() {
    let mut draft = Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 3.0, 0.0)
        .point("W", 3.0, 1.0)
        .fixed(&["A"])
        .bar("carrier", &["A", "B"])
        .bar("planet", &["B", "W"]);
    draft.gears.push(DraftGear {
        links: [FRAME.to_owned(), "planet".to_owned()],
        carrier: "carrier".to_owned(),
        teeth: [40.0, 20.0],
        mesh: Mesh::External,
    });
    let motion = motion(&turned(draft, "planet", "carrier", 1.0));
    let home = motion.home();
    assert!((home - 0.5 * PI).abs() < 1e-15);
    for off in [-9.0, -2.0, 0.0, 1.0, 7.0] {
        let found = angle(&motion, "carrier", home + off);
        assert_angle(found, [0.5 * off, 0.5, 0.0], 1e-12, "carrier");
        let found = angle(&motion, "planet", home + off);
        assert_angle(found, [0.5 * PI + 1.5 * off, 1.5, 0.0], 1e-12, "planet");
    }
}

/// A length is dragged: the input stays, and so does what further drivers make of it.
#[test]
fn lengths_change_under_the_drivers() {
    let lever = motion(&cylinder([2.7, 4.5]));
    let link = lever.mechanism().link("lever").unwrap();
    let changed = lever.changed(Dimension::Length(link), 2.0, 3.2).unwrap();
    assert!(!changed.gave_way);
    assert!((changed.input - 3.2).abs() < 1e-12);
    let [angle_at_d, ..] = angle_opposite(reach(3.2, 0.5), 2.0, 4.0_f64.hypot(1.0));
    let [found, ..] = angle(&changed.motion, "lever", 3.2);
    assert!(reduced(found - f64::atan2(1.0, -4.0) + angle_at_d).abs() < 1e-12);

    let [drawn, _] = drawn_arm();
    let arm = motion(&turned(
        turned(arm().crank("a"), "b", "a", 0.5),
        "c",
        "b",
        -1.0,
    ));
    let link = arm.mechanism().link("b").unwrap();
    let changed = arm.changed(Dimension::Length(link), 2.5, 1.3).unwrap();
    let off = 1.3 - drawn[0];
    for (link, turns) in [("b", 1.5), ("c", 0.5)] {
        let exact = drawn[usize::from(link == "c") + 1] + turns * off;
        let [found, ..] = angle(&changed.motion, link, 1.3);
        assert!(reduced(found - exact).abs() < 1e-12, "{link}");
    }
}

/// Another driver of the excavator's: what was driven within a group is so again.
#[test]
fn a_cylinder_as_the_input_or_not() {
    let motion = motion(&excavator(&mut Random(3), 0.3));
    assert_eq!(
        motion.mechanism().drivable(),
        ["boom", "lower", "piston", "plunger"]
    );
    let input = motion.home() + 0.1;
    let driver = motion.driver("plunger").unwrap();
    let other = motion.driven_by(&driver, input).unwrap();
    assert_eq!(
        other.motion.mechanism().rates().collect::<Vec<f64>>(),
        [1.0, 1.0 / 0.3]
    );
    let [one, two] = [
        place(&motion, "T", input)[0],
        place(&other.motion, "T", other.input)[0],
    ];
    assert!((one - two).norm() < 1e-12);
    let further = place(&other.motion, "T", other.input + 0.03)[0];
    assert!((further - place(&motion, "T", input + 0.1)[0]).norm() < 1e-11);
}

#[test]
fn what_cannot_be_driven_is_named() {
    let named = |draft: &Draft| Mechanism::new(draft).unwrap_err();
    let names = |links: &[&str]| {
        links
            .iter()
            .map(|link| (*link).to_owned())
            .collect::<Vec<_>>()
    };
    // Links that share no point.
    let apart = turned(turned(arm().crank("a"), "c", "a", 1.0), "b", "a", 1.0);
    let links = ["c", "a"].map(str::to_owned);
    assert_eq!(named(&apart), [Defect::NotHinged { links }]);
    // Twice the same pair, whichever way it is told.
    let twice = turned(turned(arm().crank("a"), "b", "a", 1.0), "a", "b", 1.0);
    let locked = Defect::Locked {
        mobility: 3,
        links: names(&["b", "a"]),
    };
    assert_eq!(named(&twice), [locked]);
    // A part of the base.
    let mut own = arm().bar("w", &["A", "B"]);
    own.links[3].fixed_to = Some("a".to_owned());
    let own = turned(turned(own.crank("a"), "w", "a", 1.0), "c", "b", 1.0);
    assert_eq!(named(&own), [Defect::WithItself("w".to_owned())]);
    // A coupler against its crank, and the crank as well: too many.
    let mut closed = arm().crank("a");
    closed.frame.push("D".to_owned());
    let links = names(&["a", "b", "c"]);
    let defects = named(&turned(closed, "b", "a", 1.0));
    assert!(
        matches!(&defects[..], [Defect::Locked { links: locked, .. }] if links.iter().all(|link| locked.contains(link))),
        "{defects:?}"
    );
}

/// A point of the drawing stays where it is drawn.
#[test]
fn the_drawn_row_is_the_drawing() {
    let mut random = Random(11);
    for _ in 0..20 {
        let draft = excavator(&mut random, 0.2);
        let motion = motion(&draft);
        for point in &draft.points {
            let off = place(&motion, &point.name, motion.home())[0] - point.at.coords;
            assert!(off.norm() < 1e-12, "{point:?}");
        }
    }
}

/// Every pair between moving links of the catalogue's linkages, as the driver of the same linkage from the same pose:
/// its poses are those of the motion as it was, with derivatives by the other input.
#[cfg(not(target_family = "wasm"))]
#[test]
fn any_pair_of_the_catalogue_drives() {
    let mut tried = 0;
    for name in assur_file::catalogue() {
        let draft = assur_file::from_catalogue(name).unwrap().unwrap().draft();
        let as_it_was = motion(&draft);
        let Some(input) = regular(&as_it_was) else {
            continue;
        };
        if draft.drivers.len() > 1 {
            continue;
        }
        let pose = as_it_was.pose::<1>(input).unwrap();
        let drawn = Draft {
            drivers: Vec::new(),
            ..as_it_was.mechanism().drawn_in(&pose)
        };
        for (k, slide) in drawn.slides.iter().enumerate() {
            if slide.on != FRAME {
                let line = [&slide.line[0], &slide.line[1], &slide.point].map(String::as_str);
                let way = |input| on_line(&as_it_was, line, input)[0];
                let wide = [way(input) - 1e6, way(input) + 1e6];
                let driven = moved(drawn.clone(), k, wide, 1.0);
                tried += usize::from(drives(&as_it_was, input, &driven, way, name));
            }
        }
        for (k, link) in drawn.links.iter().enumerate() {
            for base in &drawn.links[..k] {
                let angles = |input: f64| {
                    [&link.name, &base.name].map(|name| angle(&as_it_was, name, input)[0])
                };
                let against = |input: f64| {
                    let [link, base] = angles(input);
                    link - base
                };
                let driven = turned(drawn.clone(), &link.name, &base.name, 1.0);
                tried += usize::from(drives(&as_it_was, input, &driven, against, name));
            }
        }
    }
    assert!(tried > 80, "{tried}");
}

/// An input where a motion is far from its ends.
fn regular(motion: &Motion) -> Option<f64> {
    let [from, to] = motion.cycle().axis();
    let input = if motion.dead_points().is_empty() {
        motion.home() + 0.3
    } else {
        0.45 * from + 0.55 * to
    };
    motion.pose::<3>(input).ok().map(|_| input)
}

/// Whether another driver drives a linkage; then it must do so as the one before, from an input of that one on.
fn drives(
    was: &Motion,
    input: f64,
    draft: &Draft,
    coordinate: impl Fn(f64) -> f64,
    name: &str,
) -> bool {
    let mechanism = match Mechanism::new(draft) {
        Ok(mechanism) => mechanism,
        // No pair at all, or one that does not move, or more wheels than it may have.
        Err(defects) => {
            let known = |defect: &Defect| {
                matches!(
                    defect,
                    Defect::NotHinged { .. }
                        | Defect::WithItself(_)
                        | Defect::Locked { .. }
                        | Defect::Underdriven { .. }
                )
            };
            assert!(
                defects.iter().all(known),
                "{name} {:?}: {defects:?}",
                draft.drivers
            );
            return false;
        }
    };
    let what = format!("{name} {:?}", draft.drivers);
    let now = Motion::new(mechanism);
    let h = 1e-4 * was.mechanism().size().min(1.0);
    let rate = (coordinate(input + h) - coordinate(input - h)) / (2.0 * h);
    if rate.abs() < 0.05 {
        return false;
    }
    for off in [0.0, 0.01, -0.01] {
        let by = coordinate(input + off) - coordinate(input);
        let pose = now.pose::<1>(now.home() + by);
        let pose = pose.unwrap_or_else(|why| panic!("{what} {off}: {why}"));
        for point in was.mechanism().points() {
            let found = now
                .mechanism()
                .place(&pose, now.mechanism().point(point).unwrap())
                .place();
            let exact = place(was, point, input + off)[0];
            assert!(
                (found.coords - exact).norm() < 1e-9 * was.mechanism().size(),
                "{what} {point} {off}"
            );
        }
    }
    assert_smooth(&now, now.home(), 1e-4);
    true
}
