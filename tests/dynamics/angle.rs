//! Angles as whole turns and a remainder.

use std::f64::consts::{PI, TAU};

use assur::Angle;

#[test]
fn what_is_beyond_whole_turns_is_within_half_a_turn() {
    for (radians, turns, part) in [
        (0.0, 0, 0.0),
        (3.0, 0, 3.0),
        (-3.0, 0, -3.0),
        (7.0, 1, 7.0 - TAU),
        (-7.0, -1, TAU - 7.0),
        (1e3, 159, 0.973_536_158_445_750_2),
        (-1e6, -159_155, 0.357_564_167_085_735),
    ] {
        let angle = Angle::new(radians);
        assert_eq!(angle.turns(), turns, "{radians}");
        assert!(
            (angle.part() - part).abs() < 1e-15,
            "{radians}: {}",
            angle.part()
        );
        assert!((angle.radians() - radians).abs() <= 1e-15 * radians.abs());
    }
    for step in -4000..4000 {
        let angle = Angle::new(f64::from(step) * 0.1);
        assert!((-PI..=PI).contains(&angle.part()), "{step}");
    }
}
