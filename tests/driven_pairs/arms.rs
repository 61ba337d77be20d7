//! Drivers that turn or slide a link relative to an earlier link, and wheels on a carrier.

use std::f64::consts::{PI, TAU};

use assur::Vector;
use assur::gears::Mesh;
use assur::mechanism::{FRAME, GearSpec, LinkageSpec};
use assur::motion::DeadPointKind;

use super::{along, angle, assert_angle, motion, moved, place, reduced, turned};

/// Three links one on the other.
pub(crate) fn arm() -> LinkageSpec {
    LinkageSpec::default()
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
pub(crate) fn drawn_arm() -> [[f64; 3]; 2] {
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
    assert!(reduced(motion.drawn_input() + drawn[0]).abs() < 1e-14);
    for input in [-2.0, motion.drawn_input(), 0.4, 3.0] {
        let off = input - motion.drawn_input();
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
    let draft = LinkageSpec::default()
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
    let pushed = LinkageSpec::default()
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

/// A planet turned against its carrier around a sun that stands: z₁ θ_c = z₂ φ.
#[test]
fn a_planet_turned_against_its_carrier() {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 3.0, 0.0)
        .point("W", 3.0, 1.0)
        .fixed(&["A"])
        .bar("carrier", &["A", "B"])
        .bar("planet", &["B", "W"]);
    draft.gears.push(GearSpec {
        links: [FRAME.to_owned(), "planet".to_owned()],
        carrier: "carrier".to_owned(),
        teeth: [40.0, 20.0],
        mesh: Mesh::External,
    });
    let motion = motion(&turned(draft, "planet", "carrier", 1.0));
    let home = motion.drawn_input();
    assert!((home - 0.5 * PI).abs() < 1e-15);
    assert_eq!(motion.cycle().period(), Some(2.0 * TAU));
    for off in [-9.0, -2.0, 0.0, 1.0, 7.0] {
        let found = angle(&motion, "carrier", home + off);
        assert_angle(found, [0.5 * off, 0.5, 0.0], 1e-12, "carrier");
        let found = angle(&motion, "planet", home + off);
        assert_angle(found, [0.5 * PI + 1.5 * off, 1.5, 0.0], 1e-12, "planet");
    }
}
