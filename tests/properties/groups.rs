//! Properties of every group of Class III to V, whatever its dimensions.

use std::f64::consts::TAU;

use assur::Point;
use assur::gears::Mesh;
use assur::mechanism::{Defect, GearSpec, LinkageSpec, Mechanism, PointSpec};
use assur::motion::{DeadPointKind, Motion};
use assur_tests::scaled;

use super::closure::Closure;
use super::following::{Random, closes, does_not_jump, inputs, leads_to_itself, rate};

const GROUPS: u64 = 40;

/// Kinds of groups by class and order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Triad,
    FourTwo,
    FourThree,
    Five,
}

pub(crate) const KINDS: [(Kind, &str); 4] = [
    (Kind::Triad, "III₃"),
    (Kind::FourTwo, "IV₂"),
    (Kind::FourThree, "IV₃"),
    (Kind::Five, "V₃"),
];

/// A point anywhere, but not upon another.
fn place(draft: &mut LinkageSpec, random: &mut Random, name: &str) {
    let at = loop {
        let at = Point::new(random.within(-3.0, 3.0), random.within(-3.0, 3.0));
        if draft
            .points
            .iter()
            .all(|point| (point.at - at).norm() > 0.3)
        {
            break at;
        }
    };
    let name = name.to_owned();
    draft.points.push(PointSpec { name, at });
}

/// A crank and a group of a kind, drawn anywhere. Each side of a triad may slide.
pub(crate) fn drawn(kind: Kind, seed: u64) -> LinkageSpec {
    let mut random = Random::new(1_000 + seed);
    let mut draft = LinkageSpec::default();
    let names: &[&str] = match kind {
        Kind::Triad => &["A", "B", "P", "Q", "R", "G", "H", "K", "L", "M"],
        Kind::FourTwo => &["A", "B", "C", "E", "F", "H", "D"],
        Kind::FourThree => &["A", "B", "E", "G", "F", "K", "L", "C", "H", "D"],
        Kind::Five => &["A", "B", "P", "Q", "R", "S", "T", "U", "D", "H"],
    };
    for name in names {
        place(&mut draft, &mut random, name);
    }
    let frame: &[&str] = match kind {
        Kind::Triad => &["A", "G", "H", "K", "L", "M"],
        Kind::FourTwo => &["A", "D"],
        Kind::FourThree | Kind::Five => &["A", "H", "D"],
    };
    let draft = draft.fixed(frame).bar("crank", &["A", "B"]).crank("crank");
    match kind {
        Kind::FourTwo => draft
            .bar("BCE", &["B", "C", "E"])
            .bar("CF", &["C", "F"])
            .bar("EH", &["E", "H"])
            .bar("DFH", &["D", "F", "H"]),
        Kind::FourThree => draft
            .bar("BE", &["B", "E"])
            .bar("EGF", &["E", "G", "F"])
            .bar("HGL", &["H", "G", "L"])
            .bar("CLK", &["C", "L", "K"])
            .bar("FK", &["F", "K"])
            .bar("CD", &["D", "C"]),
        Kind::Five => draft
            .bar("BTP", &["B", "T", "P"])
            .bar("PQ", &["P", "Q"])
            .bar("DQR", &["D", "Q", "R"])
            .bar("RSU", &["R", "S", "U"])
            .bar("ST", &["S", "T"])
            .bar("HU", &["H", "U"]),
        Kind::Triad => {
            let mut draft = draft.bar("platform", &["P", "Q", "R"]);
            draft = match random.below(3) {
                // A block on the crank pin, on a line of the platform.
                0 => draft
                    .bar("first", &["B"])
                    .slide("first", "B", "platform", ["P", "Q"]),
                _ => draft.bar("first", &["B", "P"]),
            };
            draft = match random.below(3) {
                // A block of the platform on a line of the frame.
                0 => draft
                    .bar("second", &["Q"])
                    .slide("second", "Q", "frame", ["K", "L"]),
                _ => draft.bar("second", &["G", "Q"]),
            };
            match random.below(4) {
                0 => draft
                    .bar("third", &["R"])
                    .slide("third", "R", "frame", ["L", "M"]),
                1 => draft
                    .bar("third", &["H"])
                    .slide("third", "H", "platform", ["Q", "R"]),
                _ => draft.bar("third", &["H", "R"]),
            }
        }
    }
}

