//! Sun, carrier and ring, each driven, held or free, in all combinations.

use std::f64::consts::TAU;

use assur::gears::Mesh;
use assur::mechanism::LinkageSpec;
use assur_tests::{angle_between, assert_near};

use super::draw::{DRAWN, Dice, SHAFTS, gear, set};
use super::{angle, moved};

/// What is constant by Willis: each shaft's angle multiplied by its number.
fn willis([sun, ring]: [u32; 2], [at_sun, at_ring]: [u32; 2]) -> [f64; 3] {
    let [sun, ring, at_sun, at_ring] = [sun, ring, at_sun, at_ring].map(f64::from);
    let [a, b] = [sun / at_sun, ring / at_ring];
    [a, -a - b, b]
}

/// By how much the free one of three shafts turns: two are given.
fn free(numbers: [f64; 3], [one, two]: [(usize, f64); 2]) -> f64 {
    let third = 3 - one.0 - two.0;
    -(numbers[one.0] * one.1 + numbers[two.0] * two.1) / numbers[third]
}

/// Both numbers of teeth of the satellite alike, or of a stepped one.
fn teeth(dice: &mut Dice, stepped: bool) -> ([u32; 2], [u32; 2]) {
    let sun = dice.whole([12, 60]);
    let satellite = dice.whole([12, 40]);
    let other = if stepped {
        dice.whole([12, 40])
    } else {
        satellite
    };
    ([sun, sun + satellite + other], [satellite, other])
}

#[test]
fn all_combinations_over_several_turns() {
    let mut dice = Dice(1);
    for case in 0..20 {
        let (shafts, satellite) = teeth(&mut dice, case % 2 == 1);
        let numbers = willis(shafts, satellite);
        for (one, two) in [(0, 1), (1, 0), (0, 2), (2, 0), (1, 2), (2, 1)] {
            for rate in [0.0, 1.0, -1.0, 0.5, -2.25, 3.0] {
                let draft = set(shafts, &[satellite])
                    .crank(SHAFTS[one])
                    .crank(SHAFTS[two]);
                let motion = moved(&draft.at_rate(rate));
                let third = 3 - one - two;
                let grown = free(numbers, [(one, 1.0), (two, rate)]);
                let what = format!("{shafts:?} {satellite:?} {one} {two} {rate}");
                let period = motion.cycle().period().unwrap_or_else(|| {
                    panic!("{what} {:?} {:?}", motion.cycle(), motion.dead_points())
                });
                for k in 0..40 {
                    let input = period * f64::from(k) / 40.0;
                    // It begins where it is drawn; the cycle is told from zero on.
                    let by = input - DRAWN[one];
                    let off = angle_between(
                        angle(&motion, SHAFTS[third], input)[0],
                        DRAWN[third] + grown * by,
                    );
                    assert!(off < 1e-12 * TAU * period, "{what} {input}: {off:e}");
                    let [_, first, second] = angle(&motion, SHAFTS[third], input);
                    assert_near(first, grown, 1e-13, &what);
                    assert_near(second, 0.0, 1e-13, &what);
                    // θ₂ = θ₃ − (θ₁ − θ₃) z₁/z₂.
                    let rates = [0, 1, 2].map(|k| match k {
                        _ if k == one => 1.0,
                        _ if k == two => rate,
                        _ => grown,
                    });
                    let turned = rates[1]
                        - (rates[0] - rates[1]) * f64::from(shafts[0]) / f64::from(satellite[0]);
                    assert_near(angle(&motion, "satellite0", input)[1], turned, 1e-12, &what);
                }
            }
        }
    }
}

