//! Several driven pairs at once: random excavators, and a platform.

use assur::mechanism::LinkageSpec;

use super::{assert_smooth, motion, moved, on_line, place};

/// Random numbers that are the same every time.
pub(crate) struct Random(pub(crate) u64);

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
pub(crate) fn excavator(random: &mut Random, rate: f64) -> LinkageSpec {
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
    let mut draft = LinkageSpec::default();
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

#[test]
fn cylinders_of_excavators() {
    let mut random = Random(7);
    for case in 0..40 {
        let rate = random.within(-0.5, 0.5);
        let motion = motion(&excavator(&mut random, rate));
        let home = motion.drawn_input();
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
            for constraint in &motion.mechanism().constraints() {
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

/// A point of the drawing stays where it is drawn.
#[test]
fn the_drawn_row_is_the_drawing() {
    let mut random = Random(11);
    for _ in 0..20 {
        let draft = excavator(&mut random, 0.2);
        let motion = motion(&draft);
        for point in &draft.points {
            let off = place(&motion, &point.name, motion.drawn_input())[0] - point.at.coords;
            assert!(off.norm() < 1e-12, "{point:?}");
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
    let mut draft = LinkageSpec::default();
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
    let home = motion.drawn_input();
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
