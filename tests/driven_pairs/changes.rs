//! Changes of dimensions and of drivers, and drivers that are refused.

use assur::Point;
use assur::mechanism::{Defect, Dimension, LinkageSpec, Mechanism};

use super::arms::{arm, drawn_arm};
use super::cylinders::{angle_opposite, cylinder, reach};
use super::excavators::{Random, excavator};
use super::{angle, motion, place, reduced, turned};

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

    // So it is where the lever's own hinge is dragged.
    let (hinge, to) = (lever.mechanism().point("D").unwrap(), Point::new(4.3, -0.8));
    let changed = lever.hinge_moved(hinge, to, 3.2).unwrap();
    assert!((changed.input - 3.2).abs() < 1e-12);
    let [end, ..] = place(&changed.motion, "B", 3.2);
    assert!((end.norm() - 3.2_f64.hypot(0.5)).abs() < 1e-12);
    assert!(((end - to.coords).norm() - 1.0_f64.hypot(1.5)).abs() < 1e-12);

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
    let input = motion.drawn_input() + 0.1;
    let driver = motion.driver("plunger").unwrap().unwrap();
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
    let named = |draft: &LinkageSpec| Mechanism::new(draft).unwrap_err();
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
    assert_eq!(
        named(&own),
        [Defect::WithItself {
            link: "w".to_owned()
        }]
    );
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