pub(crate) fn moving(kind: Kind, seed: u64) -> (LinkageSpec, Motion) {
    let draft = drawn(kind, seed);
    let mechanism = Mechanism::new(&draft).unwrap_or_else(|e| panic!("{kind:?} {seed}: {e:?}"));
    let motion = Motion::new(mechanism);
    (draft, motion)
}

#[test]
fn groups_are_of_their_class() {
    for (kind, symbol) in KINDS {
        for seed in 0..scaled(GROUPS) / 10 {
            let mechanism = Mechanism::new(&drawn(kind, seed)).unwrap();
            let formula = mechanism.structure().formula(|link| link);
            assert!(formula.contains(symbol), "{kind:?} {seed}: {formula}");
        }
    }
}

#[test]
fn groups_close_with_all_derivatives() {
    let mut random = Random::new(17);
    for (kind, _) in KINDS {
        let mut checked = 0;
        for seed in 0..scaled(GROUPS) {
            let (draft, motion) = moving(kind, seed);
            let inputs = inputs(&motion, &mut random);
            checked += closes(seed, &draft, &motion, &inputs);
        }
        assert!(checked as u64 > 7 * scaled(GROUPS), "{kind:?}: {checked}");
    }
}

#[test]
fn any_pose_leads_to_the_same_motion() {
    let mut random = Random::new(19);
    for (kind, _) in KINDS {
        let mut checked = 0;
        for seed in 0..scaled(GROUPS) / 4 {
            let (draft, motion) = moving(kind, seed);
            let inputs = inputs(&motion, &mut random);
            checked += leads_to_itself(seed, &draft, &motion, &inputs);
        }
        assert!(checked as u64 > scaled(GROUPS), "{kind:?}: {checked}");
    }
}

#[test]
fn nothing_jumps() {
    for (kind, _) in KINDS {
        for seed in 0..scaled(GROUPS) / 10 {
            let (_, motion) = moving(kind, seed);
            does_not_jump(seed, &motion);
        }
    }
}

/// The engine's motion is the branch that is met in steps of a tenth of a degree by
/// other equations and another method.
#[test]
fn small_steps_lead_the_same_way() {
    for (kind, _) in KINDS {
        let mut compared = 0;
        for seed in 0..scaled(GROUPS) / 20 {
            let (draft, motion) = moving(kind, seed);
            let mechanism = motion.mechanism();
            // Where the crank goes to and fro over more than a turn, whole turns count.
            let cycle = motion.cycle();
            let home = motion.drawn_input();
            let [from, to] = cycle.arcs()[0];
            for turn in [TAU, -TAU] {
                Closure::new(&draft).follow(turn, 3_600, |gone, place| {
                    let input = home + gone;
                    assert!(
                        cycle.is_full() || (from - 1e-9..=to + 1e-9).contains(&input),
                        "{kind:?} {seed}: goes on at {input} beyond {from} to {to}"
                    );
                    let Ok(pose) = motion.pose::<4>(input) else {
                        return;
                    };
                    if rate(mechanism, &pose) > 1e3 {
                        return;
                    }
                    for (index, point) in mechanism.point_ids().enumerate() {
                        let off = (mechanism.place(&pose, point).place() - place(index)).norm();
                        assert!(
                            off < 1e-8 * mechanism.size(),
                            "{kind:?} {seed} at {input}: {} is off by {off:e}",
                            draft.points[index].name
                        );
                    }
                    compared += 1;
                });
            }
        }
        assert!(
            compared as u64 > 3_600 * scaled(GROUPS) / 80,
            "{kind:?}: {compared}"
        );
    }
}

