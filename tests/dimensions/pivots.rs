//! Pivots, drivers and assemblies.

use super::*;

/// A hinge of the frame goes as far as the linkage lets it, and the links stay.
#[test]
fn a_hinge_is_moved() {
    let motion = motion("watt-2");
    let mechanism = motion.mechanism();
    let h = mechanism.point("H").unwrap();
    let from = mechanism.spec().points[h.index()].at;
    for to in [from + Vector::new(0.05, 0.1), from + Vector::new(20.0, 5.0)] {
        let moved = motion.hinge_moved(h, to, motion.drawn_input()).unwrap();
        let after = moved.motion.mechanism();
        let at = after.spec().points[h.index()].at;
        let way = (to - from).normalize();
        assert!((at - from).dot(&way) > 0.1 && (at - from).perp(&way).abs() < 1e-12);
        for dimension in mechanism.dimensions() {
            if let Dimension::Length(_) = dimension {
                assert_eq!(after.value(dimension), mechanism.value(dimension));
            }
        }
    }
}

/// Whatever can drive drives from the pose at hand: links hinged on the frame, slides on it,
/// and what drives already.
#[test]
fn every_driver_of_the_catalogue() {
    for name in gallery() {
        let motion = motion(name);
        let mechanism = motion.mechanism();
        for link in mechanism.drivable() {
            let driver = motion.driver(link).unwrap().unwrap();
            for input in inputs(&motion) {
                let at = format!("{name} {link} at {input}");
                let changed = motion.driven_by(&driver, input);
                let changed = changed.unwrap_or_else(|defects| panic!("{at}: {defects:?}"));
                let after = changed.motion.mechanism();
                let draft = after.spec();
                assert_eq!(draft.driven(&draft.drivers[0]), Some(link), "{at}");
                let base = match &draft.drivers[0] {
                    DriverSpec::Crank { base, .. } => base,
                    DriverSpec::Slide { slide, .. } => &draft.slides[*slide].on,
                };
                let driven = format!("I({base},{link})");
                assert!(after.terms().contains(&driven), "{at}");
                let pose = changed.motion.pose(changed.input).unwrap();
                assert!(residual(after, &pose) < 1e-9, "{at}");
                let here = places(mechanism, &motion.pose(input).unwrap());
                let near = if changed.gave_way { 0.3 } else { 1e-9 };
                let off = off(&here, &places(after, &pose));
                assert!(off < near * mechanism.size(), "{at}: {off}");
            }
        }
    }
}

/// At a dead point of the new driver the old one gives way a little.
#[test]
fn a_driver_at_its_dead_point() {
    // The rocker of a crank-rocker at the end of its swing: crank and coupler in line.
    let linkage = FourBar::new([0.37, 0.85, 0.55, 0.85]).unwrap();
    let limit = linkage.limits(Assembly::First)[0].crank;
    let motion = motion("watt-2");
    let mechanism = motion.mechanism();
    let a = mechanism.spec().points[0].at;
    let d = mechanism
        .spec()
        .points
        .iter()
        .find(|point| point.name == "D");
    let frame = d.unwrap().at - a;
    let input = limit + frame.y.atan2(frame.x);
    let rocker = motion.driver("rocker").unwrap().unwrap();
    let changed = motion.driven_by(&rocker, input).unwrap();
    assert!(changed.motion.pose::<3>(changed.input).is_ok());
}

/// Drawn in an assembly it is the one of that number.
#[test]
fn every_assembly_of_the_catalogue() {
    for name in gallery() {
        let motion = motion(name);
        let mechanism = motion.mechanism();
        let all = mechanism.signed_assemblies();
        for number in 0..all.count() {
            let other = all.assembly(number).unwrap();
            let others = other.signed_assemblies();
            let found = (others.drawn(), others.count());
            assert_eq!(found, (number, all.count()), "{name}");
            assert_eq!(other.drawn_input(), mechanism.drawn_input(), "{name}");
        }
    }
}
