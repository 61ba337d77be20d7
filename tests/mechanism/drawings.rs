//! Special drawings: singular poses, kites, and linkages assembled from dimensions alone.

use super::*;

/// A drawing in a singular position, with hinges in one place, or beyond the range of a driven slide says so.
#[test]
fn drawings_that_do_not_begin_are_named() {
    let links = |names: &[&str]| -> Vec<String> {
        let names = names.iter().map(|name| (*name).to_owned());
        names.collect()
    };
    let refused = |draft: &LinkageSpec| Mechanism::new(draft).unwrap_err();
    // Crank and rod together just reach the guide.
    let upright = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 0.0, 2.0)
        .point("G", 4.0, 2.0)
        .point("H", 5.0, 2.0)
        .fixed(&["A", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["G", "H"])
        .crank("crank");
    let singular = Defect::Singular {
        links: links(&["rod", "slider"]),
        singularity: Singularity::Perpendicular,
    };
    assert_eq!(refused(&upright), [singular]);
    // The block is on the hinge of the lever along which it slides.
    let on_the_hinge = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("D", 1.0, 0.0)
        .point("E", 3.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("block", &["B"])
        .bar("lever", &["D", "E"])
        .slide("block", "B", "lever", ["D", "E"])
        .crank("crank");
    let coincident = Defect::CoincidentHinges {
        links: links(&["block", "lever"]),
    };
    assert_eq!(refused(&on_the_hinge), [coincident]);
    let foot = "foot".to_owned();
    let reversed = Defect::RangeReversed {
        link: foot.clone(),
        from: 2.0,
        to: 1.0,
    };
    assert_eq!(refused(&ladder([2.0, 1.0])), [reversed]);
    let empty = Defect::RangeEmpty {
        link: foot.clone(),
        at: 2.0,
    };
    assert_eq!(refused(&ladder([2.0, 2.0])), [empty]);
    let endless = [Defect::NotFinite { name: foot.clone() }];
    assert_eq!(refused(&ladder([1.0, f64::INFINITY])), endless);
    let Defect::DrawnBeyondRange { link, at, from, to } = &refused(&ladder([0.1, 0.3]))[0] else {
        panic!("{:?}", refused(&ladder([0.1, 0.3])));
    };
    assert_eq!((link, [*from, *to]), (&foot, [0.1, 0.3]));
    assert!((at - 1.5).abs() < 1e-15, "{at}");
}

/// Where B lies on D coupler and rocker of a kite may stand at any angle: the row is the limit along the motion, smooth as
/// the rows beside it, and the input is a change point.
#[test]
fn a_kite_passes_its_free_swing_smoothly() {
    for (lengths, turns) in [
        ([5.0; 4], 1),
        ([1.0, 2.0, 2.0, 1.0], 2),
        ([2.0, 1.25, 1.25, 2.0], 1),
    ] {
        for assembly in Assembly::ALL {
            let draft = four_bar(lengths, 0.3, assembly);
            let motion = Motion::new(Mechanism::new(&draft).unwrap());
            let mechanism = motion.mechanism();
            let quantities = ["crank.angle", "coupler.angle", "rocker.angle", "C.x", "C.y"];
            let quantities = quantities.map(|name| Quantity::named(mechanism, name).unwrap());
            let columns: Vec<Column> = Column::all(mechanism);
            let swings = motion.cycle().contains(0.0);
            assert!(swings);
            for turn in 0..=turns {
                let at = TAU * f64::from(turn);
                let inputs = motion.change_points().iter();
                let is_listed = inputs.copied().any(|input| input == at);
                assert!(is_listed || turn == turns, "{lengths:?} {at}");
                let row = motion.row(&columns, at);
                assert_eq!(row.reason, None, "{lengths:?} {at}");
                assert!(row.values.iter().all(Option::is_some));
                // By Taylor's series from the pose itself and from both sides.
                let step = 1e-3;
                let here = motion.pose::<5>(at).unwrap();
                for quantity in quantities {
                    let jet = quantity.of(mechanism, &here);
                    for by in [-step, step] {
                        let Ok(beside) = motion.pose::<1>(at + by) else {
                            continue;
                        };
                        let terms = (0..5).rev();
                        let told = terms.fold(0.0, |sum, order| {
                            sum * by / (order + 1) as f64 + jet.derivative(order)
                        });
                        let off = quantity.of(mechanism, &beside).value() - told;
                        let off = if quantity.is_angle() {
                            off - TAU * (off / TAU).round()
                        } else {
                            off
                        };
                        assert!(
                            off.abs() < 1e-11,
                            "{lengths:?} {assembly:?} {at} {by}: {off:e}"
                        );
                    }
                }
            }
        }
    }
}

/// By its dimensions alone a linkage is drawn in an assembly at an input, wherever its moving points are drawn; at an input
/// that it does not reach there is none, and what else is wrong is named.
#[test]
fn assembled_by_dimensions_alone() {
    let lengths = [2.0, 6.0, 4.5, 6.0];
    let mut draft = four_bar(lengths, 1.0, Assembly::First);
    for (link, length) in draft.links.iter_mut().zip(lengths) {
        link.shape = Some(vec![Point::origin(), Point::new(length, 0.0)]);
    }
    let places: Vec<Point> = draft.points.iter().map(|point| point.at).collect();
    let origin = Point::origin();
    for name in ["B", "C"] {
        let point = draft.points.iter_mut().find(|point| point.name == name);
        point.unwrap().at = origin;
    }
    assert!(Mechanism::new(&draft).is_err());
    let mechanism = Mechanism::assembled(&draft, Some(1.0)).unwrap().unwrap();
    assert!((mechanism.drawn_input() - 1.0).abs() < 1e-14);
    let output = mechanism.link("rocker").unwrap();
    let found = Motion::new(mechanism.clone()).assemblies_at(1.0, output);
    assert!(found.whole && found.poses.len() == 2);
    let is_drawn = |pose: &_| {
        let ids = mechanism.point_ids().zip(&places);
        ids.into_iter()
            .all(|(id, at)| (mechanism.place(pose, id).place() - at).norm() < 1e-13)
    };
    assert_eq!(found.poses.iter().filter(|pose| is_drawn(pose)).count(), 1);
    // Each of them is a drawing of its own.
    for pose in &found.poses {
        let drawn = Mechanism::new(&mechanism.drawn_in(pose)).unwrap();
        assert!((drawn.drawn_input() - 1.0).abs() < 1e-14);
    }
    // The coupler is too short to reach over here.
    draft.links[1].shape = Some(vec![Point::origin(), Point::new(2.5, 0.0)]);
    assert!(Mechanism::assembled(&draft, Some(3.1)).unwrap().is_none());
    draft.drivers.clear();
    let without = Mechanism::assembled(&draft, None).unwrap_err();
    assert_eq!(without, [Defect::NoDriver]);
}

/// A crank that cannot turn fully, whose four-bar passes a change point, may be counted by another whole turn than it is
/// drawn by, after which the closed form has the other assembly.
#[test]
fn counted_by_another_turn_the_assembly_is_the_drawn_one() {
    for assembly in Assembly::ALL {
        let mut draft = four_bar([3.0, 2.0, 3.0, 4.0], 10_f64.to_radians(), assembly);
        for point in &mut draft.points {
            point.at = Point::from(-point.at.coords);
        }
        let mechanism = Mechanism::new(&draft).unwrap();
        let c = mechanism.point("C").unwrap();
        let motion = Motion::new(mechanism);
        let again = Motion::new(motion.mechanism().clone());
        for motion in [motion, again] {
            let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
            let off = motion.mechanism().place(&pose, c).place() - draft.points[2].at;
            assert!(off.norm() < 1e-12, "{assembly:?}: {off:?}");
        }
    }
}
