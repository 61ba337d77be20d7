//! Dyads on a crank that turns about the origin, in poses with numbers that can be checked by hand.

use std::f64::consts::FRAC_PI_2;

use super::{Prp, Rpp, Rpr, Rrp, Rrr, Side};
use crate::index::{BodyId, Id, PointId, StepId};
use crate::position::{
    Arm, BodyPoint, Cause, Mounting, Nearby, Sign, State, Step, StepContext, Track,
};
use crate::{Jet, Vector};

/// A point of a body: 0 is the frame, 1 the crank, 2 and 3 are the links i and j.
pub(in crate::position) fn at(body: usize, x: f64, y: f64) -> BodyPoint {
    let local = Vector::new(x, y);
    BodyPoint {
        body: BodyId::at(body),
        local,
    }
}

fn arm(body: usize, outer: BodyPoint, length: f64) -> Arm {
    Arm::new(
        BodyId::at(body),
        outer,
        [Vector::zeros(), Vector::new(length, 0.0)],
        [PointId::at(0); 2],
    )
}

/// A side with its hinge at the origin of the body, and with the x-axis of the body as its line.
fn side(body: usize, outer: BodyPoint) -> Side {
    Side::new(
        BodyId::at(body),
        outer,
        (PointId::at(0), Vector::zeros()),
        (Vector::zeros(), Vector::x()),
    )
}

/// A track on which the origin of a body slides: a line in the x-direction of the other body.
pub(in crate::position) fn track(body: usize, line: BodyPoint) -> Track {
    Track {
        body: BodyId::at(body),
        line,
        heading: Vector::x(),
        direction: Vector::x(),
        point: Vector::zeros(),
        offset: 0.0,
        joint: None,
    }
}

/// A point of a dyad with its first two derivatives with respect to the crank angle, for the crank at 90°.
pub(in crate::position) fn place(step: &Step, sign: Sign, point: BodyPoint) -> [[f64; 2]; 3] {
    let place = solved(step, sign).unwrap().place(point);
    [0, 1, 2].map(|order| [place.x(), place.y()].map(|jet| jet.derivative(order)))
}

/// The bodies after a step, with the crank at 90°.
fn solved(step: &Step, sign: Sign) -> Result<State<3>, Cause> {
    let mut state: State<3> = State::new(4, 1, 0, 10.0);
    let input = Jet::linear(FRAC_PI_2, 1.0);
    state.pin(BodyId::at(1), input, at(0, 0.0, 0.0), Vector::zeros());
    let orientations = state.orientations();
    let near = Nearby {
        orientations: &orientations,
        natural: &[],
        smooth_roots: &[],
    };
    let context = StepContext {
        step: StepId::FIRST,
        input,
        sign,
        near,
        mounting: &Mounting::planned(4),
    };
    step.put(&mut state, &context)?;
    Ok(state)
}

