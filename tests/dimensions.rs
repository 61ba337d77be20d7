//! Changes of dimensions in the current pose. The changed linkage closes, keeps its assembly and can be changed back;
//! an impossible value is refused with the last value that works.

mod pivots;

use std::f64::consts::TAU;

use assur::mechanism::{
    ConstraintKind, Dimension, DriverSpec, LinkageSpec, Mechanism, Pose, Quantity,
};
use assur::motion::{Changed, Motion, OutputProfile, Refusal};
use assur::{Assembly, FourBar, Point, Swing, Vector};
use assur_file::{from_catalogue, gallery};
use assur_tests::scaled;

use crate::mechanism::ladder;

fn motion(name: &str) -> Motion {
    from_catalogue(name).unwrap().unwrap().motion().unwrap()
}

/// Inputs over a motion: at its drawing, and away from the ends.
fn inputs(motion: &Motion) -> [f64; 3] {
    let [from, to] = motion.cycle().arcs()[0];
    [
        motion.drawn_input(),
        from + 0.15 * (to - from),
        from + 0.65 * (to - from),
    ]
}

/// The largest residual of the constraint equations: lengths relative to the size, and
/// angles.
fn residual(mechanism: &Mechanism, pose: &Pose<1>) -> f64 {
    let constraints = mechanism.constraints();
    let off = constraints.iter().map(|one| {
        let scale = match one.kind {
            ConstraintKind::Distance { .. } | ConstraintKind::Offset { .. } => {
                mechanism.size().powi(2)
            }
            ConstraintKind::Direction { .. } => 1.0,
            ConstraintKind::Mesh { teeth, .. } => teeth[0] + teeth[1],
        };
        mechanism.sides(pose, one, 0).residual().abs() / scale
    });
    off.fold(0.0, f64::max)
}

fn places(mechanism: &Mechanism, pose: &Pose<1>) -> Vec<Point> {
    let points = mechanism.point_ids();
    points
        .map(|point| mechanism.place(pose, point).place())
        .collect()
}

fn off(a: &[Point], b: &[Point]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).norm())
        .fold(0.0, f64::max)
}

/// Values over every slider's range, of which a quick run takes each tenth: each is shown, or refused with the last value that
/// works; what is shown is closed and of that value, and goes back to the same pose
/// unless the input gave way, after which there may be another way back.
#[test]
fn every_dimension_of_the_catalogue() {
    let [mut number, mut shown, mut gave, mut refused] = [0, 0, 0, 0];
    for name in gallery() {
        let motion = motion(name);
        let mechanism = motion.mechanism();
        let is_redundant = mechanism.mobility().q() > 0;
        for dimension in mechanism.dimensions() {
            let [from, to] = mechanism.range(dimension).unwrap();
            let was = mechanism.value(dimension).unwrap();
            for input in inputs(&motion) {
                let before = places(mechanism, &motion.pose(input).unwrap());
                for k in 0..9 {
                    number += 1;
                    if number % 10 >= scaled(1) {
                        continue;
                    }
                    let value = from + (to - from) * f64::from(k) / 8.0;
                    let at = format!("{name} {dimension:?} {was} → {value} at {input}");
                    match motion.changed(dimension, value, input) {
                        Ok(changed) => {
                            shown += 1;
                            gave += usize::from(changed.gave_way);
                            returns(&changed, dimension, [was, value], &before, &at);
                        }
                        Err(Refusal::LoopOpen {
                            last, by, links, ..
                        }) => {
                            // One length of a linkage with redundant constraints cannot change alone.
                            refused += usize::from(!is_redundant);
                            assert!(by > 0.0 && !links.is_empty(), "{at}");
                            assert!((by - (value - last).abs()).abs() < 1e-12, "{at}");
                            assert!((last - was) * (value - last) >= 0.0, "{at}: {last}");
                            let works = motion.changed(dimension, last, input);
                            assert!(works.is_ok(), "{at}: {last} {works:?}");
                        }
                        Err(other) => panic!("{at}: {other:?}"),
                    }
                }
            }
        }
    }
    println!("{shown} shown ({gave} of them at another input), {refused} refused");
    assert!(shown > 10 * refused, "{shown} {refused}");
}

