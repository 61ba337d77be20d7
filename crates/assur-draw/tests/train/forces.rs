//! Forces, velocities, plates, bevel wheels.

use super::*;

/// Returns starting points and tips of the arrows filled with a colour, in the coordinates of the carrier.
fn arrows(all: &[Drawn], role: Role) -> Vec<[[f64; 2]; 2]> {
    let arrows = all
        .iter()
        .filter(|drawn| drawn.body == 2 && drawn.is(1, role));
    let arrows = arrows.flat_map(Drawn::lines).filter(|line| line.len() == 7);
    let ends = arrows.map(|line| {
        let from = [0, 1].map(|k| 0.5 * (line[0][k] + line[6][k]));
        [from, line[3]]
    });
    ends.collect()
}

/// Forces on the satellites oppose the torques on sun and ring; in each gap they are proportional to the given torque.
#[test]
fn forces_on_satellites_are_against_the_torques() {
    let figure = TrainFigure::new(&magnets(), ALIKE);
    let pose = TrainPose {
        torques: Some([0.8, -0.4]),
        ..at_rest([0.3, 0.1, 0.2, 0.5])
    };
    let arrows = arrows(&drawn(&figure, &pose).1, Role::Ink);
    assert_eq!(arrows.len(), 6);
    for (pair, arrows) in arrows.chunks(2).enumerate() {
        let turns = [0, 1].map(|gap: usize| {
            let [[x, y], [to, up]] = arrows[gap];
            (x * (up - y) - y * (to - x)) / x.hypot(y)
        });
        assert!(turns[0] < 0.0 && turns[1] > 0.0, "{pair}: {turns:?}");
        assert!(
            (turns[0] + 2.0 * turns[1]).abs() < 1e-3,
            "{pair}: {turns:?}"
        );
    }
    let unloaded = TrainPose {
        torques: Some([0.0, 0.0]),
        ..pose
    };
    let none = drawn(&figure, &unloaded).1;
    assert_eq!(self::arrows(&none, Role::Ink).len(), 0);
}

/// With the ring held, the instant centre of the satellite is at its contact with the ring. In all poses the tips of
/// the velocities are on a line through the instant centre.
#[test]
fn velocities_end_on_a_line() {
    let view = TrainView {
        velocities: true,
        ..CONTACT
    };
    let layout = layout(Train::planar([20.0, 20.0, 60.0]).unwrap(), 3.0);
    let figure = TrainFigure::new(&layout, view);
    let moving = |sun: f64, carrier: f64| TrainPose {
        speeds: turned(&layout, sun, carrier),
        ..at_rest([0.0; 4])
    };
    // With ω₁ = 4 ω₃ the ring is at rest.
    for (pose, centre) in [(moving(4.0, 1.0), Some(120.0)), (moving(-1.0, 0.7), None)] {
        let all = drawn(&figure, &pose).1;
        let arrows = arrows(&all, Role::Velocity);
        let pole = all
            .iter()
            .find(|drawn| drawn.is(3, Role::Velocity))
            .unwrap();
        let [x, y] = [pole.record[3], pole.record[4]];
        assert_eq!(y, 0.0);
        if let Some(centre) = centre {
            assert!((x - centre).abs() < 1e-4);
            assert_eq!(arrows.len(), 2);
        } else {
            assert_eq!(arrows.len(), 3);
        }
        let slopes = arrows.iter().map(|[[from, _], [to, up]]| {
            assert!((from - to).abs() < 1e-4);
            up / (to - x)
        });
        let slopes: Vec<f64> = slopes.collect();
        for slope in &slopes {
            assert!((slope / slopes[0] - 1.0).abs() < 1e-4, "{slopes:?}");
        }
        // The slope of the line of tips has the sign of the satellite's speed.
        assert_eq!(slopes[0] > 0.0, pose.speeds[1] > 0.0);
    }
}

/// Plates too fine to be seen are drawn as a band, which keeps the list short.
#[test]
fn fine_plates_are_a_band() {
    let layout = layout(Train::planar([500.0, 200.0, 1000.0]).unwrap(), 6.0);
    for view in [ALIKE, CONTACT] {
        let figure = TrainFigure::new(&layout, view);
        assert!(figure.rigid().numbers().len() < 20_000);
    }
}

/// If the mesh slips, the angle of the satellite turns the satellite and no other body.
#[test]
fn bodies_turn_by_their_own_angles() {
    let figure = TrainFigure::new(&magnets(), ALIKE);
    let before = drawn(&figure, &at_rest([0.0; 4])).0;
    let after = drawn(&figure, &at_rest([0.0, 0.5, 0.0, 0.0])).0;
    for (body, (before, after)) in before.iter().zip(&after).enumerate() {
        let turned = (after[2] - before[2]).rem_euclid(TAU);
        let expected = if body < 4 { 0.0 } else { 0.5 };
        assert!((turned - expected).abs() < 1e-5, "{body}: {turned}");
    }
}

#[test]
fn every_member_is_another_picture() {
    let pictures = WorkingMember::ALL.map(|member| {
        let view = TrainView {
            members: [Some(member), None],
            ..ALIKE
        };
        TrainFigure::new(&magnets(), view)
            .rigid()
            .numbers()
            .to_vec()
    });
    for (index, picture) in pictures.iter().enumerate() {
        assert!(pictures[..index].iter().all(|other| other != picture));
    }
}

#[test]
fn bevel_wheels_have_no_rigid_list() {
    let layout = layout(Train::bevel([20.0, 14.0, 20.0]).unwrap(), 2.0);
    assert_eq!(layout.train().kind(), Kind::Bevel);
    let figure = TrainFigure::new(&layout, CONTACT);
    assert!(figure.rigid().numbers().is_empty());
    let pose = at_rest(turned(&layout, 1.0, 0.4));
    let other = at_rest(turned(&layout, 1.1, 0.4));
    assert_ne!(figure.frame(&pose), figure.frame(&other));
}
