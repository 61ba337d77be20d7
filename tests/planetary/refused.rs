//! Impossible trains: the fault is named, without a panic or a result that is not a number.

use assur::gears::Mesh;
use assur::mechanism::{Defect, LinkageSpec, Mechanism};
use assur::motion::Motion;
use assur_tests::scaled;

use super::draw::{Dice, gear, set};
use super::residual;

fn refused(draft: &LinkageSpec) -> Vec<Defect> {
    Mechanism::new(draft).unwrap_err()
}

/// An arm with a planet between two suns: at equal ratios they ask the same of it, or what cannot be.
fn two_suns(teeth: [[u32; 2]; 2]) -> LinkageSpec {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("P", 40.0, 0.0)
        .point("Q", 40.0, 9.0)
        .point("S", 10.0, 3.0)
        .point("T", 12.0, -3.0)
        .fixed(&["A"])
        .bar("one", &["A", "S"])
        .bar("two", &["A", "T"])
        .bar("arm", &["A", "P"])
        .bar("planet", &["P", "Q"]);
    for (sun, teeth) in ["one", "two"].into_iter().zip(teeth) {
        draft
            .gears
            .push(gear([sun, "planet"], "arm", teeth, Mesh::External));
    }
    draft
}

#[test]
fn equal_ratios_determine_nothing() {
    let links = ["arm", "planet"].map(str::to_owned).to_vec();
    for rate in [1.0, 0.0, -2.0] {
        let draft = two_suns([[20, 60], [30, 90]])
            .crank("one")
            .crank("two")
            .at_rate(rate);
        assert_eq!(
            refused(&draft),
            [Defect::TrainUndetermined {
                links: links.clone()
            }],
            "{rate}"
        );
    }
    // The least difference there is makes a set of them, and a fast one.
    let draft = two_suns([[999, 1000], [998, 999]])
        .crank("one")
        .crank("two")
        .at_rate(0.0);
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let pose = motion.pose::<2>(0.3).unwrap();
    let arm = mechanism
        .angle(&pose, mechanism.link("arm").unwrap())
        .derivative(1);
    let [a, b] = [999.0 / 1000.0, 998.0 / 999.0];
    let expected = a / (a - b);
    // The difference loses six digits in this test; the engine reckons in whole numbers.
    assert!((arm / expected - 1.0).abs() < 1e-9, "{arm} {expected}");
    assert_eq!(arm, 999.0 * 999.0);
    // Driven by the arm they are what they are in every book, a wheel that turns with the other.
    let draft = two_suns([[20, 60], [30, 90]])
        .crank("arm")
        .crank("one")
        .at_rate(0.0);
    assert!(Mechanism::new(&draft).is_ok());
}

#[test]
fn drivers_too_many_and_too_few() {
    let draft = set([24, 72], &[[24, 24]]);
    let all = draft.clone().crank("sun").crank("carrier").crank("ring");
    assert!(
        matches!(&refused(&all)[..], [Defect::Locked { links, .. }] if links.contains(&"ring".to_owned()))
    );
    let one = draft.crank("sun");
    assert!(matches!(
        &refused(&one)[..],
        [Defect::Underdriven { mobility: 2, links }] if links.len() == 4 || links.len() == 3
    ));
}

