use assur::dynamics::Poles;
use assur::gears::train::{Coupling, Drive, Input, Shaft, Train};

use super::*;

/// The distance of a phase from half a turn, modulo whole turns, in turns.
fn beyond_half(phase: f64) -> f64 {
    let turns = phase / TAU - 0.5;
    (turns - turns.round()).abs()
}

/// Bevel gears in mesh touch along a line, and on this line teeth meet gaps. Where magnets are nearest, north poles
/// meet south poles. Both hold at all angles that the train allows.
#[test]
fn cones_roll_on_one_another() {
    for (teeth, satellites) in [
        ([20.0, 14.0, 20.0], 2.0),
        ([16.0, 14.0, 24.0], 4.0),
        ([30.0, 8.0, 18.0], 3.0),
        ([8.0, 30.0, 64.0], 6.0),
    ] {
        let train = Train::bevel(teeth).unwrap();
        let layout = Layout::new(train, satellites, 4.0, None).unwrap();
        for (coupling, poles) in [
            (Coupling::Contact, Poles::Alike),
            (Coupling::Magnetic, Poles::Alternating),
        ] {
            let view = TrainView {
                coupling,
                poles,
                members: [None, None],
                velocities: false,
            };
            let bevel = Bevel::new(&layout, view);
            let [p1, p2, p4] = bevel.periods();
            for step in 0..20 {
                let given = |shaft, angle| Input {
                    shaft,
                    drive: Drive::Given(angle),
                };
                let inputs = [
                    given(Shaft::Sun, 0.31 * f64::from(step)),
                    given(Shaft::Carrier, 2.0 - 0.17 * f64::from(step)),
                ];
                let angles = train.differential().solve(&inputs).unwrap();
                let pose = TrainPose {
                    angles: [angles.sun, 0.0, angles.carrier, angles.ring],
                    speeds: [0.0; 4],
                    torques: None,
                    ground: 0.0,
                };
                let ([sun, ring], satellite) = bevel.mounted(&pose);
                for k in 0..layout.counts().satellites {
                    let at = angles.carrier + TAU * f64::from(k) / satellites;
                    let wheel = bevel.satellite(at);
                    let own = satellite(at);
                    let phases = [
                        p1 * (at - sun) - p2 * own,
                        p4 * (at - ring) - p2 * (PI - own),
                    ];
                    for phase in phases {
                        assert!(beyond_half(phase) < 1e-9, "{teeth:?}: {phase}");
                    }
                    if coupling == Coupling::Contact {
                        for (member, there) in [(Member::Sun, 0.0), (Member::Ring, PI)] {
                            let central = bevel.central_wheel(member);
                            for end in 0..2 {
                                let off = central.place(end, at) - wheel.place(end, there);
                                assert!(off.norm() < 1e-9 * bevel.size, "{member:?}: {off:?}");
                            }
                        }
                    }
                }
            }
        }
    }
}