#[test]
fn places_and_derivatives() {
    use Sign::{Minus, Plus};
    let four_bar = None;
    // The triangle 3, 4, 5 between B (0, 1), on a crank of length 1, and D (5, 1).
    let arms = [arm(2, at(1, 1.0, 0.0), 3.0), arm(3, at(0, 5.0, 1.0), 4.0)];
    let rrr = Step::from(Rrr { arms, four_bar });
    // Crank 3 and rod 5: x = 3 cos φ ± √(25 − 9 sin² φ).
    let rrp = Step::from(Rrp {
        arm: arm(2, at(1, 3.0, 0.0), 5.0),
        track: track(3, at(0, 0.0, 0.0)),
    });
    // From B (0, 3) to D (4, 0): ω = d × d′ / d² = 9/25.
    let sides = [side(2, at(1, 3.0, 0.0)), side(3, at(0, 4.0, 0.0))];
    let rpr = Step::from(Rpr { sides });
    // The scotch yoke: x = 5 cos φ.
    let rpp = Step::from(Rpp {
        side: side(2, at(1, 5.0, 0.0)),
        track: track(3, at(0, 0.0, 0.0)),
        direction: Vector::y(),
        through: Vector::zeros(),
    });
    // A line at a distance of 2 from the pivot of the crank meets the x axis at 2 / sin φ.
    let tracks = [track(2, at(0, 0.0, 0.0)), track(3, at(1, 0.0, -2.0))];
    let prp = Step::from(Prp { tracks });
    let [c, x, on_i] = [at(3, 4.0, 0.0), at(3, 0.0, 0.0), at(2, 5.0, 0.0)];
    // NaN stands for second derivatives that are not compared.
    let n = f64::NAN;
    let cases = [
        (&rrr, Plus, c, [1.8, 3.4, -0.36, -0.48, n, n]),
        (&rrr, Minus, c, [1.8, -1.4, -0.36, 0.48, n, n]),
        (&rrp, Plus, x, [4.0, 0.0, -3.0, 0.0, 2.25, 0.0]),
        (&rrp, Minus, x, [-4.0, 0.0, -3.0, 0.0, -2.25, 0.0]),
        (&rpr, Plus, on_i, [4.0, 0.0, -1.92, 1.44, n, n]),
        (&rpr, Minus, on_i, [-4.0, 6.0, -4.08, -1.44, n, n]),
        (&rpp, Plus, x, [0.0, 0.0, -5.0, 0.0, 0.0, 0.0]),
        (&prp, Plus, x, [2.0, 0.0, 0.0, 0.0, 2.0, 0.0]),
    ];
    for (step, sign, point, expected) in cases {
        let found = place(step, sign, point);
        let mut both = found.as_flattened().iter().zip(expected);
        let is_near = both.all(|(a, b)| b.is_nan() || (a - b).abs() < 1e-14);
        assert!(is_near, "{sign:?}: {found:?}, not {expected:?} by {step:?}");
    }
}

/// B at (0, 1) and D at (5, 1) are 5 apart. Arms of 1 and 3 together are 1 too short, arms of 1 and 7 differ by 1 too
/// much, and arms of 2 and 3 are in line. From (0, 3) a rod of 2 is 1 too short to reach the x-axis, and a rod of 3
/// just reaches it.
#[test]
fn dyads_out_of_reach_and_at_dead_points() {
    let rrr = |lengths: [f64; 2], d: [f64; 2]| {
        let [x, y] = d;
        let arms = [
            arm(2, at(1, 1.0, 0.0), lengths[0]),
            arm(3, at(0, x, y), lengths[1]),
        ];
        Step::from(Rrr {
            arms,
            four_bar: None,
        })
    };
    let rrp = |length: f64| {
        Step::from(Rrp {
            arm: arm(2, at(1, 3.0, 0.0), length),
            track: track(3, at(0, 0.0, 0.0)),
        })
    };
    // Two lines of the crank.
    let tracks = [track(2, at(1, 0.0, 0.0)), track(3, at(1, 0.0, -2.0))];
    for (step, expected) in [
        (rrr([1.0, 3.0], [5.0, 1.0]), Cause::Apart { by: 1.0 }),
        (rrr([1.0, 7.0], [5.0, 1.0]), Cause::Apart { by: 1.0 }),
        (rrr([2.0, 3.0], [5.0, 1.0]), Cause::DeadPoint),
        (rrr([3.0, 3.0], [0.0, 1.0]), Cause::Undetermined),
        (rrp(2.0), Cause::OutOfReach { by: 1.0 }),
        (rrp(3.0), Cause::DeadPoint),
        (Step::from(Prp { tracks }), Cause::Parallel),
    ] {
        let found = solved(&step, Sign::Plus).map(drop).unwrap_err();
        let is_same = match (found, expected) {
            (Cause::Apart { by }, Cause::Apart { by: expected })
            | (Cause::OutOfReach { by }, Cause::OutOfReach { by: expected }) => {
                (by - expected).abs() < 1e-14
            }
            _ => found == expected,
        };
        assert!(is_same, "{found:?}, not {expected:?}");
    }
}