fn returns(changed: &Changed, of: Dimension, [was, value]: [f64; 2], before: &[Point], at: &str) {
    let Changed {
        motion,
        input,
        gave_way,
    } = changed;
    let mechanism = motion.mechanism();
    let got = mechanism.value(of).unwrap();
    let turns = match of {
        Dimension::Corner(..) => ((got - value) / TAU).round(),
        _ => 0.0,
    };
    assert!(
        (got - value - TAU * turns).abs() <= 1e-12 * value.abs().max(1.0),
        "{at}: {got}"
    );
    let pose = motion.pose(*input).unwrap_or_else(|e| {
        panic!(
            "{at}: {e} home {} {:?} draft {:?}",
            motion.drawn_input(),
            motion.cycle(),
            mechanism.spec()
        )
    });
    assert!(residual(mechanism, &pose) < 1e-9, "{at}");
    ends_are_poses(motion, at);
    // The drawing is that pose.
    let drawn: Vec<Point> = mechanism.spec().points.iter().map(|one| one.at).collect();
    let size = mechanism.size();
    assert!(off(&drawn, &places(mechanism, &pose)) < 1e-9 * size, "{at}");
    // From a straight corner it may go back to either side.
    let is_straight = match of {
        Dimension::Side(link, [1, point]) => {
            let corner = mechanism.value(Dimension::Corner(link, point));
            corner.unwrap().sin().abs() < 1e-6
        }
        _ => false,
    };
    if !gave_way && !is_straight {
        let back = motion.changed(of, was, *input);
        let back = back.unwrap_or_else(|refused| panic!("{at}: {refused:?}"));
        let again = places(
            back.motion.mechanism(),
            &back.motion.pose(back.input).unwrap(),
        );
        assert!(
            off(before, &again) < 1e-7 * size,
            "{at}: {:e}",
            off(before, &again) / size
        );
    }
}

/// Where a motion turns back there is a pose, and so a least and a greatest angle of
/// every link.
fn ends_are_poses(motion: &Motion, at: &str) {
    let mechanism = motion.mechanism();
    if !motion.cycle().is_full() {
        for end in motion.cycle().arcs().as_flattened() {
            let pose = motion.pose::<1>(*end);
            assert!(pose.is_ok(), "{at}: {end} {:?}", pose.err());
        }
        for dead in motion.dead_points() {
            assert!(motion.pose::<1>(dead.input).is_ok(), "{at}: {dead:?}");
        }
    }
    for link in &mechanism.spec().links {
        let link = mechanism.link(&link.name).unwrap();
        for swing in OutputProfile::new(motion, Quantity::Angle(link))
            .unwrap()
            .swings()
        {
            if let Swing::Between { min, max } = swing {
                assert!(min <= max && (max - min).is_finite(), "{at}: {min} {max}");
            }
        }
    }
}

/// What the drawing alone could not tell: from 60°, where a rod of half as much again
/// would end far from where it is drawn.
#[test]
fn a_slider_crank_far_from_its_drawing() {
    let motion = motion("slider-crank");
    let mechanism = motion.mechanism();
    let [crank, rod] = ["crank", "rod"].map(|name| mechanism.link(name).unwrap());
    let phi = 1.0;
    for (link, value, lengths) in [
        (rod, 4.5, [1.0, 4.5]),
        (rod, 6.0, [1.0, 6.0]),
        (crank, 3.0, [3.0, 3.0]),
    ] {
        let changed = motion.changed(Dimension::Length(link), value, phi).unwrap();
        assert_eq!((changed.input, changed.gave_way), (phi, false));
        let after = changed.motion.mechanism();
        let pose = changed.motion.pose::<1>(phi).unwrap();
        let c = after.place(&pose, after.point("C").unwrap()).place();
        let [r, l] = lengths;
        let x = r * phi.cos() + (l * l - (r * phi.sin()).powi(2)).sqrt();
        assert!((c - Point::new(x, 0.0)).norm() < 1e-12, "{c} {x}");
    }
    // A rod shorter than the crank: it turns no longer over 60°, and the crank gives way
    // to where the rod just reaches its guide.
    let short = motion.changed(Dimension::Length(rod), 0.5, phi).unwrap();
    assert!(short.gave_way && short.input.sin() < 0.5, "{}", short.input);
    assert!(short.input.sin() > 0.5 - 0.01, "{}", short.input);
}

fn offsets(mechanism: &Mechanism) -> Vec<Dimension> {
    let mut dimensions = mechanism.dimensions();
    dimensions.retain(|one| matches!(one, Dimension::Offset(_)));
    dimensions
}

