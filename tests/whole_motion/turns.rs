//! Angles over whole turns, and changes of groups in any unit.

use super::*;

/// The angle of a crank and its rocker grows by a turn with each cycle, as the crank's own does.
#[test]
fn an_angle_between_links_turns() {
    let motion = crank_rocker();
    let between = quantity(&motion, "rocker-crank.between");
    let profile = OutputProfile::new(&motion, between).unwrap();
    assert_eq!(profile.swings(), [Swing::Turns]);
    let travel = profile.travels()[0];
    assert!(travel >= TAU - 1e-12, "{travel}");
    // It goes on over the end of the cycle.
    let dwell = profile.dwell(0.1).unwrap();
    for k in 0..=20 {
        let input = dwell.arc[0] + dwell.length() * f64::from(k) / 20.0;
        let row = motion.row(
            &[Column {
                quantity: between,
                order: 0,
            }],
            input,
        );
        let value = row.values[0].unwrap();
        let within = dwell.band[0] - 1e-9..=dwell.band[1] + 1e-9;
        assert!(within.contains(&value), "{value} {dwell:?}");
    }
}

/// A deltoid whose links lie on each other at the start of its cycle, where coupler and rocker swing freely: beyond the
/// cycle angles go on, and an angle that only grows has its dwell.
#[test]
fn a_deltoid_goes_on_beyond_its_cycle() {
    // A kite of two long and two short links, the crank and the frame short.
    let motion = moved(
        &LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("C", 2.0, 2.0)
            .point("D", 1.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank"),
    );
    assert!(motion.cycle().is_full());
    let period = motion.cycle().period().unwrap();
    assert!(motion.change_points().contains(&0.0));
    let mechanism = motion.mechanism();
    for link in ["crank", "coupler", "rocker"] {
        let angle = quantity(&motion, &format!("{link}.angle"));
        let columns = [Column {
            quantity: angle,
            order: 0,
        }];
        let value = |input: f64| motion.row(&columns, input).values[0].unwrap();
        let [early, later] = [1.0, 1.0 + period].map(value);
        let by_steps = (0..3600).map(|k| {
            let at = |k: f64| {
                let input = 1.0 + period * k / 3600.0;
                let pose = motion.pose::<1>(input.rem_euclid(period));
                pose.map(|pose| {
                    mechanism
                        .angle(&pose, mechanism.link(link).unwrap())
                        .value()
                })
            };
            let [Ok(a), Ok(b)] = [f64::from(k), f64::from(k) + 1.0].map(at) else {
                return 0.0;
            };
            let by = b - a;
            by - TAU * (by / TAU).round()
        });
        let gained: f64 = by_steps.sum();
        assert!(
            (later - early - gained).abs() < 0.1,
            "{link}: {early} {later} {gained}"
        );
        let profile = OutputProfile::new(&motion, angle).unwrap();
        assert!(profile.dwell(0.1).is_some(), "{link}");
        // Zeros are those at which a fine sweep over the cycle changes its sign.
        let [found, ..] = motion
            .features(&[angle], InputRate::ANALOGUES)
            .unwrap()
            .swap_remove(0);
        let sweep = (0..36_000).filter_map(|k| {
            let input = period * (f64::from(k) + 0.5) / 36_000.0;
            let pose = motion.pose::<1>(input).ok()?;
            Some(angle.of(mechanism, &pose).value())
        });
        let sweep: Vec<f64> = sweep.collect();
        let passes = sweep.windows(2).filter(|pair| pair[0] * pair[1] < 0.0);
        let inside = found
            .zeros
            .iter()
            .filter(|zero| **zero > 1e-3 && **zero < period - 1e-3);
        assert_eq!(inside.count(), passes.count(), "{link}: {:?}", found.zeros);
    }
}

/// A hinge that is set so far off that the points of a guide are one place beside it: they are at fault, not the links of the
/// first step of the plan.
#[test]
fn a_guide_without_a_direction_is_named() {
    let motion = moved(
        &LinkageSpec::default()
            .point("O", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("A", 4.0, 0.0)
            .point("P", 3.0, 0.25)
            .point("T", 2.0, 0.5)
            .point("S", 2.0, -3.0)
            .point("G", 0.0, -3.0)
            .point("H", 1e-5, -3.0)
            .fixed(&["O", "A", "G", "H"])
            .bar("crank", &["O", "B"])
            .bar("block", &["B"])
            .bar("rocker", &["A", "P", "T"])
            .bar("rod", &["B", "S"])
            .bar("slider", &["S"])
            .slide("block", "B", "rocker", ["P", "T"])
            .slide("slider", "S", "frame", ["G", "H"])
            .crank("crank"),
    );
    let point = motion.mechanism().point("A").unwrap();
    let refused = motion.changed(Dimension::X(point), 1e5, 0.5 * PI);
    let refused = refused.unwrap_err();
    let Refusal::Defects(defects) = refused else {
        panic!("{refused:?}");
    };
    let [Defect::Coincident { link, points }] = &defects[..] else {
        panic!("{defects:?}");
    };
    assert_eq!(
        (link.as_str(), points),
        ("frame", &["G", "H"].map(str::to_owned))
    );
}

/// A linkage drawn in any unit of length can be changed: determinants of its groups are not beyond all numbers.
#[test]
fn groups_in_any_unit_can_be_changed() {
    for name in ["class4-order2", "class4-dwell", "class5"] {
        let plain = assur_file::from_catalogue(name).unwrap().unwrap();
        let plain = plain.mechanism().unwrap();
        for unit in [1.0, 1e-9, 1e8, 1e-40, 1e-60] {
            let mut draft = plain.spec().clone();
            for point in &mut draft.points {
                point.at *= unit;
            }
            for link in &mut draft.links {
                for at in link.shape.iter_mut().flatten() {
                    *at *= unit;
                }
            }
            draft.tracers.clear();
            let motion = moved(&draft);
            let margin = motion.singularity_margin();
            assert!(
                margin.is_finite() && margin != 0.0,
                "{name} {unit:e}: {margin}"
            );
            let mut dimensions = motion.mechanism().dimensions().into_iter();
            let length = dimensions
                .find(|one| matches!(one, Dimension::Length(_)))
                .unwrap();
            let value = motion.mechanism().value(length).unwrap();
            let changed = motion.changed(length, 1.001 * value, motion.drawn_input());
            assert!(changed.is_ok(), "{name} {unit:e}: {:?}", changed.err());
        }
    }
}