/// Dead points stand where an extended system, which is regular there, has them.
#[test]
fn dead_points_to_ten_digits() {
    for (kind, _) in KINDS {
        let mut compared = 0;
        for seed in 0..scaled(GROUPS) / 4 {
            let (draft, motion) = moving(kind, seed);
            for dead in motion.dead_points() {
                if dead.kind != DeadPointKind::Singular {
                    continue;
                }
                // From just inside the motion.
                let [from, to] = motion.cycle().arcs()[0];
                let inside = dead.input + 1e-4 * (0.5 * (from + to) - dead.input).signum();
                let Ok(pose) = motion.pose::<1>(inside) else {
                    continue;
                };
                let points = motion.mechanism().point_ids();
                let near: Vec<Point> = points
                    .map(|point| motion.mechanism().place(&pose, point).place())
                    .collect();
                let Some(exact) = Closure::new(&draft).dead_point(&near, inside) else {
                    continue;
                };
                let off = (dead.input - exact).abs();
                // Another one may be met where two are close together.
                if off > 1e-3 {
                    continue;
                }
                assert!(off < 1e-10, "{kind:?} {seed}: off by {off:e}");
                compared += 1;
            }
        }
        assert!(
            compared as u64 > scaled(GROUPS) / 10,
            "{kind:?}: {compared}"
        );
    }
}

/// What is wrong with a group is said with the names of its links and points.
#[test]
fn broken_groups_say_why() {
    for (kind, _) in KINDS {
        for seed in 0..8 {
            let draft = drawn(kind, seed);
            let [last, other] = [draft.links.len() - 1, 1].map(|k| draft.links[k].name.clone());
            let group: Vec<String> = draft.links[1..].iter().map(|l| l.name.clone()).collect();
            let what = format!("{kind:?} {seed}");

            // Held by one bar more.
            let mut locked = draft.clone();
            let point = locked.links[1].points.last().unwrap().clone();
            locked = locked.bar("stay", &[&point, "A"]);
            let defects = Mechanism::new(&locked).unwrap_err();
            let said = |defect: &Defect| matches!(defect, Defect::Locked { mobility: 0, .. });
            assert!(defects.iter().any(said), "{what}: {defects:?}");

            // A link missing.
            let mut loose = draft.clone();
            loose.links.pop();
            loose.slides.retain(|slide| slide.link != last);
            let defects = Mechanism::new(&loose).unwrap_err();
            let said = defects.iter().any(|defect| {
                matches!(defect, Defect::Underdriven { mobility: 2.., links } if !links.is_empty())
            });
            assert!(said, "{what}: {defects:?}");

            // Far too long to close.
            let mut apart = draft.clone();
            let long = apart
                .links
                .iter_mut()
                .find(|l| l.points.len() == 2 && l.name != "crank");
            if let Some(long) = long {
                long.shape = Some(vec![Point::origin(), Point::new(1e4, 0.0)]);
                let defects = Mechanism::new(&apart).unwrap_err();
                let said = defects.iter().any(|defect| match defect {
                    Defect::Open { links, .. } => {
                        let mut links = links.clone();
                        let mut group = group.clone();
                        links.sort();
                        group.sort();
                        links == group
                    }
                    Defect::Misdrawn { point, .. } => {
                        draft.points.iter().any(|other| other.name == *point)
                    }
                    _ => false,
                });
                assert!(said, "{what}: {defects:?}");
            }

            // Two points of a link at one place.
            let mut flat = draft.clone();
            let plate = flat
                .links
                .iter()
                .find(|link| link.points.len() == 3)
                .unwrap()
                .clone();
            let at = flat
                .points
                .iter()
                .find(|p| p.name == plate.points[0])
                .unwrap()
                .at;
            flat.points
                .iter_mut()
                .find(|p| p.name == plate.points[1])
                .unwrap()
                .at = at;
            let defects = Mechanism::new(&flat).unwrap_err();
            let said = defects.iter().any(
                |defect| matches!(defect, Defect::Coincident { link, .. } if *link == plate.name),
            );
            assert!(said, "{what}: {defects:?}");

            // A wheel that turns on no point of its carrier.
            let mut geared = draft.clone();
            geared.gears.push(GearSpec {
                links: [other.clone(), "crank".to_owned()],
                carrier: "frame".to_owned(),
                teeth: [20.0, 30.0],
                mesh: Mesh::External,
            });
            let links = [other, "frame".to_owned()];
            let defects = Mechanism::new(&geared).unwrap_err();
            assert_eq!(defects, [Defect::NotHinged { links }], "{what}");
        }
    }
}