/// Wheels with numbers of teeth, dimensions and drivers that may be anything near to what is sound: it is refused by
/// name, or every pose is closed.
#[test]
fn whatever_is_given() {
    let mut dice = Dice(7);
    let (mut sound, mut told) = (0, 0);
    for case in 0..400 {
        let satellites = dice.whole([1, 3]);
        let satellite = dice.whole([3, 40]);
        let sun = dice.whole([3, 60]);
        let mut all = vec![[satellite; 2]; satellites as usize];
        if dice.part() < 0.3 {
            all[0][1] = dice.whole([3, 40]);
        }
        let mut draft = set([sun, sun + 2 * satellite], &all);
        let near = |dice: &mut Dice| if dice.part() < 0.5 { 1e-9 } else { 1e-3 } * dice.between([-1.0, 1.0]);
        for point in &mut draft.points {
            point.at.x += near(&mut dice);
            point.at.y += near(&mut dice);
        }
        let names = ["sun", "carrier", "ring", "satellite0"];
        let name = |dice: &mut Dice| names[dice.whole([0, 3]) as usize];
        match dice.whole([0, 5]) {
            0 => draft.gears[0].mesh = Mesh::Internal,
            1 => draft.gears[0].carrier = name(&mut dice).to_owned(),
            2 => draft.gears[0].links[0] = name(&mut dice).to_owned(),
            3 => draft.links[3].points.truncate(1),
            4 => draft.links[2].fixed_to = Some("frame".to_owned()),
            _ => {}
        }
        let rate = [0.0, 1.0, -1.0, 0.5][dice.whole([0, 3]) as usize];
        let first = dice.whole([0, 2]) as usize;
        let second = (first + dice.whole([1, 3]) as usize) % 4;
        let draft = draft.crank(names[first]);
        let draft = if draft.links[2].fixed_to.is_none() {
            draft.crank(names[second]).at_rate(rate)
        } else {
            draft
        };
        match Mechanism::new(&draft) {
            Ok(mechanism) => {
                let motion = Motion::new(mechanism);
                let period = motion.cycle().period().unwrap();
                for k in 0..7 {
                    let off = residual(&motion, period * f64::from(k) / 7.0);
                    assert!(off < 1e-11, "{case}: {off:e}");
                }
                sound += 1;
            }
            Err(defects) => {
                assert!(!defects.is_empty(), "{case}");
                told += 1;
            }
        }
    }
    assert!(sound > 60 && told > 60, "{sound} {told}");
}

/// Sun-and-planet gears of all kinds of dimensions, most of which cannot be joined, or come to dead points.
#[test]
fn whatever_is_given_of_a_group() {
    let mut dice = Dice(11);
    let mut sound = 0;
    for case in 0..scaled(15) {
        let mut place = |x: f64| [x + dice.between([-1.0, 1.0]), dice.between([-2.0, 2.0])];
        let [p, q, d, s] = [place(0.0), place(2.0), place(3.0), place(0.0)];
        let teeth = [dice.whole([3, 90]), dice.whole([3, 90])];
        let mesh = if dice.part() < 0.5 {
            Mesh::External
        } else {
            Mesh::Internal
        };
        let mut draft = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("S", s[0], s[1])
            .point("P", p[0], p[1])
            .point("Q", q[0], q[1])
            .point("D", d[0], d[1])
            .fixed(&["A", "D"])
            .bar("sun", &["A", "S"])
            .bar("carrier", &["A", "P"])
            .bar("rod", &["P", "Q"])
            .bar("beam", &["D", "Q"])
            .crank("sun");
        draft
            .gears
            .push(gear(["sun", "rod"], "carrier", teeth, mesh));
        // In line, or nearly.
        if case % 5 == 0 {
            let at = dice.between([-1e-9, 1e-9]);
            draft.points[3].at =
                draft.points[2].at + (draft.points[4].at - draft.points[2].at) * (0.4 + at);
        }
        let Ok(mechanism) = Mechanism::new(&draft) else {
            continue;
        };
        let motion = Motion::new(mechanism);
        sound += 1;
        let [from, to] = motion.cycle().arcs()[0];
        for k in 1..20 {
            let input = from + (to - from) * f64::from(k) / 20.0;
            let Ok(pose) = motion.pose::<3>(input) else {
                continue;
            };
            let mechanism = motion.mechanism();
            for constraint in &mechanism.constraints() {
                let sides = mechanism.sides(&pose, constraint, 0);
                let scale = sides.left.abs() + mechanism.size().powi(2).max(1.0);
                assert!(
                    sides.residual().abs() < 1e-11 * scale,
                    "{case} {constraint:?} {sides:?}"
                );
            }
            for link in mechanism.link_ids() {
                assert!(mechanism.angle(&pose, link).is_finite(), "{case}");
            }
        }
    }
    assert!(sound > scaled(8), "{sound}");
}
