use std::f64::consts::PI;

use assur::mechanism::{LinkageSpec, Mechanism};
use assur::motion::Motion;

use super::super::View;
use super::*;

/// An arm with a sun on the frame and a planet in a ring, and a train beside it.
fn draft() -> LinkageSpec {
    // Module of the mesh of the ring with the second wheel. The third wheel is placed such that its mesh has the same
    // module.
    let module = 2.0 * 10.0_f64.sqrt() / 94.0;
    let mut draft = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("Q", 0.1, 0.4)
        .point("P", 1.0, 0.2)
        .point("M", 1.2, 0.5)
        .point("E", 3.0, 1.0)
        .point("F", 3.0 + 19.5 * module, 1.0)
        .fixed(&["O", "Q", "E", "F"])
        .bar("arm", &["O", "P"])
        .bar("planet", &["P", "M"])
        .bar("ring", &["O"])
        .bar("second", &["E"])
        .bar("third", &["F"])
        .crank("arm");
    let mut sun = assur::mechanism::LinkSpec {
        name: "sun".to_owned(),
        points: vec!["O".to_owned(), "Q".to_owned()],
        ..Default::default()
    };
    sun.fixed_to = Some("frame".to_owned());
    draft.links.push(sun);
    for (links, carrier, teeth, mesh) in [
        // The couplings are not in the order in which the motion is transmitted.
        (["third", "second"], "frame", [15.0, 24.0], Mesh::External),
        (["sun", "planet"], "arm", [30.0, 20.0], Mesh::External),
        (["planet", "ring"], "arm", [20.0, 70.0], Mesh::Internal),
        (["ring", "second"], "frame", [70.0, 24.0], Mesh::External),
    ] {
        draft.gears.push(GearSpec {
            links: links.map(str::to_owned),
            carrier: carrier.to_owned(),
            teeth,
            mesh,
        });
    }
    draft
}

#[test]
fn teeth_meet_gaps_all_along_a_train() {
    let draft = draft();
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let home = motion.pose::<1>(motion.drawn_input()).unwrap();
    let view = View::default();
    let posed = Posed {
        mechanism,
        pose: &home,
    };
    let layout = Layout::new(posed, &view);
    let gearing = Gearing::new(&layout, posed, &view);
    // The ring counts twice: for the mesh with the second wheel it also has external teeth.
    assert_eq!(gearing.wheels.len(), 6);
    for input in [0.0, 0.3, 1.7, 4.0] {
        let pose = motion.pose::<1>(input).unwrap();
        for gear in &draft.gears {
            let internal = gear.mesh == Mesh::Internal;
            let drawn = [0, 1].map(|k| {
                let link = mechanism.link(&gear.links[k]).unwrap();
                let ring = internal && gear.teeth[k] > gear.teeth[1 - k];
                let mut wheels = gearing.wheels.iter();
                wheels
                    .find(|one| one.link == link && one.ring == ring)
                    .unwrap()
            });
            let [a, b] = drawn.map(|one| mechanism.place(&pose, one.hinge).place());
            let line = (b - a).y.atan2((b - a).x);
            let phase = |one: &Drawn, contact: f64| {
                let angle = mechanism.angle(&pose, one.link).value() + one.lead;
                (contact - angle) * f64::from(one.teeth) / (2.0 * PI)
            };
            let [first, second] = drawn;
            let sum = if internal {
                let contact = if second.ring { line + PI } else { line };
                phase(first, contact) - phase(second, contact)
            } else {
                phase(first, line) + phase(second, line + PI)
            };
            let off = (sum - 0.5) - (sum - 0.5).round();
            assert!(off.abs() < 1e-9, "{:?} at {input}: {off}", gear.links);
            let [r, s] = drawn.map(|one| 0.5 * f64::from(one.teeth) * one.module);
            let apart = if internal { (r - s).abs() } else { r + s };
            assert!((apart - (b - a).norm()).abs() < 1e-12);
        }
    }
}