/// The slide of an offset slider-crank by hand: x = r cos φ + √(l² − (r sin φ − e)²), where e is the height of the guide and the
/// slide's offset from it.
#[test]
fn a_slider_keeps_off_its_guide() {
    let motion = motion("slider-crank-offset");
    let mechanism = motion.mechanism();
    let offset = offsets(mechanism)[0];
    assert_eq!(mechanism.value(offset), Some(0.0));
    for (value, phi) in [(0.4, 1.0), (-0.7, 1.0), (1.0, 3.5)] {
        let changed = motion.changed(offset, value, phi).unwrap();
        assert_eq!((changed.input, changed.gave_way), (phi, false));
        let after = changed.motion.mechanism();
        let pose = changed.motion.pose::<1>(phi).unwrap();
        let c = after.place(&pose, after.point("C").unwrap()).place();
        let e = -1.0 + value;
        let x = phi.cos() + (9.0 - (phi.sin() - e).powi(2)).sqrt();
        assert!((c - Point::new(x, e)).norm() < 1e-12, "{c} {x}");
        for other in mechanism.dimensions() {
            if other != offset {
                let [was, is] = [mechanism, after].map(|one| one.value(other).unwrap());
                assert!((is - was).abs() < 1e-12, "{other:?}: {was} {is}");
            }
        }
    }
    // The guide as high as crank and rod are long together, and 1 below A.
    match motion.changed(offset, 6.0, 1.0).unwrap_err() {
        Refusal::LoopOpen { last, by, .. } => {
            assert!(last <= 5.0 && last > 5.0 - 0.01, "{last}");
            assert!((by - (6.0 - last)).abs() < 1e-12);
        }
        other => panic!("{other:?}"),
    }
}

/// Of driven slides, on the frame and on a cylinder that turns; the input counts along the line as before.
#[test]
fn offsets_of_driven_slides() {
    let mut boom = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("A", 1.0, -0.5)
        .point("U", 1.2, 0.3)
        .point("B", 1.5, 1.5)
        .point("T", 4.0, 3.0)
        .fixed(&["O", "A"])
        .bar("boom", &["O", "B", "T"])
        .bar("cylinder", &["A", "U"])
        .bar("rod", &["B"])
        .slide("rod", "B", "cylinder", ["A", "U"]);
    boom.drivers.push(DriverSpec::Slide {
        slide: 0,
        range: [1.4, 2.6],
        rate: 1.0,
    });
    for draft in [ladder([0.5, 2.0]), boom] {
        let motion = Motion::new(Mechanism::new(&draft).unwrap());
        let mechanism = motion.mechanism();
        for offset in offsets(mechanism) {
            for input in inputs(&motion) {
                let before = places(mechanism, &motion.pose(input).unwrap());
                for value in [0.2, -0.1] {
                    let at = format!("{offset:?} → {value} at {input}");
                    let changed = motion.changed(offset, value, input);
                    let changed = changed.unwrap_or_else(|refused| panic!("{at}: {refused:?}"));
                    assert!((changed.input - input).abs() < 1e-12, "{at}");
                    returns(&changed, offset, [0.0, value], &before, &at);
                }
            }
        }
    }
}

/// A block that two points guide along one line has no offset that could change alone.
#[test]
fn offset_of_one_of_two_points_of_a_block() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.6, 0.8)
        .point("C", 3.0, 0.0)
        .point("E", 4.0, 0.0)
        .point("G", 1.0, 0.0)
        .fixed(&["A", "G"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("block", &["C", "E"])
        .slide("block", "C", "frame", ["A", "G"])
        .slide("block", "E", "frame", ["A", "G"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    for offset in offsets(mechanism) {
        match motion
            .changed(offset, 0.1, motion.drawn_input())
            .unwrap_err()
        {
            Refusal::LoopOpen { last, .. } => assert!(last.abs() < 1e-3, "{last}"),
            other => panic!("{other:?}"),
        }
    }
}

/// What cannot be says how far it is from what can.
#[test]
fn refusals() {
    let motion = motion("slider-crank-offset");
    let mechanism = motion.mechanism();
    let length = |name: &str| Dimension::Length(mechanism.link(name).unwrap());
    for (value, refusal) in [
        (0.0, Refusal::NotPositive),
        (-1.0, Refusal::NotPositive),
        (f64::NAN, Refusal::NotFinite),
        (f64::INFINITY, Refusal::NotFinite),
    ] {
        assert_eq!(
            motion.changed(length("rod"), value, 1.0).unwrap_err(),
            refusal
        );
    }
    let joint = Dimension::X(mechanism.point("B").unwrap());
    assert_eq!(
        motion.changed(joint, 1.0, 1.0).unwrap_err(),
        Refusal::Absent
    );
    // The guide, 1 below A, is out of reach once the hinge is farther than crank and rod
    // together.
    let height = Dimension::Y(mechanism.point("A").unwrap());
    let guide = mechanism
        .spec()
        .points
        .iter()
        .find(|point| point.name == "F");
    let most = guide.unwrap().at.y + 4.0;
    match motion.changed(height, most + 1.0, 1.0).unwrap_err() {
        Refusal::LoopOpen {
            last, by, links, ..
        } => {
            assert!(last <= most && last > most - 0.01, "{last} {most}");
            assert!((by - (most + 1.0 - last)).abs() < 1e-12);
            let names: Vec<&str> = links
                .iter()
                .map(|link| mechanism.link_name(*link))
                .collect();
            assert_eq!(names, ["rod", "slider"]);
        }
        other => panic!("{other:?}"),
    }
}