/// The ring held by the frame, the sun driven: it repeats when carrier and satellite are back; how a round satellite is
/// turned nobody sees.
#[test]
fn the_period_is_that_of_the_teeth() {
    let cases = [
        ([24, 72], 24, [4, 4]),
        ([20, 40], 10, [3, 3]),
        // The carrier turns by 1/6, the satellite by −1/4.
        ([18, 90], 36, [12, 6]),
        // By 3/13 and −3/7.
        ([18, 60], 21, [91, 13]),
    ];
    for (shafts, satellite, turns) in cases {
        for (is_round, turns) in [false, true].into_iter().zip(turns) {
            let mut draft = set(shafts, &[[satellite; 2]]).crank("sun");
            draft.links[2].fixed_to = Some("frame".to_owned());
            if is_round {
                draft.links[3].points.pop();
            }
            let motion = moved(&draft);
            let expected = TAU * f64::from(turns);
            assert_eq!(motion.cycle().period(), Some(expected), "{shafts:?}");
            let ratio = f64::from(shafts[0]) / f64::from(shafts[0] + shafts[1]);
            assert_near(angle(&motion, "carrier", 2.0)[1], ratio, 1e-15, "ratio");
        }
    }
}

/// Where the carriers of two sets follow each other: i = (1 + z₄/z₁)².
#[test]
fn two_sets_in_series() {
    let [sun, satellite, ring] = [20_u32, 16, 52];
    let mut draft = set([sun, ring], &[[satellite; 2]]).crank("sun");
    draft.links[2].fixed_to = Some("frame".to_owned());
    // The second set is turned by the first one's carrier; its ring is the frame's as well.
    let arm = 0.5 * f64::from(sun + satellite);
    draft = draft
        .point("A2", 80.0, 0.0)
        .point("S2", 80.0 + arm, 0.0)
        .point("P2", 80.0, arm)
        .point("Q2", 80.0, arm + 5.0)
        .fixed(&["A2"])
        .bar("sun2", &["A2", "S2"])
        .bar("carrier2", &["A2", "P2"])
        .bar("satellite2", &["P2", "Q2"])
        .bar("ring2", &["A2"]);
    draft.links[7].fixed_to = Some("frame".to_owned());
    // A shaft between them, as wheels of equal teeth have it.
    draft.gears.extend([
        gear(["carrier", "sun2"], "frame", [40, 40], Mesh::AsPrinted),
        gear(
            ["sun2", "satellite2"],
            "carrier2",
            [sun, satellite],
            Mesh::External,
        ),
        gear(
            ["satellite2", "ring2"],
            "carrier2",
            [satellite, ring],
            Mesh::Internal,
        ),
    ]);
    let motion = moved(&draft);
    assert_eq!(
        motion.mechanism().formula(),
        "I(frame,sun) → III₃(carrier,satellite0) → II₂(sun2) → III₃(carrier2,satellite2)"
    );
    let stage = f64::from(sun) / f64::from(sun + ring);
    for k in 0..100 {
        let input = f64::from(k);
        let [_, first, second] = angle(&motion, "carrier2", input);
        assert_near(first, stage * stage, 1e-15, "ratio");
        assert_near(second, 0.0, 1e-15, "second derivative");
    }
}

/// The arm of a mixing head, as it is drawn in every book: with two equal wheels at its ends and an idler between, the
/// last wheel does not turn while the arm goes round.
#[test]
fn fergusons_wheel_does_not_turn() {
    let head = |last: u32| -> LinkageSpec {
        let mut draft = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("I", 30.0, 0.0)
            .point("P", 60.0, 0.0)
            .point("Q", 60.0, 7.0)
            .fixed(&["A"])
            .bar("arm", &["A", "I", "P"])
            .bar("idler", &["I"])
            .bar("last", &["P", "Q"])
            .crank("arm");
        draft.gears = vec![
            gear(["frame", "idler"], "arm", [30, 30], Mesh::External),
            gear(["idler", "last"], "arm", [30, last], Mesh::External),
        ];
        draft
    };
    for (last, expected) in [(30, 0.0), (31, 1.0 - 30.0 / 31.0), (29, 1.0 - 30.0 / 29.0)] {
        let motion = moved(&head(last));
        let [_, first, second] = angle(&motion, "last", 1.0);
        assert_near(first, expected, 1e-15, "Ferguson");
        assert_eq!(second, 0.0);
    }
}
